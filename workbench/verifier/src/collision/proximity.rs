//! Answers to "how far apart are two bodies, where are they nearest, how deep do they overlap".
//!
//! The location of the displacement of the centres relative to the zonotope of the generators of both says whether the
//! bodies meet. Of disjoint bodies the distance has a certificate of its own; its coefficients give the nearest points,
//! and the vector between these the faces. Bodies that touch have a common supporting hyperplane, whose normal is part
//! of the answer. How deep bodies overlap is known from all facets of a small sum.

use std::fmt::{self, Display};

use dashu_int::IBig;
use dashu_int::ops::Abs;

use super::displaced::Displaced;
use super::distance::{DistanceAnswer, Nearest, nearest};
use super::location::{Coefficients, Located, LocationAnswer, Status, located};
use super::penetration::{PenetrationAnswer, check_penetration};
use super::placed::Body;
use crate::exact::fraction::Fraction;
use crate::exact::linear::{Echelon, dot, is_zero};
use crate::exact::proportion::{Proportion, check_figure};
use crate::exact::whole_direction;
use crate::verdict::{Stop, Verdict};

/// The kinds of face by their dimension.
const FEATURES: [&str; 3] = ["vertex", "edge", "facet"];

/// The body that a common point of two bodies is in where their interiors meet.
const INTERIOR: &str = "interior";

/// An answer as it was written.
#[derive(Debug, Clone, PartialEq)]
pub struct ProximityAnswer {
    /// The claimed distance: 0 for bodies that meet.
    pub distance: f64,
    /// The place of the displacement of the centres, with its proof.
    pub location: LocationAnswer,
    /// The claimed nearest points of the first and of the second body.
    pub nearest: [Vec<f64>; 2],
    /// The names of the faces on which they lie.
    pub features: [String; 2],
    /// The claims about bodies that are disjoint, about bodies that touch, about bodies that meet.
    pub parts: ProximityParts,
}

/// The parts of an answer that not every answer has.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ProximityParts {
    /// Of disjoint bodies, the coefficients and the basis that prove the distance.
    pub distance: Option<(Vec<f64>, Vec<usize>)>,
    /// Of bodies that touch, the normal of a hyperplane that supports both.
    pub normal: Option<Vec<Fraction>>,
    /// Of bodies that meet, how deep.
    pub penetration: Option<PenetrationAnswer>,
}

/// The proof.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProximityProof {
    /// The distance as it was written.
    pub distance: f64,
    /// The status.
    pub status: Status,
}

impl Display for ProximityProof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { distance, status } = self;
        write!(f, "{}; distance {distance:?}, nearest points and faces are the exact ones, rounded", status.name())
    }
}

/// Proves distance, nearest points, faces and depth of two bodies, or says what fails.
pub fn check_proximity<G: AsRef<[f64]>>(
    a: &Body<'_, G>,
    b: &Body<'_, G>,
    answer: &ProximityAnswer,
) -> Verdict<ProximityProof> {
    proved(a, b, answer).into()
}

fn proved<G: AsRef<[f64]>>(a: &Body<'_, G>, b: &Body<'_, G>, answer: &ProximityAnswer) -> Result<ProximityProof, Stop> {
    let question = Displaced::between(a, b)?;
    let found = located(&question, &answer.location)?;
    let right = ProximityProof { distance: answer.distance, status: answer.location.status };
    let ProximityParts { distance, normal, penetration } = &answer.parts;
    let count = a.generators.len();
    match found {
        Located::Outside(_) => {
            let (coefficients, basis) = distance.clone().ok_or("the proof of the distance is missing".to_owned())?;
            let claimed = DistanceAnswer { distance: answer.distance, coefficients, basis };
            let Nearest { coefficients, residual } = nearest(&question, &claimed)?;
            if answer.distance <= 0.0 {
                return Err("disjoint bodies have a positive distance".into());
            }
            check_features(&question, count, &residual, &answer.features)?;
            check_points(&question, count, &coefficients, &answer.nearest)?;
        }
        Located::Member(coefficients) => {
            if answer.distance != 0.0 {
                return Err(format!("bodies that meet have the distance 0, not {}", answer.distance).into());
            }
            if answer.nearest[0] != answer.nearest[1] {
                return Err("the nearest points of bodies that meet are not one".into());
            }
            check_points(&question, count, &coefficients, &answer.nearest)?;
            match (answer.location.status, normal) {
                (Status::Boundary, Some(normal)) => {
                    let normal = whole_direction(normal);
                    let supports = normal.len() == question.dimension()
                        && !is_zero(&normal)
                        && dot(&normal, &question.p) == question.support(&normal);
                    if !supports {
                        return Err("the hyperplane of the contact does not support the bodies".into());
                    }
                    check_features(&question, count, &normal, &answer.features)?;
                }
                (Status::Boundary, None) => return Err("the normal of the contact is missing".into()),
                _ if answer.features.iter().any(|feature| feature != INTERIOR) => {
                    return Err("bodies whose interiors meet do not meet in a face".into());
                }
                _ => {}
            }
            let penetration = penetration.as_ref().ok_or("how deep the bodies overlap is missing".to_owned())?;
            check_penetration(&question, answer.location.status, penetration)?;
        }
    }
    Ok(right)
}

/// Checks the names of the faces in the direction u: each is spanned by the generators of its body that are orthogonal
/// to u.
fn check_features(question: &Displaced, count: usize, u: &[IBig], features: &[String; 2]) -> Result<(), String> {
    let (own, others) = question.generators.split_at(count);
    for ((name, generators), claimed) in [("a", own), ("b", others)].into_iter().zip(features) {
        let face = generators.iter().filter(|generator| dot(u, generator) == IBig::ZERO);
        let exact = FEATURES.get(Echelon::spanned(question.dimension(), face).rank());
        if exact != Some(&claimed.as_str()) {
            let exact = exact.unwrap_or(&"the whole space");
            return Err(format!("the face of {name} is called `{claimed}`, but it is `{exact}`"));
        }
    }
    Ok(())
}

/// Checks the points of both bodies that belong to coefficients: the exact ones, rounded.
///
/// A coordinate may be off by what rounding the coefficients to doubles takes from the sum: it is at most the unit
/// roundoff times the sum of the magnitudes of the terms.
fn check_points(
    question: &Displaced,
    count: usize,
    coefficients: &Coefficients,
    points: &[Vec<f64>; 2],
) -> Result<(), String> {
    let Coefficients { numerators, denominator } = coefficients;
    let ranges = [(0..count, IBig::ONE), (count..numerators.len(), IBig::NEG_ONE)];
    for ((point, (range, sign)), (name, center)) in
        points.iter().zip(ranges).zip([("a", &question.from), ("b", &question.to)])
    {
        if point.len() != question.dimension() {
            return Err(format!("the point of {name} has {} coordinates", point.len()));
        }
        for (axis, &claimed) in point.iter().enumerate() {
            let terms = || range.clone().map(|index| &numerators[index] * &question.generators[index][axis]);
            let sum: IBig = terms().sum();
            let size: IBig = terms().map(Abs::abs).sum();
            let exact =
                Proportion::new(&center[axis] * denominator + &sign * sum, denominator.clone(), question.exponent());
            let size = Proportion::new(size, denominator.clone(), question.exponent()).plus(&exact.magnitude());
            let allowed = size.times(&Proportion::of_double(f64::EPSILON));
            check_figure(&format!("coordinate {} of the point of {name}", axis + 1), claimed, &exact, &allowed)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::location::LocationCertificate;
    use super::*;

    const SQUARE: [[f64; 2]; 2] = [[1.0, 0.0], [0.0, 1.0]];

    fn body(center: &[f64; 2]) -> Body<'_, [f64; 2]> {
        Body { center, generators: &SQUARE, pose: None }
    }

    /// Two squares of side 2, the second one 3 and a half to the right.
    fn apart() -> ProximityAnswer {
        let certificate = LocationCertificate::Separation(vec![IBig::ONE, IBig::ZERO]);
        ProximityAnswer {
            distance: 1.5,
            location: LocationAnswer { status: Status::Outside, certificate },
            nearest: [vec![1.0, 0.25], vec![2.5, 0.25]],
            features: ["edge", "edge"].map(str::to_owned),
            parts: ProximityParts { distance: Some((vec![1.0, 0.25, 1.0, 0.0], vec![1])), ..Default::default() },
        }
    }

    /// The same, the second one 2 to the right: they touch.
    fn touching() -> ProximityAnswer {
        let certificate = LocationCertificate::Witness { coefficients: vec![1.0, 0.25, 1.0, 0.0], basis: vec![1] };
        ProximityAnswer {
            distance: 0.0,
            location: LocationAnswer { status: Status::Boundary, certificate },
            nearest: [vec![1.0, 0.25], vec![1.0, 0.25]],
            features: ["edge", "edge"].map(str::to_owned),
            parts: ProximityParts {
                normal: ["3", "0"].map(Fraction::parse).into_iter().collect(),
                penetration: Some(PenetrationAnswer { lower: 0.0, upper: 0.0, direction: vec![0.0, 0.0] }),
                ..Default::default()
            },
        }
    }

    fn accepts(x: f64, answer: &ProximityAnswer) -> bool {
        check_proximity(&body(&[0.0, 0.0]), &body(&[x, 0.25]), answer).is_right()
    }

    #[test]
    fn squares_by_hand() {
        assert!(accepts(3.5, &apart()) && accepts(2.0, &touching()));
        assert!(!accepts(3.0, &apart()) && !accepts(2.5, &touching()));
    }

    #[test]
    fn what_is_wrong_is_told() {
        let wrong: [fn(&mut ProximityAnswer); 6] = [
            |answer| answer.distance += 0.25,
            |answer| answer.nearest[0][1] = 0.5,
            |answer| answer.nearest[1][0] += 1e-9,
            |answer| answer.features[1] = "vertex".to_owned(),
            |answer| answer.parts = ProximityParts::default(),
            |answer| answer.location.status = Status::Inside,
        ];
        for spoil in wrong {
            for (x, mut answer) in [(3.5, apart()), (2.0, touching())] {
                spoil(&mut answer);
                assert!(!accepts(x, &answer), "{answer:?}");
            }
        }
        let mut turned = touching();
        turned.parts.normal = ["1", "1"].map(Fraction::parse).into_iter().collect();
        assert!(!accepts(2.0, &turned));
        let mut deep = touching();
        deep.parts.penetration = Some(PenetrationAnswer { lower: 0.0, upper: 0.5, direction: vec![1.0, 0.0] });
        assert!(!accepts(2.0, &deep));
    }

    /// One claim is wrong at a time, and the others are right.
    #[test]
    fn one_wrong_claim_is_told() {
        let touching_with = |spoil: fn(&mut ProximityAnswer)| {
            let mut answer = touching();
            spoil(&mut answer);
            accepts(2.0, &answer)
        };
        assert!(!touching_with(|answer| answer.parts.normal = None));
        assert!(!touching_with(|answer| answer.parts.penetration = None));
        for normal in [&["0", "0"] as &[&str], &["1"], &["1", "0", "0"], &["-1", "0"], &["0", "1"]] {
            let mut answer = touching();
            answer.parts.normal = normal.iter().copied().map(Fraction::parse).collect();
            assert!(answer.parts.normal.is_some() && !accepts(2.0, &answer), "{normal:?}");
        }
        let mut below = apart();
        below.distance = -1.5;
        assert!(!accepts(3.5, &below));
    }

    #[test]
    fn faces_of_any_dimension_have_their_names() {
        let bodies: [&[[f64; 3]]; 3] = [
            &[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            &[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 1.0]],
            &[[1.0, 1.0, 0.0], [1.0, 0.0, 1.0], [1.0, 0.5, 0.5]],
        ];
        let names = ["facet", "edge", "vertex"];
        for (generators, name) in bodies.into_iter().zip(names) {
            let body = |x| Displaced::new(&[0.0; 3], &[x, 0.0, 0.0], generators).expect("finite");
            let features = |claimed: &str| {
                let u = [1, 0, 0].map(IBig::from);
                check_features(&body(4.0), generators.len(), &u, &[claimed, "vertex"].map(str::to_owned))
            };
            for claimed in names {
                assert_eq!(features(claimed).is_ok(), claimed == name, "{claimed} for {name}");
            }
        }
    }

    /// Two squares of side 2, the second one half to the right: they meet in more than a face.
    #[test]
    fn squares_that_overlap_meet_in_no_face() {
        let certificate = LocationCertificate::Witness { coefficients: vec![0.25, 0.0, 0.25, 0.25], basis: vec![] };
        let overlapping = ProximityAnswer {
            distance: 0.0,
            location: LocationAnswer { status: Status::Inside, certificate },
            nearest: [vec![0.25, 0.0], vec![0.25, 0.0]],
            features: [INTERIOR; 2].map(str::to_owned),
            parts: ProximityParts {
                penetration: Some(PenetrationAnswer { lower: 1.5, upper: 1.5, direction: vec![1.0, 0.0] }),
                ..Default::default()
            },
        };
        assert!(accepts(0.5, &overlapping));
        for at in 0..2 {
            let mut named = overlapping.clone();
            named.features[at] = "edge".to_owned();
            assert!(!accepts(0.5, &named));
        }
        let mut shallow = overlapping;
        shallow.parts.penetration = Some(PenetrationAnswer { lower: 1.0, upper: 1.0, direction: vec![1.0, 0.0] });
        assert!(!accepts(0.5, &shallow));
    }
}
