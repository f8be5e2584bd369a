//! A distance between two bounds.

/// A distance between two bounds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Distance<const D: usize> {
    /// The distance: the double nearest to it where the bounds are neighbours or equal, else the middle between them.
    pub value: f64,
    /// The distance is not below this.
    pub lower: f64,
    /// The distance is not above this.
    pub upper: f64,
    /// A direction of a length about 1 in which the support functions differ by `lower`, up to rounding.
    pub direction: [f64; D],
}

impl<const D: usize> Distance<D> {
    /// Two bounds with the middle between them.
    pub(super) fn between(lower: f64, upper: f64, direction: [f64; D]) -> Self {
        Self { value: lower + (upper - lower) / 2.0, lower, upper, direction }
    }

    /// The same distance, of which it is known that it is not above a bound.
    pub(in crate::reduction) fn at_most(self, bound: f64) -> Self {
        if bound < self.upper { Self::between(self.lower, bound.max(self.lower), self.direction) } else { self }
    }
}
