//! Bodies that are asked about again and again.

use experiments::definition::Quantity;

use crate::report::chapter::{Chapter, ChapterTable, Cost, Held};
use experiments::findings::words;
use experiments::measured::{Extreme, Measured};

pub(super) static CHAPTER: Chapter = Chapter {
    id: "repeated-tests",
    title: "Bodies that are asked again and again",
    place: "Section 5.2, Lemmas 5.3 and 5.6, Corollary 5.4",
    statement: "Two bodies move, and at every moment it is asked whether they meet, or how far apart they are. What is \
        worth building once, so that a question need not read all generators?",
    lesson,
    pictures: &["coherence"],
    table: ChapterTable::Growth,
    method: &[
        "Space for time: a cutting of the dual lines has trapezoids that few lines cross. A query finds its trapezoid \
         among them and looks at the generators of those lines alone (Lemma 5.3); located along a ray, it has the \
         distance in the metric of the body (Corollary 5.4). With linear space, a tree over the directions of the \
         generators adds up neighbours whose signs agree.",
        "Coarser bodies: nested levels of fewer and fewer generators, inside and outside, are compared from the \
         coarsest on, until two of them prove where the bodies are.",
        "Walking: the facets next to a facet are the next crossings along its dual lines. Convex hulls of the lines \
         above and below, which change by a line a step, find them (Lemma 5.6). The closest features of moving bodies \
         are followed so, or the optimum of the last frame is where the kernel begins in the next.",
    ],
    costs: &[
        Cost { text: "The paper: O((n²/m) log² n) a query with O(m) space.", held: Held::Claim("lemma-5.3") },
        Cost { text: "The paper: O(log² n) a step from face to face.", held: Held::Claim("lemma-5.6") },
    ],
    claims: &[
        "summary-repeated-tests",
        "translation-by-point-location",
        "rotations-in-the-sum",
        "arrangement-trade-off",
        "lemma-5.3",
        "cutting-size",
        "pseudo-lines",
        "tiles-of-cutting-lines",
        "corollary-5.4",
        "location-of-rays",
        "local-walk",
        "small-motions",
        "lemma-5.6",
        "neighbours-of-a-face",
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

/// The savings of a structure and of the last frame, on all kinds of bodies.
fn lesson(found: &Measured<'_>) -> Option<String> {
    let reads = |experiment, method| found.over_inputs(experiment, method, Quantity::Value("reads"));
    let shares = |experiment, [method, other]: [&'static str; 2]| {
        let (own, others) = (reads(experiment, method), reads(experiment, other));
        let shares: Vec<Extreme> = own
            .into_iter()
            .filter_map(|end| {
                let of_input = others.iter().find(|other| (&other.input, other.n) == (&end.input, end.n))?;
                Some(Extreme { number: end.number / of_input.number, ..end })
            })
            .collect();
        let least = shares.iter().min_by(|a, b| a.number.total_cmp(&b.number)).map(words::at)?;
        let greatest = shares.iter().max_by(|a, b| a.number.total_cmp(&b.number)).map(words::at)?;
        Some((least, greatest))
    };
    let (least, greatest) = shares("direction-tree-queries", ["by_direction_tree", "by_lad"])?;
    let (slowest_least, slowest_greatest) = shares("coherence", ["warm", "fresh"])?;
    Some(format!(
        "For an exact gauge, at the largest size of each kind of bodies, a tree over the directions of the generators \
         reads {least} to {greatest} times what the kernel reads without one; in the slowest motion the kernel \
         that begins with the last frame reads {slowest_least} to {slowest_greatest} times what a fresh query does, n \
         being the frames of a turn."
    ))
}
