//! Location and gauge by every method against the exact truth, on all families of questions in one to four dimensions.
//!
//! Every location, the truth's included, is proved by the verifier, its status too.

use dashu_ratio::RBig;
use families::drawn::bodies::families;
use proptest::prelude::*;
use rivals::simplex::Microlp;
use tests::body_questions::{Asked, asked};
use tests::runner::for_all;
use zonotope::collision::by_linear_program::{self, Answer};
use zonotope::collision::{Gauge, Method, brute_force};
use zonotope::interop::verifier::check_location;
use zonotope::linear_program::{Clarabel, Engine};
use zonotope::numeric::dyadic::Dyadic;

/// The questions of a long run for each of the fourteen families, by dimension: 23,100 in all.
const CASES: [u32; 4] = [150, 400, 850, 250];

/// The questions of a long run for each family in space, by linear programs: 21,700 in all.
const ENGINE_CASES: u32 = 1550;

/// Every exact method that works in the dimension locates as the truth does, and measures within its own error.
fn agrees<const D: usize>(asked: &Asked<D>) -> Result<(), TestCaseError> {
    let question = asked.displacement();
    let truth = brute_force::locate(&question);
    prop_assert_eq!(check_location(&question, &truth).proof().map(drop), Ok(()), "{:?}", truth);
    let exact = brute_force::exact_gauge(&question);
    prop_assert_eq!(exact.as_ref().is_some_and(|gauge| *gauge <= RBig::ONE), truth.is_member());
    let works = |method: &&Method| method.always_locates() && method.dimensions().contains(&D);
    for method in Method::ALL.iter().filter(works) {
        let name = method.id();
        match method.locate(&question, 1, &mut ()) {
            Ok(Some(location)) => {
                prop_assert_eq!(location.status(), truth.status(), "{}: {:?}", name, location);
                prop_assert_eq!(
                    check_location(&question, &location).proof().map(drop),
                    Ok(()),
                    "{}: {:?}",
                    name,
                    location
                );
            }
            other => prop_assert!(false, "{}: {:?}", name, other),
        }
        if !method.measures() {
            continue;
        }
        let Gauge { value, error, location } = method.gauge(&question, &mut ()).expect("few directions");
        prop_assert_eq!(location.status(), truth.status(), "{}", name);
        prop_assert_eq!(check_location(&question, &location).proof().map(drop), Ok(()), "{}: {:?}", name, location);
        match &exact {
            None => prop_assert!(value == f64::INFINITY && error == 0.0, "{}: {} ± {}", name, value, error),
            Some(exact) => {
                prop_assert!(is_within(exact, value, error), "{}: {} ± {}, not {}", name, value, error, exact)
            }
        }
    }
    Ok(())
}

fn is_within(exact: &RBig, value: f64, error: f64) -> bool {
    let rational = |v: f64| Dyadic::from_f64(v).to_rational();
    if !value.is_finite() || error == f64::INFINITY {
        return value.is_finite();
    }
    let difference = exact - rational(value);
    difference <= rational(error) && -difference <= rational(error)
}

/// Every family of a dimension, with at most `most` generators.
fn conform<const D: usize>(most: usize, cases: u32) {
    for (family, generators) in families::<D>(most) {
        for_all(&asked(generators), cases, |asked| {
            agrees(&asked).map_err(|error| TestCaseError::fail(format!("{family}: {error}")))
        });
    }
}

#[test]
fn in_one_dimension() {
    conform::<1>(6, CASES[0]);
}

#[test]
fn in_the_plane() {
    conform::<2>(9, CASES[1]);
}

#[test]
fn in_space() {
    conform::<3>(8, CASES[2]);
}

#[test]
fn in_space_and_time() {
    conform::<4>(7, CASES[3]);
}

/// Beyond the sizes for which the kernel has a method of its own.
#[test]
fn in_the_plane_with_many_generators() {
    conform::<2>(40, 60);
}

#[test]
fn in_space_with_many_generators() {
    conform::<3>(24, 60);
}

/// The engines may leave a question undecided, but what they say is right.
#[test]
fn linear_programs_are_never_wrong() {
    for (_, generators) in families::<3>(8) {
        for_all(&asked(generators), ENGINE_CASES, |asked| {
            let question = asked.displacement();
            let truth = brute_force::locate(&question);
            let engines: [&dyn Engine; 2] = [&Clarabel, &Microlp];
            for engine in engines {
                let answer = by_linear_program::locate(&question, engine);
                match &answer {
                    Answer::Located(location) => {
                        prop_assert_eq!(location.status(), truth.status(), "{}: {:?}", engine.name(), location);
                        prop_assert_eq!(check_location(&question, location).proof().map(drop), Ok(()));
                    }
                    Answer::Member(_) => prop_assert!(truth.is_member(), "{}", engine.name()),
                    Answer::Undecided(_) => {}
                }
            }
            Ok(())
        });
    }
}

/// The same question in other words; of two that are paired, the second says what the first says.
fn restated<const D: usize>(asked: &Asked<D>, exponent: i32) -> Vec<(&'static str, [Asked<D>; 2])> {
    let Asked { from, to, generators } = asked.clone();
    let with = |generators: Vec<[f64; D]>| Asked { generators, ..asked.clone() };
    let times = |factor: f64| move |vector: [f64; D]| vector.map(|v| v * factor);
    let scale = times(libm::ldexp(1.0, exponent));
    let scaled =
        Asked { from: scale(from), to: scale(to), generators: generators.iter().copied().map(scale).collect() };
    let permuted = {
        let (first, second) = generators.split_at(generators.len() / 2);
        with(second.iter().chain(first.iter().rev()).copied().collect())
    };
    let negated = Asked { from: to, to: from, generators: generators.clone() };
    let turned = with(generators.iter().copied().enumerate().map(|(i, g)| times([1.0, -1.0][i % 2])(g)).collect());
    let split = with(generators.iter().flat_map(|&g| [times(0.5)(g), times(0.25)(g), times(-0.25)(g)]).collect());
    let twice = with(generators.iter().flat_map(|&g| [g, times(-1.0)(g)]).collect());
    let merged = with(generators.iter().copied().map(times(2.0)).collect());
    let mut pairs = vec![
        ("permuted", [asked.clone(), permuted]),
        ("negated", [asked.clone(), negated]),
        ("turned", [asked.clone(), turned]),
        ("merged", [twice, merged]),
    ];
    let vectors = || generators.iter().chain([&from, &to]);
    let is_exact = |factor: f64| vectors().flatten().all(|v| v * factor / factor == *v);
    if is_exact(libm::ldexp(1.0, exponent)) {
        pairs.push(("scaled", [asked.clone(), scaled]));
    }
    if is_exact(0.25) {
        pairs.push(("split", [asked.clone(), split]));
    }
    let shift = |point: [f64; D]| {
        let moved = point.map(|v| v + 0.5);
        let is_exact = |(m, v): (&f64, &f64)| Dyadic::from_f64(*m) == Dyadic::from_f64(*v) + Dyadic::from_f64(0.5);
        moved.iter().zip(&point).all(is_exact).then_some(moved)
    };
    if let (Some(from), Some(to)) = (shift(from), shift(to)) {
        pairs.push(("translated", [asked.clone(), Asked { from, to, generators }]));
    }
    pairs
}

/// The methods whose answers must not depend on the wording: the truth is brute force's by its definition.
const FAST: [Method; 3] = [Method::ByLad, Method::BySlopeSelection, Method::ByExplicitFaces];

fn keeps_its_answers<const D: usize>(asked: &Asked<D>, exponent: i32) -> Result<(), TestCaseError> {
    for (name, [one, other]) in restated(asked, exponent) {
        for method in FAST.into_iter().filter(|method| method.dimensions().contains(&D)) {
            let [first, second] = [&one, &other].map(|asked| match method.locate(&asked.displacement(), 1, &mut ()) {
                Ok(Some(location)) => location.status().name(),
                other => panic!("{other:?} by {}", method.id()),
            });
            prop_assert_eq!(first, second, "{} by {}", name, method.id());
        }
    }
    Ok(())
}

fn stay<const D: usize>() {
    const WITHOUT_ROUNDING: [&str; 6] = ["random", "lattice", "parallel", "coplanar", "boxes", "nearly_parallel"];
    for (family, generators) in families::<D>(12).into_iter().filter(|(name, _)| WITHOUT_ROUNDING.contains(name)) {
        for_all(&(asked(generators), -300..=300i32), 200, |(asked, exponent)| {
            let result = keeps_its_answers(&asked, exponent);
            result.map_err(|error| TestCaseError::fail(format!("{family}: {error}")))
        });
    }
}

#[test]
fn answers_do_not_depend_on_the_wording() {
    stay::<2>();
    stay::<3>();
    stay::<4>();
}
