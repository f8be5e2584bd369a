//! Whether a zonotope contains another one with the same centre, along its facet normals: in doubles where a bound on
//! their errors leaves no doubt, exactly otherwise.
//!
//! The outer body spans its space, so it is the intersection of the half-spaces of its facets, whose normals are those
//! of the hyperplanes that its generators span. A normal in doubles comes with the error of each coordinate; times the
//! extents of the bodies that bounds the error of the reaches along it.

use std::array;

use crate::numeric::bounded::Bounded;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{Span, exact, hyperplane_normal, sum_of_products};
use crate::numeric::lanes::{Extents, absolute_sum};
use crate::numeric::scaling::{binary_exponent, largest_magnitude, scale_by_power_of_two};
use crate::numeric::subsets::for_each_subset;
use crate::numeric::tolerance::{DIFFERENCE_OF_LEADING_DOUBLES, FIVE_ROUNDINGS, PRODUCT_UNDERFLOW};

/// Generators of a body that spans the first `rank` coordinates, if it spans them: the others are 0.
pub(super) struct Facets<'a, const D: usize> {
    outer: &'a [[f64; D]],
    rank: usize,
    /// The generators times a power of two each, so that their largest coordinate is about 1; what that loses of far
    /// smaller coordinates is in their errors.
    unit: Vec<[Bounded; D]>,
}

/// The generators of a body times one power of two, with what bounds the errors of sums over them.
struct Scaled<const D: usize> {
    generators: Vec<[f64; D]>,
    extents: Extents<D>,
}

impl<const D: usize> Scaled<D> {
    fn new(generators: &[[f64; D]], exponent: i64) -> Self {
        let generators: Vec<[f64; D]> =
            generators.iter().map(|g| g.map(|c| scale_by_power_of_two(c, exponent))).collect();
        let extents = Extents::new(&generators);
        Self { generators, extents }
    }

    /// Σ |g · u| for an exact direction of which no coordinate is farther from `direction` than `errors`.
    fn reach(&self, direction: &[f64; D], errors: &[f64; D]) -> Bounded {
        let value = absolute_sum(&self.generators, direction);
        let moved: f64 = self.extents.sums().iter().zip(errors).map(|(sum, error)| sum * error).sum();
        let underflow = self.generators.len() as f64 * PRODUCT_UNDERFLOW;
        let error = (self.extents.error(direction, value) + moved + underflow) * FIVE_ROUNDINGS * FIVE_ROUNDINGS;
        Bounded { value, error }
    }
}

impl<'a, const D: usize> Facets<'a, D> {
    /// The facets of a body; `None` if its generators do not span the first `rank` coordinates, or are not finite.
    pub(super) fn new(outer: &'a [[f64; D]], rank: usize) -> Option<Self> {
        let unit = |g: &[f64; D]| {
            let exponent = binary_exponent(largest_magnitude(g)).unwrap_or(0);
            g.map(|c| {
                let value = scale_by_power_of_two(c, -i64::from(exponent));
                let is_exact = c == 0.0 || value.abs() >= PRODUCT_UNDERFLOW;
                Bounded { value, error: if is_exact { 0.0 } else { PRODUCT_UNDERFLOW } }
            })
        };
        let is_finite = outer.as_flattened().iter().all(|c| c.is_finite());
        let spans = is_finite && rank > 0 && Span::of_doubles(outer).rank() == rank;
        spans.then(|| Self { outer, rank, unit: outer.iter().map(unit).collect() })
    }

    /// The number of hyperplanes that are looked at, if it is below a limit.
    pub(super) fn count(generators: usize, rank: usize, limit: u64) -> Option<u64> {
        let mut count = 1u64;
        for k in 0..rank.saturating_sub(1) as u64 {
            count = count.checked_mul((generators as u64).saturating_sub(k))? / (k + 1);
            if count > limit {
                return None;
            }
        }
        Some(count)
    }

    /// Calls `visit` with the generators that span each hyperplane and a normal, rounded, with the errors of its
    /// coordinates, as long as it says so.
    fn for_each_normal(&self, mut visit: impl FnMut(&[usize], [Bounded; D]) -> bool) {
        let mut goes_on = true;
        for_each_subset(self.unit.len(), self.rank - 1, |chosen| {
            if goes_on {
                let rows: Vec<&[Bounded]> = chosen.iter().map(|&index| &self.unit[index][..self.rank]).collect();
                let normal = hyperplane_normal(&rows);
                let coordinate = |k: usize| normal.get(k).copied().unwrap_or(Bounded::exact(0.0));
                goes_on = visit(chosen, array::from_fn(coordinate));
            }
        });
    }

    /// At most `limit` of the sets of generators that span hyperplanes: every so many of them, another choice for each
    /// `turn`.
    pub(super) fn sampled_hyperplanes(&self, limit: u64, turn: u64) -> Vec<Vec<usize>> {
        let stride = Self::count(self.unit.len(), self.rank, u64::MAX).map_or(u64::MAX, |count| count.div_ceil(limit));
        let mut next = turn % stride.max(1);
        let mut sets = Vec::new();
        for_each_subset(self.unit.len(), self.rank - 1, |chosen| {
            if next == 0 {
                sets.push(chosen.to_vec());
                next = stride;
            }
            next -= 1;
        });
        sets
    }

    /// The normal of the hyperplane that some generators span, rounded.
    pub(super) fn normal(&self, chosen: &[usize]) -> [f64; D] {
        let rows: Vec<[f64; D]> = chosen.iter().map(|&index| self.unit[index].map(|c| c.value)).collect();
        let rows: Vec<&[f64]> = rows.iter().map(|row| &row[..self.rank]).collect();
        let normal = hyperplane_normal(&rows);
        array::from_fn(|k| normal.get(k).copied().unwrap_or(0.0))
    }

    /// Whether the body contains the one of other generators with the same centre, which are 0 beyond the first `rank`
    /// coordinates as well. O(C(k, r − 1) (n + k)). None where doubles leave more products of a normal and a generator
    /// in doubt than are left of the exact ones, which are taken off.
    pub(super) fn contain(&self, inner: &[[f64; D]], exact_products: &mut u64) -> Option<bool> {
        self.contain_displaced(inner, &array::from_fn(|_| Dyadic::zero()), exact_products)
    }

    /// The same where the other body has its centre at a displacement, of which the coordinates beyond the first `rank`
    /// are 0, too.
    pub(super) fn contain_displaced(
        &self,
        inner: &[[f64; D]],
        displacement: &[Dyadic; D],
        exact_products: &mut u64,
    ) -> Option<bool> {
        let (outer_scaled, inner_scaled, exponent) = self.scaled(inner);
        let moved = displacement.each_ref().map(|c| {
            let value = c.clone().scaled(exponent).to_f64();
            Bounded { value, error: value.abs() * DIFFERENCE_OF_LEADING_DOUBLES + PRODUCT_UNDERFLOW }
        });
        let products = (inner.len() + self.outer.len()) as u64;
        let mut holds = Some(true);
        self.for_each_normal(|chosen, normal| {
            let (direction, errors) = (normal.map(|c| c.value), normal.map(|c| c.error));
            let [reach, limit] = [&inner_scaled, &outer_scaled].map(|body| body.reach(&direction, &errors));
            let along = normal.iter().zip(&moved).fold(Bounded::exact(0.0), |sum, (&u, &p)| sum + u * p);
            let slack = limit - reach - Bounded { value: along.value.abs(), error: along.error };
            if slack.negated().is_positive() {
                holds = Some(false);
            } else if !slack.is_positive() {
                let rest = exact_products.checked_sub(products);
                holds = rest.map(|_| self.contain_along(chosen, inner, displacement));
                *exact_products = rest.unwrap_or(0);
            }
            holds == Some(true)
        });
        holds
    }

    /// Whether the inner body reaches no farther along the normal of a hyperplane, exactly.
    fn contain_along(&self, chosen: &[usize], inner: &[[f64; D]], displacement: &[Dyadic; D]) -> bool {
        let rows: Vec<Vec<Dyadic>> =
            chosen.iter().map(|&index| exact(self.outer[index])[..self.rank].to_vec()).collect();
        let normal = hyperplane_normal(&rows);
        let reach = |generators: &[[f64; D]]| {
            let products = generators.iter().map(|g| sum_of_products(&exact(*g), &normal).abs());
            products.fold(Dyadic::zero(), |sum, product| &sum + &product)
        };
        &reach(inner) + &sum_of_products(displacement, &normal).abs() <= reach(self.outer)
    }

    /// The factor by which the body has to grow to contain the one of other generators, up to rounding; infinite if
    /// that is not known. O(C(k, r − 1) (n + k)).
    pub(super) fn growth(&self, inner: &[[f64; D]]) -> f64 {
        let (outer_scaled, inner_scaled, _) = self.scaled(inner);
        let mut factor = 0.0f64;
        self.for_each_normal(|_, normal| {
            let direction = normal.map(|c| c.value);
            let [reach, limit] = [&inner_scaled, &outer_scaled].map(|body| absolute_sum(&body.generators, &direction));
            // a normal of dependent generators is 0 up to rounding
            let is_certain = normal.iter().any(|c| c.is_positive() || c.negated().is_positive());
            if is_certain && reach > factor * limit {
                factor = reach / limit;
            }
            true
        });
        factor
    }

    /// Both bodies times a power of two, and its exponent.
    fn scaled(&self, inner: &[[f64; D]]) -> (Scaled<D>, Scaled<D>, i64) {
        let largest = largest_magnitude(self.outer.as_flattened()).max(largest_magnitude(inner.as_flattened()));
        let exponent = -i64::from(binary_exponent(largest).unwrap_or(0));
        (Scaled::new(self.outer, exponent), Scaled::new(inner, exponent), exponent)
    }
}

#[cfg(test)]
mod tests {
    use super::super::brute_force;
    use super::*;
    use crate::zonotope::Zonotope;
    use proptest::prelude::*;

    fn number() -> impl Strategy<Value = f64> {
        prop_oneof![
            (-4..=4i32).prop_map(f64::from),
            -1.0..1.0f64,
            (-4..=4i32).prop_map(|c| f64::from(c) * f64::from_bits(1)),
            (-4..=4i32).prop_map(|c| f64::from(c) * 2f64.powi(1020)),
        ]
    }

    fn agrees<const D: usize>(outer: &[[f64; D]], inner: &[[f64; D]]) -> Result<(), TestCaseError> {
        let Some(facets) = Facets::new(outer, D) else { return Ok(()) };
        let [a, b] = [outer, inner].map(|list| Zonotope::new([0.0; D], list.to_vec()).unwrap());
        prop_assert_eq!(facets.contain(inner, &mut { u64::MAX }), Some(brute_force::contains(&a, &b)));
        Ok(())
    }

    properties! {
        #[test]
        fn agrees_with_brute_force(
            outer in proptest::collection::vec(proptest::array::uniform3(number()), 3..7),
            inner in proptest::collection::vec(proptest::array::uniform3(number()), 0..5),
            shrunk in any::<bool>(),
        ) {
            let halves: Vec<[f64; 3]> = outer.iter().map(|g| g.map(|c| c / 2.0)).collect();
            agrees(&outer, if shrunk { &halves } else { &inner })?;
            agrees(&outer, &outer)?;
        }

        #[test]
        fn agrees_with_brute_force_in_the_plane_and_in_r4(
            plane in proptest::collection::vec(proptest::array::uniform2(number()), 2..6),
            space_time in proptest::collection::vec(proptest::array::uniform4(number()), 4..6),
        ) {
            agrees(&plane, &plane[1..])?;
            agrees(&space_time, &space_time[1..])?;
        }
    }

    properties! {
        #[test]
        fn a_body_grown_by_the_factor_contains(
            outer in proptest::collection::vec(proptest::array::uniform3(-1.0..1.0f64), 3..7),
            inner in proptest::collection::vec(proptest::array::uniform3(-1.0..1.0f64), 0..7),
        ) {
            let facets = Facets::new(&outer, 3).expect("random vectors are independent");
            let factor = facets.growth(&inner);
            let grown = |factor: f64| -> Vec<[f64; 3]> { outer.iter().map(|g| g.map(|c| c * factor)).collect() };
            let contains = |factor: f64| Facets::new(&grown(factor), 3)?.contain(&inner, &mut (1 << 20));
            prop_assert!(inner.is_empty() || contains(factor * 1.000_001) == Some(true));
            prop_assert!(inner.is_empty() || contains(factor * 0.999_999) == Some(false));
        }
    }

    #[test]
    fn exact_products_are_limited() {
        // the sums of 30 generators touch themselves along every facet normal
        let generator = |k: i32| [f64::from(k), f64::from(k * k % 7), f64::from(k * k * k % 11)];
        let generators: Vec<[f64; 3]> = (1..31).map(generator).collect();
        let facets = Facets::new(&generators, 3).expect("they span space");
        let all = 435 * 60;
        let (mut enough, mut few) = (all, all - 1);
        assert_eq!((facets.contain(&generators, &mut enough), enough), (Some(true), 0));
        assert_eq!((facets.contain(&generators, &mut few), few), (None, 0));
    }

    #[test]
    fn hyperplanes_are_counted() {
        assert_eq!(Facets::<3>::count(512, 3, u64::MAX), Some(130_816));
        assert_eq!(Facets::<3>::count(usize::MAX, 6, 1 << 20), None);
        assert_eq!(Facets::<1>::count(7, 1, 10), Some(1));
    }
}
