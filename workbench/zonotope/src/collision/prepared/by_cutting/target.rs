//! The displacement that a query is about, or its opposite.

use super::filtered::Vector;
use crate::numeric::double_double::Precision;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, negated};
use crate::zonotope::query::Query;

/// A displacement that is not zero, relative to the generators of a body.
#[derive(Debug)]
pub(crate) struct Target<'q> {
    pub(crate) query: Query<'q, 3>,
    /// The displacement.
    pub(crate) p: ExactVector,
    /// The displacement, scaled such that its longest coordinate is about 1.
    pub(crate) direction: ExactVector,
}

impl Vector for Target<'_> {
    fn over<N: Precision>(&self) -> [N; 3] {
        self.direction.over()
    }
}

impl<'q> Target<'q> {
    /// The target of a query; `None` if its displacement is zero.
    pub(crate) fn new(query: Query<'q, 3>) -> Option<Self> {
        let p = query.exact();
        let exponent = p.iter().filter_map(Dyadic::binary_exponent).max()?;
        let direction = p.clone().map(|c| c.scaled(-exponent));
        Some(Self { query, p, direction })
    }

    /// The opposite displacement, relative to the same generators; the body is the same seen from there.
    pub(crate) fn opposite(self, generators: &'q [[f64; 3]]) -> Self {
        let query = Query::of_finite(self.query.to(), self.query.from(), generators);
        Self { query, p: negated(self.p), direction: negated(self.direction) }
    }
}
