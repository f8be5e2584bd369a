//! Generators in few directions, or nearly: a sample says little of the lines between, but much of the sum of each
//! direction.
//!
//! The generators of a sample that are parallel but for noise form a class, whose sum makes one line. Two of these
//! lines meet in a vertex, and the generators of both classes cross a cell around it. If the vertex turns out not to
//! be optimal, the sample is corrected: the difference between the gradient of all generators there and that of the
//! sample is added to the sample's objective, which then has the right gradient near the vertex and the sample's
//! changes of gradient farther off.

use fearless_simd::{Simd, dispatch, f64x8, mask64x8, prelude::*};

use crate::lad::of_generators::cells::reduced::Reduced;
use crate::lad::of_generators::guess::vertex_descent::descend;
use crate::lad::of_generators::plane::in_doubles::{Guess, RoundedChart, RoundedLines};
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::lanes::level::level;
use crate::numeric::lanes::number::product;
use crate::numeric::lanes::octet::{LANES, Octet, slot, splat};
use crate::numeric::lanes::octets::Octets;
use crate::numeric::linear::dot;
use crate::numeric::reused::{Reused, keep_lists_of};

/// The number of generators of the sample that are compared with each other to see whether any are parallel.
const PROBES: usize = 2 * LANES;

/// Generators of more classes than this are not treated by classes.
const CLASS_LIMIT: usize = 32;

/// The most noise of a direction, as the sine of an angle.
const PARALLEL_SINE: f64 = 1e-6;

/// The factor by which a class may be wider than in the sample.
const WIDTH_MARGIN: f64 = 4.0;

/// The classes of a sample.
pub(crate) struct ParallelClasses {
    classes: Reused<ParallelClass>,
    lines: RoundedLines,
    /// The correction that is added to the gradient of the sample.
    linear: [f64; 2],
    /// The part of all generators that the sample is.
    part: f64,
}

/// Generators in one direction.
#[derive(Debug, Clone, Copy)]
struct ParallelClass {
    /// The direction of one of them, with the largest coordinate 1 or −1.
    unit: [f64; 3],
    sum: [f64; 3],
    noise: f64,
}

keep_lists_of!(ParallelClass);

/// A meeting: the vertex of the lines of two classes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Meeting {
    first: usize,
    second: usize,
    pub(crate) guess: Guess,
    /// Whether all generators of either class are parallel but for rounding.
    is_sharp: bool,
}

impl ParallelClasses {
    /// The classes of a sample of a part of all generators, if they are few.
    pub(crate) fn of(sample: &[[f64; 3]], part: f64, chart: &RoundedChart) -> Option<Self> {
        if !seem_repeated(sample) {
            return None;
        }
        Self::summed_up(sample.iter().copied(), part, chart)
    }

    /// The classes of all generators, if they are few: where the sample leads to no meeting that is optimal. One pass,
    /// which compares each generator with the classes.
    pub(crate) fn of_all(query: &dyn KernelQuery, chart: &RoundedChart) -> Option<Self> {
        Self::summed_up(query.generators(), 1.0, chart)
    }

    fn summed_up(vectors: impl Iterator<Item = [f64; 3]>, part: f64, chart: &RoundedChart) -> Option<Self> {
        let mut classes = Reused::<ParallelClass>::with_capacity(CLASS_LIMIT);
        for v in vectors {
            let Some(own) = unit(&v) else { continue };
            match classes.iter().position(|class| sine_square(&class.unit, &own) < PARALLEL_SINE * PARALLEL_SINE) {
                Some(place) => {
                    let class = &mut classes[place];
                    let noise = sine_square(&class.unit, &own).sqrt();
                    let sign = f64::copysign(1.0, dot(&class.unit, &v));
                    class.sum = [0, 1, 2].map(|k| class.sum[k] + sign * v[k]);
                    class.noise = class.noise.max(noise);
                }
                None if classes.len() == CLASS_LIMIT => return None,
                None => classes.push(ParallelClass { unit: own, sum: v, noise: 0.0 }),
            }
        }
        let lines = chart.lines(&classes.iter().map(|class| class.sum).collect::<Reused<_>>());
        Some(Self { classes, lines, linear: [0.0; 2], part })
    }

    /// The meeting at which the objective of the classes is least.
    pub(crate) fn meeting(&self, chart: &RoundedChart) -> Option<Meeting> {
        let (start, _) = self.lines.least_squares()?;
        let [first, second] = descend(&self.lines, self.linear, start)?;
        let point = self.lines.meet(first, second);
        let size = chart.point(point).iter().map(|c| c.abs()).sum::<f64>();
        let noises = [first, second].map(|i| WIDTH_MARGIN * self.classes[i].noise);
        let [[a, b, _], [c, d, _]] = [first, second].map(|i| chart.line(&self.classes[i].unit));
        let determinant = a * d - b * c;
        let [one, other] = noises.map(|noise| noise * size / determinant);
        let sides = [[d * one, -c * one], [-b * other, a * other]];
        // about half of the lines of either class are nearer
        let band = noises[0].max(noises[1]) * size / (8.0 * WIDTH_MARGIN);
        let is_finite = sides.as_flattened().iter().chain(&point).all(|c| c.is_finite());
        let is_sharp = noises.iter().all(|noise| *noise < ROUNDING_SINE);
        is_finite.then_some(Meeting { first, second, guess: Guess { point, band, sides }, is_sharp })
    }

    /// Of the generators that cross a cell around a meeting, the longest of either class, if the meeting is sharp.
    pub(crate) fn vertex(&self, meeting: &Meeting, reduced: &Reduced) -> Option<[usize; 2]> {
        let longest = |class: usize| {
            let unit = &self.classes[class].unit;
            let own = reduced.vectors.iter().enumerate().filter(|(_, v)| is_along(v, unit));
            own.map(|(i, v)| (dot(v, unit).abs(), i)).max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, i)| i)
        };
        let found = if meeting.is_sharp { Some([longest(meeting.first)?, longest(meeting.second)?]) } else { None };
        found.filter(|[first, second]| first != second)
    }

    /// Whether the gradient was corrected because the optimum is not at a meeting; decided from the generators that
    /// cross a cell around the meeting.
    pub(crate) fn is_corrected(&mut self, meeting: &Meeting, reduced: &Reduced, chart: &RoundedChart) -> bool {
        let pair = [meeting.first, meeting.second];
        let mut sums = [[0.0; 3]; 2];
        let mut others = reduced.fixed.sum;
        for v in &reduced.vectors {
            match pair.iter().position(|&i| is_along(v, &self.classes[i].unit)) {
                Some(place) => {
                    let sign = f64::copysign(1.0, dot(&self.classes[pair[place]].unit, v));
                    sums[place] = [0, 1, 2].map(|k| sums[place][k] + sign * v[k]);
                }
                None => {
                    // a line through the same vertex, or nearly: with the sign at its centre
                    let [a, b, c] = chart.line(v);
                    let [x, y] = meeting.guess.point;
                    let sign = f64::copysign(1.0, a * x + b * y + c);
                    others = [0, 1, 2].map(|k| others[k] + sign * v[k]);
                }
            }
        }
        let [[a, b, _], [c, d, _]] = sums.map(|sum| chart.line(&sum));
        let [x, y, _] = chart.line(&others);
        let determinant = (a * d - b * c).abs();
        let is_optimal = (x * d - y * c).abs() <= COEFFICIENT_MARGIN * determinant
            && (a * y - b * x).abs() <= COEFFICIENT_MARGIN * determinant;
        let [px, py] = meeting.guess.point;
        let mut own = [0.0; 2];
        for (_, [a, b, c, _]) in self.lines.iter().enumerate().filter(|(i, _)| !pair.contains(i)) {
            let sign = f64::copysign(1.0, a * px + b * py + c);
            own = [own[0] + sign * a, own[1] + sign * b];
        }
        self.linear = [self.part * x - own[0], self.part * y - own[1]];
        !is_optimal
    }
}

/// The sine of an angle below which two directions differ by rounding alone.
const ROUNDING_SINE: f64 = 1e-14;

/// A meeting counts as the optimum where the coefficients of its two classes are at most this.
const COEFFICIENT_MARGIN: f64 = 1.0 + 1e-6;

fn unit(v: &[f64; 3]) -> Option<[f64; 3]> {
    let size = v.iter().fold(0.0f64, |m, c| m.max(c.abs()));
    let unit = v.map(|c| c / size);
    unit.iter().all(|c| c.is_finite()).then_some(unit)
}

/// The square of the sine of the angle between two directions whose largest coordinate is ±1, but for a factor from 1
/// to 9.
fn sine_square([a, b, c]: &[f64; 3], [d, e, f]: &[f64; 3]) -> f64 {
    let [x, y, z] = [b * f - c * e, c * d - a * f, a * e - b * d];
    x * x + y * y + z * z
}

/// Whether any of some generators of a sample are parallel to each other or to their neighbours: in a list that is
/// sorted by direction, those at a distance differ and neighbours are parallel.
fn seem_repeated(sample: &[[f64; 3]]) -> bool {
    let step = (sample.len() / PROBES).max(1);
    let pick = |offset: usize| {
        let mut picked = [[0.0; 3]; PROBES];
        for (own, v) in picked.iter_mut().zip(sample.iter().skip(offset).step_by(step)) {
            *own = *v;
        }
        picked
    };
    dispatch!(level(), simd => are_repeated(simd, &pick(0), &pick(1)))
}

/// Whether a probe is parallel to a probe before it or to its neighbour. A probe of zero is parallel to none.
#[inline(always)]
fn are_repeated<S: Simd>(simd: S, probes: &[[f64; 3]; PROBES], neighbours: &[[f64; 3]; PROBES]) -> bool {
    let octets = Octets::new(probes, &[]);
    let [first, second] = [octets.load(simd, 0), octets.load(simd, 1)];
    let followers = Octets::new(neighbours, &[]);
    let mut found = are_parallel(simd, &first, &followers.load(simd, 0)).to_bitmask()
        | are_parallel(simd, &second, &followers.load(simd, 1)).to_bitmask();
    for (place, probe) in probes.iter().enumerate() {
        let probe = splat(simd, probe);
        let own = 1 << (slot(place) % LANES);
        if place < LANES {
            found |= are_parallel(simd, &probe, &first).to_bitmask() & !own;
            found |= are_parallel(simd, &probe, &second).to_bitmask();
        } else {
            found |= are_parallel(simd, &probe, &second).to_bitmask() & !own;
        }
    }
    found != 0
}

/// Whether the angle of vectors in a lane is that of parallel ones but for noise.
#[inline(always)]
fn are_parallel<S: Simd>(simd: S, a: &Octet<S>, b: &Octet<S>) -> mask64x8<S> {
    let x = a[1] * b[2] - a[2] * b[1];
    let y = a[2] * b[0] - a[0] * b[2];
    let z = a[0] * b[1] - a[1] * b[0];
    let limit = f64x8::splat(simd, PARALLEL_SINE * PARALLEL_SINE);
    (x * x + y * y + z * z).simd_lt(limit * product(a, a) * product(b, b))
}

fn is_along(v: &[f64; 3], unit: &[f64; 3]) -> bool {
    sine_square(v, unit) < 4.0 * PARALLEL_SINE * PARALLEL_SINE * dot(v, v)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chart() -> RoundedChart {
        RoundedChart::new([0.0, 0.0, 1.0])
    }

    #[test]
    fn few_directions_are_told_from_many() {
        let few: Vec<[f64; 3]> = (0..60)
            .map(|i| [[1.0, 0.0, 0.2], [0.0, 1.0, 0.3], [1.0, 1.0, 1.0]][i % 3].map(|c| c * (1.0 + i as f64)))
            .collect();
        let classes = ParallelClasses::of(&few, 1.0, &chart()).expect("three directions");
        assert_eq!(classes.classes.len(), 3);
        let many: Vec<[f64; 3]> = (0..60).map(|i| [1.0, f64::from(i), f64::from(i * i)]).collect();
        assert!(ParallelClasses::of(&many, 1.0, &chart()).is_none());
    }

    #[test]
    fn a_wrong_meeting_is_corrected() {
        // lines x = −0.2, y = −0.3 of weight 1 and x + y = −1 of weight w: with w = 3 the optimum is where the heavy
        // one meets another
        let body = |w: f64| [[1.0, 0.0, 0.2], [0.0, 1.0, 0.3], [w, w, w]];
        let sample = body(0.1);
        let repeated: Vec<[f64; 3]> = sample.iter().copied().cycle().take(24).collect();
        let mut classes = ParallelClasses::of(&repeated, 1.0, &chart()).expect("three directions");
        let first = classes.meeting(&chart()).expect("there is one");
        let mut pair = [first.first, first.second];
        pair.sort_unstable();
        assert_eq!(pair, [0, 1]);
        let truth: Vec<[f64; 3]> = body(3.0).iter().copied().cycle().take(24).collect();
        let query = crate::collision::Query::new([0.0; 3], [0.0, 0.0, 1.0], &truth).expect("finite");
        let reduced = Reduced::of_query(&query, chart().cell(&first.guess, 1.0));
        assert_eq!(reduced.vectors.len(), 16);
        assert!(classes.is_corrected(&first, &reduced, &chart()));
        let second = classes.meeting(&chart()).expect("there is one");
        assert!(second.first == 2 || second.second == 2, "{second:?}");
    }
}
