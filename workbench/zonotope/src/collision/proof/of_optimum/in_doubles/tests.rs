use super::*;
use crate::collision::{Location, by_lad};
use crate::interop::verifier::check_location;
use crate::lad::of_generators::cells::reduced::Reduced;
use crate::numeric::bounded;
use crate::numeric::linear::cross;
use crate::zonotope::Zonotope;
use crate::zonotope::pose::Pose;
use crate::zonotope::query::Query;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// The proof from the vertex of the first two generators, checked exactly.
fn prove(generators: &[[f64; 3]], p: [f64; 3]) -> Option<Witness> {
    let query = Query::new([0.0; 3], p, generators).expect("finite");
    let p = crate::numeric::bounded::exact(p);
    let optimum = RoundedOptimum::at(&[Reduced::whole(&query)], &p, [0, 1]).ok()?;
    let (member, _) = witness(&query, &optimum, &NestedCells::default(), &p)?;
    let witness = written(member, &query);
    assert!(check_location(&query, &Location::Inside(witness.clone())).is_right());
    Some(witness)
}

/// The coefficients of all generators.
fn written(member: Coefficients, query: &Query<'_, 3>) -> Witness {
    match Location::Inside(member).written(query) {
        Location::Inside(witness) => witness,
        other => unreachable!("{other:?}"),
    }
}

const BODY: [[f64; 3]; 6] =
    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.1, 1.0], [0.3, 0.0, 1.0], [0.1, -0.2, 1.0], [-0.2, 0.1, 0.7]];

#[test]
fn points_below_a_facet_are_proved() {
    let top = BODY[2..].iter().fold([0.0; 3], |sum, v| [0, 1, 2].map(|k| sum[k] + v[k]));
    for (x, y) in [(0.0, 0.0), (0.5, -0.25), (0.999, 0.0), (1.0, 1.0), (-1.0, 0.3)] {
        for factor in [0.5, 0.9, 1.0 - 1e-9] {
            let p = [top[0] + x, top[1] + y, top[2]].map(|c| c * factor);
            let witness = prove(&BODY, p).unwrap_or_else(|| panic!("{x} {y} {factor}"));
            assert!(witness.basis.len() == 3 && witness.basis[..2] == [0, 1], "{witness:?}");
        }
    }
}

#[test]
fn shares_of_a_facet_are_part_of_the_proof() {
    let body: Vec<[f64; 3]> = BODY.into_iter().chain([[1.0, 1.0, 0.0], [1.0, -1.0, 0.0], [0.3, 0.0, 0.0]]).collect();
    let top = BODY[2..].iter().fold([0.0; 3], |sum, v| [0, 1, 2].map(|k| sum[k] + v[k]));
    for (x, y) in [(0.0, 0.0), (2.5, 0.7), (-3.2, 0.1), (0.0, 2.9)] {
        let p = [top[0] + x, top[1] + y, top[2]].map(|c| c * 0.99);
        let witness = prove(&body, p).unwrap_or_else(|| panic!("{x} {y}"));
        assert!(witness.basis.iter().all(|index| *index < 6), "{witness:?}");
    }
}

#[test]
fn where_the_two_of_the_vertex_are_nearly_parallel_others_make_up_for_them() {
    let a = [1.0, 0.3, 0.1];
    let b = [a[0] + 0.2e-9, a[1] - 0.7e-9, a[2] + 0.4e-9];
    let normal = cross(&a, &b);
    let others = [[0.3, 0.6, 2.7], [0.0, 3.0, 0.3], [1.2, -0.9, 1.5], [-0.6, 1.8, 0.9]];
    let body: Vec<[f64; 3]> = [a, b].into_iter().chain(others).collect();
    let top = others.iter().fold([0.0; 3], |sum, v| {
        let sign = f64::copysign(1.0, dot(v, &normal));
        [0, 1, 2].map(|k| sum[k] + sign * v[k])
    });
    for factor in [0.5, 0.9, 1.0 - 1e-9] {
        let p = [0, 1, 2].map(|k| factor * (top[k] + 0.3 * a[k] - 0.2 * b[k]));
        let witness = prove(&body, p).unwrap_or_else(|| panic!("{factor}"));
        assert!(witness.basis.len() == 3, "{witness:?}");
    }
}

#[test]
fn points_outside_are_not() {
    assert!(prove(&BODY, [0.2, 0.0, 4.0]).is_none());
}

/// The optimum at the vertex of the first two generators, with the query.
fn optimum_at(query: &Query<'_, 3>, p: [f64; 3]) -> Option<crate::numeric::reused::ReusedBox<RoundedOptimum>> {
    RoundedOptimum::at(&[Reduced::whole(query)], &bounded::exact(p), [0, 1]).ok()
}

/// A body and a point below the facet of its first two, in whose plane there may be others.
fn below(random: &mut Pcg64Mcg, scale: f64, members: usize, factor: f64) -> (Vec<[f64; 3]>, [f64; 3]) {
    let mut vector = || [0, 1, 2].map(|_| scale * random.random_range(-1.0..1.0f64));
    let (a, b) = (vector(), vector());
    let others: Vec<[f64; 3]> = (0..4).map(|_| vector()).collect();
    let in_plane = [[1.0, 0.5], [-0.5, 1.0], [0.75, -0.25]];
    let of = |[s, t]: [f64; 2]| [0, 1, 2].map(|k| s * a[k] + t * b[k]);
    let normal = cross(&a, &b);
    let mut p = of([0.3 + 0.4 * members as f64, -0.2]);
    for v in &others {
        let sign = f64::copysign(1.0, dot(v, &normal));
        p = [0, 1, 2].map(|k| p[k] + sign * v[k]);
    }
    let shared = in_plane[..members].iter().map(|parts| of(*parts));
    ([a, b].into_iter().chain(others).chain(shared).collect(), p.map(|c| factor * c))
}

/// The coefficients of three vectors that make up a rest.
fn solved(basis: [&[f64; 3]; 3], rest: &[f64; 3]) -> [f64; 3] {
    let normals = cyclic_cross_products(basis[0], basis[1], basis[2]);
    let determinant = dot(basis[0], &normals[0]);
    normals.map(|normal| dot(rest, &normal) / determinant)
}

fn is_right(query: &Query<'_, 3>, witness: &Witness) -> bool {
    let exact = witness.clone().with_nearest_basis(query);
    let is_near = |(exact, own): (&f64, &f64)| (exact - own).abs() < 1e-6;
    exact.coefficients.iter().zip(&witness.coefficients).all(is_near)
        && check_location(query, &Location::Inside(exact)).is_right()
}

#[test]
fn an_attempt_has_the_margin_of_its_coefficients_and_is_proved_where_there_is_one() {
    let random = &mut Pcg64Mcg::seed_from_u64(141);
    let (mut proved, mut refused) = (0, 0);
    for round in 0..300 {
        let (scale, members) = ([1.0, 1e-5, 1e5][round % 3], round / 3 % 3);
        let inverse = [0.5, 0.9, 0.99][round / 9 % 3];
        let (body, p) = below(random, scale, members, inverse);
        let query = Query::new([0.0; 3], p, &body).expect("finite");
        let Some(optimum) = optimum_at(&query, p) else { continue };
        let bounded = bounded::exact(p);
        for index in 2..6 {
            let cells = NestedCells::default();
            let sign = cells.sign(&query, &optimum.cell(), index);
            let third = Third::new(&optimum, index, body[index], sign);
            for factor in [inverse, 0.5 * (1.0 + inverse), 1.0] {
                let attempt = third.attempt(&optimum, &bounded, factor);
                let sum = optimum.sum.map(|c| c.value);
                let rest = [0, 1, 2].map(|k| p[k] - factor * (sum[k] - sign * body[index][k]));
                let own = solved([&body[0], &body[1], &body[index]], &rest);
                let margin = 1.0 - own.iter().fold(0.0f64, |most, c| most.max(c.abs()));
                assert!((attempt.margin - margin).abs() < 1e-6 * (1.0 + margin.abs()), "{attempt:?} {margin}");
                assert_eq!((attempt.third, attempt.sign, attempt.factor), (index, sign, factor));
                let found = super::prove(&query, &optimum, &cells, &bounded, attempt);
                let found = found.map(|member| written(member, &query));
                if let Some(witness) = &found {
                    assert!(is_right(&query, witness), "{body:?} {p:?} {attempt:?}");
                    for (i, c) in [0, 1, index].into_iter().zip(own) {
                        assert!((witness.coefficients[i] - c).abs() < 1e-6, "{witness:?} {own:?}");
                    }
                }
                (proved, refused) = (proved + u32::from(found.is_some()), refused + u32::from(found.is_none()));
                assert!(margin.abs() < 1e-6 || found.is_some() == (margin > 0.0), "{margin} {found:?}");
            }
        }
    }
    assert!(proved > 300 && refused > 300, "{proved} {refused}");
}

#[test]
fn a_generator_in_the_plane_of_the_two_is_no_third_one() {
    let body = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.25, 0.0, 1.0], [1.0, 1.0, 0.0]];
    let p = [0.25, 0.0, 0.5];
    let query = Query::new([0.0; 3], p, &body).expect("finite");
    let optimum = optimum_at(&query, p).expect("below the facet");
    let third = Third::new(&optimum, 3, body[3], 1.0);
    assert_eq!(third.attempt(&optimum, &bounded::exact(p), 0.5).margin, 0.0);
}

/// The two of the vertex are nearly parallel, and there may be one more in their plane.
#[test]
fn three_others_make_up_for_what_two_nearly_parallel_ones_leave() {
    let random = &mut Pcg64Mcg::seed_from_u64(142);
    let mut found = [0, 0, 0];
    for round in 0..300 {
        let scale = [1.0, 1e-5, 1e5][round % 3];
        let size = [0.25, 0.25, 4.0][round / 3 % 3];
        let mut vector = |size: f64| [0, 1, 2].map(|_| scale * size * random.random_range(-1.0..1.0f64));
        let (a, small) = (vector(size), vector(1e-9));
        let b = [0, 1, 2].map(|k| a[k] + small[k]);
        let others = [vector(1.0), vector(1.0), vector(1.0), vector(1.0)];
        let mut body = [&[a, b][..], &others[..]].concat();
        let is_shared = round / 3 % 3 == 1;
        if is_shared {
            body.push([0, 1, 2].map(|k| 0.5 * a[k] - 0.25 * b[k]));
        }
        let normal = cross(&a, &small);
        let inverse = [0.5, 0.8][round % 2];
        let p = [0, 1, 2].map(|k| {
            let top = others.iter().map(|v| f64::copysign(1.0, dot(v, &normal)) * v[k]).sum::<f64>();
            inverse * (top + 0.3 * a[k] - 0.2 * b[k])
        });
        let query = Query::new([0.0; 3], p, &body).expect("finite");
        let Some(optimum) = optimum_at(&query, p) else { continue };
        let bounded = bounded::exact(p);
        for factor in [inverse, 0.9] {
            let own = prove_by_others(&query, &optimum, &NestedCells::default(), &bounded, factor);
            if let Some(witness) = own {
                assert!(is_right(&query, &witness), "{body:?} {p:?} {factor} {witness:?}");
                assert!(witness.basis.iter().all(|i| (2..6).contains(i)), "{witness:?}");
                found[round / 3 % 3] += 1;
            }
        }
    }
    assert!(found[0] > 60 && found[1] > 60, "{found:?}");
}

#[test]
fn three_vectors_make_up_a_rest_if_all_coefficients_are_within_their_ends() {
    for scale in [1.0, 1e-6, 1e6] {
        for (a, b) in [(0, 1), (1, 0)] {
            let mut rows = [[1.0, 0.25, 0.0], [0.0, 2.0, 0.5], [0.25, 0.0, 4.0]].map(|v| v.map(|c| scale * c));
            rows.swap(a, b);
            for parts in [[0.5, -0.25, 0.75], [-0.875, 0.999, -0.5]] {
                let of = |parts: [f64; 3]| {
                    bounded::exact([0, 1, 2].map(|k| (0..3).map(|i| parts[i] * rows[i][k]).sum::<f64>()))
                };
                let vectors = rows.map(bounded::exact);
                let own = solve(&vectors, &of(parts)).expect("all are within");
                assert!((0..3).all(|k| (own[k] - parts[k]).abs() < 1e-12), "{own:?} {parts:?}");
                for k in 0..3 {
                    for end in [1.0, -1.0, 1.5, -2.0] {
                        let mut beyond = parts;
                        beyond[k] = end;
                        assert_eq!(solve(&vectors, &of(beyond)), None, "{beyond:?}");
                    }
                }
                let dependent = [vectors[0], vectors[1], vectors[0]];
                assert_eq!(solve(&dependent, &of(parts)), None);
            }
        }
    }
}

/// Of more generators than a likely vertex is looked for, the cells of the search have the signs of products with the
/// direction of the vertex, and the proof is a rule; under a matrix it is written.
#[test]
fn near_the_boundary_of_many_generators_the_proof_is_a_rule() {
    let random = &mut Pcg64Mcg::seed_from_u64(143);
    let mut rules = 0;
    for round in 0..12 {
        let scale = [1.0, 1e-30, 1e30][round % 3];
        let mut vector = || [0, 1, 2].map(|_| scale * random.random_range(-1.0..1.0f64));
        let body: Vec<[f64; 3]> = (0..2000).map(|_| vector()).collect();
        let p = vector();
        let ray = Query::new([0.0; 3], p, &body).expect("finite");
        let factor = (1.0 - [1e-9, 1e-6, 1e-3][round / 3 % 3]) / by_lad::gauge(&ray, &mut ()).value;
        let p = p.map(|c| factor * c);
        let query = Query::new([0.0; 3], p, &body).expect("finite");
        let located = by_lad::located(&query, &mut ()).expect("the kernel answers in space");
        assert!(located.is_member());
        rules += usize::from(matches!(&located, Location::Inside(Coefficients::BySigns(_))));
        let written = located.written(&query);
        assert_eq!(check_location(&query, &written).proof().map(drop), Ok(()));
        let body = Zonotope::new([0.0; 3], body).expect("finite");
        let posed = Query::of_point_in(p, body.at(&Pose::IDENTITY)).expect("finite");
        let located = by_lad::located(&posed, &mut ()).expect("the kernel answers in space");
        assert!(matches!(&located, Location::Inside(Coefficients::Written(_))));
    }
    assert!(rules >= 11, "{rules}");
}
