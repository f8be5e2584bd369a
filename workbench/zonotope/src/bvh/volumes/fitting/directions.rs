//! Few directions of generators: a dictionary from which the worst are dropped, then changes one at a time.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::covering::{Covering, unit};
use crate::numeric::linear::euclidean_norm;
use crate::seed::DEFAULT_SEED;

/// Of fewer points than this, more than three generators gain little: the least cover of a triangle with a centre has
/// twice its area.
const FEWEST_POINTS: usize = 8;

/// A change must gain this share to be taken.
const LEAST_GAIN: f64 = 1e-4;

/// A zonotope of at most `count` generators that is no worse than a box.
pub(super) fn search(points: &[[f64; 3]], start: Covering, count: usize, effort: usize) -> Covering {
    let count = if points.len() < FEWEST_POINTS { 3 } else { count };
    let axes = start.directions.clone();
    let mut best = start;
    if let Some(found) = from_dictionary(points, &axes, count)
        && found.aim() < best.aim()
    {
        best = found;
    }
    improve(points, best, count, effort)
}

/// The axes of a box with the diagonals of its faces.
fn dictionary(axes: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let mut directions = axes.to_vec();
    for (i, j) in [(0, 1), (1, 2), (2, 0)] {
        for sign in [1.0, -1.0] {
            directions.extend(unit(&std::array::from_fn(|k| axes[i][k] + sign * axes[j][k])));
        }
    }
    directions
}

/// The covering along the dictionary's directions, of which the one that costs least is dropped until few are left.
fn from_dictionary(points: &[[f64; 3]], axes: &[[f64; 3]], count: usize) -> Option<Covering> {
    let mut found = Covering::along(points, &dictionary(axes))?;
    while found.directions.len() > count {
        let weights = found.weights();
        let share = |k: usize| found.half_lengths[k] * weights[k];
        let mut order: Vec<usize> = (0..weights.len()).collect();
        order.sort_by(|&i, &j| share(i).total_cmp(&share(j)));
        let without = |k: usize| {
            let kept = |list: &[[f64; 3]]| list.iter().enumerate().filter(|(i, _)| *i != k).map(|(_, d)| *d).collect();
            let directions: Vec<[f64; 3]> = kept(&found.directions);
            let weights = weights.iter().enumerate().filter(|(i, _)| *i != k).map(|(_, w)| *w).collect();
            Covering::with_weights(points, &directions, weights)
        };
        found = order.into_iter().find_map(without)?;
    }
    Covering::along(points, &found.directions).filter(|again| again.aim() < found.aim()).or(Some(found))
}

/// Changes of one direction at a time, or one more, as long as they make the covering better.
fn improve(points: &[[f64; 3]], mut best: Covering, count: usize, effort: usize) -> Covering {
    let mut random = Pcg64Mcg::seed_from_u64(DEFAULT_SEED);
    let mut aim = best.aim();
    let mut reach = 0.5;
    for _ in 0..effort {
        let mut directions = best.directions.clone();
        let changed = random.random_range(0..directions.len());
        let new = match random.random_range(0..3) {
            0 => {
                let corner = points[random.random_range(0..points.len())];
                edge_at(points, &corner)
            }
            1 => {
                let other = directions[random.random_range(0..directions.len())];
                let sign = if random.random_bool(0.5) { 1.0 } else { -1.0 };
                unit(&std::array::from_fn(|k| directions[changed][k] + sign * other[k]))
            }
            _ => {
                let noise: [f64; 3] = std::array::from_fn(|_| random.random_range(-reach..reach));
                unit(&std::array::from_fn(|k| directions[changed][k] + noise[k]))
            }
        };
        let Some(new) = new else { continue };
        if directions.len() < count {
            directions.push(new);
        } else {
            directions[changed] = new;
        }
        // what the new direction saves is told by the weights of the old covering
        let mut weights = best.weights();
        let mean = weights.iter().sum::<f64>() / weights.len() as f64;
        weights.resize(directions.len(), mean);
        let found = Covering::with_weights(points, &directions, weights);
        match found.filter(|found| found.aim() < aim * (1.0 - LEAST_GAIN)) {
            Some(found) => (aim, best) = (found.aim(), found),
            None => reach = f64::max(0.97 * reach, 0.05),
        }
    }
    best
}

/// The direction from a corner to the nearest other one, which is mostly that of an edge of the hull.
fn edge_at(points: &[[f64; 3]], corner: &[f64; 3]) -> Option<[f64; 3]> {
    let edges = points.iter().map(|p| [p[0] - corner[0], p[1] - corner[1], p[2] - corner[2]]);
    let others = edges.filter(|edge| *edge != [0.0; 3]);
    unit(&others.min_by(|a, b| euclidean_norm(a).total_cmp(&euclidean_norm(b)))?)
}

#[cfg(test)]
mod tests {
    use super::super::boxes;
    use super::*;
    use crate::numeric::linear::dot;

    #[test]
    fn a_search_fits_a_rhombic_dodecahedron_better_than_its_box() {
        let corner = |signs: [f64; 4]| {
            let diagonals = [[1.0, 1.0, 1.0], [1.0, 1.0, -1.0], [1.0, -1.0, 1.0], [-1.0, 1.0, 1.0]];
            std::array::from_fn(|k| (0..4).map(|i| 0.25 * signs[i] * diagonals[i][k]).sum::<f64>())
        };
        let sign = |bits: usize, k: usize| if bits >> k & 1 == 0 { -1.0 } else { 1.0 };
        let points: Vec<[f64; 3]> = (0..16).map(|bits| corner([0, 1, 2, 3].map(|k| sign(bits, k)))).collect();
        let boxed = boxes::search(&points);
        let [aim, of_box] = [search(&points, boxed.clone(), 4, 200).aim(), boxed.aim()];
        let exact = Covering {
            center: [0.0; 3],
            directions: [[1.0, 1.0, 1.0], [1.0, 1.0, -1.0], [1.0, -1.0, 1.0], [-1.0, 1.0, 1.0]]
                .map(|d: [f64; 3]| d.map(|c| c / dot(&d, &d).sqrt()))
                .to_vec(),
            half_lengths: vec![3f64.sqrt() / 4.0; 4],
        };
        assert!(aim < 0.8 * of_box && aim >= exact.aim() * 0.999_999, "{aim} {} {of_box}", exact.aim());
    }
}
