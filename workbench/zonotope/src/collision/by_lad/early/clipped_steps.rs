//! Clipped coefficients by Newton steps on the Huber dual: coefficients for a point well within the body, or a
//! direction that separates.

use super::INSIDE_GAUGE;
use super::combination::Combination;
use super::huber_dual::{Among, Lengths, Moments};
use crate::collision::Witness;
use crate::lad::of_generators::seam::generators::Generators;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::bounded::BoundedVector;
use crate::numeric::linear::dot;
use crate::tally::{Operation, Rung, Tally};
use crate::zonotope::location::Proof;

/// A step goes too far if it ends with a slope of more than this part of the slope at its start.
const OVERSHOOT: f64 = 0.3;

/// The most steps on a sample.
pub(super) const SAMPLE_STEPS: usize = 12;

/// The most steps on all generators.
const WHOLE_STEPS: usize = 6;

/// The end of Newton steps.
pub(super) enum StepsEnd {
    /// Coefficients that combine to the point.
    Inside(Combination),
    /// A direction that is likely to separate.
    Outside([f64; 3]),
    /// A point near the boundary, or too many steps.
    Neither,
}

/// The limit of a search for coefficients, and whether they are to be exact.
#[derive(Debug, Clone, Copy)]
pub(super) struct Effort {
    pub(super) steps: usize,
    pub(super) exact: bool,
}

/// A Newton step, and the slope along it where it starts.
struct Step {
    from: [f64; 3],
    step: [f64; 3],
    slope: f64,
}

impl Step {
    /// The point at which the slope may be zero, if the slope is positive at the end and not much less steep than it
    /// was negative at the start.
    fn shortened(self, end: &Moments, target: &[f64; 3]) -> Option<[f64; 3]> {
        let slope = end.slope(&self.step, target);
        let part = (self.slope / (self.slope - slope)).max(0.02);
        (slope > -OVERSHOOT * self.slope).then(|| [0, 1, 2].map(|k| self.from[k] + part * self.step[k]))
    }
}

/// The point of the Newton steps, and a lower bound of the gauge of p.
#[derive(Debug, Clone, Copy)]
pub(super) struct State {
    y: [f64; 3],
    gauge: f64,
    /// The sums at y, where they are known.
    at: Option<Moments>,
}

impl State {
    /// The start of the steps, from the y whose coefficients make up p without clipping.
    pub(super) fn new(y: &[f64; 3], gauge: f64) -> Self {
        let state = Self { y: *y, gauge, at: None };
        Self { y: y.map(|c| c * state.aim()), ..state }
    }

    /// The start of the steps at a y whose clipped coefficients nearly make up a point beyond p.
    pub(super) fn at(y: [f64; 3], gauge: f64) -> Self {
        Self { y, gauge, at: None }
    }

    /// The point of the steps.
    pub(super) fn y(&self) -> [f64; 3] {
        self.y
    }

    /// The multiple of p that the steps aim at, half the way from p to the boundary: its coefficients times f < 1 make
    /// up p and stay away from ±1.
    fn aim(&self) -> f64 {
        (1.0 + 1.0 / self.gauge) / 2.0
    }

    /// The proof of a point by steps on all generators.
    pub(super) fn prove(
        mut self,
        query: &impl KernelQuery,
        p: &BoundedVector,
        lengths: Lengths,
        among: Among<'_>,
        tally: &mut dyn Tally,
    ) -> Option<Proof> {
        tally.add(Operation::GeneratorRead, query.len() as u64);
        let effort = Effort { steps: WHOLE_STEPS, exact: true };
        let rung = Rung::ClippedCoefficients;
        match self.coefficients(query, lengths, &p.map(|c| c.value), among, effort) {
            StepsEnd::Inside(combination) => {
                inside(query, p, &combination, tally).map(|witness| Proof::inside(witness, rung))
            }
            StepsEnd::Outside(y) => separates(query, p, &y, tally).then(|| Proof::outside(y, rung)),
            StepsEnd::Neither => None,
        }
    }

    /// Newton steps until there are coefficients for p or a direction that separates.
    pub(super) fn coefficients(
        &mut self,
        generators: &impl Generators,
        lengths: Lengths,
        p: &[f64; 3],
        among: Among<'_>,
        effort: Effort,
    ) -> StepsEnd {
        let mut before: Option<Step> = None;
        for _ in 0..effort.steps {
            let at = self.at.take().unwrap_or_else(|| Moments::at(generators, lengths, &self.y));
            let gauge = dot(p, &self.y) / at.reach;
            if gauge > 1.0 {
                return StepsEnd::Outside(self.y);
            }
            if gauge > INSIDE_GAUGE {
                // steps that go on only creep up to the boundary, near which others decide
                return StepsEnd::Neither;
            }
            self.gauge = self.gauge.max(gauge);
            let factor = self.aim();
            let target = p.map(|c| factor * c);
            if let Some(shorter) = before.take().and_then(|step| step.shortened(&at, &target)) {
                self.y = shorter;
                continue;
            }
            if let Some(combination) = at.combination(generators, lengths, &self.y, p, among, effort.exact) {
                self.at = Some(at);
                return StepsEnd::Inside(combination);
            }
            let step = at.step(&target);
            before = Some(Step { from: self.y, step, slope: at.slope(&step, &target) });
            self.y = [0, 1, 2].map(|k| self.y[k] + step[k]);
        }
        StepsEnd::Neither
    }
}

/// Whether a direction separates. One pass.
pub(super) fn separates(query: &impl KernelQuery, p: &BoundedVector, y: &[f64; 3], tally: &mut dyn Tally) -> bool {
    tally.add(Operation::GeneratorRead, query.len() as u64);
    query.separates(p, y)
}

/// The proof of a member by a combination. One pass.
pub(super) fn inside(
    query: &impl KernelQuery,
    p: &BoundedVector,
    combination: &Combination,
    tally: &mut dyn Tally,
) -> Option<Witness> {
    tally.add(Operation::GeneratorRead, query.len() as u64);
    combination.witness(query, p)
}
