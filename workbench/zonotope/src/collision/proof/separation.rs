//! Separating directions: that of a rounded optimum, where it leaves room for every rounding error, else doubles near
//! an exact direction.

use crate::collision::Separation;
use crate::collision::proof::direction_of_doubles::Beyond;
use crate::lad::of_generators::certify::rounded_optimum::RoundedOptimum;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::bounded::{Bounded, BoundedVector};
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, cross, difference, dot, negated};
use crate::tally::Rung;
use crate::zonotope::location::Proof;

/// The direction of the facet in doubles: rounding it by e takes at most e · (Σ |v|_1 + |p|_1) off the gap, |v|_1 < 2
/// |v|.
pub(in crate::collision) fn in_doubles(optimum: &RoundedOptimum, p: &BoundedVector) -> Option<Proof> {
    let error = optimum.direction.iter().fold(0.0f64, |m, c| m.max(c.error));
    let size: f64 = p.iter().map(|c| c.magnitude()).sum();
    let gap = optimum.along - optimum.support();
    let lost = Bounded::exact(error) * (Bounded::exact(4.0 * optimum.magnitude) + Bounded::exact(2.0 * size));
    let direction = optimum.direction.map(|c| c.value);
    (gap - lost).is_positive().then(|| Proof::outside(direction, Rung::RoundedDirection))
}

/// The rung of a direction that is proved without rounding.
pub(in crate::collision) fn exact_rung(separation: &Separation<3>) -> Rung {
    match separation {
        Separation::Rounded(_) => Rung::DirectionOfDoubles,
        Separation::Exact(_) => Rung::RationalDirection,
    }
}

/// The proof from an exact direction u with u · p > h(u); `basis` has the generators to which u is known to be
/// orthogonal, `sum` is that of all others with the signs of their products with u.
pub(crate) fn separation(
    query: &dyn KernelQuery,
    p: &ExactVector,
    direction: &ExactVector,
    basis: &[usize],
    sum: &ExactVector,
) -> Separation<3> {
    let normal = match *basis {
        [first, second] => {
            let [first, second] = [first, second].map(|b| query.exact_generator(b));
            let normal = cross(&first, &second);
            // the same direction in smaller numbers: of integers, perhaps, that are doubles
            if dot(&normal, p).sign().is_lt() { negated(normal) } else { normal }
        }
        _ => direction.clone(),
    };
    let exponent = normal.iter().filter_map(Dyadic::binary_exponent).max().unwrap_or(0);
    let mut spanning = [[BoundedDoubleDouble::exact(0.0); 3]; 2];
    for (vector, &index) in spanning.iter_mut().zip(basis) {
        *vector = query.exact_generator(index).each_ref().map(BoundedDoubleDouble::of);
    }
    let beyond = Beyond {
        normal: normal.map(|c| BoundedDoubleDouble::of(&c.scaled(-exponent))),
        rest: difference(p, sum).each_ref().map(BoundedDoubleDouble::of),
        spanning,
    };
    match beyond.direction_of_doubles(query) {
        Some(direction) => Separation::Rounded(direction),
        None => Separation::Exact(Box::new(direction.clone().map(|v| v.to_rational()))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lad::of_generators::cells::reduced::Reduced;
    use crate::numeric::bounded;
    use crate::numeric::exact_linear::{exact, multiple};
    use crate::numeric::linear;
    use crate::zonotope::query::Query;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    /// The facet is of long generators that a rounded normal is not orthogonal to, and the gap is narrow.
    #[test]
    fn a_normal_of_integers_is_found_whatever_multiple_of_it_is_given() {
        let power = Dyadic::from_f64(3f64.powi(30));
        for (basis, scale) in [([0, 1], 1.0), ([1, 0], 1.0), ([0, 1], 2f64.powi(400)), ([1, 0], 2f64.powi(400))] {
            let body = [[5e6, -3e6, 0.0], [7e6, 0.0, -3e6], [3.0, 5.0, 7.0]].map(|v| v.map(|c: f64| scale * c));
            let p = body[2].map(|c| c * (1.0 + 4.0 * f64::EPSILON));
            let query = Query::new([0.0; 3], p, &body).expect("finite");
            let direction = multiple(&(&power * &power), &exact([3.0, 5.0, 7.0]));
            let sum = exact(body[2]);
            let found = separation(&query, &query.exact(), &direction, &basis, &sum);
            let Separation::Rounded(w) = found else { unreachable!("the normal is of doubles: {basis:?}") };
            let along = |v: &[f64; 3]| dot(&exact(*v), &exact(w));
            let reach = body.iter().fold(Dyadic::zero(), |sum, v| sum + along(v).abs());
            assert!(along(&p) > reach, "{w:?}");
            assert_eq!(exact_rung(&Separation::Rounded(w)), Rung::DirectionOfDoubles);
        }
    }

    #[test]
    fn the_direction_itself_separates_where_no_doubles_do() {
        let body = [[1e9, 3e8, 0.1], [0.3, 1e9, 7e8], [0.7, 0.1, 1.3]];
        let rows = body.map(exact);
        let normal = cross(&rows[0], &rows[1]);
        let u = if dot(&normal, &rows[2]).sign().is_lt() { negated(normal) } else { normal };
        let p = body[2].map(|c: f64| c * (1.0 + f64::EPSILON));
        let query = Query::new([0.0; 3], p, &body).expect("finite");
        if dot(&difference(&query.exact(), &rows[2]), &u).sign().is_gt() {
            let found = separation(&query, &query.exact(), &u, &[0, 1], &rows[2]);
            if let Separation::Exact(own) = &found {
                assert_eq!(**own, u.map(|c| c.to_rational()));
                assert_eq!(exact_rung(&found), Rung::RationalDirection);
            }
        }
    }

    /// Points beyond the facets of random bodies, by little or much; two generators have a small angle or a large one.
    #[test]
    fn directions_of_rounded_optima_separate_and_are_found_where_the_gap_is_not_narrow() {
        let random = &mut Pcg64Mcg::seed_from_u64(121);
        let mut count = 0;
        for round in 0..600 {
            let scale = [1.0, 1e-6, 1e6][round % 3];
            let mut vector = |size: f64| [0, 1, 2].map(|_| size * random.random_range(-1.0..1.0f64));
            let (a, small) = (vector(scale), vector([1.0, 1e-3][round / 3 % 2] * scale));
            let body = [a, [0, 1, 2].map(|k| a[k] + small[k]), vector(scale), vector(scale)];
            let u = linear::cross(&a, &body[1]);
            let beyond = 1.0 + [1e-16, 3e-16, 1e-15, 1e-13, 1e-9, 0.5][round / 6 % 6];
            let p = [0, 1, 2].map(|k| {
                let others = (2..4).map(|i| f64::copysign(1.0, linear::dot(&body[i], &u)) * body[i][k]).sum::<f64>();
                beyond * (others + 0.3 * a[k] - 0.2 * body[1][k])
            });
            let (query, bounded) = (Query::new([0.0; 3], p, &body).expect("finite"), bounded::exact(p));
            let Ok(optimum) = RoundedOptimum::at(&[Reduced::whole(&query)], &bounded, [0, 1]) else { continue };
            let found = in_doubles(&optimum, &bounded);
            if let Some(w) = found.as_ref().and_then(Proof::direction) {
                let along = |v: &[f64; 3]| dot(&exact(*v), &exact(w));
                let reach = body.iter().fold(Dyadic::zero(), |sum, v| sum + along(v).abs());
                assert!(along(&p) > reach, "{body:?} {p:?}");
                count += 1;
            } else {
                assert!(beyond < 1.0 + 1e-10, "{body:?} {p:?}");
            }
        }
        assert!(count > 200, "{count}");
        let cube = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let inside = Query::new([0.0; 3], [0.0, 0.0, 0.5], &cube).expect("finite");
        let p = bounded::exact([0.0, 0.0, 0.5]);
        let optimum = RoundedOptimum::at(&[Reduced::whole(&inside)], &p, [0, 1]).expect("below the top");
        assert!(in_doubles(&optimum, &p).is_none());
    }
}
