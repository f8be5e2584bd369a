//! Zonotopes as bounding volumes: exact, certified algorithms of computational geometry.
//!
//! A zonotope is a Minkowski sum of segments, given by its centre and generators: { p + Σ δ_i v_i : |δ_i| ≤ 1 }. This
//! library implements *Zonotopes as Bounding Volumes* (Guibas, Nguyen, Zhang, SODA 2003): every decision is exact,
//! every answer carries a certificate, and a volume that is called enclosing encloses. It is pure: no input or output,
//! no clock, no ambient randomness.
//!
//! # What a body can be asked
//!
//! Is a point inside? Sets are closed: a point of the boundary belongs to the body.
//! ```
//! use zonotope::Zonotope;
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let square = Zonotope::new([0.0, 0.0], vec![[1.0, 0.0], [0.0, 1.0]])?; // the square [−1, 1]²
//! assert!(square.contains([1.0, 0.5])? && !square.contains([1.0f64.next_up(), 0.5])?);
//! # Ok(()) }
//! ```
//!
//! Do two bodies meet? In space each may stand under a [`Pose`], and no generator is copied to move it.
//! ```
//! # use zonotope::{Pose, Zonotope};
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let cube = Zonotope::new([0.0; 3], vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])?;
//! assert!(cube.at(&Pose::from_translation([2.0, 0.0, 0.0])?).intersects(&cube)); // they touch
//! # Ok(()) }
//! ```
//!
//! How far is a point? The gauge is the factor by which the body must grow from its centre to hold the point.
//! ```
//! # use zonotope::Zonotope;
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! # let square = Zonotope::new([0.0, 0.0], vec![[1.0, 0.0], [0.0, 1.0]])?;
//! let gauge = square.gauge([3.0, 0.5])?;
//! assert!((gauge.value - 3.0).abs() <= gauge.error);
//! # Ok(()) }
//! ```
//!
//! What encloses these points? Here the zonogon of least area, along given directions, and of least total length; every
//! answer is an [`Enclosing`] with a lower bound that no such body can beat.
//! ```
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! use zonotope::enclosing::{along_directions, min_area, min_length};
//! let triangle = [[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]];
//! let least = min_area(&triangle)?;
//! assert_eq!((least.value, least.lower_bound), (4.0, 4.0)); // nothing smaller holds the triangle
//! let along_the_legs = along_directions(&triangle, &[[1.0, 0.0], [0.0, 1.0]])?;
//! assert_eq!(along_the_legs.optimal().map(|square| square.value), Some(2.0)); // half-lengths 1 and 1
//! assert!(min_length(&triangle, 1e-6)?.ratio() <= 1.0 + 1e-6);
//! # Ok(()) }
//! ```
//!
//! How is an answer checked? It carries its proof: of a point outside, a direction u in which the point is beyond the
//! body.
//! ```
//! # use zonotope::{Separation, Zonotope};
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! # let square = Zonotope::new([0.0, 0.0], vec![[1.0, 0.0], [0.0, 1.0]])?;
//! let located = square.locate([3.0, 0.5])?;
//! let Some(Separation::Rounded(u)) = located.separation() else { panic!("the point is outside") };
//! assert!(u[0] * 3.0 + u[1] * 0.5 > square.support(*u).value());
//! # Ok(()) }
//! ```
//!
//! The methods of [`Zonotope`] take the kernel in up to four dimensions; above, they enumerate facets in rationals,
//! O(n^D).
//!
//! # Problems
//!
//! | module | problem | in the paper |
//! |---|---|---|
//! | [`enclosing::min_area_zonogon`] | the zonogon of least area around points of the plane | 4.1, Theorem 4.5 |
//! | [`enclosing::fixed_directions`] | the smallest zonotope along given directions around points of R^d | 4.2, Theorem 4.6 |
//! | [`enclosing::min_total_length`] | the zonotope of least total length around points of R^d | 4.3, Theorem 4.7 |
//! | [`enclosing::centered_zonogon`] | the smallest zonogon with a given centre | 4.1, Z(O) |
//! | [`collision`] | membership, intersection and gauge, with proofs | 5.1, Theorem 5.2 |
//! | [`collision::hierarchy`] | whether bodies meet, by levels from coarse to fine | 5.2, hierarchical method |
//! | [`collision::prepared`] | repeated queries about one body, by the structure that suits | 5.2, Lemma 5.3 |
//! | [`collision::distance`] | Euclidean distance with nearest points and faces, and penetration depth | from 5.1, Lemma 5.1 |
//! | [`motion::continuous`] | whether two moving bodies meet during a step of time, and when first | 6 |
//! | [`lad`] | the kernel: weighted least absolute deviations in the plane | under 4.1 and 5.1 |
//! | [`lad::of_forms`] | the kernel in three variables | under 5.1 in R^4 |
//! | [`line_fit`] | the kernel as a statistician knows it: the line of least absolute deviations | |
//! | [`arrangement::slope_selection`] | the k-th leftmost vertex of a line arrangement | 4.1 and 5.1, \[5\] |
//! | [`arrangement::dynamic_hull`] | one chain of a convex hull, under insertions and deletions | 5.2, Lemma 5.6 |
//! | [`arrangement::facet_walk`] | the neighbours of a facet, by walking from facet to facet | 5.2, Lemma 5.6 |
//! | `linear_program` | linear programs by engines in floating point (feature `linear-programming`) | under 4.2 and 4.3 |
//! | [`arrangement::tiling`] | the tiling of Q by the facets of the upper hull, dual to the arrangement | 3, Figure 1 |
//! | [`arrangement::separator`] | the k-th separator of that tiling | 5.1 |
//! | [`arrangement::cutting`] | trapezoids that few lines of an arrangement cross, and location among them | 5.2 |
//! | [`collision::upper_hull`] | the height of the upper hull over a point | 5.1 |
//! | [`reduction`] | a zonotope of few generators around one of many | 5.2, Lemma 5.5 |
//! | [`reduction::hausdorff`] | the Hausdorff distance of two zonotopes, between two bounds | 5.2, H(A, B) |
//! | [`motion::space_time`] | a zonotope around all placements of a turning one | 6, Theorem 6.1 |
//! | [`bvh`] | where two meshes of triangles meet, and how far apart they are, by hierarchies of bounding volumes | 1 |
//! | [`hull`] | convex hull and farthest vertices of its edges | 4.1 |
//! | [`hull::in_space`] | convex hull of points of space | 4.3, as what a body has to contain |
//! | [`zonotope`] | support function, sums and linear maps; vertices, area and membership of zonogons | 3 |
//! | [`zonotope::faces`] | the face lattice in space; vertices and facets in any dimension | 3 |
//! | [`zonotope::combinatorics()`] | counts of faces, exact volume | 3 |
//! | [`interop`] | zonotopes among the types of other libraries | |
//!
//! # Notation
//!
//! | paper | here |
//! |---|---|
//! | Z = (p, ⟨v_1 … v_n⟩) | [`zonotope::Zonotope`] with `center` and `generators` |
//! | 𝓗, P_t, P_t P_{t+1} | [`hull::ConvexHull`], a vertex, the edge with the index of its first vertex |
//! | P_s, farthest from P_t P_{t+1} | [`hull::antipodal::FarthestVertex`] |
//! | ℓ_t | a line of [`enclosing::bisectors::Bisectors`] |
//! | 𝓩(O), 𝓢 | [`enclosing::centered_zonogon::CenteredZonogon`] and its `description` |
//! | P'_i | [`enclosing::centered_zonogon::BoundaryVertex`] with `reflected` |
//! | f(O) | `area` of Z(O); up to a constant the objective of a [`lad::LadProblem`] |
//! | 𝓐 | the arrangement of the lines of that problem |
//! | Π, ℓ_i | [`arrangement::DualArrangement`] and its line with the index i |
//! | 𝒯, T_ij | [`arrangement::tiling::FacetTiling`] and a tile of it |
//! | L'_k | [`arrangement::separator::Separator`] |
//!
//! # Layers
//!
//! [`numeric`], [`seed`] and [`tally`] at the bottom, then [`hull`], [`arrangement`] and [`zonotope`], then [`lad`],
//! then [`enclosing`] and [`collision`], then [`line_fit`], [`motion`] and [`bvh`]; [`reduction`] stands on
//! [`zonotope`].

// The tables of methods name those that the feature brings.
#![cfg_attr(not(feature = "linear-programming"), allow(rustdoc::broken_intra_doc_links))]

#[cfg(test)]
#[macro_use]
mod property_cases;

pub mod arrangement;
pub mod bvh;
pub mod collision;
pub mod enclosing;
pub mod hull;
#[cfg(not(test))]
#[doc(hidden)]
pub mod instances;
pub mod interop;
pub mod lad;
pub mod line_fit;
#[cfg(feature = "linear-programming")]
pub mod linear_program;
pub mod motion;
pub mod numeric;
pub mod reduction;
pub mod seed;
mod tables;
pub mod tally;
pub mod zonotope;

pub use collision::{Gauge, Located, Location, PreparedFor, Separation, SignRule, Status, Witness};
pub use enclosing::Enclosing;
pub use motion::Motion;
pub use numeric::non_finite::{NonFinite, Place};
pub use seed::DEFAULT_SEED;
pub use zonotope::pose::{Pose, PoseError};
pub use zonotope::{AtRest, BoundingBox, Placed, Standing, Support, Zonotope, ZonotopeError, support_of};
