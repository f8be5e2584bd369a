//! The kernel in three variables, by exact line searches along the edges of the plane arrangement.
//!
//! # Statement
//! Input: weighted planes and a linear term. Output: a minimiser of linear · x + Σ w_i |a_i · x + b_i| with the exact
//! minimum and a certificate, or a direction in which the objective falls without end. Where the minimiser is not
//! unique one is returned. No planes, planes without normal, parallel, equal and concurrent planes are ordinary input.
//!
//! # Source
//! Beyond the paper, which asks in its last section for the intersection of zonotopes in space-time: the kernel of
//! Sections 4.1 and 5.1 with one more variable. Where the kernel in the plane prunes, this one only starts at the
//! optimum of a sample, which is simpler: no cell, no summed-up planes, at the price of a pass over all planes for
//! every step from there.
//!
//! # Method
//! 1. Start at a point, pinned down by three planes without weight; among many planes, at the optimum of every eighth,
//!    found in the same way.
//! 2. At a vertex, try both ways along the three edges of its basis; if the objective falls along one, take the
//!    steepest and go to its lowest vertex (`line_search`): a plane leaves the basis, another enters.
//! 3. If no edge falls and only the basis passes through the vertex, it is optimal. So it is where the coefficients
//!    that the basis needs, with 0 for the other planes, do not exceed 1.
//! 4. Else the planes through the vertex are moved apart at random and solved as a problem of their own, with the
//!    gradient of the others as its linear term. Its certificate depends on normals alone, so it is valid for the
//!    vertex; if it is unbounded, the objective falls along that direction.
//!
//! # Complexity
//! n planes, s steps: O(n) for a line search, O(n s) in all, space O(n). The number of steps has no polynomial bound
//! here; on random planes it is a few tens.
//!
//! # Shapes
//! planes: n × (3 + 1 + 1), any order, duplicates allowed.
//!
//! # Numerics
//! Vertices are exact. Signs and slopes are decided by floating point where a bound on its error allows, else exactly.
//!
//! # Checked by
//! [`brute_force`](super::brute_force) on every family, the crate `verifier` for certificates.
//!
//! # Example
//! ```
//! use zonotope::lad::of_forms::{SpaceLadProblem, SpaceOutcome, WeightedPlane, minimize};
//! let plane = |normal, offset| WeightedPlane { normal, offset, weight: 1.0 };
//! let planes = vec![plane([1.0, 0.0, 0.0], -1.0), plane([0.0, 2.0, 0.0], -4.0), plane([0.0, 0.0, 1.0], 3.0)];
//! let problem = SpaceLadProblem::new(planes, [0.5, 0.0, 0.0]).unwrap();
//! let SpaceOutcome::Optimal(optimum) = minimize(&problem, &mut ()) else { panic!() };
//! assert_eq!(optimum.point, [1.into(), 2.into(), (-3).into()]);
//! ```

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::instance::{Instance, Source};
use super::line_search::lowest;
use super::outcome::{SpaceCertificate, SpaceOptimum, SpaceOutcome};
use super::problem::SpaceLadProblem;
use super::vector4::{Vector4, negated4, plus_multiple};
use super::vertex::{Plane, Vertex};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::dot;
use crate::tally::Tally;

/// Number of planes from which on the search starts at the optimum of a sample.
const SMALLEST_SAMPLED_PROBLEM: usize = 1024;

/// Minimises a problem: a minimiser with its proof, or a direction in which the objective falls without end.
pub fn minimize(problem: &SpaceLadProblem, tally: &mut impl Tally) -> SpaceOutcome {
    let [x, y, z] = problem.linear().map(Dyadic::from_f64);
    let forms = problem.planes().iter().map(|plane| {
        let [a, b, c] = plane.normal;
        [a, b, c, plane.offset].map(|v| Dyadic::from_f64(plane.weight) * Dyadic::from_f64(v))
    });
    let chart = [0.0, 0.0, 0.0, 1.0].map(Dyadic::from_f64);
    let instance = Instance::new(chart.clone(), [x, y, z, Dyadic::zero()], Source::Exact(forms.collect()));
    match descend(&instance, &chart, tally) {
        Descent::Unbounded { direction, .. } => {
            let [x, y, z, _] = direction.map(|v| v.to_rational());
            SpaceOutcome::Unbounded { direction: [x, y, z] }
        }
        Descent::Optimal { point, gradient, certificate } => {
            let value = dot(&gradient, &point).to_rational();
            let [x, y, z, w] = point.map(|v| v.to_rational());
            SpaceOutcome::Optimal(SpaceOptimum { point: [x / &w, y / &w, z / &w], value: value / &w, certificate })
        }
    }
}

/// The end of a descent.
#[derive(Debug)]
pub(crate) enum Descent {
    /// The descent ends at an optimal point.
    Optimal {
        /// The point in homogeneous coordinates, with chart · point > 0.
        point: Vector4,
        /// The gradient linear + Σ sign · form over the forms that do not vanish at the point. Its product with the
        /// point is the minimum times chart · point.
        gradient: Vector4,
        certificate: SpaceCertificate,
    },
    /// The descent does not end: the objective falls for ever along a direction on two planes.
    Unbounded { direction: Vector4, along: [ProblemPlane; 2] },
}

/// One of two planes along which a direction runs.
#[derive(Debug)]
pub(crate) struct ProblemPlane(Plane);

/// Descends from a point of the chart, or from where a sample has its optimum, to an optimum.
pub(crate) fn descend(instance: &Instance, start: &Vector4, tally: &mut impl Tally) -> Descent {
    let mut search = Search { random: Pcg64Mcg::seed_from_u64(0), tally };
    let start = search.start(instance, start);
    search.descend(instance, &start)
}

/// A direction and two planes on which it runs.
type Way = (Vector4, [Plane; 2]);

/// The decision at a vertex from which the objective falls along no edge of its basis.
enum Decision {
    Optimal(SpaceCertificate),
    Falls(Box<Way>),
}

struct Search<'t, T> {
    random: Pcg64Mcg,
    tally: &'t mut T,
}

impl<T: Tally> Search<'_, T> {
    /// The rounded optimum of a sample, which is found from that of a smaller sample; the given point where the sample
    /// has no optimum.
    fn start(&mut self, instance: &Instance, given: &Vector4) -> Vector4 {
        if instance.len() < SMALLEST_SAMPLED_PROBLEM {
            return given.clone();
        }
        let sample = instance.sample();
        let start = self.start(&sample, given);
        match self.descend(&sample, &start) {
            Descent::Optimal { point, .. } => {
                let largest = point.iter().filter_map(Dyadic::binary_exponent).max().unwrap_or(0);
                let rounded = point.map(|v| Dyadic::from_f64(v.scaled(-largest).to_f64()));
                if dot(&instance.chart, &rounded).sign().is_gt() { rounded } else { given.clone() }
            }
            Descent::Unbounded { .. } => given.clone(),
        }
    }

    fn descend(&mut self, instance: &Instance, start: &Vector4) -> Descent {
        let mut vertex = Vertex::at(instance, start, self.tally);
        loop {
            let (direction, kept) = match self.steepest_edge(instance, &vertex) {
                Some(edge) => edge,
                None => match self.decide(instance, &vertex) {
                    Decision::Optimal(certificate) => return optimal(instance, &vertex, certificate),
                    Decision::Falls(way_down) => *way_down,
                },
            };
            let direction = instance.probe(direction);
            let [(slope, _), _] = vertex.slopes(instance, &direction, self.tally);
            match lowest(instance, &vertex, &kept, &direction, slope, &mut self.random, self.tally) {
                Some(next) => vertex = next,
                None => {
                    return Descent::Unbounded { direction: direction.exact, along: kept.map(ProblemPlane) };
                }
            }
        }
    }

    /// The edge of the basis along which the objective falls most steeply, with the two planes on which the edge runs.
    fn steepest_edge(&mut self, instance: &Instance, vertex: &Vertex) -> Option<Way> {
        let mut best: Option<(f64, usize, bool, Vector4)> = None;
        for k in 0..3 {
            let edge = instance.probe(vertex.edge(instance, k));
            for (back, (slope, falls)) in vertex.slopes(instance, &edge, self.tally).into_iter().enumerate() {
                if falls && best.as_ref().is_none_or(|(steepest, ..)| slope < *steepest) {
                    best = Some((slope, k, back == 1, edge.exact.clone()));
                }
            }
        }
        best.map(|(_, k, back, edge)| {
            let kept = [(k + 1) % 3, (k + 2) % 3].map(|other| vertex.basis[other].clone());
            (if back { negated4(edge) } else { edge }, kept)
        })
    }

    /// Decides at a vertex from which the objective falls along no edge of its basis: a plane through it off the basis
    /// may still let it fall.
    fn decide(&mut self, instance: &Instance, vertex: &Vertex) -> Decision {
        let mut basis: Vec<u32> = vertex.basis.iter().filter_map(|plane| plane.index).collect();
        basis.sort_unstable();
        if basis.len() == vertex.through.len() || vertex.is_balanced(instance) {
            return Decision::Optimal(SpaceCertificate { signs: vertex.signs.clone(), basis });
        }
        let apart = vertex.through.iter().map(|&i| self.moved(instance, instance.form(i as usize))).collect();
        let local =
            Instance::new(instance.chart.clone(), vertex.exact_gradient(instance).clone(), Source::Exact(apart));
        match self.descend(&local, &vertex.point.exact) {
            Descent::Optimal { certificate, .. } => {
                let mut signs = vertex.signs.clone();
                for (&i, &sign) in vertex.through.iter().zip(&certificate.signs) {
                    signs[i as usize] = sign;
                }
                let basis = certificate.basis.iter().map(|&k| vertex.through[k as usize]).collect();
                Decision::Optimal(SpaceCertificate { signs, basis })
            }
            Descent::Unbounded { direction, along } => {
                let back = |ProblemPlane(plane): ProblemPlane| match plane.index {
                    Some(k) => {
                        let index = vertex.through[k as usize];
                        Plane { index: Some(index), form: instance.form(index as usize) }
                    }
                    None => vertex.parallel(instance, &plane),
                };
                Decision::Falls(Box::new((direction, along.map(back))))
            }
        }
    }

    /// A plane parallel to the given one at a random distance.
    fn moved(&mut self, instance: &Instance, form: Vector4) -> Vector4 {
        let exponent = |v: &Vector4| v.iter().filter_map(Dyadic::binary_exponent).max().unwrap_or(0);
        let scale = exponent(&form) - exponent(&instance.chart) - 30;
        let distance = f64::from(self.random.random_range(1..=i32::MAX));
        let distance = if self.random.random_range(0..2) == 0 { distance } else { -distance };
        plus_multiple(&form, &Dyadic::from_f64(distance).scaled(scale), &instance.chart)
    }
}

fn optimal(instance: &Instance, vertex: &Vertex, certificate: SpaceCertificate) -> Descent {
    Descent::Optimal {
        point: vertex.point.exact.clone(),
        gradient: vertex.exact_gradient(instance).clone(),
        certificate,
    }
}
