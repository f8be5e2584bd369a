//! Bodies that are asked about again and again.

use experiments::definition::Quantity;

use crate::report::chapter::{Chapter, ChapterTable};
use crate::report::html::grouped;
use crate::report::measured::{Measured, Series};

pub(super) static CHAPTER: Chapter = Chapter {
    id: "repeated-tests",
    title: "Bodies that are asked again and again",
    place: "Section 5.2, Lemmas 5.3 and 5.6, Corollary 5.4",
    statement: "Two bodies move, and at every moment it is asked whether they meet, or how far apart they are. What is \
        worth building once, so that a question need not read all generators?",
    lesson,
    pictures: &["tracked-features", "coherence"],
    table: ChapterTable::Growth,
    method: &[
        "Space for time: a cutting of the dual lines has trapezoids that few lines cross. A query finds its trapezoid \
         among them and looks at the generators of those lines alone (Lemma 5.3); located along a ray, it has the \
         distance in the metric of the body (Corollary 5.4). With linear space, a tree over the directions of the \
         generators adds up neighbours whose signs agree.",
        "Coarser bodies: nested levels of fewer and fewer generators tell bodies that are far apart, or deep in each \
         other, from a handful of generators; the nearer they are to touching, the finer the levels that tell.",
        "Walking: the facets next to a facet are the next crossings along its dual lines. Convex hulls of the lines \
         above and below, which change by a line a step, find them (Lemma 5.6). The closest features of moving bodies \
         are followed so, or the optimum of the last frame is where the kernel begins in the next.",
    ],
    bound: "The paper: O((n²/m) log² n) a query with O(m) space; O(log² n) a step. Here: O(n²/m + log² n); O(log² n).",
    claims: &[
        "summary-repeated-tests",
        "translation-by-point-location",
        "lemma-5.3",
        "erratum-5.2-lemma-5.3",
        "corollary-5.4",
        "erratum-5.2-corollary-5.4",
        "local-walk",
        "lemma-5.6",
        "erratum-5.2-lemma-5.6",
    ],
    experiments: &[
        "query-trade-off",
        "query-growth",
        "direction-tree-queries",
        "hierarchy-levels",
        "walk-steps",
        "coherence",
    ],
    commands: &[(
        "cargo run --release -- solve tests/goldens/questions.jsonl",
        "answers questions of every kind, those of member_batch, distance and walk among them",
    )],
};

/// What a structure and what the last frame save.
fn lesson(found: &Measured<'_>) -> Option<String> {
    let of = |experiment, method| Series { experiment, input: "random_bodies", method };
    let reads = Quantity::Value("reads");
    let (n, by_tree) = found.at_largest(of("direction-tree-queries", "by_direction_tree"), reads)?;
    let (_, without) = found.at_largest(of("direction-tree-queries", "by_lad"), reads)?;
    let (frames, warm) = found.at_largest(of("coherence", "warm"), reads)?;
    let (_, fresh) = found.at_largest(of("coherence", "fresh"), reads)?;
    let [by_tree, without, warm, fresh] = [by_tree, without, warm, fresh].map(|reads| grouped(reads as u64));
    Some(format!(
        "For an exact gauge of {} generators a tree over their directions reads {by_tree} nodes and generators, the \
         kernel without one {without}; in a motion of {} frames a turn, the kernel that begins with the last frame \
         reads {warm} generators a frame, a fresh query {fresh}.",
        grouped(n),
        grouped(frames)
    ))
}
