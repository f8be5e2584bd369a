//! Enclosing zonotopes at the very ends of what their checks allow, mostly segments of a line.

use super::min_length_all::{
    MinLengthAnswer, check_min_length_all, check_min_length_all_at_any_ratio, check_min_length_all_bounds,
};
use super::min_length_dirs::{
    Directed, DirectedAnswer, DirectedProof, check_min_length_dirs, check_min_length_dirs_feasible,
};
use crate::exact::fraction::Fraction;
use crate::faces::normals::MOST_COORDINATES;
use crate::verdict::Verdict;

/// The smallest positive double.
const TINY: f64 = f64::from_bits(1);

/// A vector of whole numbers of halves.
fn halves<const D: usize>(vector: [i64; D]) -> Vec<Fraction> {
    vector.into_iter().filter_map(|x| Fraction::new(x, 2)).collect()
}

/// The points −half and half of the line, along the direction 1 of the cost 1: nothing around them costs less than
/// `half`.
fn segment(half: f64) -> Directed {
    Directed { points: vec![vec![-half], vec![half]], directions: vec![vec![1.0]], weights: vec![1.0] }
}

/// The segment from −value to value, with half a unit of force outward at either point, which proves just `half`.
fn around(value: f64, lower_bound: f64) -> DirectedAnswer {
    DirectedAnswer::Optimal {
        value,
        center: vec![0.0],
        coefficients: vec![value],
        lower_bound,
        forces: vec![(0, halves([-1])), (1, halves([1]))],
    }
}

/// The points (0, 0) and (2, height) along both axes, in the box with these two corners. Forces of a half along the
/// first axis prove its half width 1.
fn flat_box(height: f64, weights: &[f64]) -> (Directed, DirectedAnswer) {
    let question = Directed {
        points: vec![vec![0.0, 0.0], vec![2.0, height]],
        directions: vec![vec![1.0, 0.0], vec![0.0, 1.0]],
        weights: weights.to_vec(),
    };
    let answer = DirectedAnswer::Optimal {
        value: 1.0,
        center: vec![1.0, height / 2.0],
        coefficients: vec![1.0, height / 2.0],
        lower_bound: 1.0,
        forces: vec![(0, halves([-1, 0])), (1, halves([1, 0]))],
    };
    (question, answer)
}

#[test]
fn a_cost_just_1e_11_above_its_bound_may_be_called_the_least_or_not() {
    let question = segment(1e11);
    let just = around(1e11 + 1.0, 1e11);
    assert!(check_min_length_dirs(&question, &just).is_right());
    assert!(check_min_length_dirs_feasible(&question, &just).is_right());
    let least = check_min_length_dirs_feasible(&question, &around(1e11, 1e11)).proof();
    assert!(least.is_err_and(|complaint| complaint.contains("not called so")));
}

#[test]
fn a_cost_that_is_not_called_the_least_is_as_far_above_its_bound_as_rounding_explains() {
    let question = segment(1e11);
    assert!(check_min_length_dirs_feasible(&question, &around(1e11 + 50.0, 1e11)).is_right());
    let far = check_min_length_dirs_feasible(&question, &around(2e11, 1e11));
    assert!(matches!(&far, Verdict::Unchecked(reason) if reason.contains("than rounding the centre")), "{far:?}");
}

#[test]
fn a_gap_of_1e_11_is_the_largest_that_proves_the_least_cost() {
    let proof = check_min_length_dirs(&segment(1e11 - 1.0), &around(1e11, 1e11 - 1.0));
    assert_eq!(proof, Verdict::Right(DirectedProof::Optimal { points: 2, value: 1e11, gap: 1e-11 }));
    let above = check_min_length_dirs(&segment(1e11), &around(1e11 + 1000.0, 1e11));
    assert!(matches!(&above, Verdict::Unchecked(reason) if reason.contains("may not be the least")), "{above:?}");
    // the bound that is claimed is 50 below the proven one
    let modest = check_min_length_dirs(&segment(1e11), &around(1e11, 1e11 - 50.0));
    assert!(matches!(&modest, Verdict::Wrong(reason) if reason.contains("not within 1e-11")), "{modest:?}");
}

#[test]
fn rounding_costs_two_of_the_smallest_doubles_where_the_bound_is_not_zero() {
    let verdict = |value: f64, lower_bound: f64| check_min_length_dirs(&segment(value), &around(value, lower_bound));
    assert!(verdict(3.0 * TINY, TINY).is_right() && verdict(4.0 * TINY, TINY).is_wrong());
    assert!(verdict(TINY, 0.0).is_wrong(), "a bound of zero says nothing");
    assert!(verdict(0.0, 0.0).is_right());
}

#[test]
fn a_direction_may_cost_nothing_but_not_less() {
    let (question, answer) = flat_box(1.0, &[1.0, 0.0]);
    assert!(check_min_length_dirs(&question, &answer).is_right());
    for weights in [&[1.0][..], &[1.0, 0.0, 1.0], &[1.0, -1.0]] {
        let (question, answer) = flat_box(1.0, weights);
        let complaint = check_min_length_dirs(&question, &answer).proof().expect_err("those are no weights");
        assert!(complaint.contains("weights are not one number"), "{complaint}");
    }
}

#[test]
fn a_direction_may_be_left_out() {
    let (question, answer) = flat_box(0.0, &[1.0, 1.0]);
    assert!(check_min_length_dirs(&question, &answer).is_right());
}

/// The segment from 0 to 2 consists of whole numbers, the third point is half-way between two of them.
#[test]
fn points_on_a_finer_grid_than_the_segment_are_held_against_it() {
    let verdict = |third: f64| {
        let question = Directed {
            points: vec![vec![0.0], vec![2.0], vec![third]],
            directions: vec![vec![1.0]],
            weights: vec![1.0],
        };
        let DirectedAnswer::Optimal { value, coefficients, lower_bound, forces, .. } = around(1.0, 1.0) else {
            unreachable!("it is a segment")
        };
        let answer = DirectedAnswer::Optimal { value, center: vec![1.0], coefficients, lower_bound, forces };
        check_min_length_dirs(&question, &answer).proof()
    };
    assert!(verdict(0.5).is_ok() && verdict(1.5).is_ok());
    assert!(verdict(2.5).is_err_and(|complaint| complaint.contains("point 3 lies outside")));
}

/// The points −1 and 1 of the line.
fn unit_points() -> [Vec<f64>; 2] {
    [vec![-1.0], vec![1.0]]
}

/// The segment from −length to length, with forces that prove the bound 1 for [`unit_points`].
fn of_length(length: f64) -> MinLengthAnswer {
    MinLengthAnswer {
        length,
        center: vec![0.0],
        generators: vec![vec![length]],
        lower_bound: 1.0,
        ratio: length,
        within_epsilon: None,
        forces: vec![(0, vec![-1.0]), (1, vec![1.0])],
    }
}

#[test]
fn a_ratio_of_just_one_and_epsilon_may_be_called_within_it_or_not() {
    let verdict = |length: f64, within_epsilon: Option<bool>| {
        check_min_length_all(&unit_points(), 0.5, &MinLengthAnswer { within_epsilon, ..of_length(length) })
    };
    for claim in [None, Some(true), Some(false)] {
        assert!(verdict(1.5, claim).is_right(), "{claim:?}");
    }
    let short = verdict(1.5 - 1e-9, Some(false)).proof();
    assert!(short.is_err_and(|complaint| complaint.contains("within_epsilon is false")));
}

#[test]
fn the_least_length_exceeds_the_bound_by_nothing() {
    let proof = check_min_length_all(&unit_points(), 0.5, &of_length(1.0)).proof().expect("the segment itself");
    assert_eq!((proof.excess, proof.proven_bound), (0.0, 1.0));
    assert!(proof.to_string().ends_with("at most 1 times the least"), "{proof}");
    let proof = check_min_length_all_bounds(&unit_points(), 0.5, &of_length(0.5)).proof();
    assert_eq!(proof.map(|proof| proof.excess), Ok(0.0), "a segment that is too short to hold the points");
}

#[test]
fn a_ratio_without_end_is_that_of_a_length_without_end() {
    let finite = MinLengthAnswer { ratio: f64::INFINITY, ..of_length(1.0) };
    let complaint = check_min_length_all(&unit_points(), 0.5, &finite).proof().expect_err("the ratio is 1");
    assert!(complaint.contains("ratio is inf"), "{complaint}");
    // half of a diagonal is √2 times as long as the largest double
    let corner = vec![f64::MAX; 2];
    let points = [corner.clone(), vec![-f64::MAX; 2]];
    let verdict = |ratio: f64| {
        let diagonal = MinLengthAnswer {
            length: f64::INFINITY,
            center: vec![0.0; 2],
            generators: vec![corner.clone()],
            lower_bound: f64::MAX,
            ratio,
            within_epsilon: None,
            forces: vec![(0, vec![1.0; 2]), (1, vec![-1.0; 2])],
        };
        check_min_length_all(&points, 0.5, &diagonal)
    };
    assert!(verdict(f64::INFINITY).is_right() && verdict(2.0_f64.sqrt()).is_right());
    assert!(verdict(1.0).is_wrong());
}

#[test]
fn no_force_pulls_at_the_point_after_the_last() {
    let elsewhere = MinLengthAnswer { forces: vec![(2, vec![-1.0]), (1, vec![1.0])], ..of_length(1.0) };
    let complaint = check_min_length_all(&unit_points(), 0.5, &elsewhere).proof().expect_err("there are two points");
    assert!(complaint.contains("point 2, which does not exist"), "{complaint}");
}

/// Forces are searched for their farthest vertex in few dimensions only, and need no search where they prove nothing.
#[test]
fn forces_that_gain_nothing_prove_zero_in_any_dimension() {
    let dimension = MOST_COORDINATES + 1;
    let point = vec![3.0; dimension];
    let forces = vec![(0, vec![1.0; dimension]), (1, vec![-1.0; dimension])];
    let nothing = MinLengthAnswer {
        length: 0.0,
        center: point.clone(),
        generators: vec![],
        lower_bound: 0.0,
        ratio: 1.0,
        within_epsilon: Some(true),
        forces,
    };
    let verdict = check_min_length_all_at_any_ratio(&[point.clone(), point], 0.5, &nothing);
    assert!(verdict.is_right(), "{verdict:?}");
}
