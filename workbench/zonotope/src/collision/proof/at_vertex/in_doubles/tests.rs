use super::*;
use crate::collision::brute_force;
use crate::interop::verifier::check_location;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{self, exact};
use crate::zonotope::Zonotope;
use crate::zonotope::location::Location;
use crate::zonotope::pose::Pose;
use crate::zonotope::query::Query;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// The proof that a pair gives, checked exactly.
fn proved(generators: &[[f64; 3]], p: [f64; 3], pair: [usize; 2]) -> Option<&'static str> {
    let query = Query::new([0.0; 3], p, generators).expect("finite");
    let location = location_by_pair(&query, &bounded::exact(p), pair)?.location.written(&query);
    assert_eq!(check_location(&query, &location).proof().map(drop), Ok(()), "{generators:?} {p:?} {pair:?}");
    Some(location.status().name())
}

#[test]
fn the_top_of_a_cube_worked_out_by_hand() {
    let cube = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    assert_eq!(proved(&cube, [0.3, 0.2, 0.999], [0, 1]), Some("inside"));
    assert_eq!(proved(&cube, [-0.3, -0.2, -0.999], [1, 0]), Some("inside"));
    assert_eq!(proved(&cube, [0.3, 0.2, 1.001], [0, 1]), Some("outside"));
    // the ray leaves through another side, and still the coefficients are in [−1, 1]
    assert_eq!(proved(&cube, [0.9, 0.0, 0.1], [0, 1]), Some("inside"));
    assert_eq!(proved(&cube, [0.3, 0.2, 1.0], [0, 1]), Some("boundary"));
    // beyond another side; a pair without a normal
    assert_eq!(proved(&cube, [1.2, 0.0, 0.1], [0, 1]), None);
    assert_eq!(proved(&cube, [0.3, 0.2, 0.5], [0, 0]), None);
}

#[test]
fn generators_of_a_facet_share_what_two_cannot_make_up_for() {
    let body = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 1.0, 0.0], [1.0, -1.0, 0.0], [0.3, 0.0, 0.0]];
    for (x, y) in [(0.0, 0.0), (2.5, 0.7), (-3.2, 0.1), (0.0, 2.9)] {
        for factor in [0.5, 1.0 - 1e-9] {
            assert_eq!(proved(&body, [x, y, 1.0].map(|c| factor * c), [0, 1]), Some("inside"), "{x} {y}");
        }
    }
    assert_eq!(proved(&body, [5.0, 0.0, 0.9], [0, 1]), None);
}

#[test]
fn a_body_that_is_thin_along_an_axis_is_as_good_as_another() {
    let body = [[1.0, 0.3, 1e-9], [0.2, -1.0, 2e-9], [0.1, 0.4, -7e-9], [-0.6, 0.5, 4e-9], [0.3, 0.8, 5e-9]];
    let answers = |factor: f64| {
        let p = [0.3, 0.1, 8e-9].map(|c| factor * c);
        let pairs = (0..5).flat_map(|i| (0..i).map(move |j| [i, j]));
        pairs.filter_map(|pair| proved(&body, p, pair)).collect::<Vec<_>>()
    };
    let gauge = brute_force::gauge(&Query::new([0.0; 3], [0.3, 0.1, 8e-9], &body).expect("finite")).value;
    assert_eq!(answers((1.0 - 1e-9) / gauge), ["inside"]);
    assert!(!answers((1.0 + 1e-9) / gauge).is_empty());
}

#[test]
fn no_pair_tells_what_is_not_so_and_the_best_one_tells_nearly_always() {
    let random = &mut Pcg64Mcg::seed_from_u64(9);
    let (mut asked, mut answered) = (0, 0);
    for round in 0..240 {
        let n = 3 + round % 9;
        let mut vector = || {
            let v = [0, 1, 2].map(|_| random.random_range(-1.0..1.0f64));
            if round % 2 == 0 { v } else { v.map(|c| (3.0 * c).round()) }
        };
        let (body, direction) = ((0..n).map(|_| vector()).collect::<Vec<_>>(), vector());
        let gauge = brute_force::gauge(&Query::new([0.0; 3], direction, &body).expect("finite")).value;
        if !(gauge > 0.0 && gauge < 1e9) {
            continue;
        }
        for factor in [0.7, 1.0 - 1e-9, 1.0, 1.0 + 1e-9, 1.4] {
            let p = direction.map(|c| c * (factor / gauge));
            let status = brute_force::locate(&Query::new([0.0; 3], p, &body).expect("finite")).status().name();
            let pairs = (0..n).flat_map(|i| (0..i).map(move |j| [i, j]));
            let answers: Vec<_> = pairs.filter_map(|pair| proved(&body, p, pair)).collect();
            assert!(answers.iter().all(|answer| *answer == status), "{answers:?} {status} {body:?} {p:?}");
            if factor != 1.0 {
                (asked, answered) = (asked + 1, answered + u32::from(!answers.is_empty()));
            }
        }
    }
    assert!(asked > 600 && answered * 100 > asked * 97, "{answered} of {asked}");
}

/// Generators that are parallel to others but for some ulps, and points that would be on a facet if they were.
#[test]
fn generators_that_are_nearly_of_the_facet_count_with_their_signs() {
    let random = &mut Pcg64Mcg::seed_from_u64(12);
    let mut found = 0;
    for round in 0..400 {
        let n = 3 + round % 4;
        let mut body: Vec<[f64; 3]> =
            (0..n).map(|_| [0, 1, 2].map(|_| f64::from(random.random_range(-3..4)))).collect();
        for i in 1..n {
            if random.random_range(0..2) == 0 {
                let factor = [-1.0, 1.0, 0.5][random.random_range(0..3)];
                body[i] = body[random.random_range(0..i)].map(|c| factor * c);
            }
        }
        let [i, j] = [random.random_range(0..n), random.random_range(0..n)];
        let u = cross(&body[i], &body[j]);
        let mut share = |v: &[f64; 3]| match dot(v, &u) {
            0.0 => f64::from(random.random_range(-2..3)) / 2.0,
            along => along.signum(),
        };
        let p = body.iter().fold([0.0; 3], |sum, v| minus(sum, -share(v), v));
        for v in &mut body {
            v[random.random_range(0..3)] += f64::from(random.random_range(-2..3)) * 7e-15;
        }
        let status = brute_force::locate(&Query::new([0.0; 3], p, &body).expect("finite")).status().name();
        for pair in (0..n).flat_map(|i| (0..i).map(move |j| [i, j])) {
            let answer = proved(&body, p, pair);
            assert!(answer.is_none_or(|answer| answer == status), "{answer:?} {status} {body:?} {p:?}");
            found += u32::from(answer.is_some());
        }
    }
    assert!(found > 400, "{found}");
}

/// Asserts that the sums of a query along a direction are off by no more than they may be.
fn check_sums(query: &dyn KernelQuery, u: &[f64; 3], magnitude: f64) {
    let n = query.len();
    let (sums, mut signs) = (Sums::of(&query.parts(), u), vec![]);
    sign_rule::write(&query.parts(), u, 1.0, &mut signs);
    assert_eq!(signs.len(), n);
    let zero = || [Dyadic::zero(), Dyadic::zero(), Dyadic::zero()];
    let (mut reach, mut sum, direction) = (Dyadic::zero(), zero(), exact(*u));
    let (mut sizes, mut length) = ([0.0; 3], 0.0);
    for (i, &sign) in signs.iter().enumerate() {
        let v = query.exact_generator(i);
        let along = exact_linear::dot(&v, &direction);
        let own = v.each_ref().map(|c| c.to_f64().abs());
        let terms = dot(&own, &u.map(f64::abs));
        assert!(sign.abs() == 1.0 && sign == sign_rule::sign(&query.parts(), u, i));
        assert!(along.to_f64().abs() < 1e-9 * terms || (sign > 0.0) == along.sign().is_gt(), "{i} {sign}");
        sum = exact_linear::sum(&sum, &exact_linear::multiple(&Dyadic::from_f64(sign), &v));
        reach = reach + along.abs();
        sizes = [0, 1, 2].map(|k| sizes[k] + own[k]);
        length += sum_norm(&query.vector(i).0);
    }
    let off = |value: f64, exact: &Dyadic| (exact - &Dyadic::from_f64(value)).abs().to_f64();
    let additions = UNIT * (n / 2 + 16) as f64;
    assert!(off(sums.reach, &reach) <= (additions * sums.reach + 4.0 * UNIT * sums.terms) * LONG_SUM, "{n}");
    for k in 0..3 {
        // seven roundings and no more for the matrix
        assert!(off(sums.sum[k], &sum[k]) <= (additions + 8.0 * UNIT) * sums.sizes[k] * LONG_SUM, "{k} {n}");
        assert!(sums.sizes[k] >= sizes[k] * (1.0 - 1e-12), "{k} {n}");
    }
    let least = dot(&sizes, &u.map(f64::abs)) * (1.0 - 1e-12);
    assert!(sums.terms >= least, "{n}");
    if magnitude == 0.0 {
        assert!(sums.terms <= least * (1.0 + 1e-11), "{n}");
        assert!((0..3).all(|k| sums.sizes[k] <= sizes[k] * (1.0 + 1e-12)), "{n}");
    } else {
        assert!(sums.terms <= 40.0 * magnitude * length * sum_norm(u), "{n}");
        assert!(sum_norm(&sums.sizes) <= 40.0 * length, "{n}");
    }
}

#[test]
fn sums_of_bodies_at_rest_and_under_matrices_are_within_their_bounds() {
    let random = &mut Pcg64Mcg::seed_from_u64(31);
    let turned = Pose::from_axis_angle([1.0, -2.0, 0.5], 0.7, [0.0; 3]).expect("an axis");
    let stretched = Pose::new([[2.0, 0.3, 0.0], [-0.2, 0.9, 0.4], [0.1, 0.0, 1.3]], [0.0; 3]).expect("finite");
    let still = Pose::IDENTITY;
    for (round, counts) in [(3, 0), (7, 5), (8, 16), (21, 35), (1, 40)].into_iter().cycle().take(30).enumerate() {
        let scale = [1e-6, 1.0, 1e5][round % 3];
        let mut vector = |size: f64| [0, 1, 2].map(|_| size * random.random_range(-1.0..1.0f64));
        let mut body = |n: usize| {
            let rows = (0..n).map(|_| vector(scale)).collect::<Vec<_>>();
            Zonotope::new([0.0; 3], rows).expect("finite")
        };
        let (first, second) = (body(counts.0), body(counts.1));
        let u = vector([1e3, 1.0, 1e-7][round / 3 % 3]);
        let poses = [[&still, &still], [&still, &stretched], [&turned, &still], [&stretched, &turned]];
        for (i, [own, other]) in poses.into_iter().enumerate() {
            let query = Query::of_placed(first.at(own), second.at(other));
            check_sums(&query, &u, if i == 0 { 0.0 } else { 1.0 });
        }
        check_sums(&Query::between(&first, &second), &u, 0.0);
    }
}

/// A prism over a square, with some generators that lean.
fn leaning(n: usize) -> Vec<[f64; 3]> {
    let mut body = vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    body.extend((0..n).map(|i| [0.25, if i % 2 == 0 { 0.5 } else { -0.5 }, 1.0]));
    body
}

#[test]
fn a_gap_of_one_rounding_for_each_generator_is_enough() {
    let body = leaning(1024);
    let gap = 1024.0 * (1.0 + 1026.0 * UNIT);
    let query = Query::new([0.0; 3], [0.0, 0.0, gap], &body).expect("finite");
    let proof = location_by_pair(&query, &bounded::exact([0.0, 0.0, gap]), [0, 1]).expect("it is beyond the facet");
    assert_eq!(proof.rung, Rung::RoundedDirection);
    assert_eq!(proof.direction(), Some([0.0, 0.0, 1.0]));
}

#[test]
fn what_is_lost_of_a_sum_separates_nothing() {
    // of all but the first eight of the others the sum of doubles has nothing
    let mut body = vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    body.extend([[0.0, 0.0, 1.0]; 14]);
    body.extend([[0.0, 0.0, 0.49 * f64::EPSILON]; 1200]);
    for height in [14.0 + 16.0 * f64::EPSILON, 14.0 + 80.0 * f64::EPSILON] {
        let query = Query::new([0.0; 3], [0.0, 0.0, height], &body).expect("finite");
        let proof = location_by_pair(&query, &bounded::exact([0.0, 0.0, height]), [0, 1]);
        assert!(proof.is_none_or(|proof| proof.location.is_member()), "{height}");
    }
}

#[test]
fn a_generator_that_hardly_counts_has_a_coefficient_as_well() {
    for scale in [8.0, 1024.0] {
        let speck = [0.0, 0.0, 2f64.powi(-40)];
        let body = [[scale, 0.0, 0.0], [0.0, scale, 0.0], [0.0, 0.0, scale], speck, speck];
        for p in [[0.0, 0.0, 0.5 * scale], [0.3 * scale, -0.2 * scale, 0.75 * scale]] {
            assert_eq!(proved(&body, p, [0, 1]), Some("inside"), "{scale} {p:?}");
        }
    }
}

/// Points whose coefficient of a generator of the facet is 1 but for some roundings, of the rest that a sum of many
/// generators leaves.
#[test]
fn points_near_the_edge_of_a_facet_are_not_taken_for_members() {
    let random = &mut Pcg64Mcg::seed_from_u64(33);
    let mut count = 0;
    for round in 0..160 {
        let scale = [1.0, 2f64.powi(-30)][round % 2];
        let (n, most) = [(6, 12), (400, 1500)][round / 2 % 2];
        let mut vector = |axis: usize| {
            [0, 1, 2].map(|k| scale * (random.random_range(0.0..0.2) + if k == axis { 1.0 } else { 0.0 }))
        };
        let body: Vec<[f64; 3]> = (0..n).map(|i| vector(i.min(2))).collect();
        let sum = body[2..].iter().fold([0.0; 3], |sum, v| [0, 1, 2].map(|k| sum[k] + v[k]));
        let below = 1.0 - 1e-9;
        let end = 1.0 + UNIT * f64::from(random.random_range(-most..most));
        let p = [0, 1, 2].map(|k| below * (sum[k] + 0.9 * body[1][k]) + end * body[0][k]);
        count += u32::from(proved(&body, p, [0, 1]).is_some());
        let p = [0, 1, 2].map(|k| below * (sum[k] + 0.9 * body[1][k]) + (1.0 - 1e-6) * body[0][k]);
        count += u32::from(proved(&body, p, [0, 1]) == Some("inside"));
    }
    assert!(count >= 160, "{count}");
}

/// The answer of the facet of a pair, that a point is below.
fn below<T>(
    body: &[[f64; 3]],
    p: [f64; 3],
    pair: [usize; 2],
    ask: impl FnOnce(&Facet<'_>, &mut [f64]) -> Option<T>,
) -> Option<T> {
    let query = Query::new([0.0; 3], p, body).expect("finite");
    let vectors = Vectors::of(&query).expect("it has no matrix");
    let product = cross(&body[pair[0]], &body[pair[1]]);
    let sign = f64::copysign(1.0, dot(&product, &p));
    let u = product.map(|c| sign * c);
    let (sums, mut signs) = (Sums::of(&vectors.parts, &u), vec![]);
    sign_rule::write(&vectors.parts, &u, 1.0, &mut signs);
    let bounded = bounded::exact(p);
    let sizes = [0, 1, 2].map(|k| sums.sizes[k] + p[k].abs());
    let errors = SumErrors { p: &bounded, sizes, count: body.len() };
    let factor = dot(&p, &u) / sums.reach;
    ask(&Facet { vectors: &vectors, p, pair, u, sum: sums.sum, factor, errors: &errors }, &mut signs)
}

/// Whether there is a proof, checked exactly, that a point is inside.
fn is_right(body: &[[f64; 3]], p: [f64; 3], proof: Option<Proof>) -> bool {
    let query = Query::new([0.0; 3], p, body).expect("finite");
    proof.is_some_and(|proof| {
        assert!(matches!(proof.location, Location::Inside(_)));
        assert_eq!(check_location(&query, &proof.location.written(&query)).proof().map(drop), Ok(()), "{body:?} {p:?}");
        true
    })
}

#[test]
fn the_two_of_a_facet_make_up_for_what_is_in_its_plane() {
    let body = [&leaning(20)[..], &[[0.25, 0.0, 0.0]]].concat();
    for (x, y) in [(0.0, 0.0), (0.75, -0.5), (-0.7, 0.9)] {
        for factor in [0.5, 0.9, 1.0 - 1e-9] {
            let p = [5.25 + x, y, 20.0].map(|c| factor * c);
            let proof = below(&body, p, [0, 1], |facet, _| facet.combined_by_pair());
            assert!(is_right(&body, p, proof), "{x} {y} {factor}");
        }
    }
    let beside = [5.25 + 1.5, 0.0, 20.0].map(|c| 0.9 * c);
    assert!(below(&body, beside, [0, 1], |facet, _| facet.combined_by_pair()).is_none());
}

/// The plane of the facet holds an axis or none of the axes, and the two of the pair are short.
#[test]
fn all_generators_of_a_slanted_facet_share_what_is_in_its_plane() {
    let random = &mut Pcg64Mcg::seed_from_u64(34);
    for axis in 0..4 {
        for scale in [1.0, 2f64.powi(-30)] {
            let mut found = 0;
            for _ in 0..20 {
                let mut vector = || [0, 1, 2].map(|_| random.random_range(-1.0..1.0f64));
                let (mut first, mut second) = (vector(), vector());
                if axis < 3 {
                    first = [0, 1, 2].map(|k| if k == axis { 1.0 } else { 0.0 });
                    second[axis] = 0.0;
                }
                let others: Vec<[f64; 3]> = (0..4).map(|_| vector().map(|c| scale * c)).collect();
                let mut in_plane = |size: f64| {
                    let [s, t] = [0, 1].map(|_| size * scale * random.random_range(-1.0..1.0f64));
                    [0, 1, 2].map(|k| s * first[k] + t * second[k])
                };
                let mut body = vec![in_plane(0.02), in_plane(0.02)];
                body.extend((0..6).map(|_| in_plane(1.0)));
                let share = [0.8, -0.8, 0.4, 0.8, -0.4, 0.8, -0.8, 0.8];
                let u = cross(&body[0], &body[1]);
                let mut p = (0..8).fold([0.0; 3], |sum, i| minus(sum, -share[i], &body[i]));
                p = others.iter().fold(p, |sum, v| minus(sum, -f64::copysign(1.0, dot(v, &u)), v));
                body.extend(others);
                let p = p.map(|c| 0.9 * c);
                let proof = below(&body, p, [0, 1], |facet, signs| facet.combined_by_shares(signs));
                found += u32::from(is_right(&body, p, proof));
            }
            assert!(found >= 15, "{axis} {scale} {found}");
        }
    }
}

#[test]
fn nothing_is_shared_by_a_facet_of_whose_pair_doubles_do_not_know_that_it_is_theirs() {
    let (a, zero) = ([0.3, 0.7, -0.2], [0.0; 3]);
    for step in [1e-11, -3e-12, 7e-13] {
        let b = [a[0] + step, a[1] - 0.3 * step, a[2] + 0.7 * step];
        let body = [a, b, zero, zero, zero, [0.1, 0.5, 0.9], [-0.7, 0.2, 0.4], [0.9, 0.1, 0.3]];
        let u = cross(&a, &b);
        let others = body[5..].iter().fold([0.0; 3], |sum, v| minus(sum, -f64::copysign(1.0, dot(v, &u)), v));
        for share in [-1.5, -0.5, 0.5, 1.5] {
            let p = [0, 1, 2].map(|k| 0.9 * (others[k] + share * a[k] + 0.2 * b[k]));
            let proof = below(&body, p, [0, 1], |facet, signs| facet.combined_by_shares(signs));
            assert!(proof.is_none(), "{step} {share}");
        }
    }
}
