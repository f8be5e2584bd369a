//! Membership, intersection and gauge in R^4, by the kernel in three variables: minimise the support function over u ·
//! p = 1.
//!
//! # Statement
//! Input: a [`Query`] p and generators of R^4. Output: its [`Location`] relative to Z = { Σ δ_i v_i : |δ_i| ≤ 1 } with
//! a proof, and the [`Gauge`] min { t ≥ 0 : p ∈ t Z }. Z is closed: touching is [`Location::Boundary`], and so is every
//! member of a flat Z. Zero, parallel and dependent generators and none at all are ordinary input; p = 0 has the
//! gauge 0.
//!
//! # Source
//! The paper's last section asks whether zonotopes in space-time can be intersected as Theorem 5.2 does in space. They
//! can: the gauge is 1 / min { h(u) : u · p = 1 } with h(u) = Σ |v_i · u| in any dimension, a least-absolute-deviations
//! problem with one variable less.
//!
//! # Method
//! 1. The kernel in three variables (`lad::of_forms`) in homogeneous coordinates, the generators as its forms and p as
//!    its chart: an optimal u, and coefficients δ_i = ±1 off at most three generators with Σ δ_i v_i = λ p. The gauge
//!    is 1 / λ.
//! 2. λ < 1: u separates.
//! 3. λ ≥ 1: generators join the three until they span what all span. With the coefficients off this basis multiplied
//!    by a double near 1 / λ, or by 1, the basis solves Σ δ_i v_i = p exactly; if neither fits in [−1, 1], δ_i / λ is
//!    moved there (`settling`).
//!
//! # Complexity
//! n generators: as `lad::of_forms::by_line_search`, O(n) a step. Moving coefficients, needed only very near the
//! boundary, takes O(n) exact eliminations.
//!
//! # Shapes
//! generators: n × 4, any order, duplicates allowed.
//!
//! # Numerics
//! Every decision is exact. The gauge is rounded within `error`; beyond the range of doubles it is `f64::MAX` with
//! infinite error.
//!
//! # Checked by
//! [`brute_force`](super::brute_force) on every family, the crate `verifier` for each proof.
//!
//! # Example
//! ```
//! use zonotope::collision::{Query, Status, by_lad_in_r4};
//! // the cube [−1, 1]⁴ and the point (0, 3, 0, 1)
//! let cube = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];
//! let question = Query::new([0.0; 4], [0.0, 3.0, 0.0, 1.0], &cube).unwrap();
//! let gauge = by_lad_in_r4::gauge(&question, &mut ());
//! assert_eq!((gauge.value, gauge.location.status()), (3.0, Status::Outside));
//! ```

use super::proof::balance::solve::{left_over, solve};
use super::proof::to_doubles::rounded_off_a_basis;
use crate::lad::of_forms::SpaceCertificate;
use crate::lad::of_forms::homogeneous::{Descent, Instance, Source, Vector4, descend};
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::dot;
use crate::tally::Tally;
use crate::zonotope::location::{Gauge, Location, Separation, Witness};
use crate::zonotope::query::Query;

/// Where a displacement lies relative to the zonotope of its generators, with a proof.
pub fn locate(question: &Query<'_, 4>, tally: &mut impl Tally) -> Location<4> {
    gauge(question, tally).location
}

/// The gauge of a displacement and where it lies.
pub fn gauge(question: &Query<'_, 4>, tally: &mut impl Tally) -> Gauge<4> {
    let p = question.exact();
    let zero = || std::array::from_fn(|_| Dyadic::zero());
    if p.iter().all(Dyadic::is_zero) {
        let any = [1.0, 0.0, 0.0, 0.0].map(Dyadic::from_f64);
        let spans = Instance::new(any, zero(), Source::Doubles(question.runs())).spanning(&[]).len() == 4;
        let witness = Witness { coefficients: vec![0.0; question.len()], basis: Vec::new() };
        let location = if spans { Location::Inside(witness) } else { Location::Boundary(witness) };
        return Gauge { value: 0.0, error: 0.0, location };
    }
    let instance = Instance::new(p.clone(), zero(), Source::Doubles(question.runs()));
    match descend(&instance, &p, tally) {
        Descent::Optimal { point, gradient, certificate } => {
            let reach = dot(&gradient, &point);
            let along = dot(&p, &point);
            Exit { question, instance: &instance, p, direction: point, certificate, reach, along }.gauge()
        }
        Descent::Unbounded { .. } => unreachable!("a sum of absolute values is bounded below"),
    }
}

/// The optimum: Σ δ_i v_i = λ p with λ = reach / along.
struct Exit<'a> {
    question: &'a Query<'a, 4>,
    instance: &'a Instance<'a>,
    p: Vector4,
    direction: Vector4,
    certificate: SpaceCertificate,
    /// h(direction).
    reach: Dyadic,
    /// direction · p, positive.
    along: Dyadic,
}

impl Exit<'_> {
    fn gauge(&self) -> Gauge<4> {
        let location = self.location();
        if self.reach.is_zero() {
            return Gauge { value: f64::INFINITY, error: 0.0, location };
        }
        let value = self.along.rounded_ratio(&self.reach);
        if value < f64::MAX {
            Gauge { value, error: value * f64::EPSILON + f64::from_bits(1), location }
        } else {
            Gauge { value: f64::MAX, error: f64::INFINITY, location }
        }
    }

    fn location(&self) -> Location<4> {
        if self.along > self.reach {
            return Location::Outside(Separation::near(self.question, &self.direction));
        }
        let facet: Vec<usize> = self.certificate.basis.iter().map(|&b| b as usize).collect();
        if self.along == self.reach {
            let witness = self.scaled(&facet, 1.0).expect("the certificate of λ = 1 is a witness");
            return Location::Boundary(witness);
        }
        let basis = self.instance.spanning(&facet);
        let near = self.along.ratio(&self.reach).min(1.0);
        let witness = [near, 1.0].into_iter().find_map(|factor| self.scaled(&basis, factor));
        let witness = witness.unwrap_or_else(|| self.moved(&facet));
        if basis.len() == 4 { Location::Inside(witness) } else { Location::Boundary(witness) }
    }

    /// The witness with all coefficients off the basis multiplied by a factor, if it is one.
    fn scaled(&self, basis: &[usize], factor: f64) -> Option<Witness> {
        let signs = self.certificate.signs.iter();
        let mut coefficients: Vec<f64> = signs.map(|&sign| f64::from(sign) * factor).collect();
        let values = solve(self.question, basis, &left_over(self.question, &self.p, &coefficients, basis))?;
        for (&b, value) in basis.iter().zip(values) {
            if value > Rational::ONE || value < Rational::NEG_ONE {
                return None;
            }
            coefficients[b] = value.to_f64().value().clamp(-1.0, 1.0);
        }
        Some(Witness { coefficients, basis: basis.to_vec() })
    }

    /// The witness from δ_i / λ, exactly.
    fn moved(&self, facet: &[usize]) -> Witness {
        let shrink = self.along.to_rational() / self.reach.to_rational();
        let signs: Vec<f64> = self.certificate.signs.iter().map(|&sign| f64::from(sign)).collect();
        let mut exact: Vec<Rational> =
            self.certificate.signs.iter().map(|&sign| Rational::from(sign) * &shrink).collect();
        // along · Σ δ v = reach · p
        let whole = left_over(self.question, &self.p.clone().map(|_| Dyadic::zero()), &signs, facet);
        let left = std::array::from_fn(|k| &self.reach * &self.p[k] + &self.along * &whole[k]);
        let values = solve(self.question, facet, &left).expect("the certificate's basis solves its equation");
        for (&b, value) in facet.iter().zip(values) {
            exact[b] = value / self.reach.to_rational();
        }
        rounded_off_a_basis(exact, |i| self.question.generator(i).map(|v| Dyadic::from_f64(v).to_rational()).to_vec())
    }
}
