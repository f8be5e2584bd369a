//! The tiling of the upper hull and the line arrangement dual to it.

use crate::report::chapter::Chapter;

pub(super) static CHAPTER: Chapter = Chapter {
    id: "duality",
    title: "A tiling and its dual arrangement",
    place: "Section 3, Figure 1; section 5.1",
    statement: "Seen from above, the facets of a zonohedron that look up tile a convex polygon Q with \
        parallelograms. How are the tiles arranged, and how can Q be cut in two between them without listing them \
        all?",
    method: &[
        "Generator (a, b, c) becomes the line a x + b y + c = 0. Tiles then correspond to crossings of lines, edges \
         of the tiling to edges of the arrangement, vertices of the tiling to faces of the arrangement.",
        "Number the crossings from left to right. A vertical line just right of the k-th crossing meets the lines in \
         some order from top to bottom; setting the projected generators end to end in that order gives a chain \
         through the tiling with the first k tiles on its left. Slope selection finds the k-th crossing without \
         listing the others.",
    ],
    bound: "The paper: a separator in O(n log n). Here: expected O(n log n), with a randomised slope selection.",
    claims: &[
        "upper-hull-tiling",
        "tiling-arrangement-duality",
        "figure-1",
        "separator-order",
        "separators",
        "erratum-5.1-separators",
    ],
    experiments: &[],
    commands: &[(
        "cargo run --release -- solve tests/goldens/questions.jsonl",
        "answers questions of every kind, those of separator, upper_hull and slope_selection among them",
    )],
};
