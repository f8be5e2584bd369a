//! How far the rules of order reduction are from the body: the Hausdorff distance relative to the diameter against the
//! number of generators, with the exponent of a power law, for every family of bodies and every rule; and what
//! Lemma 5.5 needs beside cluster sums.
//!
//! `cargo run --release -p experiments --example reduction_rules -- [family] [n] [largest k]`. Distances are upper
//! bounds within one per cent of the lower ones, where a `~` does not say otherwise.

use std::env;
use std::time::Instant;

use experiments::families::bodies::{BODY_FAMILIES, BodyFamily, SPACE_TIME_FAMILIES};
use experiments::families::source::RandomSource;
use experiments::fit::fit_growth;
use zonotope::Zonotope;
use zonotope::reduction::by_patches::{patch_count, patches_within};
use zonotope::reduction::hausdorff::{Distance, excess};
use zonotope::reduction::{Method, Problem};

/// The ratio of the bounds is at most 1 + this.
const WIDTH: f64 = 0.01;

const COUNTS: [usize; 11] = [16, 23, 32, 45, 64, 91, 128, 181, 256, 362, 512];

/// Generators of length 1 in uniform directions: the body is nearly a ball.
const BALL: BodyFamily<3> = BodyFamily {
    id: "ball",
    title: "Near balls",
    description: "generators of length 1 in uniform directions",
    is_random: true,
    generate: unit_vectors,
};

fn unit_vectors(n: usize, seed: u64) -> Vec<[f64; 3]> {
    let mut source = RandomSource::new(seed);
    (0..n)
        .map(|_| {
            let z = source.signed_unit();
            let ([x, y], radius) = (source.unit_vector(), (1.0 - z * z).sqrt());
            [radius * x, radius * y, z]
        })
        .collect()
}

fn main() {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let number = |at: usize, default: usize| {
        arguments.get(at).map_or(default, |text| text.parse().expect("sizes are whole numbers"))
    };
    let (n, largest) = (number(1, 10_000), number(2, 512));
    let chosen = |id: &str| arguments.first().is_none_or(|family| family == id || family == "all");
    for family in [BALL].iter().chain(BODY_FAMILIES).filter(|family| chosen(family.id)) {
        in_space(family, n, largest);
    }
    for family in SPACE_TIME_FAMILIES.iter().filter(|family| chosen(family.id)) {
        rules(family, n.min(1000), largest.min(64));
    }
}

fn in_space(family: &BodyFamily<3>, n: usize, largest: usize) {
    let body = Zonotope::new([0.0; 3], family.generate(n, 1)).expect("the family is finite");
    let diameter = diameter(&body);
    println!("\n{}: Lemma 5.5", family.id);
    println!("| ε asked for | patches | generators | ε reached |");
    println!("|---|---|---|---|");
    let mut samples = Vec::new();
    for epsilon in [0.8, 0.4, 0.2, 0.1, 0.05] {
        let Ok(reduced) = patches_within(&body, epsilon) else { continue };
        let (count, reached) = (reduced.body.generators().len(), error(&reduced.body, &body, diameter));
        println!("| {epsilon} | {} | {count} | {} |", patch_count(3, epsilon), shown(&reached));
        samples.push((patch_count(3, epsilon), reached.upper));
    }
    print_exponent("error against patches", &samples);
    rules(family, n, largest);
}

/// The table of rules for one body of a family.
fn rules<const D: usize>(family: &BodyFamily<D>, n: usize, largest: usize) {
    let body = Zonotope::new([0.0; D], family.generate(n, 1)).expect("the family is finite");
    let diameter = diameter(&body);
    println!("\n{}: {} generators in R^{D}", family.id, n);
    for method in Method::ALL.into_iter().filter(|method| *method != Method::Best) {
        let mut samples = Vec::new();
        for count in COUNTS.into_iter().filter(|count| (D + 3..=largest.min(n)).contains(count)) {
            let start = Instant::now();
            let problem = Problem::new(&body, count).expect("the count is at least the dimension");
            let Ok(reduced) = method.reduce(&problem) else { continue };
            let time = start.elapsed();
            let reached = error(&reduced.body, &body, diameter);
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
    let distance = excess(outer, body, WIDTH);
    Distance { lower: distance.lower / diameter, upper: distance.upper / diameter, ..distance }
}

fn diameter<const D: usize>(body: &Zonotope<D>) -> f64 {
    let center = Zonotope::new(body.center(), Vec::new()).expect("the centre is finite");
    2.0 * excess(body, &center, 1e-3).lower
}

fn shown<const D: usize>(error: &Distance<D>) -> String {
    let mark = if error.upper <= (1.0 + WIDTH) * error.lower { "" } else { "~" };
    format!("{mark}{:.5}", error.upper)
}

fn print_exponent(what: &str, samples: &[(f64, f64)]) {
    if let Ok(growth) = fit_growth(samples, &[]) {
        let exponent = growth.exponent;
        println!("{what}: exponent {:.3} in [{:.3}, {:.3}]", exponent.value, exponent.low, exponent.high);
    }
}
