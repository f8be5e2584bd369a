//! Answers of bodies, handed to the verifier as they stand: each coefficient a double, each gauge its value.

use proptest::prelude::*;
use verifier::{Body, Displaced, GaugeAnswer, LocationAnswer, LocationCertificate, check_gauge, check_location};
use zonotope::{Location, Pose, Separation, Witness, Zonotope};

fn certificate<const D: usize>(location: &Location<D>) -> Option<LocationCertificate> {
    match location {
        Location::Inside(Witness { coefficients, basis }) | Location::Boundary(Witness { coefficients, basis }) => {
            Some(LocationCertificate::Witness { coefficients: coefficients.clone(), basis: basis.clone() })
        }
        Location::Outside(Separation::Rounded(u)) => {
            let exact: Vec<_> = u.iter().filter_map(|c| verifier::Fraction::of_double(*c)).collect();
            Some(LocationCertificate::Separation(verifier::whole_direction(&exact)))
        }
        Location::Outside(Separation::Exact(_)) => None,
    }
}

/// The verifier takes an answer as it stands.
fn check<const D: usize>(question: &Displaced, location: &Location<D>) {
    let Some(certificate) = certificate(location) else { return };
    let status = verifier::Status::named(location.status().name()).expect("a status");
    let verdict = check_location(question, &LocationAnswer { status, certificate });
    assert!(verdict.is_right(), "{verdict:?}");
}

fn check_plain<const D: usize>(center: [f64; D], generators: &[[f64; D]], point: [f64; D]) {
    let body = Zonotope::new(center, generators.to_vec()).expect("finite");
    let question = Displaced::new(&center, &point, generators).expect("one dimension");
    check(&question, &body.locate(point).expect("finite").expand());
    check(&question, &body.gauge(point).expect("finite").expand().location);
    let origin = Zonotope::new(point, vec![]).expect("finite");
    check(&question, &body.intersection(&origin).expand());
}

fn number() -> impl Strategy<Value = f64> {
    prop_oneof![3 => -1.0..1.0f64, 2 => (-2i32..3).prop_map(f64::from), 1 => Just(1e-9), 1 => Just(1e200)]
}

fn vector<const D: usize>() -> impl Strategy<Value = [f64; D]> {
    proptest::collection::vec(number(), D).prop_map(|v| std::array::from_fn(|k| v[k]))
}

fn body<const D: usize>() -> impl Strategy<Value = ([f64; D], Vec<[f64; D]>, [f64; D])> {
    (vector(), proptest::collection::vec(vector(), 0..7), vector())
}

fn pose() -> impl Strategy<Value = Pose> {
    let any = (proptest::array::uniform3(vector()), vector()).prop_map(|(m, t)| Pose::new(m, t).expect("finite"));
    let rotation = (proptest::array::uniform4(-1.0..1.0f64), vector())
        .prop_map(|(q, t)| Pose::from_quaternion(q, t).unwrap_or_default());
    prop_oneof![any, rotation]
}

tests::properties! {
    200;

    #[test]
    fn answers_of_bodies_go_straight_to_the_verifier(
        line in body::<1>(), planar in body::<2>(), of_space in body::<3>(), more in body::<4>()
    ) {
        check_plain(line.0, &line.1, line.2);
        check_plain(planar.0, &planar.1, planar.2);
        check_plain(of_space.0, &of_space.1, of_space.2);
        check_plain(more.0, &more.1, more.2);
    }

    #[test]
    fn answers_of_posed_bodies_go_straight_to_the_verifier(
        (center, generators, point) in body::<3>(), from in pose(), to in pose()
    ) {
        let placed = |pose: &Pose| verifier::Pose {
            matrix: pose.matrix().map(|row| row.to_vec()).to_vec(),
            translation: pose.translation().to_vec(),
        };
        let (first, second) = generators.split_at(generators.len() / 2);
        let [a, b] = [(center, first), (point, second)]
            .map(|(center, own)| Zonotope::new(center, own.to_vec()).expect("finite"));
        let (there, here) = (placed(&from), placed(&to));
        let own = Body { center: &center, generators: first, pose: Some(&there) };
        let other = Body { center: &point, generators: second, pose: Some(&here) };
        let question = Displaced::between(&own, &other).expect("space");
        check(&question, &a.at(&from).intersection(b.at(&to)).expand());
        let question = Displaced::to_point(&own, &point).expect("space");
        check(&question, &a.at(&from).locate(point).expect("finite").expand());
        let gauge = a.at(&from).gauge(point).expect("finite").expand();
        if let Some(certificate) = certificate(&gauge.location) {
            let at_most_one = gauge.location.is_member();
            let answer = GaugeAnswer { gauge: gauge.value, at_most_one, certificate };
            prop_assert!(check_gauge(&question, &answer).is_right());
        }
    }
}
