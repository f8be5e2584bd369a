//! Sums over the lines for the objective with rounded-off kinks, two lines at a time.

use wide::f64x2;

use crate::lad::of_generators::plane::rounded_lines::{Pair, RoundedLines};

/// A symmetric matrix [[xx, xy], [xy, yy]].
type Symmetric = [f64; 3];

/// Sums over the lines at a point for one band.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Moments {
    pub(super) gradient: [f64; 2],
    pub(super) hessian: Symmetric,
    /// Σ weight / band over the band.
    pub(super) weight: f64,
    pub(super) count: f64,
}

impl RoundedLines {
    /// The minimum of Σ weight · (a x + b y + c)² and the root of the mean square.
    pub(crate) fn least_squares(&self) -> Option<([f64; 2], f64)> {
        let mut sums = [f64x2::splat(0.0); 6];
        for [a, b, c, w] in self.pairs() {
            // the line that pads an odd number has no weight
            let w = w & w.simd_lt(f64x2::splat(f64::MAX));
            let (wa, wb) = (w * a, w * b);
            let terms = [wa * a, wa * b, wb * b, wa * c, wb * c, w * c * c];
            for (sum, term) in sums.iter_mut().zip(terms) {
                *sum += term;
            }
        }
        let [xx, xy, yy, x, y, constant] = sums.map(f64x2::reduce_add);
        let point = solve(&[xx, xy, yy], [x, y])?.map(|v| -v);
        let rest = constant + x * point[0] + y * point[1];
        Some((point, (rest.max(0.0) / self.length).sqrt()))
    }

    /// Σ normal · normalᵀ over the lines of a band, plus `share` of it over all other lines but those of generators
    /// longer than `longest`. Where there is a point `before`, only lines that pass between the two points count
    /// among the others.
    pub(super) fn spread(
        &self,
        point: [f64; 2],
        before: Option<[f64; 2]>,
        band: f64,
        share: f64,
        longest: f64,
    ) -> Symmetric {
        let mut sums = [f64x2::splat(0.0); 3];
        let [x, y] = point.map(f64x2::splat);
        let [other_x, other_y] = before.unwrap_or_default().map(f64x2::splat);
        let is_any = f64x2::splat(if before.is_some() { 0.0 } else { f64::from_bits(u64::MAX) });
        let [band, share, one] = [band, share, 1.0].map(f64x2::splat);
        // a little less than the longest's inverse length, which was rounded
        let least = f64x2::splat(0.999 / longest);
        for [a, b, c, w] in self.pairs() {
            let value = a * x + b * y + c;
            let within = (value.abs() * w).simd_lt(band);
            let is_between = (value * (a * other_x + b * other_y + c)).simd_lt(f64x2::default());
            let share = share & w.simd_gt(least) & (is_any | is_between);
            let part = share + ((one - share) & within);
            let (pa, pb) = (part * a, part * b);
            for (sum, term) in sums.iter_mut().zip([pa * a, pa * b, pb * b]) {
                *sum += term;
            }
        }
        sums.map(f64x2::reduce_add)
    }

    pub(super) fn moments(&self, point: [f64; 2], band: f64) -> Moments {
        let mut sums = Sums::default();
        let [x, y] = point.map(f64x2::splat);
        let scale = f64x2::splat(1.0 / band);
        for pair in self.pairs() {
            sums.read(pair, [x, y], scale);
        }
        sums.total()
    }
}

/// Sums side by side: the gradient, the Hessian, weight and count of the band.
#[derive(Default)]
struct Sums([f64x2; 7]);

impl Sums {
    #[inline(always)]
    fn read(&mut self, &[a, b, c, w]: &Pair, [x, y]: [f64x2; 2], scale: f64x2) {
        let one = f64x2::splat(1.0);
        let weight = w * scale;
        let t = (a * x + b * y + c) * weight;
        let inside = t.abs().simd_lt(one);
        let slope = t.fast_min(one).fast_max(-one);
        let stiff = weight & inside;
        let (sa, sb) = (stiff * a, stiff * b);
        let terms = [slope * a, slope * b, sa * a, sa * b, sb * b, stiff, one & inside];
        for (sum, term) in self.0.iter_mut().zip(terms) {
            *sum += term;
        }
    }

    fn total(&self) -> Moments {
        let [gx, gy, xx, xy, yy, weight, count] = self.0.map(f64x2::reduce_add);
        Moments { gradient: [gx, gy], hessian: [xx, xy, yy], weight, count }
    }
}

pub(super) fn solve([xx, xy, yy]: &Symmetric, [x, y]: [f64; 2]) -> Option<[f64; 2]> {
    let determinant = xx * yy - xy * xy;
    (determinant > 1e-14 * (xx * yy)).then(|| [(yy * x - xy * y) / determinant, (xx * y - xy * x) / determinant])
}

/// The columns of the lower triangular L with L Lᵀ = the matrix.
pub(super) fn factor([xx, xy, yy]: &Symmetric) -> Option<[[f64; 2]; 2]> {
    let first = xx.sqrt();
    let rest = yy - xy * xy / xx;
    (*xx > 0.0 && rest > 0.0).then(|| [[first, xy / first], [0.0, rest.sqrt()]])
}
