//! A box around points that no small turn makes better.

use super::covering::{Aim, Covering, unit};
use crate::numeric::linear::{cross, dot, euclidean_norm};

/// The axes of coordinates.
pub(super) const AXES: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// The first angle of a turn; the angles that follow are halves of it.
const FIRST_TURN: f64 = 0.4;

/// The number of angles.
const TURNS: usize = 6;

/// Starts of a search: the best of the frames that are looked at.
const STARTS: usize = 2;

/// Of no more points than these, frames along their edges are looked at instead of turned ones: the least box of a
/// polygon has a side along an edge.
const POINTS_OF_A_FACE: usize = 4;

/// The box along orthonormal directions.
pub(super) fn along(points: &[[f64; 3]], axes: [[f64; 3]; 3]) -> Covering {
    let ends = axes.map(|axis| {
        let heights = points.iter().map(|p| dot(p, &axis));
        heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), h| (low.min(h), high.max(h)))
    });
    let mut center = [0.0; 3];
    for (axis, (low, high)) in axes.iter().zip(ends) {
        (0..3).for_each(|k| center[k] += 0.5 * (low + high) * axis[k]);
    }
    let half_lengths = ends.iter().map(|(low, high)| 0.5 * (high - low)).collect();
    Covering { aim: Aim::EXPECTED_OVERLAPS, center, directions: axes.to_vec(), half_lengths }
}

/// A box of few expected overlaps.
pub(super) fn search(points: &[[f64; 3]]) -> Covering {
    let is_face = points.len() <= POINTS_OF_A_FACE;
    let mut starts: Vec<(f64, [[f64; 3]; 3])> = vec![(aim(points, &AXES), AXES)];
    if is_face {
        starts.extend(frames_of_edges(points).map(|axes| (aim(points, &axes), axes)));
    } else {
        let turned = (0..3).map(|axis| turn(&AXES, axis, std::f64::consts::FRAC_PI_4));
        let others = turned.chain(frame_of_extremes(points));
        starts.extend(others.map(|axes| (aim(points, &axes), axes)));
    }
    starts.sort_by(|a, b| a.0.total_cmp(&b.0));
    let improved = starts
        .into_iter()
        .take(STARTS)
        .map(|(value, axes)| if is_face { (value, axes) } else { improve(points, value, axes) });
    let best = improved.min_by(|a, b| a.0.total_cmp(&b.0));
    along(points, best.expect("the axes are a start").1)
}

/// The frames of an edge and the plane of a triangle, for all triples of points.
fn frames_of_edges(points: &[[f64; 3]]) -> impl Iterator<Item = [[f64; 3]; 3]> {
    let count = points.len();
    let triples = (0..count).flat_map(move |i| (0..i).flat_map(move |j| (0..count).map(move |k| [i, j, k])));
    triples.filter_map(|[i, j, k]| {
        let away = |p: usize, q: usize| -> [f64; 3] { std::array::from_fn(|axis| points[p][axis] - points[q][axis]) };
        let edge = away(i, j);
        let along = unit(&edge)?;
        let normal = unit(&cross(&along, &away(k, i)))?;
        Some([along, normal, cross(&along, &normal)])
    })
}

/// The expected overlaps of the box along some axes.
fn aim(points: &[[f64; 3]], axes: &[[f64; 3]; 3]) -> f64 {
    let [a, b, c] = axes.map(|axis| {
        let heights = points.iter().map(|p| dot(p, &axis));
        let (low, high) = heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), h| (h.min(low), h.max(high)));
        0.5 * (high - low)
    });
    8.0 * (a + b + c) * (a * b + b * c + c * a) + 16.0 * a * b * c
}

/// Axes turned about one of them.
fn turn(axes: &[[f64; 3]; 3], about: usize, angle: f64) -> [[f64; 3]; 3] {
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    let [i, j] = [(about + 1) % 3, (about + 2) % 3];
    let mut turned = *axes;
    turned[i] = std::array::from_fn(|k| cos * axes[i][k] + sin * axes[j][k]);
    turned[j] = std::array::from_fn(|k| cos * axes[j][k] - sin * axes[i][k]);
    turned
}

fn improve(points: &[[f64; 3]], mut value: f64, mut axes: [[f64; 3]; 3]) -> (f64, [[f64; 3]; 3]) {
    let mut angle = FIRST_TURN;
    for _ in 0..TURNS {
        let mut steps = 0;
        let mut is_better = true;
        while is_better && steps < 8 {
            is_better = false;
            steps += 1;
            for about in 0..3 {
                for signed in [angle, -angle] {
                    let turned = turn(&axes, about, signed);
                    let found = aim(points, &turned);
                    if found < value {
                        (value, axes, is_better) = (found, turned, true);
                    }
                }
            }
        }
        angle *= 0.5;
    }
    (value, axes)
}

/// The frame of a longest difference, as two sweeps find it, and the point farthest from that line.
fn frame_of_extremes(points: &[[f64; 3]]) -> Option<[[f64; 3]; 3]> {
    let away = |p: &[f64; 3], q: &[f64; 3]| -> [f64; 3] { std::array::from_fn(|k| p[k] - q[k]) };
    let farthest = |from: &[f64; 3]| {
        let distance = |p: &[f64; 3]| euclidean_norm(&away(p, from));
        points.iter().copied().max_by(|p, q| distance(p).total_cmp(&distance(q)))
    };
    let first = farthest(points.first()?)?;
    let second = farthest(&first)?;
    let along = unit(&away(&second, &first))?;
    let off = |p: &[f64; 3]| cross(&along, &away(p, &first));
    let side = points.iter().map(off).max_by(|a, b| euclidean_norm(a).total_cmp(&euclidean_norm(b)))?;
    let normal = unit(&side)?;
    Some([along, normal, cross(&along, &normal)])
}
