//! Bodies of the line and the plane as prisms in space.
//!
//! Let Z lie in R^D, D < 3. The prism Z × [−s, s]^(3−D) has the generators of Z and one more along each new axis. A
//! displacement p of R^D lies in t Z just when (p, 0) lies in t times the prism, and in the interior of t Z just when
//! (p, 0) is in the interior, so gauge and status are the same. A proof for the prism is one for Z: the coefficient
//! of a new generator is 0, and a direction loses its new coordinates.

use std::array;
use std::ops::Range;

use crate::numeric::lanes::Extents;
use crate::numeric::scaling::{binary_exponent, scale_by_power_of_two};
use crate::numeric::tolerance::SQUARABLE_SIZES;
use crate::zonotope::location::{Location, Witness};
use crate::zonotope::query::{Query, padded};

/// The points and generators of a prism.
#[derive(Debug)]
pub(crate) struct Prism {
    from: [f64; 3],
    to: [f64; 3],
    generators: Vec<[f64; 3]>,
    /// The number of generators of the body.
    own: usize,
}

impl Prism {
    pub(crate) fn over<const D: usize>(query: &Query<'_, D>) -> Self {
        let generators = query.generators().map(padded).collect();
        Self::with_axes(padded(&query.from()), padded(&query.to()), generators, D..3)
    }

    /// The prism over a body of space from which a coordinate is dropped: that coordinate is 0 in all points and
    /// generators, but for the prism's new generator.
    pub(crate) fn without(axis: usize, query: &Query<'_, 3>) -> Self {
        let dropped = |v: &[f64; 3]| array::from_fn(|i| if i == axis { 0.0 } else { v[i] });
        let generators = query.generators().map(dropped).collect();
        Self::with_axes(dropped(&query.from()), dropped(&query.to()), generators, axis..axis + 1)
    }

    fn with_axes(from: [f64; 3], to: [f64; 3], mut generators: Vec<[f64; 3]>, axes: Range<usize>) -> Self {
        let own = generators.len();
        let total: f64 = Extents::new(&generators).sums().iter().sum();
        // as wide along the new axis as the body is long, or nearly; as its longest generator where squares of the
        // total length would overflow
        let size = if total < SQUARABLE_SIZES.end {
            total
        } else {
            generators.as_flattened().iter().fold(0.0f64, |m, c| m.max(c.abs()))
        };
        let size = scale_by_power_of_two(1.0, binary_exponent(size).map_or(0, i64::from));
        generators.extend(axes.map(|axis| array::from_fn(|i| if i == axis { size } else { 0.0 })));
        Self { from, to, generators, own }
    }

    pub(crate) fn query(&self) -> Query<'_, 3> {
        Query::of_finite(self.from, self.to, &self.generators)
    }

    /// Whether a generator is not one of the body.
    pub(crate) fn is_new(&self, generator: usize) -> bool {
        generator >= self.own
    }

    /// The coefficients for the body.
    pub(crate) fn lower_witness(&self, witness: Witness) -> Witness {
        witness.lowered(self.own)
    }

    /// The answer for the body.
    pub(crate) fn lower<const D: usize>(&self, location: Location<3>) -> Location<D> {
        location.lowered(self.own)
    }
}
