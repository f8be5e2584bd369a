//! The support value of the body in a direction, exactly, and a vertex that has it.

use super::DirectionTree;
use super::query::TreeQuery;
use crate::lad::of_generators::seam::direction_signs::DirectionSigns;
use crate::lad::of_generators::seam::generators::Generators;
use crate::numeric::exact_linear::{self, ExactVector, exact, negated};
use crate::numeric::non_finite::NonFinite;
use crate::zonotope::Support;
use crate::zonotope::query::Query;

impl DirectionTree {
    /// The support function and an extreme vertex, exactly, as [`Zonotope::support`](crate::Zonotope::support) has
    /// them: a generator that is orthogonal to the direction has the coefficient 1. O(√n) nodes and leaves of a random
    /// body; a pass where the coordinates are too far apart for short exact sums.
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the direction is NaN or infinite.
    pub fn support(&self, direction: [f64; 3]) -> Result<Support<3>, NonFinite> {
        NonFinite::check_vector("the direction", &direction)?;
        let u = exact(direction);
        let (sum, orthogonal) = match self.exact_sum_along(&u) {
            Some((sum, orthogonal)) => (sum, orthogonal.iter().map(|&place| place as usize).collect()),
            None => self.summed_up(&u),
        };
        let point =
            orthogonal.into_iter().fold(exact_linear::sum(&exact(self.center), &sum), |point: ExactVector, i| {
                let v = exact(self.rows[i]);
                exact_linear::sum(&point, &if self.is_turned[i] { negated(v) } else { v })
            });
        Ok(Support { exact_value: exact_linear::dot(&point, &u), exact_point: point })
    }

    /// The sum with the signs of all products with a direction, by a pass over the rows.
    fn summed_up(&self, u: &ExactVector) -> (ExactVector, Vec<usize>) {
        let query = self.at_origin();
        let signs = DirectionSigns::new(&query, u).all(u);
        let orthogonal = (0..signs.len()).filter(|&i| signs[i] == 0).collect();
        (query.signed_sum(&signs), orthogonal)
    }

    /// The centre itself as a query.
    fn at_origin(&self) -> TreeQuery<'_> {
        TreeQuery { query: Query::of_finite(self.center, self.center, &self.rows), trees: [Some(self), None] }
    }
}
