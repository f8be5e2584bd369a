//! Bodies that are asked about again and again.

use crate::report::chapter::Chapter;

pub(super) static CHAPTER: Chapter = Chapter {
    id: "repeated-tests",
    title: "Bodies that are asked again and again",
    place: "Section 5.2, Lemmas 5.3 to 5.6, Corollary 5.4",
    statement: "Two bodies move, and at every moment it is asked whether they meet, or how far apart they are. What is \
        worth building once, so that a question need not read all generators?",
    method: &[
        "Space for time: a cutting of the dual lines has trapezoids that few lines cross. A query finds its trapezoid \
         among them and looks at the generators of those lines alone (Lemma 5.3); located along a ray, it has the \
         distance in the metric of the body (Corollary 5.4). With linear space, a tree over the directions of the \
         generators adds up neighbours whose signs agree.",
        "Coarser bodies: generators of similar directions are added up, and what is lost comes back as a box \
         (Lemma 5.5). Fitted sums of clusters are nearer with fewer generators; both contain the body exactly, and \
         the Hausdorff distance is bounded from both sides. Nested levels tell bodies that are far apart, or deep in \
         each other, from a handful of generators; the nearer they are to touching, the finer the levels that tell.",
        "Walking: the facets next to a facet are the next crossings along its dual lines. Convex hulls of the lines \
         above and below, which change by a line a step, find them (Lemma 5.6). The closest features of moving bodies \
         are followed so, or the optimum of the last frame is where the kernel begins in the next.",
    ],
    bound: "The paper: O((n²/m) log² n) a query with O(m) space; O(1/ε²) generators for a distance of ε diameters; \
        O(log² n) a step. Here: O(n²/m + log² n); about ε^(−4/5) generators for bodies like balls, measured; \
        O(log² n).",
    claims: &[
        "summary-repeated-tests",
        "translation-by-point-location",
        "lemma-5.3",
        "erratum-5.2-lemma-5.3",
        "corollary-5.4",
        "erratum-5.2-corollary-5.4",
        "convex-approximation",
        "ball-approximation",
        "zonoid-approximation",
        "lemma-5.5",
        "lemma-5.5-containment",
        "erratum-5.2-lemma-5.5",
        "local-walk",
        "lemma-5.6",
        "erratum-5.2-lemma-5.6",
    ],
    experiments: &[
        "query-trade-off",
        "direction-tree-queries",
        "reduction-error",
        "hierarchy-levels",
        "walk-steps",
        "coherence",
    ],
    commands: &[(
        "cargo run --release -- solve tests/goldens/questions.jsonl",
        "answers questions of every kind, those of member_batch, approx, reduce, hausdorff and walk among them",
    )],
};
