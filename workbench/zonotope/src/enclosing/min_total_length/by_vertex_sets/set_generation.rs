//! Multipliers at more and more points, for more and more sides, until no point is outside and no vertex beyond the unit ball: a Newton step, the vertices, the points, and again.

use std::collections::BTreeSet;

use super::interior::scalar::{Scalar, values};
use super::vertex_sets::Sides;
use crate::enclosing::fixed_directions::{Generation, balanced};
use crate::enclosing::min_total_length::box_coordinates::{BoxCoordinates, Sight};
use crate::enclosing::min_total_length::direction_net::{Net, cell_corners};
use crate::enclosing::min_total_length::frame::Frame;
use crate::enclosing::min_total_length::frame_zonotope::FrameZonotope;
use crate::enclosing::min_total_length::lower_bound::Best;
use crate::tally::{Operation, Tally};
use crate::zonotope::ray_exit::dot;

/// What a search has found.
pub(super) struct Found<const D: usize> {
    pub(super) inner: FrameZonotope<D>,
    /// The best length and the best lower bound after each look at all points.
    pub(super) progress: Vec<[f64; 2]>,
    /// How many sides were tried.
    pub(super) sides: usize,
}

/// More rounds than this are not taken.
const MOST_ROUNDS: usize = 400;

/// Rounds without progress after which rounding is what is left.
const MOST_IDLE: usize = 40;

/// Where rounding ends a step, the gap is widened by this factor, so many times.
const RESCUE: f64 = 100.0;
const MOST_RESCUES: usize = 4;

/// More products and sums than this are not spent: half a minute or less.
const MOST_WORK: f64 = 1e11;

/// The gap of the multipliers for the sets so far is wanted at this multiple of what the vertices are beyond the unit ball.
const AIM: f64 = 0.3;

/// And not below this multiple of ε.
const ENOUGH: f64 = 0.1;

/// Bounds are near enough at this multiple of ε: rounding takes some of the rest.
const CLOSELY: f64 = 0.25;

/// Vertices that are inside the unit ball by at most the gap may be beyond it next: their sets are added, but none farther inside than this.
const NEAR: f64 = 0.05;

/// Where vertices are beyond the unit ball by this multiple of the gap, as where a point has joined that is near another, the gap is widened to this part of what they are beyond it.
const FAR_BEYOND: f64 = 30.0;
const BACK: f64 = 0.1;

/// Points added after a look at them.
const MOST_POINTS: usize = 16;

/// Generators shorter than this beside the longest, in box coordinates, are noise for the search of facets.
const NOISE: f64 = 1e-12;

/// The ε of the net that the search begins with.
const COARSE: f64 = 0.1;

struct Growing<'a, R, const D: usize> {
    frame: &'a Frame<D>,
    coordinates: &'a BoxCoordinates<'a, D>,
    rank: usize,
    sides: Sides<'a, R, D>,
    /// The points with a multiplier.
    members: Vec<usize>,
    is_member: Vec<bool>,
}

/// The least zonotope around points that span at least three dimensions.
pub(super) fn least_by_sides<R: Scalar, const D: usize>(
    frame: &Frame<D>,
    epsilon: f64,
    best: &mut Best<D>,
    work: &mut f64,
    tally: &mut impl Tally,
) -> Found<D> {
    let coordinates = BoxCoordinates::of(frame);
    let mut inner = coordinates.boxed();
    let mut growing = Growing::<R, D>::new(frame, &coordinates, best, &mut inner);
    growing.sides.work = *work;
    let (mut progress, mut tried, mut idle, mut rescues) = (Vec::new(), 0, 0, 0);
    let (mut beyond, mut least_doubt) = (0.0, f64::INFINITY);
    for _ in 0..MOST_ROUNDS {
        tally.add(Operation::SearchStep, 1);
        growing.sides.tidy();
        let count = growing.sides.sides.len() as f64;
        let least_gap = f64::max(AIM * beyond, ENOUGH * epsilon) * growing.sides.length;
        let Some(stepped) = growing.sides.step(least_gap / count) else {
            // Slacks or loads so near the boundary that rounding takes them beyond it begin anew farther inside.
            rescues += 1;
            if rescues > MOST_RESCUES {
                break;
            }
            growing.sides.widen(RESCUE * growing.sides.mu * count);
            continue;
        };
        let (center, sides, generators) = growing.zonotope(stepped.generators);
        let gap = (stepped.mu * count / growing.sides.length).min(NEAR);
        let looked = growing.look(center, &generators);
        tally.add(Operation::PointRead, frame.points.len() as u64);
        let before = (inner.upper, best.lower);
        let length: f64 = generators.iter().map(|g| dot(g, g).sqrt()).sum::<f64>() + stepped.missed.iter().sum::<f64>();
        if looked.reach * length < inner.upper {
            let generators = generators.iter().map(|g| g.map(|c| c * looked.reach)).collect();
            let witnesses = growing.witnesses(&sides, 1.0 / looked.reach);
            inner = FrameZonotope { upper: looked.reach * length, center, generators, witnesses };
        }
        let pulls = growing.pulls();
        let far = best.improve(growing.rank, &frame.points, pulls, 1.0 - gap);
        beyond = far.radius - 1.0;
        if best.lower > before.1 {
            growing.sides.length = best.lower;
        }
        progress.push([inner.upper, best.lower]);
        if inner.upper <= (1.0 + CLOSELY * epsilon) * best.lower {
            break;
        }
        let gain = before.0 - inner.upper + best.lower - before.1;
        let doubt = stepped.mu * count / growing.sides.length + beyond + looked.reach - 1.0;
        idle = if gain > 1e-3 * (inner.upper - best.lower) || doubt < 0.98 * least_doubt { 0 } else { idle + 1 };
        least_doubt = doubt.min(least_doubt);
        if idle > MOST_IDLE || growing.sides.work > MOST_WORK {
            break;
        }
        let mut others = far.on_circles;
        others.sort_by(|a, b| dot(b, b).total_cmp(&dot(a, a)));
        others.truncate(growing.members.len() / 2);
        for peak in far.peaks.iter().chain(&others) {
            tried += usize::from(growing.sides.part(peak));
        }
        growing.sides.widen((looked.reach - 1.0).min(NEAR) * growing.sides.length);
        if beyond > FAR_BEYOND * gap {
            growing.sides.widen(BACK * beyond.min(1.0) * growing.sides.length);
        }
        let members = growing.members.len();
        growing.add_points(looked.outside);
        if growing.members.len() > members {
            (idle, least_doubt) = (0, f64::INFINITY);
        }
    }
    *work = growing.sides.work;
    Found { inner, progress, sides: tried }
}

/// A zonotope, longer where it does not hold all points.
fn stretched<const D: usize>(inner: FrameZonotope<D>, coordinates: &BoxCoordinates<'_, D>) -> FrameZonotope<D> {
    let reach = coordinates.reach(inner.center, &inner.generators);
    let generators = inner.generators.iter().map(|g| g.map(|c| c * reach)).collect();
    FrameZonotope { upper: inner.upper * reach, center: inner.center, generators, witnesses: Vec::new() }
}

/// What a look at all points found.
struct Looked<const D: usize> {
    /// The zonotope contains all points when its generators are so much longer.
    reach: f64,
    /// Points outside, the farthest first, with the normals of the facets that they see.
    outside: Vec<(usize, [f64; D])>,
}

impl<'a, R: Scalar, const D: usize> Growing<'a, R, D> {
    /// Begins with a coarse net where that is cheap, else with the farthest points along the axes.
    fn new(
        frame: &'a Frame<D>,
        coordinates: &'a BoxCoordinates<'a, D>,
        best: &mut Best<D>,
        inner: &mut FrameZonotope<D>,
    ) -> Self {
        let rank = frame.rank();
        if rank == 3
            && let Some(growing) = Self::from_net(frame, coordinates, best, inner)
        {
            return growing;
        }
        let mut growing = Self {
            frame,
            coordinates,
            rank,
            sides: Sides::new(rank, coordinates, best.lower),
            members: Vec::new(),
            is_member: vec![false; frame.points.len()],
        };
        for axis in 0..rank {
            for sign in [1.0, -1.0] {
                let u: [f64; D] = std::array::from_fn(|c| if c == axis { sign } else { 0.0 });
                growing.add(growing.farthest(&u), &u);
            }
        }
        growing
    }

    /// Begins with the least zonotope along a coarse net: the points that it touches, their multipliers, and as many sides as keep these in their place.
    fn from_net(
        frame: &'a Frame<D>,
        coordinates: &'a BoxCoordinates<'a, D>,
        best: &mut Best<D>,
        inner: &mut FrameZonotope<D>,
    ) -> Option<Self> {
        let rank = frame.rank();
        let net = Net::Cells.directions(rank, COARSE);
        let weights = vec![1.0; net.len()];
        let mut generation = Generation::new(rank, &frame.points, net, weights, &mut ());
        generation.set_precision(1e-6);
        generation.run(&mut ()).ok()?;
        let program = &generation.program;
        let pulls: Vec<(usize, [f64; D])> =
            program.multipliers().map(|(row, y)| (row.point, row.normal.map(|c| c * y))).collect();
        let multipliers = balanced(&pulls);
        if multipliers.len() < 2 {
            return None;
        }
        let along_net = stretched(FrameZonotope::along(&generation), coordinates);
        if along_net.upper < inner.upper {
            *inner = along_net;
        }
        let far = best.improve(rank, &frame.points, multipliers.clone(), 1.0);
        let multipliers: Vec<(usize, [f64; D])> =
            multipliers.into_iter().map(|(j, f)| (j, f.map(|c| c / far.radius))).collect();
        let members: Vec<usize> = multipliers.iter().map(|(j, _)| *j).collect();
        let points: Vec<[f64; D]> = members.iter().map(|&j| frame.points[j]).collect();
        let mut is_member = vec![false; frame.points.len()];
        for &j in &members {
            is_member[j] = true;
        }
        let cells = (2.0 * (members.len() as f64).sqrt()).ceil() as usize;
        let directions: Vec<[f64; D]> = far.peaks.into_iter().chain(cell_corners(cells)).collect();
        let sides =
            Sides::begun(rank, coordinates, &points, multipliers.into_iter().map(|(_, f)| f).collect(), &directions);
        Some(Self { frame, coordinates, rank, sides, members, is_member })
    }

    fn farthest(&self, u: &[f64; D]) -> usize {
        let mut far = (f64::NEG_INFINITY, 0);
        for (j, point) in self.frame.points.iter().enumerate() {
            let height = dot(u, point);
            if height > far.0 {
                far = (height, j);
            }
        }
        far.1
    }

    fn add(&mut self, point: usize, pull: &[f64; D]) {
        if std::mem::replace(&mut self.is_member[point], true) {
            return;
        }
        if let Some(&first) = self.members.first() {
            let points = &self.frame.points;
            self.sides.add_point(&points[point], &points[first], pull);
        }
        self.members.push(point);
    }

    fn add_points(&mut self, outside: Vec<(usize, [f64; D])>) {
        let mut added = BTreeSet::new();
        for (_, normal) in outside {
            let point = self.farthest(&normal);
            self.add(point, &normal);
            added.insert(point);
            if added.len() >= MOST_POINTS.max(self.members.len() / 4) {
                break;
            }
        }
    }

    fn pulls(&self) -> Vec<(usize, [f64; D])> {
        let multipliers = self.members.iter().copied().zip(self.sides.multipliers.iter().map(values));
        balanced(&multipliers.collect::<Vec<_>>())
    }

    /// The centre, from which the first point is all generators away, and those generators that are no noise, with their places.
    fn zonotope(&self, generators: Vec<[f64; D]>) -> ([f64; D], Vec<usize>, Vec<[f64; D]>) {
        let first = self.members.first().map_or([0.0; D], |&j| self.frame.points[j]);
        let center = generators.iter().fold(first, |sum, g| std::array::from_fn(|c| sum[c] + g[c]));
        let size = |g: &[f64; D]| self.coordinates.size(g);
        let longest = generators.iter().map(size).fold(0.0, f64::max);
        let is_long = |(_, g): &(usize, [f64; D])| size(g) > NOISE * longest;
        let (places, long) = generators.into_iter().enumerate().filter(is_long).unzip();
        (center, places, long)
    }

    /// The coefficients of points with multipliers: one way for the sets that hold them, the other way for the others.
    fn witnesses(&self, sides: &[usize], size: f64) -> Vec<(usize, Vec<f64>)> {
        let mut signs = vec![vec![-size; sides.len()]; self.members.len()];
        for (place, &side) in sides.iter().enumerate() {
            for member in self.sides.sides[side].members() {
                signs[member][place] = size;
            }
        }
        self.members.iter().copied().zip(signs).collect()
    }

    fn look(&self, center: [f64; D], generators: &[[f64; D]]) -> Looked<D> {
        let mut least: f64 = 1.0;
        let mut outside = Vec::new();
        // Those with a multiplier are vertices.
        let others = (0..self.is_member.len()).filter(|&j| !self.is_member[j]);
        for (j, sight) in self.coordinates.sights(center, generators, others) {
            let (gauge, normal) = match sight {
                Sight::Facet { gauge, normal } => (gauge, normal),
                Sight::OffSpan { normal } => (0.0, normal),
                Sight::Center => continue,
            };
            least = least.min(gauge);
            if gauge < 1.0 - 1e-14 {
                outside.push((gauge, j, normal));
            }
        }
        outside.sort_by(|a, b| a.0.total_cmp(&b.0));
        let outside = outside.into_iter().map(|(_, j, normal)| (j, normal)).collect();
        Looked { reach: 1.0 / least, outside }
    }
}
