//! The zonotope of the multipliers: its vertices far from the origin are the directions that a set of directions lacks.
//!
//! A vertex is Σ ± λ_j with the signs of λ_j · v for some direction v. Each cell of the arrangement of the planes v ⊥ λ_j touches an intersection of d − 2 of them, which is a
//! circle of directions; a walk around it meets the other planes in the order of their angles and changes one sign at a time.

use crate::numeric::tolerance::UNIT;
use crate::zonotope::ray_exit::dot;

/// What an enumeration of the vertices found.
pub(crate) struct FarVertices<const D: usize> {
    /// A proven upper bound of the distance of the farthest vertex from the origin.
    pub(crate) radius: f64,
    /// Vertices that are farthest in a neighbourhood and farther than was asked, each once up to sign, the farthest first.
    pub(crate) peaks: Vec<[f64; D]>,
    /// Vertices that are farthest in a neighbourhood on a circle of directions orthogonal to rank − 2 of the multipliers, and farther than was asked.
    pub(crate) on_circles: Vec<[f64; D]>,
}

/// The vertices of Σ [−1, 1] λ_j, whose first `rank` coordinates count, farther than `least` from the origin. O(m^{rank−1} log m).
pub(crate) fn far_vertices<const D: usize>(rank: usize, multipliers: &[[f64; D]], least: f64) -> FarVertices<D> {
    let total: f64 = multipliers.iter().map(length).sum();
    let (mut found, mut on_circles): (Vec<[f64; D]>, Vec<[f64; D]>) = (Vec::new(), Vec::new());
    let mut farthest: f64 = 0.0;
    if rank == 1 {
        return FarVertices {
            radius: total * (1.0 + (multipliers.len() + 8) as f64 * UNIT),
            peaks: Vec::new(),
            on_circles: Vec::new(),
        };
    }
    let mut is_walked = false;
    let mut circle = Circle { multipliers, angles: Vec::with_capacity(multipliers.len()) };
    for_subsets(multipliers.len(), rank.saturating_sub(2), |subset| {
        if let Some((distance, vertex)) = circle.farthest(rank, subset, least, &mut on_circles) {
            is_walked = true;
            farthest = farthest.max(distance);
            if distance > least {
                found.push(vertex);
            }
        }
    });
    // No circle where all multipliers are parallel; then one vertex adds up their lengths, and nothing is farther.
    if !is_walked {
        farthest = total;
    }
    let mut peaks: Vec<[f64; D]> = found.iter().map(|vertex| climb(multipliers, *vertex)).collect();
    peaks.sort_by(|a, b| length(b).total_cmp(&length(a)));
    let mut distinct: Vec<[f64; D]> = Vec::new();
    for peak in peaks {
        let (size, tolerance) = (length(&peak), 1e-18);
        let same = |other: &[f64; D]| {
            let along = dot(&peak, other) / (size * length(other));
            1.0 - along.abs() < tolerance
        };
        if !distinct.iter().any(same) {
            distinct.push(peak);
        }
    }
    // Directions within rounding of each other may change places in a walk, so a vertex may be missed whose cell is smaller than that.
    let rounding = (8.0 * multipliers.len() as f64 + 64.0) * UNIT * total * if rank > 2 { 8.0 } else { 1.0 };
    FarVertices { radius: farthest + rounding, peaks: distinct, on_circles }
}

fn length<const D: usize>(v: &[f64; D]) -> f64 {
    dot(v, v).sqrt()
}

/// Goes from vertex to vertex in the direction of the vertex itself while that leads farther out.
fn climb<const D: usize>(multipliers: &[[f64; D]], mut vertex: [f64; D]) -> [f64; D] {
    for _ in 0..100 {
        let mut next = [0.0; D];
        for multiplier in multipliers {
            let sign = if dot(multiplier, &vertex) < 0.0 { -1.0 } else { 1.0 };
            next = std::array::from_fn(|c| next[c] + sign * multiplier[c]);
        }
        if length(&next) <= length(&vertex) {
            break;
        }
        vertex = next;
    }
    vertex
}

fn for_subsets(count: usize, size: usize, mut visit: impl FnMut(&[usize])) {
    let mut subset: Vec<usize> = (0..size).collect();
    while subset.last().is_none_or(|&last| last < count) {
        visit(&subset);
        let Some(moving) = (0..size).rev().find(|&i| subset[i] + size - i < count) else { break };
        subset[moving] += 1;
        for i in moving + 1..size {
            subset[i] = subset[i - 1] + 1;
        }
    }
}

/// The circle of directions orthogonal to a few multipliers.
struct Circle<'a, const D: usize> {
    multipliers: &'a [[f64; D]],
    /// For each other multiplier the slope key of its crossing on the half circle, and its index.
    angles: Vec<(f64, usize, bool)>,
}

impl<const D: usize> Circle<'_, D> {
    /// The farthest vertex met on the way around, with every choice of signs for the multipliers of the subset.
    fn farthest(
        &mut self,
        rank: usize,
        subset: &[usize],
        least: f64,
        peaks: &mut Vec<[f64; D]>,
    ) -> Option<(f64, [f64; D])> {
        let own: Vec<[f64; D]> = subset.iter().map(|&i| self.multipliers[i]).collect();
        let [x, y] = orthogonal_pair(rank, &own)?;
        // The walk goes from direction x over y to −x; multiplier j changes its sign where its projection (a, b) is orthogonal to the direction.
        let mut sum = [0.0; D];
        self.angles.clear();
        for (j, multiplier) in self.multipliers.iter().enumerate() {
            if subset.contains(&j) {
                continue;
            }
            let (a, b) = (dot(multiplier, &x), dot(multiplier, &y));
            let is_positive = if a == 0.0 { b >= 0.0 } else { a > 0.0 };
            let sign = if is_positive { 1.0 } else { -1.0 };
            sum = std::array::from_fn(|c| sum[c] + sign * multiplier[c]);
            // a cos t + b sin t = 0 at cot t = −b/a, which falls from ∞ to −∞.
            let cotangent = if a == 0.0 { f64::NEG_INFINITY } else { -b / a };
            self.angles.push((cotangent, j, is_positive));
        }
        self.angles.sort_unstable_by(|p, q| q.0.total_cmp(&p.0).then(p.1.cmp(&q.1)));
        let mut best = Self::with_signs(&own, &sum);
        let (mut last, mut is_rising) = (best, true);
        for &(_, j, was_positive) in &self.angles {
            let change = if was_positive { -2.0 } else { 2.0 };
            let multiplier = &self.multipliers[j];
            sum = std::array::from_fn(|c| sum[c] + change * multiplier[c]);
            let candidate = Self::with_signs(&own, &sum);
            if candidate.0 < last.0 && is_rising && last.0 > least * least {
                peaks.push(last.1);
            }
            is_rising = candidate.0 >= last.0;
            last = candidate;
            if candidate.0 > best.0 {
                best = candidate;
            }
        }
        Some((best.0.sqrt(), best.1))
    }

    /// The farthest of sum ± own multipliers, with its squared distance.
    fn with_signs(own: &[[f64; D]], sum: &[f64; D]) -> (f64, [f64; D]) {
        let choices = 1usize << own.len();
        let candidates = (0..choices).map(|choice| {
            let mut vertex = *sum;
            for (i, multiplier) in own.iter().enumerate() {
                let sign = if choice >> i & 1 == 0 { 1.0 } else { -1.0 };
                vertex = std::array::from_fn(|c| vertex[c] + sign * multiplier[c]);
            }
            (dot(&vertex, &vertex), vertex)
        });
        candidates.max_by(|a, b| a.0.total_cmp(&b.0)).expect("there is at least one choice")
    }
}

/// Two orthogonal unit vectors orthogonal to rank − 2 vectors; `None` if these are dependent within rounding.
fn orthogonal_pair<const D: usize>(rank: usize, own: &[[f64; D]]) -> Option<[[f64; D]; 2]> {
    let mut units: Vec<[f64; D]> = Vec::with_capacity(rank);
    let reduce = |v: [f64; D], units: &[[f64; D]]| {
        let mut rest = v;
        for _ in 0..2 {
            for unit in units {
                let along = dot(unit, &rest);
                rest = std::array::from_fn(|c| rest[c] - along * unit[c]);
            }
        }
        rest
    };
    for v in own {
        let size = length(v);
        let rest = reduce(*v, &units);
        let left = length(&rest);
        if left.is_nan() || left <= 1e-12 * size {
            return None;
        }
        units.push(rest.map(|c| c / left));
    }
    for _ in 0..2 {
        let axes = (0..rank).map(|a| reduce(std::array::from_fn(|c| f64::from(u8::from(a == c))), &units));
        let longest = axes.max_by(|a, b| length(a).total_cmp(&length(b)))?;
        let size = length(&longest);
        units.push(longest.map(|c| c / size));
    }
    Some([units[units.len() - 2], units[units.len() - 1]])
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::{RngExt, SeedableRng};

    /// All choices of signs.
    fn farthest<const D: usize>(multipliers: &[[f64; D]]) -> f64 {
        (0..1usize << multipliers.len())
            .map(|choice| {
                let mut sum = [0.0; D];
                for (i, multiplier) in multipliers.iter().enumerate() {
                    let sign = if choice >> i & 1 == 0 { 1.0 } else { -1.0 };
                    sum = std::array::from_fn(|c| sum[c] + sign * multiplier[c]);
                }
                length(&sum)
            })
            .fold(0.0, f64::max)
    }

    fn agrees<const D: usize>(count: usize, coordinate: &mut impl FnMut() -> f64) {
        let multipliers: Vec<[f64; D]> = (0..count).map(|_| std::array::from_fn(|_| coordinate())).collect();
        let truth = farthest(&multipliers);
        let far = far_vertices(D, &multipliers, 0.99 * truth);
        assert!(
            far.radius >= truth && far.radius <= truth * (1.0 + 1e-9) + 1e-300,
            "{} {truth} {multipliers:?}",
            far.radius
        );
        if truth > 0.0 && count >= D {
            assert!((length(&far.peaks[0]) - truth).abs() <= 1e-12 * truth);
        }
    }

    #[test]
    fn the_farthest_vertex_is_that_of_all_signs() {
        let mut rng = rand_pcg::Pcg64::seed_from_u64(11);
        for count in 2..9 {
            for _ in 0..30 {
                agrees::<2>(count, &mut || rng.random_range(-1.0..1.0));
                agrees::<3>(count, &mut || rng.random_range(-1.0..1.0));
                agrees::<4>(count.max(3), &mut || rng.random_range(-1.0..1.0));
                agrees::<2>(count, &mut || f64::from(rng.random_range(-2i32..3)));
            }
        }
    }
}
