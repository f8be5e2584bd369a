//! The search by cutting planes: safe whatever the lengths and directions of the generators are, and slower than a
//! good guess where the objective is smooth.
//!
//! In the plane of the chart the objective f is convex and piecewise linear, so each piece is a plane that is nowhere
//! above f. Three pieces whose slopes have the origin between them are a model of f with a minimum.
//!
//! 1. Three such pieces are found in directions far out, each chosen to have the origin between it and those before.
//! 2. The piece of f at the minimum of the model takes the place of one of the three, such that the origin is still
//!    between their slopes; so the minimum of the model rises, as in Kelley's method, but with three planes only.
//! 3. The three planes are below the least value of f seen so far in a triangle, and the optimum is in it. When the
//!    triangle has become much smaller, the lines that miss its ellipse are summed up (`cells`).
//! 4. Among a few hundred lines the search ends as all do (`narrowing`).
//!
//! If lines are far apart, a step halves the triangle; where they nearly meet in a few points the model is nearly f
//! itself, and one step leads from such a point to the next.

use super::Searched;
use super::narrowing::{DESCENT_LINES, Missed, narrow_last};
use crate::lad::of_generators::cells::reduced::{Reduced, USUAL_LEVELS};
use crate::lad::of_generators::plane::in_doubles::{Guess, Plane, RoundedLines};
use crate::lad::of_generators::problem::Problem;
use crate::numeric::linear::cross;
use crate::numeric::reused::Reused;
use crate::tally::{Operation, Tally};

/// At most so many pieces are looked at before three have the origin between their slopes.
const PORTAL_STEPS: usize = 12;

/// At most so many pieces take the place of others.
const PLANES_LIMIT: usize = 64;

/// Lines are summed up when the triangle has become smaller by this factor.
const SHRINKING: f64 = 1.0 / 16.0;

/// Lines are summed up where at most this part of them is left.
const WORTHWHILE: f64 = 0.75;

/// The model is taken for the objective where they differ by less than this part.
const MEETING: f64 = 1e-13;

/// The optimum of all generators, seen from a point. O(n) for each plane until lines are summed up.
pub(crate) fn cutting_planes(
    problem: &Problem<'_>,
    start: [f64; 2],
    most_lines: usize,
    tally: &mut dyn Tally,
) -> Result<Searched, Missed> {
    let chart = &problem.chart;
    let whole = Reduced::whole(problem.query);
    let lost = Missed::Lost { crossing: whole.vectors.len() };
    let mut pieces = Pieces { lines: whole.lines(chart), fixed: Plane::default(), tally };
    let Some(mut portal) = Portal::found(&mut pieces, start) else { return Err(lost) };
    let mut levels: Reused<Reduced> = Reused::with_capacity(USUAL_LEVELS);
    levels.push(whole);
    let (mut best, mut least, mut area) = (start, f64::INFINITY, None);
    let mut guess = None;
    for _ in 0..PLANES_LIMIT {
        let Some(point) = portal.minimum() else { break };
        let piece = pieces.at([point[0], point[1], 1.0]);
        let (value, model) = (piece.value(point), portal.planes[0].value(point));
        if value < least {
            (best, least) = (point, value);
        }
        let is_met = least - model <= MEETING * least.abs();
        if !is_met && !portal.replace(piece) {
            break;
        }
        let Some(triangle) = Triangle::under(&portal, least) else { break };
        let before = *area.get_or_insert(triangle.area());
        if !is_met && triangle.area() > SHRINKING * before {
            continue;
        }
        area = Some(triangle.area());
        let near = triangle.guess();
        guess = Some(Guess { point: best, ..near });
        let level = levels.last().expect("there is always the whole problem");
        let reduced = level.split(chart.cell(&near, 1.0));
        pieces.tally.add(Operation::SearchStep, 1);
        pieces.tally.add(Operation::GeneratorRead, level.vectors.len() as u64);
        if !reduced.is_moderate() {
            return Err(lost);
        }
        if reduced.vectors.len() as f64 <= WORTHWHILE * level.vectors.len() as f64 {
            reduced.write_lines(chart, &mut pieces.lines);
            pieces.fixed = Plane::of(chart.line(&reduced.fixed.sum));
            levels.push(reduced);
        }
        if is_met || pieces.lines.len() <= DESCENT_LINES {
            break;
        }
    }
    narrow_last(problem, levels, pieces.lines, guess, most_lines)
}

/// The objective: lines, and the sum of those that were summed up.
struct Pieces<'t> {
    lines: RoundedLines,
    fixed: Plane,
    tally: &'t mut dyn Tally,
}

impl Pieces<'_> {
    /// The piece of the objective at a point (x, y, 1), or far out in a direction (x, y, 0).
    fn at(&mut self, place: [f64; 3]) -> Plane {
        self.tally.add(Operation::GeneratorRead, self.lines.len() as u64);
        self.lines.piece(place).plus(&self.fixed)
    }
}

/// Three planes, the slopes of which go round the origin counter-clockwise.
struct Portal {
    planes: [Plane; 3],
}

impl Portal {
    /// Three pieces of the objective with the origin between their slopes, the first one at a point.
    fn found(pieces: &mut Pieces<'_>, [x, y]: [f64; 2]) -> Option<Self> {
        let mut first = pieces.at([x, y, 1.0]);
        let mut second = pieces.at([-first.slope[0], -first.slope[1], 0.0]);
        for _ in 0..PORTAL_STEPS {
            // across the segment between both slopes, to the side of the origin
            let along = [second.slope[0] - first.slope[0], second.slope[1] - first.slope[1]];
            let turn = if area(&first.slope, &second.slope) > 0.0 { 1.0 } else { -1.0 };
            let third = pieces.at([-turn * along[1], turn * along[0], 0.0]);
            let around = |a: &Plane, b: &Plane| turn * area(&a.slope, &b.slope) > 0.0;
            match (around(&second, &third), around(&third, &first)) {
                (true, true) if turn > 0.0 => return Some(Self { planes: [first, second, third] }),
                (true, true) => return Some(Self { planes: [second, first, third] }),
                (false, true) => first = third,
                (true, false) => second = third,
                (false, false) => return None,
            }
        }
        None
    }

    /// The point at which the largest of the planes is least.
    fn minimum(&self) -> Option<[f64; 2]> {
        let [a, b, c] = &self.planes;
        let (first, second) = (a.minus(c), b.minus(c));
        zero_of(&first, &second)
    }

    /// Puts another plane in the place of one, such that the origin stays between the slopes.
    fn replace(&mut self, plane: Plane) -> bool {
        let sides = self.planes.each_ref().map(|own| area(&plane.slope, &own.slope));
        for k in 0..3 {
            let next = (k + 1) % 3;
            // the origin is between the new slope and these two
            if sides[k] >= 0.0 && sides[next] <= 0.0 && (sides[k] > 0.0 || sides[next] < 0.0) {
                self.planes[(k + 2) % 3] = plane;
                return true;
            }
        }
        false
    }
}

/// The triangle in which three planes are below a value.
struct Triangle {
    corners: [[f64; 2]; 3],
}

impl Triangle {
    fn under(portal: &Portal, value: f64) -> Option<Self> {
        let [a, b, c] = portal.planes.each_ref().map(|plane| Plane { height: plane.height - value, ..*plane });
        Some(Self { corners: [zero_of(&a, &b)?, zero_of(&b, &c)?, zero_of(&c, &a)?] })
    }

    /// Twice the area.
    fn area(&self) -> f64 {
        let [a, b, c] = self.corners;
        area(&[b[0] - a[0], b[1] - a[1]], &[c[0] - a[0], c[1] - a[1]]).abs()
    }

    /// The centre, with the ellipse through the corners that has the least area (Steiner).
    fn guess(&self) -> Guess {
        let [a, b, c] = self.corners;
        let point = [0, 1].map(|k| (a[k] + b[k] + c[k]) / 3.0);
        let across = 3.0f64.sqrt().recip();
        let sides = [[0, 1].map(|k| a[k] - point[k]), [0, 1].map(|k| (b[k] - c[k]) * across)];
        let band = sides.as_flattened().iter().fold(0.0f64, |m, c| m.max(c.abs()));
        Guess { point, band, sides }
    }
}

/// The point at which two planes are zero, if doubles have one.
fn zero_of(a: &Plane, b: &Plane) -> Option<[f64; 2]> {
    let coordinates = |plane: &Plane| [plane.slope[0], plane.slope[1], plane.height];
    let [x, y, scale] = cross(&coordinates(a), &coordinates(b));
    let point = [x / scale, y / scale];
    point.iter().all(|c| c.is_finite()).then_some(point)
}

/// Twice the area of the triangle between two vectors of the plane.
fn area(a: &[f64; 2], b: &[f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::brute_force;
    use crate::lad::of_generators::goal::Goal;
    use crate::numeric::bounded::exact;
    use crate::zonotope::query::Query;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    /// Generators of four kinds: even; around a cone; of lengths from 1 to thousands; nine in ten nearly in a plane.
    fn body(kind: usize, n: usize, random: &mut Pcg64Mcg) -> Vec<[f64; 3]> {
        let generator = |i: usize| {
            let v = [0, 1, 2].map(|_| random.random_range(-1.0..1.0f64));
            let (sin, cos) = libm::sincos(std::f64::consts::TAU * i as f64 / n as f64);
            match kind {
                0 => v,
                1 => [cos, sin, 0.5],
                2 => v.map(|c| c / (1.0 - random.random_range(0.0..1.0f64))),
                _ if i.is_multiple_of(10) => v,
                _ => [v[0], v[1], v[0] + 1e-6 * v[2]],
            }
        };
        (0..n).map(generator).collect()
    }

    #[test]
    fn the_optimum_is_found_from_any_point() {
        let random = &mut Pcg64Mcg::seed_from_u64(4);
        for kind in 0..4 {
            for n in [40, 900] {
                let mut found = 0;
                for _ in 0..10 {
                    let body = body(kind, n, random);
                    let p = [0, 1, 2].map(|_| random.random_range(-1.0..1.0));
                    let start = [0, 1].map(|_| random.random_range(-1.0..1.0));
                    let query = Query::new([0.0; 3], p, &body).expect("finite");
                    let problem = Problem::new(&query, exact(p), Goal::Gauge);
                    if let Ok(Searched::Certified(optimum, _)) = cutting_planes(&problem, start, 2 * n, &mut ()) {
                        let gauge = optimum.along.value / optimum.reach.value;
                        if n < 100 {
                            let truth = brute_force::gauge(&query).value;
                            assert!((gauge - truth).abs() <= 1e-9 * truth, "kind {kind}: {gauge} {truth}");
                        }
                        found += 1;
                    }
                }
                assert!(found >= 8, "kind {kind}, {n} generators: {found} of 10");
            }
        }
    }

    #[test]
    fn a_triangle_worked_out_by_hand() {
        let plane = |x: f64, y: f64| Plane { slope: [x, y], height: 0.0 };
        let mut portal = Portal { planes: [plane(1.0, 0.0), plane(-1.0, 1.0), plane(-1.0, -1.0)] };
        assert_eq!(portal.minimum(), Some([0.0, 0.0]));
        // x < 1, y < 1 + x and −y < 1 + x
        let triangle = Triangle::under(&portal, 1.0).expect("three corners");
        assert_eq!((triangle.corners, triangle.area()), ([[1.0, 2.0], [-1.0, 0.0], [1.0, -2.0]], 8.0));
        // the origin is between the new slope and the last two
        assert!(portal.replace(plane(2.0, 0.5)));
        assert_eq!(portal.planes.map(|plane| plane.slope), [[2.0, 0.5], [-1.0, 1.0], [-1.0, -1.0]]);
    }
}
