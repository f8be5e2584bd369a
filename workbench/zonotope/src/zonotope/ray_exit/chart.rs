//! One facet of the zonotopes along some directions: what spans it, on which side the other directions are, and what
//! lies beyond its edges.

use crate::numeric::linear::{dot, inverse};

/// The place of a chart that does not exist.
pub(crate) const NOWHERE: u32 = u32::MAX;

/// A vector shorter than this, beside directions of ordinary size, is none.
const NEGLIGIBLE_LENGTH: f64 = 1e-12;

/// A facet; the first `rank` − 1 entries of its basis count.
pub(crate) struct Chart<const D: usize> {
    pub(crate) basis: [usize; D],
    /// Of length 1.
    pub(crate) normal: [f64; D],
    /// For each direction the side of the facet's plane on which it is; zero for the basis.
    signs: Vec<i8>,
    /// The charts beyond the edges on which a direction of the basis counts fully, forward and backward.
    pub(crate) next: [[u32; 2]; D],
    /// The coefficients for which the rest is up to date.
    edition: u32,
    /// Inverse to the matrix with the basis and `sum` for columns.
    pub(crate) rows: [[f64; D]; D],
    /// Σ s_j c_j v_j.
    pub(crate) sum: [f64; D],
}

impl<const D: usize> Chart<D> {
    /// The facet with a basis, on the side where the others have the signs of their coefficients; `None` where these
    /// hardly span.
    pub(crate) fn at(rank: usize, directions: &[[f64; D]], basis: [usize; D], coefficients: &[f64]) -> Option<Self> {
        let mut signs: Vec<i8> = coefficients.iter().map(|&c| if c < 0.0 { -1 } else { 1 }).collect();
        basis[..rank - 1].iter().for_each(|&b| signs[b] = 0);
        Self::with_signs(rank, directions, basis, signs)
    }

    fn with_signs(rank: usize, directions: &[[f64; D]], basis: [usize; D], mut signs: Vec<i8>) -> Option<Self> {
        let unit = vec![1.0; directions.len()];
        let rows = rows_of(rank, directions, &basis, &signed_sum(directions, &signs, &unit))?;
        let normal = rows[rank - 1];
        let length = dot(&normal, &normal).sqrt();
        let normal = normal.map(|c| c / length);
        // Those in the plane of the facet may have either sign; of the others the plane tells.
        for (sign, direction) in signs.iter_mut().zip(directions).filter(|(sign, _)| **sign != 0) {
            let height = dot(&normal, direction);
            if height.abs() > NEGLIGIBLE_LENGTH {
                *sign = if height < 0.0 { -1 } else { 1 };
            }
        }
        let next = [[NOWHERE; 2]; D];
        Some(Self { basis, normal, signs, next, edition: 0, rows: [[0.0; D]; D], sum: [0.0; D] })
    }

    /// Brings `rows` and `sum` up to date; where the zonotope is flat there are none, and no ray is found to meet the
    /// facet.
    pub(crate) fn refresh(&mut self, rank: usize, directions: &[[f64; D]], coefficients: &[f64], edition: u32) {
        if self.edition != edition {
            self.edition = edition;
            self.sum = signed_sum(directions, &self.signs, coefficients);
            self.rows = rows_of(rank, directions, &self.basis, &self.sum).unwrap_or([[0.0; D]; D]);
        }
    }

    /// The facet beyond an edge: the plane turns about the edge until it meets another direction.
    pub(crate) fn beyond(&self, rank: usize, directions: &[[f64; D]], leaving: usize, side: usize) -> Option<Self> {
        let unit = vec![1.0; directions.len()];
        let rows = rows_of(rank, directions, &self.basis, &signed_sum(directions, &self.signs, &unit))?;
        let sign: i8 = if side == 0 { 1 } else { -1 };
        // In the plane of the two normals, at an angle from the first one that grows with `turns`.
        let mut first: Option<((bool, f64), usize)> = None;
        for (j, (direction, &s)) in directions.iter().zip(&self.signs).enumerate().filter(|(_, (_, s))| **s != 0) {
            let height = f64::from(s) * dot(&self.normal, direction);
            let rate = f64::from(s * sign) * dot(&rows[leaving], direction);
            if height.abs() + rate.abs() <= NEGLIGIBLE_LENGTH {
                continue;
            }
            let turns = (rate >= 0.0, -height.max(0.0) / rate);
            if first.is_none_or(|(least, _)| turns < least) {
                first = Some((turns, j));
            }
        }
        let (_, entering) = first?;
        let (mut basis, mut signs) = (self.basis, self.signs.clone());
        signs[basis[leaving]] = sign;
        signs[entering] = 0;
        basis[leaving] = entering;
        Self::with_signs(rank, directions, basis, signs)
    }
}

fn signed_sum<const D: usize>(directions: &[[f64; D]], signs: &[i8], coefficients: &[f64]) -> [f64; D] {
    let terms = directions.iter().zip(signs).zip(coefficients);
    terms.fold([0.0; D], |sum, ((v, &s), c)| {
        let signed = f64::from(s) * c;
        std::array::from_fn(|i| sum[i] + signed * v[i])
    })
}

fn rows_of<const D: usize>(
    rank: usize,
    directions: &[[f64; D]],
    basis: &[usize; D],
    sum: &[f64; D],
) -> Option<[[f64; D]; D]> {
    let mut matrix = [[0.0; D]; D];
    for c in 0..rank {
        for i in 0..rank {
            matrix[c][i] = if i + 1 < rank { directions[basis[i]][c] } else { sum[c] };
        }
    }
    inverse(rank, &matrix)
}
