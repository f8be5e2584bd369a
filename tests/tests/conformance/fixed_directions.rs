//! Section 4.2 against the rational twin: all methods, by both engines, on every family in one to four dimensions.
//!
//! Eleven families of 24 cases in four dimensions are 1,056 cases of a long run, each decided and measured by five
//! methods.

use dashu_ratio::RBig;
use families::drawn::directions::Instance;
use proptest::prelude::*;
use rivals::simplex::Microlp;
use tests::kernel_twin::exactly;
use zonotope::enclosing::fixed_directions::{
    Enclosure, FixedDirections, FixedDirectionsError, brute_force, min_length_along, papers_program, rational,
    support_form,
};
use zonotope::interop::verifier::check_min_length_dirs_at_any_gap;
use zonotope::linear_program::{Clarabel, Engine};

const CASES: u32 = 24;

/// Up to this dimension the optimum in rationals is itself held to the twin that knows all normals; in R^4, where these
/// are cubic in the directions and a case of the twin may take minutes, `in_each_dimension` crosses the two on small
/// instances.
const ENUMERATED_DIMENSIONS: usize = 3;

type Answer<const D: usize> = Result<Enclosure<D>, FixedDirectionsError>;

/// Every method and engine by name.
fn answers<const D: usize>(problem: &FixedDirections<'_, D>) -> Vec<(String, Answer<D>)> {
    let mut answers = vec![("row generation".to_owned(), min_length_along(problem, &mut ()))];
    for engine in [&Clarabel as &dyn Engine, &Microlp] {
        answers.push((
            format!("support form, {}", engine.name()),
            support_form::min_length_by_support_form(problem, engine, &mut ()),
        ));
        answers.push((
            format!("paper's program, {}", engine.name()),
            papers_program::min_length_by_papers_program(problem, engine, &mut ()),
        ));
    }
    answers
}

/// The distance to which a value and a bound must come to the truth.
#[derive(Clone, Copy, PartialEq)]
enum Nearness {
    /// Both to a relative 1e-12.
    Relative,
    /// The bound to a relative 1e-12, the value to that and what a centre in doubles may cost.
    CenterInDoubles,
    /// On their side of the truth, wherever they are.
    AnyGap,
}

fn tight<const D: usize>(instance: Instance<D>) -> Result<(), TestCaseError> {
    agrees(&instance, Nearness::Relative)
}

fn tight_but_for_the_center<const D: usize>(instance: Instance<D>) -> Result<(), TestCaseError> {
    agrees(&instance, Nearness::CenterInDoubles)
}

fn proven<const D: usize>(instance: Instance<D>) -> Result<(), TestCaseError> {
    agrees(&instance, Nearness::AnyGap)
}

fn agrees<const D: usize>(instance: &Instance<D>, nearness: Nearness) -> Result<(), TestCaseError> {
    let Instance { points, directions, weights } = instance;
    let problem =
        FixedDirections::new(points, directions, weights).map_err(|error| TestCaseError::fail(error.to_string()))?;
    let optimum = rational::min_length_in_rationals(&problem);
    let truth = optimum.as_ref().map(|optimum| optimum.value.clone());
    // a direction one step from zero takes more than doubles hold
    let largest = exactly(f64::MAX);
    let is_beyond = optimum.is_some_and(|optimum| optimum.coefficients.iter().any(|c| *c > largest));
    if D <= ENUMERATED_DIMENSIONS {
        let twin = brute_force::least_length(&problem).map(|optimum| optimum.value);
        prop_assert_eq!(&twin, &truth, "the rational program and the twin on all normals");
    }
    for (name, answer) in answers(&problem) {
        let answer = match answer {
            Ok(answer) => answer,
            Err(error) => {
                prop_assert_eq!(error, FixedDirectionsError::OutOfRange);
                prop_assert!(nearness == Nearness::AnyGap || is_beyond, "{}: {}", name, error);
                continue;
            }
        };
        let verdict = check_min_length_dirs_at_any_gap(&problem, &answer);
        prop_assert!(verdict.is_right(), "{}: {:?} {:?}", name, verdict, answer);
        prop_assert_eq!(answer.optimal().is_some(), truth.is_some(), "{}", name);
        let (Some(zonotope), Some(truth)) = (answer.optimal(), &truth) else { continue };
        let (value, bound) = (exactly(zonotope.value), exactly(zonotope.lower_bound));
        prop_assert!(bound <= *truth && *truth <= value, "{}: {:?}", name, zonotope);
        let relative = truth * exactly(1e-12);
        let allowed = match nearness {
            Nearness::AnyGap => continue,
            Nearness::Relative => relative.clone(),
            Nearness::CenterInDoubles => match cost_of_rounding(instance) {
                Some(cost) => &relative + cost,
                None => continue,
            },
        };
        prop_assert!(truth - bound <= relative, "{}: the bound of {:e}, {:?}", name, truth.to_f64_fast(), zonotope);
        prop_assert!(value - truth <= allowed, "{}: the value of {:e}, {:?}", name, truth.to_f64_fast(), zonotope);
    }
    Ok(())
}

/// The cost of a zonotope along the directions that makes up for a centre rounded to doubles in every coordinate, three
/// times over; `None` where the directions do not span.
fn cost_of_rounding<const D: usize>(instance: &Instance<D>) -> Option<RBig> {
    let largest = instance.points.iter().flatten().fold(0.0, |max: f64, c| max.max(c.abs()));
    let unit = 3.0 * f64::EPSILON * largest;
    let corners: Vec<[f64; D]> = (0..1usize << D)
        .map(|corner| std::array::from_fn(|c| if corner >> c & 1 == 0 { unit } else { -unit }))
        .collect();
    let box_problem =
        FixedDirections::new(&corners, &instance.directions, &instance.weights).expect("finite, as the instance is");
    rational::min_length_in_rationals(&box_problem).map(|optimum| optimum.value)
}

tests::test_on_direction_families! {
    CASES;
    generic: tight;
    lattices: tight;
    parallel: tight;
    flat: tight;
    too_few: tight;
    one_point: tight;
    duplicates: tight;
    scaled: tight;
    zero_weights: tight;
    one_ulp: tight_but_for_the_center;
    mixed_scales: proven;
}
