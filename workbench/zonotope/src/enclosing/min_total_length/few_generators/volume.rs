//! Stage: directions and lengths change where that makes the volume less, down to a local optimum.
//!
//! The volume of a zonotope is 8 Σ |det(g_i, g_j, g_k)|, so a generator of length 1 along u adds 8 Σ |det(u, g_i, g_j)|
//! to it at first. With these numbers as weights the linear program finds the generators, along the directions so far
//! and neighbours of theirs, that are the best to go to as long as the weights hold. The way there is cut in half until
//! the volume is less. Where no step makes it less, the angle of the neighbours is halved. The volume is no convex
//! function of the generators, so what is found is a local optimum.

use super::along::{Along, Programs, unit};
use super::moving::{around, sums_of_neighbours};
use crate::numeric::linear::{cross, dot};

/// The angle of the first neighbours.
const FIRST_ANGLE: f64 = 0.2;

/// The steps end at this angle,
const LAST_ANGLE: f64 = 1e-3;

/// or after so many.
const STEPS: usize = 40;

/// The shares of the way that are tried in a step.
const SHARES: [f64; 4] = [1.0, 0.5, 0.25, 0.125];

/// A step counts if it makes the volume less by more than this share of it.
const LEAST_GAIN: f64 = 1e-6;

/// Three eighths of the volume of a zonotope.
pub(super) fn of(zonotope: &Along<3>) -> f64 {
    let generators = zonotope.generators();
    AddedVolume::of(&generators).volume(&generators)
}

/// The zonotope of space after the descent: its volume is not greater than before, and it has no more generators.
pub(super) fn of_less_volume(programs: &Programs<'_, 3>, start: Along<3>) -> Along<3> {
    let mut best = start;
    let mut angle = FIRST_ANGLE;
    for _ in 0..STEPS {
        let generators = best.generators();
        let added = AddedVolume::of(&generators);
        let volume = added.volume(&generators);
        let centers: Vec<[f64; 3]> = generators.iter().filter_map(unit).collect();
        let around = around(3, &centers, angle);
        let Some(spread) = programs.along_weighted(&around, |u| added.along(u)) else { break };
        let ends = sums_of_neighbours(3, &spread);
        let next = SHARES.iter().find_map(|share| {
            let way = generators.iter().zip(&ends);
            let way = way.map(|(g, end)| std::array::from_fn(|c| g[c] + share * (end[c] - g[c])));
            let next = programs.along_weighted(&way.collect::<Vec<_>>(), |u| added.along(u))?;
            let reached = next.generators();
            let is_less = AddedVolume::of(&reached).volume(&reached) < (1.0 - LEAST_GAIN) * volume;
            (is_less && next.count() <= best.count()).then_some(next)
        });
        match next {
            Some(next) => best = next,
            None => angle /= 2.0,
        }
        if angle < LAST_ANGLE {
            break;
        }
    }
    best
}

/// The cross products of pairs of generators: what a short generator adds to the volume, but for a factor.
struct AddedVolume(Vec<[f64; 3]>);

impl AddedVolume {
    fn of(generators: &[[f64; 3]]) -> Self {
        let pairs = generators.iter().enumerate().flat_map(|(i, a)| generators[..i].iter().map(move |b| (a, b)));
        Self(pairs.map(|(a, b)| cross(a, b)).collect())
    }

    /// Σ |det(u, g_i, g_j)| over pairs of generators.
    fn along(&self, u: &[f64; 3]) -> f64 {
        self.0.iter().map(|normal| dot(normal, u).abs()).sum()
    }

    /// Three eighths of the volume of the zonotope of these generators.
    fn volume(&self, generators: &[[f64; 3]]) -> f64 {
        generators.iter().map(|g| self.along(g)).sum()
    }
}
