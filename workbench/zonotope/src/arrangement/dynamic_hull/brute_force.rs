//! One chain of a dynamic hull, by looking at all sites in rationals: the truth the methods are held to.
//!
//! # Source
//! The definitions.
//!
//! # Method
//! 1. An update marks the site.
//! 2. The extreme vertex is the best of all present sites.
//! 3. A line through a point has no site below it if its slope is between those of the lines to the sites on the left
//!    and on the right; the tangents are the ends of that interval. An upper chain is turned upside down.
//! 4. The vertices are found by gift wrapping.
//!
//! # Complexity
//! n sites, h vertices: an update O(1), a query O(n), the vertices O(n h), all in rationals; space O(n).
//!
//! # Numerics
//! Everything is exact rational arithmetic.
//!
//! # Checked by
//! Its simplicity; the vertices of both chains beside [`hull`](crate::hull).
//!
//! # Example
//! ```
//! use std::sync::Arc;
//! use zonotope::arrangement::dynamic_hull::brute_force::BruteForce;
//! use zonotope::arrangement::dynamic_hull::{HullChain, PlanarPoint, Side, SiteIndex, SortedSites};
//! let points = PlanarPoint::list(&[[0.0, 0.0], [1.0, -1.0], [2.0, 0.0], [1.0, 5.0]])?;
//! let sites = Arc::new(SortedSites::new(&points)?);
//! let mut chain = BruteForce::new(sites, Side::Lower, (0..4).map(SiteIndex))?;
//! assert_eq!(chain.vertices(), [0, 1, 2].map(SiteIndex));
//! chain.delete(SiteIndex(1))?;
//! assert_eq!(chain.vertices(), [0, 2].map(SiteIndex));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use std::cmp::Ordering;
use std::sync::Arc;

use super::interface::{HullChain, Side, Tangent, Towards, UpdateError};
use super::sites::{Direction, Site, SiteIndex, SortedSites};
use crate::numeric::Rational;
use crate::numeric::exact_linear::exact;

/// The present sites.
#[derive(Debug, Clone)]
pub struct BruteForce<S> {
    sites: Arc<SortedSites<S>>,
    side: Side,
    /// The coordinates of all sites, turned upside down for an upper chain, which is a lower one then.
    points: Vec<[Rational; 2]>,
    present: Vec<bool>,
}

impl<S: Site> BruteForce<S> {
    /// The chain on one side of some of the sites. O(n).
    ///
    /// # Errors
    /// [`UpdateError`] if an index of `present` is repeated or unknown.
    pub fn new(
        sites: Arc<SortedSites<S>>,
        side: Side,
        present: impl IntoIterator<Item = SiteIndex>,
    ) -> Result<Self, UpdateError> {
        let count = sites.len();
        let all = (0..count as u32).filter_map(|index| sites.site(SiteIndex(index)));
        let points = all.map(|site| upright(side, site)).collect();
        let mut chain = Self { sites, side, points, present: vec![false; count] };
        for site in present {
            chain.insert(site)?;
        }
        Ok(chain)
    }

    fn presence(&mut self, site: SiteIndex) -> Result<&mut bool, UpdateError> {
        let count = self.present.len();
        self.present.get_mut(site.position()).ok_or(UpdateError::Unknown { site, count })
    }

    /// The present sites.
    fn all(&self) -> impl Iterator<Item = SiteIndex> {
        (0..self.present.len() as u32).map(SiteIndex).filter(|site| self.present[site.position()])
    }

    fn point(&self, site: SiteIndex) -> &[Rational; 2] {
        &self.points[site.position()]
    }

    /// By abscissa, then ordinate, then index.
    fn order(&self, a: SiteIndex, b: SiteIndex) -> Ordering {
        let ([x, y], [other_x, other_y]) = (self.point(a), self.point(b));
        let by_ordinate = match self.side {
            Side::Lower => y.cmp(other_y),
            Side::Upper => other_y.cmp(y),
        };
        x.cmp(other_x).then(by_ordinate).then(a.cmp(&b))
    }
}

/// The coordinates of a site, turned upside down for an upper chain.
fn upright<S: Site>(side: Side, site: &S) -> [Rational; 2] {
    let [x, y, w] = site.homogeneous().map(|coordinate| coordinate.to_rational());
    let y = match side {
        Side::Lower => y,
        Side::Upper => -y,
    };
    [x / w.clone(), y / w]
}

/// (b − a) × (c − a).
fn double_area(a: &[Rational; 2], b: &[Rational; 2], c: &[Rational; 2]) -> Rational {
    (&b[0] - &a[0]) * (&c[1] - &a[1]) - (&b[1] - &a[1]) * (&c[0] - &a[0])
}

impl<S: Site> HullChain<S> for BruteForce<S> {
    fn insert(&mut self, site: SiteIndex) -> Result<(), UpdateError> {
        match std::mem::replace(self.presence(site)?, true) {
            true => Err(UpdateError::Present(site)),
            false => Ok(()),
        }
    }

    fn delete(&mut self, site: SiteIndex) -> Result<(), UpdateError> {
        match std::mem::replace(self.presence(site)?, false) {
            true => Ok(()),
            false => Err(UpdateError::Absent(site)),
        }
    }

    fn contains(&self, site: SiteIndex) -> bool {
        self.present.get(site.position()) == Some(&true)
    }

    fn len(&self) -> usize {
        self.all().count()
    }

    fn extreme(&self, direction: Direction) -> Option<SiteIndex> {
        let [x, y] = exact(direction.vector()).map(|coordinate| coordinate.to_rational());
        let x = match self.side {
            Side::Lower => x,
            Side::Upper => -x,
        };
        let value = |site: SiteIndex| &self.point(site)[0] * &x + &self.point(site)[1] * &y;
        self.all().min_by(|&a, &b| value(a).cmp(&value(b)).then(self.order(a, b)))
    }

    fn tangent(&self, from: &S, towards: Towards) -> Tangent {
        let [x, y] = &upright(self.side, from);
        // the slopes of lines through the point with no site below them: from those of the sites on the right, which
        // are upper bounds, and on the left, which are lower bounds
        let slope = |site: SiteIndex| (&self.point(site)[1] - y) / (&self.point(site)[0] - x);
        let farther = |a: SiteIndex, b: SiteIndex| self.point(a)[0].cmp(&self.point(b)[0]);
        let on = |side: Ordering| self.all().filter(move |&site| self.point(site)[0].cmp(x) == side);
        let left =
            on(Ordering::Less).max_by(|&a, &b| slope(a).cmp(&slope(b)).then(farther(b, a)).then(self.order(b, a)));
        let right =
            on(Ordering::Greater).min_by(|&a, &b| slope(a).cmp(&slope(b)).then(farther(b, a)).then(self.order(a, b)));
        let is_below = |site: SiteIndex| self.point(site)[1] < *y;
        let has_none = left.zip(right).is_some_and(|(left, right)| slope(left) > slope(right));
        if has_none || on(Ordering::Equal).any(is_below) {
            return Tangent::Hidden;
        }
        let found = match towards {
            Towards::Left => left,
            Towards::Right => right,
        };
        found.map_or(Tangent::Unbounded, Tangent::Touches)
    }

    fn vertices(&self) -> Vec<SiteIndex> {
        let mut vertices: Vec<SiteIndex> = Vec::new();
        let mut next = self.all().min_by(|&a, &b| self.order(a, b));
        while let Some(vertex) = next {
            vertices.push(vertex);
            let from = self.point(vertex);
            let is_after = |&site: &SiteIndex| self.point(site) != from && self.order(vertex, site).is_lt();
            next = self.all().filter(is_after).reduce(|best, site| {
                let area = double_area(from, self.point(best), self.point(site));
                let is_on_line = area == Rational::ZERO;
                // equal points come in the order of their indices, so the first of them stays
                let is_farther = self.point(site) != self.point(best) && self.order(best, site).is_lt();
                let is_right = area < Rational::ZERO;
                if is_right || (is_on_line && is_farther) { site } else { best }
            });
        }
        vertices
    }

    fn bytes(&self) -> usize {
        self.sites.bytes() + self.present.capacity() + self.points.capacity() * size_of::<[Rational; 2]>()
    }
}
