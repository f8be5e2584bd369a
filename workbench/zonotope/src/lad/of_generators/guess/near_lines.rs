//! The lines near a point, among which a descent goes on, with the gradient of all others.
//!
//! After a few Newton steps the optimum is nearer than all but some dozens of lines. The others have the same signs at
//! the optimum as at the point, so they are one linear function there, and a line search among the near ones takes a
//! tenth of a pass. Where a line that was left out passes between the point and the optimum, the descent ends at
//! another vertex, no worse: a vertex is proved by others.

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use super::vertex_descent::descend;
use crate::lad::of_generators::plane::in_doubles::{LineBlock, RoundedLines, load};
use crate::lad::of_generators::seam::sign_pass::USUAL_CROSSING;
use crate::numeric::lanes::level::level;
use crate::numeric::lanes::octet::{LANES, slot, total, turned};
use crate::numeric::reused::Reused;

/// Near lines, the rows that they have among all lines, and the gradient of the others at the point.
struct NearLines {
    lines: RoundedLines,
    rows: Reused<usize>,
    gradient: [f64; 2],
}

impl RoundedLines {
    /// The two lines through the vertex at which the descent from a point ends, of linear · x + Σ |a x + b y + c|,
    /// among the lines that are nearer to the point than `band`, in terms of the length of their generators; `None`
    /// where no line is.
    pub(crate) fn vertex_near(&self, linear: [f64; 2], point: [f64; 2], band: f64) -> Option<[usize; 2]> {
        let near = self.near(point, band);
        let vertex = descend(&near.lines, [0, 1].map(|k| linear[k] + near.gradient[k]), point)?;
        Some(vertex.map(|line| near.rows[line]))
    }

    fn near(&self, point: [f64; 2], band: f64) -> NearLines {
        // what fills up the last block is not finite by the length of its generator
        let band = band.min(f64::MAX);
        let mut rows = Reused::with_capacity(USUAL_CROSSING);
        let gradient = dispatch!(level(), simd => split(simd, self.blocks(), point, band, &mut rows));
        NearLines { lines: self.picked(&rows), rows, gradient }
    }
}

/// Adds the rows of the lines nearer to a point than a band to a list; the gradient of the others.
#[inline(always)]
fn split<S: Simd>(simd: S, blocks: &[LineBlock], [x, y]: [f64; 2], band: f64, rows: &mut Vec<usize>) -> [f64; 2] {
    let zero = f64x8::splat(simd, 0.0);
    let mut sums = [zero; 2];
    for (number, block) in blocks.iter().enumerate() {
        let [a, b, c, w] = load(simd, block);
        let value = a * x + b * y + c;
        let is_near = (value.abs() * w).simd_lt(band);
        for (sum, slope) in sums.iter_mut().zip([a, b]) {
            *sum += turned(simd, is_near.select(zero, slope), value);
        }
        let mut near = is_near.to_bitmask();
        while near != 0 {
            rows.push(LANES * number + slot(near.trailing_zeros() as usize));
            near &= near - 1;
        }
    }
    sums.map(total)
}

#[cfg(test)]
mod tests {
    use crate::lad::of_generators::guess::approach::Approach;
    use crate::lad::of_generators::plane::in_doubles::RoundedChart;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    #[test]
    fn near_lines_and_the_gradient_of_the_others_are_those_of_all() {
        let random = &mut Pcg64Mcg::seed_from_u64(38);
        for n in [1, 7, 8, 9, 100] {
            let vectors: Vec<[f64; 3]> = (0..n).map(|_| [0, 1, 2].map(|_| random.random_range(-1.0..1.0))).collect();
            let lines = RoundedChart::new([0.1, -0.2, 0.9]).lines(&vectors);
            let point = [0, 1].map(|_| random.random_range(-0.5..0.5));
            for band in [0.0, 0.1, 0.5, f64::INFINITY] {
                let near = lines.near(point, band);
                let is_near = |row: usize| {
                    let [a, b, c, w] = lines.line(row);
                    (a * point[0] + b * point[1] + c).abs() * w < band
                };
                let mut rows = near.rows.to_vec();
                rows.sort_unstable();
                assert_eq!(rows, (0..n).filter(|&row| is_near(row)).collect::<Vec<_>>(), "{n} {band}");
                assert!(near.rows.iter().enumerate().all(|(i, &row)| near.lines.line(i) == lines.line(row)));
                let gradient = near.lines.gradient(point);
                let whole = lines.gradient(point);
                assert!((0..2).all(|k| (near.gradient[k] + gradient[k] - whole[k]).abs() < 1e-12), "{n} {band}");
            }
        }
    }

    /// All lines are near in an infinite band, and among those of a narrow band the vertex is the same.
    #[test]
    fn the_vertex_is_that_of_all_lines() {
        let random = &mut Pcg64Mcg::seed_from_u64(39);
        let mut same = 0;
        for _ in 0..100 {
            let vectors: Vec<[f64; 3]> = (0..400).map(|_| [0, 1, 2].map(|_| random.random_range(-1.0..1.0))).collect();
            let lines = RoundedChart::new([0.1, -0.2, 0.9]).lines(&vectors);
            let Approach { point, band, .. } = lines.approach([0.0; 2], None).expect("lines of all directions");
            let [mut all, mut near] = [f64::INFINITY, 2.0 * band].map(|band| lines.vertex_near([0.0; 2], point, band));
            [&mut all, &mut near].into_iter().flatten().for_each(|vertex| vertex.sort_unstable());
            assert!(all.is_some());
            same += u32::from(all == near);
        }
        assert!(same >= 90, "{same}");
    }
}
