//! Clusters of generators by direction, by Lloyd's rounds.
//!
//! A cluster's sum has its direction; its length is the sum of the lengths of its members. That is more than the sum is
//! long, and it makes the mean of |b · u| over all directions u that of Σ |v · u|: the zonotope of the clusters is as
//! wide as the body on average. Plain sums are narrower everywhere by about 1 / k, which would have to be made up for
//! by a factor.

use crate::numeric::linear::{add_multiple, dot};

/// Rounds after which clusters hardly change; the fit that follows moves them on.
const ROUNDS: usize = 12;

/// Generators whose directions differ by an angle with a cosine closer to 1 than this are in one cluster: their facets
/// would have normals of few certain digits, and apart they gain 2^-34 of their length at most.
const PARALLEL: f64 = 1.0 / 17_179_869_184.0;

/// Generators in at most `count` directions, one for each cluster of the given vectors. O(n k) a round.
pub(super) fn cluster_sums<const D: usize>(vectors: &[[f64; D]], count: usize) -> Vec<[f64; D]> {
    let lengths: Vec<f64> = vectors.iter().map(|v| dot(v, v).sqrt()).collect();
    let mut directions = farthest_first(vectors, &lengths, count);
    let mut totals = vec![0.0; directions.len()];
    for _ in 0..ROUNDS {
        let mut sums = vec![[0.0; D]; directions.len()];
        totals.fill(0.0);
        for (v, length) in vectors.iter().zip(&lengths) {
            let (mut nearest, mut product) = (0, 0.0f64);
            for (index, direction) in directions.iter().enumerate() {
                let along = dot(direction, v);
                if along.abs() > product.abs() {
                    (nearest, product) = (index, along);
                }
            }
            if product != 0.0 {
                add_multiple(&mut sums[nearest], if product < 0.0 { -1.0 } else { 1.0 }, v);
                totals[nearest] += length;
            }
        }
        for (direction, sum) in directions.iter_mut().zip(&sums) {
            let length = dot(sum, sum).sqrt();
            if length > 0.0 {
                *direction = sum.map(|c| c / length);
            }
        }
    }
    let sized = directions.iter().zip(&totals).filter(|(_, total)| **total > 0.0);
    sized.map(|(direction, total)| direction.map(|c| c * total)).collect()
}

/// Directions of generators, each of the one that the directions before it miss most: by |v| − |u · v|.
fn farthest_first<const D: usize>(vectors: &[[f64; D]], lengths: &[f64], count: usize) -> Vec<[f64; D]> {
    let mut reached = vec![0.0f64; vectors.len()];
    let mut directions = Vec::with_capacity(count);
    while directions.len() < count {
        let (mut next, mut most) = (None, 0.0);
        for (index, (length, reached)) in lengths.iter().zip(&reached).enumerate() {
            let missed = length - reached;
            if missed > most && missed > PARALLEL * length {
                (next, most) = (Some(index), missed);
            }
        }
        let Some(index) = next else { break };
        let direction = vectors[index].map(|c| c / lengths[index]);
        for (reached, v) in reached.iter_mut().zip(vectors) {
            *reached = reached.max(dot(&direction, v).abs());
        }
        directions.push(direction);
    }
    directions
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clusters_worked_out_by_hand() {
        let vectors = [[4.0, 3.0], [-4.0, 3.0], [1.0, -2.0], [8.0, 6.0]];
        let two = cluster_sums(&vectors, 2);
        // (4, 3) and (8, 6) make one cluster; (−4, 3) and −(1, −2) add up to (−5, 5) and are 5 + √5 long
        assert_eq!(two.len(), 2);
        assert!((two[0][0] - 12.0).abs() < 1e-12 && (two[0][1] - 9.0).abs() < 1e-12, "{two:?}");
        let length = dot(&two[1], &two[1]).sqrt();
        assert!((length - 5.0 - 5f64.sqrt()).abs() < 1e-12 && (two[1][0] + two[1][1]).abs() < 1e-12, "{two:?}");
        assert_eq!(cluster_sums(&vectors, 9).len(), 3);
    }
}
