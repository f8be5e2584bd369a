//! Answers to "where do these points lie relative to one zonotope, and what are their gauges".
//!
//! They come without certificates, so the facets of the zonotope are listed once and every point is held against all
//! of them; a large body is not checked.

use std::cmp::Ordering;
use std::fmt::{self, Display};

use super::gauge::check_gauge_figure;
use super::location::Status;
use super::placed::{Body, Frame};
use crate::verdict::{Stop, Verdict};

use crate::exact::linear::{Echelon, Vector};
use crate::exact::proportion::Proportion;
use crate::faces::facets::Facets;

/// The number of products of facets and points that are tried.
const MOST_TRIALS: usize = 20_000_000;

/// The number of points that were held against every facet.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MemberBatchProof {
    /// The number of points.
    pub points: usize,
}

impl Display for MemberBatchProof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} points, each held against every facet", self.points)
    }
}

/// Checks the status and the gauge of every point, if the body is small enough for that.
pub fn check_member_batch<G: AsRef<[f64]>>(
    body: &Body<'_, G>,
    points: &[Vec<f64>],
    answers: &[(Status, f64)],
) -> Verdict<MemberBatchProof> {
    held(body, points, answers).into()
}

fn held<G: AsRef<[f64]>>(
    body: &Body<'_, G>,
    points: &[Vec<f64>],
    answers: &[(Status, f64)],
) -> Result<MemberBatchProof, Stop> {
    if answers.len() != points.len() {
        return Err(format!("{} answers for {} points", answers.len(), points.len()).into());
    }
    let dimension = body.center.len();
    body.check_dimension(dimension)?;
    if points.iter().any(|point| point.len() != dimension) {
        return Err("answered a question whose dimensions do not agree".into());
    }
    let frame = Frame::of(&[body], &points.iter().map(Vec::as_slice).collect::<Vec<_>>())?;
    let (center, generators) = (frame.center(body), frame.generators(body));
    let span = Echelon::spanned(dimension, &generators);
    let pivots = span.pivots();
    let projected = |v: &Vector| -> Vector { pivots.iter().map(|&axis| v[axis].clone()).collect() };
    let placed_points: Vec<Vector> = points
        .iter()
        .map(|point| frame.point(point).iter().zip(&center).map(|(point, center)| point - center).collect())
        .collect();
    let facets = match pivots.len() {
        0 => None,
        rank => {
            let [generators, points] =
                [&generators, &placed_points].map(|list| list.iter().map(projected).collect::<Vec<_>>());
            match Facets::of(rank, &generators, &points) {
                Some(facets) if facets.count().saturating_mul(points.len()) <= MOST_TRIALS => Some(facets),
                _ => {
                    let reason = "too many facets to hold points without certificates against";
                    return Err(Stop::Unchecked(reason.to_owned()));
                }
            }
        }
    };

    for (index, (p, (status, gauge))) in placed_points.iter().zip(answers).enumerate() {
        let number = index + 1;
        if !span.contains(p) {
            if *status != Status::Outside || *gauge != f64::INFINITY {
                let status = status.name();
                return Err(format!(
                    "point {number} is off the span, but it is said to be {status} with gauge {gauge}"
                )
                .into());
            }
            continue;
        }
        let is_full = span.rank() == dimension;
        let bounds = facets.as_ref().and_then(|facets| facets.gauge_bounds(index));
        if let Some(told) = bounds.and_then(|bounds| told_by(&bounds, is_full, number, *status, *gauge)) {
            told?;
            continue;
        }
        let exact = facets.as_ref().map_or(Proportion::of_double(0.0), |facets| facets.gauge(index));
        let truth = status_at(&exact, is_full);
        check_status(number, *status, truth)?;
        check_gauge_figure(&name_of_gauge(number), *gauge, &exact)?;
    }
    Ok(MemberBatchProof { points: points.len() })
}

/// The status of a point of the span with the gauge.
fn status_at(gauge: &Proportion, is_full: bool) -> Status {
    match gauge.compare(&Proportion::of_double(1.0)) {
        Ordering::Greater => Status::Outside,
        Ordering::Less if is_full => Status::Inside,
        _ => Status::Boundary,
    }
}

fn check_status(number: usize, claimed: Status, truth: Status) -> Result<(), String> {
    if claimed == truth {
        return Ok(());
    }
    Err(format!("point {number} is said to be {}, but it is {}", claimed.name(), truth.name()))
}

fn name_of_gauge(number: usize) -> String {
    format!("the gauge of point {number}")
}

/// The verdict that bounds of the gauge give on a status and a figure: `None` if they are too far apart for that, or
/// about 1. A figure that is right at both bounds is right between them.
fn told_by(
    [low, high]: &[Proportion; 2],
    is_full: bool,
    number: usize,
    status: Status,
    gauge: f64,
) -> Option<Result<(), String>> {
    let one = Proportion::of_double(1.0);
    if low.compare(&one).is_le() && high.compare(&one).is_ge() {
        return None;
    }
    if let Err(complaint) = check_status(number, status, status_at(low, is_full)) {
        return Some(Err(complaint));
    }
    // The largest double stands for all that is beyond the doubles, which is left to the exact gauge.
    if !(0.0..f64::MAX).contains(&gauge) {
        return None;
    }
    // A false figure is told beside the exact one.
    let name = name_of_gauge(number);
    [low, high].iter().all(|bound| check_gauge_figure(&name, gauge, bound).is_ok()).then_some(Ok(()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_around_a_square_and_a_segment() {
        let check = |generators: &[[f64; 2]], answers: &[(Status, f64)]| {
            let body = Body { center: &[1.0, 1.0], generators, pose: None };
            let points = [vec![1.0, 1.5], vec![2.0, 1.0], vec![4.0, 1.0], vec![1.0, 1.0]];
            check_member_batch(&body, &points, answers).proof().map(|proof| proof.points)
        };
        let square = [[1.0, 0.0], [0.0, 1.0]];
        assert_eq!(
            check(
                &square,
                &[(Status::Inside, 0.5), (Status::Boundary, 1.0), (Status::Outside, 3.0), (Status::Inside, 0.0)]
            ),
            Ok(4)
        );
        assert!(
            check(
                &square,
                &[(Status::Inside, 0.5), (Status::Inside, 1.0), (Status::Outside, 3.0), (Status::Inside, 0.0)]
            )
            .is_err()
        );
        assert!(
            check(
                &square,
                &[(Status::Inside, 0.5), (Status::Boundary, 1.0), (Status::Outside, 2.0), (Status::Inside, 0.0)]
            )
            .is_err()
        );
        let infinite = f64::INFINITY;
        let flat =
            [(Status::Outside, infinite), (Status::Boundary, 0.5), (Status::Outside, 1.5), (Status::Boundary, 0.0)];
        assert_eq!(check(&[[2.0, 0.0]], &flat), Ok(4));
        let nothing = [
            (Status::Outside, infinite),
            (Status::Outside, infinite),
            (Status::Outside, infinite),
            (Status::Boundary, 0.0),
        ];
        assert_eq!(check(&[], &nothing), Ok(4));
        assert!(check(&square, &[]).is_err());
    }

    /// Bounds in floating point tell of most points; what they leave open, and what is beyond the doubles, the exact
    /// gauge tells.
    #[test]
    fn points_about_bodies_of_any_size() {
        for exponents in [[0, 0, 0], [900, -900, 0], [-1_040, 300, -600], [1_000, 1_000, -1_060]] {
            let [a, b, c] =
                exponents.map(|exponent: i32| 2.0_f64.powi(exponent / 2) * 2.0_f64.powi(exponent - exponent / 2));
            let generators = [[a, 0.0, 0.0], [0.0, b, 0.0], [0.0, 0.0, c]];
            let body = Body { center: &[0.0; 3], generators: &generators, pose: None };
            let points = [vec![0.5 * a, -0.25 * b, 0.0], vec![a, b, -c], vec![0.0, 3.0 * b, c], vec![0.0; 3]];
            let verdict = |answers: [(Status, f64); 4]| check_member_batch(&body, &points, &answers);
            let right = [(Status::Inside, 0.5), (Status::Boundary, 1.0), (Status::Outside, 3.0), (Status::Inside, 0.0)];
            assert!(verdict(right).is_right(), "{exponents:?}");
            for (index, false_answer) in [
                (0, (Status::Boundary, 0.5)),
                (0, (Status::Inside, 0.5 + 1e-11)),
                (1, (Status::Outside, 1.0)),
                (1, (Status::Boundary, 1.0 - 1e-11)),
                (2, (Status::Inside, 3.0)),
                (2, (Status::Outside, f64::MAX)),
                (2, (Status::Outside, f64::INFINITY)),
                (3, (Status::Inside, f64::from_bits(1))),
                (3, (Status::Boundary, 0.0)),
            ] {
                let mut answers = right;
                answers[index] = false_answer;
                assert!(verdict(answers).is_wrong(), "{exponents:?} {index} {false_answer:?}");
            }
        }
    }

    #[test]
    fn the_point_with_a_false_answer_is_named() {
        let body = Body { center: &[0.0, 0.0], generators: &[[1.0, 0.0], [0.0, 1.0]], pose: None };
        let points = [vec![0.5, 0.0], vec![0.5, 0.25], vec![0.0, 3.0]];
        let right = [(Status::Inside, 0.5), (Status::Inside, 0.5), (Status::Outside, 3.0)];
        for (index, false_answer) in [(1, (Status::Outside, 0.5)), (2, (Status::Outside, 2.0))] {
            let mut answers = right;
            answers[index] = false_answer;
            let complaint = check_member_batch(&body, &points, &answers).proof().expect_err("an answer is false");
            assert!(complaint.contains(&format!("point {} is", index + 1)), "{complaint}");
        }
    }

    /// The first answer is false, so that the limit alone takes time.
    #[test]
    fn as_many_facets_and_points_are_gone_through_as_the_limit_says() {
        let generators: Vec<[f64; 2]> = (0..4_000).map(|k| [1.0, f64::from(k)]).collect();
        let body = Body { center: &[0.0, 0.0], generators: &generators, pose: None };
        let verdict = |count: usize| {
            let answers = vec![(Status::Outside, 0.0); count];
            check_member_batch(&body, &vec![vec![0.0, 0.0]; count], &answers)
        };
        let most = MOST_TRIALS / generators.len();
        assert!(verdict(most).is_wrong());
        assert!(matches!(verdict(most + 1), Verdict::Unchecked(_)));
    }
}
