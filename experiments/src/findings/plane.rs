//! Sentences about sections 4 and 4.1.

use super::finding::Findings;
use super::words::{number, per_size, percent, plain, ratio, span};
use crate::data::outlines;
use crate::definition::Quantity;
use crate::measured::{Measured, Series, range};

pub(super) static FINDINGS: &[Findings] = &[
    Findings {
        experiment: "min-area-scaling",
        counted: &[],
        timed: &[|found| {
            let methods = ["by_slope_selection", "by_pruning"];
            ratio(found, "Times", "min-area-scaling", methods, Quantity::Time("total"))
        }],
    },
    Findings { experiment: "min-area-stages", counted: &[hull_share], timed: &[] },
    Findings {
        experiment: "lad-scaling",
        counted: &[|found| {
            span(
                found,
                "The number of passes of pruning",
                ["lad-scaling", "by_pruning"],
                Quantity::Value("passes"),
                plain,
            )
        }],
        timed: &[|found| {
            let methods = ["by_slope_selection", "by_pruning"];
            ratio(found, "Times", "lad-scaling", methods, Quantity::Time("total"))
        }],
    },
    Findings {
        experiment: "lad-race",
        counted: &[],
        timed: &[
            |found| {
                let methods = ["by_slope_selection", "by_pruning"];
                ratio(found, "Times", "lad-race", methods, Quantity::Time("total"))
            },
            |found| ratio(found, "Times", "lad-race", ["by_line_search", "by_pruning"], Quantity::Time("total")),
        ],
    },
    Findings {
        experiment: "pruning-passes",
        counted: &[|found| {
            span(found, "The number of passes", ["pruning-passes", "by_pruning"], Quantity::Value("passes"), plain)
        }],
        timed: &[],
    },
    Findings {
        experiment: "hull-scaling",
        counted: &[
            |found| {
                let chain = ["hull-scaling", "by_monotone_chain"];
                span(
                    found,
                    "The number of orientation tests of the monotone chain over n",
                    chain,
                    Quantity::Count("turn"),
                    per_size,
                )
            },
            |found| {
                let wrapping = ["hull-scaling", "brute_force"];
                span(
                    found,
                    "The number of orientation tests of gift wrapping over n",
                    wrapping,
                    Quantity::Count("turn"),
                    per_size,
                )
            },
        ],
        timed: &[],
    },
    Findings { experiment: "area-ratio", counted: &[area_ratio, outline_ratio], timed: &[] },
];

/// The part of the hull in the operations of the three stages that are counted apart.
fn hull_share(found: &Measured<'_>) -> Option<String> {
    let shares: Vec<String> = found
        .inputs("min-area-stages", "by_pruning")
        .into_iter()
        .filter_map(|input| {
            let series = Series { experiment: "min-area-stages", input, method: "by_pruning" };
            let stages = ["hull_operations", "antipodal_operations", "kernel_operations"];
            let [hull, antipodal, kernel] = stages.map(|stage| found.at_largest(series, Quantity::Value(stage)));
            let (hull, rest) = (hull?.1, antipodal?.1 + kernel?.1);
            Some(format!("{} on {}", percent(hull / (hull + rest)), super::words::input(input)))
        })
        .collect();
    let sentence =
        format!("Of the operations of hull, farthest vertices and kernel the hull has {}.", shares.join(", "));
    (!shares.is_empty()).then_some(sentence)
}

fn area_ratio(found: &Measured<'_>) -> Option<String> {
    span(found, "The ratio of the areas", ["area-ratio", "by_pruning"], Quantity::Value("area_ratio"), plain)
}

/// The ratios of country outlines alone.
fn outline_ratio(found: &Measured<'_>) -> Option<String> {
    let ratios = || {
        outlines().iter().filter_map(|outline| {
            let series = Series { experiment: "area-ratio", input: outline.name, method: "by_pruning" };
            Some(found.at_largest(series, Quantity::Value("area_ratio"))?.1)
        })
    };
    let [low, high] = range(ratios())?;
    Some(format!("Of {} country outlines it is from {} to {}.", ratios().count(), number(low), number(high)))
}
