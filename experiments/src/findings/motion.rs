//! Sentences about section 6.

use super::finding::Findings;
use super::words::{course, plain, ratio};
use crate::definition::Quantity;
use crate::measured::Measured;

const INTERVALS: Quantity = Quantity::Value("intervals");
const SUPPORTS: Quantity = Quantity::Value("supports");
const EXCESS: Quantity = Quantity::Value("excess");

pub(super) static FINDINGS: &[Findings] = &[
    Findings {
        experiment: "motion-clearance",
        counted: &[
            |found| {
                let own = ["motion-clearance", "by_control_points"];
                course(found, "The number of stretches by control points", own, INTERVALS, plain)
            },
            |found| {
                let volumes = ["motion-clearance", "by_space_time_volumes"];
                course(found, "The number of stretches by Theorem 6.1", volumes, INTERVALS, plain)
            },
        ],
        timed: &[],
    },
    Findings {
        experiment: "motion-strength",
        counted: &[
            |found| against(found, "Stretches", "by_space_time_volumes", INTERVALS),
            |found| against(found, "Stretches", "by_conservative_advancement", INTERVALS),
            |found| against(found, "Stretches", "by_chord", INTERVALS),
            |found| against(found, "Support values", "by_conservative_advancement", SUPPORTS),
        ],
        timed: &[],
    },
    Findings {
        experiment: "motion-misses",
        counted: &[
            |found| missed(found, "Sampling misses", "by_sampling"),
            |found| missed(found, "The hulls of end poses miss", "by_hull_of_end_poses"),
            |found| missed(found, "Control points miss", "by_control_points"),
        ],
        timed: &[],
    },
    Findings {
        experiment: "swept-excess",
        counted: &[
            |found| course(found, "The excess of Theorem 6.1", ["swept-excess", "by_farthest_vertex"], EXCESS, plain),
            |found| {
                let middle = ["swept-excess", "by_middle_placement"];
                course(found, "The excess from the middle placement", middle, EXCESS, plain)
            },
            |found| {
                let turned = ["swept-excess", "by_turned_generators"];
                course(found, "The excess of turned generators", turned, EXCESS, plain)
            },
        ],
        timed: &[],
    },
];

fn against(found: &Measured<'_>, what: &str, other: &str, quantity: Quantity) -> Option<String> {
    ratio(found, what, "motion-strength", ["by_control_points", other], quantity)
}

/// Sentence on the proved collisions that a method misses, over all inputs and numbers of steps.
fn missed(found: &Measured<'_>, what: &str, method: &str) -> Option<String> {
    let total = |value| found.total("motion-misses", method, value);
    Some(format!("{what} {} of {} collisions.", total("missed")?, total("collisions")?))
}
