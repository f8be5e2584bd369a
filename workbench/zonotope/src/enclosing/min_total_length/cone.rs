//! Pairs in the cone x_0 ≥ |(x_1 … x_d)|: how far a limit is from being reached, and the load that it bears.
//!
//! The cone is its own dual. For a slack s and a load z inside there is one symmetric map W of the cone onto itself with W z = W⁻¹ s: seen through it both are the same point, and
//! a step towards s ∘ z = μ treats both alike (Nesterov and Todd). With J = diag(1, −1 … −1), W = β (2 v vᵀ − J), vᵀ J v = 1.

use super::real::{Real, dot, plus, zero};

/// A vector with a head, which is its length where it lies on the boundary of the cone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Headed<R, const D: usize> {
    pub(super) head: R,
    pub(super) rest: [R; D],
}

impl<R: Real, const D: usize> Headed<R, D> {
    pub(super) fn zero() -> Self {
        Self { head: R::from(0.0), rest: zero() }
    }

    pub(super) fn dot(&self, other: &Self) -> R {
        self.head * other.head + dot(&self.rest, &other.rest)
    }

    pub(super) fn plus(&self, factor: R, other: &Self) -> Self {
        Self { head: self.head + factor * other.head, rest: plus(&self.rest, factor, &other.rest) }
    }

    pub(super) fn minus(&self, other: &Self) -> Self {
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
    pub(super) fn room(&self) -> R {
        let length = dot(&self.rest, &self.rest).sqrt();
        (self.head - length) * (self.head + length)
    }

    /// The load μ s⁻¹ that goes with a slack on the central path.
    pub(super) fn load(&self, mu: R) -> Self {
        self.reflected().times(mu / self.room())
    }

    /// How far one can go along a direction before the boundary of the cone.
    pub(super) fn reach(&self, direction: &Self) -> f64 {
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
pub(super) struct Scaling<R, const D: usize> {
    beta: R,
    /// w̄ with W² = β² (2 w̄ w̄ᵀ − J).
    square: Headed<R, D>,
    root: Headed<R, D>,
    /// W z = W⁻¹ s.
    pub(super) both: Headed<R, D>,
}

impl<R: Real, const D: usize> Scaling<R, D> {
    /// `None` where one of them is not inside the cone.
    pub(super) fn new(slack: &Headed<R, D>, load: &Headed<R, D>) -> Option<Self> {
        let (of_slack, of_load) = (slack.room(), load.room());
        let [half, one, two] = [0.5, 1.0, 2.0].map(R::from);
        if ![of_slack, of_load, slack.head, load.head].iter().all(|v| v.value() > 0.0) {
            return None;
        }
        let (unit_slack, unit_load) = (slack.times(one / of_slack.sqrt()), load.times(one / of_load.sqrt()));
        let gamma = (half * (one + unit_slack.dot(&unit_load))).sqrt();
        let square = unit_slack.plus(one, &unit_load.reflected()).times(half / gamma);
        let beta = (of_slack / of_load).sqrt().sqrt();
        let shifted = Headed { head: square.head + one, rest: square.rest };
        let root = shifted.times(one / (two * shifted.head).sqrt());
        let mut scaling = Self { beta, square, root, both: Headed::zero() };
        scaling.both = scaling.apply(load);
        let is_positive = beta.value().is_finite() && beta.value() > 0.0;
        (is_positive && scaling.both.dot(&scaling.both).value().is_finite()).then_some(scaling)
    }

    /// W x.
    pub(super) fn apply(&self, x: &Headed<R, D>) -> Headed<R, D> {
        let along = R::from(2.0) * self.root.dot(x);
        self.root.times(along).minus(&x.reflected()).times(self.beta)
    }

    /// W⁻¹ x.
    pub(super) fn undo(&self, x: &Headed<R, D>) -> Headed<R, D> {
        let back = self.root.reflected();
        let along = R::from(2.0) * back.dot(x);
        back.times(along).minus(&x.reflected()).times(R::from(1.0) / self.beta)
    }

    /// W⁻² x.
    pub(super) fn undo_twice(&self, x: &Headed<R, D>) -> Headed<R, D> {
        let back = self.square.reflected();
        let along = R::from(2.0) * back.dot(x);
        back.times(along).minus(&x.reflected()).times(R::from(1.0) / (self.beta * self.beta))
    }

    /// An entry of W⁻², without heads.
    pub(super) fn entry(&self, a: usize, b: usize) -> R {
        let identity = R::from(if a == b { 1.0 } else { 0.0 });
        (identity + R::from(2.0) * self.square.rest[a] * self.square.rest[b]) / (self.beta * self.beta)
    }

    /// x with (W z) ∘ x = right, where a ∘ b = (a · b, a_0 b' + b_0 a').
    pub(super) fn divided(&self, right: &Headed<R, D>) -> Headed<R, D> {
        let both = &self.both;
        let head = (both.head * right.head - dot(&both.rest, &right.rest)) / both.room();
        Headed { head, rest: std::array::from_fn(|c| (right.rest[c] - head * both.rest[c]) / both.head) }
    }
}

/// a ∘ b.
pub(super) fn jordan<R: Real, const D: usize>(a: &Headed<R, D>, b: &Headed<R, D>) -> Headed<R, D> {
    Headed { head: a.dot(b), rest: std::array::from_fn(|c| a.head * b.rest[c] + b.head * a.rest[c]) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slack_and_its_load_are_seen_as_the_same_point() {
        let (slack, load) =
            (Headed { head: 1.0, rest: [0.3, -0.5, 0.1] }, Headed { head: 0.2, rest: [0.05, 0.1, -0.1] });
        let scaling = Scaling::new(&slack, &load).expect("both are inside");
        let seen = scaling.undo(&slack);
        let again = scaling.undo_twice(&slack);
        for c in 0..3 {
            assert!((seen.rest[c] - scaling.both.rest[c]).abs() < 1e-14);
            assert!((again.rest[c] - load.rest[c]).abs() < 1e-14);
        }
        let back = scaling.divided(&jordan(&scaling.both, &load));
        assert!((back.head - load.head).abs() < 1e-14 && (back.rest[2] - load.rest[2]).abs() < 1e-14);
        let along = Headed { head: 0.0, rest: [1.0, 0.0, 0.0] };
        assert!((Headed { head: 1.0, rest: [0.0; 3] }.reach(&along) - 1.0).abs() < 1e-15);
        assert!(Scaling::new(&Headed { head: 1.0, rest: [1.0, 0.0, 0.0] }, &load).is_none());
    }
}
