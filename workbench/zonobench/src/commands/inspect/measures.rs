//! Quick measures of a body.

use zonotope::numeric::dyadic::Dyadic;
use zonotope::zonotope::{Directions, Zonotope};

use crate::input::{Body, Placed};

/// More generators than this have too many pairs for the surface area.
const PAIRED_GENERATOR_LIMIT: usize = 20_000;

/// Sizes of a body, rounded.
pub(super) struct Measures {
    /// The ends of the bounding box along each axis.
    pub(super) bounds: Vec<[f64; 2]>,
    /// The number of generators that are zero, and that of the directions of the others.
    pub(super) zeros: usize,
    pub(super) directions: usize,
    /// Σ of the generators' lengths.
    pub(super) total_length: f64,
    /// The area of the boundary, in space.
    pub(super) surface_area: Option<f64>,
}

impl Measures {
    /// Measures a body whose vectors have D coordinates, and its image in doubles.
    pub(super) fn of<const D: usize>(placed: &Placed, body: &Body) -> Self {
        let fixed = |v: &Vec<f64>| -> [f64; D] { std::array::from_fn(|axis| v[axis]) };
        let generators: Vec<[f64; D]> = body.generators.iter().map(fixed).collect();
        // A regular matrix keeps which generators are parallel, which rounding its products may not.
        let is_regular = placed.pose.as_ref().is_none_or(|pose| !pose.exact().determinant().is_zero());
        let own: Vec<[f64; D]> = placed.body.generators.iter().map(fixed).collect();
        let lines = if is_regular { &own } else { &generators };
        let zeros = lines.iter().filter(|generator| **generator == [0.0; D]).count();
        let directions = Directions::new(lines).expect("the file was read as finite numbers").len();
        let exact = placed.exact();
        let side = |axis: usize| {
            let sum = |sum: Dyadic, generator: &Vec<Dyadic>| sum + generator[axis].clone().abs();
            let reach = exact.generators.iter().fold(Dyadic::zero(), sum);
            let center = &exact.center[axis];
            [(center - &reach).to_f64(), (center + &reach).to_f64()]
        };
        let bounds = (0..D).map(side).collect();
        let space = |v: &Vec<f64>| <[f64; 3]>::try_from(v.as_slice()).ok();
        let in_space: Option<Vec<[f64; 3]>> =
            if generators.len() <= PAIRED_GENERATOR_LIMIT { body.generators.iter().map(space).collect() } else { None };
        let surface_area = in_space
            .filter(|_| D == 3)
            .and_then(|generators| Zonotope::new([0.0; 3], generators).ok())
            .map(|body| body.surface_area().value);
        let body = Zonotope::new([0.0; D], generators).expect("the file was read as finite numbers");
        let total_length = body.total_length();
        Self { bounds, zeros, directions, total_length, surface_area }
    }
}
