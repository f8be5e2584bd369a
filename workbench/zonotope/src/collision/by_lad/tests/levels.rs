//! Answers are the same, to the last bit, whatever vector instructions the machine has.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::{FAMILIES, displacement, family};
use crate::collision::{Query, by_lad};
use crate::numeric::lanes::level::{at_each_level, levels};
use crate::zonotope::Zonotope;
use crate::zonotope::pose::Pose;

/// Asserts that all results are the same, to the last bit: a double is printed with as many digits as tell it from all
/// others, and the sign of a zero.
fn assert_same<T: std::fmt::Debug>(what: &str, compute: impl FnMut() -> T) {
    let results: Vec<String> = at_each_level(compute).iter().map(|result| format!("{result:?}")).collect();
    for (other, level) in results.iter().zip(levels()) {
        assert_eq!(*other, results[0], "{what}: {level:?} against {:?}", levels()[0]);
    }
}

#[test]
fn answers_are_the_same_at_every_level() {
    let mut random = Pcg64Mcg::seed_from_u64(31);
    for name in FAMILIES {
        for n in [6, 15, 17, 40, 129, 321, 1100, 5000] {
            let generators = family::<3>(name, n, &mut random);
            for round in 0..4 {
                let (from, mut to) = displacement(&generators, &mut random);
                if round == 3 {
                    // near the boundary, where the search goes to its end
                    let gauge = by_lad::gauge(&Query::new(from, to, &generators).expect("finite"), &mut ()).value;
                    let scaled = [0, 1, 2].map(|k| from[k] + (to[k] - from[k]) / gauge);
                    to = if scaled.iter().all(|c| c.is_finite()) { scaled } else { to };
                }
                let query = Query::new(from, to, &generators).expect("finite");
                assert_same(&format!("location, {name} {n}"), || by_lad::locate(&query, &mut ()));
                assert_same(&format!("gauge, {name} {n}"), || by_lad::gauge(&query, &mut ()));
            }
        }
    }
}

#[test]
fn answers_about_posed_bodies_are_the_same_at_every_level() {
    let mut random = Pcg64Mcg::seed_from_u64(32);
    for n in [3, 20, 400] {
        let mut body = || {
            let row = |random: &mut Pcg64Mcg| [0, 1, 2].map(|_| random.random_range(-1.0..1.0));
            let generators = (0..n).map(|_| row(&mut random)).collect();
            Zonotope::new([0.0; 3], generators).expect("finite")
        };
        let bodies = [body(), body()];
        let pose = Pose::new([[0.6, -0.8, 0.0], [0.8, 0.6, 0.0], [0.0, 0.0, 1.0]], [0.1, 0.2, 0.3]).expect("finite");
        for away in [0.0, 0.5, 1.0, 3.0] {
            let other = Pose::new(*pose.rows(), [away * n as f64, 0.0, 0.1]).expect("finite");
            let query = Query::of_placed(bodies[0].at(&pose), bodies[1].at(&other));
            assert_same(&format!("posed location, {n}"), || by_lad::locate(&query, &mut ()));
            assert_same(&format!("posed gauge, {n}"), || by_lad::gauge(&query, &mut ()));
        }
    }
}
