//! The certificates of the library's collision answers, checked from their definition.

use dashu_ratio::RBig;
use zonotope::collision::{Location, Separation, Witness};

use crate::definitions::ratio::{exactly, integer};
use crate::definitions::space::Vector;

/// The proof of an answer about a displacement p and the zonotope of some generators about the origin.
#[derive(Debug)]
pub(crate) enum Proof {
    /// Coefficients in [−1, 1] with Σ δ_i g_i = p, exactly.
    Member(Vec<RBig>),
    /// A direction u with u · p > Σ |u · g_i|, exactly.
    Separated(Vector),
}

/// The proof that an answer carries, or why it is none.
pub(crate) fn proof_of(answer: &Location<3>, target: &Vector, generators: &[Vector]) -> Result<Proof, String> {
    match answer {
        Location::Inside(witness) | Location::Boundary(witness) => {
            coefficients(witness, target, generators).map(Proof::Member)
        }
        Location::Outside(separation) => {
            let direction = match separation {
                Separation::Rounded(direction) => Vector::exactly(*direction),
                Separation::Exact(direction) => Vector(*direction.clone()),
            };
            let reach = generators.iter().fold(RBig::ZERO, |sum, generator| {
                let along = direction.dot(generator);
                if along < RBig::ZERO { sum - along } else { sum + along }
            });
            if direction.dot(target) > reach {
                Ok(Proof::Separated(direction))
            } else {
                Err(format!("the direction {direction} does not separate"))
            }
        }
    }
}

/// The coefficients of a witness, those of its basis solved for.
fn coefficients(witness: &Witness, target: &Vector, generators: &[Vector]) -> Result<Vec<RBig>, String> {
    let mut coefficients: Vec<RBig> = witness.coefficients.iter().copied().map(exactly).collect();
    let mut rest = target.clone();
    for (index, coefficient) in coefficients.iter().enumerate() {
        if !witness.basis.contains(&index) {
            rest = rest.plus(&-coefficient, &generators[index]);
        }
    }
    let columns: Vec<&Vector> = witness.basis.iter().map(|&index| &generators[index]).collect();
    let solved = solve(&columns, rest).ok_or("the basis does not span the rest")?;
    for (&index, value) in witness.basis.iter().zip(solved) {
        coefficients[index] = value;
    }
    match coefficients.iter().position(|c| *c < integer(-1) || *c > integer(1)) {
        Some(index) => Err(format!("coefficient {index} is {}", coefficients[index])),
        None => Ok(coefficients),
    }
}

/// The unique solution of Σ x_k columns_k = right; `None` if there is none, or more than one.
fn solve(columns: &[&Vector], right: Vector) -> Option<Vec<RBig>> {
    let width = columns.len();
    let mut rows: Vec<Vec<RBig>> = (0..3)
        .map(|i| columns.iter().map(|column| column.0[i].clone()).chain([right.0[i].clone()]).collect())
        .collect();
    for pivot in 0..width {
        let row = (pivot..3).find(|&row| rows[row][pivot] != RBig::ZERO)?;
        rows.swap(pivot, row);
        let head = rows[pivot][pivot].clone();
        rows[pivot].iter_mut().for_each(|value| *value /= &head);
        for other in (0..3).filter(|&other| other != pivot) {
            let factor = rows[other][pivot].clone();
            let pivot_row = rows[pivot].clone();
            for (value, head) in rows[other].iter_mut().zip(&pivot_row) {
                *value -= &factor * head;
            }
        }
    }
    let consistent = rows[width..].iter().all(|row| row[width] == RBig::ZERO);
    consistent.then(|| rows[..width].iter().map(|row| row[width].clone()).collect())
}
