//! The tiling of the upper hull and the line arrangement dual to it.

use crate::report::chapter::{Chapter, ChapterTable, Cost, Held};
use experiments::fit::GrowthModel;
use experiments::measured::Measured;

pub(super) static CHAPTER: Chapter = Chapter {
    id: "duality",
    title: "A tiling and its dual arrangement",
    place: "Section 3, Figure 1; section 5.1",
    statement: "Seen from above, the facets of a zonohedron that look up tile a convex polygon Q with \
        parallelograms. How are the tiles arranged, and how can Q be cut in two between them without listing them \
        all?",
    lesson,
    pictures: &["paper-figure-1"],
    table: ChapterTable::Words {
        head: &["generators", "dual arrangement", "tiling of Q", "zonohedron"],
        rows: &[
            &["one", "a line", "a direction of edges", "a zone"],
            &["two", "a crossing", "a tile", "a facet that looks up, and its opposite"],
            &["one between two others", "an edge", "an edge", "an edge of the upper hull"],
            &["a sign for each", "a face", "a vertex", "a vertex of the upper hull"],
            &["their order on a vertical line", "the lines that it meets, from the top", "a chain", "a path of edges"],
        ],
    },
    method: &[
        "Generator (a, b, c) becomes the line a x + b y + c = 0. Tiles then correspond to crossings of lines, edges \
         of the tiling to edges of the arrangement, vertices of the tiling to faces of the arrangement.",
        "Number the crossings from left to right. A vertical line just right of the k-th crossing meets the lines in \
         some order from top to bottom; setting the projected generators end to end in that order gives a chain \
         through the tiling with the first k tiles on its left. Slope selection finds the k-th crossing without \
         listing the others.",
    ],
    costs: &[
        Cost { text: "The paper: a separator in O(n log n).", held: Held::Claim("separators") },
        Cost {
            text: "Here: expected O(n log n), with a randomised slope selection.",
            held: Held::Fit {
                experiment: "slope-selection-scaling",
                method: "randomized",
                law: GrowthModel::Linearithmic,
            },
        },
    ],
    claims: &[
        "upper-hull-tiling",
        "tiling-arrangement-duality",
        "figure-1",
        "monotone-subdivision",
        "separator-order",
        "separator-length",
        "separators",
        "separator-steps",
    ],
    experiments: &[],
    commands: &[(
        "cargo run --release -- solve tests/goldens/questions.jsonl",
        "answers questions of every kind, those of separator, upper_hull and slope_selection among them",
    )],
};

/// The numbering of the tiles; the chapter has no experiment of its own.
fn lesson(_: &Measured<'_>) -> Option<String> {
    let lesson = "The crossings of the lines, counted from the left, number the tiles: one crossing selected and the \
                  lines sorted there give a chain with a given number of tiles on its left, and none of the tiles is \
                  ever listed.";
    Some(lesson.to_owned())
}
