//! Forces at more and more points, for more and more sides, until no point is outside and no vertex beyond the unit ball.

use std::collections::BTreeSet;

use super::by_direction_net::Net;
use super::direction_net::cell_corners;
use super::even::{Even, Sight};
use super::finish::Inner;
use super::frame::Frame;
use super::lower_bound::Best;
use super::sides::Sides;
use crate::enclosing::fixed_directions::{Generation, balanced, dot};
use crate::tally::{Operation, Tally};

/// What a search has found.
pub(super) struct Found<const D: usize> {
    pub(super) inner: Inner<D>,
    /// The best length and the best lower bound after each look at all points.
    pub(super) progress: Vec<[f64; 2]>,
    /// How many sides were tried.
    pub(super) sides: usize,
}

/// More rounds than this are not taken.
const MOST_ROUNDS: usize = 400;

/// Rounds without progress after which rounding is what is left.
const MOST_IDLE: usize = 40;
const MOST_IDLE_AT_THE_END: usize = 8;

/// More products and sums than this are not spent: half a minute or less.
const MOST_WORK: f64 = 4e10;

/// Beyond this the barrier is within rounding of its limits.
const SHARPEST: f64 = 1e14;

/// By how much the barrier may be blunter or sharper in the next round.
const SLOWEST: f64 = 0.25;
const FASTEST: f64 = 16.0;

/// The squared Newton decrements that are small enough on the way and at the end.
const COARSELY: f64 = 0.2;
const FINELY: f64 = 1e-6;

/// The gap of the barrier is wanted at this multiple of what the sides and points seen so far are off by.
const AIM: f64 = 2.0;

/// Points added after a look at them.
const MOST_POINTS: usize = 16;

/// At the end the search goes along the directions of so many of the longest generators.
const MOST_DIRECTIONS: usize = 250;

/// Generators shorter than this beside the longest are noise for the search of facets.
const NOISE: f64 = 1e-12;

/// The ε of the net that the search begins with.
const COARSE: f64 = 0.1;

struct Growing<'a, const D: usize> {
    frame: &'a Frame<D>,
    even: &'a Even<'a, D>,
    rank: usize,
    sides: Sides<D>,
    /// The points with a force.
    members: Vec<usize>,
    is_member: Vec<bool>,
}

/// The least zonotope around points that span at least three dimensions.
pub(super) fn least_by_sides<const D: usize>(
    frame: &Frame<D>,
    epsilon: f64,
    best: &mut Best<D>,
    tally: &mut impl Tally,
) -> Found<D> {
    let even = Even::of(frame);
    let mut inner = even.boxed();
    let mut growing = Growing::new(frame, &even, best, &mut inner);
    let mut sharpest = inner.generators.clone();
    let (mut progress, mut tried, mut idle, mut is_last) = (Vec::new(), 0, 0, false);
    for _ in 0..MOST_ROUNDS {
        tally.add(Operation::SearchStep, 1);
        let is_settled = growing.sides.settle(if is_last { FINELY } else { COARSELY });
        let (center, generators) = growing.zonotope();
        let looked = growing.look(center, &generators);
        tally.add(Operation::PointRead, frame.points.len() as u64);
        let before = (inner.upper, best.lower);
        let value = growing.sides.value();
        let length: f64 = generators.iter().map(|g| dot(g, g).sqrt()).sum();
        if looked.reach * length < inner.upper {
            let generators = generators.iter().map(|g| g.map(|c| c * looked.reach)).collect();
            inner = Inner { upper: looked.reach * length, center, generators };
        }
        let pulls = growing.pulls();
        // Between the best forces and the last ones there are often better ones.
        let between = best.mixed(&pulls);
        let far = best.improve(growing.rank, &frame.points, pulls);
        let far_between = best.improve(growing.rank, &frame.points, between);
        if best.lower > before.1 {
            sharpest = generators;
        }
        progress.push([inner.upper, best.lower]);
        if inner.upper <= (1.0 + 0.5 * epsilon) * best.lower {
            break;
        }
        let gain = before.0 - inner.upper + best.lower - before.1;
        idle = if gain > 1e-3 * (inner.upper - best.lower) { 0 } else { idle + 1 };
        if idle > if is_last { MOST_IDLE_AT_THE_END } else { MOST_IDLE } || growing.sides.work > MOST_WORK {
            break;
        }
        let mut sides = 0;
        for peak in far.peaks.iter().chain(&far.on_circles).chain(&far_between.peaks) {
            sides += usize::from(growing.sides.part(peak));
        }
        tried += sides;
        if sides > 0 {
            growing.sides.shrink(far.radius.max(1.0));
        }
        growing.add_points(looked.outside);
        let violation = (far.radius - 1.0).max(1.0 - 1.0 / looked.reach);
        is_last = violation < 0.25 * epsilon || sides == 0 && is_last;
        let sharpness = growing.sides.sharpness;
        let factor = AIM * (length / value - 1.0) / violation.max(0.1 * epsilon);
        let factor = if is_settled { factor.clamp(SLOWEST, FASTEST) } else { SLOWEST };
        growing.sides.sharpness = (sharpness * factor).min(SHARPEST);
        growing.sides.forget();
    }
    if inner.upper > (1.0 + 0.5 * epsilon) * best.lower
        && let Some(polished) = along_generators(frame, &even, &sharpest)
        && polished.upper < inner.upper
    {
        inner = polished;
        progress.push([inner.upper, best.lower]);
    }
    Found { inner, progress, sides: tried }
}

/// The least zonotope along the directions of generators that are nearly the best ones: what these are off by counts only squared.
fn along_generators<const D: usize>(frame: &Frame<D>, even: &Even<'_, D>, generators: &[[f64; D]]) -> Option<Inner<D>> {
    let length = |g: &[f64; D]| dot(g, g).sqrt();
    let mut long: Vec<[f64; D]> = generators.iter().copied().filter(|g| length(g) > 0.0).collect();
    long.sort_by(|a, b| length(b).total_cmp(&length(a)));
    long.truncate(MOST_DIRECTIONS);
    let directions = long.iter().map(|g| g.map(|c| c / length(g)));
    // these alone may hardly span
    let directions: Vec<[f64; D]> = frame.long.iter().copied().chain(directions).collect();
    let weights = vec![1.0; directions.len()];
    let mut generation = Generation::new(frame.rank(), &frame.points, directions, weights, &mut ());
    generation.run(&mut ()).ok()?;
    Some(stretched(Inner::along(&generation), even))
}

/// A zonotope, longer where it does not hold all points.
fn stretched<const D: usize>(inner: Inner<D>, even: &Even<'_, D>) -> Inner<D> {
    let reach = even.reach(inner.center, &inner.generators);
    let generators = inner.generators.iter().map(|g| g.map(|c| c * reach)).collect();
    Inner { upper: inner.upper * reach, center: inner.center, generators }
}

/// What a look at all points found.
struct Looked<const D: usize> {
    /// The zonotope contains all points when its generators are so much longer.
    reach: f64,
    /// Points outside, the farthest first, with the normals of the facets that they see.
    outside: Vec<(usize, [f64; D])>,
}

impl<'a, const D: usize> Growing<'a, D> {
    /// Begins with a coarse net where that is cheap, else with the farthest points along the axes.
    fn new(frame: &'a Frame<D>, even: &'a Even<'a, D>, best: &mut Best<D>, inner: &mut Inner<D>) -> Self {
        let rank = frame.rank();
        if rank == 3
            && let Some(growing) = Self::from_net(frame, even, best, inner)
        {
            return growing;
        }
        let mut growing = Self {
            frame,
            even,
            rank,
            sides: Sides::new(rank),
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

    /// Begins with the least zonotope along a coarse net: the points that it touches, their forces, and as many sides as keep these in their place.
    fn from_net(frame: &'a Frame<D>, even: &'a Even<'a, D>, best: &mut Best<D>, inner: &mut Inner<D>) -> Option<Self> {
        let rank = frame.rank();
        let net = Net::Cells.directions(rank, COARSE);
        let weights = vec![1.0; net.len()];
        let mut generation = Generation::new(rank, &frame.points, net, weights, &mut ());
        generation.set_precision(1e-6);
        generation.run(&mut ()).ok()?;
        let program = &generation.program;
        let pulls: Vec<(usize, [f64; D])> =
            program.multipliers().map(|(row, y)| (row.point, row.normal.map(|c| c * y))).collect();
        let forces = balanced(&pulls);
        if forces.len() < 2 {
            return None;
        }
        let along_net = stretched(Inner::along(&generation), even);
        if along_net.upper < inner.upper {
            *inner = along_net;
        }
        let far = best.improve(rank, &frame.points, forces.clone());
        let members: Vec<usize> = forces.iter().map(|(j, _)| *j).collect();
        let points = members.iter().map(|&j| frame.points[j]).collect();
        let mut is_member = vec![false; frame.points.len()];
        for &j in &members {
            is_member[j] = true;
        }
        let cells = (members.len() as f64).sqrt().ceil() as usize * 2;
        let directions: Vec<[f64; D]> = far.peaks.into_iter().chain(cell_corners(cells)).collect();
        let mut sides = Sides::begun(rank, points, forces.into_iter().map(|(_, f)| f).collect(), &directions);
        sides.sharpness = sides.sets() as f64 / (far.radius - 1.0).max(1e-4);
        sides.shrink(far.radius.max(1.0));
        Some(Self { frame, even, rank, sides, members, is_member })
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
            self.sides.add_point(std::array::from_fn(|c| points[point][c] - points[first][c]), *pull);
        }
        self.members.push(point);
    }

    fn add_points(&mut self, outside: Vec<(usize, [f64; D])>) {
        let mut added = BTreeSet::new();
        for (_, normal) in outside {
            let point = self.farthest(&normal);
            self.add(point, &normal);
            added.insert(point);
            if added.len() >= MOST_POINTS {
                break;
            }
        }
    }

    fn pulls(&self) -> Vec<(usize, [f64; D])> {
        let forces = self.members.iter().copied().zip(self.sides.forces().iter().copied());
        balanced(&forces.collect::<Vec<_>>())
    }

    fn zonotope(&self) -> ([f64; D], Vec<[f64; D]>) {
        let generators = self.sides.generators();
        let first = self.members.first().map_or([0.0; D], |&j| self.frame.points[j]);
        let center = generators.iter().fold(first, |sum, g| std::array::from_fn(|c| sum[c] + g[c]));
        let longest = generators.iter().map(|g| dot(g, g)).fold(0.0, f64::max).sqrt();
        let long = generators.into_iter().filter(|g| dot(g, g).sqrt() > NOISE * longest);
        (center, long.collect())
    }

    fn look(&self, center: [f64; D], generators: &[[f64; D]]) -> Looked<D> {
        let mut least: f64 = 1.0;
        let mut outside = Vec::new();
        for (j, sight) in self.even.sights(center, generators).enumerate() {
            let (gauge, normal) = match sight {
                Sight::Facet { gauge, normal } => (gauge, normal),
                Sight::OffSpan { normal } => (0.0, normal),
                Sight::Center => continue,
            };
            least = least.min(gauge);
            if gauge < 1.0 - 1e-14 && !self.is_member[j] {
                outside.push((gauge, j, normal));
            }
        }
        outside.sort_by(|a, b| a.0.total_cmp(&b.0));
        let outside = outside.into_iter().map(|(_, j, normal)| (j, normal)).collect();
        Looked { reach: 1.0 / least, outside }
    }
}
