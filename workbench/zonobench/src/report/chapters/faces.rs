//! Zonotopes of space and their faces.

use experiments::definition::Quantity;

use crate::report::chapter::{Chapter, ChapterTable};
use crate::report::html::grouped;
use crate::report::measured::{Measured, Series};

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
    bound: "The paper: of order n² faces in space, n(n − 1) facets when no three generators are coplanar. Here: O(n² \
        log n), and proportional to the output but for the sorting.",
    claims: &[
        "affine-image-of-cube",
        "facets-are-parallelepipeds",
        "central-symmetry",
        "spatial-symmetric-not-zonotope",
        "familiar-zonotopes",
        "zones-are-bands",
        "sphere-arrangement-duality",
        "complexity-bound",
        "boxes-are-zonotopes",
        "implicit-representation",
        "center-and-generators",
        "face-count",
        "erratum-3-independent-generators",
    ],
    experiments: &["faces-scaling"],
    commands: &[(
        "echo '{\"generators\":[[1,0,0],[0,1,0],[0,0,1],[1,1,1]]}' | \
         cargo run --release -- inspect - --format json --svg body.svg",
        "counts, measures and draws a body: the rhombic dodecahedron",
    )],
};

/// How many facets few generators stand for.
fn lesson(found: &Measured<'_>) -> Option<String> {
    let on = |input| Series { experiment: "faces-scaling", input, method: "by_sweep" };
    let (n, facets) = found.at_largest(on("random_bodies"), Quantity::Value("facets"))?;
    let (_, on_lattice) = found.at_largest(on("lattice_bodies"), Quantity::Value("facets"))?;
    let relation = if facets == (n * (n - 1)) as f64 { "exactly the paper's n(n − 1)" } else { "not n(n − 1)" };
    Some(format!(
        "A short list stands for a large body: {n} generators in random directions make {} facets, {relation}; {n} \
         with coordinates on a lattice, often coplanar, make {}.",
        grouped(facets as u64),
        grouped(on_lattice as u64)
    ))
}
