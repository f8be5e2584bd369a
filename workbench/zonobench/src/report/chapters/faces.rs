//! Zonotopes of space and their faces.

use experiments::definition::Quantity;

use crate::report::chapter::{Chapter, ChapterTable, Cost, Held};
use crate::report::html::grouped;
use experiments::findings::words;
use experiments::fit::GrowthModel;
use experiments::measured::{Extreme, Measured, Series};

pub(super) static CHAPTER: Chapter = Chapter {
    id: "faces",
    title: "Zonotopes and their faces",
    place: "Sections 1 and 3",
    statement: "A zonotope is the set of all sums c + Σ δᵢ vᵢ with every δᵢ between −1 and 1: a centre and a list of \
        generators stand for a polytope. Which vertices, edges and facets does it have?",
    lesson,
    pictures: &["named-zonohedra"],
    table: ChapterTable::Values("faces-scaling"),
    method: &[
        "Each generator vᵢ gives a great circle on the sphere of directions, the directions orthogonal to it. A \
         direction off all circles has one farthest vertex, the one whose signs are those of u·vᵢ; where two circles \
         cross lies the normal of a facet. So the faces of the zonotope are the cells of an arrangement of great \
         circles.",
        "Along one circle the crossings are sorted by angle. That order is the band of facets around the body that \
         share the generator, its zone. Zones of all generators together are the face lattice.",
        "Generators that are coplanar share one facet, with a side for each of them and its opposite. Parallel ones \
         are merged, flat bodies have their faces within their own plane or line. Every comparison is exact.",
    ],
    costs: &[
        Cost { text: "The paper: O(n^(d−1)) faces.", held: Held::Claim("face-count") },
        Cost { text: "The paper: found in O(n^(d−1)) time.", held: Held::Claim("construction-time") },
        Cost {
            text: "Here: O(n²) facets in space; the sweep that lists them also sorts along each circle.",
            held: Held::Fit { experiment: "faces-scaling", method: "by_sweep", law: GrowthModel::Quadratic },
        },
    ],
    claims: &[
        "affine-image-of-cube",
        "facets-are-parallelepipeds",
        "central-symmetry",
        "spatial-symmetric-not-zonotope",
        "familiar-zonotopes",
        "zones-are-bands",
        "sphere-arrangement-duality",
        "tangent-plane",
        "central-projection",
        "complexity-bound",
        "construction-time",
        "boxes-are-zonotopes",
        "implicit-representation",
        "center-and-generators",
        "face-count",
        "centered-body",
        "independent-generators",
    ],
    experiments: &["faces-scaling"],
    commands: &[(
        "echo '{\"generators\":[[1,0,0],[0,1,0],[0,0,1],[1,1,1]]}' | \
         cargo run --release -- inspect - --format json --svg body.svg",
        "counts, measures and draws a body: the rhombic dodecahedron",
    )],
};

/// The number of facets that few generators stand for, on each kind of bodies.
fn lesson(found: &Measured<'_>) -> Option<String> {
    let mut facets = found.over_inputs("faces-scaling", "by_sweep", Quantity::Value("facets"));
    facets.sort_by(|a, b| b.number.total_cmp(&a.number));
    let full = |extreme: &Extreme| extreme.number == (extreme.n * (extreme.n - 1)) as f64;
    let (most, rest) = (facets.first()?, facets.iter().filter(|extreme| !full(extreme)));
    let fewer: Vec<String> = rest.filter_map(|extreme| counted(found, &extreme.input)).collect();
    let relation = if full(most) { "n(n − 1), the most there can be" } else { "fewer than n(n − 1)" };
    Some(format!(
        "A short list stands for a large body: {} generators make {} facets, {relation}, on {} of {} kinds of bodies; \
         the others have {}.",
        most.n,
        grouped(most.number as u64),
        facets.iter().filter(|extreme| full(extreme)).count(),
        facets.len(),
        fewer.join(", ")
    ))
}

/// The facets of the largest bodies of a kind, which may differ in number.
fn counted(found: &Measured<'_>, input: &str) -> Option<String> {
    let series = Series { experiment: "faces-scaling", input, method: "by_sweep" };
    let (_, [least, most]) = found.range_at_largest(series, Quantity::Value("facets"))?;
    let [least, most] = [least, most].map(|count| grouped(count as u64));
    let counts = if least == most { most } else { format!("{least} to {most}") };
    Some(format!("{counts} of {}", words::input(input)))
}
