//! Sentences about section 5.1, and about the explicit faces.

use super::finding::Findings;
use super::words::{course, number, percent, plain, ratio, span, title};
use crate::catalog;
use crate::definition::Quantity;
use crate::measured::Measured;

pub(super) static FINDINGS: &[Findings] = &[
    Findings {
        experiment: "collision-scaling",
        counted: &[],
        timed: &[
            |found| ratio(found, "Times", COLLISION, ["by_slope_selection", "by_lad"], Quantity::Time("total")),
            |found| ratio(found, "Times", COLLISION, ["by_explicit_faces", "by_lad"], Quantity::Time("total")),
            |found| ratio(found, "Times", COLLISION, ["by_gjk", "by_lad"], Quantity::Time("total")),
        ],
    },
    Findings {
        experiment: "gauge-passes",
        counted: &[
            |found| span(found, "The number of passes", ["gauge-passes", "by_lad"], PASSES, plain),
            |found| course(found, "The number of passes", ["gauge-passes", "by_lad"], PASSES, plain),
        ],
        timed: &[],
    },
    Findings { experiment: "fallback-rate", counted: &[fallbacks], timed: &[] },
    Findings {
        experiment: "faces-scaling",
        counted: &[|found| {
            let facets = Quantity::Value("facets");
            course(found, "The number of facets over n(n − 1)", ["faces-scaling", "by_sweep"], facets, |n, facets| {
                facets / (n * (n - 1.0))
            })
        }],
        timed: &[],
    },
    Findings { experiment: "wrong-answers", counted: &[wrong_answers], timed: &[] },
];

const COLLISION: &str = "collision-scaling";
const PASSES: Quantity = Quantity::Value("passes");

/// The number of questions that have a sign that doubles leave undecided, near the boundary and farther from it.
fn fallbacks(found: &Measured<'_>) -> Option<String> {
    let total = |value| found.total("fallback-rate", "by_lad", value);
    let [asked, fallbacks] = [total("asked")?, total("fallbacks")?];
    let [apart, fallbacks_apart] = [total("asked_apart")?, total("fallbacks_apart")?];
    Some(format!(
        "Of {} questions {} have a sign that floating point does not decide ({}); of the {} with gaps of at least \
         1e-9, {} ({}).",
        number(asked),
        number(fallbacks),
        percent(fallbacks / asked),
        number(apart),
        number(fallbacks_apart),
        percent(fallbacks_apart / apart)
    ))
}

/// The wrong and the missing answers of each method.
fn wrong_answers(found: &Measured<'_>) -> Option<String> {
    let experiment = catalog::find("wrong-answers")?;
    let methods = experiment.variants.iter().filter_map(|variant| {
        let total = |value| Some(number(found.total(experiment.id, variant.id, value)?));
        let [wrong, failed, asked] = [total("wrong")?, total("failed")?, total("asked")?];
        Some(format!("“{}” {wrong} wrong and {failed} missing of {asked}", title(experiment.id, variant.id)))
    });
    let methods: Vec<String> = methods.collect();
    (!methods.is_empty()).then(|| format!("Answers: {}.", methods.join("; ")))
}
