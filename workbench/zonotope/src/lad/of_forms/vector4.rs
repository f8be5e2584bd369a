//! Vectors of R^4 with exact coordinates.

use crate::numeric::dyadic::{Dyadic, remove_common_factor};

/// An exact vector: a point of space in homogeneous coordinates, or the linear form that vanishes on a plane.
pub(crate) type Vector4 = [Dyadic; 4];

pub(crate) fn dot4([a, b, c, d]: &Vector4, [e, f, g, h]: &Vector4) -> Dyadic {
    a * e + b * f + c * g + d * h
}

/// The vector product of three vectors, orthogonal to each: zero if and only if they are dependent.
pub(super) fn cross4(a: &Vector4, b: &Vector4, c: &Vector4) -> Vector4 {
    // The six minors of the last two rows.
    let minor = |i: usize, j: usize| &b[i] * &c[j] - &b[j] * &c[i];
    let [m01, m02, m03] = [minor(0, 1), minor(0, 2), minor(0, 3)];
    let [m12, m13, m23] = [minor(1, 2), minor(1, 3), minor(2, 3)];
    [
        &a[1] * &m23 - &a[2] * &m13 + &a[3] * &m12,
        -(&a[0] * &m23 - &a[2] * &m03 + &a[3] * &m02),
        &a[0] * &m13 - &a[1] * &m03 + &a[3] * &m01,
        -(&a[0] * &m12 - &a[1] * &m02 + &a[2] * &m01),
    ]
}

pub(super) fn is_zero4(a: &Vector4) -> bool {
    a.iter().all(Dyadic::is_zero)
}

pub(super) fn negated4(a: Vector4) -> Vector4 {
    a.map(|v| -v)
}

/// a + factor · b.
pub(super) fn plus_multiple(a: &Vector4, factor: &Dyadic, b: &Vector4) -> Vector4 {
    std::array::from_fn(|k| &a[k] + &(factor * &b[k]))
}

/// The vector divided by the common factor of its coordinates, which keeps the numbers of a long descent short.
pub(super) fn primitive(mut a: Vector4) -> Vector4 {
    remove_common_factor(&mut a);
    a
}
