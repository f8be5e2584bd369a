//! From rational coefficients of a member to a witness, whose coefficients off a basis are doubles.

use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::dependence;
use crate::zonotope::location::Witness;

/// The witness of exact coefficients in [−1, 1]. They are moved along dependences of the generators until those that no
/// double says belong to independent generators, the basis; each move takes one of them to −1 or 1. O(n) eliminations.
pub(in crate::collision) fn rounded_off_a_basis(
    mut coefficients: Vec<Rational>,
    generator: impl Fn(usize) -> Vec<Rational>,
) -> Witness {
    let is_double = |c: &Rational| Dyadic::from_f64(c.to_f64().value()).to_rational() == *c;
    let mut basis: Vec<usize> = Vec::new();
    for i in 0..coefficients.len() {
        if is_double(&coefficients[i]) {
            continue;
        }
        basis.push(i);
        let members: Vec<Vec<Rational>> = basis.iter().map(|&b| generator(b)).collect();
        let Some(dependence) = dependence(&members) else { continue };
        // The longest step in the direction of the dependence that stays in [−1, 1].
        let room = |(&b, rate): (&usize, &Rational)| {
            let end = if *rate > Rational::ZERO { Rational::ONE } else { Rational::NEG_ONE };
            (*rate != Rational::ZERO).then(|| (end - &coefficients[b]) / rate)
        };
        let step =
            basis.iter().zip(&dependence).filter_map(room).min().expect("a dependence has a member that is not 0");
        for (&b, rate) in basis.iter().zip(&dependence) {
            coefficients[b] += &step * rate;
        }
        basis.retain(|&b| !is_double(&coefficients[b]));
    }
    let coefficients = coefficients.iter().map(|c| c.to_f64().value().clamp(-1.0, 1.0)).collect();
    Witness { coefficients, basis }
}
