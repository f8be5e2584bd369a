//! The coefficients of a proof that are one factor with the signs of products with a direction, but for those of a
//! basis.
//!
//! Near the boundary most proofs are of this kind: the vertex of the facet in the direction, made smaller. A rule has
//! the size of a few numbers and says all; a caller who reads a coefficient for each generator has them written, which
//! takes a pass and as much memory as the coefficients do. The signs are those of the very products, as they are
//! rounded, of which the proof was made.

use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::lad::of_generators::seam::part::{Part, of_row};
use crate::numeric::lanes::number::product;
use crate::numeric::lanes::octet::LANES;
use crate::numeric::lanes::signed_factors;
use crate::zonotope::location::{Coefficients, Location, SignRule, Witness};
use crate::zonotope::pose::Standing;
use crate::zonotope::query::Query;

/// A direction as the rows of a part are multiplied with it.
fn as_rows_have_it(part: &Part<'_>, u: &[f64; 3]) -> [f64; 3] {
    part.frame.map_or(*u, |frame| frame.pulled(u))
}

/// The sign, 1 or −1, of the product of a generator with a direction.
pub(super) fn sign(parts: &[Part<'_>; 2], u: &[f64; 3], index: usize) -> f64 {
    of_row(parts, index, |part, v| 1f64.copysign(product(v, &as_rows_have_it(part, u))))
}

/// Adds a factor for each generator to a list, with the sign of its product with a direction. O(n).
pub(super) fn write(parts: &[Part<'_>; 2], u: &[f64; 3], factor: f64, list: &mut Vec<f64>) {
    for part in parts {
        signed_factors(part.rows, &as_rows_have_it(part, u), factor, list);
    }
}

impl SignRule {
    /// The coefficients of all generators of the query that the rule is about. O(n).
    fn written(self, query: &dyn KernelQuery) -> Witness {
        // each part is written in whole octets
        let mut coefficients = Vec::with_capacity(query.len() + 2 * LANES);
        write(&query.parts(), &self.direction, self.factor, &mut coefficients);
        Witness::with_basis(coefficients, self.basis, self.own)
    }
}

impl Coefficients {
    /// The coefficients of all generators of the query that they are about. O(n) for a rule.
    fn written(self, query: &dyn KernelQuery) -> Witness {
        match self {
            Self::BySigns(rule) => rule.written(query),
            Self::Written(witness) => witness,
        }
    }
}

impl Location<3, Coefficients> {
    /// The location with a coefficient for each generator of its query. O(n) for a member.
    pub(crate) fn written(self, query: &dyn KernelQuery) -> Location<3> {
        self.map(|coefficients| coefficients.written(query))
    }
}

impl<const D: usize> Location<D, Coefficients> {
    /// The location with a coefficient for each generator of its query, in any dimension. O(n) for a member.
    pub(crate) fn written_for<P: Standing>(self, query: &Query<'_, D, P>) -> Location<D> {
        self.map(|coefficients| match coefficients {
            Coefficients::Written(witness) => witness,
            Coefficients::BySigns(rule) => rule.written(&query.in_dimension::<3>().expect("rules are of space")),
        })
    }

    /// The location of a displacement of space, if D is 3.
    pub(crate) fn of_space(location: Location<3, Coefficients>) -> Self {
        match location {
            Location::Inside(member) => Self::Inside(member),
            Location::Boundary(member) => Self::Boundary(member),
            Location::Outside(separation) => Self::Outside(separation.lowered()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::by_lad;
    use crate::interop::verifier::check_location;
    use crate::lad::of_generators::seam::generators::Generators;
    use crate::zonotope::Zonotope;
    use crate::zonotope::pose::Pose;
    use crate::zonotope::prepared::PreparedBody;

    const CUBE: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

    #[test]
    fn a_rule_of_a_cube_is_written_as_it_says() {
        let rule = SignRule { direction: [0.5, -1.0, 0.0], factor: 0.75, basis: [2, 0, 1], own: [0.25, -0.5, 1.0] };
        let body = [&CUBE[..], &[[0.0, 0.0, 1.0], [-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]]].concat();
        let query = Query::new([0.0; 3], [0.0; 3], &body).expect("finite");
        let witness = rule.clone().written(&query);
        // the fourth product is 0
        assert_eq!(witness.coefficients, [-0.5, 1.0, 0.25, 0.75, -0.75, 0.75]);
        assert_eq!(witness.basis, [0, 1, 2]);
        assert_eq!(Coefficients::BySigns(rule).written(&query), witness);
    }

    #[test]
    fn the_sign_of_one_generator_is_that_among_all() {
        let quarter = Pose::new([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]], [0.0; 3]).expect("finite");
        let body = Zonotope::new([0.0; 3], CUBE.to_vec()).expect("finite");
        let query = Query::of_placed(body.at(&quarter), body.at(&Pose::IDENTITY));
        let (parts, u) = (Generators::parts(&query), [1.0, -2.0, 3.0]);
        let mut all = vec![];
        write(&parts, &u, 0.5, &mut all);
        // (1, 0, 0) becomes (0, 1, 0), and (0, 1, 0) becomes (−1, 0, 0)
        assert_eq!(all, [-0.5, -0.5, 0.5, 0.5, -0.5, 0.5]);
        assert!((0..6).all(|i| 0.5 * sign(&parts, &u, i) == all[i]));
    }

    #[test]
    fn the_proof_of_a_pair_has_constant_size_and_the_coefficients_of_rows_and_blocks() {
        let generators: Vec<[f64; 3]> =
            (0..50u32).map(|i| [i * i % 101, i * i % 83, i * 7 % 61].map(|c| f64::from(c) / 60.0 - 0.6)).collect();
        let body = Zonotope::new([0.0; 3], generators).expect("finite");
        let u = [0.3, 0.2, 0.9];
        let facet_point = body.support(u).point().map(|c| c * (1.0 - 1e-6));
        let prepared = PreparedBody::new(body.clone());
        let query = Query::of_point(facet_point, &body).expect("finite");
        let in_blocks = Query::of_point_in(facet_point, prepared.placed()).expect("finite");
        let found = [by_lad::located(&query, &mut ()), by_lad::located(&in_blocks, &mut ())].map(|found| {
            let found = found.expect("the kernel answers in space");
            let is_rule = matches!(&found, Location::Inside(Coefficients::BySigns(_)));
            assert!(is_rule, "{found:?}");
            found
        });
        assert_eq!(found[0], found[1]);
        let [rows, blocks] = found;
        let written = rows.written_for(&query);
        assert_eq!(written, blocks.written_for(&in_blocks));
        assert_eq!(check_location(&query, &written).proof().map(drop), Ok(()));
    }
}
