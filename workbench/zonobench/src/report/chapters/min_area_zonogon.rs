//! Minimum-area enclosing zonogon.

use experiments::data::outlines;
use experiments::definition::Quantity;
use experiments::findings::words;

use crate::report::chapter::{Chapter, ChapterTable, Cost, Held};
use experiments::fit::GrowthModel;
use experiments::measured::{Measured, Series, range};

pub(super) static CHAPTER: Chapter = Chapter {
    id: "min-area-zonogon",
    title: "The smallest zonogon around a set of points",
    place: "Section 4.1, Theorem 4.5",
    statement: "A zonogon is a centrally symmetric convex polygon: the set of sums c + Σ δᵢ gᵢ with every δᵢ between \
        −1 and 1, for a centre c and generators gᵢ. Given points of the plane, which zonogon of least area contains \
        them all?",
    lesson,
    pictures: &["country-outlines"],
    table: ChapterTable::Growth,
    method: &[
        "Once the centre O is chosen, the answer is plain: reflect the points through O and take the convex hull \
         Z(O) of both sets. So the question is where to put O. Write P₁ … Pₙ for the corners of the hull of the \
         points, and for each hull edge Pₜ Pₜ₊₁ let ℓₜ be the line halfway between the edge and the corner farthest \
         from it. The edge lies on Z(O) exactly when O is on its side of ℓₜ.",
        "The area of Z(O) is therefore a sum of hinges, one for each line: it is convex and piecewise linear, with \
         creases on the lines ℓₜ, and its minimum lies at a crossing of two of them. Finding that crossing is the \
         problem of the next chapter.",
        "The answer carries a proof. Slopes δₜ between −1 and 1 that balance at the optimum bound the area of every \
         enclosing zonogon from below; a separate verifier recomputes hull, containment, area and bound in \
         whole-number arithmetic. The generators are rounded outward, so the zonogon contains every point exactly.",
    ],
    costs: &[
        Cost { text: "The paper: O(n log² n).", held: Held::Claim("theorem-4.5") },
        Cost {
            text: "Here: expected O(n log n), hull included.",
            held: Held::Fit { experiment: "min-area-scaling", method: "by_pruning", law: GrowthModel::Linearithmic },
        },
    ],
    claims: &[
        "summary-min-area",
        "hull-suffices",
        "fixed-center-optimum",
        "combinatorial-description",
        "evaluation-in-linear-time",
        "area-formula",
        "figure-2",
        "linear-coefficient",
        "edge-criterion",
        "lemma-4.1",
        "edges-along-a-line",
        "minimum-at-vertex",
        "flat-point-sets",
        "theorem-4.5",
    ],
    experiments: &["min-area-scaling", "min-area-stages", "area-ratio", "hull-scaling"],
    commands: &[
        (
            "cargo run --release -- enclose experiments/data/outline_italy.csv --svg italy.svg --json italy.json",
            "solves it for the points of a file",
        ),
        (
            "cargo run --release -- verify experiments/data/outline_italy.csv italy.json",
            "checks the proof that the answer carries",
        ),
    ],
};

/// The ratio of the smallest zonogon to the hull, around real outlines and around anything, and how well that
/// is proved.
fn lesson(found: &Measured<'_>) -> Option<String> {
    let of = |value| {
        outlines().iter().filter_map(move |outline| {
            let series = Series { experiment: "area-ratio", input: outline.name, method: "by_pruning" };
            Some(found.at_largest(series, Quantity::Value(value))?.1)
        })
    };
    let [low, high] = range(of("area_ratio"))?;
    let overall = |value| found.extremes("area-ratio", "by_pruning", Quantity::Value(value), words::plain);
    let ([least, greatest], [_, gap]) = (overall("area_ratio")?, overall("relative_gap")?);
    Some(format!(
        "Around {} country outlines the smallest zonogon has {low:.2} to {high:.2} times the area of the convex hull; \
         over all inputs the ratio is from {} to {}, and the proof leaves a relative doubt of at most {}.",
        of("area_ratio").count(),
        words::at(&least),
        words::at(&greatest),
        words::at(&gap)
    ))
}
