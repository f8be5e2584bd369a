//! A guess of the optimum by Newton steps on the objective with rounded-off kinks.
//!
//! Each |t| is replaced by t² / (2 e) + e / 2 where |t| < e (Huber's function), with e in proportion to the length of
//! the generator. The lines nearer than e are the band. The band shrinks as the steps get shorter, until it holds a
//! few lines. Nothing here is exact, and nothing rests on it but speed.
//!
//! Newton steps come before descent because a descent from vertex to vertex among n lines takes many line searches of
//! O(n) each, each of which may stop at the next vertex but one. The smooth objective sees the lines of a whole band
//! at once: a few steps of one pass each come so near that the cell around them is crossed by a few hundred lines, and
//! only among these the descent begins.
//!
//! A pass sums up gradient and Hessian over the lines, eight at a time.

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use super::aim::Aim;
use super::vertex_descent::descend;
use crate::lad::of_generators::plane::in_doubles::{Guess, LineBlock, RoundedLines, load};
use crate::numeric::lanes::level::level;
use crate::numeric::lanes::octet::total;
use crate::numeric::linear::dot;
use crate::numeric::reused::Reused;

/// The most Newton steps.
const NEWTON_STEP_LIMIT: usize = 20;

/// The thinnest band, in terms of the first.
const THINNEST_BAND: f64 = 1e-13;

/// The number of steps that went too far after which the objective counts as not smooth enough.
const SHORTENED_STEP_LIMIT: usize = 3;

/// From twice this number of lines on, descent begins with a part of them.
const DESCENT_PART_LINES: usize = 200;

/// A band is thin enough with fewer than this many times the lines that it must have.
const THIN_ENOUGH: f64 = 3.0;

/// The mean square of the change of the lines' distances, in terms of the band, below which a step counts as the last
/// one for its band where the minimum of the band itself is wanted.
const STRICT_CHANGE: f64 = 1e-4;

/// The minimum hardly moves if its last step is no longer than this, in terms of the deviation that the guess allows
/// for.
const SETTLED_CHANGE: f64 = 0.5;

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
    /// A point near the minimum of linear · x + Σ |a x + b y + c|; the search begins at another guess, if there is one.
    ///
    /// A step that ends far beyond the minimum along its way is shortened. The band gets thinner when the steps
    /// are shorter than the band. Where the band gets too thin, the search goes back to the last minimum and thins
    /// the band less; where the minimum moves steadily from band to band, the next one is extrapolated.
    pub(crate) fn guess(&self, linear: [f64; 2], start: Option<&Guess>, aim: Aim) -> Option<Guess> {
        // where all lines are parallel there is no guess at all
        let (point, band) = match start {
            Some(guess) => (guess.point, guess.band),
            None => self.least_squares()?,
        };
        self.by_newton(linear, point, band, aim)
    }

    /// The optimal vertex by descent from vertex to vertex: of a part of the lines first where they are many, then of
    /// all.
    pub(crate) fn optimum(&self, linear: [f64; 2], start: [f64; 2]) -> Option<[f64; 2]> {
        let share = self.len() / DESCENT_PART_LINES;
        let start = match share {
            0 | 1 => start,
            _ => self.part(share).optimum(linear.map(|c| c / share as f64), start).unwrap_or(start),
        };
        let [first, second] = descend(self, linear, start)?;
        let point = self.meet(first, second);
        point.iter().all(|c| c.is_finite()).then_some(point)
    }

    /// The guess around an optimal vertex of lines whose gradient was corrected at a point `before`; `None` where all
    /// lines near the vertex are parallel.
    pub(crate) fn guess_at(&self, point: [f64; 2], before: Option<[f64; 2]>, aim: Aim) -> Option<Guess> {
        let band = self.band(point, aim)?;
        self.around(&self.moments(point, band), band, point, before, aim)
    }

    /// Twice the distance, in terms of the length of its generator, of the farthest line of a band with as many lines
    /// as `aim` asks for.
    fn band(&self, point: [f64; 2], aim: Aim) -> Option<f64> {
        let distance = |[a, b, c, w]: [f64; 4]| (a * point[0] + b * point[1] + c).abs() * w;
        let mut distances: Reused<f64> = self.iter().map(distance).collect();
        let place = (aim.thickness as usize).min(self.len().checked_sub(1)?);
        let (_, &mut nearest, _) = distances.select_nth_unstable_by(place, f64::total_cmp);
        Some(2.0 * nearest)
    }

    fn by_newton(&self, linear: [f64; 2], mut point: [f64; 2], mut band: f64, aim: Aim) -> Option<Guess> {
        let thickness = aim.thickness;
        let thinnest = band * THINNEST_BAND;
        let mut best: Option<(Moments, f64, [f64; 2])> = None;
        let mut pending: Option<Step> = None;
        let mut anchor: Option<(f64, [f64; 2])> = None;
        let mut limit = 1.0;
        let mut shortened = 0;
        let mut steps = 0;
        loop {
            steps += 1;
            if steps > NEWTON_STEP_LIMIT {
                return None;
            }
            let moments = self.moments(point, band);
            let gradient = [moments.gradient[0] + linear[0], moments.gradient[1] + linear[1]];
            let newton = if moments.count < thickness { None } else { solve(&moments.hessian, gradient) };
            let Some(newton) = newton else {
                (pending, anchor) = (None, None);
                match best {
                    None if moments.count as usize == self.len() => return None,
                    None => band *= 4.0,
                    Some((wider, ..)) if wider.count < THIN_ENOUGH * thickness => break,
                    // the minimum of the wider band itself, not one step towards it, before a thinner one is tried
                    // again
                    Some((_, size, from)) if limit > STRICT_CHANGE => {
                        (point, band, limit) = (from, size, STRICT_CHANGE)
                    }
                    Some((_, size, _)) if band > 0.7 * size => break,
                    Some((_, size, from)) => (point, band) = (from, (band * size).sqrt()),
                }
                continue;
            };
            if let Some(shorter) = pending.take().and_then(|step| step.shortened(gradient)) {
                shortened += 1;
                if shortened > SHORTENED_STEP_LIMIT {
                    return None;
                }
                point = shorter;
                continue;
            }
            let step = Step::new(point, newton, gradient);
            point = step.end();
            let change = step.change(&moments);
            if change >= 1.0 {
                best = best.or(Some((moments, band, step.origin)));
                pending = Some(step);
                continue;
            }
            best = Some((moments, band, point));
            if change >= limit {
                continue;
            }
            // the gradient's deviation in terms of the band, each normal taken as long as its generator is wide on
            // average
            let deviation = aim.deviations * (self.len() as f64 / 3.0).sqrt() / moments.count;
            let is_settled =
                change < (SETTLED_CHANGE * deviation).powi(2) || moments.count < THIN_ENOUGH * aim.thinnest;
            if (moments.count < THIN_ENOUGH * thickness && is_settled) || band < thinnest {
                break;
            }
            let steady = change < 0.25;
            let thinner = band
                * (1.5 * if moments.count < THIN_ENOUGH * thickness { aim.thinnest } else { thickness }
                    / moments.count)
                    .max(if steady { 0.125 } else { 0.5 });
            let before = anchor.replace((band, point)).filter(|(before, _)| steady && *before > 1.01 * band);
            if let Some((before, from)) = before {
                let ahead = (band - thinner) / (before - band);
                point = [0, 1].map(|i| point[i] + ahead * (point[i] - from[i]));
            }
            band = thinner;
        }
        let (moments, band, point) = best?;
        self.around(&moments, band, point, None, aim)
    }

    /// The guess at a point, given the moments of the band there.
    fn around(
        &self,
        moments: &Moments,
        band: f64,
        point: [f64; 2],
        before: Option<[f64; 2]>,
        aim: Aim,
    ) -> Option<Guess> {
        let missing = 1.0 - self.len() as f64 / aim.population as f64;
        let others = Others { before, share: missing, longest: aim.longest };
        self.guess_of(moments, band, point, others, aim.deviations)
    }

    /// The guess whose sides are so many standard deviations of the gradient long, which the lines of the band and some
    /// of the others have.
    pub(crate) fn guess_of(
        &self,
        moments: &Moments,
        band: f64,
        point: [f64; 2],
        others: Others,
        deviations: f64,
    ) -> Option<Guess> {
        let [first, second] = factor(&self.spread(point, band, others))?;
        let side = |v: [f64; 2]| solve(&moments.hessian, v.map(|c| c * deviations));
        let guess = Guess { point, band, sides: [side(first)?, side(second)?] };
        let finite = |v: [f64; 2]| v[0].is_finite() && v[1].is_finite();
        (finite(guess.point) && finite(guess.sides[0]) && finite(guess.sides[1])).then_some(guess)
    }

    /// The minimum of Σ weight · (a x + b y + c)² and the root of the mean square.
    pub(crate) fn least_squares(&self) -> Option<([f64; 2], f64)> {
        let [xx, xy, yy, x, y, constant] = dispatch!(level(), simd => square_sums(simd, self.blocks()));
        let point = solve(&[xx, xy, yy], [x, y])?.map(|v| -v);
        let rest = constant + x * point[0] + y * point[1];
        Some((point, (rest.max(0.0) / self.length).sqrt()))
    }

    /// Σ normal · normalᵀ over the lines of a band, plus a share of it over some of the others.
    fn spread(&self, point: [f64; 2], band: f64, others: Others) -> Symmetric {
        dispatch!(level(), simd => spread(simd, self.blocks(), point, band, others))
    }

    pub(crate) fn moments(&self, point: [f64; 2], band: f64) -> Moments {
        dispatch!(level(), simd => moments(simd, self.blocks(), point, band))
    }
}

/// A Newton step, and the slope along it where it starts.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Step {
    origin: [f64; 2],
    vector: [f64; 2],
    slope: f64,
}

impl Step {
    /// The step that `newton`, the inverse Hessian times the gradient, asks for.
    pub(crate) fn new(origin: [f64; 2], newton: [f64; 2], gradient: [f64; 2]) -> Self {
        Self { origin, vector: newton.map(|c| -c), slope: -dot(&gradient, &newton) }
    }

    /// The mean square of the change of t / e in the band of some moments, each length taken for the harmonic mean.
    pub(crate) fn change(&self, moments: &Moments) -> f64 {
        -self.slope * moments.weight / (moments.count * moments.count)
    }

    pub(crate) fn end(&self) -> [f64; 2] {
        [self.origin[0] + self.vector[0], self.origin[1] + self.vector[1]]
    }

    /// The point where the slope may be zero, if it is positive at the end and not much less steep than it was negative
    /// at the start.
    pub(crate) fn shortened(&self, gradient: [f64; 2]) -> Option<[f64; 2]> {
        let slope = dot(&gradient, &self.vector);
        let part = (self.slope / (self.slope - slope)).max(0.05);
        (slope > -0.3 * self.slope).then(|| [0, 1].map(|i| self.origin[i] + part * self.vector[i]))
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
fn factor([xx, xy, yy]: &Symmetric) -> Option<[[f64; 2]; 2]> {
    let first = xx.sqrt();
    let rest = yy - xy * xy / xx;
    (*xx > 0.0 && rest > 0.0).then(|| [[first, xy / first], [0.0, rest.sqrt()]])
}
