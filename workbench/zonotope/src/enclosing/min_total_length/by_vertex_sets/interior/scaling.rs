//! The Nesterov–Todd scaling of the second-order cone.
//!
//! For a slack s and a dual variable z inside the cone there is exactly one symmetric automorphism W of the cone such
//! that W z and W⁻¹ s are the same point. In its coordinates slack and dual variable are equal, so a Newton step
//! towards s ∘ z = μ treats both alike. It has the form W = β (2 v vᵀ − J) with vᵀ J v = 1.

use crate::enclosing::min_total_length::by_vertex_sets::cone::ConeVector;
use crate::enclosing::min_total_length::by_vertex_sets::scalar::Scalar;
use crate::numeric::linear::dot;

/// The Nesterov–Todd scaling W of a slack and a dual variable.
pub(super) struct Scaling<R, const D: usize> {
    /// The factor β of W.
    beta: R,
    /// The vector w̄ with W² = β² (2 w̄ w̄ᵀ − J).
    square: ConeVector<R, D>,
    /// The vector v with W = β (2 v vᵀ − J).
    root: ConeVector<R, D>,
    /// The scaled point W z = W⁻¹ s of both variables.
    pub(super) both: ConeVector<R, D>,
}

impl<R: Scalar, const D: usize> Scaling<R, D> {
    /// The scaling of a slack and a dual variable; `None` if one of them is not inside the cone, or the scaling is not
    /// finite.
    pub(super) fn new(slack: &ConeVector<R, D>, dual: &ConeVector<R, D>) -> Option<Self> {
        let (of_slack, of_dual) = (slack.determinant(), dual.determinant());
        let [half, one, two] = [0.5, 1.0, 2.0].map(R::from);
        if ![of_slack, of_dual, slack.head, dual.head].iter().all(|v| v.value() > 0.0) {
            return None;
        }
        let (unit_slack, unit_dual) = (slack.times(one / of_slack.sqrt()), dual.times(one / of_dual.sqrt()));
        let gamma = (half * (one + unit_slack.dot(&unit_dual))).sqrt();
        let square = unit_slack.plus(one, &unit_dual.reflected()).times(half / gamma);
        let beta = (of_slack / of_dual).sqrt().sqrt();
        let shifted = ConeVector { head: square.head + one, rest: square.rest };
        let root = shifted.times(one / (two * shifted.head).sqrt());
        let mut scaling = Self { beta, square, root, both: ConeVector::zero() };
        scaling.both = scaling.apply(dual);
        let is_positive = beta.value().is_finite() && beta.value() > 0.0;
        (is_positive && scaling.both.dot(&scaling.both).value().is_finite()).then_some(scaling)
    }

    /// The product W x.
    pub(super) fn apply(&self, x: &ConeVector<R, D>) -> ConeVector<R, D> {
        let along = R::from(2.0) * self.root.dot(x);
        self.root.times(along).minus(&x.reflected()).times(self.beta)
    }

    /// The product W⁻¹ x.
    pub(super) fn undo(&self, x: &ConeVector<R, D>) -> ConeVector<R, D> {
        let back = self.root.reflected();
        let along = R::from(2.0) * back.dot(x);
        back.times(along).minus(&x.reflected()).times(R::from(1.0) / self.beta)
    }

    /// The product W⁻² x.
    pub(super) fn undo_twice(&self, x: &ConeVector<R, D>) -> ConeVector<R, D> {
        let back = self.square.reflected();
        let along = R::from(2.0) * back.dot(x);
        back.times(along).minus(&x.reflected()).times(R::from(1.0) / (self.beta * self.beta))
    }

    /// An entry of W⁻² in the rows and columns after those of the head.
    pub(super) fn entry(&self, a: usize, b: usize) -> R {
        let identity = R::from(if a == b { 1.0 } else { 0.0 });
        (identity + R::from(2.0) * self.square.rest[a] * self.square.rest[b]) / (self.beta * self.beta)
    }

    /// The vector x with (W z) ∘ x = right, for the Jordan product ∘.
    pub(super) fn divided(&self, right: &ConeVector<R, D>) -> ConeVector<R, D> {
        let both = &self.both;
        let head = (both.head * right.head - dot(&both.rest, &right.rest)) / both.determinant();
        ConeVector { head, rest: std::array::from_fn(|c| (right.rest[c] - head * both.rest[c]) / both.head) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::enclosing::min_total_length::by_vertex_sets::cone::jordan;

    #[test]
    fn a_slack_and_its_dual_are_scaled_to_the_same_point() {
        let (slack, dual) =
            (ConeVector { head: 1.0, rest: [0.3, -0.5, 0.1] }, ConeVector { head: 0.2, rest: [0.05, 0.1, -0.1] });
        let scaling = Scaling::new(&slack, &dual).expect("both are inside");
        let seen = scaling.undo(&slack);
        let again = scaling.undo_twice(&slack);
        for c in 0..3 {
            assert!((seen.rest[c] - scaling.both.rest[c]).abs() < 1e-14);
            assert!((again.rest[c] - dual.rest[c]).abs() < 1e-14);
        }
        let back = scaling.divided(&jordan(&scaling.both, &dual));
        assert!((back.head - dual.head).abs() < 1e-14 && (back.rest[2] - dual.rest[2]).abs() < 1e-14);
        let along = ConeVector { head: 0.0, rest: [1.0, 0.0, 0.0] };
        assert!((ConeVector { head: 1.0, rest: [0.0; 3] }.reach(&along) - 1.0).abs() < 1e-15);
        assert!(Scaling::new(&ConeVector { head: 1.0, rest: [1.0, 0.0, 0.0] }, &dual).is_none());
    }
}
