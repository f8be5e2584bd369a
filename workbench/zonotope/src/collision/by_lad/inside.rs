//! The proof of a member in doubles, from a vertex that doubles proved.
//!
//! All generators have ±c, c near 1 / λ, but three that make up for the rest: the two of the vertex and a third, off the facet's plane. Where the
//! point is at an edge of its facet, the two are at the ends of their range; then the third is one that moves both inwards as it
//! leaves its own end, which it may as far as c can grow towards 1.

use super::certain::Certain;
use super::trail::Trail;
use crate::collision::{Displacement, Witness};
use crate::numeric::bounded::{self, Bounded, BoundedVector};
use crate::numeric::tolerance::UNIT;

/// How many generators are tried as the third.
const PICKS: usize = 32;

/// A margin of so much of what the other generators leave is enough.
const ENOUGH: f64 = 0.25;

/// How much of the third's range is left to it when it moves away from its end.
const MOVE: f64 = 0.5;

/// Three generators and the factor of all others.
#[derive(Debug, Clone, Copy)]
struct Attempt {
    third: usize,
    sign: f64,
    factor: f64,
    /// How far the largest of the three coefficients is from 1, nearly.
    margin: f64,
}

/// The proof of a member whose gauge is less than 1.
pub(super) fn witness(
    question: &Displacement<'_, 3>,
    certain: &Certain,
    trail: &Trail,
    p: &BoundedVector,
) -> Option<Witness> {
    let inverse = (certain.along.value / certain.reach.value).min(1.0);
    let n = question.len();
    let last = certain.cell();
    let sign = |index: usize| trail.sign(question, &last, index);
    let is_shared = |i: &usize| certain.shares.binary_search_by_key(i, |(index, _)| *index).is_ok();
    let picks = (0..n).step_by(n.div_ceil(PICKS).max(1)).filter(|i| !certain.basis.contains(i) && !is_shared(i));
    // far enough from the ends: no other pick is much better, unless rounding forbids this one
    let mut enough = ENOUGH * (1.0 - inverse);
    let mut best = Attempt { third: 0, sign: 0.0, factor: 0.0, margin: 0.0 };
    for third in picks {
        let sign = sign(third);
        let v = question.generator(third);
        let height = sign * dot(&v, &certain.direction.map(|c| c.value)) / certain.reach.value;
        let moved = (inverse * (1.0 + MOVE * height)).min(1.0);
        for factor in [moved, inverse, 1.0] {
            let own = attempt(question, certain, p, Attempt { third, sign, factor, margin: 0.0 });
            if own.margin > best.margin {
                best = own;
            }
        }
        if best.margin > enough && enough > 0.0 {
            if let Some(found) = prove(question, certain, trail, p, best) {
                return Some(found);
            }
            enough = 0.0;
        }
    }
    if best.margin > 0.0 { prove(question, certain, trail, p, best) } else { None }
}

/// The proof by an attempt, if rounding leaves no doubt of it.
fn prove(
    question: &Displacement<'_, 3>,
    certain: &Certain,
    trail: &Trail,
    p: &BoundedVector,
    attempt: Attempt,
) -> Option<Witness> {
    let Attempt { third, sign, factor, .. } = attempt;
    let [a, b] = certain.vectors.map(bounded::exact);
    let c = bounded::exact(question.generator(third));
    let off = [0, 1, 2].map(|k| certain.sum[k] - c[k] * Bounded::exact(sign));
    let normals = [bounded::cross(&b, &c), bounded::cross(&c, &a), bounded::cross(&a, &b)];
    let determinant = bounded::dot(&c, &normals[2]);
    let negative = determinant.sign()? < 0;
    let determinant = if negative { determinant.negated() } else { determinant };
    // the coefficients of those that share are rounded
    let rounded = Bounded { value: 0.0, error: 2.0 * (UNIT * certain.shared + f64::MIN_POSITIVE) };
    let rest = [0, 1, 2].map(|k| p[k] - off[k] * Bounded::exact(factor) + rounded);
    let numerators = [0, 1, 2].map(|i| bounded::dot(&rest, &normals[i]));
    numerators.iter().all(|n| n.is_within(determinant)).then_some(())?;
    let mut coefficients = trail.coefficients(question, &certain.cell(), factor);
    for &(index, share) in &certain.shares {
        coefficients[index] = share * factor;
    }
    let mut basis = vec![certain.basis[0], certain.basis[1], third];
    for (&index, numerator) in basis.iter().zip(numerators) {
        let value = numerator.value / determinant.value;
        coefficients[index] = if negative { -value } else { value };
    }
    basis.sort_unstable();
    Some(Witness { coefficients, basis })
}

/// The attempt with its margin.
fn attempt(question: &Displacement<'_, 3>, certain: &Certain, p: &BoundedVector, attempt: Attempt) -> Attempt {
    let [a, b] = &certain.vectors;
    let c = &question.generator(attempt.third);
    let normals = [cross(b, c), cross(c, a), cross(a, b)];
    let determinant = dot(c, &normals[2]);
    let rest = [0, 1, 2].map(|k| p[k].value - (certain.sum[k].value - attempt.sign * c[k]) * attempt.factor);
    let largest = normals.iter().fold(0.0f64, |m, normal| m.max((dot(&rest, normal) / determinant).abs()));
    // none where the third is in the plane of the others
    Attempt { margin: if determinant == 0.0 { 0.0 } else { 1.0 - largest }, ..attempt }
}

fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::Location;
    use crate::collision::by_lad::reduced::Reduced;
    use crate::collision::verify::verify;

    /// The proof from the vertex of the first two generators, checked exactly.
    fn prove(generators: &[[f64; 3]], p: [f64; 3]) -> Option<Witness> {
        let question = Displacement::new([0.0; 3], p, generators).expect("finite");
        let p = bounded::exact(p);
        let certain = Certain::at(&[Reduced::whole(&question)], &p, [0, 1]).ok()?;
        let witness = witness(&question, &certain, &Trail::default(), &p)?;
        assert_eq!(verify(&question, &Location::Inside(witness.clone())), Ok(()));
        Some(witness)
    }

    const BODY: [[f64; 3]; 6] =
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.1, 1.0], [0.3, 0.0, 1.0], [0.1, -0.2, 1.0], [-0.2, 0.1, 0.7]];

    #[test]
    fn points_below_a_facet_are_proved() {
        let top = BODY[2..].iter().fold([0.0; 3], |sum, v| [0, 1, 2].map(|k| sum[k] + v[k]));
        for (x, y) in [(0.0, 0.0), (0.5, -0.25), (0.999, 0.0), (1.0, 1.0), (-1.0, 0.3)] {
            for factor in [0.5, 0.9, 1.0 - 1e-9] {
                let p = [top[0] + x, top[1] + y, top[2]].map(|c| c * factor);
                let witness = prove(&BODY, p).unwrap_or_else(|| panic!("{x} {y} {factor}"));
                assert!(witness.basis.len() == 3 && witness.basis[..2] == [0, 1], "{witness:?}");
            }
        }
    }

    #[test]
    fn shares_of_a_facet_are_part_of_the_proof() {
        let body: Vec<[f64; 3]> =
            BODY.into_iter().chain([[1.0, 1.0, 0.0], [1.0, -1.0, 0.0], [0.3, 0.0, 0.0]]).collect();
        let top = BODY[2..].iter().fold([0.0; 3], |sum, v| [0, 1, 2].map(|k| sum[k] + v[k]));
        for (x, y) in [(0.0, 0.0), (2.5, 0.7), (-3.2, 0.1), (0.0, 2.9)] {
            let p = [top[0] + x, top[1] + y, top[2]].map(|c| c * 0.99);
            let witness = prove(&body, p).unwrap_or_else(|| panic!("{x} {y}"));
            assert!(witness.basis.iter().all(|index| *index < 6), "{witness:?}");
        }
    }

    #[test]
    fn points_outside_are_not() {
        assert!(prove(&BODY, [0.2, 0.0, 4.0]).is_none());
    }
}
