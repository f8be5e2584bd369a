//! Pairs in the cone x_0 ≥ |(x_1 … x_d)|: how far a limit is from being reached, and the load that it bears.
//!
//! The cone is its own dual. For a slack s and a load z inside there is one symmetric map W of the cone onto itself with W z = W⁻¹ s: seen through it both are the same point, and
//! a step towards s ∘ z = μ treats both alike (Nesterov and Todd). With J = diag(1, −1 … −1), W = β (2 v vᵀ − J), vᵀ J v = 1.

use super::scalar::{Scalar, dot, plus, zero};

/// A vector with a head, which is its length where it lies on the boundary of the cone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::enclosing::min_total_length::by_vertex_sets) struct ConeVector<R, const D: usize> {
    pub(in crate::enclosing::min_total_length::by_vertex_sets) head: R,
    pub(in crate::enclosing::min_total_length::by_vertex_sets) rest: [R; D],
}

impl<R: Scalar, const D: usize> ConeVector<R, D> {
    pub(in crate::enclosing::min_total_length::by_vertex_sets) fn zero() -> Self {
        Self { head: R::from(0.0), rest: zero() }
    }

    pub(in crate::enclosing::min_total_length::by_vertex_sets) fn dot(&self, other: &Self) -> R {
        self.head * other.head + dot(&self.rest, &other.rest)
    }

    pub(in crate::enclosing::min_total_length::by_vertex_sets) fn plus(&self, factor: R, other: &Self) -> Self {
        Self { head: self.head + factor * other.head, rest: plus(&self.rest, factor, &other.rest) }
    }

    pub(in crate::enclosing::min_total_length::by_vertex_sets) fn minus(&self, other: &Self) -> Self {
        self.plus(R::from(-1.0), other)
    }

    fn times(&self, factor: R) -> Self {
        Self { head: self.head * factor, rest: self.rest.map(|c| c * factor) }
    }

    /// J x.
    fn reflected(&self) -> Self {
        Self { head: self.head, rest: self.rest.map(|c| -c) }
    }

    /// xᵀ J x = x_0² − |x'|²; positive inside the cone.
    pub(in crate::enclosing::min_total_length::by_vertex_sets) fn room(&self) -> R {
        let length = dot(&self.rest, &self.rest).sqrt();
        (self.head - length) * (self.head + length)
    }

    /// The load μ s⁻¹ that goes with a slack on the central path.
    pub(in crate::enclosing::min_total_length::by_vertex_sets) fn load(&self, mu: R) -> Self {
        self.reflected().times(mu / self.room())
    }

    /// How far one can go along a direction before the boundary of the cone.
    pub(in crate::enclosing::min_total_length::by_vertex_sets) fn reach(&self, direction: &Self) -> f64 {
        let nothing = R::from(0.0);
        let a = direction.head * direction.head - dot(&direction.rest, &direction.rest);
        let b = self.head * direction.head - dot(&self.rest, &direction.rest);
        let c = self.room();
        let discriminant = b * b - a * c;
        if discriminant < nothing || (a >= nothing && b >= nothing) {
            return f64::INFINITY;
        }
        (c / (discriminant.sqrt() - b)).value()
    }
}

/// The map W for a slack and a load.
pub(in crate::enclosing::min_total_length::by_vertex_sets) struct Scaling<R, const D: usize> {
    beta: R,
    /// w̄ with W² = β² (2 w̄ w̄ᵀ − J).
    square: ConeVector<R, D>,
    root: ConeVector<R, D>,
    /// W z = W⁻¹ s.
    pub(in crate::enclosing::min_total_length::by_vertex_sets) both: ConeVector<R, D>,
}

impl<R: Scalar, const D: usize> Scaling<R, D> {
    /// `None` where one of them is not inside the cone.
    pub(in crate::enclosing::min_total_length::by_vertex_sets) fn new(
        slack: &ConeVector<R, D>,
        load: &ConeVector<R, D>,
    ) -> Option<Self> {
        let (of_slack, of_load) = (slack.room(), load.room());
        let [half, one, two] = [0.5, 1.0, 2.0].map(R::from);
        if ![of_slack, of_load, slack.head, load.head].iter().all(|v| v.value() > 0.0) {
            return None;
        }
        let (unit_slack, unit_load) = (slack.times(one / of_slack.sqrt()), load.times(one / of_load.sqrt()));
        let gamma = (half * (one + unit_slack.dot(&unit_load))).sqrt();
        let square = unit_slack.plus(one, &unit_load.reflected()).times(half / gamma);
        let beta = (of_slack / of_load).sqrt().sqrt();
        let shifted = ConeVector { head: square.head + one, rest: square.rest };
        let root = shifted.times(one / (two * shifted.head).sqrt());
        let mut scaling = Self { beta, square, root, both: ConeVector::zero() };
        scaling.both = scaling.apply(load);
        let is_positive = beta.value().is_finite() && beta.value() > 0.0;
        (is_positive && scaling.both.dot(&scaling.both).value().is_finite()).then_some(scaling)
    }

    /// W x.
    pub(in crate::enclosing::min_total_length::by_vertex_sets) fn apply(
        &self,
        x: &ConeVector<R, D>,
    ) -> ConeVector<R, D> {
        let along = R::from(2.0) * self.root.dot(x);
        self.root.times(along).minus(&x.reflected()).times(self.beta)
    }

    /// W⁻¹ x.
    pub(in crate::enclosing::min_total_length::by_vertex_sets) fn undo(
        &self,
        x: &ConeVector<R, D>,
    ) -> ConeVector<R, D> {
        let back = self.root.reflected();
        let along = R::from(2.0) * back.dot(x);
        back.times(along).minus(&x.reflected()).times(R::from(1.0) / self.beta)
    }

    /// W⁻² x.
    pub(in crate::enclosing::min_total_length::by_vertex_sets) fn undo_twice(
        &self,
        x: &ConeVector<R, D>,
    ) -> ConeVector<R, D> {
        let back = self.square.reflected();
        let along = R::from(2.0) * back.dot(x);
        back.times(along).minus(&x.reflected()).times(R::from(1.0) / (self.beta * self.beta))
    }

    /// An entry of W⁻², without heads.
    pub(in crate::enclosing::min_total_length::by_vertex_sets) fn entry(&self, a: usize, b: usize) -> R {
        let identity = R::from(if a == b { 1.0 } else { 0.0 });
        (identity + R::from(2.0) * self.square.rest[a] * self.square.rest[b]) / (self.beta * self.beta)
    }

    /// x with (W z) ∘ x = right, where a ∘ b = (a · b, a_0 b' + b_0 a').
    pub(in crate::enclosing::min_total_length::by_vertex_sets) fn divided(
        &self,
        right: &ConeVector<R, D>,
    ) -> ConeVector<R, D> {
        let both = &self.both;
        let head = (both.head * right.head - dot(&both.rest, &right.rest)) / both.room();
        ConeVector { head, rest: std::array::from_fn(|c| (right.rest[c] - head * both.rest[c]) / both.head) }
    }
}

/// a ∘ b.
pub(in crate::enclosing::min_total_length::by_vertex_sets) fn jordan<R: Scalar, const D: usize>(
    a: &ConeVector<R, D>,
    b: &ConeVector<R, D>,
) -> ConeVector<R, D> {
    ConeVector { head: a.dot(b), rest: std::array::from_fn(|c| a.head * b.rest[c] + b.head * a.rest[c]) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slack_and_its_load_are_seen_as_the_same_point() {
        let (slack, load) =
            (ConeVector { head: 1.0, rest: [0.3, -0.5, 0.1] }, ConeVector { head: 0.2, rest: [0.05, 0.1, -0.1] });
        let scaling = Scaling::new(&slack, &load).expect("both are inside");
        let seen = scaling.undo(&slack);
        let again = scaling.undo_twice(&slack);
        for c in 0..3 {
            assert!((seen.rest[c] - scaling.both.rest[c]).abs() < 1e-14);
            assert!((again.rest[c] - load.rest[c]).abs() < 1e-14);
        }
        let back = scaling.divided(&jordan(&scaling.both, &load));
        assert!((back.head - load.head).abs() < 1e-14 && (back.rest[2] - load.rest[2]).abs() < 1e-14);
        let along = ConeVector { head: 0.0, rest: [1.0, 0.0, 0.0] };
        assert!((ConeVector { head: 1.0, rest: [0.0; 3] }.reach(&along) - 1.0).abs() < 1e-15);
        assert!(Scaling::new(&ConeVector { head: 1.0, rest: [1.0, 0.0, 0.0] }, &load).is_none());
    }
}
