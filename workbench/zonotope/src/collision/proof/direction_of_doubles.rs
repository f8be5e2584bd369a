//! A direction of doubles that separates, near the exact normal of a facet that the displacement is beyond.
//!
//! Near the boundary rounding the normal u costs more than the gap: the two generators of the facet, which u is
//! orthogonal to, are not orthogonal to a rounded u. Multiples of u are rounded differently, and so are neighbours of a
//! rounded one, so several directions are tried. Let S be the sum of all other generators with the signs of their
//! products with u. No direction w separates unless w · (p − S) exceeds |w · v| of the two, which takes O(1) and turns
//! nearly all down; what is left is tried with all generators.

use crate::lad::of_generators::seam::direction_signs::DirectionSigns;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::exact_linear::{self, exact};
use crate::numeric::linear::dot;

/// Multiples of the direction that are rounded in turn: each multiple has its coordinates rounded differently.
const MULTIPLES: [f64; 8] = [1.0, 1.1, 1.3, 1.5, 1.7, 1.2, 1.4, 1.6];

/// A vector in pairs of doubles.
pub(crate) type Pairs = [BoundedDoubleDouble; 3];

/// The facet of at most two generators, seen from a displacement beyond it.
pub(crate) struct Beyond {
    /// The normal u with u · p > 0.
    pub(crate) normal: Pairs,
    /// p − S.
    pub(crate) rest: Pairs,
    /// The generators of the facet; zero where there are fewer than two.
    pub(crate) spanning: [Pairs; 2],
}

impl Beyond {
    /// A direction of doubles near the normal that separates, if one is found. O(n) for each that is likely to.
    pub(crate) fn direction_of_doubles(&self, query: &dyn KernelQuery) -> Option<[f64; 3]> {
        let size = self.normal.iter().fold(0.0f64, |m, c| m.max(c.high.abs()));
        let largest = BoundedDoubleDouble::exact(size);
        let [x, y, z] = self.normal.map(|c| (c / largest).high);
        let multiples = MULTIPLES.map(|factor| self.normal.map(|c| (c * BoundedDoubleDouble::exact(factor)).high));
        let candidates = multiples.into_iter().chain([[x, y, z]]).chain(neighbours([x, y, z]));
        candidates.filter(|w| self.is_likely(*w)).find(|w| separates(query, *w))
    }

    /// Whether w · (p − S) may exceed the reach of the facet's generators.
    fn is_likely(&self, w: [f64; 3]) -> bool {
        let w = w.map(BoundedDoubleDouble::exact);
        let [first, second] = self.spanning.map(|v| dot(&v, &w).abs());
        let gap = dot(&self.rest, &w) - first - second;
        gap.high > 0.0 || gap.sign().is_none()
    }
}

/// The directions in which one or more coordinates are moved to a neighbouring double.
fn neighbours(u: [f64; 3]) -> impl Iterator<Item = [f64; 3]> {
    let step = |value: f64, step: i32| match step {
        0 => value,
        1 => value.next_up(),
        _ => value.next_down(),
    };
    (0..27).filter(|&code| code != 13).map(move |code| {
        let steps = [code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1];
        [0, 1, 2].map(|i| step(u[i], steps[i]))
    })
}

/// Whether w · p > h(w): as pairs of doubles tell, or else exactly. O(n).
fn separates(query: &dyn KernelQuery, w: [f64; 3]) -> bool {
    seems_to_separate(query, w).unwrap_or_else(|| separates_exactly(query, w))
}

/// Whether w · p > h(w), where pairs of doubles tell. O(n).
fn seems_to_separate(query: &dyn KernelQuery, w: [f64; 3]) -> Option<bool> {
    let w = w.map(BoundedDoubleDouble::exact);
    let mut reach = BoundedDoubleDouble::exact(0.0);
    for part in query.parts() {
        let own = part.pair_pulled(&w);
        let product = |v: &[f64; 3]| dot(&v.map(BoundedDoubleDouble::exact), &own);
        reach = part.rows.list().iter().fold(reach, |sum, v| sum + product(v).abs());
    }
    (dot(&query.displacement_pairs(), &w) - reach).sign().map(|sign| sign > 0)
}

/// Whether w · p > h(w), exactly. O(n).
fn separates_exactly(query: &dyn KernelQuery, w: [f64; 3]) -> bool {
    if !w.iter().all(|c| c.is_finite()) {
        return false;
    }
    let direction = exact(w);
    let sum = query.signed_sum(&DirectionSigns::new(query, &direction).all(&direction));
    exact_linear::dot(&exact_linear::difference(&query.exact(), &sum), &direction).sign().is_gt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::linear::cross;
    use crate::zonotope::query::Query;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    fn pairs(v: [f64; 3]) -> Pairs {
        v.map(BoundedDoubleDouble::exact)
    }

    /// The exact gap w · p − h(w).
    fn gap(query: &dyn KernelQuery, w: [f64; 3]) -> crate::numeric::dyadic::Dyadic {
        let w = exact(w);
        let along = exact_linear::dot(&query.exact(), &w);
        (0..query.len()).fold(along, |gap, i| gap - exact_linear::dot(&query.exact_generator(i), &w).abs())
    }

    #[test]
    fn the_neighbours_of_a_direction_are_all_twenty_six() {
        let u = [1.0, -0.5, 3e-7];
        let own: Vec<[f64; 3]> = neighbours(u).collect();
        assert_eq!(own.len(), 26);
        for (i, w) in own.iter().enumerate() {
            assert!(*w != u && !own[..i].contains(w), "{w:?}");
            assert!((0..3).all(|k| [u[k].next_down(), u[k], u[k].next_up()].contains(&w[k])), "{w:?}");
        }
    }

    #[test]
    fn a_direction_is_likely_where_the_rest_exceeds_what_the_facet_reaches() {
        let of = |rest: [f64; 3]| Beyond {
            normal: pairs([0.0, 0.0, 1.0]),
            rest: pairs(rest),
            spanning: [pairs([1.0, 0.0, 0.0]), pairs([0.0, -2.0, 0.0])],
        };
        let w = [0.25, 0.125, 1.0];
        assert!(of([0.0, 0.0, 0.51]).is_likely(w));
        assert!(!of([0.0, 0.0, 0.49]).is_likely(w));
        assert!(!of([0.0, 0.0, 0.3]).is_likely(w) && !of([0.0, 0.0, 0.2]).is_likely(w));
        assert!(!of([0.0, 0.0, -1.0]).is_likely(w));
        // an equality leaves a doubt
        assert!(of([0.0, 0.0, 0.5]).is_likely(w));
        assert!(of([4.0, 0.0, 0.0]).is_likely(w) && !of([1.0, 1.0, 0.0]).is_likely(w));
    }

    #[test]
    fn pairs_and_exact_numbers_tell_alike_whether_a_direction_separates() {
        let random = &mut Pcg64Mcg::seed_from_u64(111);
        let mut told = [0, 0];
        for round in 0..300 {
            let n = 1 + round % 12;
            let mut vector = || [0, 1, 2].map(|_| f64::from(random.random_range(-9..10)));
            let (rows, w, mut p) = ((0..n).map(|_| vector()).collect::<Vec<[f64; 3]>>(), vector(), vector());
            let reach: f64 = rows.iter().map(|v| dot(v, &w).abs()).sum();
            // in the plane that supports the body, one above or one below it, where w allows
            if let Some(k) = (0..3).find(|&k| w[k].abs() == 1.0) {
                p[k] += w[k] * (reach - dot(&p, &w) + f64::from(round % 3 - 1));
            }
            let query = Query::new([0.0; 3], p, &rows).expect("finite");
            let is_apart = gap(&query, w).sign().is_gt();
            assert_eq!(separates_exactly(&query, w), is_apart, "{rows:?} {p:?} {w:?}");
            assert_eq!(separates(&query, w), is_apart, "{rows:?} {p:?} {w:?}");
            let own = seems_to_separate(&query, w);
            assert!(own.is_none_or(|own| own == is_apart), "{rows:?} {p:?} {w:?}");
            assert!(own.is_some() || gap(&query, w).is_zero(), "{rows:?} {p:?} {w:?}");
            told[usize::from(is_apart)] += 1;
        }
        assert!(told.iter().all(|count| *count > 20), "{told:?}");
        let cube = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let query = Query::new([0.0; 3], [0.0, 0.0, 2.0], &cube).expect("finite");
        assert!(!separates_exactly(&query, [0.0, 0.0, f64::INFINITY]));
        assert!(!separates_exactly(&query, [f64::NAN, 0.0, 1.0]));
    }

    /// Gaps of some units in the last place are beyond what one rounding of the normal leaves, and found among several.
    #[test]
    fn directions_of_doubles_are_found_for_most_narrow_gaps() {
        let random = &mut Pcg64Mcg::seed_from_u64(112);
        for scale in [1.0, 1e3, 1e-3] {
            let mut found = 0;
            for _ in 0..120 {
                let mut vector = |size: f64| [0, 1, 2].map(|_| size * random.random_range(-1.0..1.0f64));
                let body = [vector(scale), vector(scale), vector(1.0), vector(1.0)];
                let spanning = [body[0], body[1]].map(pairs);
                let normal = cross(&spanning[0], &spanning[1]);
                let sign = |v: &[f64; 3]| f64::from(dot(&normal, &pairs(*v)).sign().unwrap_or(0));
                let signs = [sign(&body[2]), sign(&body[3])];
                let sum = [0, 1, 2].map(|k| signs[0] * body[2][k] + signs[1] * body[3][k]);
                let p = sum.map(|c| c * (1.0 + 3.0 * scale.max(1.0) * f64::EPSILON));
                let query = Query::new([0.0; 3], p, &body).expect("finite");
                let off = |k: usize, i: usize| BoundedDoubleDouble::exact(signs[i] * body[i + 2][k]);
                let rest = [0, 1, 2].map(|k| BoundedDoubleDouble::exact(p[k]) - off(k, 0) - off(k, 1));
                let Some(w) = (Beyond { normal, rest, spanning }).direction_of_doubles(&query) else { continue };
                assert!(gap(&query, w).sign().is_gt(), "{body:?} {p:?}");
                found += 1;
            }
            assert!(found >= 85, "{scale} {found}");
        }
    }
}
