//! Whether a point is a minimiser, and if not, along which line to leave it.
//!
//! At a vertex where two lines cross, four slopes decide. Where more lines meet, the lines through the vertex alone decide, and
//! they form a kernel problem of their own: minus the gradient of all other lines must be a combination of their
//! normals with coefficients in [−1, 1]. Offsets do not matter for that, so the lines are moved apart at random and the problem is
//! solved again: its optimal vertex is an ordinary one and gives coefficients that are ±1 off two lines; if it is
//! unbounded, the direction of descent is that of one of the lines.

use std::cmp::Ordering;

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::cone::Cone;
use super::line_search::SearchLine;
use super::solution::{Decision, Optimal, Solution};
use super::solve::solve;
use crate::lad::of_lines::subproblem::instance::{Instance, Surroundings};
use crate::numeric::dyadic::Dyadic;
use crate::tally::Tally;

/// Lines with a normal below this size get offsets of size 1: theirs would be lost to underflow.
const SMALLEST_SIZE: f64 = 1e-200;

/// Decides at a point that is minimal along some line through it. Expected O(k) for k lines through the point.
pub(crate) fn decide(instance: &Instance, around: &Surroundings, seed: u64, tally: &mut impl Tally) -> Decision {
    match around.through[..] {
        [line] => decide_on_one(instance, around, line),
        [first, second] if instance.cross_sign(first, second) != Ordering::Equal => {
            decide_on_two(instance, around, [first, second])
        }
        _ => {
            decide_where_all_meet(instance, around).unwrap_or_else(|| decide_among_many(instance, around, seed, tally))
        }
    }
}

/// Where all lines meet and there is no linear term, as for a centrally symmetric polygon: the objective is zero there. The edges of a polygon
/// sum to zero, so all coefficients may be 1; those of a sample are not asked for.
fn decide_where_all_meet(instance: &Instance, around: &Surroundings) -> Option<Decision> {
    let lines = &around.through;
    let first = lines[0];
    let crossing = lines.iter().copied().find(|&line| instance.cross_sign(first, line) != Ordering::Equal)?;
    let sign = |line| i8::from(line != first && line != crossing);
    (lines.len() == instance.len() && instance.is_balanced()).then(|| Decision::Optimal {
        through: lines.iter().map(|&line| (line, sign(line))).collect(),
        basis: vec![first, crossing],
        face_dimension: 0,
    })
}

fn slopes(instance: &Instance, around: &Surroundings, line: u32) -> [Ordering; 2] {
    let along = SearchLine::of(instance, line);
    [true, false].map(|forward| along.slope_sign(instance, around, forward))
}

fn falling(line: u32, slopes: [Ordering; 2]) -> Option<Decision> {
    let descend = |forward| Decision::Descend { line, forward };
    match slopes {
        [Ordering::Less, _] => Some(descend(true)),
        [_, Ordering::Less] => Some(descend(false)),
        _ => None,
    }
}

fn decide_on_one(instance: &Instance, around: &Surroundings, line: u32) -> Decision {
    falling(line, slopes(instance, around, line)).unwrap_or_else(|| Decision::Optimal {
        through: Vec::new(),
        basis: vec![line],
        face_dimension: 1,
    })
}

fn decide_on_two(instance: &Instance, around: &Surroundings, [first, second]: [u32; 2]) -> Decision {
    let along = [first, second].map(|line| slopes(instance, around, line));
    falling(first, along[0]).or_else(|| falling(second, along[1])).unwrap_or_else(|| {
        let flat = along.iter().filter(|slopes| slopes.contains(&Ordering::Equal)).count();
        Decision::Optimal { through: Vec::new(), basis: vec![first, second], face_dimension: flat as u8 }
    })
}

fn decide_among_many(instance: &Instance, around: &Surroundings, seed: u64, tally: &mut impl Tally) -> Decision {
    let lines = &around.through;
    let mut random = Pcg64Mcg::seed_from_u64(seed);
    let mut offset = |line: u32| {
        let [x, y] = instance.normal(line);
        let size = x.abs() + y.abs();
        random.random_range(-1.0..1.0) * if size > SMALLEST_SIZE { size } else { 1.0 }
    };
    let offsets = lines.iter().map(|&line| offset(line)).collect();
    let moved = instance.moved_apart(lines, instance.exact_gradient(&around.signs), offsets);
    match solve(&moved, random.random(), tally) {
        Solution::Optimal(optimal) => Decision::Optimal {
            face_dimension: if instance.is_sample() { 0 } else { face_dimension(&moved, &optimal) },
            through: lines.iter().copied().zip(optimal.signs).collect(),
            basis: optimal.basis.iter().map(|&i| lines[i as usize]).collect(),
        },
        Solution::Unbounded { along, .. } => {
            let (line, forward) = along.expect("a point that is minimal along a line is left along another one");
            Decision::Descend { line: lines[line as usize], forward }
        }
    }
}

/// The dimension of the set of minimisers at a vertex: of the cone of directions along which the objective is constant.
///
/// It grows by Σ (|normal · u| − δ normal · u) in direction u, a sum of terms that are never negative: it is zero
/// iff δ normal · u ≥ 0 for each line with |δ| = 1 and normal · u = 0 for each line with |δ| < 1.
fn face_dimension(through: &Instance, optimal: &Optimal) -> u8 {
    let gradient = through.exact_gradient(&optimal.signs);
    let normals: Vec<_> = optimal.basis.iter().map(|&line| through.exact_line(line).normal).collect();
    let mut cone = Cone::Plane;
    for (line, &sign) in optimal.signs.iter().enumerate().filter(|(_, sign)| **sign != 0) {
        cone = cone.clip(&turned(through.exact_line(line as u32).normal, sign));
        if cone.dimension() == 0 {
            return 0;
        }
    }
    for (own, other) in [(0, 1), (1, 0)].into_iter().take(normals.len()) {
        let sign = basis_sign(&gradient, &normals[own], normals.get(other));
        let sides: &[i8] = if sign == 0 { &[1, -1] } else { &[sign] };
        for &side in sides {
            cone = cone.clip(&turned(normals[own].clone(), side));
        }
    }
    cone.dimension()
}

/// The coefficient of a basis line where it is 1 or −1, else 0.
fn basis_sign(gradient: &[Dyadic; 2], own: &[Dyadic; 2], other: Option<&[Dyadic; 2]>) -> i8 {
    let across = other.map_or_else(|| own.clone(), |[x, y]| [-y.clone(), x.clone()]);
    let along = |v: &[Dyadic; 2]| &v[0] * &across[0] + &v[1] * &across[1];
    let (rest, own) = (along(gradient), along(own));
    if rest.clone().abs() != own.clone().abs() { 0 } else { -(rest.sign() as i8) * own.sign() as i8 }
}

fn turned(normal: [Dyadic; 2], sign: i8) -> [Dyadic; 2] {
    if sign < 0 { normal.map(|v| -v) } else { normal }
}
