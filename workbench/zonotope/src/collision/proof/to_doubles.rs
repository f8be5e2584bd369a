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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::exact_linear::{rational, solve};
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    fn vector(v: [f64; 3]) -> Vec<Rational> {
        v.map(rational).to_vec()
    }

    fn combined(rows: &[[f64; 3]], coefficients: &[Rational]) -> Vec<Rational> {
        (0..3)
            .map(|k| rows.iter().zip(coefficients).fold(Rational::ZERO, |sum, (v, c)| sum + c * rational(v[k])))
            .collect()
    }

    /// Thirds are no doubles, and those of dependent generators are moved until few are left.
    #[test]
    fn coefficients_off_an_independent_basis_become_doubles_that_prove_the_same() {
        let random = &mut Pcg64Mcg::seed_from_u64(151);
        for round in 0..200 {
            let n = 1 + round % 8;
            let rows: Vec<[f64; 3]> =
                (0..n).map(|_| [0, 1, 2].map(|_| f64::from(random.random_range(-2..3)))).collect();
            let coefficients: Vec<Rational> =
                (0..n).map(|_| rational(f64::from(random.random_range(-12..13))) / rational(12.0)).collect();
            let p = combined(&rows, &coefficients);
            let Witness { coefficients: own, basis } = rounded_off_a_basis(coefficients, |i| vector(rows[i]));
            assert!(own.len() == n && own.iter().all(|c| c.abs() <= 1.0) && basis.len() <= 3, "{own:?}");
            let off: Vec<Rational> =
                (0..n).map(|i| if basis.contains(&i) { Rational::ZERO } else { rational(own[i]) }).collect();
            let rest: Vec<Rational> = p.iter().zip(combined(&rows, &off)).map(|(p, off)| p - off).collect();
            let columns: Vec<Vec<Rational>> = basis.iter().map(|&b| vector(rows[b])).collect();
            if basis.is_empty() {
                assert!(rest.iter().all(|c| *c == Rational::ZERO), "{rows:?} {own:?}");
                continue;
            }
            let values = solve(&columns, &rest).expect("the basis is independent and solves the equation");
            for (&b, value) in basis.iter().zip(&values) {
                assert!(*value <= Rational::ONE && *value >= Rational::NEG_ONE, "{rows:?} {own:?}");
                assert!((value.to_f64().value() - own[b]).abs() < 1e-12, "{rows:?} {own:?}");
            }
        }
    }

    #[test]
    fn coefficients_that_are_doubles_stay_as_they_are() {
        let rows = [[1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let coefficients = [0.5, -0.25, 1.0, 0.0].map(rational).to_vec();
        let own = rounded_off_a_basis(coefficients, |i| vector(rows[i]));
        assert_eq!(own, Witness { coefficients: vec![0.5, -0.25, 1.0, 0.0], basis: vec![] });
        // of two parallel ones with thirds, one is moved to an end
        let third = rational(1.0) / rational(3.0);
        let own = rounded_off_a_basis(vec![third.clone(), third, Rational::ZERO, Rational::ZERO], |i| vector(rows[i]));
        assert!(own.basis.len() <= 1 && own.coefficients[..2].iter().any(|c| c.abs() == 1.0), "{own:?}");
    }
}
