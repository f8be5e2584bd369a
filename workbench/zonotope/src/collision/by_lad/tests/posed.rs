//! Queries about posed bodies against exact arithmetic on the images of their generators.

use crate::collision::by_lad::locate;
use crate::collision::{Location, Query, Separation, Status, by_lad};
use crate::lad::of_generators::seam::generators::Generators;
use crate::numeric::Rational;
use crate::numeric::bounded::Bounded;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, cross, cyclic_cross_products, dot, exact, is_zero};
use crate::zonotope::Zonotope;
use crate::zonotope::pose::Pose;
use proptest::prelude::*;

/// The images of all generators, exactly.
fn images(query: &Query<'_, 3, Pose>) -> Vec<ExactVector> {
    let images = query.parts().iter().map(|body| {
        let image = |v: &[f64; 3]| body.standing().exact_image(&exact(*v));
        body.generators().iter().map(image).collect::<Vec<_>>()
    });
    images.flatten().collect()
}

/// h(u), exactly.
fn support(images: &[ExactVector], u: &ExactVector) -> Dyadic {
    images.iter().fold(Dyadic::zero(), |sum, v| sum + dot(v, u).abs())
}

/// The status by every facet normal, for images that span space.
fn truth(images: &[ExactVector], p: &ExactVector) -> Option<&'static str> {
    let mut spans = false;
    let mut status = "inside";
    for (i, a) in images.iter().enumerate() {
        for b in &images[..i] {
            let normal = cross(a, b);
            if is_zero(&normal) {
                continue;
            }
            let reach = support(images, &normal);
            spans |= !reach.is_zero();
            match dot(p, &normal).abs().cmp(&reach) {
                std::cmp::Ordering::Greater => status = "outside",
                std::cmp::Ordering::Equal if status == "inside" => status = "boundary",
                _ => {}
            }
        }
    }
    spans.then_some(status)
}

/// Whether the proof holds, in exact rationals.
pub(in crate::collision) fn check_proof(query: &Query<'_, 3, Pose>, location: &Location<3>) {
    let (images, p) = (images(query), query.exact());
    match location {
        Location::Outside(separation) => {
            let u: [Rational; 3] = match separation {
                Separation::Rounded(u) => u.map(|c| Rational::try_from(c).expect("finite")),
                Separation::Exact(u) => *u.clone(),
            };
            let along = |v: &ExactVector| (0..3).fold(Rational::ZERO, |sum, k| sum + v[k].to_rational() * &u[k]);
            let reach = images.iter().fold(Rational::ZERO, |sum, v| {
                let own = along(v);
                sum + if own < Rational::ZERO { -own } else { own }
            });
            assert!(along(&p) > reach, "{u:?} does not separate");
        }
        Location::Inside(witness) | Location::Boundary(witness) => {
            assert!(witness.coefficients.iter().all(|c| c.abs() <= 1.0));
            assert_eq!(witness.coefficients.len(), images.len());
            let off = |i: &usize| !witness.basis.contains(i);
            let rest = (0..images.len()).filter(off).fold(p.clone(), |rest, i| {
                let c = Dyadic::from_f64(witness.coefficients[i]);
                [0, 1, 2].map(|k| &rest[k] - &(&c * &images[i][k]))
            });
            let solved = match witness.basis[..] {
                [] => is_zero(&rest),
                [a, b, c] => {
                    let normals = cyclic_cross_products(&images[a], &images[b], &images[c]);
                    let determinant = dot(&images[a], &normals[0]).abs();
                    !determinant.is_zero() && normals.iter().all(|normal| dot(&rest, normal).abs() <= determinant)
                }
                [a, b] => {
                    let normal = cross(&images[a], &images[b]);
                    let [first, second] = [cross(&images[b], &normal), cross(&normal, &images[a])];
                    let determinant = dot(&normal, &normal);
                    dot(&rest, &normal).is_zero()
                        && [first, second].iter().all(|dual| dot(&rest, dual).abs() <= determinant)
                }
                [a] => {
                    let square = dot(&images[a], &images[a]);
                    is_zero(&cross(&rest, &images[a])) && dot(&rest, &images[a]).abs() <= square
                }
                _ => panic!("a basis of {} generators", witness.basis.len()),
            };
            assert!(solved, "the coefficients do not combine to the displacement");
        }
    }
}

fn check(query: &Query<'_, 3, Pose>) {
    let (images, p) = (images(query), query.exact());
    let location = locate(query, &mut ());
    let gauge = by_lad::gauge(query, &mut ());
    if let Some(status) = truth(&images, &p) {
        assert_eq!(location.status().name(), status);
        let scale = Dyadic::from_f64(gauge.value);
        // p is outside of a body a little smaller than gauge times this one, and inside of one a little larger
        if gauge.value.is_finite() && gauge.value > 0.0 && gauge.error < 1e-6 * gauge.value {
            let times = |factor: f64| {
                let factor = &scale * &Dyadic::from_f64(factor);
                images.iter().map(|v| v.each_ref().map(|c| c * &factor)).collect::<Vec<_>>()
            };
            assert_eq!(truth(&times(1.0 + 1e-9), &p), Some("inside"));
            assert_eq!(truth(&times(1.0 - 1e-9), &p), Some("outside"));
        }
    }
    assert_eq!(gauge.location.status(), location.status());
    check_proof(query, &location);
    check_proof(query, &gauge.location);
}

fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![3 => -1.0..1.0f64, 2 => (-2i32..3).prop_map(f64::from), 1 => Just(1e-9), 1 => Just(1e9)]
}

fn vector() -> impl Strategy<Value = [f64; 3]> {
    proptest::array::uniform3(coordinate())
}

fn body() -> impl Strategy<Value = Zonotope<3>> {
    (vector(), proptest::collection::vec(vector(), 0..5))
        .prop_map(|(center, generators)| Zonotope::new(center, generators).expect("finite"))
}

/// Rotations, quarter turns, mirrors, shears and matrices that flatten.
fn pose() -> impl Strategy<Value = Pose> {
    let rotation = (proptest::array::uniform4(-1.0..1.0f64), vector())
        .prop_map(|(q, t)| Pose::from_quaternion(q, t).unwrap_or_default());
    let quarters = (0usize..6, vector()).prop_map(|(i, t)| {
        let rows = [[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]];
        Pose::new([rows[i % 3], rows[(i + 1) % 3], rows[(i + 2) % 3]], t).expect("finite")
    });
    let any = (proptest::array::uniform3(vector()), vector()).prop_map(|(m, t)| Pose::new(m, t).expect("finite"));
    prop_oneof![4 => rotation, 2 => quarters, 1 => any, 1 => Just(Pose::IDENTITY)]
}

properties! {
    #![proptest_config(crate::property_cases::config(400))]

    #[test]
    fn posed_bodies_meet_as_exact_arithmetic_has_it(a in body(), b in body(), from in pose(), to in pose()) {
        check(&Query::of_placed(a.at(&from), b.at(&to)));
    }

    #[test]
    fn a_point_is_where_it_is_in_a_posed_body(a in body(), from in pose(), point in vector(), share in vector()) {
        check(&Query::of_point_in(point, a.at(&from)).expect("finite"));
        // and near the image of a combination of the generators
        let near = a.generators().iter().zip(share.iter().cycle()).fold(from.exact_point(a.center()), |sum, (v, s)| {
            let image = from.exact_image(&exact(*v));
            let factor = Dyadic::from_f64(s.clamp(-1.0, 1.0));
            [0, 1, 2].map(|k| &sum[k] + &(&factor * &image[k]))
        });
        check(&Query::of_point_in(near.map(|c| c.to_f64()), a.at(&from)).expect("finite"));
    }
}

#[test]
fn many_generators_under_rotations() {
    use rand::{RngExt, SeedableRng};
    let random = &mut rand_pcg::Pcg64Mcg::seed_from_u64(3);
    for n in [40, 200, 700] {
        let mut body = || {
            let generators = (0..n).map(|_| [0, 1, 2].map(|_| random.random_range(-1.0..1.0f64))).collect();
            Zonotope::new([0.0; 3], generators).expect("finite")
        };
        let (a, b) = (body(), body());
        for i in 0..12 {
            let angle = f64::from(i);
            let from = Pose::from_axis_angle([1.0, 2.0, angle], angle, [0.0; 3]).expect("an axis");
            // from far inside, through near contact, to far outside
            let at = [0.1, 0.5, 1.0, 1.0 + 1e-9, 1.5, 4.0][i as usize % 6];
            let turned = Pose::from_axis_angle([0.0, 1.0, 0.3], 2.0 * angle, [0.0; 3]).expect("an axis");
            let unit = Query::of_placed(a.at(&from), b.at(&Pose::from_translation([1.0, 0.5, -0.3]).expect("finite")));
            let gauge = by_lad::gauge(&unit, &mut ()).value;
            let distance = [1.0, 0.5, -0.3].map(|c| c * at / gauge);
            let to = Pose::new(turned.matrix(), distance).expect("finite");
            let query = Query::of_placed(a.at(&from), b.at(&to));
            check_proof(&query, &locate(&query, &mut ()));
            check_proof(&query, &by_lad::gauge(&query, &mut ()).location);
        }
    }
}

#[test]
fn the_identity_answers_as_no_pose_does() {
    let cube = Zonotope::new([0.0; 3], vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]).expect("finite");
    for at in [0.5, 2.0, 2.0 + f64::EPSILON * 2.0] {
        let other = Zonotope::new([at, 0.0, 0.0], cube.generators().to_vec()).expect("finite");
        let posed = Query::of_placed(cube.at(&Pose::IDENTITY), other.at(&Pose::IDENTITY));
        assert_eq!(locate(&posed, &mut ()).status(), locate(&Query::between(&cube, &other), &mut ()).status());
    }
}

/// A matrix of whole numbers and powers of two, which turns small whole numbers into others without rounding.
fn exact_matrix(kind: usize, mut random: impl FnMut() -> i32) -> [[f64; 3]; 3] {
    let mut signed = |size: f64| if random() < 0 { -size } else { size };
    match kind % 3 {
        0 => {
            let [a, b, c] = [signed(1.0), signed(1.0), signed(1.0)];
            [[0.0, a, 0.0], [0.0, 0.0, b], [c, 0.0, 0.0]]
        }
        1 => {
            let [a, b, c] = [signed(0.125), signed(4.0), signed(1.0)];
            [[a, 0.0, 0.0], [0.0, b, 0.0], [0.0, 0.0, c]]
        }
        _ => [0, 1, 2].map(|_| [0, 1, 2].map(|_| f64::from(random()))),
    }
}

/// Under matrices that round nothing, posed bodies are where the bodies of the images of their generators are.
#[test]
fn exact_matrices_answer_as_images_do() {
    use rand::{RngExt, SeedableRng};
    let random = &mut rand_pcg::Pcg64Mcg::seed_from_u64(11);
    for n in [3, 7, 20, 100, 400] {
        let mut seen = [0; 3];
        for i in 0..60 {
            let mut row = || [0, 1, 2].map(|_| f64::from(random.random_range(-1000..=1000)));
            let [first, second]: [Vec<_>; 2] = [(0..n).map(|_| row()).collect(), (0..n).map(|_| row()).collect()];
            let matrices = [i, i / 3].map(|kind| exact_matrix(kind, || random.random_range(-3..=3)));
            let image = |m: &[[f64; 3]; 3], v: &[f64; 3]| m.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2]);
            let images = [(&matrices[0], &first), (&matrices[1], &second)]
                .map(|(m, rows)| rows.iter().map(|v| image(m, v)).collect::<Vec<_>>());
            // from deep inside through the boundary, a vertex or an edge, to far outside
            let u = [0, 1, 2].map(|_| random.random_range(-1.0..1.0f64));
            let vertex = images.iter().flatten().fold([0.0; 3], |sum, v| {
                let sign = f64::copysign(1.0, v[0] * u[0] + v[1] * u[1] + v[2] * u[2]);
                [0, 1, 2].map(|k| sum[k] + sign * v[k])
            });
            let factor = [0.125, 0.5, 0.75, 1.0, 1.25, 4.0][i % 6];
            let p = vertex.map(|c| factor * c);
            let center = [5.0, -7.0, 11.0];
            let [a, b] = [first, second].map(|rows| Zonotope::new(center, rows).expect("finite"));
            let from = Pose::new(matrices[0], [0.0; 3]).expect("finite");
            let [start, end] = [image(&matrices[0], &center), image(&matrices[1], &center)];
            let to = Pose::new(matrices[1], [0, 1, 2].map(|k| p[k] + start[k] - end[k])).expect("finite");
            let posed = Query::of_placed(a.at(&from), b.at(&to));
            let all = images.concat();
            let plain = Query::new([0.0; 3], p, &all).expect("finite");
            let location = locate(&posed, &mut ());
            assert_eq!(location.status(), locate(&plain, &mut ()).status(), "{n} {i}");
            check_proof(&posed, &location);
            seen[Status::ALL.iter().position(|status| *status == location.status()).expect("a status")] += 1;
        }
        assert!(seen.iter().all(|count| *count > 0), "{n} {seen:?}");
    }
}

/// Matrices that flatten, and those of sizes at both ends of the range of doubles.
#[test]
fn extreme_matrices_are_answered_exactly() {
    let rotation = Pose::from_axis_angle([1.0, 2.0, -2.0], 0.7, [0.0; 3]).expect("an axis").matrix();
    let scaled = |size: f64| rotation.map(|row| row.map(|c| size * c));
    let tiny = f64::from_bits(1);
    let matrices = [
        [[0.0; 3]; 3],
        [[1.0, 2.0, 3.0], [2.0, 4.0, 6.0], [0.5, 1.0, 1.5]],
        [[1.0, 0.0, 1.0], [0.0, 1.0, 1.0], [0.0, 0.0, 0.0]],
        [[1.0, 1.0, 1.0], [1.0, 1.0 + f64::EPSILON, 1.0], [1.0, 1.0, 1.0 - f64::EPSILON]],
        scaled(1e-18),
        scaled(1e18),
        scaled(1e-200),
        scaled(1e300),
        scaled(3e-308),
        [[tiny, 0.0, 0.0], [0.0, tiny, 0.0], [0.0, 0.0, tiny]],
        [[f64::MAX, 0.0, 0.0], [0.0, tiny, 0.0], [0.0, 0.0, 1.0]],
        rotation,
    ];
    let generators = [[1.0, 0.0, 0.0], [0.25, 1.0, 0.0], [0.0, -0.5, 1.0], [1.0, 1.0, 0.3]];
    let body = |size: f64| Zonotope::new([size, 0.0, 0.0], generators.map(|v| v.map(|c| size * c)).to_vec());
    for (i, matrix) in matrices.iter().enumerate() {
        let from = Pose::new(*matrix, [0.0; 3]).expect("finite");
        for size in [1.0, 1e-300, 1e150] {
            let a = body(size).expect("finite");
            for other in [matrices[i], rotation, matrices[(i + 4) % matrices.len()]] {
                for factor in [0.0, 0.3, 1.0, 3.0] {
                    let t = from.exact_image(&exact([1.0, 0.25, -0.5])).map(|c| factor * size * c.to_f64());
                    let to = Pose::new(other, t.map(|c| c.clamp(f64::MIN, f64::MAX))).expect("finite");
                    check(&Query::of_placed(a.at(&from), a.at(&to)));
                }
            }
        }
    }
}

properties! {
    #[test]
    fn support_values_of_posed_rows_keep_their_bounds(
        a in body(), b in body(), from in pose(), to in pose(), u in vector()
    ) {
        let query = Query::of_placed(a.at(&from), b.at(&to));
        let truth = support(&images(&query), &exact(u));
        let holds = |value: Bounded| {
            (Dyadic::from_f64(value.value) - truth.clone()).abs() <= Dyadic::from_f64(value.error)
        };
        prop_assert!(holds(query.support(&u)));
        if query.is_moderate() {
            for (i, image) in images(&query).iter().enumerate() {
                let (v, length) = query.vector(i);
                let error = Dyadic::from_f64(4.0 * crate::numeric::tolerance::UNIT * length);
                prop_assert!((0..3).all(|k| (Dyadic::from_f64(v[k]) - image[k].clone()).abs() <= error));
                let exact_length = image.iter().fold(Dyadic::zero(), |sum, c| sum + c.clone().abs());
                // the sum of a generator's own coordinates is rounded
                let length = length * crate::numeric::tolerance::FIVE_ROUNDINGS;
                prop_assert!(exact_length <= Dyadic::from_f64(length));
            }
        }
    }
}
