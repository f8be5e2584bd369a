//! Location of a displacement, by a linear program in floating point whose answer is proved exactly or not given.
//!
//! # Statement
//! Input: a displacement p, generators g_i of R^D, any D ≥ 1, and an engine. Output: what the engine's optimum proves.
//! [`Answer::Located`] holds a complete location with its proof; [`Answer::Member`] proves a member whose status stayed
//! open; [`Answer::Undecided`] says why the engine's numbers proved nothing. No answer is ever wrong; touching and
//! narrowly missing questions are often undecided.
//!
//! # Source
//! Section 5.1 names linear programming as the general method; it is the baseline here.
//!
//! # Method
//! 1. Maximise t subject to Σ δ_i g_i = t p, |δ_i| ≤ 1, each axis and p scaled by a power of two: the gauge is 1 / t,
//!    and the multipliers of the axes are the direction u with u · p = 1 that minimises Σ |u · g_i|.
//! 2. If u or −u separates exactly, p is outside.
//! 3. The coefficients δ_i / t, clamped to [−1, 1], with a basis of independent generators that leave most room, prove
//!    a member if the basis coefficients that solve the equation exactly lie in [−1, 1].
//! 4. D of these strictly between −1 and 1 prove the inside, a direction u with u · p = Σ |u · g_i| exactly the
//!    boundary.
//!
//! # Complexity
//! The engine's, plus O(n D³) floating-point and O(n D) exact operations.
//!
//! # Shapes
//! generators: n × D, any order, zero and parallel ones allowed.
//!
//! # Numerics
//! The engine's numbers are guesses; what is concluded from them is decided in exact arithmetic.
//!
//! # Checked by
//! [`brute_force`](super::brute_force) and the crate `verifier` wherever it answers.
//!
//! # Example
//! ```
//! use zonotope::collision::{Query, Status, by_linear_program};
//! use zonotope::linear_program::Clarabel;
//! let square = [[1.0, 0.0], [0.0, 1.0]];
//! let question = Query::new([0.0, 0.0], [2.0, 0.5], &square).unwrap();
//! let answer = by_linear_program::locate(&question, &Clarabel);
//! assert_eq!(answer.location().unwrap().status(), Status::Outside);
//! ```

mod answer;
mod proof;

pub use answer::{Answer, Undecided};

use crate::linear_program::{BoundedVariable, Engine, Guess, LinearProgram, Relation, Row};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::scaling::{binary_exponent, scale_by_power_of_two};
use crate::zonotope::location::Location;
use crate::zonotope::query::Query;

/// What the engine's optimum proves about a displacement.
pub fn locate<const D: usize>(question: &Query<'_, D>, engine: &dyn Engine) -> Answer<D> {
    let displacement = question.exact();
    let program = ScaledProgram::of(question, &displacement);
    let guess = match &program {
        Some(program) => engine.solve(&program.program),
        None => Guess::Optimal { primal: vec![0.0; question.len()], multipliers: vec![0.0; D] },
    };
    let Guess::Optimal { primal, multipliers } = &guess else { return Answer::Undecided(Undecided::Engine(guess)) };
    let (times, direction) = match &program {
        Some(program) => (program.times(primal[question.len()]), program.direction::<D>(multipliers)),
        None => (f64::INFINITY, None),
    };
    if let Some(separation) = direction.as_ref().and_then(|u| proof::separation(question, &displacement, u)) {
        return Answer::Located(Location::Outside(separation));
    }
    match proof::membership(question, &displacement, &primal[..question.len()], times, direction.as_ref()) {
        Some(answer) => answer,
        None => Answer::Undecided(Undecided::Unproved { believed_gauge: 1.0 / times }),
    }
}

/// Maximise t' with Σ δ_i 2^−axis g_i = t' 2^−length p, axis by axis.
struct ScaledProgram {
    program: LinearProgram,
    axes: Vec<i64>,
    length: i64,
}

impl ScaledProgram {
    /// `None` for p = 0, which every zonotope holds.
    fn of<const D: usize>(question: &Query<'_, D>, displacement: &[Dyadic; D]) -> Option<Self> {
        let count = question.len();
        let axes: Vec<i64> = (0..D)
            .map(|axis| {
                let of_generators = question.generators().filter_map(|g| binary_exponent(g[axis])).max().map(i64::from);
                of_generators.or_else(|| displacement[axis].binary_exponent()).unwrap_or(0)
            })
            .collect();
        let scaled_exponent = |(p, axis): (&Dyadic, &i64)| Some(p.binary_exponent()? - axis);
        let length = displacement.iter().zip(&axes).filter_map(scaled_exponent).max()?;
        let boxed = BoundedVariable { cost: 0.0, lower: -1.0, upper: 1.0 };
        let mut variables = vec![boxed; count];
        variables.push(BoundedVariable::non_negative(-1.0));
        let mut program = LinearProgram::new(variables).expect("the costs are 0 and -1, the bounds -1, 0 and 1");
        for axis in 0..D {
            let generators = question.generators().map(|g| scale_by_power_of_two(g[axis], -axes[axis]));
            let point = -displacement[axis].clone().scaled(-axes[axis] - length).to_f64();
            let terms = generators.chain([point]).enumerate().filter(|(_, v)| *v != 0.0).collect();
            let row = Row { terms, relation: Relation::Equal, right: 0.0 };
            program.add_row(row).expect("each row names every variable at most once, with a finite coefficient");
        }
        Some(Self { program, axes, length })
    }

    /// t for the program's t'.
    fn times(&self, scaled: f64) -> f64 {
        scale_by_power_of_two(scaled, -self.length)
    }

    /// The direction that the multipliers of the axes are; `None` if they are not numbers.
    fn direction<const D: usize>(&self, multipliers: &[f64]) -> Option<[Dyadic; D]> {
        let finite = multipliers.iter().all(|y| y.is_finite());
        finite.then(|| std::array::from_fn(|axis| Dyadic::from_f64(multipliers[axis]).scaled(-self.axes[axis])))
    }
}
