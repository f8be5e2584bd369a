//! All faces of a zonotope, by composing sign vectors in rationals: the truth that faster methods are held to.
//!
//! # Statement
//! Input: generators in R^D. Output: every nonempty face as a sign vector, sorted by dimension: for each generator the coefficient 1, −1 or,
//! where the face extends along the generator, none. The last is the body itself. Zero generators have no coefficient in any face.
//!
//! # Source
//! Section 3: the faces are those of an arrangement of hyperplanes. The sign vectors (sign(u · v_i))_i of all u are the covectors of an oriented matroid,
//! which the cocircuits generate by composition (Björner and others, Oriented Matroids, 1999, Proposition 3.7.2).
//!
//! # Method
//! 1. Choose r coordinates, r the rank, in which the generators have the same linear dependences.
//! 2. For each r − 1 generators that are independent, take the vector u orthogonal to them and the sign vectors of u and −u: the facets.
//! 3. Compose: X ∘ C has the signs of X and, where X has none, those of C. Repeat with every facet C until nothing new appears.
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
//! # Errors
//! None.
//!
//! # Panics
//! If a coordinate is not finite.
//!
//! # Checked by
//! The counts of named bodies, Euler's relation, and Zaslavsky's count of the vertices from ranks of subsets (tests of this folder).
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

use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;

/// The coefficients of a face: 1 (`Greater`), −1 (`Less`), none (`Equal`).
pub type SignVector = Vec<Ordering>;

/// All nonempty faces, by dimension.
pub fn faces_by_dimension<const D: usize>(generators: &[[f64; D]]) -> Vec<BTreeSet<SignVector>> {
    let exact: Vec<Vec<Rational>> =
        generators.iter().map(|g| g.iter().map(|&c| Dyadic::from_f64(c).to_rational()).collect()).collect();
    let coordinates = pivots(exact.clone());
    let vectors: Vec<Vec<Rational>> =
        exact.iter().map(|v| coordinates.iter().map(|&c| v[c].clone()).collect()).collect();
    let facets = facets(&vectors, coordinates.len());
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
    let mut by_dimension = vec![BTreeSet::new(); coordinates.len() + 1];
    for face in faces {
        let along = vectors.iter().zip(&face).filter(|(_, sign)| sign.is_eq()).map(|(v, _)| v.clone()).collect();
        by_dimension[pivots(along).len()].insert(face);
    }
    by_dimension
}

/// The sign vectors of the facets of vectors that span R^`rank`; none for rank 0.
fn facets(vectors: &[Vec<Rational>], rank: usize) -> BTreeSet<SignVector> {
    let mut facets = BTreeSet::new();
    if rank == 0 {
        return facets;
    }
    let mut chosen: Vec<usize> = (0..rank - 1).collect();
    loop {
        if let Some(normal) = normal(chosen.iter().map(|&i| vectors[i].clone()).collect(), rank) {
            let dot = |v: &Vec<Rational>| v.iter().zip(&normal).fold(Rational::ZERO, |sum, (a, b)| sum + a * b);
            let signs: SignVector = vectors.iter().map(|v| dot(v).cmp(&Rational::ZERO)).collect();
            facets.insert(signs.iter().map(|sign| sign.reverse()).collect());
            facets.insert(signs);
        }
        let Some(at) = (0..rank - 1).rev().find(|&at| chosen[at] + rank - 1 < vectors.len() + at) else {
            return facets;
        };
        chosen[at] += 1;
        for later in at + 1..rank - 1 {
            chosen[later] = chosen[later - 1] + 1;
        }
    }
}

/// A vector orthogonal to `dimension` − 1 independent ones; `None` if they are dependent.
fn normal(mut rows: Vec<Vec<Rational>>, dimension: usize) -> Option<Vec<Rational>> {
    let columns = eliminate(&mut rows);
    if columns.len() + 1 < dimension {
        return None;
    }
    let free = (0..dimension).find(|c| !columns.contains(c)).expect("one column has no pivot");
    let mut normal = vec![Rational::ZERO; dimension];
    normal[free] = Rational::ONE;
    for (row, &column) in rows.iter().zip(&columns) {
        normal[column] = -&row[free] / &row[column];
    }
    Some(normal)
}

/// Columns in which the rows have full rank.
fn pivots(mut rows: Vec<Vec<Rational>>) -> Vec<usize> {
    eliminate(&mut rows)
}

/// Gauss–Jordan elimination: afterwards each of the first rows alone has an entry in its column of those returned.
fn eliminate(rows: &mut [Vec<Rational>]) -> Vec<usize> {
    let mut columns = Vec::new();
    for column in 0..rows.first().map_or(0, Vec::len) {
        let done = columns.len();
        let Some(pivot) = (done..rows.len()).find(|&row| !rows[row][column].is_zero()) else { continue };
        rows.swap(done, pivot);
        let source = rows[done].clone();
        for (index, row) in rows.iter_mut().enumerate() {
            if index != done && !row[column].is_zero() {
                let factor = &row[column] / &source[column];
                for (entry, from) in row.iter_mut().zip(&source) {
                    *entry -= &factor * from;
                }
            }
        }
        columns.push(column);
    }
    columns
}
