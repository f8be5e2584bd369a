//! Where the next optimum is to be expected, and how far from there it may be.
//!
//! No rule fits all motions, so three are asked, and the one that was nearest of late is believed:
//!
//! - *still*: the optimum stays where it is in space, as for a round body of many small facets that spins, or far
//!   apart bodies;
//! - *carried*: it is the normal of the same two generators, each moved with its own body, as where a facet, or an
//!   edge on an edge, stays in contact: then the optimum is the same vertex of the arrangement, and this rule is exact;
//! - *straight on*: it goes as far as it did in the frame before, as where bodies slide along each other.
//!
//! A rule's *drift* is the distance by which it missed, between directions of length 1; it is forgotten by half each
//! frame. The cell that a search begins with is a few drifts wide.

use crate::lad::of_generators::seam::generators::Generators;
use crate::numeric::linear::{cross, dot, euclidean_norm, max_norm};

/// The drift where no rule was tried yet.
const FIRST_DRIFT: f64 = 1.0 / 256.0;

/// The drift that is left of one after a frame that saw a smaller one.
const MEMORY: f64 = 0.5;

/// The optimum of the last frames, as directions of length 1.
#[derive(Debug, Clone)]
pub(super) struct Prediction {
    last: [f64; 3],
    before: Option<[f64; 3]>,
    basis: Option<[usize; 2]>,
    /// None of a rule that was never tried.
    drifts: [Option<f64>; 3],
}

/// A direction of length 1 in which the optimum is expected, and by how much the rule missed of late.
#[derive(Debug, Clone, Copy)]
pub(super) struct Expected {
    pub(super) direction: [f64; 3],
    pub(super) drift: f64,
}

impl Prediction {
    /// From the first optimum; none if it has no direction.
    pub(super) fn new(optimum: [f64; 3], basis: Option<[usize; 2]>) -> Option<Self> {
        Some(Self { last: unit(&optimum)?, before: None, basis, drifts: [None; 3] })
    }

    /// The direction of the rule that was nearest, for the generators where they are now.
    pub(super) fn expected(&self, generators: &dyn Generators) -> Expected {
        let rules = self.rules(generators).into_iter().zip(self.drifts);
        let tried = rules.filter_map(|(direction, drift)| Some(Expected { direction: direction?, drift: drift? }));
        let best = tried.min_by(|a, b| a.drift.total_cmp(&b.drift));
        best.unwrap_or(Expected { direction: self.last, drift: FIRST_DRIFT })
    }

    /// Takes note of an optimum, which the rules are measured by.
    pub(super) fn learn(&mut self, generators: &dyn Generators, optimum: [f64; 3], basis: Option<[usize; 2]>) {
        let Some(found) = unit(&optimum) else { return };
        let rules = self.rules(generators);
        for (drift, direction) in self.drifts.iter_mut().zip(rules) {
            if let Some(direction) = direction {
                let missed = euclidean_norm(&difference(&found, &direction));
                *drift = Some(missed.max(MEMORY * drift.unwrap_or(0.0)));
            }
        }
        self.before = Some(self.last);
        self.last = found;
        self.basis = basis;
    }

    /// Takes note of a frame without an optimum, in which a prediction was good enough.
    pub(super) fn confirm(&mut self) {
        if self.drifts == [None; 3] {
            self.drifts[0] = Some(FIRST_DRIFT);
        }
        self.drifts = self.drifts.map(|drift| drift.map(|drift| MEMORY * drift));
    }

    /// What each rule says.
    fn rules(&self, generators: &dyn Generators) -> [Option<[f64; 3]>; 3] {
        let carried = self.basis.and_then(|basis| {
            let [a, b] = basis.map(|index| generators.generator(index));
            let [a, b] = [unit(&a)?, unit(&b)?];
            let normal = unit(&cross(&a, &b))?;
            Some(if dot(&normal, &self.last) < 0.0 { normal.map(|c| -c) } else { normal })
        });
        let on = self.before.and_then(|before| {
            let way = difference(&self.last, &before);
            unit(&[0, 1, 2].map(|k| self.last[k] + way[k]))
        });
        [Some(self.last), carried, on]
    }
}

fn difference(a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|k| a[k] - b[k])
}

/// The direction of a vector, of length 1 but for rounding; none of zero and of what is not finite.
fn unit(v: &[f64; 3]) -> Option<[f64; 3]> {
    let largest = max_norm(v);
    if !(largest > 0.0 && v.iter().all(|c| c.is_finite())) {
        return None;
    }
    let scaled = v.map(|c| c / largest);
    let length = euclidean_norm(&scaled);
    Some(scaled.map(|c| c / length))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::Query;
    use crate::zonotope::pose::Pose;

    const GENERATORS: [[f64; 3]; 3] = [[3.0, 0.0, 0.0], [0.0, 1e-3, 0.0], [1.0, 1.0, 1.0]];

    fn of(generators: &[[f64; 3]]) -> Query<'_, 3> {
        Query::of_finite([0.0; 3], [0.0; 3], generators)
    }

    fn turned(angle: f64) -> Vec<[f64; 3]> {
        let pose = Pose::from_axis_angle([1.0, 0.0, 0.0], angle, [0.0; 3]).expect("an axis");
        let image = |v: &[f64; 3]| pose.matrix().map(|row| dot(&row, v));
        GENERATORS.iter().map(image).collect()
    }

    /// What is expected after frames with these optima, for the generators as they are now.
    fn expected(optima: &[[f64; 3]], basis: Option<[usize; 2]>, turns: f64) -> Expected {
        let (first, others) = optima.split_first().expect("there is an optimum");
        let mut prediction = Prediction::new(*first, basis).expect("it has a direction");
        for (i, optimum) in others.iter().enumerate() {
            prediction.learn(&of(&turned(turns * (i + 1) as f64)), *optimum, basis);
        }
        prediction.expected(&of(&turned(turns * optima.len() as f64)))
    }

    fn is_near(expected: Expected, direction: [f64; 3]) -> bool {
        euclidean_norm(&difference(&expected.direction, &direction)) < 1e-9
    }

    #[test]
    fn the_rule_that_was_right_is_believed() {
        // the facet of the first two generators turns, and so does its normal
        let normal = |angle: f64| [0.0, -libm::sin(angle), libm::cos(angle)];
        let carried = expected(&[0.0, 0.1, 0.2].map(normal), Some([0, 1]), 0.1);
        assert!(is_near(carried, normal(0.3)) && carried.drift < 1e-12);
        let still = expected(&[[0.0, 0.0, 5.0]; 3], Some([0, 1]), 0.1);
        assert!(is_near(still, [0.0, 0.0, 1.0]) && still.drift == 0.0);
        // without a basis the change is what goes on
        let on = expected(&[0.0, 0.01, 0.02, 0.03].map(normal), None, 0.0);
        assert!(euclidean_norm(&difference(&on.direction, &normal(0.04))) < 1e-4 && on.drift < 1e-3);
    }

    #[test]
    fn drifts_are_forgotten_by_half() {
        let mut prediction = Prediction::new([0.0, 0.0, 2.0], None).expect("it has a direction");
        assert_eq!(prediction.expected(&of(&GENERATORS)).drift, FIRST_DRIFT);
        prediction.learn(&of(&GENERATORS), [0.0, 1.0, 0.0], None);
        assert_eq!(prediction.expected(&of(&GENERATORS)).drift, 2.0f64.sqrt());
        prediction.confirm();
        assert_eq!(prediction.expected(&of(&GENERATORS)).drift, 2.0f64.sqrt() / 2.0);
        assert!(Prediction::new([0.0; 3], None).is_none() && Prediction::new([f64::NAN, 1.0, 0.0], None).is_none());
    }
}
