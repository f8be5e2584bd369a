//! The kernel: weighted least absolute deviations in the plane.

use experiments::definition::Quantity;

use crate::report::chapter::{Chapter, ChapterTable, Cost, Held};
use crate::report::html::grouped;
use experiments::findings::words;
use experiments::fit::GrowthModel;
use experiments::measured::{Measured, range};

pub(super) static CHAPTER: Chapter = Chapter {
    id: "kernel",
    title: "The lowest point of a sum of hinges",
    place: "Section 4.1, Lemmas 4.2 and 4.3, Corollary 4.4",
    statement: "Given lines aᵢ·x + bᵢ = 0 with weights wᵢ, find the point x of the plane that minimises \
        c·x + Σ wᵢ |aᵢ·x + bᵢ|. The same problem decides whether a point lies in a zonotope of space.",
    lesson,
    pictures: &["search-of-theorem-4-5"],
    table: ChapterTable::Growth,
    method: &[
        "The paper's search keeps a vertical slab that holds the optimum. Slope selection finds the median crossing \
         inside the slab; on the vertical line through it the minimum is a problem with one variable; the slopes \
         there tell on which side the optimum lies, and half of the crossings are gone.",
        "Line search walks downhill instead: along a line the minimum is a weighted median, found in linear time, \
         and each such minimum suggests the next line.",
        "Pruning solves the problem for a random sample, puts a small cell around the sample's optimum, and adds up \
         all lines that miss the cell into one linear term. Few lines remain, and their optimum is the true one if \
         it lies in the cell: a test, not a hope, so chance affects the time and never the answer.",
    ],
    costs: &[
        Cost { text: "The paper: O(log n) steps of O(n log n) each.", held: Held::Claim("halving-search") },
        Cost {
            text: "The paper's search here: expected O(n log² n), with a randomised slope selection.",
            held: Held::Fit {
                experiment: "lad-scaling",
                method: "by_slope_selection",
                law: GrowthModel::LinearLogSquared,
            },
        },
        Cost {
            text: "Pruning: expected O(1) passes over the lines.",
            held: Held::Fit { experiment: "pruning-passes", method: "by_pruning", law: GrowthModel::Constant },
        },
    ],
    claims: &["lemma-4.2", "lemma-4.3", "corollary-4.4", "deciding-side", "candidates", "halving-search"],
    experiments: &["lad-scaling", "lad-race", "methods-agree", "pruning-passes", "slope-selection-scaling"],
    commands: &[
        ("cargo run --release -- list methods", "names the methods"),
        (
            "cargo run --release -- solve tests/goldens/questions.jsonl --seed 7",
            "answers questions of every kind; one of min_area may name a method of the kernel",
        ),
    ],
};

/// The number of times that pruning reads its input, on all kinds of lines; what the clock says of the methods stands
/// with the times.
fn lesson(found: &Measured<'_>) -> Option<String> {
    let passes = found.over_inputs("pruning-passes", "by_pruning", Quantity::Value("passes"));
    let ends = range(passes.iter().map(|end| end.number))?;
    let [_, ever] = found.extremes("pruning-passes", "by_pruning", Quantity::Value("passes"), words::plain)?;
    Some(format!(
        "The median number of passes that pruning takes over {} lines is {}, on {} kinds of lines; the most at any \
         size are {}.",
        grouped(passes.iter().map(|end| end.n).max()?),
        words::between(ends),
        passes.len(),
        words::at(&ever)
    ))
}
