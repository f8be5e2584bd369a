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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::exact_linear::{multiple, sum};
    use crate::zonotope::query::Query;

    /// Two vectors of a plane, and the normal of it.
    const FIRST: [f64; 3] = [1.0, 2.0, 2.0];
    const SECOND: [f64; 3] = [2.0, 1.0, -2.0];
    const NORMAL: [f64; 3] = [-2.0, 2.0, -1.0];

    fn of(parts: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|k| parts[0] * FIRST[k] + parts[1] * SECOND[k] + parts[2] * NORMAL[k])
    }

    fn basis(members: &[[f64; 3]]) -> Basis {
        Basis::new(members.iter().map(|v| exact(*v)).enumerate().collect())
    }

    #[test]
    fn numerators_over_the_determinant_are_the_coefficients() {
        for members in [[FIRST, SECOND, NORMAL], [SECOND, FIRST, NORMAL], [NORMAL, FIRST, SECOND]] {
            for rank in 0..=3 {
                let basis = basis(&members[..rank]);
                assert!(basis.determinant().sign().is_gt());
                let parts = [0.5, -0.75, 2.0];
                let zero = exact([0.0; 3]);
                let x =
                    (0..rank).fold(zero, |x, i| sum(&x, &multiple(&Dyadic::from_f64(parts[i]), &exact(members[i]))));
                let numerators = basis.numerators(&x);
                assert_eq!((basis.rank(), numerators.len()), (rank, rank));
                for (numerator, part) in numerators.iter().zip(parts) {
                    assert_eq!(*numerator, &Dyadic::from_f64(part) * basis.determinant(), "{members:?} {rank}");
                }
                assert!(!basis.misses(&x));
                for v in &members[rank..] {
                    assert!(basis.misses(&sum(&x, &exact(*v))), "{members:?} {rank}");
                }
            }
        }
    }

    #[test]
    fn normals_of_the_span_are_orthogonal_to_its_members() {
        for single in [[1.0, 0.0, 0.0], [0.0, -3.0, 0.0], [0.0, 0.0, 2.0], FIRST] {
            let normals = basis(&[single]).rounded_normals();
            assert_eq!(normals.len(), 2);
            for n in &normals {
                let along = (0..3).map(|k| n[k] * single[k]).sum::<f64>();
                assert!(along.abs() < 1e-12 && n.iter().any(|c| c.abs() >= 1.0), "{n:?} {single:?}");
            }
        }
        let normals = basis(&[FIRST, SECOND]).rounded_normals();
        let [n] = normals[..] else { unreachable!("one normal for a plane") };
        assert!((n[0] / n[2] - 2.0).abs() < 1e-12 && (n[1] / n[2] + 2.0).abs() < 1e-12, "{n:?}");
    }

    #[test]
    fn generators_far_from_the_span_are_proposed_farthest_first() {
        let heights = [0.0, 0.25, -1.0, 0.5, 3.0, -2.0, 0.0, 0.125];
        for shift in 0..8 {
            let height = |i: usize| heights[(i + shift) % 8];
            let rows: Vec<[f64; 3]> = (0..8).map(|i| of([3.0 - i as f64, 0.5 * i as f64, height(i)])).collect();
            let query = Query::new([0.0; 3], [0.0; 3], &rows).expect("finite");
            let own = most_independent(&query, &basis(&[FIRST, SECOND]));
            let farthest: Vec<f64> = own.into_iter().map(height).collect();
            assert_eq!(farthest, [3.0, -2.0, -1.0], "{shift}");
            // at most as many as there are
            let query = Query::new([0.0; 3], [0.0; 3], &rows[..2]).expect("finite");
            let own = most_independent(&query, &basis(&[FIRST, SECOND]));
            assert_eq!(own.len(), (0..2).filter(|&i| height(i) != 0.0).count(), "{shift}");
        }
        // of a line, the sum over both normals counts
        let rows = [FIRST, of([0.0, 0.25, 0.25]), of([9.0, 0.0, 0.0]), of([0.0, 2.0, 2.0])];
        let query = Query::new([0.0; 3], [0.0; 3], &rows).expect("finite");
        assert_eq!(most_independent(&query, &basis(&[FIRST])), [3, 1]);
    }

    #[test]
    fn a_basis_is_extended_until_it_spans_all_and_others_are_named() {
        let rows = [FIRST, of([2.0, 0.0, 0.0]), SECOND, of([0.0, 1.0, 0.5]), of([1.0, 0.0, 1.0])];
        let query = Query::new([0.0; 3], [0.0; 3], &rows).expect("finite");
        let start = Basis::new(vec![(0, exact(FIRST)), (2, exact(SECOND))]);
        let (own, others) = Basis::spanning(&query, start);
        assert_eq!((own.generators, others), (vec![0, 2, 4], vec![3]));
        let (own, _) = Basis::spanning(&query, Basis::new(vec![]));
        assert_eq!(own.rank(), 3);
        let flat = Query::new([0.0; 3], [0.0; 3], &rows[..3]).expect("finite");
        let (own, others) = Basis::spanning(&flat, Basis::new(vec![]));
        assert_eq!((own.rank(), others.len()), (2, 0));
        // products with the normals overflow in doubles, and the exact search finds what they cannot propose
        let huge = [[1e308, 0.0, 0.0], [0.0, 1e308, 0.0], [1e308, 1e308, 1e308]];
        let query = Query::new([0.0; 3], [0.0; 3], &huge).expect("finite");
        assert_eq!(Basis::spanning(&query, Basis::new(vec![])).0.generators, [0, 1, 2]);
    }
}
