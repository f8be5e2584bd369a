//! Locations and gauges of points relative to bodies of a few generators whose coordinates have exponents from all over
//! the range of doubles, crossed with the exact face lattice: at rest, under a pose and prepared.
//!
//! Products of such coordinates underflow and overflow in the middle of a proof, not in the numbers that are given.

use rand::{Rng, RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use std::env;
use zonotope::collision::{Query, Status, by_explicit_faces, by_lad};
use zonotope::{Pose, Zonotope, ZonotopeError};

/// The questions of a long run and of an ordinary one.
const QUESTIONS: [u64; 2] = [60_000, 4_000];

/// A body and a point beside, on or within it.
struct Question<const D: usize> {
    center: [f64; D],
    point: [f64; D],
    generators: Vec<[f64; D]>,
}

/// A number whose exponent is near one of a few levels.
fn number(random: &mut impl Rng, levels: &[i32]) -> f64 {
    let exponent = levels[random.random_range(0..levels.len())] + random.random_range(-2..3);
    let mantissa = match random.random_range(0..4) {
        0 => 1.0,
        1 => 1.0 + f64::EPSILON * f64::from(random.random_range(0..8)),
        2 => 1.0 + f64::from(random.random_range(0..4)) / 4.0,
        _ => random.random_range(1.0..2.0),
    };
    let half = exponent / 2;
    let value: f64 = mantissa * 2f64.powi(half) * 2f64.powi(exponent - half);
    value.min(f64::MAX).copysign(if random.random() { 1.0 } else { -1.0 })
}

impl<const D: usize> Question<D> {
    /// A question whose point is, up to rounding, a combination of the generators with coefficients −1, 0, 1/2 and 1,
    /// or the neighbour of one.
    fn drawn<R: Rng>(random: &mut R) -> Self {
        let levels: Vec<i32> = (0..random.random_range(1..5)).map(|_| random.random_range(-1075..1025)).collect();
        let zeros = if random.random_range(0..3) == 0 { 0.5 } else { 0.15 };
        let vector = |zeros: f64, random: &mut R| {
            [(); D].map(|()| if random.random_bool(zeros) { 0.0 } else { number(random, &levels) })
        };
        let generators: Vec<_> = (0..random.random_range(1..6)).map(|_| vector(zeros, random)).collect();
        let center = match random.random_range(0..4) {
            0 => [0.0; D],
            1 => generators[random.random_range(0..generators.len())],
            _ => vector(0.5, random),
        };
        let mut point = if random.random_range(0..3) == 0 { [0.0; D] } else { center };
        for v in &generators {
            let coefficient = [0.0, 1.0, -1.0, 1.0, -1.0, 0.5][random.random_range(0..6)];
            for (c, own) in point.iter_mut().zip(v) {
                *c = (*c + coefficient * own).clamp(f64::MIN, f64::MAX);
            }
        }
        let place = random.random_range(0..4 * D);
        if let Some(c) = point.get_mut(place) {
            *c = if random.random() { c.next_up() } else { c.next_down() }.clamp(f64::MIN, f64::MAX);
        }
        Self { center, point, generators }
    }

    /// The status that the exact face lattice tells, which all others have to tell.
    fn agreed(&self) -> Status {
        let told = format!("{:?} in {:?} + {:?}", self.point, self.center, self.generators);
        let query = Query::new(self.center, self.point, &self.generators).expect("finite");
        let status = by_explicit_faces::locate(&query, &mut ()).expect("a few generators").status();
        assert_eq!(by_lad::locate(&query, &mut ()).status(), status, "{told}");
        let gauge = by_lad::gauge(&query, &mut ());
        assert_eq!(gauge.location.status(), status, "gauge of {told}");
        let is_above = gauge.value - gauge.error > 1.0;
        let is_below = gauge.value + gauge.error < 1.0;
        assert!(!is_above || status == Status::Outside, "{} ± {}: {told}", gauge.value, gauge.error);
        assert!(!is_below || status != Status::Outside, "{} ± {}: {told}", gauge.value, gauge.error);
        status
    }
}

impl Question<3> {
    /// The same question in coordinates in another order, the body under the quarter turns that bring them there, and
    /// of the body prepared for few and many points.
    fn agrees_under_turns_and_prepared(&self, status: Status) -> Result<(), ZonotopeError> {
        let told = format!("{:?} in {:?} + {:?}", self.point, self.center, self.generators);
        let body = Zonotope::new(self.center, self.generators.clone())?;
        let turn = Pose::new([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], [0.0; 3]).expect("a rotation");
        let [x, y, z] = self.point;
        let posed = body.at(&turn).locate([z, x, y]).expect("finite");
        assert_eq!(posed.status(), status, "under a pose: {told}");
        for expected in [1, 100, 1_000_000] {
            let prepared = body.prepared_for(expected);
            let located = prepared.locate(self.point).expect("finite").status();
            assert_eq!(located, status, "prepared for {expected}: {told}");
            let is_member = prepared.contains(self.point).expect("finite");
            assert_eq!(is_member, status != Status::Outside, "prepared for {expected}: {told}");
        }
        Ok(())
    }
}

#[test]
fn a_normal_whose_square_underflows_tells_its_side() -> Result<(), ZonotopeError> {
    let height = 3.384606560206073e125;
    let short = [1.8048201988518992e-183, 3.5322329704938686e-183, 4.633461153705632e-183];
    let generators =
        vec![[-1.0, -3.237541462289103e-183, 0.0], [8.206760175485206e-184, -1.0, 0.0], short, [0.0, 0.0, height]];
    let question = Question { center: [0.0, 0.0, height], point: short, generators };
    let status = question.agreed();
    assert_eq!(status, Status::Inside);
    question.agrees_under_turns_and_prepared(status)
}

#[test]
fn answers_are_those_of_the_face_lattice_whatever_the_exponents() -> Result<(), ZonotopeError> {
    let questions = QUESTIONS[usize::from(option_env!("ZONOTOPE_CASES") != Some("long"))];
    let seed = env::var("PROPTEST_RNG_SEED").map_or(1, |seed| seed.parse().expect("a whole number"));
    let random = &mut Pcg64Mcg::seed_from_u64(seed);
    let mut found = [0; 3];
    for round in 0..questions {
        let status = match round % 8 {
            0 => Question::<2>::drawn(random).agreed(),
            1 => Question::<1>::drawn(random).agreed(),
            _ => {
                let question = Question::<3>::drawn(random);
                let status = question.agreed();
                question.agrees_under_turns_and_prepared(status)?;
                status
            }
        };
        found[status as usize] += 1;
    }
    assert!(found.iter().all(|&count| count > questions / 20), "{found:?}");
    Ok(())
}
