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
        let exact = facets.as_ref().map_or(Proportion::of_double(0.0), |facets| facets.gauge(index));
        let truth = match exact.compare(&Proportion::of_double(1.0)) {
            Ordering::Greater => Status::Outside,
            Ordering::Less if span.rank() == dimension => Status::Inside,
            _ => Status::Boundary,
        };
        if *status != truth {
            return Err(format!("point {number} is said to be {}, but it is {}", status.name(), truth.name()).into());
        }
        check_gauge_figure(&format!("the gauge of point {number}"), *gauge, &exact)?;
    }
    Ok(MemberBatchProof { points: points.len() })
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
}
