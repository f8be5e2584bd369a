//! All faces of a zonotope, by composing sign vectors in rationals: the truth that faster methods are held to.
//!
//! # Statement
//! Input: generators in R^D. Output: every nonempty face as a sign vector, sorted by dimension: for each generator the
//! coefficient 1, −1 or, where the face extends along the generator, none. The last is the body itself. Zero generators
//! have no coefficient in any face.
//!
//! # Source
//! Section 3: the faces are those of an arrangement of hyperplanes. The sign vectors (sign(u · v_i))_i of all u are the
//! covectors of an oriented matroid, which the cocircuits generate by composition (Björner and others, Oriented
//! Matroids, 1999, Proposition 3.7.2).
//!
//! # Method
//! 1. Choose r coordinates, r the rank, in which the generators have the same linear dependences.
//! 2. For each r − 1 generators that are independent, take the vector u orthogonal to them and the sign vectors of u
//!    and −u: the facets.
//! 3. Compose: X ∘ C has the signs of X and, where X has none, those of C. Repeat with every facet C until nothing new
//!    appears.
//! 4. The dimension of a face is the rank of the generators without a coefficient.
//!
//! # Complexity
//! n generators, f faces: O(C(n, r − 1) f n) time and O(f n) space; for small n.
//!
//! # Shapes
//! `generators`: n × D, in any order, zero, parallel and dependent ones allowed.
//!
//! # Numerics
//! Exact rationals throughout.
//!
//! # Panics
//! If a coordinate is not finite.
//!
//! # Checked by
//! The counts of named bodies, Euler's relation, and Zaslavsky's count of the vertices from ranks of subsets (tests of
//! this folder).
//!
//! # Example
//! ```
//! use zonotope::zonotope::faces::brute_force::faces_by_dimension;
//!
//! let cube = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
//! let counts: Vec<usize> = faces_by_dimension(&cube).iter().map(|faces| faces.len()).collect();
//! assert_eq!(counts, [8, 12, 6, 1]);
//! ```

use std::cmp::Ordering;
use std::collections::BTreeSet;

use super::SignVector;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{Span, hyperplane_normal, sum_of_products};
use crate::numeric::subsets::for_each_subset;

/// All nonempty faces, by dimension.
pub fn faces_by_dimension<const D: usize>(generators: &[[f64; D]]) -> Vec<BTreeSet<SignVector>> {
    let span = Span::of_doubles(generators);
    let vectors: Vec<Vec<Dyadic>> = generators.iter().map(|g| span.project(&g.map(Dyadic::from_f64))).collect();
    let facets = facets(&vectors, span.rank());
    let mut faces = BTreeSet::from([vec![Ordering::Equal; vectors.len()]]);
    let mut fresh: Vec<SignVector> = faces.iter().cloned().collect();
    while let Some(face) = fresh.pop() {
        for facet in &facets {
            let composed: SignVector = face.iter().zip(facet).map(|(x, c)| x.then(*c)).collect();
            if faces.insert(composed.clone()) {
                fresh.push(composed);
            }
        }
    }
    let mut by_dimension = vec![BTreeSet::new(); span.rank() + 1];
    for face in faces {
        let along = vectors.iter().zip(&face).filter(|(_, sign)| sign.is_eq()).map(|(v, _)| v.clone());
        by_dimension[Span::of(along, span.rank()).rank()].insert(face);
    }
    by_dimension
}

/// The sign vectors of the facets of vectors that span R^`rank`; none for rank 0.
fn facets(vectors: &[Vec<Dyadic>], rank: usize) -> BTreeSet<SignVector> {
    let mut facets = BTreeSet::new();
    if rank == 0 {
        return facets;
    }
    for_each_subset(vectors.len(), rank - 1, |chosen| {
        let normal = hyperplane_normal(&chosen.iter().map(|&i| &vectors[i]).collect::<Vec<_>>());
        if normal.iter().any(|c| !c.is_zero()) {
            let signs: SignVector = vectors.iter().map(|v| sum_of_products(v, &normal).sign()).collect();
            facets.insert(signs.iter().map(|sign| sign.reverse()).collect());
            facets.insert(signs);
        }
    });
    facets
}
