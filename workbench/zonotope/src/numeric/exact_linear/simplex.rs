//! The simplex method in rationals, which finds the exact optimum of small programs.
//!
//! It maximises Σ gain_j y_j over y ≥ 0 with inequalities · y ≤ bounds, where no bound is negative, and
//! equalities · y = 0. The point y = 0 is feasible, so there is no first phase. Bland's rule keeps the method from
//! cycling, however many rows are tight at once.
//!
//! The entries are quotients of determinants of the program's numbers, so they are long where these are of many sizes:
//! a program of thirteen rows in numbers from 1e-300 to 1e300 takes minutes. So a caller who has another answer says
//! how much work it may be.

use dashu_int::ops::BitTest;

use crate::numeric::Rational;

/// The work of a change of an entry beside that of its products and common divisors: as much as numbers of a few words
/// take.
pub(crate) const WORK_PER_CHANGE: u64 = 32;

/// Work without a limit.
pub(crate) const ANY_WORK: u64 = u64::MAX;

/// The column of an unknown y_j: its entries in the inequalities and in the equalities, and the gain of a unit of it.
pub(crate) struct Column {
    pub(crate) inequalities: Vec<Rational>,
    pub(crate) equalities: Vec<Rational>,
    pub(crate) gain: Rational,
}

/// An optimum with the prices that prove it.
pub(crate) struct Optimum {
    pub(crate) value: Rational,
    /// The value of each unknown.
    pub(crate) solution: Vec<Rational>,
    /// The price of each inequality; no price is negative.
    pub(crate) inequality_prices: Vec<Rational>,
    /// The price of each equality.
    pub(crate) equality_prices: Vec<Rational>,
}

/// Why there is no optimum.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum NoOptimum {
    /// The gain has no bound.
    Unbounded,
    /// It would take more work than was allowed.
    TooMuchWork,
}

/// The tableau. A row holds the entries of the unknowns, of one slack for each inequality and of one artificial unknown
/// for each equality, then the right-hand side. The last row holds the negated reduced gains, then the value.
struct Tableau<'a> {
    rows: Vec<Vec<Rational>>,
    basis: Vec<usize>,
    /// The work that is left, in products of words.
    work: &'a mut u64,
}

impl Tableau<'_> {
    /// Makes a column basic in a row.
    fn pivot(&mut self, row: usize, column: usize) -> Result<(), NoOptimum> {
        let inverse = Rational::ONE / &self.rows[row][column];
        for entry in &mut self.rows[row] {
            if !entry.is_zero() {
                *entry *= &inverse;
            }
        }
        let pivot_row = std::mem::take(&mut self.rows[row]);
        for other in self.rows.iter_mut().filter(|other| !other.is_empty()) {
            let factor = other[column].clone();
            if factor.is_zero() {
                continue;
            }
            for (entry, pivot) in other.iter_mut().zip(&pivot_row) {
                if !pivot.is_zero() {
                    let longest = words(&factor) + words(pivot) + words(entry);
                    let change = longest * longest + WORK_PER_CHANGE;
                    *self.work = self.work.checked_sub(change).ok_or(NoOptimum::TooMuchWork)?;
                    *entry -= &factor * pivot;
                }
            }
        }
        self.rows[row] = pivot_row;
        self.basis[row] = column;
        Ok(())
    }
}

/// The length of a number, at least 1.
fn words(number: &Rational) -> u64 {
    (number.numerator().bit_len() + number.denominator().bit_len()) as u64 / 64 + 1
}

/// The optimum, if it takes no more than the work that is left, in products of words; what it takes is taken off.
///
/// # Errors
/// [`NoOptimum`] says which of the two does not hold.
pub(crate) fn maximize(
    columns: &[Column],
    bounds: &[Rational],
    equalities: usize,
    work: &mut u64,
) -> Result<Optimum, NoOptimum> {
    let (inequalities, unknowns) = (bounds.len(), columns.len());
    let height = inequalities + equalities;
    let width = unknowns + height + 1;
    let mut rows: Vec<Vec<Rational>> = (0..height)
        .map(|row| {
            let mut entries: Vec<Rational> = columns
                .iter()
                .map(|c| {
                    if row < inequalities { &c.inequalities[row] } else { &c.equalities[row - inequalities] }.clone()
                })
                .collect();
            entries.resize(width, Rational::ZERO);
            entries[unknowns + row] = Rational::ONE;
            if row < inequalities {
                entries[width - 1] = bounds[row].clone();
            }
            entries
        })
        .collect();
    let mut objective: Vec<Rational> = columns.iter().map(|c| -c.gain.clone()).collect();
    objective.resize(width, Rational::ZERO);
    rows.push(objective);
    let mut tableau = Tableau { rows, basis: (unknowns..unknowns + height).collect(), work };
    for row in inequalities..height {
        // The right-hand side is zero, so any nonzero entry can be the pivot, whatever its sign; a row without one is
        // 0 = 0.
        if let Some(column) = (0..unknowns).find(|&c| !tableau.rows[row][c].is_zero()) {
            tableau.pivot(row, column)?;
        }
    }
    let may_enter = unknowns + inequalities;
    while let Some(entering) = (0..may_enter).find(|&c| tableau.rows[height][c] < Rational::ZERO) {
        let candidates = (0..height).filter(|&row| tableau.rows[row][entering] > Rational::ZERO);
        let ratio = |row: usize| &tableau.rows[row][width - 1] / &tableau.rows[row][entering];
        let leaving = candidates
            .min_by(|&a, &b| ratio(a).cmp(&ratio(b)).then_with(|| tableau.basis[a].cmp(&tableau.basis[b])))
            .ok_or(NoOptimum::Unbounded)?;
        tableau.pivot(leaving, entering)?;
    }
    let mut solution = vec![Rational::ZERO; unknowns];
    for (row, &column) in tableau.basis.iter().enumerate() {
        if column < unknowns {
            solution[column] = tableau.rows[row][width - 1].clone();
        }
    }
    let mut last = tableau.rows.pop().expect("the objective is the last row");
    let value = last.pop().expect("the value is the last entry");
    let equality_prices = last.split_off(may_enter);
    let inequality_prices = last.split_off(unknowns);
    Ok(Optimum { value, solution, inequality_prices, equality_prices })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn numbers(values: &[i32]) -> Vec<Rational> {
        values.iter().map(|&v| Rational::from(v)).collect()
    }

    fn column(inequalities: &[i32], equalities: &[i32], gain: i32) -> Column {
        Column { inequalities: numbers(inequalities), equalities: numbers(equalities), gain: Rational::from(gain) }
    }

    #[test]
    fn a_program_by_hand() {
        // Maximise 3a + 2b with a + b ≤ 4, a + 3b ≤ 6, a ≤ 3: the optimum is a = 3, b = 1.
        let columns = [column(&[1, 1, 1], &[], 3), column(&[1, 3, 0], &[], 2)];
        let optimum = maximize(&columns, &numbers(&[4, 6, 3]), 0, &mut ANY_WORK.clone()).expect("bounded");
        assert_eq!(optimum.value, Rational::from(11));
        assert_eq!(optimum.solution, numbers(&[3, 1]));
        assert_eq!(optimum.inequality_prices, numbers(&[2, 0, 1]));
    }

    #[test]
    fn equalities_have_prices_and_a_gain_may_have_no_bound() {
        // Maximise 3a − b with a = b and a ≤ 5.
        let columns = [column(&[1], &[1], 3), column(&[0], &[-1], -1)];
        let optimum = maximize(&columns, &numbers(&[5]), 1, &mut ANY_WORK.clone()).expect("bounded");
        assert_eq!(
            (optimum.value, optimum.inequality_prices, optimum.equality_prices),
            (10.into(), numbers(&[2]), numbers(&[1]))
        );
        let of =
            |mut work| maximize(&[column(&[0], &[0], 1)], &numbers(&[1]), 1, &mut work).map(|optimum| optimum.value);
        assert_eq!(of(ANY_WORK), Err(NoOptimum::Unbounded));
        let of = |mut work| maximize(&columns, &numbers(&[5]), 1, &mut work).map(|optimum| optimum.value);
        assert_eq!((of(10), of(100_000)), (Err(NoOptimum::TooMuchWork), Ok(10.into())));
    }

    /// Beale's example, on which the largest-coefficient rule cycles.
    #[test]
    fn ties_do_not_make_it_cycle() {
        let q = |a: i32, b: u32| Rational::from(a) / Rational::from(b);
        let columns = [
            Column { inequalities: vec![q(1, 4), q(1, 2), q(0, 1)], equalities: vec![], gain: q(3, 4) },
            Column { inequalities: vec![q(-60, 1), q(-90, 1), q(0, 1)], equalities: vec![], gain: q(-150, 1) },
            Column { inequalities: vec![q(-1, 25), q(-1, 50), q(1, 1)], equalities: vec![], gain: q(1, 50) },
            Column { inequalities: vec![q(9, 1), q(3, 1), q(0, 1)], equalities: vec![], gain: q(-6, 1) },
        ];
        assert_eq!(
            maximize(&columns, &numbers(&[0, 0, 1]), 0, &mut ANY_WORK.clone()).expect("bounded").value,
            q(1, 20)
        );
    }

    #[test]
    fn lengths_are_told_in_words_of_both_parts_of_a_fraction() {
        let power = |exponent: usize| Rational::from(dashu_int::UBig::ONE << exponent);
        let numbers = [Rational::ZERO, Rational::ONE, power(64), power(200), power(200) / Rational::from(3).pow(100)];
        assert_eq!(numbers.each_ref().map(words), [1, 1, 2, 4, 6]);
    }

    #[test]
    fn a_program_takes_the_work_of_its_changes_and_no_more() {
        // Factors and pivots of the objective's changes have 2 and 1, 2 and 1, 2 and 4 words.
        let [gain, bound] = [64usize, 200].map(|exponent| Rational::from(dashu_int::UBig::ONE << exponent));
        let columns = [Column { inequalities: numbers(&[1]), equalities: vec![], gain: gain.clone() }];
        let needed = [2 + 1 + 2, 2 + 1 + 1, 2 + 4 + 1].map(|sum| sum * sum + WORK_PER_CHANGE).iter().sum();
        let mut work = needed;
        let optimum = maximize(&columns, std::slice::from_ref(&bound), 0, &mut work).expect("all work is allowed");
        assert_eq!((optimum.value, optimum.solution, work), (&gain * &bound, vec![bound.clone()], 0));
        assert_eq!((optimum.inequality_prices, optimum.equality_prices), (vec![gain], vec![]));
        assert_eq!(maximize(&columns, &[bound], 0, &mut (needed - 1)).err(), Some(NoOptimum::TooMuchWork));
    }

    #[test]
    fn the_row_of_the_least_ratio_leaves() {
        let columns = [column(&[2, 1], &[], 1)];
        let optimum = maximize(&columns, &numbers(&[6, 4]), 0, &mut ANY_WORK.clone()).expect("bounded");
        assert_eq!((optimum.value, optimum.solution), (3.into(), numbers(&[3])));
    }

    properties! {
        #![proptest_config(crate::property_cases::config(2_000))]

        #[test]
        fn an_optimum_is_feasible_and_its_prices_prove_it(
            entries in proptest::collection::vec(proptest::array::uniform4(-3i32..6), 1..5),
            bounds in proptest::array::uniform2(0i32..9),
        ) {
            // two inequalities, one equality and the gain
            let columns: Vec<Column> = entries.iter().map(|[a, b, c, gain]| column(&[*a, *b], &[*c], *gain)).collect();
            let bounds = numbers(&bounds);
            if let Ok(optimum) = maximize(&columns, &bounds, 1, &mut ANY_WORK.clone()) {
                let sum = |terms: &mut dyn Iterator<Item = Rational>| terms.fold(Rational::ZERO, |sum, v| sum + v);
                let of_row = |entry: &dyn Fn(&Column) -> Rational| {
                    sum(&mut columns.iter().zip(&optimum.solution).map(|(column, value)| entry(column) * value))
                };
                prop_assert!(optimum.solution.iter().chain(&optimum.inequality_prices).all(|v| *v >= Rational::ZERO));
                for (row, bound) in bounds.iter().enumerate() {
                    prop_assert!(of_row(&|column| column.inequalities[row].clone()) <= *bound);
                }
                prop_assert_eq!(of_row(&|column| column.equalities[0].clone()), Rational::ZERO);
                prop_assert_eq!(of_row(&|column| column.gain.clone()), optimum.value.clone());
                for column in &columns {
                    let cost = |prices: &[Rational], entries: &[Rational]| {
                        sum(&mut prices.iter().zip(entries).map(|(price, entry)| price * entry))
                    };
                    let costs = cost(&optimum.inequality_prices, &column.inequalities)
                        + cost(&optimum.equality_prices, &column.equalities);
                    prop_assert!(costs >= column.gain);
                }
                let prices = optimum.inequality_prices.iter().zip(&bounds);
                prop_assert_eq!(sum(&mut prices.map(|(price, bound)| price * bound)), optimum.value);
            }
        }
    }
}
