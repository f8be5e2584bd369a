//! How deep two bodies overlap: the answer.

/// By how much two bodies overlap, between two bounds: the length of the shortest translation after which they only
/// touch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Penetration<const D: usize> {
    /// No shorter translation takes the bodies apart.
    pub lower: f64,
    /// A translation of this length does; infinite where lengths leave the range of doubles.
    pub upper: f64,
    /// The direction of that translation for the second body, rounded, of any length; that of the first is opposite.
    /// 0 where the bodies do not overlap.
    pub direction: [f64; D],
}

impl<const D: usize> Penetration<D> {
    /// The bodies do not overlap: they touch, or they are disjoint.
    pub(super) const NONE: Self = Self { lower: 0.0, upper: 0.0, direction: [0.0; D] };

    /// The same answer under the name of its dimension.
    pub(super) fn in_dimension<const E: usize>(&self) -> Penetration<E> {
        let Self { lower, upper, direction } = *self;
        Penetration { lower, upper, direction: std::array::from_fn(|k| direction[k]) }
    }

    /// Whether the bounds differ by at most so much of the upper one.
    pub fn is_within(&self, relative: f64) -> bool {
        self.upper - self.lower <= relative * self.upper
    }
}
