//! An independent check of a location: exact, O(n), sharing nothing with the methods that find it.
//!
//! # What is proved
//! - `Outside`: the direction u satisfies u · p > Σ |u · g_i|.
//! - `Inside` and `Boundary`: the basis is independent and solves Σ δ_i g_i = p with every coefficient in [−1, 1].
//! - The status of a member. A direction u ≠ 0 supports the zonotope at p just when u is orthogonal to every generator whose coefficient
//!   is strictly between −1 and 1 and δ_i (u · g_i) ≥ 0 for the others: p is on the boundary if there is one and inside if not. That
//!   question is decided by adding the inequalities one after the other: a ray that violates the next one is replaced by a
//!   ray in that inequality's plane, a problem of one dimension less, or by its opposite.
//!
//! So an answer that passes is right, whatever found it.

use std::cmp::Ordering;

use rand::SeedableRng;
use rand::seq::SliceRandom;
use rand_pcg::Pcg64Mcg;
use thiserror::Error;

use super::location::{Location, Separation, Witness};
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::sum_of_products;
use crate::numeric::exact_sum::ExactSum;
use crate::zonotope::query::Query;

/// Why a location is not proved.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum VerifyError {
    /// A coordinate of the direction is NaN or infinite.
    #[error("the direction's coordinate {coordinate} is not a finite number")]
    NonFiniteDirection {
        /// The coordinate, from 0.
        coordinate: usize,
    },
    /// The direction does not separate the displacement from the zonotope.
    #[error("the direction does not separate")]
    NotSeparating,
    /// There is not one coefficient for each generator.
    #[error("{found} coefficients for {expected} generators")]
    CoefficientCount {
        /// How many generators there are.
        expected: usize,
        /// How many coefficients.
        found: usize,
    },
    /// A coefficient, solved for if it belongs to the basis, is not in [−1, 1].
    #[error("the coefficient of generator {generator} is not in [-1, 1]")]
    Coefficient {
        /// The generator, from 0.
        generator: usize,
    },
    /// The basis is not a list of generators in increasing order.
    #[error("the basis is not a list of generators in increasing order")]
    BasisOrder,
    /// The generators of the basis are dependent.
    #[error("the generators of the basis are dependent")]
    DependentBasis,
    /// No coefficients of the basis make up for what the others leave.
    #[error("no coefficients of the basis sum to the displacement")]
    NoSolution,
    /// The location says inside, but a supporting plane touches there.
    #[error("the point is on the boundary, not inside")]
    NotInside,
    /// The location says boundary, but no supporting plane touches there.
    #[error("the point is inside, not on the boundary")]
    NotBoundary,
}

type Vector = Vec<Dyadic>;

/// Checks a location and its proof, exactly.
///
/// # Errors
/// [`VerifyError`] says what is not proved.
pub fn verify<const D: usize>(question: &Query<'_, D>, location: &Location<D>) -> Result<(), VerifyError> {
    match location {
        Location::Outside(separation) => verify_separation(question, separation),
        Location::Inside(witness) => match is_supported(question, &solve(question, witness)?) {
            false => Ok(()),
            true => Err(VerifyError::NotInside),
        },
        Location::Boundary(witness) => match is_supported(question, &solve(question, witness)?) {
            true => Ok(()),
            false => Err(VerifyError::NotBoundary),
        },
    }
}

fn verify_separation<const D: usize>(question: &Query<'_, D>, separation: &Separation<D>) -> Result<(), VerifyError> {
    let direction: [Dyadic; D] = match separation {
        Separation::Rounded(direction) => {
            if let Some(coordinate) = direction.iter().position(|v| !v.is_finite()) {
                return Err(VerifyError::NonFiniteDirection { coordinate });
            }
            direction.map(Dyadic::from_f64)
        }
        Separation::Exact(direction) => {
            let common =
                direction.iter().fold(Rational::ONE, |product, v| product * Rational::from(v.denominator().clone()));
            std::array::from_fn(|i| Dyadic::new((&direction[i] * &common).numerator().clone(), 0))
        }
    };
    let reach = question.generators().fold(Dyadic::zero(), |sum, g| sum + sum_of_products(&direction, &exact(g)).abs());
    if sum_of_products(&direction, &question.exact()) > reach { Ok(()) } else { Err(VerifyError::NotSeparating) }
}

/// Every coefficient, exactly.
struct Solved<'w> {
    witness: &'w Witness,
    basis: Vec<Rational>,
}

impl Solved<'_> {
    /// The coefficient's sign if it is 1 or −1, 0 if it is strictly between.
    fn bound(&self, generator: usize) -> i8 {
        let at_end = |is_one: bool, is_minus_one: bool| i8::from(is_one) - i8::from(is_minus_one);
        match self.witness.basis.binary_search(&generator) {
            Ok(k) => at_end(self.basis[k] == Rational::ONE, self.basis[k] == Rational::NEG_ONE),
            Err(_) => {
                let coefficient = self.witness.coefficients[generator];
                at_end(coefficient == 1.0, coefficient == -1.0)
            }
        }
    }
}

fn solve<'w, const D: usize>(question: &Query<'_, D>, witness: &'w Witness) -> Result<Solved<'w>, VerifyError> {
    let Witness { coefficients, basis } = witness;
    if coefficients.len() != question.len() {
        return Err(VerifyError::CoefficientCount { expected: question.len(), found: coefficients.len() });
    }
    if let Some(generator) = coefficients.iter().position(|c| !(-1.0..=1.0).contains(c)) {
        return Err(VerifyError::Coefficient { generator });
    }
    if basis.windows(2).any(|pair| pair[0] >= pair[1]) || basis.last().is_some_and(|&last| last >= question.len()) {
        return Err(VerifyError::BasisOrder);
    }
    let left = left_over(question, witness);
    let mut rows: Vec<Vec<Rational>> = (0..D)
        .map(|axis| {
            let columns = basis.iter().map(|&b| Dyadic::from_f64(question.generator(b)[axis]).to_rational());
            columns.chain([left[axis].to_rational()]).collect()
        })
        .collect();
    for column in 0..basis.len() {
        let pivot = (column..D).find(|&row| rows[row][column] != Rational::ZERO).ok_or(VerifyError::DependentBasis)?;
        rows.swap(column, pivot);
        let (done, below) = rows.split_at_mut(column + 1);
        let pivot = &done[column];
        for row in below {
            let factor = &row[column] / &pivot[column];
            row.iter_mut().zip(pivot).for_each(|(a, b)| *a -= &factor * b);
        }
    }
    if rows[basis.len()..].iter().any(|row| row[basis.len()] != Rational::ZERO) {
        return Err(VerifyError::NoSolution);
    }
    let mut solution = vec![Rational::ZERO; basis.len()];
    for k in (0..basis.len()).rev() {
        let known = (k + 1..basis.len()).fold(Rational::ZERO, |sum, l| sum + &rows[k][l] * &solution[l]);
        solution[k] = (&rows[k][basis.len()] - known) / &rows[k][k];
        if solution[k] > Rational::ONE || solution[k] < Rational::NEG_ONE {
            return Err(VerifyError::Coefficient { generator: basis[k] });
        }
    }
    Ok(Solved { witness, basis: solution })
}

/// The displacement minus the generators off the basis, each with its coefficient.
fn left_over<const D: usize>(question: &Query<'_, D>, witness: &Witness) -> [Dyadic; D] {
    let mut whole: [ExactSum; D] = std::array::from_fn(|_| ExactSum::default());
    let mut left = question.exact();
    let mut basis = witness.basis.iter().copied().peekable();
    for ((i, g), &coefficient) in question.generators().enumerate().zip(&witness.coefficients) {
        if basis.next_if_eq(&i).is_some() {
            continue;
        }
        if coefficient.abs() == 1.0 {
            whole.iter_mut().zip(g).for_each(|(sum, v)| sum.add(coefficient * v));
        } else if coefficient != 0.0 {
            let coefficient = Dyadic::from_f64(coefficient);
            left.iter_mut().zip(exact(g)).for_each(|(sum, v)| *sum = &*sum - &(&coefficient * &v));
        }
    }
    left.iter().zip(&whole).map(|(a, b)| a - &b.value()).collect::<Vec<_>>().try_into().expect("one for each axis")
}

/// Whether a plane supports the zonotope at the point that the coefficients make.
fn is_supported<const D: usize>(question: &Query<'_, D>, solved: &Solved) -> bool {
    let mut subspace = Subspace::whole(D);
    let mut sides: Vec<(usize, i8)> = Vec::new();
    for (i, g) in question.generators().enumerate() {
        match solved.bound(i) {
            0 => subspace.cut(&exact(g)),
            side => sides.push((i, side)),
        }
        if subspace.dimension == 0 {
            return false;
        }
    }
    let signed = |(i, side): (usize, i8)| {
        subspace.restrict(question.generator(i).map(|v| f64::from(side) * v).map(Dyadic::from_f64).to_vec())
    };
    let mut inequalities: Vec<Vector> =
        sides.into_iter().map(signed).filter(|a| a.iter().any(|v| !v.is_zero())).collect();
    // In a random order few inequalities are violated when they come.
    inequalities.shuffle(&mut Pcg64Mcg::seed_from_u64(0));
    ray(&inequalities, subspace.dimension).is_some()
}

/// A subspace given by one equation after the other, each of which eliminates a coordinate.
struct Subspace {
    equations: Vec<(usize, Vector)>,
    dimension: usize,
}

impl Subspace {
    fn whole(dimension: usize) -> Self {
        Self { equations: Vec::new(), dimension }
    }

    /// A linear form of the whole space as one of the coordinates that are left, times a positive number.
    fn restrict(&self, mut form: Vector) -> Vector {
        for (pivot, equation) in &self.equations {
            form = eliminate(&form, equation, *pivot);
        }
        form
    }

    fn cut(&mut self, form: &[Dyadic]) {
        let equation = self.restrict(form.to_vec());
        if let Some(pivot) = equation.iter().position(|v| !v.is_zero()) {
            self.equations.push((pivot, equation));
            self.dimension -= 1;
        }
    }
}

/// The form on the plane where `equation` vanishes, in the coordinates other than `pivot`, times |equation\[pivot\]|.
fn eliminate(form: &[Dyadic], equation: &[Dyadic], pivot: usize) -> Vector {
    let scale = equation[pivot].clone().abs();
    let share = signed_like(&equation[pivot], &form[pivot]);
    let others = (0..form.len()).filter(|&l| l != pivot);
    others.map(|l| &(&scale * &form[l]) - &(&share * &equation[l])).collect()
}

/// `value` with its sign turned where `sign` is negative.
fn signed_like(sign: &Dyadic, value: &Dyadic) -> Dyadic {
    if sign.sign() == Ordering::Less { -value.clone() } else { value.clone() }
}

/// A vector u ≠ 0 of the given dimension with form · u ≥ 0 for every form; `None` if there is none.
fn ray(forms: &[Vector], dimension: usize) -> Option<Vector> {
    if dimension == 0 {
        return None;
    }
    let mut u: Vector = vec![Dyadic::zero(); dimension];
    u[0] = Dyadic::from_f64(1.0);
    for (position, form) in forms.iter().enumerate() {
        if sum_of_products(form, &u).sign() != Ordering::Less {
            continue;
        }
        let before = &forms[..position];
        // A form that is negative at u is not 0.
        let pivot = form.iter().position(|v| !v.is_zero())?;
        let in_plane: Vec<Vector> = before.iter().map(|other| eliminate(other, form, pivot)).collect();
        u = match ray(&in_plane, dimension - 1) {
            Some(flat) => lift(flat, form, pivot),
            None => {
                let opposite: Vector = u.into_iter().map(|v| -v).collect();
                if before.iter().any(|other| sum_of_products(other, &opposite).sign() == Ordering::Less) {
                    return None;
                }
                opposite
            }
        };
    }
    Some(u)
}

/// A vector of the plane where `equation` vanishes from its coordinates other than `pivot`, times |equation\[pivot\]|.
fn lift(flat: Vector, equation: &[Dyadic], pivot: usize) -> Vector {
    let others = equation.iter().enumerate().filter(|(l, _)| *l != pivot).map(|(_, v)| v);
    let sum = others.zip(&flat).fold(Dyadic::zero(), |sum, (a, b)| sum + a * b);
    let scale = equation[pivot].clone().abs();
    let mut lifted: Vector = flat.iter().map(|v| v * &scale).collect();
    lifted.insert(pivot, -signed_like(&equation[pivot], &sum));
    lifted
}

fn exact<const D: usize>(vector: &[f64; D]) -> [Dyadic; D] {
    vector.map(Dyadic::from_f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn witness(coefficients: &[f64], basis: &[usize]) -> Witness {
        Witness { coefficients: coefficients.to_vec(), basis: basis.to_vec() }
    }

    #[test]
    fn wrong_answers_are_refused() {
        let square = [[1.0, 0.0], [0.0, 1.0], [0.0, 0.0]];
        let question = Query::new([0.0; 2], [1.0, 0.25], &square).expect("finite");
        let check = |location| verify(&question, &location);
        let right = witness(&[1.0, 0.0, 0.5], &[1]);
        assert_eq!(check(Location::Boundary(right.clone())), Ok(()));
        assert_eq!(check(Location::Inside(right)), Err(VerifyError::NotInside));
        let boundary = |w| check(Location::Boundary(w));
        assert_eq!(boundary(witness(&[1.0, 0.25], &[])), Err(VerifyError::CoefficientCount { expected: 3, found: 2 }));
        assert_eq!(boundary(witness(&[1.0, f64::NAN, 0.0], &[])), Err(VerifyError::Coefficient { generator: 1 }));
        assert_eq!(boundary(witness(&[1.0, 0.0, 0.0], &[1, 0])), Err(VerifyError::BasisOrder));
        assert_eq!(boundary(witness(&[1.0, 0.0, 0.0], &[3])), Err(VerifyError::BasisOrder));
        assert_eq!(boundary(witness(&[1.0, 0.0, 0.0], &[1, 2])), Err(VerifyError::DependentBasis));
        assert_eq!(boundary(witness(&[0.5, 0.0, 0.0], &[1])), Err(VerifyError::NoSolution));
        let separates = |u| check(Location::Outside(Separation::Rounded(u)));
        assert_eq!(separates([1.0, 0.0]), Err(VerifyError::NotSeparating));
        assert_eq!(separates([1.0, f64::INFINITY]), Err(VerifyError::NonFiniteDirection { coordinate: 1 }));
    }

    #[test]
    fn a_basis_that_overshoots_is_refused() {
        let segment = [[1.0], [2.0]];
        let question = Query::new([0.0], [2.5], &segment).expect("finite");
        let coefficients = witness(&[-1.0, 1.0], &[1]);
        assert_eq!(verify(&question, &Location::Inside(coefficients)), Err(VerifyError::Coefficient { generator: 1 }));
        assert_eq!(verify(&question, &Location::Inside(witness(&[1.0, 0.0], &[1]))), Ok(()));
        assert_eq!(verify(&question, &Location::Boundary(witness(&[1.0, 0.0], &[1]))), Err(VerifyError::NotBoundary));
    }

    /// Three forms of the plane at 120° leave no ray, two leave some; a form and its opposite leave a line.
    #[test]
    fn rays_by_hand() {
        let forms = |list: &[[f64; 2]]| list.iter().map(|f| f.map(Dyadic::from_f64).to_vec()).collect::<Vec<_>>();
        assert!(ray(&forms(&[[2.0, 0.0], [-1.0, 2.0], [-1.0, -2.0]]), 2).is_none());
        assert!(ray(&forms(&[[2.0, 0.0], [-1.0, 2.0]]), 2).is_some());
        assert!(ray(&forms(&[[-1.0, 1.0], [1.0, -1.0]]), 2).is_some());
        assert!(ray(&forms(&[[-1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]]), 2).is_some());
        assert!(ray(&[], 1).is_some());
    }
}
