//! Vertices and facets in any dimension, by recursion on facets: a facet is a zonotope of the generators along it.
//!
//! # Statement
//! Input: a zonotope in R^D. Output: its facets and its vertices, as sign vectors (the coefficient of each generator,
//! 1, −1 or, along a facet, none), each once, in lexicographic order; both within the affine hull. A point has one
//! vertex and no facet.
//!
//! # Source
//! Section 3: facets are defined by (d − 1)-tuples of generators. The paper assumes general position; here every tuple
//! along one facet names the same set of generators, and facets are told apart by these sets.
//!
//! # Method
//! 1. Merge parallel generators; choose r coordinates, r the rank, in which the generators have the same dependences:
//!    their doubles are used as they stand.
//! 2. For each r − 1 generators: their cross product u, from minors. If it is not zero, the generators orthogonal to u
//!    lie along two opposite facets, on which the others have the signs of u · v and the opposite ones.
//! 3. The vertices of a facet are those of the zonotope of the generators along it, which leaving out a coordinate
//!    where u is not zero maps one to one into R^(r − 1). Independent generators have all signs.
//!
//! # Complexity
//! n directions, rank r: O(n^r) exact operations, as there are n^(r − 1) tuples and each normal meets n generators; in
//! general position that is O(n) a facet. Space O(n) a vertex and a facet. Facets with k generators along them cost as
//! much as their own vertices.
//!
//! # Shapes
//! The body's generators: n × D, in any order, zero, parallel and dependent ones allowed.
//!
//! # Numerics
//! Exact: minors and dot products of doubles as dyadic numbers.
//!
//! # Checked by
//! `brute_force.rs` in dimensions 1 to 5, and the face lattice in space.
//!
//! # Example
//! ```
//! use zonotope::{Zonotope, zonotope::faces::by_recursion::vertices_and_facets};
//!
//! let axes = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];
//! let tesseract = Zonotope::new([0.0; 4], axes.to_vec())?;
//! let faces = vertices_and_facets(&tesseract);
//! assert_eq!((faces.vertices.len(), faces.edge_count(), faces.facets.len()), (16, 32, 8));
//! assert!(faces.facet_sizes.iter().all(|&size| size == 8));
//! # Ok::<(), zonotope::ZonotopeError>(())
//! ```

use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};

use super::SignVector;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{Span, determinant, exact, hyperplane_normal, sum_of_products};
use crate::numeric::subsets::for_each_subset;
use crate::zonotope::directions::Directions;
use crate::zonotope::implicit::Zonotope;

type Vector = Vec<Dyadic>;

/// The vertices and the facets of a zonotope within its affine hull.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct VerticesAndFacets {
    /// The dimension of the affine hull.
    pub dimension: usize,
    /// The coefficients of each vertex.
    pub vertices: Vec<SignVector>,
    /// The coefficients of each facet; none along it.
    pub facets: Vec<SignVector>,
    /// How many vertices each facet has.
    pub facet_sizes: Vec<usize>,
    /// For each class of parallel generators, these.
    classes: Vec<Vec<usize>>,
}

/// The vertices and the facets of a zonotope.
pub fn vertices_and_facets<const D: usize>(body: &Zonotope<D>) -> VerticesAndFacets {
    let directions = Directions::of_finite(body.generators());
    let coordinates = Span::of_doubles(directions.representatives()).independent_coordinates();
    let chosen = |v: &[f64; D]| coordinates.iter().map(|&c| Dyadic::from_f64(v[c])).collect();
    let vectors: Vec<Vector> = directions.representatives().iter().map(chosen).collect();
    let mut vertices = BTreeSet::new();
    let mut facets = BTreeMap::new();
    for facet in facet_pairs(&vectors, coordinates.len()) {
        let corners = facet.vertices(&vectors);
        for signs in [facet.signs.clone(), opposite(&facet.signs)] {
            facets.insert(signs, corners.len());
        }
        vertices.extend(corners.iter().map(opposite));
        vertices.extend(corners);
    }
    if vectors.is_empty() {
        vertices.insert(Vec::new());
    }
    let of_generators = |signs: &SignVector| {
        let mut result = vec![Ordering::Equal; body.generators().len()];
        for (class, &sign) in signs.iter().enumerate() {
            for member in directions.members(class) {
                result[member.generator] = if member.reversed { sign.reverse() } else { sign };
            }
        }
        result
    };
    let mut sized: Vec<(SignVector, usize)> =
        facets.iter().map(|(signs, &size)| (of_generators(signs), size)).collect();
    sized.sort();
    let mut vertices: Vec<SignVector> = vertices.iter().map(of_generators).collect();
    vertices.sort();
    let members = |class| directions.members(class).iter().map(|member| member.generator).collect();
    VerticesAndFacets {
        dimension: coordinates.len(),
        vertices,
        facet_sizes: sized.iter().map(|&(_, size)| size).collect(),
        facets: sized.into_iter().map(|(signs, _)| signs).collect(),
        classes: (0..directions.len()).map(members).collect(),
    }
}

impl VerticesAndFacets {
    /// How many edges there are: pairs of vertices that differ in one class of parallel generators. O(n² v log v) for v
    /// vertices.
    pub fn edge_count(&self) -> usize {
        let upper_end = |vertex: &SignVector, class: &Vec<usize>| {
            let first = class[0];
            let mut other = vertex.clone();
            class.iter().for_each(|&generator| other[generator] = other[generator].reverse());
            vertex[first].is_lt() && self.vertices.binary_search(&other).is_ok()
        };
        let edges = |vertex| self.classes.iter().filter(|class| upper_end(vertex, class)).count();
        self.vertices.iter().map(edges).sum()
    }
}

/// A facet and, by the opposite signs, the facet across the centre.
struct FacetPair {
    along: Vec<usize>,
    signs: SignVector,
    /// A coordinate in which the normal is not zero.
    axis: usize,
}

impl FacetPair {
    fn vertices(&self, vectors: &[Vector]) -> Vec<SignVector> {
        let without_axis = |&i: &usize| {
            let rest = vectors[i].iter().enumerate().filter(|&(k, _)| k != self.axis);
            rest.map(|(_, c)| c.clone()).collect()
        };
        let within: Vec<Vector> = self.along.iter().map(without_axis).collect();
        let combine = |corner: SignVector| {
            let mut signs = self.signs.clone();
            for (&i, sign) in self.along.iter().zip(corner) {
                signs[i] = sign;
            }
            signs
        };
        vertices(&within, vectors[0].len() - 1).into_iter().map(combine).collect()
    }
}

/// The vertices of the zonotope of pairwise non-parallel vectors, by their coefficients. O(n^r).
pub(crate) fn vertices_of<const D: usize>(vectors: &[[Dyadic; D]]) -> BTreeSet<SignVector> {
    let coordinates = Span::of(vectors.iter().cloned(), D).independent_coordinates();
    let chosen = |v: &[Dyadic; D]| coordinates.iter().map(|&c| v[c].clone()).collect();
    vertices(&vectors.iter().map(chosen).collect::<Vec<Vector>>(), coordinates.len())
}

/// The vertices of the zonotope of pairwise non-parallel vectors that span R^`rank`.
fn vertices(vectors: &[Vector], rank: usize) -> BTreeSet<SignVector> {
    if vectors.len() == rank {
        let sign = |choice: usize, k: usize| if choice >> k & 1 == 1 { Ordering::Greater } else { Ordering::Less };
        return (0..1 << rank).map(|choice| (0..rank).map(|k| sign(choice, k)).collect()).collect();
    }
    let facets = facet_pairs(vectors, rank);
    let half: Vec<SignVector> = facets.iter().flat_map(|facet| facet.vertices(vectors)).collect();
    half.iter().map(opposite).chain(half.iter().cloned()).collect()
}

/// One of each pair of opposite facets.
fn facet_pairs(vectors: &[Vector], rank: usize) -> Vec<FacetPair> {
    let mut seen = BTreeSet::new();
    let mut facets = Vec::new();
    if rank == 0 {
        return facets;
    }
    for_each_subset(vectors.len(), rank - 1, |tuple| {
        let normal = hyperplane_normal(&tuple.iter().map(|&i| &vectors[i]).collect::<Vec<_>>());
        let Some(axis) = normal.iter().position(|c| !c.is_zero()) else { return };
        let signs: SignVector = vectors.iter().map(|v| sum_of_products(v, &normal).sign()).collect();
        let along: Vec<usize> = (0..vectors.len()).filter(|&i| signs[i].is_eq()).collect();
        if seen.insert(along.clone()) {
            facets.push(FacetPair { along, signs, axis });
        }
    });
    facets
}

fn opposite(signs: &SignVector) -> SignVector {
    signs.iter().map(|sign| sign.reverse()).collect()
}

/// The volume in R^D, exactly: 2^D Σ |det| over D-tuples of generators, n^D of them.
pub fn total_volume<const D: usize>(body: &Zonotope<D>) -> Dyadic {
    let vectors: Vec<[Dyadic; D]> = body.generators().iter().map(|&g| exact(g)).collect();
    let mut sum = Dyadic::zero();
    for_each_subset(vectors.len(), D, |tuple| {
        let rows: Vec<&[Dyadic; D]> = tuple.iter().map(|&i| &vectors[i]).collect();
        sum = &sum + &determinant::<Dyadic, _>(&rows).abs();
    });
    sum.scaled(D as i64)
}
