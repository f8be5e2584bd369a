//! Where the optimum is, nearly: Newton steps on the objective with rounded-off kinks.
//!
//! Each |t| is replaced by t² / (2 e) + e / 2 where |t| < e (Huber's function), e in proportion to the length of the generator. The band of the
//! lines nearer than e shrinks as the steps get shorter, until it is a few lines thick. Nothing here is exact
//! and nothing rests on it but speed.

use wide::f64x2;

use crate::lad::of_generators::guess::sample::Sample;
use crate::lad::of_generators::guess::vertex_descent::descend;
use crate::lad::of_generators::plane::rounded_lines::{Pair, RoundedLines};
use crate::numeric::linear::dot;

/// A point near the optimum, the band in which the lines were rounded off, and the sides of a parallelogram around the point that
/// the optimum is likely to be in.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Guess {
    pub(crate) point: [f64; 2],
    pub(crate) band: f64,
    pub(crate) sides: [[f64; 2]; 2],
}

impl Guess {
    /// Whether a point is no farther away than so many times the sides.
    pub(crate) fn is_near(&self, point: [f64; 2], times: f64) -> bool {
        let square = |[x, y]: [f64; 2]| x * x + y * y;
        let off = [point[0] - self.point[0], point[1] - self.point[1]];
        square(off) <= times * times * (square(self.sides[0]) + square(self.sides[1]))
    }
}

/// What a guess is to allow for.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Aim {
    /// RoundedLines in a band that is thin enough if the minimum hardly moved when it became so thin, and in the thinnest.
    pub(crate) thickness: f64,
    pub(crate) thinnest: f64,
    /// How many lines the columns stand for.
    pub(crate) population: usize,
    /// Those of longer generators stand for themselves alone.
    pub(crate) longest: f64,
    /// Standard deviations of the gradient that lines of the band and those that are missing may contribute.
    pub(crate) deviations: f64,
}

/// Lines in the thinnest band.
const THINNEST_BAND_LINES: f64 = 10.0;

/// Lines in a band that is thin enough, in terms of all lines.
const BAND_SHARE: f64 = 0.16;

/// The cell of a sample, in standard deviations of the gradient of the lines that are not in the sample.
pub(crate) const SAMPLE_DEVIATIONS: f64 = 2.7;

impl Aim {
    /// What a guess from some lines is to allow for.
    pub(crate) fn new(len: usize, population: usize, deviations: f64) -> Self {
        let thinnest = THINNEST_BAND_LINES.max((len as f64).sqrt());
        let thickness = thinnest.max(BAND_SHARE * len as f64);
        Self { thickness, thinnest, population, longest: f64::INFINITY, deviations }
    }

    /// The same for a sample of a population of generators, with a thin band if its lengths are uneven.
    pub(crate) fn of_sample(sample: &Sample, population: usize) -> Self {
        let aim = Self { longest: sample.longest, ..Self::new(sample.vectors.len(), population, SAMPLE_DEVIATIONS) };
        if sample.longest < f64::INFINITY { aim.thin() } else { aim }
    }

    /// The same with a band as thin as can be: where generators are uneven, a wide band hides what is in it.
    pub(crate) fn thin(self) -> Self {
        Self { thickness: self.thinnest, ..self }
    }
}

/// The most Newton steps.
const NEWTON_STEP_LIMIT: usize = 20;

/// The thinnest band, in terms of the first.
const THINNEST_BAND: f64 = 1e-13;

/// After so many steps that went too far the objective is not smooth enough for this.
const SHORTENED_STEP_LIMIT: usize = 3;

/// Of more lines than twice this, descent takes a part.
const DESCENT_PART_LINES: usize = 200;

/// The band is thin enough with so many times the lines it must have.
const THIN_ENOUGH: f64 = 3.0;

/// A step is the last one for its band if it changes the lines' distances, in terms of the band, by no more than this in the mean square.
const STRICT_CHANGE: f64 = 1e-4;

/// The minimum hardly moves if its last step is no longer than this, in terms of what the guess allows for.
const SETTLED_CHANGE: f64 = 0.5;

/// A symmetric matrix [[xx, xy], [xy, yy]].
type Symmetric = [f64; 3];

/// Sums over the lines at a point for one band.
#[derive(Debug, Clone, Copy, Default)]
struct Moments {
    gradient: [f64; 2],
    hessian: Symmetric,
    /// Σ weight / band over the band.
    weight: f64,
    count: f64,
}

impl RoundedLines {
    /// The minimum of Σ weight · (a x + b y + c)² and the root of the mean square.
    pub(crate) fn least_squares(&self) -> Option<([f64; 2], f64)> {
        let mut sums = [f64x2::splat(0.0); 6];
        for [a, b, c, w] in self.pairs() {
            // the line that is no line has no weight here
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

    /// Σ normal · normalᵀ over the lines of a band, plus `share` of all others but those of generators longer than `longest`; where there is a point
    /// before, of those only that lie between.
    fn spread(&self, point: [f64; 2], before: Option<[f64; 2]>, band: f64, share: f64, longest: f64) -> Symmetric {
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

    fn moments(&self, point: [f64; 2], band: f64) -> Moments {
        let mut sums = Sums::default();
        let [x, y] = point.map(f64x2::splat);
        let scale = f64x2::splat(1.0 / band);
        for pair in self.pairs() {
            sums.read(pair, [x, y], scale);
        }
        sums.total()
    }

    /// A point near the minimum of linear · x + Σ |a x + b y + c|; searched from another guess, if there is one.
    ///
    /// Where a step ends far beyond the minimum along its way, it is shortened. The band gets thinner when the steps are shorter than
    /// it; where it gets too thin the search goes back and thins it less, and where it follows the minimum steadily the
    /// next one is extrapolated.
    pub(crate) fn guess(&self, linear: [f64; 2], start: Option<&Guess>, aim: Aim) -> Option<Guess> {
        // where all lines are parallel there is no guess at all
        let (point, band) = match start {
            Some(guess) => (guess.point, guess.band),
            None => self.least_squares()?,
        };
        self.by_newton(linear, point, band, aim)
    }

    /// The optimal vertex from vertex to vertex: of a part of many lines first, then of all.
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

    /// The guess at an optimal vertex of lines whose gradient was right at a point before; none where all lines near it are parallel.
    pub(crate) fn guess_at(&self, point: [f64; 2], before: Option<[f64; 2]>, aim: Aim) -> Option<Guess> {
        let band = self.band(point, aim)?;
        self.around(&self.moments(point, band), band, point, before, aim)
    }

    /// Twice the distance of the farthest line of a band that is as thick as it must be, in terms of the length of its generator.
    fn band(&self, point: [f64; 2], aim: Aim) -> Option<f64> {
        let distance = |[a, b, c, w]: [f64; 4]| (a * point[0] + b * point[1] + c).abs() * w;
        let mut distances: Vec<f64> = self.iter().map(distance).collect();
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
                    // the minimum of the wider band itself, not one step towards it, before a thinner one is tried again
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
            let step = Step { origin: point, vector: newton.map(|c| -c), slope: -dot(&gradient, &newton) };
            point = step.end();
            // the mean square of the change of t / e in the band, each length taken for the harmonic mean
            let change = -step.slope * moments.weight / (moments.count * moments.count);
            if change >= 1.0 {
                best = best.or(Some((moments, band, step.origin)));
                pending = Some(step);
                continue;
            }
            best = Some((moments, band, point));
            if change >= limit {
                continue;
            }
            // the gradient's deviation in the same terms, each normal as long as its generator is wide on average
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
        let [first, second] = factor(&self.spread(point, before, band, missing, aim.longest))?;
        let side = |v: [f64; 2]| solve(&moments.hessian, v.map(|c| c * aim.deviations));
        let guess = Guess { point, band, sides: [side(first)?, side(second)?] };
        let finite = |v: [f64; 2]| v[0].is_finite() && v[1].is_finite();
        (finite(guess.point) && finite(guess.sides[0]) && finite(guess.sides[1])).then_some(guess)
    }
}

/// A Newton step, and the slope along it where it starts.
#[derive(Debug, Clone, Copy)]
struct Step {
    origin: [f64; 2],
    vector: [f64; 2],
    slope: f64,
}

impl Step {
    fn end(&self) -> [f64; 2] {
        [self.origin[0] + self.vector[0], self.origin[1] + self.vector[1]]
    }

    /// Where the slope may be zero, if it is positive at the end and not much less steep than it was negative at the start.
    fn shortened(&self, gradient: [f64; 2]) -> Option<[f64; 2]> {
        let slope = dot(&gradient, &self.vector);
        let part = (self.slope / (self.slope - slope)).max(0.05);
        (slope > -0.3 * self.slope).then(|| [0, 1].map(|i| self.origin[i] + part * self.vector[i]))
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

fn solve([xx, xy, yy]: &Symmetric, [x, y]: [f64; 2]) -> Option<[f64; 2]> {
    let determinant = xx * yy - xy * xy;
    (determinant > 1e-14 * (xx * yy)).then(|| [(yy * x - xy * y) / determinant, (xx * y - xy * x) / determinant])
}

/// The columns of the lower triangular L with L Lᵀ = the matrix.
fn factor([xx, xy, yy]: &Symmetric) -> Option<[[f64; 2]; 2]> {
    let first = xx.sqrt();
    let rest = yy - xy * xy / xx;
    (*xx > 0.0 && rest > 0.0).then(|| [[first, xy / first], [0.0, rest.sqrt()]])
}
