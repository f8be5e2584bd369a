//! Views of bodies of several dimensions on a page: what the pictures of the commands share.

use figures::style::{Color, INK, INPUT, PAPER};
use zonotope::numeric::dyadic::Dyadic;
use zonotope::zonotope::Zonotope;
use zonotope::zonotope::faces::{FaceLattice, Faces, faces};

/// Of bodies with more generators only the outline is drawn.
pub(super) const LATTICE_GENERATOR_LIMIT: usize = 120;

/// From where a body of space is seen: a unit vector.
pub(super) const EYE: [f64; 3] = [0.48, 0.6, 0.64];

/// The part of the way to white of the facet that faces the eye and of one seen from its edge, in 1/256.
const SHADES: [f64; 2] = [235.0, 120.0];

/// A change of scale by a power of two, after which a body is about as large as 1.
#[derive(Clone, Copy)]
pub(super) struct Shrinking(i64);

/// The change of scale for a body with the given generators.
pub(super) fn shrinking(generators: &[Vec<f64>]) -> Shrinking {
    let dimension = generators.first().map_or(0, Vec::len);
    let reach = |axis: usize| {
        let sum = |sum: Dyadic, generator: &Vec<f64>| sum + Dyadic::from_f64(generator[axis]).abs();
        generators.iter().fold(Dyadic::zero(), sum).binary_exponent()
    };
    Shrinking(-(0..dimension).filter_map(reach).max().unwrap_or(0))
}

impl Shrinking {
    /// The vector in the new scale.
    pub(super) fn vector(self, v: &[f64]) -> Vec<f64> {
        v.iter().map(|&x| Dyadic::from_f64(x).scaled(self.0).to_f64()).collect()
    }

    /// The difference of two points in the new scale.
    pub(super) fn difference(self, to: &[f64], from: &[f64]) -> Vec<f64> {
        let along = |(&to, &from): (&f64, &f64)| Dyadic::from_f64(to) - Dyadic::from_f64(from);
        to.iter().zip(from).map(along).map(|x| x.scaled(self.0).to_f64()).collect()
    }
}

/// Two orthonormal vectors that span the page: across and up.
pub(super) fn axes(dimension: usize) -> [Vec<f64>; 2] {
    let unit = |axis: usize| (0..dimension).map(|other| f64::from(u8::from(other == axis))).collect::<Vec<_>>();
    match dimension {
        1 => [unit(0), vec![0.0]],
        2 => [unit(0), unit(1)],
        3 => {
            let [x, y, z] = EYE;
            let flat = (x * x + y * y).sqrt();
            [vec![-y / flat, x / flat, 0.0], vec![-x * z / flat, -y * z / flat, flat]]
        }
        // Across and up wind around all the coordinate axes, so that none is seen from its end.
        _ => {
            let across: Vec<f64> = (0..dimension).map(|axis| turn(axis, dimension, 0.0)).collect();
            let up: Vec<f64> = (0..dimension).map(|axis| turn(axis, dimension, 0.5)).collect();
            let scale = (2.0 / dimension as f64).sqrt();
            [across, up].map(|axis| axis.into_iter().map(|x| x * scale).collect())
        }
    }
}

/// The cosine of π (axis / dimension − shift): over all axes the squares add up to half the dimension.
fn turn(axis: usize, dimension: usize, shift: f64) -> f64 {
    libm::cos(std::f64::consts::PI * (axis as f64 / dimension as f64 - shift))
}

/// The faces of a body of space, if they are few enough to be seen.
pub(super) fn lattice(generators: &[Vec<f64>]) -> Option<FaceLattice> {
    if generators.len() > LATTICE_GENERATOR_LIMIT {
        return None;
    }
    let space = generators.iter().map(|generator| <[f64; 3]>::try_from(generator.as_slice()).ok());
    let body = Zonotope::new([0.0; 3], space.collect::<Option<_>>()?).ok()?;
    match faces(&body, &mut ()) {
        Ok(Faces::Flat(lattice) | Faces::Solid(lattice)) => Some(lattice),
        _ => None,
    }
}

/// The turn of a polygon of space to the eye: the cosine of the angle of its normal, by twice its area.
pub(super) fn facing(corners: &[[f64; 3]]) -> f64 {
    let mut normal = [0.0; 3];
    for (a, b) in corners.iter().zip(corners.iter().cycle().skip(1)) {
        let [a, b] = [a, b].map(|p| [p[0] - corners[0][0], p[1] - corners[0][1], p[2] - corners[0][2]]);
        normal[0] += a[1] * b[2] - a[2] * b[1];
        normal[1] += a[2] * b[0] - a[0] * b[2];
        normal[2] += a[0] * b[1] - a[1] * b[0];
    }
    let dot = |u: &[f64; 3], v: &[f64; 3]| u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
    let length = dot(&normal, &normal).sqrt();
    if length > 0.0 { dot(&normal, &EYE) / length } else { 0.0 }
}

/// The colour of a facet that is turned to the eye so far.
pub(super) fn shade(facing: f64) -> Color {
    let part = SHADES[1] + (SHADES[0] - SHADES[1]) * facing.clamp(0.0, 1.0);
    INK.mixed(INPUT, 160).mixed(PAPER, part as u16)
}
