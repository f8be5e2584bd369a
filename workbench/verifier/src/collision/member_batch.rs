//! Answers to "where do these points lie relative to one zonotope, and what are their gauges".
//!
//! They come without certificates, so the facets of the zonotope are listed once and every point is held against all of them; a
//! large body is not checked.

use std::cmp::Ordering;

use crate::RELATIVE_ERROR;
use crate::exact::grid::Grid;
use crate::exact::linear::{Echelon, Vector};
use crate::exact::proportion::{Proportion, check_figure};
use crate::faces::facets::Facets;

/// So many products of facets and points are tried.
const MOST_TRIALS: usize = 20_000_000;

/// Checks the status and the gauge of every point; whether the body was small enough for that.
pub fn check_member_batch(
    center: &[f64],
    generators: &[Vec<f64>],
    points: &[Vec<f64>],
    answers: &[(&str, f64)],
) -> Result<bool, String> {
    if answers.len() != points.len() {
        return Err(format!("{} answers for {} points", answers.len(), points.len()));
    }
    let dimension = center.len();
    if generators.iter().chain(points).any(|v| v.len() != dimension) {
        return Err("answered a question whose dimensions do not agree".to_owned());
    }
    let grid = Grid::of(center.iter().chain(generators.iter().chain(points).flatten()).copied());
    let placed = |v: &[f64]| -> Vector { v.iter().map(|&component| grid.units(component)).collect() };
    let center = placed(center);
    let generators: Vec<Vector> = generators.iter().map(|generator| placed(generator)).collect();
    let span = Echelon::spanned(dimension, &generators);
    let pivots = span.pivots();
    let projected = |v: &Vector| -> Vector { pivots.iter().map(|&axis| v[axis].clone()).collect() };
    let facets = match pivots.len() {
        0 => None,
        rank => match Facets::of(rank, &generators.iter().map(projected).collect::<Vec<_>>()) {
            Some(facets) if facets.count().saturating_mul(points.len()) <= MOST_TRIALS => Some(facets),
            _ => return Ok(false),
        },
    };

    for (number, (point, (status, gauge))) in (1..).zip(points.iter().zip(answers)) {
        let p: Vector = placed(point).iter().zip(&center).map(|(point, center)| point - center).collect();
        if !span.contains(&p) {
            if *status != "outside" || *gauge != f64::INFINITY {
                return Err(format!(
                    "point {number} is off the span, but it is said to be {status} with gauge {gauge}"
                ));
            }
            continue;
        }
        let exact = facets.as_ref().map_or(Proportion::of_double(0.0), |facets| facets.gauge(&projected(&p)));
        let truth = match exact.compare(&Proportion::of_double(1.0)) {
            Ordering::Greater => "outside",
            Ordering::Less if span.rank() == dimension => "inside",
            _ => "boundary",
        };
        if *status != truth {
            return Err(format!("point {number} is said to be {status}, but it is {truth}"));
        }
        if *gauge != f64::MAX || exact.near().is_finite() {
            let allowed = exact.times(&Proportion::of_double(RELATIVE_ERROR));
            check_figure(&format!("the gauge of point {number}"), *gauge, &exact, &allowed)?;
        }
    }
    Ok(true)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_around_a_square_and_a_segment() {
        let check = |generators: &[[f64; 2]], answers: &[(&str, f64)]| {
            let generators: Vec<Vec<f64>> = generators.iter().map(|generator| generator.to_vec()).collect();
            let points = [vec![1.0, 1.5], vec![2.0, 1.0], vec![4.0, 1.0], vec![1.0, 1.0]];
            check_member_batch(&[1.0, 1.0], &generators, &points, answers)
        };
        let square = [[1.0, 0.0], [0.0, 1.0]];
        assert_eq!(check(&square, &[("inside", 0.5), ("boundary", 1.0), ("outside", 3.0), ("inside", 0.0)]), Ok(true));
        assert!(check(&square, &[("inside", 0.5), ("inside", 1.0), ("outside", 3.0), ("inside", 0.0)]).is_err());
        assert!(check(&square, &[("inside", 0.5), ("boundary", 1.0), ("outside", 2.0), ("inside", 0.0)]).is_err());
        let infinite = f64::INFINITY;
        let flat = [("outside", infinite), ("boundary", 0.5), ("outside", 1.5), ("boundary", 0.0)];
        assert_eq!(check(&[[2.0, 0.0]], &flat), Ok(true));
        let nothing = [("outside", infinite), ("outside", infinite), ("outside", infinite), ("boundary", 0.0)];
        assert_eq!(check(&[], &nothing), Ok(true));
        assert!(check(&square, &[]).is_err());
    }
}
