//! Checking a certificate: the verifier takes the numbers of question and answer and shares no code with the library.

use verifier::{Displaced, LocationAnswer, LocationCertificate, Status, Verdict, check_location};
use zonotope::{Location, Zonotope};

/// Asks, prints and asserts.
pub fn main() {
    let generators = [[3.0, 1.0, 0.0], [0.0, 2.0, 1.0], [1.0, 0.0, 2.0], [1.0, 1.0, 1.0]];
    let body = Zonotope::new([1.0, 1.0, 1.0], generators.to_vec()).expect("the coordinates are finite");
    let point = [2.0, 2.5, 1.0];

    let location = body.locate(point).expect("the point is finite").expand();
    let Location::Inside(witness) = location else { unreachable!("the point is near the centre") };

    let question = Displaced::new(&body.center(), &point, &generators).expect("the numbers are finite");
    let certificate = LocationCertificate::Witness { coefficients: witness.coefficients, basis: witness.basis };
    let claim = |status| LocationAnswer { status, certificate: certificate.clone() };
    assert!(check_location(&question, &claim(Status::Inside)).is_right());

    // the same certificate does not prove another claim
    let verdict = check_location(&question, &claim(Status::Boundary));
    assert!(matches!(verdict, Verdict::Wrong(_)));
    println!("inside: right; boundary: {verdict:?}");
}
