//! The engines against programs solved by hand and against each other.

mod membership;

use proptest::prelude::*;
use rivals::simplex::Microlp;
use zonotope::linear_program::{BoundedVariable, Clarabel, Engine, Guess, LinearProgram, Relation, Row};

/// The programs of a long run.
const CASES: u32 = 300;

const ENGINES: [&dyn Engine; 2] = [&Clarabel, &Microlp];

type Constraint<'a> = (&'a [(usize, f64)], Relation, f64);

fn program(variables: &[BoundedVariable], rows: &[Constraint]) -> LinearProgram {
    let mut program = LinearProgram::new(variables.to_vec()).expect("valid variables");
    for (terms, relation, right) in rows {
        program.add_row(Row { terms: terms.to_vec(), relation: *relation, right: *right }).expect("a valid row");
    }
    program
}

fn cost_of(program: &LinearProgram, values: &[f64]) -> f64 {
    program.variables().iter().zip(values).map(|(variable, value)| variable.cost * value).sum()
}

fn near(a: &[f64], b: &[f64]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-6)
}

/// Maximise 2x + 3y, x + y ≤ 4, x ≤ 3, y ≤ 2, x − y ≥ −1: at (2, 2) the rows x + y ≤ 4 and the bound y ≤ 2 are tight.
#[test]
fn a_vertex_and_its_multipliers() {
    let bounded = |cost, upper| BoundedVariable { cost, lower: 0.0, upper };
    let program = program(
        &[bounded(-2.0, 3.0), bounded(-3.0, 2.0)],
        &[(&[(0, 1.0), (1, 1.0)], Relation::AtMost, 4.0), (&[(0, 1.0), (1, -1.0)], Relation::AtLeast, -1.0)],
    );
    for engine in ENGINES {
        let Guess::Optimal { primal, multipliers } = engine.solve(&program) else { panic!("{}", engine.name()) };
        assert!(near(&primal, &[2.0, 2.0]), "{}: {primal:?}", engine.name());
        assert!(near(&multipliers, &[-2.0, 0.0]), "{}: {multipliers:?}", engine.name());
        assert!((cost_of(&program, &primal) + 10.0).abs() < 1e-6);
    }
}

/// Minimise x + 2y with x + y = 1, x − y ≥ 0, x ≤ 0.75 fixed by the equality of both bounds of a third variable.
#[test]
fn equalities_fixed_and_free_variables() {
    let fixed = BoundedVariable { cost: 5.0, lower: 0.25, upper: 0.25 };
    let program = program(
        &[BoundedVariable::free(1.0), BoundedVariable::free(2.0), fixed],
        &[
            (&[(0, 1.0), (1, 1.0)], Relation::Equal, 1.0),
            (&[(0, 1.0), (2, 1.0)], Relation::AtMost, 1.0),
            (&[(0, 1.0), (1, -1.0)], Relation::AtLeast, 0.0),
        ],
    );
    for engine in ENGINES {
        let Guess::Optimal { primal, multipliers } = engine.solve(&program) else { panic!("{}", engine.name()) };
        assert!(near(&primal, &[0.75, 0.25, 0.25]), "{}: {primal:?}", engine.name());
        assert!(near(&multipliers, &[2.0, -1.0, 0.0]), "{}: {multipliers:?}", engine.name());
    }
}

#[test]
fn infeasible_and_unbounded_programs_are_seen() {
    let two = [BoundedVariable::non_negative(1.0); 2];
    let infeasible = program(&two, &[(&[(0, 1.0), (1, 1.0)], Relation::AtMost, -1.0)]);
    let unbounded = program(&[BoundedVariable::free(1.0); 2], &[(&[(0, 1.0)], Relation::AtMost, 1.0)]);
    for engine in ENGINES {
        assert_eq!(engine.solve(&infeasible), Guess::Infeasible, "{}", engine.name());
        assert_eq!(engine.solve(&unbounded), Guess::Unbounded, "{}", engine.name());
    }
}

tests::properties! {
    CASES;

    /// The origin is feasible and the box bounds everything, so both engines find an optimum, and duality ties primal
    /// to dual.
    #[test]
    fn engines_agree_and_duality_holds(
        costs in proptest::collection::vec(-3.0..3.0f64, 1..6),
        rows in proptest::collection::vec((proptest::collection::vec(-2.0..2.0f64, 6), 0.0..2.0f64, 0..3u8), 0..6),
    ) {
        let boxed = |&cost: &f64| BoundedVariable { cost, lower: -1.0, upper: 1.5 };
        let mut program = LinearProgram::new(costs.iter().map(boxed).collect()).expect("valid");
        for (coefficients, right, relation) in &rows {
            let terms: Vec<_> = coefficients.iter().copied().take(costs.len()).enumerate().collect();
            let (relation, right) = match relation {
                0 => (Relation::AtMost, *right),
                1 => (Relation::AtLeast, -right),
                _ => (Relation::Equal, 0.0),
            };
            // More equalities than variables leave only the origin, a program without an interior that engines may give
            // up on.
            let equalities = program.rows().iter().filter(|row| row.relation == Relation::Equal).count();
            if relation != Relation::Equal || equalities + 1 < costs.len() {
                program.add_row(Row { terms, relation, right }).expect("valid");
            }
        }
        let mut values = Vec::new();
        for engine in ENGINES {
            let Guess::Optimal { primal, multipliers } = engine.solve(&program) else {
                return Err(TestCaseError::fail(engine.name()));
            };
            let mut reduced = costs.clone();
            let mut bound = 0.0;
            for (row, y) in program.rows().iter().zip(&multipliers) {
                prop_assert!(row.relation != Relation::AtMost || *y < 1e-6);
                prop_assert!(row.relation != Relation::AtLeast || *y > -1e-6);
                bound += y * row.right;
                for &(variable, coefficient) in &row.terms {
                    reduced[variable] -= y * coefficient;
                }
            }
            bound += reduced.iter().map(|d| if *d > 0.0 { -d } else { 1.5 * d }).sum::<f64>();
            let value = cost_of(&program, &primal);
            prop_assert!((value - bound).abs() < 1e-5, "{}: {} against its dual {}", engine.name(), value, bound);
            values.push(value);
        }
        prop_assert!((values[0] - values[1]).abs() < 1e-5);
    }
}
