//! Few directions of generators: a dictionary from which the worst are dropped, then changes one at a time.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::covering::{Aim, Covering, unit};
use super::descent::descend;
use crate::numeric::linear::{cross, dot, euclidean_norm};
use crate::seed::DEFAULT_SEED;

/// Of fewer points than this, more than three generators gain little: the least cover of a triangle with a centre has
/// twice its area.
const FEWEST_POINTS: usize = 8;

/// A change must gain this share to be taken.
const LEAST_GAIN: f64 = 1e-4;

/// Corners at which edges are looked for.
const CORNERS: usize = 64;

/// Directions of edges in a dictionary.
const EDGES: usize = 4;

/// Directions of a dictionary are apart by at least the angle of this sine.
const LEAST_SINE: f64 = 0.15;

/// Steps of a descent after the first fit.
const STEPS: usize = 5;

/// Steps of a descent from a changed direction.
const STEPS_OF_A_CHANGE: usize = 8;

/// Half-lengths below this share of the longest are dropped from a dictionary together.
const UNUSED: f64 = 1e-6;

/// A zonotope of at most `count` generators that is no worse than a box.
pub(super) fn search(points: &[[f64; 3]], start: Covering, count: usize, effort: usize) -> Covering {
    let count = if points.len() < FEWEST_POINTS { 3 } else { count };
    let found = (count > 3).then(|| from_dictionary(points, &start.directions, count)).flatten();
    let best = found.filter(|found| found.value() < start.value()).unwrap_or(start);
    improve(points, descend(points, best, STEPS), count, effort)
}

/// A zonotope of at most `most` generators that is no worse than a box, of as many generators as the predicted cost of
/// a question is least with: `cost_of_test` tells that of a test of a node with so many.
///
/// The number is chosen among the coverings that a dictionary leaves, before any descent: a descent from each of them
/// would take as long as the fits of all these numbers.
pub(super) fn search_by_cost(
    points: &[[f64; 3]],
    start: Covering,
    most: usize,
    cost_of_test: impl Fn(usize) -> f64,
    effort: usize,
) -> Covering {
    // the square, as a pair of nodes is tested where its parents overlap, whose volumes are fitted in the same way
    let cost = |covering: &Covering| covering.value().powi(2) * cost_of_test(covering.directions.len());
    let mut best = start;
    if points.len() >= FEWEST_POINTS {
        let mut next = from_dictionary(points, &best.directions, most);
        while let Some(found) = next.filter(|found| found.directions.len() > 3) {
            next = without_one(points, &found);
            if cost(&found) < cost(&best) {
                best = found;
            }
        }
    }
    let count = best.directions.len();
    improve(points, descend(points, best, STEPS), count, effort)
}

/// The axes of a box with the diagonals of its faces, and the most frequent directions between nearest points, mostly
/// those of edges of the hull.
fn dictionary(points: &[[f64; 3]], axes: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let mut directions = axes.to_vec();
    for (i, j) in [(0, 1), (1, 2), (2, 0)] {
        for sign in [1.0, -1.0] {
            directions.extend(unit(&std::array::from_fn(|k| axes[i][k] + sign * axes[j][k])));
        }
    }
    let mut edges: Vec<([f64; 3], f64)> = Vec::new();
    for corner in points.iter().take(CORNERS) {
        let Some((edge, length)) = edge_at(points, corner) else { continue };
        let is_near = |other: &[f64; 3]| euclidean_norm(&cross(other, &edge)) < LEAST_SINE;
        match edges.iter_mut().find(|(other, _)| is_near(other)) {
            Some((_, total)) => *total += length,
            None => edges.push((edge, length)),
        }
    }
    edges.sort_by(|a, b| b.1.total_cmp(&a.1));
    for (edge, _) in edges.into_iter().take(EDGES) {
        if directions.iter().all(|other| euclidean_norm(&cross(other, &edge)) >= LEAST_SINE) {
            directions.push(edge);
        }
    }
    directions
}

/// The covering along the dictionary's directions, of which the one that costs least is dropped until few are left.
fn from_dictionary(points: &[[f64; 3]], axes: &[[f64; 3]], count: usize) -> Option<Covering> {
    let mut found = Covering::along(Aim::EXPECTED_OVERLAPS, points, &dictionary(points, axes))?;
    found = without_unused(points, &found, count).unwrap_or(found);
    while found.directions.len() > count {
        found = without_one(points, &found)?;
    }
    Some(found)
}

/// The covering without the direction that costs least, or the next one whose others span space.
fn without_one(points: &[[f64; 3]], covering: &Covering) -> Option<Covering> {
    let weights = covering.weights();
    let share = |k: usize| covering.half_lengths[k] * weights[k];
    let mut order: Vec<usize> = (0..weights.len()).collect();
    order.sort_by(|&i, &j| share(i).total_cmp(&share(j)));
    order.into_iter().find_map(|dropped| with_some(points, covering, |k| k != dropped))
}

/// The covering along those of its directions that `is_kept` keeps.
fn with_some(points: &[[f64; 3]], covering: &Covering, is_kept: impl Fn(usize) -> bool) -> Option<Covering> {
    let kept = || (0..covering.directions.len()).filter(|&k| is_kept(k));
    let directions: Vec<[f64; 3]> = kept().map(|k| covering.directions[k]).collect();
    let weights = covering.weights();
    Covering::with_weights(covering.aim, points, &directions, kept().map(|k| weights[k]).collect())
}

/// The covering along the directions that it uses, if they are still as many as wanted.
fn without_unused(points: &[[f64; 3]], covering: &Covering, count: usize) -> Option<Covering> {
    let longest = covering.half_lengths.iter().fold(0.0, |m: f64, c| m.max(*c));
    let is_used = |k: usize| covering.half_lengths[k] > UNUSED * longest;
    let used = (0..covering.directions.len()).filter(|&k| is_used(k)).count();
    (used >= count).then(|| with_some(points, covering, is_used)).flatten()
}

/// Changes of one direction, or one more, each with a descent, as long as they make the covering better.
fn improve(points: &[[f64; 3]], mut best: Covering, count: usize, effort: usize) -> Covering {
    let mut random = Pcg64Mcg::seed_from_u64(DEFAULT_SEED);
    let mut value = best.value();
    for _ in 0..effort {
        let mut directions = best.directions.clone();
        let changed = random.random_range(0..directions.len());
        let new = match random.random_range(0..3) {
            0 => {
                let corner = points[random.random_range(0..points.len())];
                edge_at(points, &corner).map(|(edge, _)| edge)
            }
            1 => {
                let other = directions[random.random_range(0..directions.len())];
                let sign = if random.random_bool(0.5) { 1.0 } else { -1.0 };
                unit(&std::array::from_fn(|k| directions[changed][k] + sign * other[k]))
            }
            _ => unit(&std::array::from_fn(|_| random.random_range(-1.0..1.0))),
        };
        let Some(new) = new else { continue };
        // the new direction has the mean weight of the old ones until its own is known
        let mut weights = best.weights();
        let mean = weights.iter().sum::<f64>() / weights.len() as f64;
        if directions.len() < count {
            directions.push(new);
            weights.push(mean);
        } else {
            directions[changed] = new;
            weights[changed] = mean;
        }
        let found = Covering::with_weights(best.aim, points, &directions, weights);
        let found = found.map(|found| descend(points, found, STEPS_OF_A_CHANGE));
        if let Some(found) = found.filter(|found| found.value() < value * (1.0 - LEAST_GAIN)) {
            (value, best) = (found.value(), found);
        }
    }
    best
}

/// The direction from a corner to the nearest other one, which is mostly that of an edge of the hull, and the distance.
fn edge_at(points: &[[f64; 3]], corner: &[f64; 3]) -> Option<([f64; 3], f64)> {
    let mut nearest = ([0.0; 3], f64::INFINITY);
    for point in points {
        let edge: [f64; 3] = std::array::from_fn(|k| point[k] - corner[k]);
        let square = dot(&edge, &edge);
        if square > 0.0 && square < nearest.1 {
            nearest = (edge, square);
        }
    }
    Some((unit(&nearest.0)?, nearest.1.sqrt()))
}

#[cfg(test)]
mod tests {
    use super::super::boxes;
    use super::*;
    use crate::bvh::volume::expected_overlaps_of_generators;

    /// The corners of a zonotope around the origin, turned.
    fn corners(generators: &[[f64; 3]], turn: &[[f64; 3]; 3]) -> Vec<[f64; 3]> {
        let corner = |bits: usize| {
            let sign = |k: usize| if bits >> k & 1 == 0 { -1.0 } else { 1.0 };
            let place: [f64; 3] =
                std::array::from_fn(|axis| generators.iter().enumerate().map(|(k, g)| sign(k) * g[axis]).sum());
            turn.each_ref().map(|row| dot(row, &place))
        };
        (0..1 << generators.len()).map(corner).collect()
    }

    /// The largest ratio of what a search finds to the zonotope itself over some rotations.
    fn worst_ratio(generators: &[[f64; 3]], effort: usize) -> f64 {
        let exact = expected_overlaps_of_generators(generators);
        let mut random = Pcg64Mcg::seed_from_u64(DEFAULT_SEED);
        let ratio = |_| {
            let quaternion = [0; 4].map(|_| random.random_range(-1.0..1.0));
            let turn = crate::Pose::from_quaternion(quaternion, [0.0; 3]).expect("not zero").matrix();
            let points = corners(generators, &turn);
            search(&points, boxes::search(&points), generators.len(), effort).value() / exact
        };
        (0..5).map(ratio).fold(0.0, f64::max)
    }

    /// Half the diagonals of a cube: a rhombic dodecahedron.
    const DIAGONALS: [[f64; 3]; 4] =
        [[0.25, 0.25, 0.25], [0.25, 0.25, -0.25], [0.25, -0.25, 0.25], [-0.25, 0.25, 0.25]];

    /// The edges of a regular tetrahedron: a truncated octahedron.
    const EDGES_OF_A_TETRAHEDRON: [[f64; 3]; 6] = [
        [0.25, 0.25, 0.0],
        [0.25, -0.25, 0.0],
        [0.0, 0.25, 0.25],
        [0.0, 0.25, -0.25],
        [0.25, 0.0, 0.25],
        [0.25, 0.0, -0.25],
    ];

    #[test]
    fn the_quickest_fit_of_a_rhombic_dodecahedron_is_nearly_that() {
        let found = worst_ratio(&DIAGONALS, 0);
        assert!((0.999_999..=1.05).contains(&found), "{found}");
    }

    #[test]
    fn a_search_finds_zonotopes_with_and_without_symmetries() {
        let oblique = [[0.3, 0.1, -0.2], [-0.1, 0.4, 0.2], [0.2, -0.3, 0.25], [0.1, 0.15, 0.3], [-0.25, 0.05, 0.2]];
        for generators in [&EDGES_OF_A_TETRAHEDRON[..], &oblique] {
            let found = worst_ratio(generators, 20);
            assert!((0.999_999..=1.05).contains(&found), "{found}");
        }
    }
}
