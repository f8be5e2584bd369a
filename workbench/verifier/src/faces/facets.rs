//! All facets of a small zonotope with an interior: their normals and how far the body reaches along them.

use dashu_int::IBig;
use dashu_int::ops::Abs;

use crate::exact::linear::{Echelon, Vector, dot};
use crate::exact::proportion::Proportion;
use crate::exact::subsets::{count_subsets, subsets};
use crate::exact::turns::edges;

/// So many products of facets and generators are tried where the certificate does not name the facet.
const MOST_TRIALS: u64 = 3_000_000;

/// The normals of all facets of a body with an interior, one for each pair of opposite facets.
pub(crate) struct Facets {
    /// Each normal u with Σ |u · g_i|.
    normals: Vec<(Vector, IBig)>,
}

impl Facets {
    /// All facets, unless they are too many.
    pub(crate) fn of(dimension: usize, generators: &[Vector]) -> Option<Self> {
        if dimension == 2 {
            return Some(Self { normals: edges(generators.to_vec()) });
        }
        if count_subsets(generators.len(), dimension - 1).saturating_mul(generators.len() as u64) > MOST_TRIALS {
            return None;
        }
        let normals = subsets(generators.len(), dimension - 1).filter_map(|facet| {
            let span = Echelon::spanned(dimension, facet.iter().map(|&index| &generators[index]));
            let [u] = <[Vector; 1]>::try_from(span.complement(dimension)).ok()?;
            let reach = reach(generators, &u);
            Some((u, reach))
        });
        Some(Self { normals: normals.collect() })
    }

    /// How many normals there are.
    pub(crate) fn count(&self) -> usize {
        self.normals.len()
    }

    /// Each normal u with Σ |u · g_i|.
    pub(crate) fn normals(&self) -> &[(Vector, IBig)] {
        &self.normals
    }

    /// The largest of |u · p| / Σ |u · g_i|.
    pub(crate) fn gauge(&self, p: &Vector) -> Proportion {
        let mut largest = (IBig::ZERO, IBig::ONE);
        for (u, reach) in &self.normals {
            let along = dot(u, p).abs();
            if &along * &largest.1 > &largest.0 * reach {
                largest = (along, reach.clone());
            }
        }
        Proportion::new(largest.0, largest.1, 0)
    }
}

/// The support function Σ |u · g_i|.
pub(crate) fn reach(generators: &[Vector], u: &[IBig]) -> IBig {
    generators.iter().map(|generator| dot(u, generator).abs()).sum()
}
