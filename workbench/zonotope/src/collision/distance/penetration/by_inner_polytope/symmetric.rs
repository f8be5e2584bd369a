//! The search in plain doubles, whose bounds are proved from one margin for all corners of the polytope.
//!
//! # The lower bound
//! The polytope is symmetric about the centre of the body, so one face of each opposite pair is kept. A corner is the
//! sum of a pass and off by at most ε_k in coordinate k from the point of the body with the same signs, and so is p.
//! For any vector n, a triangle of corners x lies where n · (x − p) ≥ min n · (x − p); with the margin Σ |n_k| M_k, in
//! which M holds the errors of corners, of p and of the products, this is true of the triangles of true points, too,
//! and of all between. So no face comes nearer to p than r, the least of these levels over |n|, as the surface of
//! rounded corners becomes that of true ones, and both wind around p equally often. The first one does so where each of
//! its faces has a positive determinant as seen from p: that of corners a, b, c is N · (a − p) for the normal N, from
//! which the computed one differs by less than 16 u |b − a| |c − a| in each coordinate, the largest magnitudes of
//! coordinates. A ball around p that no face meets, and that a surface winds around, lies within the hull of the
//! surface's corners, and so in the body.
//!
//! # The upper bound
//! h(u) − u · p over |u|, where the extreme point of a pass falls short of h(u) by no more than the bound of
//! [`Extents::error`].
//!
//! Nothing else is used: which faces a new corner sees, and whether the polytope is convex, are guesses.

use super::search_end::{VERTEX_LIMIT, is_settled};
use crate::collision::distance::Penetration;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::lad::of_generators::seam::part::Part;
use crate::numeric::bounded::BoundedVector;
use crate::numeric::lanes::rows::Rows;
use crate::numeric::lanes::{Extents, extreme_sum_of};
use crate::numeric::linear::{cross, dot, euclidean_norm, max_norm};
use crate::numeric::tolerance::{FIVE_ROUNDINGS, LONG_SUM, MODERATE_SIZES, PRODUCT_UNDERFLOW, SHORTEST_LENGTH, UNIT};
use crate::tally::{Operation, Tally};
use crate::zonotope::location::Coefficients;

/// Generators whose sum is taken before it is added to that of the others, so that a term of a large body goes through
/// few additions: next to contact their roundings are what the depth is compared with.
const BLOCK: usize = 4096;

/// A corner or the opposite one: twice its place in the list, and one more for the opposite one.
type Corner = u32;

/// The depth of a p that is inside, if doubles find it; `None` where rounding leaves a doubt.
///
/// Near contact the proof that p is inside names the facet along the ray to p. Its corners are the first ones of the
/// polytope: mostly the facet is the nearest one, and the search ends with it.
pub(super) fn depth(query: &dyn KernelQuery, member: &Coefficients, tally: &mut dyn Tally) -> Option<Penetration<3>> {
    let body = Body::of(query)?;
    let mut best = Penetration { lower: 0.0, upper: f64::INFINITY, direction: [0.0; 3] };
    let mut look = |u: [f64; 3], best: &mut Penetration<3>| {
        tally.add(Operation::SearchStep, 1);
        tally.add(Operation::GeneratorRead, query.len() as u64);
        body.look(u, best)
    };
    let mut polytope = match directions_to_corners(query, member) {
        Some(directions) => {
            let [first, second, third, fourth] = directions.map(|u| look(u, &mut best));
            let mut polytope = Polytope::octahedron(&body, [first, second, third])?;
            polytope.add(fourth);
            polytope
        }
        None => {
            let along = if max_norm(&body.p) > 0.0 { body.p } else { [1.0, 0.0, 0.0] };
            let first = look(along, &mut best);
            let second = look(sideways(&first), &mut best);
            let third = look(cross(&first, &second), &mut best);
            Polytope::octahedron(&body, [first, second, third])?
        }
    };
    while polytope.corners.len() < VERTEX_LIMIT {
        let (u, lower) = polytope.nearest();
        best.lower = lower.max(0.0);
        if is_settled(&best) {
            break;
        }
        let vertex = look(u, &mut best);
        if is_settled(&best) || !polytope.add(vertex) {
            break;
        }
    }
    (best.lower > 0.0 && is_settled(&best)).then_some(best)
}

/// The angle by which a direction is tilted from the normal of a facet to a corner, times the number of generators: in
/// a facet's neighbourhood, which is about one over that number wide, no other generator changes its sign.
const CORNER_TILT: f64 = 1.0 / 1024.0;

/// Directions in which the corners of the facet are extreme that the coefficients of p lie near, if they follow a rule.
fn directions_to_corners(query: &dyn KernelQuery, member: &Coefficients) -> Option<[[f64; 3]; 4]> {
    let Coefficients::BySigns(rule) = member else { return None };
    let u = rule.direction;
    let mut spanning = rule.basis.map(|index| query.generator(index));
    let slope = |v: &[f64; 3]| dot(v, &u).abs() / euclidean_norm(v);
    spanning.sort_by(|v, w| slope(v).total_cmp(&slope(w)));
    let [v, w, _] = spanning;
    let normal = cross(&v, &w);
    let tilt = CORNER_TILT * euclidean_norm(&u) / (query.len() as f64 * dot(&normal, &normal));
    // the products of v and w with the first and the second one are positive, the others 0
    let first = cross(&w, &normal).map(|c| c * tilt * euclidean_norm(&v));
    let second = cross(&normal, &v).map(|c| c * tilt * euclidean_norm(&w));
    let tilted = |a: f64, b: f64| [0, 1, 2].map(|k| u[k] + a * first[k] + b * second[k]);
    let directions = [tilted(1.0, 1.0), tilted(1.0, -1.0), tilted(-1.0, -1.0), tilted(-1.0, 1.0)];
    directions.as_flattened().iter().all(|c| c.is_finite()).then_some(directions)
}

/// A vector orthogonal to another one.
fn sideways(v: &[f64; 3]) -> [f64; 3] {
    let shortest = (0..3).fold(0, |least, k| if v[k].abs() < v[least].abs() { k } else { least });
    cross(v, &[0, 1, 2].map(|k| if k == shortest { 1.0 } else { 0.0 }))
}

/// The extreme point of the rows, block after block.
fn extreme_sum(rows: Rows<'_>, direction: &[f64; 3]) -> [f64; 3] {
    let sums = rows.chunks(BLOCK).map(|block| extreme_sum_of(&block.octets(), direction));
    sums.reduce(|a, b| [0, 1, 2].map(|k| a[k] + b[k])).unwrap_or_default()
}

/// A body around the origin and a point p, in doubles.
struct Body<'q> {
    parts: [Part<'q>; 2],
    /// The extents of the rows of each part.
    extents: [Extents<3>; 2],
    p: [f64; 3],
    /// M: at least the errors of a corner, of p, and of a product with the difference of both.
    margins: [f64; 3],
    /// At least the magnitudes of the coordinates of p and of a corner together.
    size: [f64; 3],
}

/// The roundings of a corner beside those of its pass, and of a product with the difference of it and p, in terms of
/// their size: 1 where the sums of both parts are added, 5 for the product. Where a part has a matrix, 3 for the image
/// of its sum, and 6 as signs are those of products with a direction that is pulled back with 3, each worth twice a
/// product.
const ROUNDINGS: f64 = 16.0;

impl<'q> Body<'q> {
    fn of(query: &'q dyn KernelQuery) -> Option<Self> {
        let parts = query.parts();
        if !parts.iter().filter_map(|part| part.frame).all(|frame| frame.is_moderate()) {
            return None;
        }
        let extents = parts.each_ref().map(|part| Extents::new(part.rows.list()).in_blocks_of(BLOCK));
        let displacement: BoundedVector = query.rounded_displacement();
        let (mut size, mut margins) = (displacement.map(|c| c.value.abs() + c.error), displacement.map(|c| c.error));
        for (part, extents) in parts.iter().zip(&extents) {
            let (own, error) = (part.image_of_sizes(&extents.sums()), part.image_of_sizes(&extents.point_error()));
            for k in 0..3 {
                size[k] += own[k];
                margins[k] += error[k];
            }
        }
        let margins = [0, 1, 2].map(|k| (margins[k] + ROUNDINGS * UNIT * size[k]) * LONG_SUM + PRODUCT_UNDERFLOW);
        let (p, size) = (displacement.map(|c| c.value), size.map(|c| c * LONG_SUM));
        MODERATE_SIZES.contains(&max_norm(&size)).then_some(Self { parts, extents, p, margins, size })
    }

    /// The extreme point in a direction, whose plane of support may be nearer than the best one. One pass.
    fn look(&self, u: [f64; 3], best: &mut Penetration<3>) -> [f64; 3] {
        let largest = max_norm(&u);
        let u = [u[0] / largest, u[1] / largest, u[2] / largest];
        let (mut vertex, mut missing) = ([0.0; 3], PRODUCT_UNDERFLOW);
        for (part, extents) in self.parts.iter().zip(&self.extents) {
            let direction = part.frame.map_or(u, |frame| frame.pulled(&u));
            let sum = extreme_sum(part.rows, &direction);
            missing += extents.error(&direction, dot(&direction, &sum));
            let image = part.image(&sum);
            vertex = [vertex[0] + image[0], vertex[1] + image[1], vertex[2] + image[2]];
        }
        let gap = dot(&u, &[vertex[0] - self.p[0], vertex[1] - self.p[1], vertex[2] - self.p[2]]);
        let value = gap + (self.margin(&u) + missing) * LONG_SUM;
        let upper = value / euclidean_norm(&u) * FIVE_ROUNDINGS;
        // false for NaN as well
        if upper < best.upper {
            (best.upper, best.direction) = (upper, u);
        }
        vertex
    }

    /// Σ |n_k| M_k.
    #[inline(always)]
    fn margin(&self, n: &[f64; 3]) -> f64 {
        n[0].abs() * self.margins[0] + n[1].abs() * self.margins[1] + n[2].abs() * self.margins[2]
    }
}

/// A face and the opposite one.
#[derive(Debug, Clone, Copy)]
struct Face {
    corners: [Corner; 3],
    normal: [f64; 3],
    /// A corner is beyond the face or the opposite one where its product with the normal exceeds this in magnitude, but
    /// for rounding.
    level: f64,
    /// The direction of the normal in which p is nearer to the plane.
    sign: f64,
    /// At most the distance of p from both faces; 0 where their determinants are in doubt, negative beyond them.
    distance: f64,
}

/// A surface around the origin whose corners come in opposite pairs.
struct Polytope<'b> {
    body: &'b Body<'b>,
    corners: Vec<[f64; 3]>,
    faces: Vec<Face>,
    /// Edges of what a new corner sees that only one face has so far.
    open: Vec<[Corner; 2]>,
}

impl<'b> Polytope<'b> {
    /// The octahedron of three points and the opposite ones; `None` of points that are nearly in a plane with the
    /// origin.
    fn octahedron(body: &'b Body<'b>, points: [[f64; 3]; 3]) -> Option<Self> {
        let mut polytope = Self {
            body,
            corners: Vec::with_capacity(64),
            faces: Vec::with_capacity(128),
            open: Vec::with_capacity(16),
        };
        let volume = dot(&points[2], &cross(&points[0], &points[1]));
        let [x, y, z] = points.map(|point| polytope.corner(point));
        let y = if volume < 0.0 { y ^ 1 } else { y };
        // the other four are opposite to these
        for (mirrored, turned) in [(0, 0), (1, 1), (2, 1), (3, 0)] {
            let (a, b) = (x ^ (mirrored & 1), y ^ (mirrored >> 1));
            polytope.add_face(if turned == 1 { [a, z, b] } else { [a, b, z] });
        }
        // false for NaN as well
        (volume.abs() > 0.0).then_some(polytope)
    }

    fn corner(&mut self, point: [f64; 3]) -> Corner {
        self.corners.push(point);
        2 * (self.corners.len() as Corner - 1)
    }

    #[inline(always)]
    fn point(&self, corner: Corner) -> [f64; 3] {
        let [x, y, z] = self.corners[corner as usize / 2];
        // no branch: which corners are opposite ones is not to be predicted
        let sign = 1.0 - 2.0 * f64::from(corner & 1);
        [sign * x, sign * y, sign * z]
    }

    /// The direction to the face that is nearest to p or has p farthest behind it, and a lower bound of its distance.
    fn nearest(&self) -> ([f64; 3], f64) {
        let mut nearest = &self.faces[0];
        for face in &self.faces {
            if face.distance < nearest.distance {
                nearest = face;
            }
        }
        (nearest.normal.map(|c| c * nearest.sign), nearest.distance)
    }

    #[inline]
    fn add_face(&mut self, corners: [Corner; 3]) {
        let [a, b, c] = [self.point(corners[0]), self.point(corners[1]), self.point(corners[2])];
        let body = self.body;
        let (first, second) = ([b[0] - a[0], b[1] - a[1], b[2] - a[2]], [c[0] - a[0], c[1] - a[1], c[2] - a[2]]);
        let normal = cross(&first, &second);
        let levels = [dot(&normal, &a), dot(&normal, &b), dot(&normal, &c)];
        let least = levels[0].min(levels[1]).min(levels[2]);
        let along = dot(&normal, &body.p);
        let margin = body.margin(&normal) + PRODUCT_UNDERFLOW;
        let above = least - along.abs() - margin;
        let length = euclidean_norm(&normal);
        let off = 16.0 * UNIT * max_norm(&first) * max_norm(&second) + PRODUCT_UNDERFLOW;
        let is_turned_outward = above > off * (body.size[0] + body.size[1] + body.size[2]) * LONG_SUM;
        let distance = if length < SHORTEST_LENGTH {
            // a face without an area is looked at first, and ends the search
            f64::NEG_INFINITY
        } else if is_turned_outward {
            above / (length * FIVE_ROUNDINGS)
        } else {
            (above / length).min(0.0)
        };
        let sign = if along < 0.0 { -1.0 } else { 1.0 };
        self.faces.push(Face { corners, normal, level: levels[0] + margin, sign, distance });
    }

    /// The faces that see the point or the opposite one from outside give way to triangles from their common boundary
    /// to it; `false` if none does, and if rounding tears the surface.
    ///
    /// A surface like a sphere with 2m corners has at most 4m − 4 faces, half of which are kept. Where the faces that
    /// see the point are scattered, there are more, and their number could double with each corner.
    fn add(&mut self, point: [f64; 3]) -> bool {
        self.open.clear();
        let mut place = 0;
        let mut is_seen = false;
        while let Some(face) = self.faces.get(place) {
            let along = dot(&face.normal, &point);
            if along.abs() <= face.level || along.is_nan() {
                place += 1;
                continue;
            }
            is_seen = true;
            let [a, b, c] = face.corners;
            let [a, b, c] = if along > 0.0 { [a, b, c] } else { [a ^ 1, c ^ 1, b ^ 1] };
            self.faces.swap_remove(place);
            for [from, to] in [[a, b], [b, c], [c, a]] {
                match self.open.iter().position(|edge| *edge == [to, from]) {
                    Some(twin) => drop(self.open.swap_remove(twin)),
                    None => self.open.push([from, to]),
                }
            }
        }
        if is_seen && self.faces.len() + self.open.len() > 2 * self.corners.len() {
            return false;
        }
        if is_seen {
            let apex = self.corner(point);
            for place in 0..self.open.len() {
                let [from, to] = self.open[place];
                self.add_face([from, to, apex]);
            }
        }
        is_seen
    }
}
