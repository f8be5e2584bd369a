//! The dual zonotope Σ [−1, 1] λ_j of multipliers λ_j: its vertices outside the unit ball are constraints that the
//! multipliers violate, and the directions of these vertices are directions for generators.
//!
//! A vertex is Σ ± λ_j with the signs of λ_j · v for some direction v; the directions with the same signs are a cell of
//! the arrangement of the planes v ⊥ λ_j through the origin. Every cell touches a circle of directions: the unit
//! vectors in an intersection of d − 2 of the planes. So the vertices are found by walks around all such circles. A
//! walk crosses the other planes in the order of their angles, and each crossing changes one sign.

use crate::numeric::linear::dot;
use crate::numeric::subsets::for_each_subset;
use crate::numeric::tolerance::UNIT;

/// The vertices of a dual zonotope that an enumeration found far from the origin.
pub(crate) struct FarVertices<const D: usize> {
    /// A proven upper bound of the distance of the farthest vertex from the origin.
    pub(crate) radius: f64,
    /// Vertices farther than the threshold from which no step of [`climb`] leads farther out, each once up to sign, the
    /// farthest first.
    pub(crate) peaks: Vec<[f64; D]>,
    /// Vertices farther than the threshold whose distance is a local maximum along the walk around a circle.
    pub(crate) on_circles: Vec<[f64; D]>,
}

/// The vertices of Σ [−1, 1] λ_j farther than the threshold `least` from the origin, for m multipliers whose
/// coordinates beyond the first `rank` are zero. O(m^{rank−1} log m).
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
    let mut circle = Circle { multipliers, crossings: Vec::with_capacity(multipliers.len()) };
    for_each_subset(multipliers.len(), rank.saturating_sub(2), |subset| {
        if let Some((distance, vertex)) = circle.farthest(rank, subset, least, &mut on_circles) {
            is_walked = true;
            farthest = farthest.max(distance);
            if distance > least {
                found.push(vertex);
            }
        }
    });
    // No circle is walked if every rank − 2 multipliers are dependent. Their total length bounds every vertex then.
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
    // Rounding may exchange two crossings of a walk that are nearly at one angle, so a vertex whose cell is as small as
    // rounding may be missed. It is no farther than this beyond a vertex that was found.
    let rounding = (8.0 * multipliers.len() as f64 + 64.0) * UNIT * total * if rank > 2 { 8.0 } else { 1.0 };
    FarVertices { radius: farthest + rounding, peaks: distinct, on_circles }
}

fn length<const D: usize>(v: &[f64; D]) -> f64 {
    dot(v, v).sqrt()
}

/// Goes from a vertex to the vertex that is farthest in its direction, again and again while that leads farther from
/// the origin.
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

/// A walk around a circle of directions orthogonal to a subset of the multipliers, with room that the next walk uses
/// again.
struct Circle<'a, const D: usize> {
    multipliers: &'a [[f64; D]],
    /// For each multiplier outside the subset: the cotangent of the angle at which its sign changes on the half circle,
    /// its index, and whether its sign is positive at the beginning.
    crossings: Vec<(f64, usize, bool)>,
}

impl<const D: usize> Circle<'_, D> {
    /// The farthest vertex that a walk around the circle of a subset meets, with its distance; every choice of signs
    /// for the subset's own multipliers is tried at every place. Vertices that belong to [`FarVertices::on_circles`]
    /// join `on_circle`. `None` if the subset is dependent within rounding.
    ///
    /// With s the sum of the other multipliers and o that of the own ones, for some signs, the farther one of s ± o has
    /// the squared distance |s|² + |o|² + 2 |s · o|: half of the choices of signs are enough, and no vertex is computed
    /// before it is known to matter.
    fn farthest(
        &mut self,
        rank: usize,
        subset: &[usize],
        least: f64,
        on_circle: &mut Vec<[f64; D]>,
    ) -> Option<(f64, [f64; D])> {
        let own: Vec<[f64; D]> = subset.iter().map(|&i| self.multipliers[i]).collect();
        let [x, y] = orthogonal_pair(rank, &own)?;
        // The walk goes from the direction x over y to −x; half a circle is enough, as opposite directions have
        // opposite vertices. Multiplier j changes its sign where its projection (a, b) is orthogonal to the direction.
        let mut sum = [0.0; D];
        self.crossings.clear();
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
            self.crossings.push((cotangent, j, is_positive));
        }
        self.crossings.sort_unstable_by(|p, q| q.0.total_cmp(&p.0).then(p.1.cmp(&q.1)));
        let own = own_sums(&own);
        let mut best = Candidate::at(&own, &sum);
        let (mut last, mut is_rising) = (best, true);
        for &(_, j, was_positive) in &self.crossings {
            let change = if was_positive { -2.0 } else { 2.0 };
            let multiplier = &self.multipliers[j];
            sum = std::array::from_fn(|c| sum[c] + change * multiplier[c]);
            let candidate = Candidate::at(&own, &sum);
            if candidate.square < last.square && is_rising && last.square > least * least {
                on_circle.push(last.vertex(&own));
            }
            is_rising = candidate.square >= last.square;
            last = candidate;
            if candidate.square > best.square {
                best = candidate;
            }
        }
        let vertex = best.vertex(&own);
        Some((length(&vertex), vertex))
    }
}

/// The sums of a subset's own multipliers for every choice of signs, of two opposite ones the first, each with its
/// squared length.
fn own_sums<const D: usize>(own: &[[f64; D]]) -> Vec<([f64; D], f64)> {
    let choices = 1usize << own.len().saturating_sub(1);
    let sum = |choice: usize| {
        own.iter().enumerate().fold([0.0; D], |sum: [f64; D], (i, multiplier)| {
            let sign = if choice >> i & 1 == 0 { 1.0 } else { -1.0 };
            std::array::from_fn(|c| sum[c] + sign * multiplier[c])
        })
    };
    (0..choices).map(sum).map(|sum| (sum, dot(&sum, &sum))).collect()
}

/// The farthest of the vertices at one place of a walk.
#[derive(Clone, Copy)]
struct Candidate<const D: usize> {
    /// The squared distance from the origin, rounded.
    square: f64,
    /// The sum of the multipliers outside the subset.
    others: [f64; D],
    /// The place of the sum of the own ones, and whether it is taken away.
    own: (usize, bool),
}

impl<const D: usize> Candidate<D> {
    fn at(own: &[([f64; D], f64)], others: &[f64; D]) -> Self {
        let mut best = Self { square: f64::NEG_INFINITY, others: *others, own: (0, false) };
        for (place, (sum, square)) in own.iter().enumerate() {
            let along = dot(sum, others);
            let square = square + 2.0 * along.abs();
            if square > best.square {
                (best.square, best.own) = (square, (place, along < 0.0));
            }
        }
        best.square += dot(others, others);
        best
    }

    fn vertex(&self, own: &[([f64; D], f64)]) -> [f64; D] {
        let (place, is_taken) = self.own;
        let sign = if is_taken { -1.0 } else { 1.0 };
        std::array::from_fn(|c| self.others[c] + sign * own[place].0[c])
    }
}

/// Two unit vectors orthogonal to each other and to rank − 2 vectors; `None` if these are dependent within rounding.
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

    /// The distance of the farthest vertex, by trying all choices of signs.
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
