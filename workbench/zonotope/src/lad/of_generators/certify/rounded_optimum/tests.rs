use super::*;
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::rational;
use crate::zonotope::query::Query;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Y: [f64; 3] = [0.0, 1.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];

fn at(generators: &[[f64; 3]], p: [f64; 3], cell: Option<DirectionCone>) -> Certified {
    let query = Query::new([0.0; 3], p, generators).expect("finite");
    let level = Reduced { cell, ..Reduced::whole(&query) };
    RoundedOptimum::at(&[level], &exact(p), [0, 1])
}

#[test]
fn a_facet_of_the_cube_worked_out_by_hand() {
    // the ray along (0.3, 0.2, 2) leaves [−1, 1]³ through its top at λ = 1/2
    let optimum = at(&[X, Y, Z], [0.3, 0.2, 2.0], None).expect("inside the top");
    assert!(optimum.is_vertex());
    assert_eq!((optimum.reach.value, optimum.along.value, optimum.reversed), (1.0, 2.0, false));
    assert_eq!(optimum.slack(f64::INFINITY), 0.0);
    let below = at(&[X, Y, Z], [0.3, 0.2, -2.0], None).expect("inside the bottom");
    assert!(below.reversed && below.along.value == 2.0);
}

#[test]
fn at_an_edge_the_gauge_is_between_two_bounds() {
    // (0.1 + 0.2, 0.1, 0.3) leaves the box of half-sides 1, 1, 1 at an edge, but for rounding
    let optimum = at(&[X, Y, Z], [0.1 + 0.2, 0.1, 0.3], None).expect("at an edge");
    let slack = optimum.slack(f64::INFINITY);
    assert!(!optimum.is_vertex() && slack > 0.0 && slack < 1e-13, "{slack}");
    assert!(optimum.slack(1e-3) < 2e-3 * slack);
}

#[test]
fn nearly_parallel_generators_leave_the_gauge_sharp() {
    let a = [1.0, 0.3, 0.1];
    let b = [a[0] + 0.2e-9, a[1] - 0.7e-9, a[2] + 0.4e-9];
    // u is about (0.19, −0.38, −0.76): Z and Y have a minus
    let p = [0, 1, 2].map(|k| 0.5 * (0.3 * a[k] - 0.2 * b[k] - Y[k] - Z[k]));
    let optimum = at(&[a, b, Y, Z], p, None).expect("between the two");
    assert!(!optimum.is_vertex() && optimum.excess == [f64::INFINITY; 2]);
    assert_eq!(optimum.slack(f64::INFINITY), f64::INFINITY);
    assert!(optimum.slack(1.0) < 1e-12, "{:e}", optimum.slack(1.0));
    let (gauge, error) = (optimum.along.value / optimum.reach.value, optimum.missing / optimum.reach.value);
    assert!((gauge - 0.5).abs() < 1e-9 && error < 1e-12, "{gauge} {error:e}");
}

#[test]
fn vertices_that_are_not_the_optimum_are_not_proved() {
    let failure = |p, cell| at(&[X, Y, Z], p, cell).map(|_| ()).expect_err("no proof");
    // the ray leaves through a side; p in the plane of the basis; a cell around another direction
    assert_eq!(failure([9.0, 0.0, 1.0], None), Unproved::Doubt);
    assert_eq!(failure([1.0, 1.0, 0.0], None), Unproved::Doubt);
    let elsewhere = DirectionCone { center: [1.0, 0.0, 0.0], axes: None, ball: 0.5 };
    assert_eq!(failure([0.1, 0.2, 1.0], Some(elsewhere)), Unproved::Astray(0));
}

#[test]
fn generators_of_the_facet_share_what_the_basis_cannot_make() {
    // the top of X, Y, Z, (1, 1, 0), (1, −1, 0) is an octagon: it holds (2, 1), not (5, 0)
    let body = [X, Y, Z, [1.0, 1.0, 0.0], [1.0, -1.0, 0.0]];
    let optimum = at(&body, [2.0, 1.0, 1.0], None).expect("in the octagon");
    assert_eq!(optimum.shares.iter().map(|(index, _)| *index).collect::<Vec<_>>(), [3, 4]);
    assert!(optimum.shares.iter().all(|(_, share)| share.abs() <= 1.0));
    assert!(optimum.excess.iter().all(|excess| *excess < 1e-12));
    // what the sum lacks to be a multiple of p is a combination of X and Y with coefficients in [−1, 1]
    let [x, y, z] = optimum.sum.map(|c| c.value);
    assert!(z == 1.0 && (2.0 - x).abs() <= 1.0 + 1e-12 && (1.0 - y).abs() <= 1.0 + 1e-12, "{x} {y}");
    assert!(matches!(at(&body, [5.0, 0.0, 1.0], None), Err(Unproved::Falls(_))));
}

/// The most by which a quotient of two positive numbers is off where these are off by at most their errors.
fn most_off(value: f64, a: Bounded, b: Bounded) -> Rational {
    let [a, a_off, b, b_off] = [a.value, a.error, b.value, b.error].map(rational);
    let most = (&a + &a_off) / (&b - &b_off) - rational(value);
    let least = rational(value) - (a - a_off) / (b + b_off);
    if most > least { most } else { least }
}

#[test]
fn a_quotient_is_off_by_at_most_its_bound_and_the_bound_is_not_much_more() {
    let random = &mut Pcg64Mcg::seed_from_u64(81);
    for round in 0..600 {
        let [a, b] = [0, 1].map(|i| {
            let value = [1.0, 1e-7, 1e6][(round / 3usize.pow(i)) % 3] * random.random_range(0.5..1.0f64);
            let part = [0.0, 1e-12, 0.3, 0.9][random.random_range(0..4)];
            Bounded { value, error: value * part }
        });
        // an error may be larger than what it is of
        let a = if round % 7 == 0 { Bounded { error: 50.0 * a.value, ..a } } else { a };
        let (value, error) = quotient(a, b);
        let off = most_off(value, a, b);
        assert!(off <= rational(error), "{a:?} {b:?} {value} {error}");
        let most = off + rational(4.0 * UNIT * value);
        assert!(rational(error) <= most * rational(1.0 + 1e-9), "{a:?} {b:?} {value} {error}");
    }
    for a in [0.0, 5e-324, 15e-324, 1e-310] {
        let (a, b) = (Bounded::exact(a), Bounded::exact(2.0));
        let (value, error) = quotient(a, b);
        assert!(most_off(value, a, b) <= rational(error) && error > 0.0, "{a:?}");
    }
}

#[test]
fn nothing_is_known_of_a_quotient_by_what_may_be_zero() {
    for b in [(1.0, 1.0), (1.0, 2.0), (0.0, 0.0), (1.0, f64::NAN), (f64::NAN, 0.0), (-1.0, 0.5)] {
        for a in [0.0, 1.0] {
            assert_eq!(quotient(Bounded::exact(a), Bounded { value: b.0, error: b.1 }).1, f64::INFINITY, "{b:?}");
        }
    }
}

/// The vertex at the top of the cube.
fn top() -> RoundedOptimum {
    RoundedOptimum {
        basis: [0, 1],
        vectors: [X, Y],
        reversed: false,
        direction: exact(Z),
        sum: exact(Z),
        shares: Reused::new(),
        shared: 0.0,
        reach: Bounded::exact(1.0),
        along: Bounded::exact(2.0),
        missing: 0.0,
        excess: [0.0; 2],
        rest: Rest::of_sure_optimum([0.0; 2]),
        magnitude: 3.0,
        relative_error: 0.0,
    }
}

/// The same with other numbers.
fn changed(along: [f64; 2], reach: [f64; 2], missing: f64) -> RoundedOptimum {
    let bounded = |[value, error]: [f64; 2]| Bounded { value, error };
    RoundedOptimum { along: bounded(along), reach: bounded(reach), missing, ..top() }
}

#[test]
fn the_gauge_is_within_its_bound_of_all_that_it_may_be() {
    for scale in [1.0, 1e-6, 1e6] {
        for slack in [0.0, 1e-9, 0.1, 3.0] {
            for (along, reach, missing) in [(0.0, 0.0, 0.0), (1e-9, 1e-8, 1e-9), (0.3, 0.2, 0.1), (0.0, 0.0, 0.25)] {
                let own = changed([3.0 * scale, 3.0 * scale * along], [2.0, 2.0 * reach], 2.0 * missing);
                let (value, error) = gauge(&own, slack);
                let largest = 1.5 * scale * (1.0 + along) / (1.0 - reach) * (1.0 + slack);
                let least = 1.5 * scale * (1.0 - along) / (1.0 + reach + missing);
                assert!(value - error <= least && value + error >= largest, "{value} {error} {least} {largest}");
                // h(u) may be less than g · u less what is missing, as far as the bound knows
                let widest = 1.5 * scale * (1.0 + along) / (1.0 - reach - missing) * (1.0 + slack);
                assert!(value + error <= widest * (1.0 + 1e-12), "{value} {error} {widest}");
            }
        }
    }
}

#[test]
fn the_order_of_the_gauge_and_one_is_told_where_no_bound_leaves_a_doubt() {
    let told = |along, reach, missing, slack, goal| order(&changed(along, reach, missing), slack, goal);
    for scale in [1.0, 1e-6, 1e6] {
        let own = |along: f64, reach: f64, off: f64, missing: f64, slack| {
            told([along * scale, off * scale], [reach * scale, off * scale], missing * scale, slack, Goal::Location)
        };
        assert_eq!(own(2.0, 1.5, 0.0, 0.0, 0.0), Some(Ordering::Greater));
        assert_eq!(own(2.0, 1.5, 0.2, 0.0, 9.0), Some(Ordering::Greater));
        assert_eq!(own(2.0, 1.5, 0.2, 0.2, 0.0), None);
        assert_eq!(own(2.0, 1.5, 0.3, 0.0, 0.0), None);
        assert_eq!(own(1.5, 2.0, 0.0, 0.0, 0.0), Some(Ordering::Less));
        assert_eq!(own(1.5, 2.0, 0.0, 0.4, 0.3), Some(Ordering::Less));
        assert_eq!(own(1.5, 2.0, 0.2, 0.0, 0.0), Some(Ordering::Less));
        assert_eq!(own(1.5, 2.0, 0.1, 0.0, 0.3), None);
        assert_eq!(own(1.5, 2.0, 0.0, 0.0, 0.4), None);
        assert_eq!(own(2.0, 2.0, 0.0, 0.0, 0.0), None);
    }
    for (off, is_known) in [(1e-14, true), (1e-9, false), (0.2, false)] {
        for along in [1e-3, 1.0, 1e3] {
            let order = told([along, off * along], [0.5 * along, 0.0], 0.0, 0.0, Goal::Gauge);
            assert_eq!(order, is_known.then_some(Ordering::Greater), "{off} {along}");
        }
    }
}

#[test]
fn a_slack_is_what_ends_or_a_rest_leave_of_the_gauge() {
    let mut optimum = top();
    optimum.vectors = [[1.0, -2.0, 1.0], [0.5, 0.0, 0.25]];
    let is_near = |own: f64, exact: f64| own >= exact && own <= exact * (1.0 + 1e-12);
    // no coefficient counts for more than the gauge of its generator, which is at most 1
    optimum.excess = [0.125, 0.25];
    optimum.rest.size = f64::INFINITY;
    assert!(is_near(optimum.slack(f64::INFINITY), 0.375));
    assert!(is_near(optimum.slack(0.125), 0.125 * 0.5 + 0.25 * 0.09375));
    optimum.relative_error = 0.125;
    assert!(is_near(optimum.slack(0.125), 1.25 * (0.125 * 0.5 + 0.25 * 0.09375)));
    // a rest of gauge 1/8, and a factor that may be a tenth more
    (optimum.excess, optimum.rest.size, optimum.rest.stretch) = ([f64::INFINITY; 2], 0.25, 0.1);
    assert!(is_near(optimum.slack(0.5), 1.125 * 1.1 - 1.0));
    (optimum.rest.size, optimum.rest.stretch) = (0.0, 0.5);
    assert!(is_near(optimum.slack(4.0), 0.5));
    (optimum.rest.size, optimum.rest.stretch) = (0.5, 0.0);
    assert!(is_near(optimum.slack(4.0), 2.0));
    // the smaller one counts
    optimum.excess = [0.5, 0.5];
    assert!(is_near(optimum.slack(4.0), 1.0));
}

#[test]
fn a_direction_between_two_vectors_is_nearly_orthogonal_to_both() {
    for scale in [1.0, 1e-3, 1e3] {
        let vectors = [[1.0, 0.0, 0.0], [1.0, 1e-6, 0.0]].map(|v| v.map(|c| scale * c));
        for noise in [1e-4, -1e-5] {
            let u = between(&vectors, [noise, 0.3 * noise, 2.0]);
            assert!(vectors.iter().all(|v| dot(v, &u).abs() < 1e-6 * noise.abs() + 1e-9 * scale), "{u:?}");
            assert!((u[2] - 2.0).abs() < 1e-9, "{u:?}");
        }
    }
}

#[test]
fn a_body_of_known_thickness_is_told_from_the_boundary() {
    let a = [1.0, 0.3, 0.1];
    let b = [a[0] + 0.2e-9, a[1] - 0.7e-9, a[2] + 0.4e-9];
    let body = [a, b, Y, Z];
    for (factor, told) in [(0.5, Ordering::Less), (1.5, Ordering::Greater)] {
        let p = [0, 1, 2].map(|k| factor * (0.3 * a[k] - 0.2 * b[k] - Y[k] - Z[k]));
        let query = Query::new([0.0; 3], p, &body).expect("finite");
        let optimum = at(&body, p, None).expect("between the two");
        assert!(optimum.is_near_vertex() && !optimum.is_vertex());
        for goal in [Goal::Location, Goal::Gauge] {
            let (order, slack) = compare(&query, &optimum, goal).expect("it is not near the boundary");
            assert!(order == told && (slack < 1e-11 || goal == Goal::Location), "{slack}");
        }
    }
    let top = at(&[X, Y, Z], [0.3, 0.2, 2.0], None).expect("inside the top");
    assert!(top.is_vertex() && !top.is_near_vertex());
    let edge = at(&[X, Y, Z], [0.1 + 0.2, 0.1, 0.3], None).expect("at an edge");
    assert!(!edge.is_near_vertex() && edge.rest.size < 1e-12, "{:?}", edge.rest);
    assert!(edge.rest.coefficients.iter().all(|c| c.abs() <= 1.0), "{:?}", edge.rest);
}

/// The exact quantities of the vertex of the first two generators.
struct Exact {
    reach: Dyadic,
    along: Dyadic,
    /// The coefficients of the two, times [`along`](Self::along).
    numerators: [Dyadic; 2],
}

fn exactly(body: &[[f64; 3]], p: [f64; 3]) -> Exact {
    let (rows, p): (Vec<ExactVector>, _) =
        (body.iter().map(|v| exact_linear::exact(*v)).collect(), exact_linear::exact(p));
    let normal = exact_linear::cross(&rows[0], &rows[1]);
    let is_reversed = exact_linear::dot(&normal, &p).sign().is_lt();
    let u = if is_reversed { exact_linear::negated(normal) } else { normal };
    let zero = [Dyadic::zero(), Dyadic::zero(), Dyadic::zero()];
    let sum = rows[2..].iter().fold(zero, |sum, v| match exact_linear::dot(v, &u).sign() {
        Ordering::Less => exact_linear::difference(&sum, v),
        _ => exact_linear::sum(&sum, v),
    });
    let duals = [exact_linear::cross(&rows[1], &p), exact_linear::cross(&p, &rows[0])];
    Exact {
        reach: exact_linear::dot(&sum, &u),
        along: exact_linear::dot(&p, &u),
        numerators: duals.map(|dual| exact_linear::dot(&sum, &dual).abs()),
    }
}

/// Points at the edges of facets, whose two generators have a small angle or a large one.
#[test]
fn coefficients_leave_their_ends_by_at_most_the_excess() {
    let random = &mut Pcg64Mcg::seed_from_u64(82);
    let (mut count, mut sure) = (0, 0);
    for round in 0..1500 {
        let mut vector = |size: f64| [0, 1, 2].map(|_| size * random.random_range(-1.0..1.0f64));
        let (a, small) = (vector(1.0), vector([1.0, 1e-2, 1e-3][round % 3]));
        let b = [0, 1, 2].map(|k| a[k] + small[k]);
        let body = [a, b, vector(1.0), vector(3.0), vector(1.0)];
        let signs = {
            let u = exact_linear::cross(&exact_linear::exact(a), &exact_linear::exact(b));
            body.map(|v| f64::from(exact_linear::dot(&exact_linear::exact(v), &u).sign() as i8))
        };
        let steps = f64::from(random.random_range(-30_i32..31));
        let end = 1.0 + UNIT * steps * steps.abs() * [4.0, 4e2, 4e3][round % 3];
        let p = [0, 1, 2].map(|k| 0.7 * ((2..5).map(|i| signs[i] * body[i][k]).sum::<f64>() + end * a[k] + 0.4 * b[k]));
        let Ok(own) = at(&body, p, None) else { continue };
        if own.is_near_vertex() {
            continue;
        }
        count += 1;
        let Exact { reach, along, numerators } = exactly(&body, p);
        for (bounded, exact) in [(own.reach, &reach), (own.along, &along), (own.support(), &reach)] {
            assert!((exact - &Dyadic::from_f64(bounded.value)).abs() <= Dyadic::from_f64(bounded.error));
        }
        for (excess, numerator) in own.excess.iter().zip(&numerators) {
            assert!(*numerator <= &along * &(Dyadic::one() + Dyadic::from_f64(*excess)), "{excess} {body:?} {p:?}");
            let exact = numerator.ratio(&along);
            assert!(*excess <= (exact - 1.0).max(0.0) + 1e-7, "{excess} {exact}");
        }
        sure += u32::from(own.is_vertex());
    }
    assert!(count > 1000 && sure > 50 && sure < count - 50, "{count} {sure}");
}

/// Directions near the vertex of two nearly parallel generators are no vertices: both count in the support value.
#[test]
fn the_support_value_is_known_of_a_direction_near_a_vertex() {
    let random = &mut Pcg64Mcg::seed_from_u64(83);
    let mut count = 0;
    for round in 0..300 {
        let mut vector = |size: f64| [0, 1, 2].map(|_| size * random.random_range(-1.0..1.0f64));
        let (a, small) = (vector(1.0), vector([1e-7, 1e-9, 1e-12][round % 3]));
        let body = [a, [0, 1, 2].map(|k| a[k] + small[k]), vector(1.0), vector(3.0)];
        let normal = crate::numeric::linear::cross(&a, &small);
        let p = [0, 1, 2].map(|k| {
            let others = (2..4).map(|i| f64::copysign(1.0, dot(&body[i], &normal)) * body[i][k]).sum::<f64>();
            others + 0.1 * (a[k] - body[1][k])
        });
        let Ok(own) = at(&body, p, None) else { continue };
        if !own.is_near_vertex() {
            continue;
        }
        count += 1;
        let u = exact_linear::exact(own.direction.map(|c| c.value));
        let along = |v: &[f64; 3]| exact_linear::dot(&exact_linear::exact(*v), &u).abs();
        let support = body.iter().fold(Dyadic::zero(), |sum, v| sum + along(v));
        let bound = own.support();
        assert!((&support - &Dyadic::from_f64(bound.value)).abs() <= Dyadic::from_f64(bound.error), "{body:?} {p:?}");
        let pair = (along(&body[0]) + along(&body[1])).to_f64();
        assert!(own.missing >= pair * (1.0 - 1e-15), "{} {pair}", own.missing);
        let terms = own.direction.iter().map(|c| c.value.abs()).sum::<f64>();
        assert!(own.missing <= 1.01 * pair + 40.0 * UNIT * terms, "{} {pair}", own.missing);
    }
    assert!(count > 100, "{count}");
}
