//! The generators of a facet that has two directions only: parallel ones as one bundle.
//!
//! In a bundle, one coefficient stands for those of all members: that of their sum, each turned to one side. Where a
//! body has few directions, or two bodies share some, nearly all facets are of this kind, and the optimum's
//! coefficients follow from two quotients, without a search among the facet's generators.

use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, difference, dot, sum};

/// Parallel generators.
pub(super) struct Bundle {
    /// Each with the sign with which it points the way of the first.
    members: Vec<(usize, i8)>,
    /// The first.
    base: ExactVector,
    /// Σ sign · v.
    pub(super) total: ExactVector,
}

/// A coefficient of a bundle, `numerator` / `denominator`, the latter positive.
pub(super) struct Share<'a> {
    pub(super) numerator: &'a Dyadic,
    pub(super) denominator: &'a Dyadic,
}

impl Bundle {
    /// A generator alone.
    pub(super) fn of(index: usize, v: ExactVector) -> Self {
        Self { members: vec![(index, 1)], total: v.clone(), base: v }
    }

    /// The two bundles of a facet that is spanned by two of its generators; `None` where it has a third direction.
    /// O(k) for k generators.
    pub(super) fn of_facet(
        query: &dyn KernelQuery,
        direction: &ExactVector,
        basis: [usize; 2],
        facet: &[usize],
    ) -> Option<[Self; 2]> {
        let mut bundles = basis.map(|index| Self::of(index, query.exact_generator(index)));
        // all generators of the facet are orthogonal to the direction: one coordinate of a cross product tells whether
        // two are parallel
        let axis = direction.iter().position(|c| !c.is_zero())?;
        for &index in facet.iter().filter(|index| !basis.contains(index)) {
            let v = query.exact_generator(index);
            bundles.iter_mut().find(|bundle| bundle.is_along(&v, axis))?.add(index, &v);
        }
        Some(bundles)
    }

    /// The generator that the others are turned to.
    pub(super) fn first(&self) -> usize {
        self.members[0].0
    }

    fn is_along(&self, v: &ExactVector, axis: usize) -> bool {
        let [i, j] = [(axis + 1) % 3, (axis + 2) % 3];
        (&self.base[i] * &v[j]) == (&self.base[j] * &v[i])
    }

    fn add(&mut self, index: usize, v: &ExactVector) {
        let is_reversed = dot(&self.base, v).sign().is_lt();
        self.total = if is_reversed { difference(&self.total, v) } else { sum(&self.total, v) };
        self.members.push((index, if is_reversed { -1 } else { 1 }));
    }

    /// Signs for all members but one that, with some coefficient in [−1, 1] of that one, make up a coefficient of the
    /// bundle in [−1, 1]; returns that one.
    ///
    /// From −1 for all, one after the other is turned to 1 until the next one would go beyond.
    pub(super) fn distribute(&self, query: &dyn KernelQuery, share: &Share<'_>, signs: &mut [i8]) -> usize {
        let axis = self.base.iter().position(|c| !c.is_zero()).unwrap_or(0);
        let length = |v: &ExactVector| v[axis].clone().abs();
        let whole = length(&self.total);
        let target = share.numerator * &whole;
        let (mut reached, mut one) = (-whole, None);
        for (place, &(index, side)) in self.members.iter().enumerate() {
            if one.is_some() {
                signs[index] = -side;
                continue;
            }
            let is_last = place + 1 == self.members.len();
            let next = &reached + &length(&query.exact_generator(index)).scaled(1);
            if is_last || &next * share.denominator >= target {
                one = Some(index);
            } else {
                (reached, signs[index]) = (next, side);
            }
        }
        one.unwrap_or(self.first())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::exact_linear::exact;
    use crate::zonotope::query::Query;

    const BODY: [[f64; 3]; 7] = [
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [-2.0, 0.0, 0.0],
        [0.0, 0.0, 1.0],
        [0.5, 0.0, 0.0],
        [0.0, -3.0, 0.0],
        [1.0, 1.0, 0.0],
    ];

    fn bundles(facet: &[usize]) -> Option<[Bundle; 2]> {
        let query = Query::new([0.0; 3], [1.0; 3], &BODY).expect("finite");
        Bundle::of_facet(&query, &exact([0.0, 0.0, 1.0]), [0, 1], facet)
    }

    #[test]
    fn parallel_generators_are_turned_to_the_first() {
        let [along, across] = bundles(&[0, 1, 2, 4, 5]).expect("two directions");
        assert_eq!(along.members, [(0, 1), (2, -1), (4, 1)]);
        assert_eq!(along.total, exact([3.5, 0.0, 0.0]));
        assert_eq!(across.total, exact([0.0, 4.0, 0.0]));
        assert!(bundles(&[0, 1, 6]).is_none());
    }

    #[test]
    fn signs_make_up_a_share_with_one_coefficient_between() {
        let query = Query::new([0.0; 3], [1.0; 3], &BODY).expect("finite");
        let [along, _] = bundles(&[0, 1, 2, 4]).expect("two directions");
        let denominator = Dyadic::from_f64(8.0);
        for eighths in -8..=8 {
            let numerator = Dyadic::from_f64(f64::from(eighths));
            let mut signs = [0; 7];
            let one = along.distribute(&query, &Share { numerator: &numerator, denominator: &denominator }, &mut signs);
            assert_eq!(signs[one], 0);
            // what is left for the one: the share less the signed sum, along the first axis
            let sum: f64 = BODY.iter().zip(signs).map(|(v, sign)| v[0] * f64::from(sign)).sum();
            let rest = f64::from(eighths) / 8.0 * 3.5 - sum;
            assert!(rest.abs() <= BODY[one][0].abs(), "{eighths}: {signs:?}");
            assert!([0, 2, 4].iter().all(|&i| i == one || signs[i] != 0));
        }
    }
}
