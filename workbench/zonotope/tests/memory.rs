//! Questions of up to a few hundred generators take no memory of the heap but that of their answers.

use allocation_counter::measure;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use zonotope::Zonotope;
use zonotope::collision::{Location, Query, Status, by_lad};

/// Up to so many generators, a question writes its lists in memory that the thread keeps.
const LARGEST: usize = 320;

/// Questions until the lists of a thread have the lengths that questions like these need.
const WARMING: usize = 5;

fn vector(random: &mut Pcg64Mcg) -> [f64; 3] {
    [0, 1, 2].map(|_| random.random_range(-1.0..1.0))
}

/// How often a question asks the heap for memory after some like it, and its answer.
fn taken<T>(mut ask: impl FnMut() -> T) -> (u64, T) {
    // a list that is too short for its next use grows once more
    for _ in 0..WARMING {
        drop(ask());
    }
    let mut answer = None;
    let taken = measure(|| answer = Some(ask())).count_total;
    (taken, answer.expect("the question was asked"))
}

/// A body and points around its boundary: relative distances from it, negative for those inside.
fn each_question(distances: &[f64], mut look: impl FnMut(&Query<'_, 3>, f64)) {
    let random = &mut Pcg64Mcg::seed_from_u64(12);
    for n in [3, 6, 12, 16, 17, 40, 64, 100, 128, 129, 200, LARGEST] {
        let body: Vec<_> = (0..n).map(|_| vector(random)).collect();
        for &distance in distances {
            let direction = vector(random);
            let ray = Query::new([0.0; 3], direction, &body).expect("finite");
            let length = (1.0 + distance) / by_lad::gauge(&ray, &mut ()).value;
            let query = Query::new([0.0; 3], direction.map(|c| length * c), &body).expect("finite");
            look(&query, distance);
        }
    }
}

#[test]
fn a_location_takes_memory_for_its_answer_alone() {
    each_question(&[-0.9, -0.5, -0.1, -1e-3, -1e-9, 1e-9, 1e-3, 0.1, 1.0, 5.0], |query, distance| {
        let (taken, location) = taken(|| by_lad::locate(query, &mut ()));
        let status = if distance < 0.0 { Status::Inside } else { Status::Outside };
        assert_eq!(location.status(), status);
        // the coefficients and the basis of a member
        let most = if matches!(location, Location::Outside(_)) { 0 } else { 2 };
        assert!(taken <= most, "{} generators at {distance}: {taken}", query.len());
    });
}

/// The coefficients of a member near the boundary are a rule of constant size until they are asked for.
#[test]
fn the_answer_of_a_body_takes_none_near_the_boundary() {
    each_question(&[-1e-3, -1e-9, 1e-9, 1e-3, 1.0], |query, distance| {
        let body = Zonotope::new(query.from(), query.generators().copied().collect()).expect("finite");
        let (taken, located) = taken(|| body.locate(query.to()).expect("finite"));
        assert_eq!(located.is_member(), distance < 0.0);
        let is_written = located.is_member() && located.rule().is_none();
        assert!(taken <= if is_written { 2 } else { 0 }, "{} generators at {distance}: {taken}", query.len());
    });
}

#[test]
fn a_gauge_without_its_proof_takes_none() {
    each_question(&[-0.5, -1e-9, 1e-9, 1.0], |query, distance| {
        let (taken, facet) = taken(|| by_lad::facet(query, &mut ()).value());
        assert!((facet.0 - 1.0 - distance).abs() <= 1e-12 * (1.0 + distance), "{facet:?}");
        assert_eq!(taken, 0, "{} generators at {distance}", query.len());
    });
}
