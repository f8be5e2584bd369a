//! Sentences about hierarchies over meshes, and about zonotopes of little volume.

use super::finding::Findings;
use super::words::{between, input, number, percent, span, title};
use crate::definition::{Experiment, Quantity, Variant};
use crate::definitions::mesh_node_tests::{BOXES, COUNTS, TIMES};
use crate::measured::{Measured, Series, range};

pub(super) static FINDINGS: &[Findings] = &[
    Findings {
        experiment: "mesh-node-tests",
        counted: &[
            |found| fewest_tests(found, "at_10"),
            |found| fewest_tests(found, "at_1"),
            |found| fewest_tests(found, "at_0.1"),
            |found| fewest_tests(found, "all_pairs"),
            |found| tests(found, "zonotope_3", "at_1"),
            |found| tests(found, "zonotope_4", "at_1"),
            |found| tests(found, "zonotope_4", "at_0.1"),
            |found| tests(found, "zonotope_6", "at_1"),
            |found| tests(found, "zonotope_6", "at_0.1"),
            |found| tests(found, "zonotope_6", "all_pairs"),
            |found| tests(found, "zonotope_by_cost", "at_1"),
            |found| tests(found, "dop_26", "at_1"),
            |found| tests(found, "aabb", "at_1"),
        ],
        timed: &[],
    },
    Findings {
        experiment: "mesh-times",
        counted: &[],
        timed: &[
            |found| least_time(found, "at_10"),
            |found| least_time(found, "at_1"),
            |found| least_time(found, "contact"),
            |found| times(found, "zonotope_6", "at_1"),
            |found| times(found, "zonotope_6", "contact"),
            |found| times(found, "zonotope_4", "at_1"),
            |found| times(found, "zonotope_by_cost", "at_1"),
            |found| times(found, "zonotope_by_cost", "contact"),
            |found| times(found, "dop_26", "at_1"),
            |found| times(found, "aabb", "at_1"),
            |found| times(found, "aabb", "contact"),
            |found| times(found, "zonotope_6", "build"),
            |found| times(found, "aabb", "build"),
        ],
    },
    Findings {
        experiment: "least-volume",
        counted: &[
            |found| volume(found, "at_most_3"),
            |found| volume(found, "at_most_6"),
            |found| volume(found, "at_most_10"),
            |found| {
                let shares = found.over_inputs("least-volume", "at_most_6", Quantity::Value("near"));
                let [least, most] = range(shares.iter().map(|end| end.number))?.map(percent);
                Some(format!(
                    "Within 1 % of the smallest that is found with K = 6 end {least} to {most} of the starts."
                ))
            },
            |found| {
                let worst = Quantity::Value("worst");
                span(found, "The largest local optimum over the smallest, K = 6,", SIX, worst, |_, value| value)
            },
            |found| {
                let length = Quantity::Value("by_length");
                span(found, "The volume of short zonotopes over the smallest, K = 6,", SIX, length, |_, value| value)
            },
        ],
        timed: &[],
    },
];

const SIX: [&str; 2] = ["least-volume", "at_most_6"];

/// Sentence on the volumes of the fewest tests of nodes, mesh by mesh.
pub fn fewest_tests(found: &Measured<'_>, at: &'static str) -> Option<String> {
    let of_volumes = least(found, &COUNTS, Quantity::Value(at))?;
    Some(format!("The fewest tests of nodes ({at}) have {of_volumes}."))
}

/// Sentence on the volumes of the least time, mesh by mesh.
fn least_time(found: &Measured<'_>, lap: &'static str) -> Option<String> {
    Some(format!("The least time ({lap}) have {}.", least(found, &TIMES, Quantity::Time(lap))?))
}

/// The volumes that have the least of a quantity on some meshes, each with these meshes.
fn least<'a>(found: &Measured<'a>, experiment: &Experiment, quantity: Quantity) -> Option<String> {
    let best_on = |input: &'a str| {
        let of_volume = |variant: &Variant| {
            let series = Series { experiment: experiment.id, input, method: variant.id };
            Some((variant.id, found.at_largest(series, quantity)?.1))
        };
        let of_volumes = experiment.variants.iter().filter_map(of_volume);
        Some((input, of_volumes.min_by(|a, b| a.1.total_cmp(&b.1))?.0))
    };
    let best: Vec<(&str, &str)> = found.inputs(experiment.id, BOXES).into_iter().filter_map(best_on).collect();
    let of_volume = |variant: &Variant| {
        let on = best.iter().filter(|(_, volume)| *volume == variant.id);
        let meshes: Vec<String> = on.map(|(mesh, _)| input(mesh)).collect();
        if meshes.is_empty() { None } else { Some(format!("“{}” on {}", variant.title, meshes.join(", "))) }
    };
    let each: Vec<String> = experiment.variants.iter().filter_map(of_volume).collect();
    if each.is_empty() { None } else { Some(each.join("; ")) }
}

/// Sentence on the tests of nodes of a volume, mesh by mesh.
fn tests(found: &Measured<'_>, volume: &str, at: &'static str) -> Option<String> {
    let what = format!("Tests of nodes ({at}) of “{}” over those of searched boxes", title(COUNTS.id, volume));
    ratios(what, &found.ratios(COUNTS.id, [volume, BOXES], Quantity::Value(at)))
}

/// Sentence on the times of a volume, mesh by mesh.
fn times(found: &Measured<'_>, volume: &str, lap: &'static str) -> Option<String> {
    let what = format!("Time ({lap}) of “{}” over that of searched boxes", title(TIMES.id, volume));
    ratios(what, &found.ratios(TIMES.id, [volume, BOXES], Quantity::Time(lap)))
}

fn ratios(what: String, of_meshes: &[(&str, f64)]) -> Option<String> {
    let each: Vec<String> =
        of_meshes.iter().map(|(mesh, ratio)| format!("{} on {}", number(*ratio), input(mesh))).collect();
    if each.is_empty() { None } else { Some(format!("{what}: {}.", each.join("; "))) }
}

/// Sentence on the smallest volumes with a number of generators.
fn volume(found: &Measured<'_>, method: &str) -> Option<String> {
    let of = |name| {
        let ends = found.over_inputs("least-volume", method, Quantity::Value(name));
        range(ends.iter().map(|end| end.number)).map(between)
    };
    let inputs = found.inputs("least-volume", method).len();
    Some(format!(
        "The smallest zonotope that is found with {} or fewer around {inputs} inputs has {} times the volume of the \
         hull and {} generators.",
        title("least-volume", method),
        of("volume_ratio")?,
        of("generators")?
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::definition::{Case, Measurement, Verdict};
    use crate::environment::Environment;
    use crate::record::CountRow;
    use crate::runner::Records;
    use zonotope::tally::OperationCounts;

    fn row(mesh: &'static str, volume: &'static str, tests: f64) -> CountRow {
        let case = Case::new(1, COUNTS.id, mesh, volume, 4, 0);
        let right = Verdict::Correct("made up".to_owned());
        CountRow::new(&case, Ok(Measurement::new(&OperationCounts::default(), 0, right).with_value("at_1", tests)))
    }

    #[test]
    fn each_mesh_stands_with_the_volume_of_the_fewest_tests() {
        let counts = vec![
            row("needles", BOXES, 100.0),
            row("needles", "dop_26", 50.0),
            row("needles", "zonotope_6", 80.0),
            row("torus", BOXES, 30.0),
            row("torus", "zonotope_6", 12.0),
            row("cgal_cow", BOXES, 20.0),
            row("cgal_cow", "zonotope_6", 10.0),
        ];
        let records = Records { counts, times: Vec::new(), environment: Environment::current(), elsewhere: Vec::new() };
        let found = Measured::of(&records);
        let sentence = fewest_tests(&found, "at_1").expect("there are records");
        let [of_polytopes, of_zonotopes] = ["dop_26", "zonotope_6"].map(|volume| title(COUNTS.id, volume));
        let stated = format!("“{of_polytopes}” on needles; “{of_zonotopes}” on torus, cgal cow.");
        assert_eq!(sentence, format!("The fewest tests of nodes (at_1) have {stated}"));
        assert_eq!(fewest_tests(&found, "at_10"), None);
        let ratios = tests(&found, "zonotope_6", "at_1").expect("there are records");
        assert!(ratios.ends_with("over those of searched boxes: 0.800 on needles; 0.400 on torus; 0.500 on cgal cow."));
    }
}
