//! The least zonotope along directions that grow in number, with a lower bound for all directions: what the methods share.

use super::answer::{LengthForce, MinLengthError, MinLengthZonotope};
use super::containment::around;
use super::dual_zonotope::far_vertices;
use super::frame::Frame;
use super::in_the_plane::edge_directions;
use crate::enclosing::fixed_directions::{Generation, balanced, dot, first_non_finite};
use crate::enclosing::outward::rounded_towards;
use crate::numeric::dyadic::{Dyadic, scale_by_power_of_two};
use crate::numeric::tolerance::UNIT;
use crate::tally::Tally;
use crate::zonotope::Zonotope;

/// When to look for more directions, and when to stop.
pub(super) struct Plan {
    /// The relative gap between the bounds that is small enough.
    pub(super) epsilon: f64,
    /// How often directions may be added.
    pub(super) rounds: usize,
}

/// A direction is worth adding if the dual zonotope reaches farther than the unit ball by this.
const WORTH: f64 = 1e-13;

/// More directions than this are not added.
const MOST_DIRECTIONS: usize = 2500;

pub(super) fn validate<const D: usize>(points: &[[f64; D]], epsilon: f64) -> Result<(), MinLengthError> {
    if let Some((point, coordinate, value)) = first_non_finite(points) {
        return Err(MinLengthError::NonFinite { point, coordinate, value });
    }
    if points.is_empty() {
        return Err(MinLengthError::Empty);
    }
    if epsilon > 0.0 && epsilon < 1.0 { Ok(()) } else { Err(MinLengthError::BadEpsilon(epsilon)) }
}

/// Solves along the directions that `first` gives for a number of dimensions, then along more of them.
pub(super) fn search<const D: usize>(
    points: &[[f64; D]],
    first: impl FnOnce(usize) -> Vec<[f64; D]>,
    plan: &Plan,
    tally: &mut impl Tally,
) -> Result<MinLengthZonotope<D>, MinLengthError> {
    let frame = Frame::new(points);
    let rank = frame.rank();
    if rank == 0 {
        return around_equal_points(points);
    }
    let mut directions = first(rank);
    if rank == 2 && plan.rounds > 0 {
        let flat: Vec<[f64; 2]> = frame.points.iter().map(|p| [p[0], p[1]]).collect();
        for edge in edge_directions(&flat) {
            let edge = std::array::from_fn(|c| if c < 2 { edge[c] } else { 0.0 });
            if !directions.iter().any(|v| are_near(v, &edge)) {
                directions.push(edge);
            }
        }
    }
    let mut tried = directions.len();
    let weights = vec![1.0; directions.len()];
    let mut generation = Generation::new(rank, &frame.points, directions, weights, tally);
    generation.set_precision(1e-3 * plan.epsilon.clamp(1e-10, 1e-4));
    let mut best = Best { lower: 0.0, forces: Vec::new() };
    let (mut shortest, mut times_stuck) = (None, 0);
    let mut progress = Vec::new();
    for round in 0.. {
        // Where it gets stuck, the forces are worth a look all the same, and other directions may help.
        let is_stuck = generation.run(tally).is_err();
        times_stuck += usize::from(is_stuck);
        let program = &generation.program;
        let pulls: Vec<(usize, [f64; D])> =
            program.multipliers().map(|(row, y)| (row.point, row.normal.map(|c| c * y))).collect();
        let upper: f64 = program.coefficients().iter().map(|c| c.max(0.0)).sum();
        let mut wanted = best.improve(rank, &frame.points, balanced(&pulls));
        if !is_stuck && shortest.as_ref().is_none_or(|s: &Inner<D>| upper < s.upper) {
            let used = generation.directions().iter().zip(program.coefficients());
            let generators = used.map(|(v, c)| v.map(|v| v * c.max(0.0))).collect();
            shortest = Some(Inner { upper, center: program.center(), generators });
        }
        let upper = shortest.as_ref().map_or(f64::INFINITY, |s| s.upper);
        let is_near = |best: &Best<D>| upper <= (1.0 + 0.9 * plan.epsilon) * best.lower;
        let is_last =
            times_stuck > MOST_STUCK || round >= plan.rounds || generation.directions().len() >= MOST_DIRECTIONS;
        if !is_last {
            // Between the best forces and the last ones there are often better ones.
            for share in SHARES {
                if is_near(&best) {
                    break;
                }
                let old = best.forces.iter().map(|(j, f)| (*j, f.map(|c| c * share)));
                let new = pulls.iter().map(|(j, f)| (*j, f.map(|c| c * (1.0 - share))));
                let between = balanced(&old.chain(new).collect::<Vec<_>>());
                wanted.extend(best.improve(rank, &frame.points, between));
            }
        }
        progress.push([upper, best.lower]);
        if is_last || is_near(&best) {
            break;
        }
        wanted.extend(sums_of_neighbours(generation.directions(), program.coefficients()));
        let load = |v: &[f64; D]| pulls.iter().map(|(_, f)| dot(v, f).abs()).sum::<f64>();
        let used = generation.directions().iter().zip(program.coefficients());
        let stays = used.filter(|(v, c)| **c > 0.0 || load(v) > LOADED);
        let mut directions: Vec<[f64; D]> = stays.map(|(v, _)| *v).collect();
        let before = tried;
        for direction in wanted {
            if !directions.iter().any(|v| are_near(v, &direction)) {
                directions.push(direction);
                tried += 1;
            }
        }
        if tried == before {
            break;
        }
        generation.restart(directions, LOOSE);
    }
    let program = &generation.program;
    let Inner { center, generators, .. } = shortest.unwrap_or_else(|| {
        let used = generation.directions().iter().zip(program.coefficients());
        let generators = used.map(|(v, c)| v.map(|v| v * c.max(0.0))).collect();
        Inner { upper: f64::INFINITY, center: program.center(), generators }
    });
    let (zonotope, length) = around(points, &frame, center, &generators).ok_or(MinLengthError::OutOfRange)?;
    let (lower_bound, forces) = best.proven(points, &frame);
    let ratio = if length == 0.0 { 1.0 } else { (length / lower_bound).next_up() };
    let in_units = |v: f64| scale_by_power_of_two(v, frame.exponent);
    let progress = progress.into_iter().map(|bounds| bounds.map(in_units)).collect();
    Ok(MinLengthZonotope { zonotope, length, lower_bound, ratio, forces, progress, directions: tried })
}

/// The shortest zonotope so far, in the frame.
struct Inner<const D: usize> {
    upper: f64,
    center: [f64; D],
    generators: Vec<[f64; D]>,
}

/// How often the program may get stuck before the search ends.
const MOST_STUCK: usize = 5;

/// Whether two unit vectors or their opposites are too near to tell apart: as directions they are worth the same to a relative 1e-11.
fn are_near<const D: usize>(u: &[f64; D], v: &[f64; D]) -> bool {
    let apart = |sign: f64| u.iter().zip(v).map(|(a, b)| (a - sign * b) * (a - sign * b)).sum::<f64>();
    apart(1.0).min(apart(-1.0)) < 1e-11
}

/// A generator and its nearest neighbour are often the two halves of one between them, which is shorter: its direction.
fn sums_of_neighbours<const D: usize>(directions: &[[f64; D]], coefficients: &[f64]) -> Vec<[f64; D]> {
    let longest = coefficients.iter().fold(0.0, |max: f64, c| max.max(*c));
    let used: Vec<[f64; D]> = directions
        .iter()
        .zip(coefficients)
        .filter(|(_, c)| **c > 1e-9 * longest)
        .map(|(v, &c)| v.map(|v| v * c))
        .collect();
    let cosine = |a: &[f64; D], b: &[f64; D]| dot(a, b) / (dot(a, a) * dot(b, b)).sqrt();
    let mut sums = Vec::new();
    for (i, a) in used.iter().enumerate() {
        let others = used.iter().enumerate().filter(|(j, _)| *j != i).map(|(_, b)| (cosine(a, b), b));
        let Some((cosine, b)) = others.max_by(|p, q| p.0.abs().total_cmp(&q.0.abs())) else { continue };
        if cosine.abs() > 0.5 {
            let sum: [f64; D] = std::array::from_fn(|c| a[c] + cosine.signum() * b[c]);
            let length = dot(&sum, &sum).sqrt();
            sums.push(sum.map(|c| c / length));
        }
    }
    sums
}

/// How much of the best forces so far goes into those that are looked at between.
const SHARES: [f64; 3] = [0.9, 0.7, 0.4];

/// Normals farther from being tight than this are forgotten between rounds.
const LOOSE: f64 = 0.02;

/// Directions that are not used stay if they are loaded by more than this.
const LOADED: f64 = 0.97;

fn around_equal_points<const D: usize>(points: &[[f64; D]]) -> Result<MinLengthZonotope<D>, MinLengthError> {
    let zonotope = Zonotope::new(points[0], Vec::new()).map_err(|_| MinLengthError::OutOfRange)?;
    Ok(MinLengthZonotope {
        zonotope,
        length: 0.0,
        lower_bound: 0.0,
        ratio: 1.0,
        forces: Vec::new(),
        progress: Vec::new(),
        directions: 0,
    })
}

/// The best lower bound so far, and its forces in the frame.
struct Best<const D: usize> {
    lower: f64,
    forces: Vec<(usize, [f64; D])>,
}

impl<const D: usize> Best<D> {
    /// Takes forces, made feasible, if they prove more; the directions of the vertices beyond the unit ball.
    fn improve(&mut self, rank: usize, points: &[[f64; D]], forces: Vec<(usize, [f64; D])>) -> Vec<[f64; D]> {
        let vectors: Vec<[f64; D]> = forces.iter().map(|(_, f)| *f).collect();
        let far = far_vertices(rank, &vectors, 1.0 + WORTH);
        let lower = forces.iter().map(|(j, f)| dot(f, &points[*j])).sum::<f64>() / far.radius;
        if lower > self.lower {
            let forces = forces.into_iter().map(|(j, f)| (j, f.map(|c| c / far.radius))).collect();
            *self = Self { lower, forces };
        }
        far.peaks.iter().map(|peak| peak.map(|c| c / dot(peak, peak).sqrt())).collect()
    }

    /// The bound in units of the input, computed anew and rounded down.
    fn proven(&self, points: &[[f64; D]], frame: &Frame<D>) -> (f64, Vec<LengthForce<D>>) {
        let inside: Vec<[f64; D]> = self.forces.iter().map(|(_, f)| *f).collect();
        let rounded: Vec<(usize, [f64; D])> = self.forces.iter().map(|(j, f)| (*j, frame.outside(f))).collect();
        let forces = balanced(&rounded);
        if forces.is_empty() {
            return (0.0, Vec::new());
        }
        // Turned out of the frame a force is off by a few units in the last place, and so is what it adds to a vertex; rounding to add up to
        // zero costs each force two more, the heaviest as many as there are.
        let total: f64 = inside.iter().map(|f| dot(f, f).sqrt()).sum();
        let count = forces.len() as f64;
        let turned = if frame.rank() == D { 0.0 } else { 16.0 * D as f64 };
        let radius = far_vertices(frame.rank(), &inside, f64::INFINITY).radius;
        let radius = (radius + (turned + 16.0 * count * D as f64) * UNIT * total) * (1.0 + 4.0 * UNIT);
        let mut gain = Dyadic::zero();
        for (j, force) in &forces {
            for (a, b) in force.iter().zip(&points[*j]) {
                gain = gain + &Dyadic::from_f64(*a) * &Dyadic::from_f64(*b);
            }
        }
        let mut lower = gain.ratio(&Dyadic::from_f64(radius)).min(f64::MAX);
        while lower > 0.0 && &Dyadic::from_f64(lower) * &Dyadic::from_f64(radius) > gain {
            lower = lower.next_down();
        }
        let forces = forces.into_iter().map(|(point, vector)| LengthForce { point, vector }).collect();
        (rounded_towards(&Dyadic::from_f64(lower.max(0.0)), f64::NEG_INFINITY), forces)
    }
}
