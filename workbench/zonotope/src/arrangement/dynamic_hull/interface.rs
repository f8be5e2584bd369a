//! What every method does: updates, queries, their answers and refusals.

use thiserror::Error;

use super::sites::{Direction, SiteIndex};
use crate::numeric::orientation::Turn;

/// A chain of a convex hull.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Side {
    /// The chain below, from the leftmost to the rightmost site: in the dual the lower envelope of lines.
    Lower,
    /// The chain above: in the dual the upper envelope.
    Upper,
}

/// Which of two tangents.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Towards {
    /// The tangent that touches a site with a smaller abscissa: in the dual a line with a smaller slope.
    Left,
    /// The tangent that touches a site with a larger abscissa.
    Right,
}

/// The place at which a tangent touches a chain.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Tangent {
    /// At this site: of several the farthest one, of equal ones that with the lowest index.
    Touches(SiteIndex),
    /// Nowhere, as no site lies towards that side: in the dual the line meets no line that way.
    Unbounded,
    /// There is none, as the point lies strictly inside of the chain, where every line through it that is not vertical
    /// has sites on both sides: in the dual the line is nowhere below the lower envelope (above the upper one).
    Hidden,
}

/// Why a site is neither inserted nor deleted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum UpdateError {
    /// It is there already.
    #[error("site {} is present already", .0.0)]
    Present(SiteIndex),
    /// It is not there.
    #[error("site {} is not present", .0.0)]
    Absent(SiteIndex),
    /// There is no site with this index.
    #[error("there is no site {}, only {count} of them", .site.0)]
    Unknown {
        /// The index.
        site: SiteIndex,
        /// How many sites there are.
        count: usize,
    },
}

/// One chain of the convex hull of the present sites.
pub trait HullChain<S> {
    /// Makes a site present.
    ///
    /// # Errors
    /// [`UpdateError`] if it is present or there is no such site; nothing changes then.
    fn insert(&mut self, site: SiteIndex) -> Result<(), UpdateError>;

    /// Makes a site absent.
    ///
    /// # Errors
    /// [`UpdateError`] if it is absent or there is no such site; nothing changes then.
    fn delete(&mut self, site: SiteIndex) -> Result<(), UpdateError>;

    /// Whether a site is present.
    fn contains(&self, site: SiteIndex) -> bool;

    /// How many sites are present.
    fn len(&self) -> usize;

    /// Whether no site is present.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The site whose scalar product with a direction is least (of a lower chain) or greatest (of an upper chain): in
    /// the dual the line that the envelope follows at an abscissa. Of several sites the leftmost, then the lowest, then
    /// the one with the lowest index; `None` if no site is present.
    fn extreme(&self, direction: Direction) -> Option<SiteIndex>;

    /// Where the line through a point with all sites above it or on it (of a lower chain; below it, of an upper one)
    /// touches the sites, turned as far towards one side as it goes: in the dual the end, on one side, of the part of a
    /// line on which it is nowhere above the lower envelope (below the upper one).
    fn tangent(&self, from: &S, towards: Towards) -> Tangent;

    /// The vertices from left to right: no three on a line, of equal sites the one with the lowest index.
    fn vertices(&self) -> Vec<SiteIndex>;

    /// How many bytes are held, the sorted sites included, the digits of long numbers not.
    fn bytes(&self) -> usize;
}

impl Side {
    /// The turn from an edge, directed to the right, to a point outside of the chain.
    #[inline]
    pub(super) fn outward(self) -> Turn {
        match self {
            Self::Lower => Turn::Right,
            Self::Upper => Turn::Left,
        }
    }
}
