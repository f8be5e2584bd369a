//! Selection against the truth, for every rank, on every family of lines; growth of the operation counts.

use families::drawn::numbers::{extreme_scale, integer, nudged};
use proptest::prelude::*;

use super::*;
use crate::tally::{Operation, OperationCounts};

fn check(rows: &[[f64; 3]]) -> Result<(), TestCaseError> {
    let arrangement = LineArrangement::from_rows(rows).expect("the family makes finite lines");
    let truth: Vec<_> = brute_force::vertices(&arrangement).iter().map(ArrangementVertex::exact_x).collect();
    prop_assert_eq!(arrangement.vertex_count(), truth.len() as u64);
    for (rank, x) in (1..).zip(&truth) {
        let vertex = randomized::kth_leftmost_vertex(&arrangement, rank, rank, &mut ()).expect("the rank exists");
        prop_assert_eq!(&vertex.exact_x(), x, "rank {}", rank);
        let [first, second] = vertex.lines.map(|line| arrangement.exact_line(line));
        let [numerator, _, denominator] = first.meet(&second).map(|v| v.to_rational());
        prop_assert_eq!(&(numerator / denominator), x, "rank {}: {:?}", rank, vertex.lines);
    }
    let ranks: Vec<u64> = (1..=truth.len() as u64).rev().chain((1..=truth.len() as u64).step_by(7)).collect();
    let together = kth_leftmost_vertices(&arrangement, &ranks, 5).expect("the ranks exist");
    prop_assert_eq!(together.len(), ranks.len());
    for (rank, vertex) in ranks.iter().zip(&together) {
        prop_assert_eq!(&vertex.exact_x(), &truth[*rank as usize - 1], "rank {} among all", rank);
    }
    for rank in [0, truth.len() as u64 + 1] {
        let error = SlopeSelectionError::Rank { rank, vertices: truth.len() as u64 };
        prop_assert_eq!(randomized::kth_leftmost_vertex(&arrangement, rank, 0, &mut ()).err(), Some(error));
        prop_assert_eq!(brute_force::kth_leftmost_vertex(&arrangement, rank).err(), Some(error));
        prop_assert_eq!(kth_leftmost_vertices(&arrangement, &[rank], 0).err(), Some(error));
    }
    Ok(())
}

fn rows(coefficient: impl Strategy<Value = f64> + Clone) -> impl Strategy<Value = Vec<[f64; 3]>> {
    proptest::collection::vec([coefficient.clone(), coefficient.clone(), coefficient], 0..26)
}

properties! {
    #![proptest_config(crate::property_cases::config(300))]

    #[test]
    fn random_lines(rows in rows(-1.0..1.0f64)) {
        check(&rows)?;
    }

    #[test]
    fn lattice_lines(rows in rows(integer(3))) {
        check(&rows)?;
    }

    #[test]
    fn lines_of_all_magnitudes(rows in rows((integer(3), extreme_scale()).prop_map(|(v, s)| v * s))) {
        check(&rows)?;
    }

    #[test]
    fn lines_of_one_magnitude(rows in rows(-1.0..1.0f64), s in extreme_scale(), t in extreme_scale()) {
        let rows: Vec<_> = rows.iter().map(|[a, b, c]| [a * s, b * s, c * t]).collect();
        check(&rows)?;
    }

    #[test]
    fn nearly_parallel_lines(rows in rows(integer(3))) {
        let rows: Vec<_> = rows.iter().map(|[a, b, c]| [1.0 + a * 1e-12, 1.0, 1.0 + b + c * 1e-12]).collect();
        check(&rows)?;
    }

    #[test]
    fn lines_apart_by_units_in_the_last_place(rows in rows(integer(3))) {
        let rows: Vec<_> = rows.iter().map(|row| row.map(|steps| nudged(1.0, steps as i64))).collect();
        check(&rows)?;
    }

    #[test]
    fn concurrent_lines(rows in rows(integer(3)), x in integer(3), y in integer(3)) {
        let rows: Vec<_> = rows.iter().map(|[a, b, _]| [*a, *b, -(a * x + b * y)]).collect();
        check(&rows)?;
    }

    #[test]
    fn almost_concurrent_lines(rows in rows(-1.0..1.0f64), x in -1.0..1.0f64) {
        let rows: Vec<_> = rows.iter().map(|[a, b, _]| [*a, *b, -(a * x + b)]).collect();
        check(&rows)?;
    }

    #[test]
    fn vertical_lines_among_others(rows in rows(integer(3)), vertical in proptest::collection::vec(integer(3), 0..26)) {
        let vertical = vertical.into_iter().map(|x| [1.0, 0.0, x]);
        check(&rows.into_iter().chain(vertical).collect::<Vec<_>>())?;
    }

    #[test]
    fn vertical_lines_across_few_others(
        rows in proptest::collection::vec([integer(3), integer(3), integer(3)], 0..4),
        vertical in proptest::collection::vec(-1.0..1.0f64, 0..26),
    ) {
        let vertical = vertical.into_iter().map(|x| [1.0, 0.0, x]);
        check(&rows.into_iter().chain(vertical).collect::<Vec<_>>())?;
    }

    #[test]
    fn parallel_families(rows in rows(integer(3)), slopes in [-1.0..1.0f64, -1.0..1.0]) {
        let rows: Vec<_> = rows.iter().map(|[a, _, c]| [slopes[usize::from(*a > 0.0)], 1.0, *c]).collect();
        check(&rows)?;
    }
}

#[test]
fn the_dual_of_a_cube_and_two_more() {
    use crate::arrangement::DualArrangement;
    // e1: x = 0; e2: y = 0; e3 has no line; (1, 1, −1): x + y = 1; (1, 0, −3): x = 3, which has no vertex with x = 0.
    let generators = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 1.0, -1.0], [1.0, 0.0, -3.0], [0.0; 3]];
    let dual = DualArrangement::new(&generators).expect("finite");
    let vertices = kth_leftmost_vertices(dual.lines(), &[1, 2, 3, 4, 5], 0).expect("five vertices");
    assert_eq!(vertices.iter().map(ArrangementVertex::x).collect::<Vec<_>>(), [0.0, 0.0, 1.0, 3.0, 3.0]);
    assert_eq!(dual.lines().vertex_count(), 5);
    let error = DualArrangement::new(&[[0.0, f64::NAN, 0.0]]).expect_err("a coordinate is no number");
    assert_eq!(error.to_string(), "generator 0, coordinate 1 is NaN, not a finite number");
}

#[test]
fn values_that_are_not_finite_are_refused() {
    let rows = [[1.0, 0.0, 0.0], [0.0, f64::INFINITY, 0.0]];
    let error = LineArrangement::from_rows(&rows).expect_err("a coefficient is infinite");
    assert_eq!(error.to_string(), "line 1: b is inf, not a finite number");
}

fn random_rows(count: usize) -> Vec<[f64; 3]> {
    use rand::{RngExt, SeedableRng};
    let mut random = rand_pcg::Pcg64Mcg::seed_from_u64(count as u64);
    (0..count).map(|_| [0; 3].map(|_| random.random_range(-1.0..1.0))).collect()
}

#[test]
fn operations_grow_like_n_log_n() {
    for exponent in (8..=16).step_by(2) {
        let count = 1usize << exponent;
        let arrangement = LineArrangement::from_rows(&random_rows(count)).expect("finite lines");
        let mut counts = OperationCounts::default();
        let rank = arrangement.vertex_count() / 2;
        kth_leftmost_vertex(&arrangement, rank, 1, &mut counts).expect("the rank exists");
        let ratio = counts.get(Operation::Comparison) as f64 / (count * exponent) as f64;
        println!("n = 2^{exponent}: {ratio:.2} n log2 n comparisons, {counts:?}");
        assert!(ratio < 30.0, "n = 2^{exponent}: {ratio}");
        assert!(counts.get(Operation::ExactFallback) < 100, "n = 2^{exponent}: {counts:?}");
    }
}
