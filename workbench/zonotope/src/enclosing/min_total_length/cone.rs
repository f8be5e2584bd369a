//! Pairs in the cone x_0 ≥ |(x_1 … x_d)|: how far a limit is from being reached, and the load that it bears.
//!
//! The cone is its own dual. For a slack s and a load z inside there is one symmetric map W of the cone onto itself with W z = W⁻¹ s: seen through it both are the same point, and
//! a step towards s ∘ z = μ treats both alike (Nesterov and Todd). With J = diag(1, −1 … −1), W = β (2 v vᵀ − J), vᵀ J v = 1.

use crate::enclosing::fixed_directions::dot;

/// A vector with a head, which is its length where it lies on the boundary of the cone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Headed<const D: usize> {
    pub(super) head: f64,
    pub(super) rest: [f64; D],
}

impl<const D: usize> Headed<D> {
    pub(super) const ZERO: Self = Self { head: 0.0, rest: [0.0; D] };

    pub(super) fn dot(&self, other: &Self) -> f64 {
        self.head * other.head + dot(&self.rest, &other.rest)
    }

    pub(super) fn plus(&self, factor: f64, other: &Self) -> Self {
        Self {
            head: self.head + factor * other.head,
            rest: std::array::from_fn(|c| self.rest[c] + factor * other.rest[c]),
        }
    }

    fn times(&self, factor: f64) -> Self {
        Self { head: self.head * factor, rest: self.rest.map(|c| c * factor) }
    }

    /// J x.
    fn reflected(&self) -> Self {
        Self { head: self.head, rest: self.rest.map(|c| -c) }
    }

    /// xᵀ J x = x_0² − |x'|²; positive inside the cone.
    pub(super) fn room(&self) -> f64 {
        let length = dot(&self.rest, &self.rest).sqrt();
        (self.head - length) * (self.head + length)
    }

    /// The load μ s⁻¹ that goes with a slack on the central path.
    pub(super) fn load(&self, mu: f64) -> Self {
        self.reflected().times(mu / self.room())
    }

    /// How far one can go along a direction before the boundary of the cone.
    pub(super) fn reach(&self, direction: &Self) -> f64 {
        let a = direction.head * direction.head - dot(&direction.rest, &direction.rest);
        let b = self.head * direction.head - dot(&self.rest, &direction.rest);
        let c = self.room();
        let discriminant = b * b - a * c;
        if discriminant < 0.0 || (a >= 0.0 && b >= 0.0) {
            return f64::INFINITY;
        }
        c / (discriminant.sqrt() - b)
    }
}

/// The map W for a slack and a load.
pub(super) struct Scaling<const D: usize> {
    beta: f64,
    /// w̄ with W² = β² (2 w̄ w̄ᵀ − J).
    square: Headed<D>,
    root: Headed<D>,
    /// W z = W⁻¹ s.
    pub(super) both: Headed<D>,
}

impl<const D: usize> Scaling<D> {
    /// `None` where one of them is not inside the cone.
    pub(super) fn new(slack: &Headed<D>, load: &Headed<D>) -> Option<Self> {
        let (of_slack, of_load) = (slack.room(), load.room());
        if !(of_slack > 0.0 && of_load > 0.0 && slack.head > 0.0 && load.head > 0.0) {
            return None;
        }
        let (unit_slack, unit_load) = (slack.times(1.0 / of_slack.sqrt()), load.times(1.0 / of_load.sqrt()));
        let gamma = (0.5 * (1.0 + unit_slack.dot(&unit_load))).sqrt();
        let square = unit_slack.plus(1.0, &unit_load.reflected()).times(0.5 / gamma);
        let beta = (of_slack / of_load).sqrt().sqrt();
        let shifted = Headed { head: square.head + 1.0, rest: square.rest };
        let root = shifted.times(1.0 / (2.0 * shifted.head).sqrt());
        let mut scaling = Self { beta, square, root, both: Headed::ZERO };
        scaling.both = scaling.apply(load);
        (beta.is_finite() && beta > 0.0 && scaling.both.dot(&scaling.both).is_finite()).then_some(scaling)
    }

    /// W x.
    pub(super) fn apply(&self, x: &Headed<D>) -> Headed<D> {
        let along = 2.0 * self.root.dot(x);
        self.root.times(along).plus(-1.0, &x.reflected()).times(self.beta)
    }

    /// W⁻¹ x.
    pub(super) fn undo(&self, x: &Headed<D>) -> Headed<D> {
        let back = self.root.reflected();
        let along = 2.0 * back.dot(x);
        back.times(along).plus(-1.0, &x.reflected()).times(1.0 / self.beta)
    }

    /// W⁻² x.
    pub(super) fn undo_twice(&self, x: &Headed<D>) -> Headed<D> {
        let back = self.square.reflected();
        let along = 2.0 * back.dot(x);
        back.times(along).plus(-1.0, &x.reflected()).times(1.0 / (self.beta * self.beta))
    }

    /// An entry of W⁻², without heads.
    pub(super) fn entry(&self, a: usize, b: usize) -> f64 {
        let identity = if a == b { 1.0 } else { 0.0 };
        (identity + 2.0 * self.square.rest[a] * self.square.rest[b]) / (self.beta * self.beta)
    }

    /// x with (W z) ∘ x = right, where a ∘ b = (a · b, a_0 b' + b_0 a').
    pub(super) fn divided(&self, right: &Headed<D>) -> Headed<D> {
        let both = &self.both;
        let head = (both.head * right.head - dot(&both.rest, &right.rest)) / both.room();
        Headed { head, rest: std::array::from_fn(|c| (right.rest[c] - head * both.rest[c]) / both.head) }
    }
}

/// a ∘ b.
pub(super) fn jordan<const D: usize>(a: &Headed<D>, b: &Headed<D>) -> Headed<D> {
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
