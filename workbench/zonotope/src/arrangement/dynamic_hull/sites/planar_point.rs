//! Points with two doubles.

use std::cmp::Ordering;

use super::site::{Direction, Site, exact_crossing_order};
use crate::numeric::bounded::Bounded;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::non_finite::NonFinite;
use crate::numeric::orientation::{Turn, cross_sign, orientation};

/// A point of the plane with finite coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlanarPoint([f64; 2]);

impl PlanarPoint {
    /// The point with two coordinates.
    ///
    /// # Errors
    /// [`NonFinite`] if one of them is NaN or infinite.
    pub fn new(coordinates: [f64; 2]) -> Result<Self, NonFinite> {
        NonFinite::check_vector("the point", &coordinates)?;
        Ok(Self(coordinates))
    }

    /// The points of a list. O(n).
    ///
    /// # Errors
    /// [`NonFinite`] on the first coordinate that is NaN or infinite.
    pub fn list(points: &[[f64; 2]]) -> Result<Vec<Self>, NonFinite> {
        NonFinite::check_list("point", points)?;
        Ok(points.iter().map(|&point| Self(point)).collect())
    }

    /// The coordinates.
    pub fn coordinates(self) -> [f64; 2] {
        self.0
    }

    /// The difference of a coordinate from that of another point, with a bound on its error.
    #[inline]
    fn beyond(&self, other: &Self, axis: usize) -> Bounded {
        Bounded::exact(self.0[axis]) - Bounded::exact(other.0[axis])
    }
}

/// The order of finite doubles, in which the two zeros are equal.
#[inline]
fn order(a: f64, b: f64) -> Ordering {
    if a < b {
        Ordering::Less
    } else if a > b {
        Ordering::Greater
    } else {
        Ordering::Equal
    }
}

impl Site for PlanarPoint {
    #[inline]
    fn order(&self, other: &Self) -> Ordering {
        self.abscissa_order(other).then(order(self.0[1], other.0[1]))
    }

    #[inline]
    fn abscissa_order(&self, other: &Self) -> Ordering {
        order(self.0[0], other.0[0])
    }

    #[inline]
    fn order_along(&self, other: &Self, direction: Direction) -> Ordering {
        cross_sign(other.0, self.0, [0.0; 2], direction.quarter_turn()).sign()
    }

    #[inline]
    fn turn(a: &Self, b: &Self, c: &Self) -> Turn {
        orientation(a.0, b.0, c.0)
    }

    /// Relative to a site of the first line the determinants are products of differences, and keep their digits where
    /// all sites are close to each other.
    #[inline]
    fn crossing_order(first: [&Self; 2], second: [&Self; 2], at: &Self) -> Ordering {
        let [p, q, r] = [first[1], second[0], second[1]].map(|site| [0, 1].map(|axis| site.beyond(first[0], axis)));
        let near = p[0] * q[1] - p[1] * q[0];
        let far = p[0] * r[1] - p[1] * r[0];
        let difference = far * second[0].beyond(at, 0) - near * second[1].beyond(at, 0);
        match (far.sign(), difference.sign()) {
            (Some(side), Some(sign)) => (side * sign).cmp(&0),
            _ => exact_crossing_order(first, second, at),
        }
    }

    fn homogeneous(&self) -> [Dyadic; 3] {
        [Dyadic::from_f64(self.0[0]), Dyadic::from_f64(self.0[1]), Dyadic::one()]
    }
}
