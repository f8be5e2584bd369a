//! Directions and half-lengths of generators around points, guessed in doubles: nothing here is proved.
//!
//! The aim is the least expected number of overlaps of a node with its like ([`BoundingVolume::expected_overlaps`]), or
//! the least volume. An enclosing program has a linear aim, so it is solved with the derivatives of the aim as weights,
//! at the answer before.
//!
//! | file | what it finds |
//! |---|---|
//! | `boxes` | orthogonal directions, by turning a box until no turn makes it better |
//! | `covering` | half-lengths along given directions, by the enclosing program with weights that follow the aim |
//! | `descent` | directions and half-lengths, by moving all generators as long as the aim falls |
//! | `directions` | few directions: from dictionaries, then by descents from changed ones |
//! | `normals` | the normals of pairs of directions, and how far points reach along them |
//! | `program` | the least x ≥ 0 of a few inequalities, by a simplex method on a dense table |
//!
//! [`BoundingVolume::expected_overlaps`]: crate::bvh::BoundingVolume::expected_overlaps

mod boxes;
mod covering;
mod descent;
mod directions;
mod normals;
mod program;

use self::covering::{Aim, Covering, unit};
use self::descent::descend;

/// Steps of a descent to a local optimum.
const STEPS_OF_AN_OPTIMUM: usize = 200;

/// Half-lengths below this share of the longest are none: what rounding makes larger than 0.
const UNUSED: f64 = 1e-7;

/// A guess: unit vectors with half-lengths around a centre.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Fitted {
    pub(super) center: [f64; 3],
    pub(super) directions: Vec<[f64; 3]>,
    pub(super) half_lengths: Vec<f64>,
}

impl Fitted {
    /// The box of all points with coordinates of magnitude at most 1.
    pub(super) fn unit_cube() -> Self {
        Self { center: [0.0; 3], directions: boxes::AXES.to_vec(), half_lengths: vec![1.0; 3] }
    }
}

/// Points in a frame of their own, in which their box has the half-length 1.
struct Local {
    points: Vec<[f64; 3]>,
    center: [f64; 3],
    size: f64,
}

impl Local {
    fn new(points: &[[f64; 3]]) -> Self {
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for point in points {
            for k in 0..3 {
                low[k] = low[k].min(point[k]);
                high[k] = high[k].max(point[k]);
            }
        }
        let center: [f64; 3] = std::array::from_fn(|k| 0.5 * (low[k] + high[k]));
        let size = (0..3).map(|k| 0.5 * (high[k] - low[k])).fold(0.0, f64::max);
        let size = if size > f64::MIN_POSITIVE { size } else { 1.0 };
        let local = |p: &[f64; 3]| std::array::from_fn(|k| (p[k] - center[k]) / size);
        Self { points: points.iter().map(local).collect(), center, size }
    }

    fn fitted(&self, covering: Covering) -> Fitted {
        Fitted {
            center: std::array::from_fn(|k| self.center[k] + self.size * covering.center[k]),
            half_lengths: covering.half_lengths.iter().map(|c| c * self.size).collect(),
            directions: covering.directions,
        }
    }
}

/// A box in any position.
pub(super) fn fit_box(points: &[[f64; 3]]) -> Fitted {
    let local = Local::new(points);
    local.fitted(boxes::search(&local.points))
}

/// A zonotope of at most `count` generators, no worse than the box; `effort` bounds the changes that are tried.
pub(super) fn fit(points: &[[f64; 3]], count: usize, effort: usize) -> Fitted {
    let local = Local::new(points);
    let start = boxes::search(&local.points);
    local.fitted(directions::search(&local.points, start, count, effort))
}

/// A zonotope of at most `most` generators, no worse than the box, of the least predicted cost: `cost_of_test` tells
/// that of a test of a node with so many generators.
pub(super) fn fit_by_cost(
    points: &[[f64; 3]],
    most: usize,
    cost_of_test: impl Fn(usize) -> f64,
    effort: usize,
) -> Fitted {
    let local = Local::new(points);
    let start = boxes::search(&local.points);
    local.fitted(directions::search_by_cost(&local.points, start, most, cost_of_test, effort))
}

/// A zonotope along given directions, zero ones left out; the box along the axes where they do not serve.
pub(super) fn refit(points: &[[f64; 3]], directions: &[[f64; 3]]) -> Fitted {
    let local = Local::new(points);
    let kept: Vec<[f64; 3]> = directions.iter().copied().filter(|d| *d != [0.0; 3]).collect();
    let found = Covering::along(Aim::EXPECTED_OVERLAPS, &local.points, &kept);
    local.fitted(found.unwrap_or_else(|| boxes::along(&local.points, boxes::AXES)))
}

/// A local optimum of the volume from given directions, without those of no length; `None` where they nearly lie in a
/// plane.
pub(super) fn fit_volume(points: &[[f64; 3]], directions: &[[f64; 3]]) -> Option<Fitted> {
    let local = Local::new(points);
    let directions: Vec<[f64; 3]> = directions.iter().filter_map(unit).collect();
    let start = Covering::along(Aim::VOLUME, &local.points, &directions)?;
    let mut found = local.fitted(descend(&local.points, start, STEPS_OF_AN_OPTIMUM));
    let longest = found.half_lengths.iter().fold(0.0, |m: f64, c| m.max(*c));
    let mut lengths = found.half_lengths.iter();
    found.directions.retain(|_| lengths.next().is_some_and(|length| *length > UNUSED * longest));
    found.half_lengths.retain(|length| *length > UNUSED * longest);
    Some(found)
}
