//! Hierarchies of bounding volumes over meshes.

use experiments::definition::Quantity;
use experiments::definitions::mesh_node_tests::{BOXES, COUNTS};
use experiments::findings::{meshes::fewest_tests, words};
use experiments::measured::{Measured, range};

use crate::report::chapter::{Chapter, ChapterTable, Cost, Held};

pub(super) static CHAPTER: Chapter = Chapter {
    id: "bounding-volumes",
    title: "Zonotopes as bounding volumes of meshes",
    place: "Section 1; section 7, second, third and fifth question",
    statement: "Two meshes of triangles stand in space. A tree over the triangles of each has a simple body around \
        those below each node; where two bodies are disjoint, their triangles are. Which body is worth its test?",
    lesson,
    pictures: &["mesh-in-hierarchy"],
    table: ChapterTable::ValuesOn(COUNTS.id, "bumps"),
    method: &[
        "The tree is the same for all volumes. A zonotope of few generators is fitted to each node so that few of its \
         like overlap it in a random placement: the measure of these placements is a sum of products of mean width, \
         surface and volume. Directions come from a box and from edges, half-lengths from linear programs, and then \
         all generators move together as long as the measure falls. Containment is decided exactly.",
        "A test of two zonotopes goes along the facet normals of both, several at a time. It may take two disjoint \
         zonotopes for overlapping ones, never the other way round; pairs of triangles are decided exactly, so answers \
         are the same whatever the volume is.",
        "Where zonotopes pay, the record says mesh by mesh: the sentences above and below are made from it. No body \
         with a centre is tight around a triangle, so they have little to gain at leaves. A test of many generators \
         takes longer than one of a box, so fewer tests need not be less time: the times are in the other page.",
    ],
    costs: &[Cost {
        text: "The paper: O(n^(d−1)) faces of n generators. A test of two nodes may try the normals of all facets.",
        held: Held::Claim("face-count"),
    }],
    claims: &["question-hierarchies", "question-optimal-volume", "question-generator-count"],
    experiments: &["mesh-node-tests", "mesh-times", "least-volume"],
    commands: &[(
        "cargo run --release -- mesh experiments/data/teapot.obj experiments/data/teapot.obj --move-b 8,0,0",
        "says whether two meshes meet, where, or how far apart they are",
    )],
};

/// The tests of nodes with zonotopes over those with searched boxes, and the volumes of the fewest, mesh by mesh.
fn lesson(found: &Measured<'_>) -> Option<String> {
    let ratios = |volume, at| found.ratios(COUNTS.id, [volume, BOXES], Quantity::Value(at));
    let span = |ratios: &[(&str, f64)]| range(ratios.iter().map(|(_, ratio)| *ratio)).map(words::between);
    let (near, overlapping, four) =
        (ratios("zonotope_6", "at_1"), ratios("zonotope_6", "all_pairs"), ratios("zonotope_4", "at_1"));
    let fewer = near.iter().filter(|(_, ratio)| *ratio < 1.0).count();
    Some(format!(
        "One per cent of its diagonal apart, two copies of a mesh are proved disjoint by {} times the tests of nodes \
         of searched boxes with zonotopes of six generators, and by {} times with four; six take fewer than boxes \
         on {fewer} of {} meshes. To find all pairs of triangles of copies that overlap takes {} times the tests. {} \
         {}",
        span(&near)?,
        span(&four)?,
        near.len(),
        span(&overlapping)?,
        fewest_tests(found, "at_1")?,
        fewest_tests(found, "all_pairs")?
    ))
}
