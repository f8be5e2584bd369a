//! Passes of questions over the generators, beside the numbers that are stored here: a pass that is added without a
//! reason is noticed the day it is added. The counts are the same on every machine.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use zonotope::collision::distance::by_support_simplex;
use zonotope::collision::distance::penetration::by_inner_polytope;
use zonotope::collision::{Query, by_lad};
use zonotope::tally::{Operation, OperationCounts};

/// Questions of each kind.
const QUESTIONS: usize = 8;

/// A method that answers a query, with its operations counted.
type Question = fn(&Query<'_, 3>, &mut OperationCounts);

/// A question, the number of generators, the gauge of the displacement, and the passes of all questions together.
struct Stored {
    name: &'static str,
    ask: Question,
    count: usize,
    gauge: f64,
    passes: f64,
}

fn locate(query: &Query<'_, 3>, counts: &mut OperationCounts) {
    by_lad::locate(query, counts);
}

fn gauge(query: &Query<'_, 3>, counts: &mut OperationCounts) {
    by_lad::nearest_gauge(query, counts);
}

fn depth(query: &Query<'_, 3>, counts: &mut OperationCounts) {
    by_inner_polytope::penetration(query, counts);
}

fn distance(query: &Query<'_, 3>, counts: &mut OperationCounts) {
    by_support_simplex::distance(query, counts);
}

fn stored(name: &'static str, ask: Question, count: usize, gauge: f64, passes: f64) -> Stored {
    Stored { name, ask, count, gauge, passes }
}

/// The generators that random questions of a kind read, over the number of generators.
fn passes(Stored { ask, count, gauge, .. }: &Stored) -> f64 {
    let random = &mut Pcg64Mcg::seed_from_u64(5);
    let mut counts = OperationCounts::default();
    for _ in 0..QUESTIONS {
        let mut vector = || [0, 1, 2].map(|_| random.random_range(-1.0..1.0f64));
        let body: Vec<_> = (0..*count).map(|_| vector()).collect();
        let direction = vector();
        let ray = Query::new([0.0; 3], direction, &body).expect("finite");
        let length = gauge / by_lad::gauge(&ray, &mut ()).value;
        ask(&Query::new([0.0; 3], direction.map(|c| length * c), &body).expect("finite"), &mut counts);
    }
    counts.get(Operation::GeneratorRead) as f64 / *count as f64
}

#[test]
fn questions_take_as_many_passes_as_ever() {
    let within = 1.0 - 1e-9;
    let table = [
        stored("location", locate, 64, 0.5, 10.0),
        stored("location", locate, 64, within, 24.0),
        stored("location", locate, 1024, 0.5, 8.5),
        stored("location", locate, 1024, within, 23.28),
        stored("location", locate, 1024, 2.0, 8.5),
        stored("location", locate, 16384, within, 9.56),
        stored("gauge", gauge, 64, within, 24.0),
        stored("gauge", gauge, 1024, within, 26.78),
        stored("depth", depth, 64, within, 64.0),
        stored("depth", depth, 64, 0.5, 133.0),
        stored("depth", depth, 1024, within, 63.28),
        stored("depth", depth, 16384, within, 45.56),
        stored("distance", distance, 64, 1.0 + 1e-9, 48.0),
        stored("distance", distance, 1024, 1.0 + 1e-9, 47.28),
        stored("distance", distance, 1024, 2.0, 62.75),
    ];
    let found = table.iter().map(|row| (row, passes(row)));
    let other: Vec<String> = found
        .filter(|(row, found)| (found - row.passes).abs() > 0.005)
        .map(|(row, found)| format!("{} of {} at {}: {found:.2}", row.name, row.count, row.gauge))
        .collect();
    assert!(other.is_empty(), "{other:#?}");
}
