//! The bridge between two parts of the sites that a vertical line separates: the edge of the hull of both that joins a
//! site of the left part to one of the right part.
//!
//! Both parts are subtrees, of which only the bridges are known. Each bridge met on the way down tells, for its own
//! subtree, on which side of it the touching site lies, so the search goes down one level in one of the two subtrees
//! with every decision. It is a search between the two parts that are left: the bridge of the whole is theirs too.
//!
//! Of an upper chain, let p q be the left part's edge and r s the right part's.
//! 1. If r or s is on the line p q or above it, the slope of the bridge is at least that of p q, and it ends in p or
//!    left of it.
//! 2. If p or q is on the line r s or above it, the slope of the bridge is at most that of r s, and it ends in s or
//!    right of it.
//! 3. Else p q has the larger slope and both lines meet between the edges. If they meet before the boundary, the right
//!    part is below r s and so below p q: the bridge has a smaller slope than p q, and ends in q or right of it. If
//!    not, the left part is below p q and so below r s, and the bridge ends in r or left of it.
//!
//! Where a site is deleted that ended the bridge, two bounds on the new ends leave fewer decisions. Let p q be the old
//! bridge of an upper chain, p in the left part and deleted. What is left of that part is below the line p q, so a
//! tangent from it to the right part is at least as steep as p q, and ends in q or left of it. It ends in a neighbour
//! of p on the chain of the left part or between them: beyond the right neighbour that chain is as it was, and less
//! steep than p q; the chain before the left neighbour l is steeper than l p, and the new bridge less steep, as its end
//! in the right part is below the line p q and so below the line l p. An insertion is a deletion looked at backwards:
//! the other end moves away from the new site if it moves.
//!
//! Before and after are in the order of sites, by abscissa and then by ordinate, as if the plane were sheared by less
//! than any angle that matters: so no edge is vertical and no two sites share an abscissa.

use std::cmp::Ordering;

use super::tree::{BridgeTree, Node, Range};
use crate::arrangement::dynamic_hull::present_sites::PresentSites;
use crate::arrangement::dynamic_hull::sites::Site;
use crate::numeric::orientation::Turn;

/// The bridge between the sites of two subtrees, neither of them empty; `boundary` is a location such that all sites of
/// the left part are before it and no site of the right part is.
///
/// Of several sites on the line of the bridge it joins the outermost. Each end is known to be within `ranges`.
pub(super) fn bridge<S: Site>(
    tree: &BridgeTree,
    sites: &PresentSites<S>,
    parts: [usize; 2],
    boundary: u32,
    ranges: [Range; 2],
) -> [u32; 2] {
    let outward = sites.side.outward();
    let inward = outward.reverse();
    let [mut left, mut right] = parts;
    loop {
        match (tree.descend_within(&mut left, &ranges[0]), tree.descend_within(&mut right, &ranges[1])) {
            (Node::Leaf(p), Node::Leaf(q)) => return [p, q],
            (Node::Leaf(p), Node::Bridge(_)) => return [p, touching(tree, sites, p, right, &ranges[1], false)],
            (Node::Bridge(_), Node::Leaf(q)) => return [touching(tree, sites, q, left, &ranges[0], true), q],
            (Node::Bridge(first), Node::Bridge(second)) => {
                let [p, q] = first.map(|location| sites.point(location));
                let [r, s] = second.map(|location| sites.point(location));
                let is_inside = |a: &S, b: &S, c: &S| S::turn(a, b, c) == inward;
                let right_is_inside = is_inside(p, q, r) && is_inside(p, q, s);
                let left_is_inside = is_inside(r, s, p) && is_inside(r, s, q);
                if !right_is_inside {
                    left = BridgeTree::left(left);
                }
                if !left_is_inside {
                    right = BridgeTree::right(right);
                }
                if right_is_inside && left_is_inside {
                    if is_before([p, q], [r, s], sites.point(boundary)) {
                        left = BridgeTree::right(left);
                    } else {
                        right = BridgeTree::left(right);
                    }
                }
            }
        }
    }
}

/// Whether the lines through two edges meet before a point in the order of sites: then no site after the point is
/// outside of the first line, else no site before it is outside of the second.
///
/// Each edge is strictly inside of the other one's line, so at most one of the lines is vertical.
fn is_before<S: Site>([p, q]: [&S; 2], [r, s]: [&S; 2], at: &S) -> bool {
    match S::crossing_order([p, q], [r, s], at) {
        Ordering::Less => true,
        Ordering::Greater => false,
        // vertically above each other: the lines meet below the point if it is above a line that is not vertical
        Ordering::Equal if r.abscissa_order(s).is_eq() => S::turn(p, q, at) == Turn::Left,
        Ordering::Equal => S::turn(r, s, at) == Turn::Left,
    }
}

/// The location in a subtree, which is not empty, where the tangent from a location outside of it touches: that with
/// all sites of the subtree inside of it or on it, known to be within a range. `is_left` says whether the subtree is on
/// the left of the location.
pub(super) fn touching<S: Site>(
    tree: &BridgeTree,
    sites: &PresentSites<S>,
    from: u32,
    mut part: usize,
    range: &Range,
    is_left: bool,
) -> u32 {
    let inward = sites.side.outward().reverse();
    let from = sites.point(from);
    loop {
        match tree.descend_within(&mut part, range) {
            Node::Leaf(location) => return location,
            Node::Bridge([p, q]) => {
                let is_inside = S::turn(sites.point(p), sites.point(q), from) == inward;
                part = if is_left == is_inside { BridgeTree::right(part) } else { BridgeTree::left(part) };
            }
        }
    }
}
