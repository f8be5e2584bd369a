//! Every rule of order reduction on all families of bodies in one to four dimensions: what it answers contains the body
//! and its proof holds, in rationals; and the bounds of the distance hold the exact one.

use dashu_ratio::RBig;
use families::drawn::bodies::{Generators, families};
use proptest::prelude::*;
use tests::runner::for_all;
use zonotope::Zonotope;
use zonotope::reduction::hausdorff::{brute_force as truth, excess};
use zonotope::reduction::{Containment, Method, Problem, ReductionError, brute_force};

/// The bodies of a long run for each of the fourteen families, by dimension: 1,540 in all.
const CASES: [u32; 4] = [20, 32, 40, 18];

/// The exact distance takes the signs of all generators of both bodies.
const DISTANCE_GENERATORS: usize = 7;

fn encloses<const D: usize>(generators: Generators<D>) -> Result<(), TestCaseError> {
    let body = Zonotope::new(std::array::from_fn(|k| k as f64), generators).expect("the families are finite");
    let most = body.generators().len();
    for count in [D, D + 1, most.saturating_sub(1)].into_iter().filter(|count| *count >= D) {
        let problem = Problem::new(&body, count).expect("the count is at least the dimension");
        for method in Method::ALL {
            let reduced = match method.reduce(&problem) {
                Ok(reduced) => reduced,
                Err(error) => {
                    prop_assert_eq!(error, ReductionError::OutOfRange);
                    prop_assert!(leaves_the_doubles(&body), "{} refuses {:?}", method.id(), body);
                    continue;
                }
            };
            let outer = &reduced.body;
            prop_assert!(outer.generators().len() <= count && outer.center() == body.center(), "{}", method.id());
            prop_assert!(brute_force::contains(outer, &body), "{}: {:?}", method.id(), outer);
            if let Containment::Shares(shares) = &reduced.proof {
                prop_assert_eq!(shares.check(&body, outer), Ok(()), "{}: {:?}", method.id(), reduced);
            }
            let is_short = method == Method::Girard && outer.generators().len() + most <= DISTANCE_GENERATORS;
            let square = if is_short { truth::squared_excess(outer, &body) } else { RBig::ZERO };
            if square > RBig::ZERO {
                let distance = excess(outer, &body, 0.05);
                let exact = |v: f64| RBig::try_from(v).expect("a distance is finite");
                prop_assert!(exact(distance.lower) * exact(distance.lower) <= square, "{:?}", distance);
                prop_assert!(square <= exact(distance.upper) * exact(distance.upper), "{:?}", distance);
            }
        }
    }
    Ok(())
}

/// Whether a side of the bounding box is near the end of the doubles, where few generators may not be able to enclose.
fn leaves_the_doubles<const D: usize>(body: &Zonotope<D>) -> bool {
    let side = |k: usize| body.generators().iter().map(|g| g[k].abs() / 64.0).sum::<f64>();
    (0..D).any(|k| side(k) > f64::MAX / 1024.0)
}

fn on_all_families<const D: usize>(most: usize) {
    for (name, generators) in families::<D>(most) {
        println!("{name} in R^{D}");
        for_all(&generators, CASES[D - 1], encloses::<D>);
    }
}

#[test]
fn reductions_enclose_on_a_line() {
    on_all_families::<1>(6);
}

#[test]
fn reductions_enclose_in_the_plane() {
    on_all_families::<2>(8);
}

#[test]
fn reductions_enclose_in_space() {
    on_all_families::<3>(8);
}

#[test]
fn reductions_enclose_in_r4() {
    on_all_families::<4>(7);
}
