//! A stratified sample of the lines, and the radius of the first cell around its optimum.

use std::ops::Range;

use rand::RngExt;
use rand_pcg::Pcg64Mcg;

use crate::lad::of_lines::cells::Frame;
use crate::lad::of_lines::subproblem::Subproblem;
use crate::numeric::weighted_median::weighted_median;
use crate::tally::{Operation, Tally};

/// Number of the sample's lines, per square root of its size, from which the radius is estimated: at least sixty of
/// them cross the cell.
const LINES_PER_ROOT: f64 = 12.0;

/// Standard deviations of the sum of reaches per standard deviation of the gradient along an axis, √(2 + 4/π).
const GATHERED_DEVIATIONS: f64 = 1.81;

/// About n^(2/3) lines, one at random from each of as many equal strata, with the linear term in proportion.
///
/// Strata and not plain sampling: lines often come in an order, along a polygon or a curve, and one from each stratum
/// follows it with less variance.
pub(super) fn draw<'p>(limit: usize, subproblem: &Subproblem<'p>, random: &mut Pcg64Mcg) -> Subproblem<'p> {
    let n = subproblem.len();
    let root = integer_cube_root(n as u64) as usize;
    let size = (2 * root * root).clamp((limit / 4).max(1), (n / 4).max(1));
    let lines: Vec<u32> = (0..size as u64)
        .map(|i| {
            let Range { start, end } = stratum(i, size as u64, n as u64);
            random.random_range(start as usize..end as usize) as u32
        })
        .collect();
    let share = size as f64 / n as f64;
    let linear = subproblem.linear.map(|v| v * share);
    subproblem.sample(&lines, linear)
}

/// The lines of stratum `i` where n of them, fewer than 2^32, are cut into `count` strata of nearly equal size.
///
/// The products are taken in 64 bits: those of 32-bit sizes overflow from 430,000 lines on.
fn stratum(i: u64, count: u64, n: u64) -> Range<u64> {
    i * n / count..(i + 1) * n / count
}

/// The largest integer whose cube is at most n, for n from 1 to 2^32; in 64 bits, since the next cube may exceed 2^32.
fn integer_cube_root(n: u64) -> u64 {
    (1..).find(|root: &u64| (root + 1).pow(3) > n).expect("cubes grow past every number of lines")
}

/// The radius at which the crossing lines can make up for the sampling error of the gradient at t = √(⅔ ln n) standard
/// deviations: the cell of n lines misses the optimum with probability about exp(−t²/2) = n^(−1/3), which is the share
/// of the lines that it keeps.
///
/// A radius along an axis changes the gradient by 1 / (2 + 4/π) of the reach gathered on both sides of the centre, when
/// the normals point everywhere; the error there has 1 / (2 + 4/π) of the variance Σ reach². So √(2 + 4/π) deviations
/// of that sum are gathered for one.
pub(super) fn radius<T: Tally>(
    sample: &Subproblem,
    n: usize,
    [cx, cy]: [f64; 2],
    frame: Frame,
    tally: &mut T,
) -> Option<f64> {
    let size = sample.len() as f64;
    let step = (size / (LINES_PER_ROOT * size.sqrt())).max(1.0) as usize;
    let (distances, reaches): (Vec<f64>, Vec<f64>) = (0..sample.len())
        .step_by(step)
        .map(|i| {
            let ([x, y, b], _) = sample.lines.row(i);
            let reach = frame.reach(x, y);
            ((x * cx + y * cy + b).abs() / reach, reach)
        })
        .filter(|(distance, reach)| distance.is_finite() && *reach > 0.0)
        .unzip();
    tally.add(Operation::PartEvaluation, reaches.len() as u64);
    tally.add(Operation::Comparison, 2 * reaches.len() as u64);
    let squares = reaches.iter().map(|reach| reach * reach).sum::<f64>();
    let deviations = (2.0 / 3.0 * std::f64::consts::LN_2 * f64::from(n.ilog2())).sqrt();
    let needed = GATHERED_DEVIATIONS * deviations * (squares / step as f64).sqrt();
    let smallest = distances.iter().copied().filter(|distance| *distance > 0.0).reduce(f64::min)?;
    let farthest = weighted_median(&distances, &reaches, needed)?;
    Some(distances[farthest].max(smallest))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers of lines around the square root of 2^32 and of 2^64, and around 2^32 itself.
    const SIZES: [u64; 8] =
        [1, 2, 65_535, 65_537, 430_000, u32::MAX as u64 / 2 + 1, u32::MAX as u64 - 1, u32::MAX as u64];

    #[test]
    fn strata_cover_all_lines_up_to_the_largest_index() {
        for n in SIZES {
            let root = integer_cube_root(n);
            let count = (2 * root * root).clamp(1, (n / 4).max(1));
            let mut end = 0;
            for i in 0..count {
                let stratum = stratum(i, count, n);
                assert_eq!(stratum.start, end, "n = {n}, stratum {i}");
                let exact_end = (u128::from(i) + 1) * u128::from(n) / u128::from(count);
                assert_eq!(u128::from(stratum.end), exact_end, "n = {n}, stratum {i}");
                assert!(stratum.start < stratum.end, "n = {n}, stratum {i}");
                end = stratum.end;
            }
            assert_eq!(end, n);
        }
    }

    #[test]
    fn cube_roots_hold_up_to_the_largest_index() {
        for n in SIZES {
            let root = u128::from(integer_cube_root(n));
            assert!(root.pow(3) <= u128::from(n) && u128::from(n) < (root + 1).pow(3), "n = {n}");
        }
    }
}
