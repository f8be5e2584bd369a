//! The signs of generators for an exact direction: two doubles a coordinate tell nearly all, exact arithmetic the
//! others.

use super::kernel_query::KernelQuery;
use super::part::Part;
use crate::numeric::double_double::DoubleDoubleDirection;
use crate::numeric::exact_linear::{ExactVector, dot};

/// The signs of the generators of a query for an exact direction.
pub(crate) struct DirectionSigns<'a> {
    query: &'a dyn KernelQuery,
    /// The direction pulled back into the frame of each part, for products with the part's rows; none for a second
    /// part without rows.
    directions: Vec<DoubleDoubleDirection>,
}

impl<'a> DirectionSigns<'a> {
    pub(crate) fn new(query: &'a dyn KernelQuery, direction: &ExactVector) -> Self {
        let [first, second] = query.parts();
        let parts = [Some(first), Some(second).filter(|part| !part.rows.is_empty())];
        let pulled = |part: Part<'_>| DoubleDoubleDirection::of(&part.exact_pulled(direction));
        Self { query, directions: parts.into_iter().flatten().map(pulled).collect() }
    }

    /// The sign of one generator, if two doubles a coordinate tell it and it is not zero.
    pub(crate) fn certain_sign(&self, index: usize) -> Option<i8> {
        let [first, second] = self.query.parts();
        match index.checked_sub(first.rows.len()) {
            None => self.directions[0].certain_sign(&first.rows.list()[index]),
            Some(index) => self.directions[1].certain_sign(&second.rows.list()[index]),
        }
    }

    /// The sign of one generator, exactly; `direction` is the one from which this value was made.
    pub(crate) fn sign(&self, index: usize, direction: &ExactVector) -> i8 {
        let exact = || dot(&self.query.exact_generator(index), direction).sign() as i8;
        self.certain_sign(index).unwrap_or_else(exact)
    }

    /// The signs of all generators, exactly; `direction` is the one from which this value was made.
    pub(crate) fn all(&self, direction: &ExactVector) -> Vec<i8> {
        (0..self.query.len()).map(|index| self.sign(index, direction)).collect()
    }
}
