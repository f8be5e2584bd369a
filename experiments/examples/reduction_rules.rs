//! Distances of the rules of order reduction from the body: the Hausdorff distance relative to the diameter against the
//! number of generators, with the exponent of a power law, for every family of bodies and every rule; and what
//! Lemma 5.5 needs beside cluster sums for one precision.
//!
//! `cargo run --release -p experiments --features studies --example reduction_rules --
//! [family or all] [n] [largest k] [rule]`.
//! Distances are upper bounds, in space within one per cent of the lower ones and above within ten, where a `~` does
//! not say otherwise.

use std::env;
use std::time::Instant;

use experiments::fit::fit_growth;
use families::bodies::{BODY_FAMILIES, NEAR_BALLS, SPACE_TIME_FAMILIES};
use families::source::RandomSource;
use zonotope::Zonotope;
use zonotope::reduction::by_patches::{patch_count, patches_within};
use zonotope::reduction::hausdorff::{Distance, excess};
use zonotope::reduction::{Method, Problem};

/// The ratio of the bounds is at most 1 + this, up to three dimensions and above.
const WIDTH: f64 = 0.01;
const WIDTH_ABOVE: f64 = 0.1;

/// The precision for which generators are counted.
const PRECISION: f64 = 0.05;

const COUNTS: [usize; 11] = [16, 23, 32, 45, 64, 91, 128, 181, 256, 362, 512];

/// Generators of R^D with independent normal coordinates.
fn normal_vectors<const D: usize>(n: usize, seed: u64) -> Vec<[f64; D]> {
    let mut source = RandomSource::new(seed);
    (0..n).map(|_| std::array::from_fn(|_| source.normal_pair()[0])).collect()
}

fn main() {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let number = |at: usize, default: usize| {
        arguments.get(at).map_or(default, |text| text.parse().expect("sizes are whole numbers"))
    };
    let (n, largest) = (number(1, 10_000), number(2, 512));
    let chosen = |id: &str| arguments.first().is_none_or(|family| family == id || family == "all");
    let methods: Vec<Method> = Method::ALL
        .into_iter()
        .filter(|method| *method != Method::Best && arguments.get(3).is_none_or(|id| id == method.id()))
        .collect();
    for family in [NEAR_BALLS].into_iter().chain(BODY_FAMILIES).filter(|family| chosen(family.id)) {
        let body = Zonotope::new([0.0; 3], family.generate(n, 1)).expect("the family is finite");
        counts_for_precision(family.id, &body);
        rules(family.id, &body, largest, &methods);
    }
    let few = n.min(1000);
    for family in SPACE_TIME_FAMILIES.iter().filter(|family| chosen(family.id)) {
        let body = Zonotope::new([0.0; 4], family.generate(few, 1)).expect("the family is finite");
        rules(family.id, &body, largest.min(64), &methods);
    }
    if chosen("random_bodies_5") {
        let body = Zonotope::new([0.0; 5], normal_vectors(few, 1)).expect("normal numbers are finite");
        rules("random_bodies_5", &body, largest.min(32), &methods);
    }
    if chosen("random_bodies_6") {
        let body = Zonotope::new([0.0; 6], normal_vectors(few, 1)).expect("normal numbers are finite");
        rules("random_bodies_6", &body, largest.min(32), &methods);
    }
}

/// The reach of Lemma 5.5, and the generators that it and cluster sums take for one precision.
fn counts_for_precision(id: &str, body: &Zonotope<3>) {
    let diameter = diameter(body);
    println!("\n{id}: Lemma 5.5\n| ε asked for | patches | generators | ε reached |\n|---|---|---|---|");
    let (mut samples, mut needed) = (Vec::new(), None);
    for epsilon in (0..24).map(|step| 0.8 * libm::exp2(-f64::from(step) / 6.0)) {
        let Ok(reduced) = patches_within(body, epsilon, &mut ()) else { continue };
        let (patches, generators) = (patch_count(3, epsilon), reduced.body.generators().len());
        let reached = error(&reduced.body, body, diameter);
        println!("| {epsilon:.3} | {patches} | {generators} | {} |", shown(&reached));
        samples.push((patches, reached.upper));
        if reached.upper <= PRECISION && needed.is_none() {
            needed = Some((patches, generators));
        }
    }
    print_exponent("error against patches", &samples);
    let clusters = (3..64).find(|count| {
        let problem = Problem::new(body, *count).expect("the count is at least the dimension");
        let reduced = Method::Clusters.reduce(&problem);
        reduced.is_ok_and(|reduced| error(&reduced.body, body, diameter).upper <= PRECISION)
    });
    println!("{PRECISION}: Lemma 5.5 (patches, generators) {needed:?}, clusters {clusters:?}");
}

/// The table of rules for one body.
fn rules<const D: usize>(id: &str, body: &Zonotope<D>, largest: usize, methods: &[Method]) {
    let (n, diameter) = (body.generators().len(), diameter(body));
    println!("\n{id}: {n} generators in R^{D}\n| rule | k | generators | ε | time | time of the distance |");
    println!("|---|---|---|---|---|---|");
    for method in methods {
        let mut samples = Vec::new();
        for count in COUNTS.into_iter().filter(|count| (D + 3..=largest.min(n)).contains(count)) {
            let start = Instant::now();
            let problem = Problem::new(body, count).expect("the count is at least the dimension");
            let Ok(reduced) = method.reduce(&problem) else { continue };
            let time = start.elapsed();
            let reached = error(&reduced.body, body, diameter);
            println!(
                "| {} | {count} | {} | {} | {time:.1?} | {:.1?} |",
                method.id(),
                reduced.body.generators().len(),
                shown(&reached),
                start.elapsed() - time
            );
            samples.push((count as f64, reached.upper));
        }
        print_exponent(method.id(), &samples);
    }
}

fn error<const D: usize>(outer: &Zonotope<D>, body: &Zonotope<D>, diameter: f64) -> Distance<D> {
    let distance = excess(outer, body, width(D));
    Distance { lower: distance.lower / diameter, upper: distance.upper / diameter, ..distance }
}

fn width(dimension: usize) -> f64 {
    if dimension > 3 { WIDTH_ABOVE } else { WIDTH }
}

fn diameter<const D: usize>(body: &Zonotope<D>) -> f64 {
    let center = Zonotope::new(body.center(), Vec::new()).expect("the centre is finite");
    2.0 * excess(body, &center, width(D) / 10.0).lower
}

fn shown<const D: usize>(error: &Distance<D>) -> String {
    let mark = if error.upper <= (1.0 + width(D)) * error.lower { "" } else { "~" };
    format!("{mark}{:.5}", error.upper)
}

fn print_exponent(what: &str, samples: &[(f64, f64)]) {
    if let Ok(growth) = fit_growth(samples, &[]) {
        let exponent = growth.exponent;
        println!("{what}: exponent {:.3} in [{:.3}, {:.3}]", exponent.value, exponent.low, exponent.high);
    }
}
