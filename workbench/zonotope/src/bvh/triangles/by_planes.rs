//! Whether two triangles meet, by the sides of each other's planes on which their corners lie.
//!
//! # Statement
//! Input: two triangles over numbers with signs that are certain or not. Output: whether they have a point in common,
//! closed; `None` where a sign that matters is not certain, a triangle is flat to a segment, or both lie in one plane.
//!
//! # Source
//! No part of the paper: the leaves of a hierarchy over meshes. The signs are those of every such test of triangles.
//!
//! # Method
//! 1. Take the signs of the corners of each triangle over the plane of the other; if three are alike and not zero, the
//!    plane separates them.
//! 2. If triangles in general position meet, an edge of one meets the other, since two faces that share a single point
//!    have dimensions of at most 3 together. An edge in the plane of the other triangle need not be looked at: the end
//!    of a common part is a corner, where another edge leaves the plane, or lies on an edge of the other triangle.
//! 3. An edge with ends on both sides of a plane, or one in it, meets the triangle just when the volumes that it spans
//!    with its three edges do not have both signs.
//!
//! # Complexity
//! O(1): six signs over planes, then three volumes for each of at most six edges.
//!
//! # Shapes
//! `a`, `b`: three corners, in any order.
//!
//! # Numerics
//! Every sign is certain or the answer is `None`. Over exact numbers `None` means a special position.
//!
//! # Checked by
//! [`brute_force`](super::brute_force), on small whole coordinates, where special positions are common.
//!
//! # Example
//! ```
//! use zonotope::bvh::{Mesh, meet};
//! let a = Mesh::new(vec![[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]], vec![[0, 1, 2]])?;
//! let b = Mesh::new(vec![[1.0, 1.0, -1.0], [1.0, 1.0, 1.0], [9.0, 9.0, 0.5]], vec![[0, 1, 2]])?;
//! assert!(meet(&a, &b)); // an edge of b crosses a at (1, 1, 0)
//! # Ok::<(), zonotope::bvh::MeshError>(())
//! ```

use crate::numeric::bounded::Bounded;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::linear::{Ring, cross, dot};

/// Numbers whose sign is certain or not.
pub(crate) trait Signed: Ring {
    /// 1, 0 or −1 if it is certain.
    fn certain_sign(&self) -> Option<i8>;
}

impl Signed for Bounded {
    #[inline(always)]
    fn certain_sign(&self) -> Option<i8> {
        self.sign()
    }
}

impl Signed for Dyadic {
    fn certain_sign(&self) -> Option<i8> {
        Some(self.sign() as i8)
    }
}

/// Whether two triangles meet, if signs decide it.
#[inline]
pub(crate) fn meet<T: Signed>(a: &[[T; 3]; 3], b: &[[T; 3]; 3]) -> Option<bool> {
    let over_a = sides_of_plane(a, b);
    if are_apart(&over_a) {
        return Some(false);
    }
    let over_b = sides_of_plane(b, a);
    if are_apart(&over_b) {
        return Some(false);
    }
    let [over_a, over_b] = [certain(over_a)?, certain(over_b)?];
    if over_a == [0; 3] || over_b == [0; 3] {
        return None;
    }
    match (an_edge_meets(b, over_a, a), an_edge_meets(a, over_b, b)) {
        (Some(true), _) | (_, Some(true)) => Some(true),
        (Some(false), Some(false)) => Some(false),
        _ => None,
    }
}

/// The sides of the plane of a triangle on which the corners of another one lie.
#[inline]
fn sides_of_plane<T: Signed>(plane: &[[T; 3]; 3], corners: &[[T; 3]; 3]) -> [Option<i8>; 3] {
    let [p, q, r] = plane;
    let normal = cross(&difference(p, q), &difference(p, r));
    corners.each_ref().map(|corner| dot(&normal, &difference(p, corner)).certain_sign())
}

#[inline]
fn are_apart(sides: &[Option<i8>; 3]) -> bool {
    *sides == [Some(1); 3] || *sides == [Some(-1); 3]
}

fn certain([a, b, c]: [Option<i8>; 3]) -> Option<[i8; 3]> {
    Some([a?, b?, c?])
}

/// Whether an edge that does not lie in the plane of a triangle meets the triangle.
fn an_edge_meets<T: Signed>(edges: &[[T; 3]; 3], sides: [i8; 3], triangle: &[[T; 3]; 3]) -> Option<bool> {
    let mut answer = Some(false);
    for (i, j) in [(0, 1), (1, 2), (2, 0)] {
        if sides[i] * sides[j] > 0 || (sides[i], sides[j]) == (0, 0) {
            continue;
        }
        match line_meets(&edges[i], &edges[j], triangle) {
            Some(true) => return Some(true),
            Some(false) => {}
            None => answer = None,
        }
    }
    answer
}

/// Whether a line that is not parallel to a triangle meets it.
fn line_meets<T: Signed>(p: &[T; 3], q: &[T; 3], triangle: &[[T; 3]; 3]) -> Option<bool> {
    let along = difference(p, q);
    let from_p = triangle.each_ref().map(|corner| difference(p, corner));
    let volume = |i: usize, j: usize| dot(&along, &cross(&from_p[i], &from_p[j])).certain_sign();
    let signs = [volume(0, 1), volume(1, 2), volume(2, 0)];
    if signs.contains(&Some(1)) && signs.contains(&Some(-1)) {
        return Some(false);
    }
    certain(signs).map(|_| true)
}

/// `to` − `from`.
#[inline(always)]
fn difference<T: Ring>(from: &[T; 3], to: &[T; 3]) -> [T; 3] {
    [to[0].minus(&from[0]), to[1].minus(&from[1]), to[2].minus(&from[2])]
}
