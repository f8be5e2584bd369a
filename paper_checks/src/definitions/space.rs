//! Zonotopes of R^3 from their definition, in exact rationals and without regard to speed.
//!
//! Like [`plane`](super::plane), this is the checks' own side of each comparison: membership is decided by the normals
//! of all pairs of generators, and faces are found by looking at every pair.

use std::collections::BTreeSet;
use std::fmt;

use dashu_ratio::RBig;

use crate::definitions::ratio::{exactly, integer};

/// A point or vector of space.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Vector(pub [RBig; 3]);

impl fmt::Display for Vector {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y, z] = &self.0;
        write!(f, "({x}, {y}, {z})")
    }
}

impl Vector {
    /// The vector with these integer coordinates.
    pub fn at(coordinates: [i64; 3]) -> Self {
        Vector(coordinates.map(integer))
    }

    /// The exact value of a vector of finite doubles.
    pub fn exactly(coordinates: [f64; 3]) -> Self {
        Vector(coordinates.map(exactly))
    }

    /// `self` plus `factor` times `vector`.
    pub fn plus(&self, factor: &RBig, vector: &Vector) -> Vector {
        Vector(std::array::from_fn(|i| &self.0[i] + factor * &vector.0[i]))
    }

    /// The vector from `self` to `other`.
    pub fn to(&self, other: &Vector) -> Vector {
        other.plus(&integer(-1), self)
    }

    /// The scalar product.
    pub fn dot(&self, other: &Vector) -> RBig {
        self.0.iter().zip(&other.0).fold(RBig::ZERO, |sum, (a, b)| sum + a * b)
    }

    /// The cross product.
    pub fn cross(&self, other: &Vector) -> Vector {
        let ([ax, ay, az], [bx, by, bz]) = (&self.0, &other.0);
        Vector([ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx])
    }

    /// Whether every coordinate is zero.
    pub fn is_zero(&self) -> bool {
        self.0.iter().all(|c| *c == RBig::ZERO)
    }

    /// The multiple whose first coordinate that is not zero is 1: the same for parallel vectors.
    pub fn line(&self) -> Vector {
        match self.0.iter().find(|c| **c != RBig::ZERO) {
            Some(first) => Vector(self.0.each_ref().map(|c| c / first)),
            None => self.clone(),
        }
    }

    fn negated(&self) -> Vector {
        Vector(self.0.each_ref().map(|c| -c))
    }
}

/// The zonotope { center + Σ δ_i generators_i : |δ_i| <= 1 }.
#[derive(Clone, Debug)]
pub struct Body {
    /// The centre.
    pub center: Vector,
    /// The half-segments.
    pub generators: Vec<Vector>,
}

/// A facet: its outer normal and its corners, counter-clockwise as seen from outside.
#[derive(Clone, Debug)]
pub struct Facet {
    /// An outer normal.
    pub normal: Vector,
    /// The generators that span it.
    pub spanning: Vec<usize>,
    /// The corners.
    pub corners: Vec<Vector>,
}

impl Body {
    /// A body about the origin.
    pub fn about_origin(generators: &[[i64; 3]]) -> Self {
        let generators = generators.iter().copied().map(Vector::at).collect();
        Body { center: Vector::at([0; 3]), generators }
    }

    /// Σ |direction · g_i|: half the width in a direction.
    pub fn reach(&self, direction: &Vector) -> RBig {
        self.generators.iter().fold(RBig::ZERO, |sum, generator| {
            let along = direction.dot(generator);
            if along < RBig::ZERO { sum - along } else { sum + along }
        })
    }

    /// The support function: max { direction · x } over the body.
    pub fn support(&self, direction: &Vector) -> RBig {
        direction.dot(&self.center) + self.reach(direction)
    }

    /// A normal for each plane spanned by two of the generators, both signs.
    pub fn normals(&self) -> BTreeSet<Vector> {
        both_signs(crossings(&self.generators))
    }

    /// Whether a point lies in the body: no normal of two generators or coordinate axes separates it.
    ///
    /// The axes decide for flat bodies: the body is the limit of its sums with smaller and smaller cubes, whose facets
    /// have such normals.
    pub fn holds(&self, point: &Vector) -> bool {
        let offset = self.center.to(point);
        self.deciding_normals().iter().all(|normal| normal.dot(&offset) <= self.reach(normal))
    }

    /// Whether a point lies in the interior of the body.
    pub fn holds_inside(&self, point: &Vector) -> bool {
        let offset = self.center.to(point);
        self.deciding_normals().iter().all(|normal| normal.dot(&offset) < self.reach(normal))
    }

    /// The first of other bodies that sticks out of this one.
    pub(crate) fn first_outside<'a>(&self, others: &'a [Body]) -> Option<&'a Body> {
        let normals = self.deciding_normals();
        others.iter().find(|other| normals.iter().any(|normal| other.support(normal) > self.support(normal)))
    }

    fn deciding_normals(&self) -> BTreeSet<Vector> {
        let mut spanning = self.generators.clone();
        spanning.extend([[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(Vector::at));
        both_signs(crossings(&spanning))
    }

    /// The facets of a body of full dimension.
    pub fn facets(&self) -> Vec<Facet> {
        self.normals().into_iter().map(|normal| self.facet(normal)).collect()
    }

    /// The face on which the body reaches farthest along a normal of two generators.
    fn facet(&self, normal: Vector) -> Facet {
        let mut middle = self.center.clone();
        let mut spanning = Vec::new();
        for (index, generator) in self.generators.iter().enumerate() {
            let along = normal.dot(generator);
            if along == RBig::ZERO {
                spanning.extend((!generator.is_zero()).then_some(index));
            } else {
                middle = middle.plus(&integer(if along < RBig::ZERO { -1 } else { 1 }), generator);
            }
        }
        let corners = zonogon(&middle, spanning.iter().map(|&index| &self.generators[index]), &normal);
        Facet { normal, spanning, corners }
    }

    /// The vertices of a body of full dimension.
    pub fn vertices(&self) -> BTreeSet<Vector> {
        self.facets().into_iter().flat_map(|facet| facet.corners).collect()
    }
}

/// The corners of a zonogon in the plane with this normal, counter-clockwise around it.
fn zonogon<'a>(middle: &Vector, generators: impl Iterator<Item = &'a Vector>, normal: &Vector) -> Vec<Vector> {
    let turn = |a: &Vector, b: &Vector| normal.dot(&a.cross(b));
    let mut steps: Vec<Vector> = Vec::new();
    for generator in generators {
        let reference = steps.first().cloned().unwrap_or_else(|| generator.clone());
        let side = turn(&reference, generator);
        let backwards = side < RBig::ZERO || (side == RBig::ZERO && reference.dot(generator) < RBig::ZERO);
        let step = if backwards { generator.negated() } else { generator.clone() };
        match steps.iter_mut().find(|other| turn(other, &step) == RBig::ZERO) {
            Some(parallel) => *parallel = parallel.plus(&integer(1), &step),
            None => steps.push(step),
        }
    }
    steps.sort_by(|a, b| RBig::ZERO.cmp(&turn(a, b)));
    let mut corner = steps.iter().fold(middle.clone(), |corner, step| corner.plus(&integer(-1), step));
    let mut corners = Vec::new();
    for sign in [2, -2] {
        for step in &steps {
            corners.push(corner.clone());
            corner = corner.plus(&integer(sign), step);
        }
    }
    corners
}

fn crossings(vectors: &[Vector]) -> BTreeSet<Vector> {
    let pairs = (0..vectors.len()).flat_map(|j| (0..j).map(move |i| (i, j)));
    pairs
        .map(|(i, j)| vectors[i].cross(&vectors[j]))
        .filter(|cross| !cross.is_zero())
        .map(|cross| cross.line())
        .collect()
}

fn both_signs(lines: BTreeSet<Vector>) -> BTreeSet<Vector> {
    lines.into_iter().flat_map(|line| [line.negated(), line]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_truncated_octahedron_has_squares_and_hexagons() {
        let body = Body::about_origin(&[[1, 1, 0], [1, -1, 0], [1, 0, 1], [1, 0, -1], [0, 1, 1], [0, 1, -1]]);
        let mut sides: Vec<usize> = body.facets().iter().map(|facet| facet.corners.len()).collect();
        sides.sort_unstable();
        assert_eq!(sides, [vec![4; 6], vec![6; 8]].concat());
        assert_eq!(body.vertices().len(), 24);
    }

    #[test]
    fn a_flat_body_has_no_inside() {
        let square = Body::about_origin(&[[1, 0, 0], [0, 1, 0]]);
        assert!(square.holds(&Vector::at([1, -1, 0])) && !square.holds_inside(&Vector::at([0, 0, 0])));
        assert!(!square.holds(&Vector(["0", "0", "1/1000000"].map(|c| c.parse().expect("a fraction")))));
        assert!(!square.holds(&Vector::at([2, 0, 0])));
        let point = Body::about_origin(&[]);
        assert!(point.holds(&Vector::at([0, 0, 0])) && !point.holds(&Vector::at([0, 0, 1])));
    }
}
