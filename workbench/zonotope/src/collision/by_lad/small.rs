//! A few generators, as of two boxes: a shortest combination or a direction, whichever proves the status at once.
//!
//! With W = Σ v vᵀ and y = W^{-1} p the coefficients c_i = v_i · y combine to p and are the smallest in the sense of least squares. If all
//! are well within (−1, 1), p is inside. If Σ |c_i| = h(y) is less than y · p = Σ c_i², y separates. Else neither is proved here.

use super::search::rounded_displacement;
use super::support::support;
use crate::collision::{Displacement, Location, Separation, Witness};
use crate::numeric::bounded::{self, Bounded, BoundedVector};

/// Coefficients up to this are well within (−1, 1).
const WELL_WITHIN: f64 = 0.999;

/// The status of p with its proof, if that is found at once.
pub(super) fn locate(question: &Displacement<'_, 3>) -> Option<Location<3>> {
    let p = &rounded_displacement(question);
    let y = shortest(question, p.map(|c| c.value))?;
    let (mut largest, mut reach, mut along) = (0.0f64, 0.0, 0.0);
    for v in question.generators() {
        let c = dot(v, &y);
        largest = largest.max(c.abs());
        reach += c.abs();
        along += c * c;
    }
    if reach < along {
        let [first, second] = question.runs();
        let gap = bounded::dot(p, &bounded::exact(y)) - (support(first, &y) + support(second, &y));
        return gap.is_positive().then_some(Location::Outside(Separation::Rounded(y)));
    }
    if largest < WELL_WITHIN { witness(question, p, &y).map(Location::Inside) } else { None }
}

/// y with W y = p.
fn shortest(question: &Displacement<'_, 3>, p: [f64; 3]) -> Option<[f64; 3]> {
    let [mut xx, mut xy, mut xz, mut yy, mut yz, mut zz] = [0.0; 6];
    for &[x, y, z] in question.generators() {
        (xx, xy, xz) = (xx + x * x, xy + x * y, xz + x * z);
        (yy, yz, zz) = (yy + y * y, yz + y * z, zz + z * z);
    }
    let rows = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
    let inverse = [cross(&rows[1], &rows[2]), cross(&rows[2], &rows[0]), cross(&rows[0], &rows[1])];
    let determinant = dot(&rows[0], &inverse[0]);
    let y = inverse.map(|row| dot(&row, &p) / determinant);
    y.iter().all(|c| c.is_finite()).then_some(y)
}

/// The coefficients c_i, three of which make up for the rounding of the others.
fn witness(question: &Displacement<'_, 3>, p: &BoundedVector, y: &[f64; 3]) -> Option<Witness> {
    let basis = well_spread(question)?;
    let mut coefficients = Vec::with_capacity(question.len());
    let mut rest = *p;
    for (i, v) in question.generators().enumerate() {
        let c = dot(v, y);
        coefficients.push(c);
        if !basis.contains(&i) {
            for (total, coordinate) in rest.iter_mut().zip(v) {
                *total = *total - Bounded::exact(c) * Bounded::exact(*coordinate);
            }
        }
    }
    let [a, b, c] = basis.map(|i| bounded::exact(question.generator(i)));
    let normals = [bounded::cross(&b, &c), bounded::cross(&c, &a), bounded::cross(&a, &b)];
    let determinant = bounded::dot(&a, &normals[0]);
    let determinant = if determinant.value < 0.0 { determinant.negated() } else { determinant };
    normals.iter().all(|n| bounded::dot(&rest, n).is_within(determinant)).then_some(())?;
    let mut basis = basis.to_vec();
    basis.sort_unstable();
    // the coefficients of the basis are c_i but for rounding
    Some(Witness { coefficients, basis })
}

/// Three generators: the longest, the one farthest from its line, the one farthest from the plane of both.
fn well_spread(question: &Displacement<'_, 3>) -> Option<[usize; 3]> {
    let best = |key: &dyn Fn(&[f64; 3]) -> f64| {
        let keyed = question.generators().enumerate().map(|(i, v)| (key(v), i));
        keyed.fold((0.0, usize::MAX), |best, own| if own.0 > best.0 { own } else { best })
    };
    let (_, first) = best(&|v| dot(v, v));
    let a = (first != usize::MAX).then(|| question.generator(first))?;
    let (_, second) = best(&|v| {
        let product = cross(&a, v);
        dot(&product, &product)
    });
    let normal = (second != usize::MAX).then(|| cross(&a, &question.generator(second)))?;
    let (_, third) = best(&|v| dot(&normal, v).abs());
    (third != usize::MAX && third != first && third != second).then_some([first, second, third])
}

fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
