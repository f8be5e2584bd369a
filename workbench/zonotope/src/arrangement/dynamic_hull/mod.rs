//! Problem: the convex hull of points of the plane that come and go; in the dual, the envelopes of lines that do.
//!
//! The line y = m x + q is the point (m, q). Its height at x is the scalar product of the point with (x, 1), so the
//! chain of the hull below the points is the lower envelope of the lines, and the chain above them the upper one.
//!
//! | of points | of lines |
//! |---|---|
//! | the vertices of the lower chain | the lines of the lower envelope |
//! | the extreme vertex in the direction (x, 1) | the line that the envelope follows at x |
//! | the tangents from a point below the lower chain | where a line that is below the lower envelope somewhere meets it |
//! | such a tangent touches on the left (right) | such a line meets it at the right (left) end of that part |
//!
//! Of an upper chain the last row is the other way round. Every answer is exact, so it does not depend on the method.
//!
//! # Statement
//! Input: sites, sorted, and which of them are present; insertions and deletions. Output: at any time the chain below
//! or above the present sites, its extreme vertex in a direction, the tangents from a point ([`HullChain`]). No three
//! vertices are on a line; equal sites are one vertex, which has the lowest index of those present; sites that share an
//! abscissa are in the order of their ordinates. No sites have an empty chain.
//!
//! # Shapes
//! `sites`: n points or lines in any order, duplicates allowed ([`SortedSites`]); `present`: indices in any order, none
//! twice.
//!
//! # Errors
//! [`UpdateError::Present`] ⇔ a site is inserted that is there; [`UpdateError::Absent`] ⇔ one is deleted that is not
//! there; [`UpdateError::Unknown`] ⇔ the index is not below the number of sites.
//!
//! # What a walk needs
//! Lemma 5.6 walks from face to face of the tiling, from vertex to vertex of the dual arrangement. At the vertex of two
//! lines the walker keeps all lines above it in a lower chain and all lines below it in an upper chain. Along one of
//! its two lines, to the right, the next vertex is with the line at which the left tangent touches the lower chain or
//! with that at which the right tangent touches the upper chain: [`Site::turn`] tells which one comes first. A step
//! deletes that line from its chain and inserts the one that is left behind. All lines are known from the start, so
//! they are sorted once ([`SortedSites`], shared by both chains), and a site is named by its index in the input. Past
//! an unbounded edge what was above is below, so [`facet_walk`](super::facet_walk) keeps both chains of both sets.
//!
//! | method | update | query | what it is |
//! |---|---|---|---|
//! | [`brute_force`] | O(1) | O(n), exact rationals | the truth |
//! | [`by_bridge_tree`] | O(log² n) | O(log n) | Overmars and van Leeuwen's, with bridges alone |
//!
//! n sites. An orientation of three sites is the unit of time.
//!
//! # Example
//! The line y = 0 has y = 2 − x above it and y = x / 4 − 1 below it, at x = 0. To the right it meets the first one
//! first.
//! ```
//! use std::sync::Arc;
//! use zonotope::arrangement::dynamic_hull::{DynamicChain, HullChain, Side, Site, SlopedLine, SortedSites, Tangent};
//! use zonotope::arrangement::dynamic_hull::{SiteIndex, Towards};
//! use zonotope::numeric::orientation::Turn;
//! // rows [a, b, c] of a x + b y + c = 0
//! let line = SlopedLine::new;
//! let lines = [line([0.0, 1.0, 0.0])?, line([1.0, 1.0, -2.0])?, line([-1.0, 4.0, 4.0])?];
//! let sites = Arc::new(SortedSites::new(&lines)?);
//! let mut above = DynamicChain::new(sites.clone(), Side::Lower, [SiteIndex(1)])?;
//! let below = DynamicChain::new(sites, Side::Upper, [SiteIndex(2)])?;
//! assert_eq!(above.tangent(&lines[0], Towards::Left), Tangent::Touches(SiteIndex(1)));
//! assert_eq!(below.tangent(&lines[0], Towards::Right), Tangent::Touches(SiteIndex(2)));
//! assert_eq!(Site::turn(&lines[1], &lines[0], &lines[2]), Turn::Right);
//! above.delete(SiteIndex(1))?;
//! assert_eq!(above.tangent(&lines[0], Towards::Left), Tangent::Unbounded);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod brute_force;
pub mod by_bridge_tree;
mod chain;
mod descent;
mod interface;
mod present_sites;
mod sites;

pub use chain::DynamicChain;
pub use interface::{HullChain, Side, Tangent, Towards, UpdateError};
pub use sites::{
    Direction, DirectionError, MAX_SITES, PlanarPoint, Site, SiteIndex, SlopedLine, SlopedLineError, SortedSites,
    TooManySites,
};

#[cfg(test)]
mod tests;
