//! Small linear programs in exact rationals: the checks' own simplex method.

use dashu_ratio::RBig;

/// An equation Σ coefficients_i x_i = right.
#[derive(Clone, Debug)]
pub(crate) struct Equation {
    /// One coefficient for each unknown.
    pub(crate) coefficients: Vec<RBig>,
    /// The right side.
    pub(crate) right: RBig,
}

/// The least Σ costs_i x_i over x ≥ 0 that satisfy the equations; `None` when there is no such x. No cost may be
/// negative.
///
/// Two phases with Bland's rule, so that it ends on degenerate programs too.
pub(crate) fn least(costs: &[RBig], equations: &[Equation]) -> Option<RBig> {
    let (unknowns, count) = (costs.len(), equations.len());
    let mut rows: Vec<Vec<RBig>> = equations
        .iter()
        .enumerate()
        .map(|(i, equation)| {
            let turned = equation.right < RBig::ZERO;
            let sign = |value: &RBig| if turned { -value } else { value.clone() };
            let own = (0..count).map(|j| if i == j { RBig::ONE } else { RBig::ZERO });
            equation.coefficients.iter().map(sign).chain(own).chain([sign(&equation.right)]).collect()
        })
        .collect();
    let mut basis: Vec<usize> = (unknowns..unknowns + count).collect();
    let artificial: Vec<RBig> =
        (0..unknowns + count).map(|j| if j < unknowns { RBig::ZERO } else { RBig::ONE }).collect();
    if minimize(&mut rows, &mut basis, &artificial, unknowns + count) != RBig::ZERO {
        return None;
    }
    // An artificial unknown that stays in the basis, at zero, gives way to a real one, or its equation says nothing.
    for row in 0..count {
        if basis[row] >= unknowns
            && let Some(column) = (0..unknowns).find(|&column| rows[row][column] != RBig::ZERO)
        {
            pivot(&mut rows, &mut basis, row, column);
        }
    }
    let all: Vec<RBig> = costs.iter().cloned().chain((0..count).map(|_| RBig::ZERO)).collect();
    Some(minimize(&mut rows, &mut basis, &all, unknowns))
}

/// Pivots among the first `usable` unknowns until no cost can be saved; the least cost.
fn minimize(rows: &mut [Vec<RBig>], basis: &mut [usize], costs: &[RBig], usable: usize) -> RBig {
    loop {
        let saving = |column: usize| {
            let spent = rows.iter().zip(basis.iter());
            spent.fold(costs[column].clone(), |rest, (row, &own)| rest - &row[column] * &costs[own])
        };
        let Some(column) = (0..usable).find(|&column| !basis.contains(&column) && saving(column) < RBig::ZERO) else {
            break;
        };
        let limit = |row: usize| rows[row].last().map(|right| right / &rows[row][column]);
        let rising = (0..rows.len()).filter(|&row| rows[row][column] > RBig::ZERO);
        let row = rising
            .min_by(|&a, &b| limit(a).cmp(&limit(b)).then(basis[a].cmp(&basis[b])))
            .expect("costs are not negative, so the program is bounded");
        pivot(rows, basis, row, column);
    }
    let spent = rows.iter().zip(basis.iter()).filter_map(|(row, &own)| Some(row.last()? * &costs[own]));
    spent.fold(RBig::ZERO, |sum, cost| sum + cost)
}

fn pivot(rows: &mut [Vec<RBig>], basis: &mut [usize], row: usize, column: usize) {
    let head = rows[row][column].clone();
    rows[row].iter_mut().for_each(|value| *value /= &head);
    let pivot_row = rows[row].clone();
    for (_, other) in rows.iter_mut().enumerate().filter(|(index, _)| *index != row) {
        let factor = other[column].clone();
        if factor == RBig::ZERO {
            continue;
        }
        for (value, head) in other.iter_mut().zip(&pivot_row).filter(|(_, head)| **head != RBig::ZERO) {
            *value -= &factor * head;
        }
    }
    basis[row] = column;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::definitions::ratio::{fraction, integer};

    fn equation(coefficients: &[i64], right: i64) -> Equation {
        Equation { coefficients: coefficients.iter().copied().map(integer).collect(), right: integer(right) }
    }

    #[test]
    fn a_program_by_hand() {
        // 3x + y with x + y >= 2, x >= 1/2 (twice x minus a slack is 1): x = 1/2, y = 3/2
        let rows = [equation(&[1, 1, -1, 0], 2), equation(&[2, 0, 0, -1], 1)];
        assert_eq!(least(&[3, 1, 0, 0].map(integer), &rows), Some(integer(3)));
        assert_eq!(least(&[1, 3, 0, 0].map(integer), &rows), Some(integer(2)));
        assert_eq!(least(&[1, 1].map(integer), &[equation(&[-3, 0], -1)]), Some(fraction(1, 3)));
    }

    #[test]
    fn contradictions_and_repetitions() {
        assert_eq!(least(&[integer(1)], &[equation(&[1], 1), equation(&[2], 3)]), None);
        assert_eq!(least(&[integer(1)], &[equation(&[1], 1), equation(&[2], 2)]), Some(integer(1)));
        assert_eq!(least(&[integer(1)], &[equation(&[1], -1)]), None);
    }
}
