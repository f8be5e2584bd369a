//! The penetration depth, from the normals of all sets of generators: the truth, in exact rationals.
//!
//! # Statement
//! Input: a displacement p and generators g_i in R^D, any D ≥ 1. Output: the square of the distance of p from the
//! boundary of Z = { Σ δ_i g_i : |δ_i| ≤ 1 }, exactly, for a p inside of Z.
//!
//! # Source
//! None; the definition of the depth.
//!
//! # Method
//! 1. A point q of Z is on the boundary if no neighbourhood of q lies in Z. So the square of the depth is the least
//!    one of a translation t for which p + t is not inside: for which a direction u has u · (p + t) ≥ Σ |u · g_i|.
//! 2. Of the translations to one plane u · x = Σ |u · g_i| the shortest one is along u. The plane need not touch Z in
//!    a facet: every direction gives an upper bound of the depth. The directions that are tried are the normals of all
//!    sets of D − 1 generators with both signs, found by solving for a vector orthogonal to them, and a facet has one
//!    of these.
//!
//! # Complexity
//! n generators: O(n^D) solutions in rationals.
//!
//! # Shapes
//! generators: n × D, any order, zero and parallel ones allowed.
//!
//! # Numerics
//! Exact rationals throughout.
//!
//! # Checked by
//! Cubes by hand.
//!
//! # Example
//! ```
//! use zonotope::{collision::{Query, distance::penetration::brute_force}, numeric::Rational};
//! let square = [[1.0, 0.0], [0.0, 1.0]];
//! let query = Query::new([0.0, 0.0], [0.75, 0.5], &square).unwrap();
//! assert_eq!(brute_force::squared_depth(&query), Some(Rational::from_parts(1.into(), 16u8.into())));
//! ```

use crate::numeric::Rational;
use crate::numeric::exact_linear::{Span, rational, sum_of_products};
use crate::numeric::subsets::for_each_subset;
use crate::zonotope::query::Query;

/// The square of the depth; `None` if the generators do not span the space, so that nothing is inside.
pub fn squared_depth<const D: usize>(query: &Query<'_, D>) -> Option<Rational> {
    let p = query.exact().map(|c| c.to_rational());
    let generators: Vec<[f64; D]> = query.generators().copied().collect();
    let mut best: Option<Rational> = None;
    for_each_subset(generators.len(), D - 1, |subset| {
        let members: Vec<[f64; D]> = subset.iter().map(|&i| generators[i]).collect();
        // one functional vanishes on independent members, more on others
        let [normal] = &Span::of_doubles(&members).annihilators()[..] else { return };
        let reach = generators.iter().fold(Rational::ZERO, |sum, g| {
            let product = sum_of_products(normal, &g.map(rational));
            if product < Rational::ZERO { sum - product } else { sum + product }
        });
        let level = sum_of_products(normal, &p);
        let square = sum_of_products(normal, normal);
        for distance in [&reach - &level, &reach + &level] {
            let squared = if distance < Rational::ZERO { Rational::ZERO } else { &distance * &distance / &square };
            if best.as_ref().is_none_or(|best| squared < *best) {
                best = Some(squared);
            }
        }
    });
    best.filter(|_| Span::of_doubles(&generators).rank() == D)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cubes_by_hand() {
        let cube = [[1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 3.0]];
        let squared = |to| squared_depth(&Query::new([0.0; 3], to, &cube).expect("finite"));
        assert_eq!(squared([0.0; 3]), Some(Rational::ONE));
        assert_eq!(squared([0.5, 1.75, 0.0]), Some(Rational::from_parts(1.into(), 16u8.into())));
        let flat = Query::new([0.0; 3], [0.0; 3], &cube[..2]).expect("finite");
        assert_eq!(squared_depth(&flat), None);
    }
}
