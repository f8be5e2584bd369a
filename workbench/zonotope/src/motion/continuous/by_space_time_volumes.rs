//! The first contact of two moving bodies, by zonotopes around the volumes that they sweep.
//!
//! # Statement
//! Input: two zonotopes of space, a motion of each, a resolution. Output: when they meet first, as [`FirstContact`]
//! has it.
//!
//! # Source
//! Section 6 and Theorem 6.1, with the generators of the translation and of the disc as they must be.
//!
//! # Method
//! A body that turns by θ about an axis while its base goes along v stays within its first placement, a square about
//! the disc of radius 2 r sin(θ/2) across the axis, r the distance of its farthest point from the axis, and the segment
//! from 0 to v: a zonotope of n + 3 generators. Bodies whose volumes are disjoint do not meet on the stretch; else it
//! is
//! halved.
//!
//! # Complexity
//! O(n log n) a stretch for the farthest vertex of the projected body. A clearance ε takes some 1/ε stretches where the
//! bodies pass each other side by side.
//!
//! # Shapes
//! `bodies`: two zonotopes of space with any number of generators; times in [0, 1].
//!
//! # Numerics
//! Volumes are doubles that are made larger by more than their rounding; volumes and contacts are decided exactly.
//!
//! # Errors
//! None.
//!
//! # Panics
//! Never.
//!
//! # Checked by
//! The first contact by control points, and exact gaps of its directions.
//!
//! # Example
//! ```
//! use zonotope::{Zonotope, motion::Motion};
//! use zonotope::motion::continuous::{FirstContact, by_space_time_volumes::first_contact_counted};
//! let cube = Zonotope::new([0.0; 3], vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]).expect("finite");
//! let other = cube.translated([6.0, 0.0, 0.0]).expect("finite");
//! let right = Motion::translation([8.0, 0.0, 0.0]).expect("finite");
//! // faces that are 4 apart meet when half of 8 is gone
//! let found = first_contact_counted([&cube, &other], [&right, &Motion::rest()], 1e-6, &mut ());
//! let FirstContact::Contact { time: [before, met], .. } = found else { panic!("they meet") };
//! assert!(before < 0.5 && 0.5 <= met && met - before <= 1e-6);
//! ```

use super::FirstContact;
use super::bisection::{self, Bound};
use super::body::Body;
use super::gap::Stretch;
use super::ordinary_sizes;
use super::rates::Rates;
use super::scene::Scene;
use crate::collision::by_lad::locate;
use crate::collision::{Location, Separation};
use crate::motion::Motion;
use crate::motion::arc::Arc;
use crate::motion::quaternion::{composition, conjugate, image, polar_rotation};
use crate::numeric::bounded::Bounded;
use crate::numeric::linear::{cross, dot, euclidean_norm};
use crate::numeric::tolerance::RATE_ROUNDING;
use crate::tally::{Operation, OperationCounts, Tally};
use crate::zonotope::Zonotope;
use crate::zonotope::query::Query;

/// When two moving bodies meet first during the time from 0 to 1, within a resolution; counting operations.
pub fn first_contact_counted(
    bodies: [&Zonotope<3>; 2],
    motions: [&Motion; 2],
    resolution: f64,
    tally: &mut dyn Tally,
) -> FirstContact {
    ordinary_sizes::first_contact(bodies, motions, |scene| {
        bisection::first_contact(&scene, &Volumes, resolution, tally)
    })
}

struct Volumes;

impl Bound for Volumes {
    fn proof(
        &self,
        scene: &Scene<'_>,
        stretch: &Stretch<'_, Bounded>,
        times: [f64; 2],
        _: &[[f64; 3]],
        tally: &mut dyn Tally,
    ) -> Option<[f64; 3]> {
        let [a, b] = [0, 1].map(|i| volume(&stretch.bodies[i], &stretch.arcs[i].rounded(), scene.margin(times)));
        let (a, b) = (a?, b?);
        let mut counts = OperationCounts::default();
        let location = locate(&Query::between(&a, &b), &mut counts);
        let generators = (a.generators().len() + b.generators().len()).max(1) as u64;
        let passes = counts.get(Operation::GeneratorRead).div_ceil(generators).max(1);
        tally.add(Operation::SupportEvaluation, 2 * passes);
        match location {
            Location::Outside(Separation::Rounded(u)) => Some(u),
            _ => None,
        }
    }
}

/// A zonotope around all placements of a body on a stretch; `None` where it leaves the range of doubles.
fn volume(body: &Body<'_>, arc: &Arc<f64>, margin: f64) -> Option<Zonotope<3>> {
    let [turn, _] = &arc.turns;
    let square = dot(turn, turn);
    let rotation = polar_rotation(turn, turn).map(|row| row.map(|c| c / square));
    let arm = arc.arm_of(&body.center()).map(|c| c / arc.weight);
    let base = arc.base[0].map(|c| c / arc.weight);
    let Rates { axis, angle, travel, .. } = Rates::of(arc, body);
    let size = body.magnitude() + [arm, base, travel].as_flattened().iter().map(|c| c.abs()).sum::<f64>();
    // more than all roundings and the margin, in each direction
    let pad = (RATE_ROUNDING - 1.0) * size + margin;
    let place = image(&rotation, &arm);
    let mut generators: Vec<[f64; 3]> = body.generators().iter().map(|g| image(&rotation, g)).collect();
    let mut disc = 0.0;
    if angle != 0.0 {
        let [_, x, y, z] = composition(&conjugate(turn), &arc.turns[1]);
        let chord = if angle < std::f64::consts::PI { libm::sin(angle / 2.0) } else { 1.0 };
        disc = 2.0 * chord * farthest_from_axis(body.generators(), &arm, [x, y, z]) * RATE_ROUNDING;
    }
    let [across, other, along] = frame(axis);
    generators.extend([across, other].map(|v| v.map(|c| c * (disc + pad))));
    generators.push(along.map(|c| c * pad));
    generators.push(travel.map(|c| c / 2.0));
    let center = [0, 1, 2].map(|k| base[k] + place[k] + travel[k] / 2.0);
    Zonotope::new(center, generators).ok()
}

/// An orthonormal frame of which the last vector is along an axis, or any frame if that is zero.
fn frame(axis: [f64; 3]) -> [[f64; 3]; 3] {
    if axis == [0.0; 3] {
        return [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    }
    let least = (0..3).min_by(|&i, &j| axis[i].abs().total_cmp(&axis[j].abs())).unwrap_or(0);
    let mut unit = [0.0; 3];
    unit[least] = 1.0;
    let across = cross(&axis, &unit);
    let length = euclidean_norm(&across);
    let across = across.map(|c| c / length);
    [across, cross(&axis, &across), axis]
}

/// How far the farthest point of a body with a centre is from an axis through the origin: it is a vertex of the
/// projected body.
fn farthest_from_axis(generators: &[[f64; 3]], center: &[f64; 3], axis: [f64; 3]) -> f64 {
    let length = euclidean_norm(&axis);
    let [x, y, _] = frame(axis.map(|c| c / length));
    let projected = |v: &[f64; 3]| [dot(&x, v), dot(&y, v)];
    let mut edges: Vec<[f64; 2]> = generators
        .iter()
        .map(projected)
        .map(|[x, y]| if y < 0.0 || (y == 0.0 && x < 0.0) { [-x, -y] } else { [x, y] })
        .collect();
    edges.sort_by(|a, b| (b[0] * a[1]).total_cmp(&(a[0] * b[1])));
    let center = projected(center);
    // from the lowest vertex along the edges in the order of their angles; the other half is that of the negatives
    let mut vertex = edges.iter().fold([0.0; 2], |sum, e| [sum[0] - e[0], sum[1] - e[1]]);
    let mut farthest = 0.0f64;
    let mut look = |vertex: [f64; 2]| {
        for sign in [1.0, -1.0] {
            farthest = farthest.max(euclidean_norm(&[center[0] + sign * vertex[0], center[1] + sign * vertex[1], 0.0]));
        }
    };
    look(vertex);
    for edge in &edges {
        vertex = [vertex[0] + 2.0 * edge[0], vertex[1] + 2.0 * edge[1]];
        look(vertex);
    }
    farthest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_farthest_vertex_of_a_box_is_a_corner() {
        let generators = [[3.0, 0.0, 0.0], [0.0, 0.0, 7.0], [0.0, -4.0, 0.0]];
        assert!((farthest_from_axis(&generators, &[0.0; 3], [0.0, 0.0, 2.0]) - 5.0).abs() < 1e-12);
        assert!((farthest_from_axis(&generators, &[3.0, 4.0, 9.0], [0.0, 0.0, 2.0]) - 10.0).abs() < 1e-12);
    }
}
