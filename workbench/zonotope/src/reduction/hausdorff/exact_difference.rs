//! The difference of the support functions of two bodies, exactly, with as few generators as it takes.
//!
//! Parallel generators add up: of those of one direction that both bodies have, only the difference of their sums is
//! left, with the body that has the larger sum. So bodies that are nearly equal are told apart by the few generators
//! in which they differ.

use std::array;
use std::cmp::Ordering;

use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::exact;
use crate::zonotope::Zonotope;
use crate::zonotope::directions::Directions;

/// Two centred bodies without what both have, and the vector between their centres.
#[derive(Debug, Clone)]
pub(in crate::reduction) struct ExactDifference<const D: usize> {
    /// The generators of the first body and of the second, of which no two are parallel.
    pub(super) generators: [Vec<[Dyadic; D]>; 2],
    /// From the centre of the second body to that of the first.
    pub(super) displacement: [Dyadic; D],
}

impl<const D: usize> ExactDifference<D> {
    /// The difference of two bodies. O(n log n).
    pub(in crate::reduction) fn new(a: &Zonotope<D>, b: &Zonotope<D>) -> Self {
        let (own, others) = (a.generators(), b.generators());
        let all: Vec<[f64; D]> = own.iter().chain(others).copied().collect();
        let directions = Directions::of_finite(&all);
        let mut generators = [Vec::new(), Vec::new()];
        for class in 0..directions.len() {
            let mut sum: [Dyadic; D] = array::from_fn(|_| Dyadic::zero());
            for member in directions.members(class) {
                let is_added = member.reversed == (member.generator >= own.len());
                let vector = all[member.generator];
                let term = exact(if is_added { vector } else { vector.map(|c| 0.0 - c) });
                sum = array::from_fn(|k| &sum[k] + &term[k]);
            }
            // members are turned so that the first coordinate that is not zero is positive
            match sum.iter().map(Dyadic::sign).find(|sign| sign.is_ne()) {
                Some(Ordering::Greater) => generators[0].push(sum),
                Some(_) => generators[1].push(sum.map(|c| -c)),
                None => {}
            }
        }
        let [to, from] = [a.center(), b.center()].map(exact);
        Self { generators, displacement: array::from_fn(|k| &to[k] - &from[k]) }
    }

    /// Whether both bodies have the same centre.
    pub(super) fn is_concentric(&self) -> bool {
        self.displacement.iter().all(Dyadic::is_zero)
    }

    /// The exponent of the power of two that is not above the largest coordinate; `None` if there is nothing but zeros.
    pub(super) fn binary_exponent(&self) -> Option<i64> {
        let generators = self.generators.iter().flatten().flatten();
        generators.chain(&self.displacement).filter_map(Dyadic::binary_exponent).max()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn difference<const N: usize, const M: usize>(a: [[f64; 2]; N], b: [[f64; 2]; M]) -> [Vec<[f64; 2]>; 2] {
        let [a, b] = [a.to_vec(), b.to_vec()].map(|list| Zonotope::new([0.0; 2], list).expect("finite"));
        ExactDifference::new(&a, &b)
            .generators
            .map(|list| list.iter().map(|v| v.each_ref().map(Dyadic::to_f64)).collect())
    }

    #[test]
    fn what_both_bodies_have_is_left_out() {
        let b = [[-1.0, -2.0], [0.0, 1.0], [3.0, 0.0]];
        let shared = difference([[1.0, 2.0], [0.0, -1.0], [0.0, 0.0], [-0.0, 1.0]], b);
        assert_eq!(shared, [vec![[0.0, 1.0]], vec![[3.0, 0.0]]]);
        assert!(difference(b, b).iter().all(Vec::is_empty));
    }

    #[test]
    fn parallel_generators_count_once_for_the_body_that_has_more() {
        let parts = difference([[1.0, 1.0], [-2.0, -2.0]], [[0.5, 0.5], [1.0, 0.0]]);
        assert_eq!(parts, [vec![[2.5, 2.5]], vec![[1.0, 0.0]]]);
        let above_one = 1.0 + f64::EPSILON;
        let ulp = difference([[1.0, 0.0], [0.0, 1.0]], [[above_one, 0.0], [0.0, above_one]]);
        assert_eq!(ulp, [vec![], vec![[f64::EPSILON, 0.0], [0.0, f64::EPSILON]]]);
        let sum = difference([[f64::MAX, 0.0], [f64::MAX, 0.0]], [[f64::MAX, 0.0], [f64::MAX, 0.0]]);
        assert!(sum.iter().all(Vec::is_empty), "sums beyond the doubles cancel");
    }
}
