//! Cuttings against their definition, on all line families; how many trapezoids they take, how long their lists are.

use std::num::NonZeroU32;

use dashu_ratio::RBig;
use families::drawn::lines::Instance;
use families::lines::LINE_FAMILIES;
use proptest::prelude::*;
use tests::runner::cases;
use zonotope::arrangement::cutting::{Boundary, Cutting, TrapezoidIndex, Wall, brute_force, cutting};
use zonotope::arrangement::{LineArrangement, LineIndex};
use zonotope::tally::{Operation, OperationCounts};

const CASES: u32 = 24;

/// The largest number of lines of a long run.
const LARGEST_INSTANCE: u32 = 4096;

fn parameter(r: u32) -> NonZeroU32 {
    NonZeroU32::new(r).expect("the parameters of the tests are positive")
}

fn agrees(instance: Instance) -> Result<(), TestCaseError> {
    let rows: Vec<[f64; 3]> = instance.terms.iter().map(|term| [term.a[0], term.a[1], term.b]).collect();
    let lines = LineArrangement::from_rows(&rows).expect("the families are finite");
    let count = rows.iter().filter(|[a, b, _]| *a != 0.0 || *b != 0.0).count();
    for r in [2, 5, 20] {
        let cutting = cutting(&lines, parameter(r), 1, &mut ());
        let list = |index| cutting.crossing_lines(index);
        prop_assert_eq!(brute_force::check(&lines, count / r as usize, cutting.trapezoids(), list), Ok(()));
        for point in [[0.0, 0.0], [1.0, -1.0], [0.3, 2.5], [-1e9, 1e-9]] {
            let exact = point.map(|v| RBig::try_from(v).expect("the coordinates are finite"));
            let truth = brute_force::locate(&lines, cutting.trapezoids(), &exact);
            prop_assert_eq!(vec![cutting.locate(point).expect("the coordinates are finite")], truth);
        }
    }
    Ok(())
}

tests::test_on_line_families!(mod small: 1..=12, mixed 1..=7, CASES, agrees);

/// The number of questions that the location of a point takes at most, of a grid of points around the origin.
fn most_questions(rows: &[[f64; 3]], cutting: &Cutting) -> u32 {
    let row = |line: LineIndex| rows[line.position()];
    let grid = (-20..20).flat_map(|x| (-20..20).map(move |y| [f64::from(x) / 9.7, f64::from(y) / 9.3]));
    let questions = grid.map(|[x, y]| {
        let mut questions = 0;
        cutting.locate_by(|boundary| {
            questions += 1;
            match boundary {
                Boundary::Line(line) => -(row(line)[0] * x + row(line)[2]) / row(line)[1] <= y,
                Boundary::Wall(Wall::Along(line)) => -row(line)[2] / row(line)[0] <= x,
                Boundary::Wall(Wall::Through(pair)) => {
                    let [[a, b, c], [d, e, f]] = pair.map(row);
                    (b * f - c * e) / (a * e - b * d) <= x
                }
            }
        });
        questions
    });
    questions.max().expect("the grid has points")
}

/// Matoušek's bound on the number N of trapezoids for random lines, half as many again for the others; `-- --nocapture`
/// shows the constants.
#[test]
fn cuttings_are_small() {
    println!("| family | n | r | N / r² | listed / (n r) | heaviest · r / n | handed down / (n r) | questions |");
    println!("|---|---|---|---|---|---|---|---|");
    for family in LINE_FAMILIES {
        for r in [4u32, 8, 16, 32, 64, 128, 256] {
            for n in [4 * r, 16 * r, 64 * r].into_iter().filter(|&n| n <= cases(LARGEST_INSTANCE)) {
                let terms = family.generate(n as usize, u64::from(r));
                let rows: Vec<[f64; 3]> = terms.into_iter().map(|(a, b)| [a[0], a[1], b]).collect();
                let lines = LineArrangement::from_rows(&rows).expect("the family makes finite lines");
                let mut counts = OperationCounts::default();
                let cutting = cutting(&lines, parameter(r), 0, &mut counts);
                let trapezoids = cutting.trapezoids().len();
                let lists = (0..trapezoids as u32).map(|index| cutting.crossing_lines(TrapezoidIndex(index)).len());
                let heaviest = lists.max().expect("there is a trapezoid");
                let questions = most_questions(&rows, &cutting);
                let (square, product) = (f64::from(r * r), f64::from(n) * f64::from(r));
                let [size, total] = [trapezoids as f64 / square, cutting.total_crossings() as f64 / product];
                let handed_down = counts.get(Operation::PartEvaluation) as f64 / product;
                let id = family.id;
                let weight = f64::from(r) * heaviest as f64 / f64::from(n);
                println!(
                    "| {id} | {n} | {r} | {size:.2} | {total:.2} | {weight:.2} | {handed_down:.1} | {questions} |"
                );
                let bound = if id == "random_lines" { 8 * r * r + 6 * r + 4 } else { 12 * r * r };
                assert!(trapezoids <= bound as usize, "{id}, n = {n}, r = {r}: {trapezoids} trapezoids");
                assert!(total <= 5.0, "{id}, n = {n}, r = {r}: lists of {total} n r lines");
                assert!(heaviest <= (n / r) as usize, "{id}, n = {n}, r = {r}: {heaviest} lines");
                assert!(r < 16 || handed_down <= 13.0, "{id}, n = {n}, r = {r}: {handed_down} n r handed down");
                let logarithm = libm::log2(trapezoids as f64) / libm::log2(1.5);
                assert!(f64::from(questions) <= 4.0 * logarithm + 4.0, "{id}, n = {n}, r = {r}: {questions} questions");
            }
        }
    }
}
