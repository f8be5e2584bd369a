//! Cuttings against the truth on every family of lines; location of all points that matter; sizes on hard inputs.

use std::num::NonZeroU32;

use families::drawn::numbers::{extreme_scale, integer};
use proptest::prelude::*;

use super::*;
use crate::arrangement::{ExactLine, LineArrangement, LineIndex};
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::seed::DEFAULT_SEED;
use crate::tally::{Operation, OperationCounts};

type Row = [f64; 3];

fn arrangement(rows: &[Row]) -> LineArrangement<'static> {
    LineArrangement::from_rows(rows).expect("the family makes finite lines")
}

fn parameter(r: u32) -> NonZeroU32 {
    NonZeroU32::new(r).expect("the parameters of the tests are positive")
}

/// The vertices, and the points in which lines meet walls.
fn special_points(lines: &LineArrangement) -> Vec<[Dyadic; 3]> {
    let all: Vec<ExactLine> = (0..lines.len() as u32).map(|line| lines.exact_line(LineIndex(line))).collect();
    let pairs = all.iter().enumerate().flat_map(|(j, second)| all[..j].iter().map(move |first| first.meet(second)));
    let vertices: Vec<[Dyadic; 3]> = pairs.filter(|[_, _, w]| !w.is_zero()).collect();
    let walls = vertices.iter().map(|[x, _, w]| ExactLine { normal: [w.clone(), Dyadic::zero()], offset: -x.clone() });
    let on_walls = walls.flat_map(|wall| all.iter().map(move |line| wall.meet(line)).collect::<Vec<_>>());
    vertices.iter().cloned().chain(on_walls.filter(|[_, _, w]| !w.is_zero())).collect()
}

fn check(rows: &[Row], r: u32, seed: u64) -> Result<(), TestCaseError> {
    let lines = arrangement(rows);
    let cutting = cutting(&lines, parameter(r), seed, &mut ());
    let trapezoids = cutting.trapezoids();
    let count = rows.iter().filter(|[a, b, _]| *a != 0.0 || *b != 0.0).count();
    prop_assert_eq!(cutting.limit(), count / r as usize);
    let flaw = brute_force::check(&lines, count / r as usize, trapezoids, |index| cutting.crossing_lines(index));
    prop_assert_eq!(flaw, Ok(()));
    let plain = [[0.0, 0.0], [1.0, -2.0], [-0.3, 0.7], [1e300, -1e300], [-5e-324, 5e-324], [-1e9, 3.0]];
    let plain = plain.map(|[x, y]| [Dyadic::from_f64(x), Dyadic::from_f64(y), Dyadic::one()]);
    let special = special_points(&lines);
    let step = special.len().div_ceil(60).max(1);
    for point in plain.into_iter().chain(special.into_iter().step_by(step)) {
        let [x, y, w] = point.each_ref().map(|v| v.to_rational());
        let truth = brute_force::locate(&lines, trapezoids, &[x / &w, y / &w]);
        prop_assert_eq!(truth.len(), 1, "{:?}", point);
        let found = cutting.locate_homogeneous(point.clone());
        prop_assert_eq!(found.as_slice(), &truth[..], "{:?}", point);
        let opposite = point.each_ref().map(|v| -v.clone());
        prop_assert_eq!(cutting.locate_homogeneous(opposite), found, "{:?}", point);
    }
    Ok(())
}

fn rows(coefficient: impl Strategy<Value = f64> + Clone) -> impl Strategy<Value = Vec<Row>> {
    proptest::collection::vec([coefficient.clone(), coefficient.clone(), coefficient], 0..14)
}

properties! {
    #![proptest_config(crate::property_cases::config(60))]

    #[test]
    fn random_lines(rows in rows(-1.0..1.0f64), r in 1..20u32, seed in 0..4u64) {
        check(&rows, r, seed)?;
    }

    #[test]
    fn lattice_lines(rows in rows(integer(3)), r in 1..20u32, seed in 0..4u64) {
        check(&rows, r, seed)?;
    }

    #[test]
    fn lines_of_all_magnitudes(rows in rows((integer(3), extreme_scale()).prop_map(|(v, s)| v * s)), r in 1..9u32) {
        check(&rows, r, 0)?;
    }

    #[test]
    fn lines_of_one_magnitude(rows in rows(-1.0..1.0f64), s in extreme_scale(), t in extreme_scale(), r in 1..9u32) {
        let rows: Vec<_> = rows.iter().map(|[a, b, c]| [a * s, b * s, c * t]).collect();
        check(&rows, r, 0)?;
    }

    #[test]
    fn lines_apart_by_units_in_the_last_place(rows in rows(integer(3)), r in 1..9u32) {
        let nudge = |steps: f64| f64::from_bits((1f64.to_bits() as i64 + steps as i64) as u64);
        check(&rows.iter().map(|row| row.map(nudge)).collect::<Vec<_>>(), r, 0)?;
    }

    #[test]
    fn nearly_parallel_lines(rows in rows(integer(3)), r in 1..9u32) {
        let rows: Vec<_> = rows.iter().map(|[a, b, c]| [1.0 + a * 1e-12, 1.0, 1.0 + b + c * 1e-12]).collect();
        check(&rows, r, 0)?;
    }

    #[test]
    fn concurrent_lines(rows in rows(integer(3)), x in integer(3), y in integer(3), r in 1..20u32) {
        let rows: Vec<_> = rows.iter().map(|[a, b, _]| [*a, *b, -(a * x + b * y)]).collect();
        check(&rows, r, 0)?;
    }

    #[test]
    fn almost_concurrent_lines(rows in rows(-1.0..1.0f64), x in -1.0..1.0f64, r in 1..20u32) {
        let rows: Vec<_> = rows.iter().map(|[a, b, _]| [*a, *b, -(a * x + b)]).collect();
        check(&rows, r, 0)?;
    }

    #[test]
    fn vertical_and_equal_lines(
        rows in rows(integer(3)),
        vertical in proptest::collection::vec(integer(3), 0..8),
        copies in 1..4usize,
        r in 1..30u32,
    ) {
        let vertical = vertical.into_iter().map(|x| [1.0, 0.0, x]);
        let rows: Vec<Row> = rows.into_iter().take(5).chain(vertical).collect();
        check(&rows.repeat(copies), r, 0)?;
    }

    #[test]
    fn parallel_families(rows in rows(integer(3)), slopes in [-1.0..1.0f64, -1.0..1.0], r in 1..20u32) {
        let rows: Vec<_> = rows.iter().map(|[a, _, c]| [slopes[usize::from(*a > 0.0)], 1.0, *c]).collect();
        check(&rows, r, 0)?;
    }
}

#[test]
fn points_that_are_not_finite_or_at_infinity_are_in_no_trapezoid() {
    let lines = arrangement(&[[1.0, -1.0, 0.0]]);
    let cutting = cutting(&lines, parameter(2), DEFAULT_SEED, &mut ());
    assert_eq!(cutting.trapezoids().len(), 2);
    let error = cutting.locate([0.0, f64::NAN]).expect_err("a coordinate is no number");
    assert_eq!(error.to_string(), "the point's coordinate 1 is NaN, not a finite number");
    let direction = [Dyadic::one(), Dyadic::one(), Dyadic::zero()];
    assert_eq!(cutting.locate_homogeneous(direction), None);
}

#[test]
fn without_lines_to_cut_there_is_one_trapezoid() {
    for (rows, r) in [(vec![], 5), (vec![[0.0, 0.0, 1.0]], 5), (vec![[1.0, 2.0, 3.0], [1.0, 0.0, 0.0]], 1)] {
        let lines = arrangement(&rows);
        let cutting = cutting(&lines, parameter(r), DEFAULT_SEED, &mut ());
        assert_eq!(cutting.trapezoids(), [Trapezoid { left: None, right: None, bottom: None, top: None }]);
        assert_eq!(cutting.locate([f64::MAX, f64::MIN]), Ok(TrapezoidIndex(0)));
    }
}

/// What is asked of a search by questions is what is asked of one by a point.
#[test]
fn questions_lead_where_the_point_is() {
    let rows: Vec<Row> = (0..40).map(|i| [f64::from(i * i % 17) - 8.0, 3.0, f64::from(i * 7 % 23) - 11.0]).collect();
    let lines = arrangement(&rows);
    let cutting = cutting(&lines, parameter(8), DEFAULT_SEED, &mut ());
    for [x, y] in [[0.5, 0.25], [-3.0, 7.5], [100.0, -3.0]] {
        let row = |line: LineIndex| rows[line.position()];
        let found = cutting.locate_by(|boundary| match boundary {
            Boundary::Line(line) => -(row(line)[0] * x + row(line)[2]) / row(line)[1] <= y,
            Boundary::Wall(Wall::Along(_)) => panic!("no line is vertical"),
            Boundary::Wall(Wall::Through(pair)) => {
                let [[a, b, c], [d, e, f]] = pair.map(row);
                (b * f - c * e) / (a * e - b * d) <= x
            }
        });
        assert_eq!(cutting.locate([x, y]), Ok(found));
    }
}

/// Lines that are hard for a choice of cuts: pencils, grids, bundles, tangents of a parabola, almost one point.
fn hard_instances(n: usize) -> Vec<(&'static str, Vec<Row>)> {
    use rand::{RngExt, SeedableRng};
    let mut random = rand_pcg::Pcg64Mcg::seed_from_u64(n as u64);
    let mut number = || random.random_range(-1.0..1.0);
    let mut make = |line: &mut dyn FnMut(usize, [f64; 3]) -> Row| -> Vec<Row> {
        (0..n).map(|i| line(i, [number(), number(), number()])).collect()
    };
    let root = n.isqrt().max(1);
    vec![
        ("random", make(&mut |_, v| v)),
        ("almost concurrent", make(&mut |_, [a, b, c]| [a, b, 1e-9 * c])),
        ("parallel", make(&mut |_, [_, _, c]| [1.0, 2.0, c])),
        ("grid", make(&mut |i, [a, b, c]| if i % 2 == 0 { [1e-3 * a, 1.0, c] } else { [1.0, 1e-3 * b, c] })),
        ("axis-parallel grid", make(&mut |i, [_, _, c]| if i % 2 == 0 { [0.0, 1.0, c] } else { [1.0, 0.0, c] })),
        ("two pencils", make(&mut |i, [a, b, _]| if i % 2 == 0 { [a, b, 0.0] } else { [a, b, a] })),
        (
            "bundles",
            make(&mut |i, [a, b, c]| {
                let bundle = (i % root) as f64;
                [(bundle * 0.7) % 1.0 + 1e-7 * a, 1.0, (bundle * 0.37) % 1.0 + 1e-7 * (b + c)]
            }),
        ),
        ("tangents", make(&mut |_, [a, _, _]| [2.0 * a, -1.0, -a * a])),
        ("exponential slopes", make(&mut |_, [a, _, c]| [f64::exp2((a * 300.0).round()) * c, 1.0, a])),
        ("few copied", make(&mut |i, _| [(i % 9) as f64, 1.0, (i * i % 7) as f64])),
    ]
}

#[test]
fn hard_lines_take_few_trapezoids() {
    for r in [4, 16, 64] {
        let n = 16 * r as usize;
        for (name, rows) in hard_instances(n) {
            let lines = arrangement(&rows);
            let mut counts = OperationCounts::default();
            let cutting = cutting(&lines, parameter(r), 1, &mut counts);
            let square = f64::from(r * r);
            let size = cutting.trapezoids().len() as f64 / square;
            let total = cutting.total_crossings() as f64 / (n as f64 * f64::from(r));
            let handed_down = counts.get(Operation::PartEvaluation) as f64 / (n as f64 * f64::from(r));
            let exact = counts.get(Operation::ExactFallback);
            println!(
                "{name:20} n = {n:5}, r = {r:3}: {size:.2} r², {total:.2} n r, {handed_down:.1} n r, exact {exact}"
            );
            assert!(size <= 12.0 && total <= 5.0, "{name}, r = {r}: {size} r², {total} n r");
            let heaviest = (0..cutting.trapezoids().len() as u32)
                .map(|index| cutting.crossing_lines(TrapezoidIndex(index)).len())
                .max();
            assert!(heaviest <= Some(n / r as usize), "{name}, r = {r}");
        }
    }
}

#[test]
fn larger_cuttings_are_right() {
    for (name, rows) in hard_instances(48) {
        assert!(check(&rows, 5, 2).is_ok(), "{name}");
    }
}

#[test]
fn the_same_seed_makes_the_same_cutting() {
    let (_, rows) = hard_instances(200).swap_remove(0);
    let lines = arrangement(&rows);
    let [first, second, other] = [3, 3, 4].map(|seed| cutting(&lines, parameter(10), seed, &mut ()));
    assert_eq!(first.trapezoids(), second.trapezoids());
    assert_ne!(first.trapezoids(), other.trapezoids());
}

/// Lists with one line too few, covers with one trapezoid too few or twice the same, and weights above the limit.
#[test]
fn the_check_finds_flaws() {
    let (_, rows) = hard_instances(20).swap_remove(0);
    let lines = arrangement(&rows);
    let cutting = cutting(&lines, parameter(4), DEFAULT_SEED, &mut ());
    let list = |index: TrapezoidIndex| cutting.crossing_lines(index);
    let all = cutting.trapezoids();
    assert_eq!(brute_force::check(&lines, 5, all, list), Ok(()));
    let heaviest =
        |limit| matches!(brute_force::check(&lines, limit, all, list), Err(brute_force::Flaw::Weight { .. }));
    assert!(heaviest(2));
    let missing = |index| list(index).get(1..).unwrap_or_default();
    assert!(matches!(brute_force::check(&lines, 5, all, missing), Err(brute_force::Flaw::List(_))));
    let gap = brute_force::check(&lines, 5, &all[..all.len() - 1], list);
    assert_eq!(gap, Err(brute_force::Flaw::Cover));
    let twice: Vec<Trapezoid> = all.iter().chain(&all[..1]).copied().collect();
    let again = |index: TrapezoidIndex| list(TrapezoidIndex(index.0 % all.len() as u32));
    assert_eq!(brute_force::check(&lines, 5, &twice, again), Err(brute_force::Flaw::Cover));
    let mut turned = all.to_vec();
    let flipped =
        turned.iter_mut().find(|t| t.bottom.is_some() && t.top.is_some()).expect("some lie between two lines");
    std::mem::swap(&mut flipped.bottom, &mut flipped.top);
    let own = |index: TrapezoidIndex| if turned[index.0 as usize] == all[index.0 as usize] { list(index) } else { &[] };
    assert!(matches!(brute_force::check(&lines, 5, &turned, own), Err(brute_force::Flaw::Shape(_))));
    let vertex = [Rational::ZERO, Rational::ZERO];
    assert_eq!(brute_force::locate(&lines, all, &vertex).len(), 1);
}
