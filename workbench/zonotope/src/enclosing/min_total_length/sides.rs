//! The program over sides: the best forces for the partings of the points seen so far.
//!
//! Σ_j |λ_j · v| is the largest of 2 Σ_{j ∈ T} λ_j · v over all sets T of points, as Σ λ_j = 0. So the forces are within their limits for every unit vector v
//! just when |w_T| ≤ 1 for every T, w_T = 2 Σ_{j ∈ T} λ_j. Each T is a generator of which T is at one end and the other points at the other; unlike a direction of
//! a net it turns freely. Those T that part the points by a plane through the origin, on the side of a vertex of Σ [−1, 1] λ_j, are all that count.
//!
//! For the sets seen so far, maximise s Σ λ_j · p_j + Σ_T log(1 − |w_T|²) by Newton's method, s growing. At the maximum g_T = (2/s) w_T / (1 − |w_T|²) has
//! p_j − p_0 = Σ_{T ∋ j} 2 g_T: the zonotope of these generators has every point for a vertex, and Σ |g_T| exceeds Σ λ_j · p_j by at most 1/s for each T.

use super::cholesky::Cholesky;
use crate::enclosing::fixed_directions::dot;
use crate::numeric::tolerance::UNIT;

/// Points with their forces, and the sets of points seen so far.
pub(super) struct Sides<const D: usize> {
    rank: usize,
    /// Relative to the first one, which lies in no set.
    points: Vec<[f64; D]>,
    forces: Vec<[f64; D]>,
    sets: Vec<Vec<bool>>,
    pub(super) sharpness: f64,
    /// Products and sums so far, roughly.
    pub(super) work: f64,
}

/// Newton steps of one maximisation.
const MOST_STEPS: usize = 60;

/// So many times as many sets as coordinates of forces are kept.
const MOST_SETS: usize = 12;

impl<const D: usize> Sides<D> {
    /// The first point, with no force at all.
    pub(super) fn new(rank: usize) -> Self {
        Self { rank, points: vec![[0.0; D]], forces: vec![[0.0; D]], sets: vec![], sharpness: 8.0, work: 0.0 }
    }

    /// Points with forces that are within all limits already, and the sets on the positive side of some directions.
    pub(super) fn begun(rank: usize, points: Vec<[f64; D]>, forces: Vec<[f64; D]>, directions: &[[f64; D]]) -> Self {
        let first = points[0];
        let points: Vec<[f64; D]> = points.iter().map(|p| plus(p, -1.0, &first)).collect();
        let own = (1..points.len()).map(|j| (0..points.len()).map(|i| i == j).collect());
        let mut sides = Self { rank, sets: own.collect(), points, forces, sharpness: 8.0, work: 0.0 };
        for direction in directions {
            sides.part(direction);
        }
        sides
    }

    /// Adds a point, relative to the first one, and a direction in which it will be pulled; its own set keeps its force within limits.
    pub(super) fn add_point(&mut self, point: [f64; D], pull: [f64; D]) {
        let mut room: f64 = 1.0;
        let sums: Vec<[f64; D]> = self.sets.iter().map(|set| sum_over(set, &self.forces)).collect();
        for (set, sum) in self.sets.iter_mut().zip(sums) {
            let is_inside = dot(&sum, &pull) > 0.0;
            set.push(is_inside);
            if is_inside {
                room = room.min(1.0 - dot(&sum, &sum));
            }
        }
        let force = pull.map(|c| c * (0.01 * room / dot(&pull, &pull).sqrt()));
        self.points.push(point);
        self.forces.push(force);
        self.balance();
        let mut own = vec![false; self.points.len()];
        own[self.points.len() - 1] = true;
        self.sets.push(own);
    }

    /// Adds the set of points whose forces point to one side; whether it is new.
    pub(super) fn part(&mut self, vertex: &[f64; D]) -> bool {
        let of_first = dot(&self.forces[0], vertex) > 0.0;
        let set: Vec<bool> = self.forces.iter().map(|force| (dot(force, vertex) > 0.0) != of_first).collect();
        let is_new = set.contains(&true) && !self.sets.contains(&set);
        if is_new {
            self.sets.push(set);
        }
        is_new
    }

    /// Σ λ_j · (p_j − p_0).
    pub(super) fn value(&self) -> f64 {
        self.points.iter().zip(&self.forces).map(|(p, f)| dot(p, f)).sum()
    }

    /// Brings all forces within their limits when `radius` is the farthest that a vertex may be.
    pub(super) fn shrink(&mut self, radius: f64) {
        // As near the limits as the barrier would leave them.
        let factor = (1.0 - (radius - 1.0).max(1.0 / self.sharpness).min(0.1)) / radius;
        for force in &mut self.forces {
            *force = force.map(|c| c * factor);
        }
    }

    pub(super) fn forces(&self) -> &[[f64; D]] {
        &self.forces
    }

    pub(super) fn sets(&self) -> usize {
        self.sets.len()
    }

    /// The generators g_T; with the first point for the sum of their opposites, all points are vertices at the maximum.
    pub(super) fn generators(&self) -> Vec<[f64; D]> {
        let generator = |set: &Vec<bool>| {
            let sum = sum_over(set, &self.forces);
            let factor = 2.0 / (self.sharpness * (1.0 - dot(&sum, &sum)).max(UNIT));
            sum.map(|c| c * factor)
        };
        self.sets.iter().map(generator).collect()
    }

    /// Forgets the sets that are farthest from their limit if there are too many, but for those of one point.
    pub(super) fn forget(&mut self) {
        let most = MOST_SETS * self.rank * self.points.len();
        if self.sets.len() <= most {
            return;
        }
        let size = |set: &Vec<bool>| {
            let sum = sum_over(set, &self.forces);
            dot(&sum, &sum)
        };
        let mut sizes: Vec<f64> = self.sets.iter().map(size).collect();
        let kept: Vec<f64> = sizes.clone();
        let (_, least, _) = sizes.select_nth_unstable_by(most, |a, b| b.total_cmp(a));
        let mut place = kept.iter();
        self.sets.retain(|set| {
            let is_large = place.next().is_some_and(|size| size >= least);
            is_large || set.iter().filter(|s| **s).count() == 1
        });
    }

    /// The force of the first point makes up for the others.
    fn balance(&mut self) {
        let others = self.forces[1..].iter().fold([0.0; D], |sum, force| plus(&sum, 1.0, force));
        self.forces[0] = others.map(|c| -c);
    }

    /// Newton's method towards the maximum for the sharpness as it is, until the squared decrement was below `settled`; whether it got there.
    pub(super) fn settle(&mut self, settled: f64) -> bool {
        let rank = self.rank;
        let size = rank * (self.points.len() - 1);
        if size == 0 {
            return true;
        }
        for _ in 0..MOST_STEPS {
            self.work += (size * size * size) as f64 / 3.0;
            let sums: Vec<[f64; D]> = self.sets.iter().map(|set| sum_over(set, &self.forces)).collect();
            let mut slope: Vec<f64> =
                self.points[1..].iter().flat_map(|p| p[..rank].iter().map(|c| self.sharpness * c)).collect();
            let gain = slope.clone();
            let mut matrix = Cholesky::zero(size);
            for (set, w) in self.sets.iter().zip(&sums) {
                let members: Vec<usize> = (1..set.len()).filter(|&j| set[j]).map(|j| rank * (j - 1)).collect();
                let room = 1.0 - dot(w, w);
                let block: Vec<f64> = (0..rank * rank)
                    .map(|i| {
                        let (a, b) = (i / rank, i % rank);
                        8.0 * (f64::from(u8::from(a == b)) + 2.0 * w[a] * w[b] / room) / room
                    })
                    .collect();
                for &j in &members {
                    for (c, &w) in w[..rank].iter().enumerate() {
                        slope[j + c] -= 4.0 * w / room;
                    }
                }
                matrix.add_blocks(&members, rank, &block);
                self.work += (rank * rank * members.len() * members.len()) as f64;
            }
            let Some(step) = matrix.solve(&slope) else { return false };
            let decrement: f64 = slope.iter().zip(&step).map(|(a, b)| a * b).sum();
            if decrement.is_nan() {
                return false;
            }
            let mut turned = vec![[0.0; D]];
            turned.extend(step.chunks_exact(rank).map(|s| std::array::from_fn(|c| s.get(c).copied().unwrap_or(0.0))));
            let rates: Vec<[f64; D]> = self.sets.iter().map(|set| sum_over(set, &turned)).collect();
            let rise: f64 = gain.iter().zip(&step).map(|(a, b)| a * b).sum();
            let length = best_length(rise, &sums, &rates);
            if !(length.is_finite() && step.iter().all(|c| c.is_finite())) {
                return false;
            }
            for (force, turned) in self.forces.iter_mut().zip(&turned) {
                *force = plus(force, length, turned);
            }
            self.balance();
            if decrement < settled {
                return true;
            }
        }
        false
    }
}

/// 2 Σ over a set.
fn sum_over<const D: usize>(set: &[bool], forces: &[[f64; D]]) -> [f64; D] {
    let members = set.iter().zip(forces).filter(|(is_member, _)| **is_member);
    members.fold([0.0; D], |sum, (_, force)| plus(&sum, 2.0, force))
}

fn plus<const D: usize>(a: &[f64; D], factor: f64, b: &[f64; D]) -> [f64; D] {
    std::array::from_fn(|c| a[c] + factor * b[c])
}

/// Where rise · x + Σ log(1 − |w + x dw|²) is greatest, by Newton's method kept between bounds.
fn best_length<const D: usize>(rise: f64, sums: &[[f64; D]], rates: &[[f64; D]]) -> f64 {
    let terms: Vec<[f64; 3]> =
        sums.iter().zip(rates).map(|(w, r)| [1.0 - dot(w, w), dot(w, r), dot(r, r)]).filter(|t| t[2] > 0.0).collect();
    // |w + x dw| = 1 at the positive root of room − 2 b x − c x².
    let ends = terms.iter().map(|&[room, b, c]| {
        let root = (b * b + room * c).sqrt();
        if b > 0.0 { room / (b + root) } else { (root - b) / c }
    });
    let end = ends.fold(f64::INFINITY, f64::min);
    if !end.is_finite() {
        return 0.0;
    }
    let (mut low, mut high) = (0.0, end);
    let mut x: f64 = f64::min(1.0, 0.5 * end);
    for _ in 0..60 {
        let (slope, curvature) = terms.iter().fold((rise, 0.0), |(slope, curvature), &[room, b, c]| {
            let left = room - 2.0 * b * x - c * x * x;
            let first = 2.0 * (b + c * x) / left;
            (slope - first, curvature - first * first - 2.0 * c / left)
        });
        if slope > 0.0 {
            low = x;
        } else {
            high = x;
        }
        let next = x - slope / curvature;
        let next = if next > low && next < high { next } else { 0.5 * (low + high) };
        if (next - x).abs() <= 1e-3 * x {
            break;
        }
        x = next;
    }
    // Rounding must not carry a force over its limit.
    x.min(0.9999 * end)
}
