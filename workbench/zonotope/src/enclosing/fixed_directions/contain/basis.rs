//! Bases of directions with long generators, and the exact inverses of their matrices.

use crate::enclosing::fixed_directions::problem::FixedDirections;
use crate::enclosing::fixed_directions::scaled::Scaled;
use crate::numeric::Rational;
use crate::numeric::exact_linear::{Span, inverse, rational};
use crate::numeric::linear::dot;

/// The indices of at most `rank` vectors that are independent but for rounding: each is the one farthest from the span
/// of those before.
pub(super) fn independent<const D: usize>(rank: usize, vectors: &[[f64; D]]) -> Vec<usize> {
    let mut rest = vectors.to_vec();
    let mut chosen = Vec::with_capacity(rank);
    for _ in 0..rank {
        let Some(best) = (0..rest.len()).max_by(|&a, &b| dot(&rest[a], &rest[a]).total_cmp(&dot(&rest[b], &rest[b])))
        else {
            break;
        };
        let length = dot(&rest[best], &rest[best]).sqrt();
        if length.is_nan() || length <= 0.0 {
            break;
        }
        let unit = rest[best].map(|c| c / length);
        for v in &mut rest {
            let along = dot(v, &unit);
            *v = std::array::from_fn(|c| v[c] - along * unit[c]);
        }
        rest[best] = [0.0; D];
        chosen.push(best);
    }
    chosen
}

/// By how much the generators are lengthened along their directions when a basis is chosen, relative to the longest: so
/// a short generator with a direction of its own is preferred to a long one in nearly the span of others.
const USED_LENGTH: f64 = 1e-3;

/// The same for directions without a generator: they are chosen only where the others nearly lie in a subspace, as a
/// coefficient that makes up for rounding would be a generator as short as rounding there.
const UNUSED_LENGTH: f64 = 1e-6;

/// A basis of directions, preferably with long generators, proven independent by exact elimination. If those that
/// floating point chooses are dependent, exact elimination chooses the first independent ones.
pub(in crate::enclosing::fixed_directions) fn long_basis<const D: usize>(
    problem: &FixedDirections<'_, D>,
    scaled: &Scaled<D>,
    generators: &[[f64; D]],
) -> Vec<usize> {
    let longest = generators.iter().map(|g| dot(g, g)).fold(0.0, f64::max).sqrt().max(f64::MIN_POSITIVE);
    let lengthened: Vec<[f64; D]> = generators
        .iter()
        .zip(&scaled.directions)
        .map(|(g, d)| {
            let is_used = g.iter().any(|c| *c != 0.0);
            let more = if is_used { USED_LENGTH } else { UNUSED_LENGTH };
            std::array::from_fn(|c| g[c] / longest + more * d.vector[c])
        })
        .collect();
    let basis = independent(scaled.rank, &lengthened);
    let exactly = |basis: &[usize]| {
        let vectors: Vec<[f64; D]> = basis.iter().map(|&b| problem.directions()[scaled.directions[b].index]).collect();
        Span::of_doubles(&vectors).rank()
    };
    if basis.len() == scaled.rank && exactly(&basis) == scaled.rank {
        return basis;
    }
    let mut basis = Vec::with_capacity(scaled.rank);
    for candidate in 0..scaled.directions.len() {
        basis.push(candidate);
        if exactly(&basis) < basis.len() {
            basis.pop();
        }
    }
    basis
}

/// The rows of the inverse of the matrix whose columns are the vectors of the basis, in coordinates of the input,
/// exactly.
pub(in crate::enclosing::fixed_directions) fn exact_inverse<const D: usize>(
    problem: &FixedDirections<'_, D>,
    scaled: &Scaled<D>,
    basis: &[usize],
) -> Vec<Vec<Rational>> {
    let row =
        |&c: &usize| basis.iter().map(|&b| rational(problem.directions()[scaled.directions[b].index][c])).collect();
    inverse(scaled.coordinates.iter().map(row).collect()).expect("a basis has an inverse")
}
