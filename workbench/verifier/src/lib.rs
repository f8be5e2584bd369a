//! Answers about zonotopes, checked against their certificates: exactly, on plain numbers, without the solvers.
//!
//! A zonotope is { c + Σ δ_i g_i : |δ_i| ≤ 1 } with centre c and generators g_i. A solver that answers a question about
//! it also says why the answer is true: that is the certificate. A check takes the numbers of the question and of the
//! answer as they are written and returns a [`Verdict`]: `Right` with what was proved, `Wrong` with the place and the
//! reason, or `Unchecked` where a proof would take too long. This crate shares nothing with the solvers but the long
//! integers, reads and writes nothing, and no input makes it panic.
//!
//! # What proves what
//!
//! Let p be the vector from the centre of the zonotope (or of the first body) to the point (or to the second centre),
//! taken exactly; of two bodies the generators count together.
//!
//! | check | the claim | the certificate, checked by hand |
//! | --- | --- | --- |
//! | [`check_location`] | p lies outside | a direction u with u · p > Σ abs(u · g_i) |
//! | | p lies inside or on the boundary | coefficients δ_i in [−1, 1] with Σ δ_i g_i = p: those of at most d basis generators solve this equation exactly, the doubles given for them lie beside the solution; inside if no direction supports there |
//! | [`check_distance`] | p is that far from the zonotope | coefficients δ_i in [−1, 1] of the nearest point x, those of a basis solved for: no g_i leads from x towards p |
//! | [`check_proximity`] | distance, nearest points and faces of two bodies, how deep they overlap | that of a location and of a distance; the normal of a hyperplane between bodies that touch; none for the depth: every facet of a small sum |
//! | [`check_first_contact`] | when two moving bodies meet first, or that they do not | directions that may turn with a body, each for an interval of time: the Bernstein coefficients of the gap are positive; coefficients of a common point at the end |
//! | [`check_mesh_contact`] | when two moving meshes meet first, or that they do not | the same for parts of the meshes, which hold all pairs of triangles until then; two triangles that meet |
//! | [`check_meshes`] | two meshes of triangles meet, in which pairs, or how far apart they are | none: every pair of triangles whose boxes are near |
//! | [`check_gauge`] | the least t ≥ 0 with p in t Z | as for a location, which tells the side of 1; the d − 1 generators that span the facet through which p leaves tell the value |
//! | [`check_member_batch`] | status and gauge of many points | none: every point is held against every facet |
//! | [`check_support`] | h(u) = u · c + Σ abs(u · g_i) and a point that far | none: the sum, and the face of all farthest points, a zonotope itself |
//! | [`check_min_area`] | no enclosing zonogon has less area | hull edges e_t and coefficients δ_t in [−1, 1] with Σ δ_t e_t = 0 |
//! | [`check_min_length_dirs`] | no cheaper one along given directions | forces λ_j at points, Σ λ_j = 0, that load no direction beyond its weight: Σ_j abs(λ_j · v_i) ≤ w_i |
//! | [`check_min_length_all`] | none is shorter by more than a factor | forces λ_j at points, Σ λ_j = 0, and the farthest vertex of Σ [−1, 1] λ_j |
//! | [`check_reduction`] | a zonotope of few generators contains another one, how far apart they are | shares, which write each generator in terms of the enclosing ones; else none: every facet normal; none for the upper bound: the nearest point to every vertex |
//! | [`check_hausdorff`] | how far apart two bodies are, whether one contains the other | a direction in which their support functions differ by so much; none for the upper bound: the nearest point to every vertex |
//! | [`check_sweep`] | a zonotope contains all placements of a turning one | none: every facet normal, at every angle by stretches that are halved |
//! | [`check_combinatorics`] | numbers of faces, the volume | none: counted in another way, Σ abs(det) |
//! | [`check_measure`] | the volume, rounded | none: Σ abs(det) |
//! | [`check_slope_selection`] | the k-th leftmost vertex of lines | none: the vertices on both sides are counted |
//! | [`check_separator`] | a chain with k tiles on its left | none: the order of the lines along the chain |
//! | [`check_tiling`] | the tiling of the upper hull | none: the arrangement of lines, piece by piece |
//! | [`check_upper_hull`] | the height of the upper hull | none: the bounds of all vertices |
//! | [`check_walk`] | the four neighbours of a facet | none: the signs of all generators in both facets |
//! | [`check_convex_hull`] | the vertices of the convex hull, in order | none: every corner, and every point against the edges |
//! | [`check_lad`] | a point where linear · x + Σ abs(v_i(x)) is least | coefficients δ_i in [−1, 1] with δ_i v_i = abs(v_i) at the point and linear + Σ δ_i normal_i = 0 |
//! | | there is no minimum | a direction u with linear · u + Σ abs(normal_i · u) < 0 |
//!
//! # How it stays exact
//!
//! Every double is a whole multiple of a power of two. So all the numbers of one question and its answer are laid on
//! one grid: integers, in which sums and products are exact. A quotient is a numerator over a positive denominator, a
//! type of a page built on the same integers: a rational library would reduce after every step, which no check needs,
//! and would be one thing more to trust. Where floating point is used, to go through many facets, it only passes over
//! what is certainly clear. Figures (areas, lengths, gauges) may differ from their exact values by [`RELATIVE_ERROR`];
//! where a figure is too small for that, it is one of the two doubles around the exact value. Decisions have no
//! tolerance.
//!
//! # Example
//!
//! ```
//! use verifier::{Displaced, LocationAnswer, LocationCertificate, Status, Verdict, check_location};
//!
//! // The point (1, 1/4) is on the boundary of the square [−1, 1]².
//! let question = Displaced::new(&[0.0, 0.0], &[1.0, 0.25], &[[1.0, 0.0], [0.0, 1.0]])?;
//! let certificate = LocationCertificate::Witness { coefficients: vec![1.0, 0.25], basis: vec![1] };
//! let answer = |status| LocationAnswer { status, certificate: certificate.clone() };
//! assert!(check_location(&question, &answer(Status::Boundary)).is_right());
//! assert!(matches!(check_location(&question, &answer(Status::Inside)), Verdict::Wrong(_)));
//! # Ok::<(), String>(())
//! ```

mod arrangement;
mod bodies;
mod collision;
mod enclosing;
mod exact;
mod faces;
mod hull;
mod lad;
mod meshes;
mod motion;
mod reduction;
mod verdict;

pub use arrangement::separator::{SeparatorProof, check_separator};
pub use arrangement::slope_selection::{SlopeSelectionProof, check_slope_selection};
pub use arrangement::tiling::{Tile, TilingAnswer, TilingEdge, TilingProof, check_tiling};
pub use arrangement::upper_hull::check_upper_hull;
pub use arrangement::walk::{FacetTriple, WalkProof, check_walk};
pub use bodies::combinatorics::{CombinatoricsAnswer, check_combinatorics, check_measure};
pub use bodies::support::{SupportAnswer, SupportProof, check_support};
pub use collision::displaced::Displaced;
pub use collision::distance::{DistanceAnswer, DistanceProof, check_distance};
pub use collision::gauge::{GaugeAnswer, GaugeProof, check_gauge};
pub use collision::location::{LocationAnswer, LocationCertificate, LocationProof, Status, check_location};
pub use collision::member_batch::{MemberBatchProof, check_member_batch};
pub use collision::penetration::PenetrationAnswer;
pub use collision::placed::{Body, Pose};
pub use collision::proximity::{ProximityAnswer, ProximityParts, ProximityProof, check_proximity};
pub use enclosing::min_area::{
    Certificate, ExactMinArea, MinAreaAnswer, MinAreaProof, check_exact_min_area, check_min_area,
};
pub use enclosing::min_length_all::{
    MinLengthAnswer, MinLengthProof, check_min_length_all, check_min_length_all_at_any_ratio,
    check_min_length_all_bounds,
};
pub use enclosing::min_length_dirs::{
    Directed, DirectedAnswer, DirectedProof, check_min_length_dirs, check_min_length_dirs_at_any_gap,
    check_min_length_dirs_bounds, check_min_length_dirs_feasible,
};
pub use exact::fraction::Fraction;
pub use exact::whole_direction;
pub use hull::{ConvexHullProof, check_convex_hull};
pub use lad::{Lad, LadAnswer, LadProof, check_lad};
pub use meshes::check::{MeshAnswer, Surface, check_meshes};
pub use meshes::level::{ClaimedNode, check_mesh_level};
pub use motion::answer::{Encounter, FirstContactAnswer, FirstContactProof, FreeInterval, MovingDirection};
pub use motion::check::{MovingBody, check_first_contact};
pub use motion::of_meshes::{FreeParts, MeshContactAnswer, MeshEncounter, MovingSurface, check_mesh_contact};
pub use motion::path::{Motion, MotionPiece};
pub use motion::sweep::{Sweep, check_sweep};
pub use reduction::hausdorff::{HausdorffAnswer, check_hausdorff};
pub use reduction::reduced::{Reduction, ReductionAnswer, check_reduction};
pub use reduction::shares::Shares;
pub use verdict::{Proved, Verdict};

/// The largest relative difference that is accepted between a figure of an answer and its exact value.
pub const RELATIVE_ERROR: f64 = 1e-12;
