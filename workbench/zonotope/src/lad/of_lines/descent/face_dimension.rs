//! The dimension of the set of minimisers at an optimal vertex.

use super::cone::Cone;
use super::solution::Optimal;
use crate::lad::of_lines::subproblem::Subproblem;
use crate::numeric::dyadic::Dyadic;

/// The dimension of the set of minimisers at a vertex: of the cone of directions along which the objective is constant.
///
/// The objective grows by Σ (|normal · u| − δ normal · u) in direction u, a sum of terms that are never negative. It is
/// zero if and only if δ normal · u ≥ 0 for each line with |δ| = 1 and normal · u = 0 for each line with |δ| < 1.
pub(super) fn face_dimension(through: &Subproblem, optimal: &Optimal) -> u8 {
    let normals: Vec<_> = optimal.basis.iter().map(|&line| through.exact_line(line).normal).collect();
    let mut cone = Cone::Plane;
    for (line, &sign) in optimal.signs.iter().enumerate().filter(|(_, sign)| **sign != 0) {
        cone = cone.clip(&turned(through.exact_line(line as u32).normal, sign));
        if cone.dimension() == 0 {
            return 0;
        }
    }
    let gradient = through.exact_gradient(&optimal.signs);
    for (own, other) in [(0, 1), (1, 0)].into_iter().take(normals.len()) {
        let sign = basis_sign(&gradient, &normals[own], normals.get(other));
        let sides: &[i8] = if sign == 0 { &[1, -1] } else { &[sign] };
        for &side in sides {
            cone = cone.clip(&turned(normals[own].clone(), side));
        }
    }
    cone.dimension()
}

/// The coefficient of a basis line, given both normals of the basis, if it is 1 or −1, else 0.
fn basis_sign(gradient: &[Dyadic; 2], own: &[Dyadic; 2], other: Option<&[Dyadic; 2]>) -> i8 {
    let across = other.map_or_else(|| own.clone(), |[x, y]| [-y.clone(), x.clone()]);
    let along = |v: &[Dyadic; 2]| &v[0] * &across[0] + &v[1] * &across[1];
    let (rest, own) = (along(gradient), along(own));
    if rest.clone().abs() != own.clone().abs() { 0 } else { -(rest.sign() as i8) * own.sign() as i8 }
}

fn turned(normal: [Dyadic; 2], sign: i8) -> [Dyadic; 2] {
    if sign < 0 { normal.map(|v| -v) } else { normal }
}
