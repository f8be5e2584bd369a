//! Both bounds to the last digits, by linear programs along the directions of generators that are nearly the best ones.
//!
//! What these directions are off by counts only squared. If λ · w ≤ 1 along every one of them, a vertex w of the forces' zonotope within an angle δ of one is no farther out than
//! 1 / cos δ, so the multipliers prove nearly the length of the program's zonotope. Where a vertex is farther out than that, its direction is missing.

use super::containment::length_above;
use super::finish::Inner;
use super::frame::Frame;
use super::lower_bound::Best;
use crate::enclosing::fixed_directions::{FixedDirections, Generation, balanced, contain_guess, dot};
use crate::enclosing::outward::rounded_towards;
use crate::numeric::dyadic::{Dyadic, scale_by_power_of_two};
use crate::zonotope::Zonotope;

/// Each search begins with at most so many directions.
const MOST_DIRECTIONS: usize = 250;

/// So many programs are solved for up to so many points from each beginning, else a few from the first.
const MOST_PROGRAMS: usize = 60;
const FEW_POINTS: usize = 100;
const FEW_PROGRAMS: usize = 2;

/// Bounds are near enough at this multiple of ε: rounding takes some of the rest.
const CLOSELY: f64 = 0.25;

/// Directions within this of each other are one.
const SAME: f64 = 1e-7;

/// Directions to begin with: those of generators, these and others, the others alone.
pub(super) fn starts<const D: usize>(generators: &[[f64; D]], others: Vec<[f64; D]>) -> [Vec<[f64; D]>; 3] {
    let mut long: Vec<[f64; D]> = generators.iter().copied().filter(|g| length(g) > 0.0).collect();
    long.sort_by(|a, b| length(b).total_cmp(&length(a)));
    let long: Vec<[f64; D]> = long.into_iter().map(|g| g.map(|c| c / length(&g))).collect();
    let both = others.iter().chain(&long).copied().collect();
    [long, both, others].map(distinct)
}

fn distinct<const D: usize>(directions: Vec<[f64; D]>) -> Vec<[f64; D]> {
    let mut kept: Vec<[f64; D]> = Vec::new();
    for v in directions {
        let is_near = |other: &[f64; D]| {
            let side = if dot(&v, other) < 0.0 { -1.0 } else { 1.0 };
            let apart: [f64; D] = std::array::from_fn(|c| v[c] - side * other[c]);
            length(&apart) <= SAME
        };
        if kept.len() < MOST_DIRECTIONS && !kept.iter().any(is_near) {
            kept.push(v);
        }
    }
    kept
}

fn length<const D: usize>(v: &[f64; D]) -> f64 {
    dot(v, v).sqrt()
}

/// A zonotope around the points along directions like those that one begins with, and its length; what is proven improves on the way.
pub(super) fn sharpened<const D: usize>(
    points: &[[f64; D]],
    frame: &Frame<D>,
    starts: [Vec<[f64; D]>; 3],
    epsilon: f64,
    best: &mut Best<D>,
) -> Option<(Zonotope<D>, f64)> {
    let mut shortest: Option<(Zonotope<D>, f64)> = None;
    let is_small = points.len() <= FEW_POINTS;
    let (tries, programs) = if is_small { (starts.len(), MOST_PROGRAMS) } else { (1, FEW_PROGRAMS) };
    for start in starts.into_iter().take(tries) {
        let mut directions = start;
        let mut least: Option<(f64, [f64; D], Vec<[f64; D]>)> = None;
        for _ in 0..programs {
            // These alone may hardly span.
            directions = frame.long.iter().chain(&directions).copied().collect();
            let weights = vec![1.0; directions.len()];
            let mut generation = Generation::new(frame.rank(), &frame.points, directions, weights, &mut ());
            if generation.run(&mut ()).is_err() {
                break;
            }
            let pulls: Vec<(usize, [f64; D])> =
                generation.program.multipliers().map(|(row, y)| (row.point, row.normal.map(|c| c * y))).collect();
            let far = best.improve(frame.rank(), &frame.points, balanced(&pulls), 1.0);
            let inner = Inner::along(&generation);
            directions = inner.generators.iter().map(|g| g.map(|c| c / length(g))).collect();
            directions.extend(far.peaks.iter().map(|peak| peak.map(|c| c / length(peak))));
            directions = distinct(directions);
            if least.as_ref().is_none_or(|(upper, ..)| inner.upper < *upper) {
                least = Some((inner.upper, inner.center, inner.generators));
            }
            if far.peaks.is_empty()
                || least.as_ref().is_some_and(|(upper, ..)| *upper <= (1.0 + CLOSELY * epsilon) * best.lower)
            {
                break;
            }
        }
        let found = least.and_then(|(_, center, generators)| contained(points, frame, center, &generators));
        shortest = [shortest, found].into_iter().flatten().min_by(|a, b| a.1.total_cmp(&b.1));
        let enough = (1.0 + epsilon) * (1.0 - CLOSELY * epsilon) * best.lower;
        if shortest.as_ref().is_some_and(|(_, length)| *length <= scale_by_power_of_two(enough, frame.exponent)) {
            break;
        }
    }
    shortest
}

/// A zonotope of the frame with generators in doubles, enlarged until all points are inside.
fn contained<const D: usize>(
    points: &[[f64; D]],
    frame: &Frame<D>,
    center: [f64; D],
    generators: &[[f64; D]],
) -> Option<(Zonotope<D>, f64)> {
    // Turned out of a frame, generators may leave the hull of the points; the axes bring them back.
    let axes = (0..D).map(|axis| std::array::from_fn(|c| f64::from(u8::from(axis == c))));
    let units = generators.iter().map(|g| frame.outside(&g.map(|c| c / length(g))));
    let directions: Vec<[f64; D]> = units.chain(axes).collect();
    let lengths = generators.iter().map(|g| scale_by_power_of_two(length(g), frame.exponent));
    let coefficients: Vec<f64> = lengths.chain([0.0; D]).collect();
    let weights = vec![1.0; directions.len()];
    let problem = FixedDirections::new(points, &directions, &weights).ok()?;
    let coefficients = contain_guess(&problem, frame.point(&center), &coefficients)?;
    let mut generators: Vec<[f64; D]> = Vec::with_capacity(directions.len() + D);
    // Σ |c_i v_i − g_i| along each axis is all that rounding can have taken from a point.
    let mut lost: [Dyadic; D] = std::array::from_fn(|_| Dyadic::zero());
    for (v, &c) in directions.iter().zip(&coefficients).filter(|(_, c)| **c > 0.0) {
        let generator = v.map(|v| v * c);
        for ((lost, v), g) in lost.iter_mut().zip(v).zip(&generator) {
            let rest = &Dyadic::from_f64(*v) * &Dyadic::from_f64(c) - Dyadic::from_f64(*g);
            *lost = &*lost + &rest.abs();
        }
        generators.push(generator);
    }
    for (axis, lost) in lost.iter().enumerate().filter(|(_, lost)| !lost.is_zero()) {
        let mut generator = [0.0; D];
        generator[axis] = rounded_towards(lost, f64::INFINITY);
        generators.push(generator);
    }
    let length = length_above(&generators);
    let zonotope = Zonotope::new(frame.point(&center), generators).ok()?;
    length.is_finite().then_some((zonotope, length))
}
