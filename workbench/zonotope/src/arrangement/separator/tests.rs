//! Every separator of every family against the truth, and against what it separates: the tiles on its left.

use families::drawn::numbers::integer;
use proptest::prelude::*;

use super::*;
use crate::arrangement::DualArrangement;
use crate::arrangement::slope_selection::brute_force::vertices;

fn cross(a: &[Rational; 2], b: &[Rational; 2]) -> Rational {
    &a[0] * &b[1] - &a[1] * &b[0]
}

/// Twice the area between a chain and the line from its first point to its last, positive left of that line.
fn double_area(separator: &Separator) -> Rational {
    let points = separator.rational_points();
    let closed = points.iter().zip(points.iter().skip(1).chain(&points[..1]));
    closed.fold(Rational::ZERO, |sum, (a, b)| sum + cross(a, b))
}

fn tile_area([first, second]: [[f64; 3]; 2]) -> Rational {
    let [a, b] = [first, second].map(|g| [g[0], g[1]].map(|c| Dyadic::from_f64(c).to_rational()));
    let area = Rational::from(4) * cross(&a, &b);
    if area < Rational::ZERO { -area } else { area }
}

fn check(generators: &[[f64; 3]]) -> Result<(), TestCaseError> {
    let dual = DualArrangement::new(generators).expect("the family is finite");
    let tiles = dual.lines().vertex_count();
    let left_side = brute_force::separator(&dual, 0).expect("a tiling has a left side");
    let area = double_area(&left_side);
    let ordered = vertices(dual.lines());
    let mut sum_left = Rational::ZERO;
    for k in 0..=tiles {
        let truth = brute_force::separator(&dual, k);
        prop_assert_eq!(&by_slope_selection::separator(&dual, k, k, &mut ()), &truth, "k = {}", k);
        if k > 0 {
            let pair = ordered[k as usize - 1].lines.map(|line| generators[line.position()]);
            sum_left += tile_area(pair);
        }
        let Ok(separator) = truth else { continue };
        prop_assert!(separator.exact_points.windows(2).all(|edge| edge[0][1] >= edge[1][1]), "not monotone");
        prop_assert_eq!(separator.exact_points.len(), separator.generators.len() + 1);
        // tiles of one abscissa may come in another order than in the list, so their areas are compared once they are
        // all left
        let x = |k: usize| ordered.get(k).map(|vertex| vertex.exact_x());
        if k == 0 || x(k as usize) != x(k as usize - 1) {
            let moved = &area - double_area(&separator);
            prop_assert_eq!(moved, Rational::from(2) * &sum_left, "k = {}", k);
        }
    }
    let right_side = by_slope_selection::separator(&dual, tiles, 0, &mut ()).expect("a tiling has a right side");
    prop_assert_eq!(area - double_area(&right_side), Rational::from(2) * sum_left);
    let beyond = SeparatorError::Rank { k: tiles + 1, tiles };
    prop_assert_eq!(by_slope_selection::separator(&dual, tiles + 1, 0, &mut ()), Err(beyond.clone()));
    prop_assert_eq!(brute_force::separator(&dual, tiles + 1), Err(beyond));
    Ok(())
}

fn generators(coordinate: impl Strategy<Value = f64> + Clone) -> impl Strategy<Value = Vec<[f64; 3]>> {
    proptest::collection::vec([coordinate.clone(), coordinate.clone(), coordinate], 0..9)
}

properties! {
    #![proptest_config(crate::property_cases::config(400))]

    #[test]
    fn random_generators(generators in generators(-1.0..1.0f64)) {
        check(&generators)?;
    }

    #[test]
    fn lattice_generators(generators in generators(integer(2))) {
        check(&generators)?;
    }

    #[test]
    fn level_and_vertical_generators(
        generators in generators(-1.0..1.0f64),
        flat in proptest::collection::vec((-3..3i32, -9..9i32), 0..4),
    ) {
        let flat = flat.into_iter().map(|(x, z)| [f64::from(x), 0.0, f64::from(z)]);
        check(&generators.into_iter().chain(flat).collect::<Vec<_>>())?;
    }

    #[test]
    fn vertices_of_one_abscissa(heights in proptest::collection::vec((1..9i32, -9..9i32), 0..4)) {
        // pairs of lines y = h ± s x cross at x = 0
        let pair = |(s, h): (i32, i32)| [[f64::from(s), 1.0, f64::from(-h)], [f64::from(-s), 1.0, f64::from(-h)]];
        check(&heights.into_iter().flat_map(pair).collect::<Vec<_>>())?;
    }

    #[test]
    fn generators_of_all_magnitudes(
        generators in generators(
            (integer(2), prop_oneof![Just(1e-300), Just(1e300), Just(1.0)]).prop_map(|(v, s)| v * s)
        ),
    ) {
        check(&generators)?;
    }
}

#[test]
fn three_coplanar_generators_have_one_hexagon() {
    let generators = [[1.0, 1.0, 0.0], [-1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    let dual = DualArrangement::new(&generators).expect("finite");
    let error = by_slope_selection::separator(&dual, 2, 0, &mut ()).expect_err("two of the three tiles");
    assert_eq!(error, SeparatorError::Coplanar { k: 2, generators: vec![0, 1, 2] });
    assert!(by_slope_selection::separator(&dual, 3, 0, &mut ()).is_ok());
}

#[test]
fn operations_grow_like_n_log_n() {
    use crate::tally::{Operation, OperationCounts};
    use rand::{RngExt, SeedableRng};
    for exponent in (8..=14).step_by(2) {
        let count = 1usize << exponent;
        let mut random = rand_pcg::Pcg64Mcg::seed_from_u64(count as u64);
        let generators: Vec<[f64; 3]> = (0..count).map(|_| [0; 3].map(|_| random.random_range(-1.0..1.0))).collect();
        let dual = DualArrangement::new(&generators).expect("finite");
        let mut counts = OperationCounts::default();
        separator(&dual, dual.lines().vertex_count() / 2, 1, &mut counts).expect("general position");
        let ratio = counts.get(Operation::Comparison) as f64 / (count * exponent) as f64;
        println!("n = 2^{exponent}: {ratio:.2} n log2 n comparisons");
        assert!(ratio < 30.0, "n = 2^{exponent}: {ratio}");
    }
}
