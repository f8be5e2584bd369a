//! The query of the kernel: generators and a displacement, in whatever precision a rung wants it.

use std::borrow::Cow;

use super::direction_cone::DirectionCone;
use super::generators::Generators;
use crate::numeric::bounded::{self, BoundedVector};
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::exact_linear::{ExactVector, doubles};
use crate::numeric::linear::dot;
use crate::tally::Tally;
use crate::zonotope::pose::Standing;
use crate::zonotope::query::{Placed, Query};

/// Generators and the displacement that is asked about.
pub(crate) trait KernelQuery: Generators {
    /// The displacement p, exactly.
    fn exact(&self) -> ExactVector;

    /// The displacement p in doubles, with a bound of each coordinate's error.
    fn rounded_displacement(&self) -> BoundedVector;

    /// The displacement to twice the digits of a double.
    fn displacement_pairs(&self) -> [BoundedDoubleDouble; 3];

    /// The generators and both ends of the displacement, if doubles hold all of them; images are copied. O(n).
    fn in_doubles(&self) -> Option<InDoubles<'_>>;

    /// Whether u · p > h(u) for the displacement in doubles, proved by one pass.
    fn separates(&self, p: &BoundedVector, u: &[f64; 3]) -> bool {
        (dot(p, &bounded::exact(*u)) - self.support(u)).is_positive()
    }

    /// A cell that is likely to hold the optimum, where whoever holds the generators knows more of them than a sample
    /// tells; its centre is a direction u with u · p = 1.
    fn likely_cell(&self, _: &mut dyn Tally) -> Option<DirectionCone> {
        None
    }

    /// Σ sign · v with the signs of the products with a direction, exactly, where it is known without reading all
    /// generators; 0 is the sign of those that are orthogonal to it.
    fn exact_sum_along(&self, _: &ExactVector) -> Option<ExactVector> {
        None
    }

    /// Whether such sums are known.
    fn has_exact_sums(&self) -> bool {
        false
    }

    /// s such that the gauge of any x is at most s |x|_1, if that is known beforehand.
    fn known_gauge_bound(&self) -> Option<f64> {
        None
    }
}

/// A query as doubles hold it, at rest.
#[derive(Debug)]
pub(crate) struct InDoubles<'a> {
    ends: [[f64; 3]; 2],
    runs: [Cow<'a, [[f64; 3]]>; 2],
}

impl InDoubles<'_> {
    /// The query.
    #[inline]
    pub(crate) fn query(&self) -> Query<'_, 3> {
        Query::of_placed(Placed::of_finite(self.ends[0], &self.runs[0]), Placed::of_finite(self.ends[1], &self.runs[1]))
    }
}

impl dyn KernelQuery + '_ {
    /// All generators in doubles, in the order of their indices.
    pub(crate) fn generators(&self) -> impl Iterator<Item = [f64; 3]> {
        self.parts().into_iter().flat_map(|part| part.images())
    }
}

impl<P: Standing> KernelQuery for Query<'_, 3, P> {
    fn exact(&self) -> ExactVector {
        Query::exact(self)
    }

    #[inline(always)]
    fn rounded_displacement(&self) -> BoundedVector {
        Query::rounded_displacement(self)
    }

    fn displacement_pairs(&self) -> [BoundedDoubleDouble; 3] {
        Query::displacement_pairs(self)
    }

    fn in_doubles(&self) -> Option<InDoubles<'_>> {
        let ends = match self.at_rest() {
            Some(query) => [query.from(), query.to()],
            None => {
                let [from, to] = self.ends();
                [doubles(&from)?, doubles(&to)?]
            }
        };
        let [first, second] = Generators::parts(self);
        Some(InDoubles { ends, runs: [first.exact_images()?, second.exact_images()?] })
    }
}
