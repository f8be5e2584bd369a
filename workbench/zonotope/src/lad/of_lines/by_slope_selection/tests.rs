//! What the search says of each vertical line, against the truth.

use families::drawn::numbers::integer;
use proptest::prelude::*;

use super::*;
use crate::arrangement::slope_selection::brute_force as all_vertices;
use crate::lad::{WeightedLine, brute_force};
use crate::tally::{Operation, OperationCounts};

fn check(rows: &[[f64; 3]], linear: [f64; 2]) -> Result<(), TestCaseError> {
    let lines: Vec<_> = rows.iter().map(|&[a, b, c]| WeightedLine::unweighted([a, b], c)).collect();
    let problem = LadProblem::new(&lines, linear).expect("the family makes finite lines");
    let truth = brute_force::minimize(&problem);
    let arrangement = LineArrangement::from_rows(rows).expect("the family makes finite lines");
    let mut left: Vec<Rational> = all_vertices::vertices(&arrangement).iter().map(|vertex| vertex.exact_x()).collect();
    let (_, steps) = trace(&problem, 1);
    prop_assert_eq!(steps.is_empty(), left.is_empty());
    for step in &steps {
        prop_assert_eq!(step.vertices_before, left.len() as u64);
        prop_assert_eq!(&step.exact_x, &left[(left.len() - 1) / 2], "not the median");
        let minimizers = truth.iter().flat_map(|truth| truth.minimizers.iter().map(|point| &point[0]));
        let minimizers: Vec<&Rational> = minimizers.collect();
        let (above, below) = (|x: &Rational| *x > step.exact_x, |x: &Rational| *x < step.exact_x);
        match step.side {
            Side::Left => {
                prop_assert!(minimizers.iter().all(|x| below(x)));
                left.retain(below);
            }
            Side::Right => {
                prop_assert!(minimizers.iter().all(|x| above(x)));
                left.retain(above);
            }
            Side::Optimal => {
                // With a linear term the set of minimisers may reach the line without a vertex on that side.
                let around = !minimizers.iter().all(|x| below(x)) && !minimizers.iter().all(|x| above(x));
                prop_assert!(around || linear != [0.0, 0.0]);
                left.clear();
            }
            Side::Unbounded => {
                prop_assert!(minimizers.is_empty());
                left.clear();
            }
        }
        prop_assert_eq!(step.vertices_after, left.len() as u64);
        prop_assert!(2 * step.vertices_after <= step.vertices_before, "less than half was discarded");
    }
    prop_assert!(left.is_empty());
    Ok(())
}

properties! {
    #![proptest_config(crate::property_cases::config(600))]

    #[test]
    fn steps_halve_random_lines(
        rows in proptest::collection::vec([-1.0..1.0f64, -1.0..1.0, -1.0..1.0], 0..14),
        linear in prop_oneof![Just([0.0, 0.0]), [-3.0..3.0f64, -3.0..3.0]],
    ) {
        check(&rows, linear)?;
    }

    #[test]
    fn steps_halve_lattice_lines(
        rows in proptest::collection::vec([integer(2), integer(2), integer(2)], 0..14),
        linear in prop_oneof![Just([0.0, 0.0]), [integer(2), integer(2)]],
    ) {
        check(&rows, linear)?;
    }
}

#[test]
fn operations_grow_like_n_log_squared_n() {
    use rand::RngExt;
    for exponent in (8..=14).step_by(2) {
        let count = 1u64 << exponent;
        let mut random = Pcg64Mcg::seed_from_u64(count);
        let mut value = || random.random_range(-1.0..1.0);
        let lines: Vec<_> = (0..count).map(|_| WeightedLine::unweighted([value(), value()], value())).collect();
        let problem = LadProblem::new(&lines, [0.0, 0.0]).expect("finite lines");
        let mut counts = OperationCounts::default();
        minimize(&problem, 1, &mut counts);
        let ratio = counts.get(Operation::Comparison) as f64 / (count * exponent * exponent) as f64;
        println!("n = 2^{exponent}: {ratio:.2} n log2² n comparisons, {counts:?}");
        assert!(ratio < 25.0, "n = 2^{exponent}: {ratio}");
        let (_, steps) = trace(&problem, 1);
        assert!(steps.len() as u64 <= 2 * exponent, "n = 2^{exponent}: {} vertical lines", steps.len());
    }
}
