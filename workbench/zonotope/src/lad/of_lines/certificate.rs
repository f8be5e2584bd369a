//! The proof of a minimiser.

use super::input::LadProblem;
use crate::arrangement::LineIndex;
use crate::numeric::dyadic::Dyadic;

/// Coefficients δ in [−1, 1] that prove a minimiser x*: linear + Σ δ_i w_i a_i = 0, and δ_i (a_i · x* + b_i) =
/// |a_i · x* + b_i| for each line.
///
/// They give the lower bound Σ δ_i w_i b_i for the objective at every point, with equality at x*.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LadCertificate {
    /// The coefficient δ of each line off the basis, 1 or −1; 0 for the basis and for lines whose coefficients are all
    /// zero.
    pub signs: Vec<i8>,
    /// The lines, at most two, whose coefficients δ are what the equation leaves for them.
    pub basis: Vec<LineIndex>,
}

impl LadCertificate {
    /// The coefficients of the basis lines as fractions, numerator and denominator, exactly. O(n) exact operations.
    pub(crate) fn basis_fractions(&self, problem: &LadProblem) -> Vec<[Dyadic; 2]> {
        let signed = self.signs.iter().enumerate().filter(|(_, sign)| **sign != 0).map(|(line, &sign)| (line, sign));
        let [x, y] = problem.exact.signed_normal_sum(&mut signed.into_iter());
        let rest = [-(&problem.linear[0] + &x), -(&problem.linear[1] + &y)];
        let cross = |a: &[Dyadic; 2], b: &[Dyadic; 2]| &a[0] * &b[1] - &a[1] * &b[0];
        let normal = |line: &LineIndex| problem.exact.line(line.position()).normal;
        match &self.basis[..] {
            [first, second] => {
                let (a, b) = (normal(first), normal(second));
                vec![[cross(&rest, &b), cross(&a, &b)], [cross(&a, &rest), cross(&a, &b)]]
            }
            [line] => {
                let a = normal(line);
                let axis = usize::from(a[0].is_zero());
                vec![[rest[axis].clone(), a[axis].clone()]]
            }
            _ => Vec::new(),
        }
    }
}
