//! The decisions of a search along a chain: in which direction of an edge the answer lies.
//!
//! An edge of the hull of a part of the sites leads to that part's answer, whether or not the edge is one of the whole
//! hull: so the decisions serve a descent through the parts of a tree.

use std::cmp::Ordering;

use super::interface::{Side, Towards};
use super::present_sites::LocationTangent;
use super::sites::{Direction, Site};

/// On which side of an edge the search goes on; the end of the edge belongs to that side.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Step {
    Left,
    Right,
    /// No tangent exists.
    Hidden,
}

/// Where the site that is extreme in a direction lies: to the left where both ends of the edge are.
#[inline]
pub(super) fn extreme_step<S: Site>(side: Side, edge: [&S; 2], direction: Direction) -> Step {
    let better = match side {
        Side::Lower => Ordering::Greater,
        Side::Upper => Ordering::Less,
    };
    if edge[0].order_along(edge[1], direction) == better { Step::Right } else { Step::Left }
}

/// Where the tangent from a point touches.
///
/// The edges that the point sees from outside are consecutive, and the tangents end at both ends of these. If it sees
/// this edge, the end is on the side that is asked for; if not, the edges that it sees are on its own side of the edge,
/// and there are none where the point is between the ends of the edge or vertically above or below one of them.
#[inline]
pub(super) fn tangent_step<S: Site>(side: Side, edge: [&S; 2], from: &S, towards: Towards) -> Step {
    let turn = S::turn(edge[0], edge[1], from);
    if turn == side.outward().reverse() {
        return if from.abscissa_order(edge[0]).is_lt() {
            Step::Left
        } else if from.abscissa_order(edge[1]).is_gt() {
            Step::Right
        } else {
            Step::Hidden
        };
    }
    // on the line of a vertical edge, at the right end of a lower chain or the left end of an upper one
    let is_on_vertical = turn != side.outward() && edge[0].abscissa_order(edge[1]).is_eq();
    if is_on_vertical && is_inside_of(side, edge, from) {
        return Step::Hidden;
    }
    match towards {
        Towards::Left => Step::Left,
        Towards::Right => Step::Right,
    }
}

/// Whether a point on the line of a vertical edge is inside of the chain: above its lowest point, or below its highest.
fn is_inside_of<S: Site>(side: Side, edge: [&S; 2], from: &S) -> bool {
    match side {
        Side::Lower => from.order(edge[0]).is_gt(),
        Side::Upper => from.order(edge[1]).is_lt(),
    }
}

/// The tangent from a point to the one site at a location.
pub(super) fn tangent_to_site<S: Site>(
    side: Side,
    location: u32,
    site: &S,
    from: &S,
    towards: Towards,
) -> LocationTangent {
    let wanted = match towards {
        Towards::Left => Ordering::Less,
        Towards::Right => Ordering::Greater,
    };
    match site.abscissa_order(from) {
        Ordering::Equal if is_inside_of(side, [site, site], from) => LocationTangent::Hidden,
        order if order == wanted => LocationTangent::Touches(location),
        _ => LocationTangent::Unbounded,
    }
}
