//! Sums over the lines for the objective with rounded-off kinks, eight lines at a time.

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use crate::lad::of_generators::plane::rounded_lines::{LineBlock, RoundedLines, load};
use crate::numeric::lanes::level::level;
use crate::numeric::lanes::octet::total;

/// A symmetric matrix [[xx, xy], [xy, yy]].
pub(crate) type Symmetric = [f64; 3];

/// Sums over the lines at a point for one band.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Moments {
    pub(crate) gradient: [f64; 2],
    pub(crate) hessian: Symmetric,
    /// Σ weight / band over the band.
    pub(crate) weight: f64,
    pub(crate) count: f64,
}

/// The lines over which the sum of normal · normalᵀ is taken, beside those of the band.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Others {
    /// Only lines that pass between the point and this one, where there is one.
    pub(crate) before: Option<[f64; 2]>,
    /// The part of normal · normalᵀ that is added for each.
    pub(crate) share: f64,
    /// Lines of longer generators are left out.
    pub(crate) longest: f64,
}

impl RoundedLines {
    /// The minimum of Σ weight · (a x + b y + c)² and the root of the mean square.
    pub(crate) fn least_squares(&self) -> Option<([f64; 2], f64)> {
        let [xx, xy, yy, x, y, constant] = dispatch!(level(), simd => square_sums(simd, self.blocks()));
        let point = solve(&[xx, xy, yy], [x, y])?.map(|v| -v);
        let rest = constant + x * point[0] + y * point[1];
        Some((point, (rest.max(0.0) / self.length).sqrt()))
    }

    /// Σ normal · normalᵀ over the lines of a band, plus a share of it over some of the others.
    pub(crate) fn spread(&self, point: [f64; 2], band: f64, others: Others) -> Symmetric {
        dispatch!(level(), simd => spread(simd, self.blocks(), point, band, others))
    }

    pub(crate) fn moments(&self, point: [f64; 2], band: f64) -> Moments {
        dispatch!(level(), simd => moments(simd, self.blocks(), point, band))
    }
}

#[inline(always)]
fn square_sums<S: Simd>(simd: S, blocks: &[LineBlock]) -> [f64; 6] {
    let zero = f64x8::splat(simd, 0.0);
    let [mut xx, mut xy, mut yy, mut x, mut y, mut constant] = [zero; 6];
    for block in blocks {
        let [a, b, c, w] = load(simd, block);
        // the lines that fill up the last block have no weight
        let w = w.simd_lt(f64::MAX).select(w, zero);
        let (wa, wb) = (w * a, w * b);
        xx += wa * a;
        xy += wa * b;
        yy += wb * b;
        x += wa * c;
        y += wb * c;
        constant += w * c * c;
    }
    [total(xx), total(xy), total(yy), total(x), total(y), total(constant)]
}

#[inline(always)]
fn spread<S: Simd>(simd: S, blocks: &[LineBlock], [x, y]: [f64; 2], band: f64, others: Others) -> Symmetric {
    let (zero, one) = (f64x8::splat(simd, 0.0), f64x8::splat(simd, 1.0));
    let share = f64x8::splat(simd, others.share);
    // a little less than the longest's inverse length, which was rounded
    let least = 0.999 / others.longest;
    let is_any = others.before.is_none();
    let [other_x, other_y] = others.before.unwrap_or_default();
    let [mut xx, mut xy, mut yy] = [zero; 3];
    for block in blocks {
        let [a, b, c, w] = load(simd, block);
        let value = a * x + b * y + c;
        let is_within = (value.abs() * w).simd_lt(band);
        let between = value * (a * other_x + b * other_y + c);
        let is_counted = if is_any { w.simd_gt(least) } else { w.simd_gt(least) & between.simd_lt(0.0) };
        let part = is_within.select(one, is_counted.select(share, zero));
        let (pa, pb) = (part * a, part * b);
        xx += pa * a;
        xy += pa * b;
        yy += pb * b;
    }
    [total(xx), total(xy), total(yy)]
}

#[inline(always)]
fn moments<S: Simd>(simd: S, blocks: &[LineBlock], [x, y]: [f64; 2], band: f64) -> Moments {
    let (zero, one) = (f64x8::splat(simd, 0.0), f64x8::splat(simd, 1.0));
    let scale = 1.0 / band;
    let [mut gx, mut gy, mut xx, mut xy, mut yy, mut weight, mut count] = [zero; 7];
    for block in blocks {
        let [a, b, c, w] = load(simd, block);
        let own = w * scale;
        let t = (a * x + b * y + c) * own;
        let is_inside = t.abs().simd_lt(one);
        let slope = is_inside.select(t, one.copysign(t));
        let stiff = is_inside.select(own, zero);
        let (sa, sb) = (stiff * a, stiff * b);
        gx += slope * a;
        gy += slope * b;
        xx += sa * a;
        xy += sa * b;
        yy += sb * b;
        weight += stiff;
        count += is_inside.select(one, zero);
    }
    Moments {
        gradient: [total(gx), total(gy)],
        hessian: [total(xx), total(xy), total(yy)],
        weight: total(weight),
        count: total(count),
    }
}

pub(crate) fn solve([xx, xy, yy]: &Symmetric, [x, y]: [f64; 2]) -> Option<[f64; 2]> {
    let determinant = xx * yy - xy * xy;
    (determinant > 1e-14 * (xx * yy)).then(|| [(yy * x - xy * y) / determinant, (xx * y - xy * x) / determinant])
}

/// The columns of the lower triangular L with L Lᵀ = the matrix.
pub(crate) fn factor([xx, xy, yy]: &Symmetric) -> Option<[[f64; 2]; 2]> {
    let first = xx.sqrt();
    let rest = yy - xy * xy / xx;
    (*xx > 0.0 && rest > 0.0).then(|| [[first, xy / first], [0.0, rest.sqrt()]])
}
