//! Sentences about sections 4.2 and 4.3, and about the questions of section 7 that have a part of an answer.

use super::finding::Findings;
use super::words::{course, number, plain, ratio, span, title};
use crate::catalog;
use crate::definition::Quantity;
use crate::measured::{Measured, Series, range};

pub(super) static FINDINGS: &[Findings] = &[
    Findings {
        experiment: "directions-scaling",
        counted: &[
            |found| {
                let as_needed = ["directions-scaling", "by_row_generation"];
                course(found, "The number of rows with normals as they are needed", as_needed, ROWS, plain)
            },
            |found| {
                let printed = ["directions-scaling", "papers_program"];
                course(found, "The number of rows of the paper's program", printed, ROWS, plain)
            },
            |found| {
                let printed = ["directions-scaling", "papers_program"];
                let share = Quantity::Value("share_of_bound");
                span(
                    found,
                    "The part that the paper's program has of the rows that its bound allows",
                    printed,
                    share,
                    plain,
                )
            },
        ],
        timed: &[],
    },
    Findings {
        experiment: "points-scaling",
        counted: &[
            |found| {
                let as_needed = ["points-scaling", "by_row_generation"];
                span(found, "The number of passes with normals as they are needed", as_needed, PASSES, plain)
            },
            |found| {
                let printed = ["points-scaling", "papers_program"];
                span(found, "The number of passes of the paper's program", printed, PASSES, plain)
            },
        ],
        timed: &[],
    },
    Findings {
        experiment: "scan-race",
        counted: &[|found| {
            span(
                found,
                "The number of passes with normals as they are needed",
                ["scan-race", "by_row_generation"],
                PASSES,
                plain,
            )
        }],
        timed: &[|found| {
            let methods = ["extreme_point_scan", "by_row_generation"];
            ratio(found, "Times", "scan-race", methods, Quantity::Time("total"))
        }],
    },
    Findings {
        experiment: "length-ratio",
        counted: &[
            |found| used(found, "papers_net"),
            |found| used(found, "net_of_cells"),
            |found| used(found, "by_column_generation"),
            |found| {
                let as_needed = ["length-ratio", "by_column_generation"];
                let generators = Quantity::Value("generators");
                course(
                    found,
                    "The number of generators with directions as they are needed",
                    as_needed,
                    generators,
                    plain,
                )
            },
        ],
        timed: &[],
    },
    Findings {
        experiment: "gap-curve",
        counted: &[|found| {
            let method = ["gap-curve", "by_column_generation"];
            course(
                found,
                "The number of rounds to a relative doubt of 1e-6",
                method,
                Quantity::Value("rounds_to_1e-6"),
                plain,
            )
        }],
        timed: &[],
    },
    Findings { experiment: "few-generators", counted: &[few_generators], timed: &[] },
    Findings {
        experiment: "enclosing-quality",
        counted: &[
            |found| {
                let quality = ["enclosing-quality", "within_1e-2"];
                span(found, "The proven ratio of the lengths", quality, Quantity::Value("ratio"), plain)
            },
            |found| {
                let quality = ["enclosing-quality", "within_1e-2"];
                span(found, "The volume over that of the hull", quality, Quantity::Value("volume_ratio"), plain)
            },
            |found| {
                let quality = ["enclosing-quality", "within_1e-2"];
                span(
                    found,
                    "The volume of the box along the axes over that of the hull",
                    quality,
                    Quantity::Value("box_volume_ratio"),
                    plain,
                )
            },
        ],
        timed: &[],
    },
];

const ROWS: Quantity = Quantity::Value("rows");
const PASSES: Quantity = Quantity::Value("passes");

/// The part of the relative excess that a ratio of 1 + ε allows, of which n is 1 / ε.
fn used(found: &Measured<'_>, method: &str) -> Option<String> {
    let what = format!("The excess over ε of “{}”", title("length-ratio", method));
    span(found, &what, ["length-ratio", method], Quantity::Value("excess"), |n, excess| n * excess)
}

/// The proven ratios of each bound on the number of generators, over all meshes.
fn few_generators(found: &Measured<'_>) -> Option<String> {
    let experiment = catalog::find("few-generators")?;
    let bounds = experiment.variants.iter().filter_map(|variant| {
        let ratios = found.inputs(experiment.id, variant.id).into_iter().filter_map(|input| {
            let series = Series { experiment: experiment.id, input, method: variant.id };
            Some(found.at_largest(series, Quantity::Value("ratio"))?.1)
        });
        let ratios: Vec<f64> = ratios.collect();
        let [low, high] = range(ratios.iter().copied())?;
        Some(format!("{} to {} for “{}” ({} meshes)", number(low), number(high), variant.title, ratios.len()))
    });
    let bounds: Vec<String> = bounds.collect();
    (!bounds.is_empty()).then(|| format!("Proven ratios of the lengths: {}.", bounds.join("; ")))
}
