//! Stage: generators of nearly one direction are added up, pair by pair, the pair first that loses least length.
//!
//! The sum of two generators is shorter than both together, by |a| + |b| − |a ± b| with the sign that makes the sum
//! longer. What is lost is about the angle's square, times a mean of the lengths: so short generators are merged over
//! wide angles and long ones over narrow angles only.

use crate::numeric::linear::dot;

/// The order in which generators are merged, down to one.
pub(super) struct Merging<const D: usize> {
    generators: Vec<[f64; D]>,
    /// The length that the first merger loses; infinite where there is none.
    least_loss: f64,
    /// Pairs of places: the generator at the second joins that at the first.
    pairs: Vec<[usize; 2]>,
}

impl<const D: usize> Merging<D> {
    /// The order for generators. O(n²) in most cases.
    pub(super) fn new(generators: Vec<[f64; D]>) -> Self {
        let mut sums = generators.clone();
        let mut is_left = vec![true; sums.len()];
        let mut nearest: Vec<(f64, usize)> = (0..sums.len()).map(|i| cheapest_partner(&sums, &is_left, i)).collect();
        let least_loss = nearest.iter().map(|(loss, _)| *loss).fold(f64::INFINITY, f64::min);
        let mut pairs = Vec::with_capacity(sums.len());
        for _ in 1..sums.len() {
            let places = (0..sums.len()).filter(|&i| is_left[i]);
            let Some(first) = places.min_by(|&a, &b| nearest[a].0.total_cmp(&nearest[b].0)) else { break };
            let second = nearest[first].1;
            pairs.push([first, second]);
            sums[first] = longer_sum(&sums[first], &sums[second]);
            is_left[second] = false;
            for i in 0..sums.len() {
                if !is_left[i] {
                    continue;
                }
                if i == first || nearest[i].1 == first || nearest[i].1 == second {
                    nearest[i] = cheapest_partner(&sums, &is_left, i);
                } else {
                    let cost = lost_length(&sums[i], &sums[first]);
                    if cost < nearest[i].0 {
                        nearest[i] = (cost, first);
                    }
                }
            }
        }
        Self { generators, least_loss, pairs }
    }

    /// How many generators there are before any are merged.
    pub(super) fn len(&self) -> usize {
        self.generators.len()
    }

    /// The length that is lost when the two generators are merged that lose least; infinite of a single one.
    pub(super) fn least_loss(&self) -> f64 {
        self.least_loss
    }

    /// The generators merged until `count` are left.
    pub(super) fn down_to(&self, count: usize) -> Vec<[f64; D]> {
        let mut sums = self.generators.clone();
        let mut is_left = vec![true; sums.len()];
        for &[first, second] in self.pairs.iter().take(sums.len().saturating_sub(count)) {
            sums[first] = longer_sum(&sums[first], &sums[second]);
            is_left[second] = false;
        }
        sums.into_iter().zip(is_left).filter(|(_, left)| *left).map(|(sum, _)| sum).collect()
    }
}

/// The sum or the difference of two vectors, whichever is longer.
pub(super) fn longer_sum<const D: usize>(a: &[f64; D], b: &[f64; D]) -> [f64; D] {
    let sign = if dot(a, b) < 0.0 { -1.0 } else { 1.0 };
    std::array::from_fn(|c| a[c] + sign * b[c])
}

/// The length that is lost when two generators are replaced by their longer sum.
fn lost_length<const D: usize>(a: &[f64; D], b: &[f64; D]) -> f64 {
    let sum = longer_sum(a, b);
    let lengths = dot(a, a).sqrt() + dot(b, b).sqrt();
    (lengths - dot(&sum, &sum).sqrt()).max(0.0)
}

/// The generator that is left with which generator `i` loses least length, and that length.
fn cheapest_partner<const D: usize>(sums: &[[f64; D]], is_left: &[bool], i: usize) -> (f64, usize) {
    let others = (0..sums.len()).filter(|&j| j != i && is_left[j]);
    let costs = others.map(|j| (lost_length(&sums[i], &sums[j]), j));
    costs.min_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or((f64::INFINITY, i))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nearly_parallel_generators_are_merged_first() {
        let merging = Merging::new(vec![[1.0, 0.0], [0.0, 1.0], [-1.0, 0.1], [0.1, 0.0]]);
        assert_eq!((merging.len(), merging.least_loss()), (4, 0.0));
        assert_eq!(Merging::new(vec![[1.0, 0.0]]).least_loss(), f64::INFINITY);
        assert_eq!(merging.down_to(4).len(), 4);
        let two = merging.down_to(2);
        assert_eq!(two.len(), 2);
        assert!((two[0][0].abs() - 2.1).abs() < 1e-15 && two[1] == [0.0, 1.0]);
        assert!((two[0][1].abs() - 0.1).abs() < 1e-15);
    }
}
