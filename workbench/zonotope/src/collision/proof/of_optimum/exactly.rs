//! Coefficients of doubles that prove a member, from the exact proof of λ ≥ 1.
//!
//! Σ δ_i v_i = λ p with δ_i = ±1 off two generators and λ rational: dividing by λ proves that p is a member, but not
//! in doubles. With a third generator in the basis, all others may be scaled by the same double c, near 1 / λ or,
//! close to the boundary, 1 itself: p − c Σ_off sign v is one exact vector, and its three coefficients decide. Where
//! both values of c fail, because p is so close to the edge of a facet that rounding the scale leaves the facet, the
//! exact solution with 1 / λ is walked to one in doubles (`pivot`).

use crate::collision::Witness;
use crate::collision::proof::balance::basis::Basis;
use crate::lad::of_generators::exact::solve::ExactOptimum;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, difference, multiple, negated, sum};

/// Σ δ_i v_i = λ p, λ ≥ 1, with a basis that spans all generators.
pub(crate) struct Combination<'a> {
    pub(crate) query: &'a dyn KernelQuery,
    pub(crate) optimum: &'a ExactOptimum,
    pub(crate) p: &'a ExactVector,
    /// The basis of the optimum's generators alone.
    plane: Basis,
    pub(crate) basis: Basis,
    /// Other generators that would complete the two generators of the optimum.
    others: Vec<usize>,
}

impl<'a> Combination<'a> {
    pub(crate) fn new(query: &'a dyn KernelQuery, optimum: &'a ExactOptimum, p: &'a ExactVector) -> Self {
        let plane = Basis::new(optimum.basis.iter().map(|&b| (b, query.exact_generator(b))).collect());
        let (basis, others) = Basis::spanning(query, plane.clone());
        Self { query, optimum, p, plane, basis, others }
    }

    /// Whether the generators span space.
    pub(crate) fn spans_space(&self) -> bool {
        self.basis.rank() == 3
    }

    /// The proof with one factor for all generators off a basis, if a factor of doubles leaves the basis room.
    pub(crate) fn witness(&self) -> Option<Witness> {
        let ExactOptimum { reach, along, .. } = self.optimum;
        if reach == along {
            return self.scaled(&self.plane, 1.0);
        }
        let inverse = self.factor();
        let of = |index| self.query.exact_generator(index);
        let others = self.others.iter().filter(|_| self.optimum.basis.len() == 2).map(|&i| self.plane.with(i, of));
        std::iter::once(self.basis.clone())
            .chain(others)
            .flat_map(|basis| [(basis.clone(), inverse), (basis, 1.0)])
            .find_map(|(basis, factor)| self.scaled(&basis, factor))
    }

    /// 1 / λ in doubles, at most 1.
    pub(crate) fn factor(&self) -> f64 {
        self.optimum.along.ratio(&self.optimum.reach).min(1.0)
    }

    /// The proof with the coefficient ±`factor` off the basis, if it is one.
    fn scaled(&self, basis: &Basis, factor: f64) -> Option<Witness> {
        let signs = self.optimum.signs(self.query);
        // the optimum's sum includes the third generator of the basis
        let in_basis = basis.generators.iter().fold(None, |total: Option<ExactVector>, &b| match signs[b] {
            0 => total,
            sign => {
                let own = self.query.exact_generator(b);
                let v = if sign < 0 { negated(own) } else { own };
                Some(total.map_or_else(|| v.clone(), |total| sum(&total, &v)))
            }
        });
        let off = in_basis.map_or_else(|| self.optimum.sum.clone(), |v| difference(&self.optimum.sum, &v));
        let rest = difference(self.p, &multiple(&Dyadic::from_f64(factor), &off));
        let numerators = basis.numerators(&rest);
        if numerators.iter().any(|n| n.clone().abs() > *basis.determinant()) {
            return None;
        }
        let mut coefficients: Vec<f64> = signs.iter().map(|&sign| f64::from(sign) * factor).collect();
        for (&b, numerator) in basis.generators.iter().zip(&numerators) {
            coefficients[b] = rounded(numerator, basis.determinant());
        }
        Some(Witness { coefficients, basis: basis.generators.clone() })
    }
}

/// A ratio of magnitude at most 1, as a double of magnitude at most 1.
pub(crate) fn rounded(numerator: &Dyadic, denominator: &Dyadic) -> f64 {
    numerator.rounded_ratio(denominator).clamp(-1.0, 1.0)
}
