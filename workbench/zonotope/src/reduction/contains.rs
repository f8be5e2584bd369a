//! Whether a zonotope contains another one: exactly, for bodies anywhere.

use std::array;

use super::containment::Facets;
use super::hausdorff::{ExactDifference, lies_inside};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{Span, exact};
use crate::zonotope::Zonotope;

/// Limit of the products of a facet normal and a generator, each normal counted as [`NORMAL_PRODUCTS`] more.
const PRODUCT_LIMIT: u64 = 1 << 27;

/// The products that take as long as a normal.
const NORMAL_PRODUCTS: u64 = 64;

/// Limit of the products in exact arithmetic: where doubles leave a doubt, as they do of nearly equal bodies.
const EXACT_PRODUCT_LIMIT: u64 = 1 << 18;

/// Bodies whose facets take more products than this are looked at along cones of directions first, which tells of
/// bodies that do not touch.
const DIRECT_PRODUCT_LIMIT: u64 = 1 << 21;

/// Limit of the products along cones.
const CONE_PRODUCT_LIMIT: u64 = 1 << 23;

/// Whether the outer zonotope contains the inner one, decided exactly; none where that takes more than 2^27 products of
/// a facet normal and a generator, or more than 2^18 of which doubles do not tell enough, and the bodies touch or
/// nearly do. Flat bodies are compared within the span of the outer one. O(C(k, r − 1) (n + k)) for n generators of the
/// inner body and k of the outer one, of rank r.
#[inline(never)]
pub fn contains<const D: usize>(outer: &Zonotope<D>, inner: &Zonotope<D>) -> Option<bool> {
    let [from, to] = [outer.center(), inner.center()].map(exact);
    let displacement: [Dyadic; D] = array::from_fn(|k| &to[k] - &from[k]);
    let span = Span::of_doubles(outer.generators());
    if span.rank() < D {
        let is_beside = |v: &[Dyadic]| v.iter().any(|c| !c.is_zero()) && span.direction_to(v).is_some();
        if is_beside(&displacement) || inner.generators().iter().any(|v| is_beside(&exact(*v))) {
            return Some(false);
        }
    }
    if span.rank() == 0 {
        return Some(true);
    }
    let axes = span.independent_coordinates();
    let place = |k: usize| axes.get(k).copied();
    let kept = |list: &[[f64; D]]| -> Vec<[f64; D]> {
        list.iter().map(|v| array::from_fn(|k| place(k).map_or(0.0, |axis| v[axis]))).collect()
    };
    let (own, others) = (kept(inner.generators()), kept(outer.generators()));
    let moved = array::from_fn(|k| place(k).map_or_else(Dyadic::zero, |axis| displacement[axis].clone()));
    let products = Facets::<D>::count(others.len(), span.rank(), PRODUCT_LIMIT)
        .map(|normals| normals.saturating_mul((own.len() + others.len()) as u64 + NORMAL_PRODUCTS));
    if span.rank() == D && products.is_none_or(|products| products > DIRECT_PRODUCT_LIMIT) {
        let told = lies_inside(&ExactDifference::new(inner, outer), CONE_PRODUCT_LIMIT);
        if told.is_some() {
            return told;
        }
    }
    if products? > PRODUCT_LIMIT {
        return None;
    }
    let facets = Facets::new(&others, span.rank()).expect("independent coordinates of the span tell its vectors apart");
    facets.contain_displaced(&own, &moved, &mut { EXACT_PRODUCT_LIMIT })
}

#[cfg(test)]
mod tests {
    use super::super::brute_force;
    use super::*;
    use proptest::prelude::*;

    fn number() -> impl Strategy<Value = f64> {
        prop_oneof![
            6 => (-3..=3i32).prop_map(f64::from),
            2 => -1.0..1.0f64,
            1 => (-3..=3i32).prop_map(|c| f64::from(c) * f64::from_bits(1)),
            1 => (-3..=3i32).prop_map(|c| f64::from(c) * 2f64.powi(1020)),
        ]
    }

    fn body<const D: usize>(count: std::ops::Range<usize>) -> impl Strategy<Value = Zonotope<D>> {
        let vector = || proptest::array::uniform::<_, D>(number());
        (vector(), proptest::collection::vec(vector(), count))
            .prop_map(|(center, generators)| Zonotope::new(center, generators).expect("finite"))
    }

    properties! {
        #[test]
        fn agrees_with_brute_force(
            [a, b] in [body::<3>(0..6), body::<3>(0..4)],
            [c, d] in [body::<2>(0..6), body::<2>(0..4)],
        ) {
            prop_assert_eq!(contains(&a, &b), Some(brute_force::contains(&a, &b)));
            prop_assert_eq!(contains(&c, &d), Some(brute_force::contains(&c, &d)));
            prop_assert_eq!(contains(&a, &a), Some(true));
        }
    }

    #[test]
    fn a_square_in_a_cube_that_it_touches() {
        let cube = Zonotope::new([0.0; 3], vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]).expect("finite");
        let at = |x: f64| Zonotope::new([x, 0.5, 1.0], vec![[0.5, 0.0, 0.0], [0.0, 0.5, 0.0]]).expect("finite");
        assert_eq!([0.5, 0.5 + f64::EPSILON].map(|x| contains(&cube, &at(x))), [Some(true), Some(false)]);
        assert_eq!(contains(&at(0.5), &cube), Some(false), "a flat body contains no solid one");
        let many: Vec<[f64; 3]> = (0..40_000).map(|i| [f64::from(i), f64::from(i * i), 1.0]).collect();
        let many = Zonotope::new([0.0; 3], many).expect("finite");
        assert_eq!(contains(&many, &many), None, "there are too many facets to compare");
    }
}
