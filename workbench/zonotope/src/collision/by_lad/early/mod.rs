//! Points far inside and far outside, told and proved in few passes: by the smooth problem of `dual`, on a sample first.
//!
//! The y that solves it for a sample either separates, so that one pass over all generators proves it, or coefficients are written that the
//! sample steers (`turns`). Small bodies need no sample (`least`), a flat one needs its plane (`flat`). Where that does not do, the sums of all
//! generators at some y give coefficients. Where the sample says that the point is near the boundary, nothing is tried.

pub(crate) mod combination;
pub(crate) mod huber_dual;
pub(crate) mod least_squares;
pub(crate) mod stratified_pass;

use std::array;

use crate::collision::by_lad::early::combination::Combination;
use crate::collision::by_lad::early::huber_dual::{Lengths, Moments, Runs, dot};
use crate::collision::by_lad::early::least_squares::{Open, tell, tell_flat};
use crate::collision::by_lad::early::stratified_pass::Turns;
use crate::collision::{Location, Query, Separation, Witness};
use crate::lad::of_generators::ladder::rounded_displacement;
use crate::lad::of_generators::span::flat::SimplePlane;
use crate::lad::of_generators::span::prism::Prism;
use crate::lad::of_generators::support::{reach, separates};
use crate::numeric::bounded::{self, BoundedVector};
use crate::tally::{Operation, Tally};
use crate::zonotope::passes::bounded_sum;

/// With at most so many generators no sample is taken.
const ALL: usize = 320;

/// With at most so many the coefficients are in terms of their own lengths.
const FEW: usize = 16;

/// A point whose gauge seems to be between these is near the boundary.
pub(crate) const INSIDE: f64 = 0.9;
const OUTSIDE: f64 = 1.0;

/// How many deviations a sample must see between a point outside and the boundary.
const DEVIATIONS: f64 = 1.0;

/// A step that ends with a slope of more than this, in terms of that at its start, goes too far.
const FAR: f64 = 0.3;

/// The most steps on a sample, and on all generators.
const STEPS: [usize; 2] = [12, 6];

/// What the smooth problem says of a point.
enum Sign {
    Inside(Combination),
    Outside([f64; 3]),
    Neither,
}

/// What is clear, with its proof.
pub(crate) enum Clear {
    Inside(Witness),
    /// In a flat body.
    Flat(Witness),
    Outside([f64; 3]),
}

impl Clear {
    /// The answer in a space of which no coordinate is missing.
    pub(crate) fn location<const D: usize>(self) -> Location<D> {
        match self {
            Self::Inside(witness) => Location::Inside(witness),
            Self::Flat(witness) => Location::Boundary(witness),
            Self::Outside(u) => Location::Outside(Separation::Rounded(array::from_fn(|i| u[i]))),
        }
    }
}

/// The status of p with its proof, if that is clear.
#[inline]
pub(crate) fn locate(query: &Query<'_, 3>, tally: &mut impl Tally) -> Option<Clear> {
    let p = rounded_displacement(query);
    let n = query.len();
    if n > ALL {
        return locate_by_sample(query, &p, tally);
    }
    tally.add(Operation::GeneratorRead, n as u64);
    let told = if n <= FEW { tell::<true, FEW>(query, &p) } else { tell::<false, ALL>(query, &p) };
    told.map_or_else(|open| locate_by_steps(query, &p, &open, tally), Some)
}

/// The same of a member of a body that seems to be flat.
fn locate_flat(query: &Query<'_, 3>, p: &BoundedVector, tally: &mut impl Tally) -> Option<Clear> {
    let plane = SimplePlane::of(query)?;
    tally.add(Operation::GeneratorRead, 2 * query.len() as u64);
    let open = match tell_flat(query, p, &plane) {
        Ok(witness) => return Some(Clear::Flat(witness)),
        Err(open) => open,
    };
    if !(open.is_thick && open.gauge < INSIDE) {
        return None;
    }
    // clipped coefficients are those of the prism over what is left without a coordinate
    let prism = Prism::without(plane.axis(), query);
    let body = prism.query();
    let first = body.runs()[0];
    let steps = State::new(&plane.projected(&open.y), open.gauge);
    match steps.prove(&body, &rounded_displacement(&body), Lengths::Own, &first[..first.len().min(ALL)], tally)? {
        Clear::Inside(witness) => Some(Clear::Flat(prism.lower_witness(witness))),
        Clear::Flat(_) | Clear::Outside(_) => None,
    }
}

/// The proof of a point inside whose least coefficients are too large.
fn locate_by_steps(query: &Query<'_, 3>, p: &BoundedVector, open: &Open, tally: &mut impl Tally) -> Option<Clear> {
    // false for NaN as well
    let is_likely = open.gauge < INSIDE;
    if !is_likely {
        return None;
    }
    if !open.is_thick {
        return locate_flat(query, p, tally);
    }
    let first = query.runs()[0];
    if query.len() <= FEW {
        return State::new(&open.y, open.gauge).prove(query, p, Lengths::Own, first, tally);
    }
    match Lengths::of(query.runs()) {
        Lengths::Own => locate_by_all(query, p, tally),
        // products are taken as they are: y is in terms of any one length
        Lengths::Even(_) => State::new(&open.y, open.gauge).prove(query, p, Lengths::Even(1.0), first, tally),
    }
}

/// The same from all generators, in terms of their own lengths.
fn locate_by_all(query: &Query<'_, 3>, p: &BoundedVector, tally: &mut impl Tally) -> Option<Clear> {
    tally.add(Operation::GeneratorRead, query.len() as u64);
    let own = p.map(|c| c.value);
    let (y, is_thick) = Moments::at_zero(query.runs(), Lengths::Own).solve(&own);
    let reach = reach(query, &y);
    let along = bounded::dot(p, &bounded::exact(y));
    if (along - reach).is_positive() {
        return Some(Clear::Outside(y));
    }
    // at least that of p; NaN is nowhere
    let gauge = along.value / reach.value;
    if !(is_thick && gauge < INSIDE) {
        return None;
    }
    let first = query.runs()[0];
    let among = &first[..first.len().min(ALL)];
    let least = Combination::least(y, Lengths::Own, among, true);
    let told = least.and_then(|least| inside(query, p, &least, tally));
    told.or_else(|| State::new(&y, gauge).prove(query, p, Lengths::Own, among, tally))
}

fn locate_by_sample(query: &Query<'_, 3>, p: &BoundedVector, tally: &mut impl Tally) -> Option<Clear> {
    let turns = Turns::of(query.len());
    let few = turns.last(query);
    tally.add(Operation::GeneratorRead, few.len() as u64);
    let part = few.len() as f64 / query.len() as f64;
    let own = p.map(|c| c.value * part);
    let lengths = Lengths::of([&few, &[]]);
    let least = Moments::at_zero([&few, &[]], lengths);
    let (y, is_thick) = least.solve(&own);
    let gauge = dot(&own, &y) / bounded_sum(&few, &y).value;
    if gauge > OUTSIDE + DEVIATIONS / (few.len() as f64).sqrt()
        && let Some(clear) = outside(query, p, y, tally)
    {
        return Some(clear);
    }
    if lengths == Lengths::Own {
        // the longest are not in the sample
        return locate_by_all(query, p, tally);
    }
    if !is_thick && gauge < INSIDE {
        return locate_flat(query, p, tally);
    }
    if !(is_thick && gauge < INSIDE) {
        return None;
    }
    let start = State::new(&y, gauge);
    let (mut state, mut is_linear) = (start, true);
    let steer = |target: &[f64; 3], exact: bool| {
        if is_linear {
            let (z, _) = least.solve(target);
            let combination = Combination::least(z, lengths, &few, exact);
            is_linear = combination.is_some();
            if is_linear {
                return combination;
            }
        }
        match state.settle([&few, &[]], lengths, target, &few, Effort { steps: STEPS[0], exact }) {
            Sign::Inside(combination) => Some(combination),
            Sign::Outside(_) | Sign::Neither => None,
        }
    };
    tally.add(Operation::GeneratorRead, query.len() as u64);
    let witness = turns.witness(query, p, few.len(), steer).map(Clear::Inside);
    witness.or_else(|| start.prove(query, p, lengths, &few, tally))
}

/// How long coefficients are looked for, and whether they are to be exact.
#[derive(Debug, Clone, Copy)]
struct Effort {
    steps: usize,
    exact: bool,
}

/// A Newton step, and the slope along it where it starts.
struct Step {
    from: [f64; 3],
    step: [f64; 3],
    slope: f64,
}

impl Step {
    /// Where the slope may be zero, if it is positive at the end and not much less steep than it was negative at the start.
    fn shortened(self, end: &Moments, target: &[f64; 3]) -> Option<[f64; 3]> {
        let slope = end.slope(&self.step, target);
        let part = (self.slope / (self.slope - slope)).max(0.02);
        (slope > -FAR * self.slope).then(|| [0, 1, 2].map(|k| self.from[k] + part * self.step[k]))
    }
}

/// Where the Newton steps are, and how large the gauge of p is at least.
#[derive(Debug, Clone, Copy)]
struct State {
    y: [f64; 3],
    gauge: f64,
    /// The sums at y, where they are known.
    at: Option<Moments>,
}

impl State {
    /// From the y that makes up p without clipping.
    fn new(y: &[f64; 3], gauge: f64) -> Self {
        let state = Self { y: *y, gauge, at: None };
        Self { y: y.map(|c| c * state.aim()), ..state }
    }

    /// How far beyond p the coefficients are made for: half the way to the boundary, so that they can be made smaller.
    fn aim(&self) -> f64 {
        (1.0 + 1.0 / self.gauge) / 2.0
    }

    /// The proof of a point by clipped coefficients.
    fn prove(
        mut self,
        query: &Query<'_, 3>,
        p: &BoundedVector,
        lengths: Lengths,
        among: &[[f64; 3]],
        tally: &mut impl Tally,
    ) -> Option<Clear> {
        tally.add(Operation::GeneratorRead, query.len() as u64);
        match self.settle(query.runs(), lengths, &p.map(|c| c.value), among, Effort { steps: STEPS[1], exact: true }) {
            Sign::Inside(combination) => inside(query, p, &combination, tally),
            Sign::Outside(y) => outside(query, p, y, tally),
            Sign::Neither => None,
        }
    }

    /// Newton steps until there are coefficients for p or a direction that separates.
    fn settle(&mut self, runs: Runs<'_>, lengths: Lengths, p: &[f64; 3], among: &[[f64; 3]], effort: Effort) -> Sign {
        let mut before: Option<Step> = None;
        for _ in 0..effort.steps {
            let at = self.at.take().unwrap_or_else(|| Moments::at(runs, lengths, &self.y));
            let gauge = dot(p, &self.y) / at.reach;
            if gauge > 1.0 {
                return Sign::Outside(self.y);
            }
            self.gauge = self.gauge.max(gauge);
            let factor = self.aim();
            let target = p.map(|c| factor * c);
            if let Some(shorter) = before.take().and_then(|step| step.shortened(&at, &target)) {
                self.y = shorter;
                continue;
            }
            if let Some(combination) = at.combination(lengths, &self.y, p, among, effort.exact) {
                self.at = Some(at);
                return Sign::Inside(combination);
            }
            let step = at.step(&target);
            before = Some(Step { from: self.y, step, slope: at.slope(&step, &target) });
            self.y = [0, 1, 2].map(|k| self.y[k] + step[k]);
        }
        Sign::Neither
    }
}

fn outside(query: &Query<'_, 3>, p: &BoundedVector, y: [f64; 3], tally: &mut impl Tally) -> Option<Clear> {
    tally.add(Operation::GeneratorRead, query.len() as u64);
    separates(query, p, &y).then_some(Clear::Outside(y))
}

fn inside(query: &Query<'_, 3>, p: &BoundedVector, combination: &Combination, tally: &mut impl Tally) -> Option<Clear> {
    tally.add(Operation::GeneratorRead, query.len() as u64);
    combination.witness(query, p).map(Clear::Inside)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::brute_force;
    use crate::collision::verify::verify;
    use crate::tally::OperationCounts;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    /// Generators of three kinds: even, of lengths from 1 to thousands, nearly all nearly in a plane.
    fn body(kind: usize, n: usize, random: &mut Pcg64Mcg) -> Vec<[f64; 3]> {
        let mut vector = || {
            let [x, y, z] = [0, 1, 2].map(|_| random.random_range(-1.0..1.0f64));
            match kind {
                0 => [x, y, z],
                1 => [x, y, z].map(|c| c / (1.0 - random.random_range(0.0..1.0f64))),
                _ => [x, y, if random.random_range(0..10) == 0 { z } else { 1e-6 * z }],
            }
        };
        (0..n).map(|_| vector()).collect()
    }

    /// The point at which the ray along u leaves the body, taken so many times.
    fn point(body: &[[f64; 3]], u: [f64; 3], factor: f64) -> [f64; 3] {
        let p = body.iter().fold([0.0; 3], |sum, v| {
            let sign = f64::copysign(1.0, dot(v, &u));
            [0, 1, 2].map(|k| sum[k] + sign * v[k])
        });
        p.map(|c| factor * c)
    }

    #[test]
    fn what_is_clear_is_told_with_a_proof_and_mostly_at_once() {
        let random = &mut Pcg64Mcg::seed_from_u64(5);
        for kind in 0..3 {
            for n in [6, 15, 40, 129, 1100] {
                let (mut told, mut reads) = (0, 0);
                for i in 0..20 {
                    let body = body(kind, n, random);
                    let u = [0, 1, 2].map(|_| random.random_range(-1.0..1.0));
                    let factor = [0.0, 0.2, 0.6, 1.6, 9.0][i % 5];
                    let query = Query::new([0.0; 3], point(&body, u, factor), &body).expect("finite");
                    let mut counts = OperationCounts::default();
                    let Some(clear) = locate(&query, &mut counts) else { continue };
                    let location = clear.location::<3>();
                    assert_eq!(verify(&query, &location), Ok(()));
                    assert_eq!(location.status(), if factor < 1.0 { "inside" } else { "outside" });
                    (told, reads) = (told + 1, reads + counts.get(Operation::GeneratorRead));
                }
                assert!(told >= 14 && reads <= 4 * told * n as u64, "{kind} {n}: {told}, {reads}");
            }
        }
    }

    #[test]
    fn nothing_is_told_that_is_not_so() {
        let random = &mut Pcg64Mcg::seed_from_u64(7);
        for i in 0..300 {
            let body = body(i % 3, 3 + i % 7, random);
            let u = [0, 1, 2].map(|_| random.random_range(-1.0..1.0));
            let p = point(&body, u, random.random_range(0.7..1.4));
            let query = Query::new([0.0; 3], p, &body).expect("finite");
            if let Some(clear) = locate(&query, &mut ()) {
                let location = clear.location::<3>();
                assert_eq!(verify(&query, &location), Ok(()));
                assert_eq!(location.status(), brute_force::locate(&query).status());
            }
        }
    }

    #[test]
    fn extreme_bodies_are_left_to_others_and_so_are_most_flat_ones() {
        let is_told = |size: f64, body: &[[f64; 3]]| {
            let (p, body) = ([0.2, 0.3, 0.0].map(|c| size * c), body.iter().map(|v| v.map(|c| size * c)));
            let body: Vec<[f64; 3]> = body.collect();
            locate(&Query::new([0.0; 3], p, &body).expect("finite"), &mut ()).is_some()
        };
        let cube = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        assert!(is_told(1.0, &cube) && is_told(1e60, &cube) && is_told(1e-60, &cube));
        assert!(!is_told(f64::MAX, &cube) && !is_told(1e-200, &cube));
        // the plane's normal is (3, −2, 0)
        assert!(!is_told(1.0, &[]) && !is_told(1.0, &[[2.0, 3.0, 0.0], [2.0, 3.0, 1.0], [0.0, 0.0, 1.0]]));
        let square = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]];
        for p in [[0.9, -0.2, 0.0], [-1.2, -1.3, 0.0]] {
            let query = Query::new([0.0; 3], p, &square).expect("finite");
            let location = locate(&query, &mut ()).expect("it is in a simple plane").location::<3>();
            assert_eq!(verify(&query, &location), Ok(()));
            assert_eq!(location.status(), "boundary");
        }
        // beside a flat body a direction separates all the same
        let square = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let query = Query::new([0.0; 3], [0.5, 0.0, 1e-3], &square).expect("finite");
        assert!(matches!(locate(&query, &mut ()), Some(Clear::Outside(_))));
    }
}
