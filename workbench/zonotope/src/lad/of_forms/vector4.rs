//! Vectors of R^4 with exact coordinates.

use crate::numeric::dyadic::{Dyadic, remove_common_factor};
use crate::numeric::exact_linear::hyperplane_normal;

/// An exact vector: a point of space in homogeneous coordinates, or the linear form that vanishes on a plane.
pub(crate) type Vector4 = [Dyadic; 4];

/// The vector product of three vectors, orthogonal to each: zero if and only if they are dependent.
pub(super) fn cross4(a: &Vector4, b: &Vector4, c: &Vector4) -> Vector4 {
    let normal = hyperplane_normal(&[&a[..], &b[..], &c[..]]);
    normal.try_into().expect("three vectors of R^4 have a normal in R^4")
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
