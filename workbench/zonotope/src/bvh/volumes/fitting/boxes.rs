//! A box around points that no small turn makes better.

use super::covering::{Aim, Covering, unit};
use super::normals::reaches;
use crate::numeric::linear::{cross, euclidean_norm};

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
    let ends = reaches(points, &axes);
    let mut center = [0.0; 3];
    for (axis, [low, high]) in axes.iter().zip(ends) {
        (0..3).for_each(|k| center[k] += 0.5 * (low + high) * axis[k]);
    }
    let half_lengths = ends.iter().map(|[low, high]| 0.5 * (high - low)).collect();
    Covering { aim: Aim::EXPECTED_OVERLAPS, center, directions: axes.to_vec(), half_lengths }
}

/// A box of few expected overlaps.
pub(super) fn search(points: &[[f64; 3]]) -> Covering {
    let is_face = points.len() <= POINTS_OF_A_FACE;
    let mut starts: Vec<(f64, [[f64; 3]; 3])> = vec![(aim(points, &AXES), AXES)];
    if is_face {
        starts.extend(frames_of_edges(points).map(|axes| (aim(points, &axes), axes)));
    } else {
        let eighth = std::f64::consts::FRAC_PI_4;
        let turned = (0..3).map(|axis| turn(&AXES, axis, [libm::sin(eighth), libm::cos(eighth)]));
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
    expected_overlaps(half_lengths(points, axes))
}

/// The expected overlaps of a box with three half-lengths.
fn expected_overlaps([a, b, c]: [f64; 3]) -> f64 {
    8.0 * (a + b + c) * (a * b + b * c + c * a) + 16.0 * a * b * c
}

/// Half of how far points reach along each of some directions of unit length.
fn half_lengths<const N: usize>(points: &[[f64; 3]], directions: &[[f64; 3]; N]) -> [f64; N] {
    reaches(points, directions).map(|[low, high]| 0.5 * (high - low))
}

/// Axes turned about one of them by an angle with a sine and a cosine.
fn turn(axes: &[[f64; 3]; 3], about: usize, [sin, cos]: [f64; 2]) -> [[f64; 3]; 3] {
    let [i, j] = others(about);
    let mut turned = *axes;
    turned[i] = std::array::from_fn(|k| cos * axes[i][k] + sin * axes[j][k]);
    turned[j] = std::array::from_fn(|k| cos * axes[j][k] - sin * axes[i][k]);
    turned
}

/// The axes that a turn about one of them moves.
fn others(about: usize) -> [usize; 2] {
    [(about + 1) % 3, (about + 2) % 3]
}

/// The turns of axes about each of them, by an angle and back, with the half-lengths of both axes that each moves: one
/// pass over the points measures all of them, as most turns are no better.
fn turns(points: &[[f64; 3]], axes: &[[f64; 3]; 3], [sin, cos]: [f64; 2]) -> [(usize, [[f64; 3]; 3], [f64; 2]); 6] {
    let about = |at: usize| at / 2;
    let turned: [[[f64; 3]; 3]; 6] =
        std::array::from_fn(|at| turn(axes, about(at), [if at % 2 == 0 { sin } else { -sin }, cos]));
    let moved: [[f64; 3]; 12] = std::array::from_fn(|k| turned[k / 2][others(about(k / 2))[k % 2]]);
    let lengths = half_lengths(points, &moved);
    std::array::from_fn(|at| (about(at), turned[at], [lengths[2 * at], lengths[2 * at + 1]]))
}

fn improve(points: &[[f64; 3]], mut value: f64, mut axes: [[f64; 3]; 3]) -> (f64, [[f64; 3]; 3]) {
    let mut lengths = half_lengths(points, &axes);
    let mut angle = FIRST_TURN;
    for _ in 0..TURNS {
        let sin_cos = [libm::sin(angle), libm::cos(angle)];
        let mut steps = 0;
        let mut is_better = true;
        while is_better && steps < 8 {
            is_better = false;
            steps += 1;
            let mut all = turns(points, &axes, sin_cos);
            for at in 0..all.len() {
                let (about, turned, [first, second]) = all[at];
                let [i, j] = others(about);
                let mut changed = lengths;
                (changed[i], changed[j]) = (first, second);
                let found = expected_overlaps(changed);
                if found < value {
                    (value, axes, lengths, is_better) = (found, turned, changed, true);
                    if at + 1 < all.len() {
                        all = turns(points, &axes, sin_cos);
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
