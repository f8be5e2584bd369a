//! The lowest point of the objective along an edge: a weighted median, proposed in floating point and proved exactly.

use rand::RngExt;
use rand_pcg::Pcg64Mcg;

use super::instance::{Instance, Probe, Product};
use super::vertex::{Plane, Vertex};
use crate::numeric::weighted_median::weighted_median;
use crate::tally::{Operation, Tally};

/// Number of wrong proposals of floating point after which proposals are drawn at random, so that half of the planes
/// are expected to go with each.
const TRUSTED_PROPOSALS: u32 = 6;

/// A plane that the edge crosses ahead of the vertex.
#[derive(Debug, Clone, Copy)]
struct Crossing {
    place: f64,
    rate: f64,
    plane: u32,
}

/// The lowest vertex along a direction on the two kept planes; `None` if the objective falls without end.
///
/// The slope at the start is negative, and `start_slope` when rounded.
///
/// The slope grows by 2 |f · direction| at each plane that is crossed. A proposed vertex is tested by the exact slopes
/// on both its sides; a vertex that fails leaves only the planes before it or those behind it.
pub(super) fn lowest(
    instance: &Instance,
    start: &Vertex,
    kept: &[Plane; 2],
    direction: &Probe,
    start_slope: f64,
    random: &mut Pcg64Mcg,
    tally: &mut impl Tally,
) -> Option<Vertex> {
    tally.add(Operation::SearchStep, 1);
    let mut ahead = crossings(instance, start, direction, tally);
    let mut slope = start_slope;
    for proposal in 0.. {
        if ahead.is_empty() {
            return None;
        }
        let chosen = match proposal < TRUSTED_PROPOSALS {
            true => {
                let (places, gains): (Vec<f64>, Vec<f64>) = ahead.iter().map(|c| (c.place, 2.0 * c.rate)).unzip();
                ahead[weighted_median(&places, &gains, -slope)?]
            }
            false => ahead[random.random_range(0..ahead.len())],
        };
        let plane = Plane { index: Some(chosen.plane), form: instance.form(chosen.plane as usize) };
        let vertex = Vertex::new(instance, [plane, kept[0].clone(), kept[1].clone()], tally);
        let [(forward, falls_on), (_, falls_back)] = vertex.slopes(instance, direction, tally);
        let is_passed = |crossing: &Crossing| {
            let i = crossing.plane as usize;
            (vertex.signs[i] != 0).then(|| vertex.signs[i] != start.signs[i])
        };
        if falls_on {
            slope = forward;
            ahead.retain(|crossing| is_passed(crossing) == Some(false));
        } else if falls_back {
            ahead.retain(|crossing| is_passed(crossing) == Some(true));
        } else {
            return Some(vertex);
        }
    }
    None
}

/// The planes that the direction crosses ahead of the start. One pass.
fn crossings(instance: &Instance, start: &Vertex, direction: &Probe, tally: &mut impl Tally) -> Vec<Crossing> {
    tally.add(Operation::LineEvaluation, instance.len() as u64);
    let mut ahead = Vec::new();
    for (i, &side) in start.signs.iter().enumerate().filter(|(_, side)| **side != 0) {
        let Product { value: rate, sign, .. } = instance.product(i, direction);
        if sign == -side {
            let place = (instance.product(i, &start.point).value / rate).abs();
            let place = if place.is_nan() { f64::INFINITY } else { place };
            ahead.push(Crossing { place, rate: rate.abs(), plane: i as u32 });
        }
    }
    ahead
}
