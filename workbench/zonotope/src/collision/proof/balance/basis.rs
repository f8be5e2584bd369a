//! Linearly independent generators, and exact coordinates in terms of them.

use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, cross, cyclic_cross_products, dot, exact, is_zero, rounded_direction};

/// The number of generators that are proposed as the next of a basis.
const PROPOSAL_LIMIT: usize = 3;

/// Three independent vectors, the first `rank` of which are generators; the others are orthogonal to those.
#[derive(Debug, Clone)]
pub(crate) struct Basis {
    pub(crate) generators: Vec<usize>,
    /// The dual vectors times the determinant: the coefficient of b_i in x is dual_i · x / determinant.
    dual: [ExactVector; 3],
    /// Positive.
    determinant: Dyadic,
}

impl Basis {
    /// Independent generators, at most three, by index and value.
    pub(crate) fn new(members: Vec<(usize, ExactVector)>) -> Self {
        let (generators, mut vectors): (Vec<usize>, Vec<ExactVector>) = members.into_iter().unzip();
        while vectors.len() < 3 {
            let next = orthogonal(&vectors);
            vectors.push(next);
        }
        let [a, b, c] = [&vectors[0], &vectors[1], &vectors[2]];
        let dual = cyclic_cross_products(a, b, c);
        let determinant = dot(a, &dual[0]);
        assert!(!determinant.is_zero(), "the members are independent");
        if determinant.sign().is_lt() {
            return Self { generators, dual: dual.map(|d| d.map(|v| -v)), determinant: -determinant };
        }
        Self { generators, dual, determinant }
    }

    /// A basis extended until it spans all generators, and other generators that could have been the last added.
    pub(crate) fn spanning(query: &dyn KernelQuery, start: Self) -> (Self, Vec<usize>) {
        let of = |index| query.exact_generator(index);
        let (mut basis, mut others) = (start, Vec::new());
        while basis.rank() < 3 {
            let is_missed = |&i: &usize| basis.misses(&of(i));
            let mut missed = most_independent(query, &basis).into_iter().filter(is_missed);
            // where floating point proposes none: is there one at all?
            let Some(first) = missed.next().or_else(|| (0..query.len()).find(is_missed)) else { break };
            others = missed.collect();
            basis = basis.with(first, of);
        }
        (basis, others)
    }

    pub(crate) fn rank(&self) -> usize {
        self.generators.len()
    }

    /// The coefficients of a vector of the span, times [`determinant`](Self::determinant).
    pub(crate) fn numerators(&self, x: &ExactVector) -> Vec<Dyadic> {
        self.dual[..self.rank()].iter().map(|dual| dot(dual, x)).collect()
    }

    pub(crate) fn determinant(&self) -> &Dyadic {
        &self.determinant
    }

    /// Whether a vector lies outside the span.
    pub(crate) fn misses(&self, x: &ExactVector) -> bool {
        self.dual[self.rank()..].iter().any(|dual| !dot(dual, x).is_zero())
    }

    /// Normals of the planes between which the span is the intersection, as doubles.
    pub(crate) fn rounded_normals(&self) -> Vec<[f64; 3]> {
        self.dual[self.rank()..].iter().map(rounded_direction).collect()
    }

    /// With one more generator, one that the span misses.
    pub(crate) fn with(&self, generator: usize, of: impl Fn(usize) -> ExactVector) -> Self {
        let mut generators = self.generators.clone();
        generators.push(generator);
        generators.sort_unstable();
        Self::new(generators.into_iter().map(|index| (index, of(index))).collect())
    }
}

/// A vector, not zero, orthogonal to at most two independent ones.
fn orthogonal(vectors: &[ExactVector]) -> ExactVector {
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(exact);
    match vectors {
        [] => axes[0].clone(),
        [a, b] => cross(a, b),
        [a, ..] => axes
            .iter()
            .map(|axis| cross(a, axis))
            .find(|product| !is_zero(product))
            .expect("a vector that is not zero is parallel to at most one axis"),
    }
}

/// Generators that seem to be farthest from the span of a basis, best first.
fn most_independent(query: &dyn KernelQuery, basis: &Basis) -> Vec<usize> {
    let normals = basis.rounded_normals();
    let key = |v: &[f64; 3]| {
        let sum = normals.iter().map(|n| (n[0] * v[0] + n[1] * v[1] + n[2] * v[2]).abs()).sum::<f64>();
        if sum.is_finite() { sum } else { 0.0 }
    };
    let mut best: Vec<(f64, usize)> = Vec::new();
    for (index, v) in query.generators().enumerate() {
        let key = key(&v);
        if key > 0.0 && (best.len() < PROPOSAL_LIMIT || key > best[best.len() - 1].0) {
            best.truncate(PROPOSAL_LIMIT - 1);
            best.push((key, index));
            best.sort_by(|a, b| b.0.total_cmp(&a.0));
        }
    }
    best.into_iter().map(|(_, index)| index).collect()
}
