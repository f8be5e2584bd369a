//! First contacts: the stretches and support evaluations that each method takes on nine families of motions, and the
//! times for random bodies.
//!
//! `cargo bench -p rivals --bench first_contact`; `-- missed 1000000` looks for missed collisions of so many random
//! motions instead, and counts those that sampling and the hulls of end poses miss.

use std::hint::black_box;
use std::time::Instant;

use zonotope::motion::continuous::{FirstContact, Method, first_contact};
use zonotope::tally::{Operation, OperationCounts};

mod families;
mod missed;

use families::{FAMILIES, Scene, meeting, passing, scene};

/// Motions of each family.
const MOTIONS: u64 = 21;

/// The clearance of a free motion.
const CLEARANCE: f64 = 1e-3;

/// The clearances of the families.
const CLEARANCES: [f64; 3] = [1e-3, 1e-2, 1e-4];

/// The resolution of a contact.
const RESOLUTION: f64 = 1.0 / (1u64 << 30) as f64;

fn answer(scene: &Scene) -> FirstContact {
    first_contact(scene.bodies.each_ref(), scene.motions.each_ref())
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// The least of several rounds, in microseconds for one scene.
fn microseconds(scenes: &[Scene]) -> f64 {
    let times = scenes.iter().map(|scene| {
        let round = || {
            let start = Instant::now();
            black_box(answer(black_box(scene)));
            start.elapsed().as_secs_f64() * 1e6
        };
        (0..60).map(|_| round()).fold(f64::INFINITY, f64::min)
    });
    median(times.collect())
}

/// The medians of the free stretches and of the support evaluations of a method, and how many scenes are not separate.
fn medians(scenes: &[Scene], method: Method) -> (f64, f64, usize) {
    let mut not_separate = 0;
    let (stretches, evaluations) = scenes
        .iter()
        .map(|scene| {
            let mut counts = OperationCounts::default();
            let (bodies, motions) = (scene.bodies.each_ref(), scene.motions.each_ref());
            let found = method.first_contact(bodies, motions, RESOLUTION, &mut counts);
            not_separate += usize::from(found.name() != "separate");
            (found.free().len() as f64, counts.get(Operation::SupportEvaluation) as f64)
        })
        .unzip();
    (median(stretches), median(evaluations), not_separate)
}

fn families() {
    for clearance in CLEARANCES {
        println!("clearance {clearance}: stretches, support evaluations of each method; microseconds of the default");
        for family in FAMILIES {
            let scenes: Vec<Scene> = (0..MOTIONS).map(|seed| scene(family, seed, clearance)).collect();
            print!("{family:18}");
            for method in Method::ALL {
                let (stretches, evaluations, not_separate) = medians(&scenes, method);
                let doubt = if not_separate == 0 { String::new() } else { format!(" ({not_separate} not separate)") };
                print!(" | {stretches:5} {evaluations:6}{doubt}");
            }
            println!(" | {:8.2}", microseconds(&scenes));
        }
    }
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|argument| argument != "--bench").collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>().as_slice() {
        ["missed", count] => missed::count(count.parse().expect("a number of motions")),
        ["profile", kind, n] => profile(kind, n.parse().expect("a number of generators")),
        ["times"] => times(),
        ["families"] => families(),
        _ => {
            times();
            families();
        }
    }
}

/// The scenes of a kind, asked about once each within [`profiled`], for a profiler that collects there.
fn profile(kind: &str, n: usize) {
    let scene = |seed| if kind == "meeting" { meeting(n, seed) } else { passing(n, seed, CLEARANCE) };
    let scenes: Vec<Scene> = (0..MOTIONS).map(scene).collect();
    scenes.iter().for_each(|scene| {
        black_box(answer(scene));
    });
    profiled(&scenes);
}

#[inline(never)]
fn profiled(scenes: &[Scene]) {
    for scene in scenes {
        black_box(answer(black_box(scene)));
    }
}

fn times() {
    for n in [10, 100, 1000] {
        let scenes: Vec<Scene> = (0..MOTIONS).map(|seed| passing(n, seed, CLEARANCE)).collect();
        let stretches = scenes.iter().map(|scene| answer(scene).free().len() as f64).collect();
        println!("passing n = {n:4}: {:4} stretches, {:9.2} µs", median(stretches), microseconds(&scenes));
    }
    for n in [10, 100, 1000] {
        let scenes: Vec<Scene> = (0..MOTIONS).map(|seed| meeting(n, seed)).collect();
        let answers: Vec<FirstContact> = scenes.iter().map(answer).collect();
        let contacts = answers.iter().filter(|answer| answer.name() == "contact").count();
        let stretches = answers.iter().map(|answer| answer.free().len() as f64).collect();
        println!(
            "meeting n = {n:4}: {:4} stretches, {:9.2} µs, {contacts} of {MOTIONS} are contacts",
            median(stretches),
            microseconds(&scenes)
        );
    }
}
