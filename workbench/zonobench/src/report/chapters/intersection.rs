//! Whether two zonotopes intersect.

use crate::report::chapter::{Chapter, ChapterTable, Cost, Held};
use crate::report::html::grouped;
use experiments::definition::Quantity;
use experiments::findings::words;
use experiments::fit::GrowthModel;
use experiments::measured::{Measured, range};

pub(super) static CHAPTER: Chapter = Chapter {
    id: "intersection",
    title: "Do two zonotopes meet?",
    place: "Section 5.1, Lemma 5.1 and Theorem 5.2",
    statement: "Two bodies are given by their centres and generators. Do they have a point in common, do they only \
        touch, and what proves it? The polytopes have far more faces than the lists have generators.",
    lesson,
    pictures: &["certificates-of-intersection"],
    table: ChapterTable::Values("wrong-answers"),
    method: &[
        "The bodies meet exactly when the difference of their centres lies in the zonotope of all generators \
         together. So the question is whether a point p lies in one zonotope Z about the origin.",
        "The paper's search locates p in the tiling of the upper hull: each step compares p with one separator, \
         built by slope selection, and drops half of the tiles; then the one facet above p decides.",
        "The default method looks for the direction u with u·p = 1 in which Z reaches least far. That is the kernel \
         of section 4.1 again. A sample finds the neighbourhood of the best direction, one pass over the generators \
         adds up all those whose sign is the same throughout the neighbourhood, and the rest is decided \
         exactly. If Z reaches less than 1, u separates; otherwise the signs of u·vᵢ give the coefficients of p.",
        "Floating point only filters: wherever its error bound leaves a doubt, exact arithmetic decides, so bodies \
         that touch are told from bodies that do not, at any scale.",
    ],
    costs: &[
        Cost { text: "The paper: O(n log² n).", held: Held::Claim("theorem-5.2") },
        Cost {
            text: "Here: expected O(1) passes over the generators.",
            held: Held::Fit { experiment: "gauge-passes", method: "by_lad", law: GrowthModel::Constant },
        },
    ],
    claims: &[
        "minkowski-closure",
        "lemma-5.1",
        "explicit-test",
        "between-the-hulls",
        "separator-comparisons",
        "theorem-5.2",
        "question-4d-intersection",
        "explicit-size",
        "difference-of-centers",
    ],
    experiments: &["collision-scaling", "gauge-passes", "fallback-rate", "rung-shares", "wrong-answers"],
    commands: &[
        (
            "cargo run --release -- intersect first.json second.json --svg meeting.svg",
            "decides for two bodies of your own, files with center and generators, and draws the proof",
        ),
        (
            "cargo run --release -- solve tests/goldens/questions.jsonl",
            "answers questions of every kind, those of member, intersect and gauge among them",
        ),
    ],
};

/// Wrong answers near contact, and how many questions they are among.
fn lesson(found: &Measured<'_>) -> Option<String> {
    let total = |method, value| found.total("wrong-answers", method, value).map(|sum| grouped(sum as u64));
    let ends = found.over_inputs("gauge-passes", "by_lad", PASSES);
    let passes = range(ends.iter().map(|end| end.number))?;
    let [_, ever] = found.extremes("gauge-passes", "by_lad", PASSES, words::plain)?;
    Some(format!(
        "Of {} questions about bodies apart, overlapping and nearly touching, the kernel gets {} wrong; \
         our own GJK in floating point gets {} of {} wrong, and to {} it finds no answer. The median \
         number of passes that an exact gauge takes over {} generators is {}, by the kind of bodies; the most at \
         any size are {}.",
        total("by_lad", "asked")?,
        total("by_lad", "wrong")?,
        total("by_gjk", "wrong")?,
        total("by_gjk", "asked")?,
        total("by_gjk", "failed")?,
        grouped(ends.iter().map(|end| end.n).max()?),
        words::between(passes),
        words::at(&ever)
    ))
}

const PASSES: Quantity = Quantity::Value("passes");
