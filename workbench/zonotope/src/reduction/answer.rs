//! What a reduction is asked and what it answers.

use thiserror::Error;

use super::shares::Shares;
use crate::zonotope::Zonotope;

/// A zonotope and the number of generators to which it is to be reduced.
#[derive(Debug, Clone, Copy)]
pub struct Problem<'a, const D: usize> {
    body: &'a Zonotope<D>,
    count: usize,
}

impl<'a, const D: usize> Problem<'a, D> {
    /// The body with at most `count` generators. O(1).
    ///
    /// # Errors
    /// [`ReductionError::TooFew`] if `count` is below both the dimension and the number of generators.
    pub fn new(body: &'a Zonotope<D>, count: usize) -> Result<Self, ReductionError> {
        match count >= D || count >= body.generators().len() {
            true => Ok(Self { body, count }),
            false => Err(ReductionError::TooFew { count, needed: D }),
        }
    }

    /// The body that is reduced.
    pub fn body(&self) -> &'a Zonotope<D> {
        self.body
    }

    /// The number of generators that the answer has at most.
    pub fn count(&self) -> usize {
        self.count
    }

    /// The body itself, if it has no more generators than asked for.
    pub(super) fn unreduced(&self) -> Option<Reduced<D>> {
        let fits = self.body.generators().len() <= self.count;
        fits.then(|| Reduced::unreduced(self.body))
    }
}

/// A zonotope that contains another one, with the proof of that.
#[derive(Debug, Clone, PartialEq)]
pub struct Reduced<const D: usize> {
    /// The enclosing zonotope; its centre is that of the body that was reduced.
    pub body: Zonotope<D>,
    /// Why it contains the body that was reduced.
    pub proof: Containment,
}

impl<const D: usize> Reduced<D> {
    /// A body as it is.
    pub(super) fn unreduced(body: &Zonotope<D>) -> Self {
        let shares = Shares::each_its_own(body.generators().len());
        Self { body: body.clone(), proof: Containment::Shares(shares) }
    }
}

/// Why a zonotope contains another one with the same centre.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Containment {
    /// Every generator is written in terms of the enclosing ones.
    Shares(Shares),
    /// Along every facet normal of the enclosing zonotope, the other one reaches no farther. Its facet normals are
    /// those of the hyperplanes that its generators span, so nothing has to be listed;
    /// [`brute_force::contains`](super::brute_force::contains) checks them all.
    FacetNormals,
}

/// Why a body is not reduced.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum ReductionError {
    /// A body of full dimension needs as many generators as there are coordinates.
    #[error("{count} generators are too few: a body of dimension {needed} needs {needed}")]
    TooFew {
        /// How many were asked for.
        count: usize,
        /// How many are needed.
        needed: usize,
    },
    /// A precision is not between 0 and 1.
    #[error("a precision is a number between 0 and 1, not {0}")]
    BadEpsilon(f64),
    /// A patch for every direction that the precision needs would be more than can be indexed.
    #[error("the precision needs {0} patches of directions a side of the cube, more than can be indexed")]
    TooManyPatches(f64),
    /// A generator of the enclosing zonotope exceeds the largest double.
    #[error("the enclosing zonotope leaves the range of doubles")]
    OutOfRange,
}

/// Refuses a precision outside (0, 1).
pub(super) fn check_epsilon(epsilon: f64) -> Result<(), ReductionError> {
    if epsilon > 0.0 && epsilon < 1.0 { Ok(()) } else { Err(ReductionError::BadEpsilon(epsilon)) }
}
