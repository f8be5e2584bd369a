//! Convex hull in space, by quickhull: each point outside waits at one facet, and the farthest one there is added next.
//!
//! # Statement
//! Input: points with finite coordinates, at least one, in any order, duplicates allowed. Output: triangles,
//! counter-clockwise as seen from outside, that together are the boundary of the hull; `None` when all points lie in a
//! plane.
//!
//! # Source
//! Barber, Dobkin and Huhdanpaa, The quickhull algorithm for convex hulls, 1996, with exact signs in place of thick
//! facets.
//!
//! # Method
//! 1. Four points that span space (`simplex`): a tetrahedron. Each other point goes to a face that it is strictly
//!    above.
//! 2. A face at which points wait: of these the one that is highest above it, the apex.
//! 3. The faces that the apex is strictly above are connected, and their rim is a simple closed polygon, also where the
//!    apex is in the planes of other faces: a little nearer to the hull it is above the same ones and in no plane.
//!    They give way to triangles from the sides of the rim to the apex.
//! 4. The points that waited at them go to new triangles that they are strictly above. A point that is above none of
//!    these is inside: were it above an old face, then along a path of such faces from the one at which it waited, it
//!    would be above both faces at a side of the rim, and with them above the new triangle at that side, whose normal
//!    lies between theirs.
//! 5. Repeat from 2 until no point waits.
//!
//! # Complexity
//! n points, h of them corners of triangles: O(n log h) expected in ordinary input, O(n h) at worst; O(n + h) space.
//!
//! # Shapes
//! `points`: n × 3.
//!
//! # Numerics
//! All signs are exact. A height is computed in doubles with one bound of its error for each face and all points; where
//! that leaves a doubt, the sign is that of the exact determinant. No triangle is degenerate: the apex is strictly
//! above a face at each side of the rim, so it is not on the line of the side. Which point becomes an apex depends on
//! rounded heights, and changes nothing but the triangles of facets with more than three points.
//!
//! # Errors
//! [`HullError::Empty`] ⇔ no points; [`HullError::NonFinite`] ⇔ a coordinate is NaN or infinite; [`HullError::TooMany`]
//! ⇔ more than [`MAX_POINTS`](crate::hull::MAX_POINTS) points.
//!
//! # Checked by
//! [`brute_force`](super::brute_force); that no point is above a triangle, and Euler's relation, in the tests.
//!
//! # Example
//! ```
//! use zonotope::hull::in_space::solid_hull;
//! let grid: Vec<[f64; 3]> = (0..27).map(|i| [i % 3, i / 3 % 3, i / 9].map(f64::from)).collect();
//! let cube = solid_hull(&grid)?.expect("the grid spans space");
//! assert_eq!(cube.volume(&grid), 8.0);
//! assert_eq!(solid_hull(&grid[..9])?, None); // a square
//! # Ok::<(), zonotope::hull::HullError>(())
//! ```

use std::cmp::Ordering;

use super::simplex::{Spanned, spanned};
use super::triangulated::SolidHull;
use crate::hull::error::{HullError, check_count};
use crate::numeric::linear::{cross, dot};
use crate::numeric::non_finite::NonFinite;
use crate::numeric::orientation::in_space::side_of_plane;
use crate::numeric::tolerance::HEIGHT_OVER_PLANE;

/// The hull of points; `None` when they lie in a plane.
///
/// # Errors
/// See the module.
pub fn solid_hull(points: &[[f64; 3]]) -> Result<Option<SolidHull>, HullError> {
    check_count(points.len())?;
    NonFinite::check_list("point", points)?;
    Ok(match spanned(points) {
        Spanned::Space(simplex) => Some(hull_around(points, simplex)),
        Spanned::Place(_) | Spanned::Line(_) | Spanned::Plane(_) => None,
    })
}

/// The hull of points, of which four span space, the last of them below the plane of the others, which are
/// counter-clockwise.
pub(super) fn hull_around(points: &[[f64; 3]], simplex: [usize; 4]) -> SolidHull {
    let mut growing = Growing::new(points, simplex.map(|corner| corner as u32));
    while let Some(face) = growing.open.pop() {
        if let Some(apex) = growing.faces[face].take_highest() {
            growing.add(apex, face);
        }
    }
    let whole = growing.faces.iter().filter(|face| face.is_on_hull);
    SolidHull::from_triangles(whole.map(|face| face.corners.map(|corner| corner as usize)).collect())
}

/// A triangle of the hull so far, and the points that wait at it.
struct Face {
    /// Counter-clockwise as seen from outside.
    corners: [u32; 3],
    /// The faces across the sides that begin at the corners.
    neighbours: [usize; 3],
    /// A normal in doubles, outwards.
    normal: [f64; 3],
    /// What a computed height of any of the points is off by at most.
    doubt: f64,
    /// Points strictly above the face.
    waiting: Vec<u32>,
    /// The place among these of the one whose computed height is greatest, and that height.
    highest: (usize, f64),
    is_on_hull: bool,
}

impl Face {
    /// Takes out the highest of the points that wait.
    fn take_highest(&mut self) -> Option<u32> {
        (!self.waiting.is_empty()).then(|| self.waiting.swap_remove(self.highest.0))
    }
}

/// The hull of some of the points.
struct Growing<'a> {
    points: &'a [[f64; 3]],
    /// The extents of the points along the axes.
    extents: [f64; 3],
    /// Those of the hull, and others that were.
    faces: Vec<Face>,
    /// Places of faces that are not of the hull any more.
    vacant: Vec<usize>,
    /// Faces at which points wait, and others.
    open: Vec<usize>,
}

impl<'a> Growing<'a> {
    /// A tetrahedron, with the other points at its faces.
    fn new(points: &'a [[f64; 3]], [a, b, c, d]: [u32; 4]) -> Self {
        let range = |axis: usize| {
            let start = (f64::INFINITY, f64::NEG_INFINITY);
            let (low, high) = points.iter().fold(start, |(low, high), p| (low.min(p[axis]), high.max(p[axis])));
            high - low
        };
        let extents = [range(0), range(1), range(2)];
        let mut growing = Self { points, extents, faces: Vec::new(), vacant: Vec::new(), open: Vec::new() };
        let neighbours = [[1, 2, 3], [3, 2, 0], [1, 3, 0], [2, 1, 0]];
        for (corners, neighbours) in [[a, b, c], [a, d, b], [b, d, c], [c, d, a]].into_iter().zip(neighbours) {
            growing.put(corners, neighbours);
        }
        growing.distribute(0..points.len() as u32, &[0, 1, 2, 3]);
        growing
    }

    /// Makes a face.
    fn put(&mut self, corners: [u32; 3], neighbours: [usize; 3]) -> usize {
        let [a, b, c] = corners.map(|corner| self.points[corner as usize]);
        let [u, v] = [b, c].map(|p| difference(&p, &a));
        let size = |i: usize, j: usize| (u[i] * v[j]).abs() + (u[j] * v[i]).abs();
        let products = dot(&[size(1, 2), size(2, 0), size(0, 1)], &self.extents);
        // A product that underflows is off by less than the smallest normal double.
        let underflow = f64::MIN_POSITIVE * (1.0 + self.extents.iter().sum::<f64>());
        let doubt = HEIGHT_OVER_PLANE * products + underflow;
        let (waiting, highest) = (Vec::new(), (0, 0.0));
        let face = Face { corners, neighbours, normal: cross(&u, &v), doubt, waiting, highest, is_on_hull: true };
        if let Some(place) = self.vacant.pop() {
            self.faces[place] = face;
            place
        } else {
            self.faces.push(face);
            self.faces.len() - 1
        }
    }

    /// The height of a point above a face in doubles, times some length, if the point is strictly above it.
    fn height_above(&self, face: usize, point: u32) -> Option<f64> {
        let Face { corners, normal, doubt, .. } = &self.faces[face];
        let p = &self.points[point as usize];
        let height = dot(normal, &difference(p, &self.points[corners[0] as usize]));
        // Where a product overflows, so does the height, or it is no number.
        if height.abs() > *doubt && height.is_finite() {
            return (height > 0.0).then_some(height);
        }
        let [a, b, c] = corners.map(|corner| &self.points[corner as usize]);
        (side_of_plane(a, b, c, p) == Ordering::Greater).then_some(height)
    }

    /// Has each of some points wait at the first of some faces that it is strictly above; the others are inside.
    fn distribute(&mut self, points: impl IntoIterator<Item = u32>, faces: &[usize]) {
        for point in points {
            let above = faces.iter().find_map(|&face| Some((face, self.height_above(face, point)?)));
            if let Some((face, height)) = above {
                let Face { waiting, highest, .. } = &mut self.faces[face];
                if waiting.is_empty() || height > highest.1 {
                    *highest = (waiting.len(), height);
                }
                waiting.push(point);
            }
        }
        self.open.extend(faces.iter().filter(|&&face| !self.faces[face].waiting.is_empty()));
    }

    /// Adds a point that is strictly above a face.
    fn add(&mut self, apex: u32, face: usize) {
        let (seen, rim) = self.seen_from(apex, face);
        let mut waiting = Vec::new();
        for face in seen {
            waiting.append(&mut self.faces[face].waiting);
            self.vacant.push(face);
        }
        let mut fresh: Vec<(u32, usize)> = Vec::with_capacity(rim.len());
        for Side { from, to, beyond } in rim {
            let new = self.put([from, to, apex], [beyond, usize::MAX, usize::MAX]);
            let across = self.faces[beyond].corners.iter().position(|&corner| corner == to).unwrap_or(0);
            self.faces[beyond].neighbours[across] = new;
            fresh.push((from, new));
        }
        fresh.sort_unstable();
        for &(_, new) in &fresh {
            let to = self.faces[new].corners[1];
            let Ok(next) = fresh.binary_search_by_key(&to, |&(from, _)| from) else { continue };
            let next = fresh[next].1;
            self.faces[new].neighbours[1] = next;
            self.faces[next].neighbours[2] = new;
        }
        let fresh: Vec<usize> = fresh.into_iter().map(|(_, new)| new).collect();
        self.distribute(waiting, &fresh);
    }

    /// The faces that a point is strictly above, of which one is given, and the sides of their rim. They are no faces
    /// of the hull any more.
    fn seen_from(&mut self, apex: u32, face: usize) -> (Vec<usize>, Vec<Side>) {
        self.faces[face].is_on_hull = false;
        let (mut seen, mut rim) = (vec![face], Vec::new());
        let mut next = 0;
        while let Some(&face) = seen.get(next) {
            next += 1;
            let Face { corners, neighbours, .. } = self.faces[face];
            for (side, beyond) in neighbours.into_iter().enumerate() {
                if !self.faces[beyond].is_on_hull {
                    continue;
                }
                if self.height_above(beyond, apex).is_some() {
                    self.faces[beyond].is_on_hull = false;
                    seen.push(beyond);
                } else {
                    rim.push(Side { from: corners[side], to: corners[(side + 1) % 3], beyond });
                }
            }
        }
        (seen, rim)
    }
}

/// A side of a seen face at a face that is not seen.
struct Side {
    from: u32,
    to: u32,
    beyond: usize,
}

fn difference(p: &[f64; 3], from: &[f64; 3]) -> [f64; 3] {
    std::array::from_fn(|c| p[c] - from[c])
}
