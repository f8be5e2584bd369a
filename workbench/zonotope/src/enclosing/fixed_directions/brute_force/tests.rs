//! The criss-cross method on examples worked out by hand, and against the program as the paper prints it.

use super::criss_cross::{Constraint, Dictionary};
use super::*;
use proptest::prelude::*;

fn solve<const D: usize>(points: &[[f64; D]], directions: &[[f64; D]]) -> Option<ExactOptimum<D>> {
    least_length(&FixedDirections::new(points, directions, &vec![1.0; directions.len()]).expect("valid"))
}

/// Section 4.2 as printed: minimise Σ w_i c_i with p_j = p + Σ b_ij v_i and |b_ij| ≤ c_i. No normal occurs in it. The
/// unknowns c_i − b_ij and c_i + b_ij are slacks, and the equations are pairs of opposite inequalities; `None` when
/// nothing is feasible.
fn paper<const D: usize>(points: &[[f64; D]], directions: &[[f64; D]], weights: &[f64]) -> Option<Rational> {
    let (n, k) = (points.len(), directions.len());
    // The free unknowns p and b come first: each is expressed by a slack and then stays expressed.
    let free = D + n * k;
    let mut constraints = Vec::new();
    let mut add = |normal: Vec<Rational>, widths: Vec<Rational>, height: Rational| {
        constraints.push(Constraint { normal, widths, height });
    };
    for j in 0..n {
        for i in 0..k {
            for sign in [Rational::ONE, -Rational::ONE] {
                let mut normal = vec![Rational::ZERO; free];
                normal[D + j * k + i] = sign;
                let widths = (0..k).map(|other| Rational::from(u8::from(other == i))).collect();
                add(normal, widths, Rational::ZERO);
            }
        }
        for c in 0..D {
            for sign in [Rational::ONE, -Rational::ONE] {
                let mut normal = vec![Rational::ZERO; free];
                normal[c] = sign.clone();
                for (i, v) in directions.iter().enumerate() {
                    normal[D + j * k + i] = &sign * rational(v[c]);
                }
                add(normal, vec![Rational::ZERO; k], &sign * rational(points[j][c]));
            }
        }
    }
    Dictionary::new(&constraints, weights.iter().map(|&w| rational(w)).collect(), free)
        .try_solve()
        .map(|solution| solution.value)
}

#[test]
fn the_unit_square_along_one_axis_too_few_is_infeasible() {
    assert!(solve(&[[0.0, 0.0], [1.0, 1.0]], &[[1.0, 0.0]]).is_none());
    assert!(solve::<2>(&[[0.0, 0.0], [1.0, 1.0]], &[]).is_none());
    assert_eq!(solve::<2>(&[[3.0, 4.0]; 2], &[]).expect("one point").center, [3, 4].map(Rational::from));
}

/// The case of the errata: two extreme points along the only normal of R^3 would give a half.
#[test]
fn directions_of_a_plane_are_taken_in_the_plane() {
    let square = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let optimum = solve(&square, &axes).expect("the square lies in the plane");
    assert_eq!(optimum.value, Rational::ONE);
    assert_eq!(optimum.center, [Rational::ONE / Rational::from(2), Rational::ONE / Rational::from(2), Rational::ZERO]);
    assert!(solve(&[square[0], [0.0, 0.0, 1e-300]], &axes).is_none());
}

#[test]
fn a_simplex_of_four_dimensions_in_its_box() {
    let mut points = vec![[0.0; 4]];
    let axes: Vec<[f64; 4]> = (0..4).map(|i| std::array::from_fn(|c| f64::from(u8::from(i == c)))).collect();
    points.extend(&axes);
    assert_eq!(solve(&points, &axes).expect("a box").value, Rational::from(2));
    let mut diagonals = axes.clone();
    diagonals.push([1.0; 4]);
    assert_eq!(solve(&points, &diagonals).expect("spanning").value, Rational::from(2));
}

fn lattice<const D: usize>(count: std::ops::Range<usize>) -> impl Strategy<Value = Vec<[f64; D]>> {
    proptest::collection::vec(proptest::array::uniform((-2i8..3).prop_map(f64::from)), count)
}

fn agrees<const D: usize>(points: &[[f64; D]], directions: &[[f64; D]], weights: &[f64]) -> Result<(), TestCaseError> {
    let weights = &weights[..directions.len()];
    let problem = FixedDirections::new(points, directions, weights).expect("valid");
    let truth = least_length(&problem);
    prop_assert_eq!(truth.as_ref().map(|t| t.value.clone()), paper(points, directions, weights));
    let Some(truth) = truth else { return Ok(()) };
    let spent = weights.iter().zip(&truth.coefficients).map(|(&w, c)| rational(w) * c);
    prop_assert_eq!(spent.fold(Rational::ZERO, |sum, x| sum + x), truth.value.clone());
    prop_assert!(truth.coefficients.iter().all(|c| *c >= Rational::ZERO));
    for (v, &w) in directions.iter().zip(weights) {
        let v = v.map(rational);
        let along = truth.multipliers.iter().map(|(_, multiplier)| sum_of_products(multiplier, &v).abs());
        prop_assert!(along.fold(Rational::ZERO, |sum, x| sum + x) <= rational(w));
    }
    for c in 0..D {
        let sum = truth.multipliers.iter().fold(Rational::ZERO, |sum, (_, multiplier)| sum + &multiplier[c]);
        prop_assert!(sum.is_zero());
    }
    let reached = truth.multipliers.iter().map(|(j, multiplier)| {
        let point = points[*j].map(rational);
        sum_of_products(multiplier, &point)
    });
    prop_assert_eq!(reached.fold(Rational::ZERO, |sum, x| sum + x), truth.value);
    Ok(())
}

properties! {
    #![proptest_config(crate::property_cases::config(60))]

    #[test]
    fn the_plane_agrees_with_the_papers_program(
        points in lattice::<2>(1..4), directions in lattice::<2>(0..4), weights in [0u8..3, 0..3, 0..3],
    ) {
        agrees(&points, &directions, &weights.map(f64::from))?;
    }

    #[test]
    fn space_agrees_with_the_papers_program(points in lattice::<3>(1..4), directions in lattice::<3>(1..5)) {
        agrees(&points, &directions, &[1.0, 2.0, 1.0, 3.0])?;
    }

    #[test]
    fn the_line_agrees_with_the_papers_program(points in lattice::<1>(1..5), directions in lattice::<1>(0..4)) {
        agrees(&points, &directions, &[1.0, 2.0, 1.0])?;
    }
}
