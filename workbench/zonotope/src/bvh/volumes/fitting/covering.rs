//! Half-lengths along given directions around points, by the enclosing program over all their facet normals.

use super::normals::{Normal, heights, normals_of_pairs};
use super::program::Program;
use crate::numeric::linear::{cross, dot, euclidean_norm};

/// Coordinates of centres are at least the opposite of this: of points at most 1, no centre is farther out.
const FARTHEST_CENTER: f64 = 2.0;

/// Programs solved with the derivatives at the answer before as weights.
const REWEIGHTINGS: usize = 1;

/// Three directions span less than this volume: they are near a plane, where the program forgets what is across it.
const FLAT: f64 = 0.02;

/// A program whose answer leaves points farther outside than this has failed.
const LARGEST_MISS: f64 = 1e-6;

/// The aim of a covering, which is to be small: a sum of V1 V2 and V3, each with a factor, in intrinsic volumes:
/// twice the mean width, half the surface and the volume.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Aim {
    pub(super) of_surface: f64,
    pub(super) of_volume: f64,
}

impl Aim {
    /// The expected number of overlaps with its like, up to a constant.
    pub(super) const EXPECTED_OVERLAPS: Self = Self { of_surface: 1.0, of_volume: 2.0 };

    /// The volume.
    pub(super) const VOLUME: Self = Self { of_surface: 0.0, of_volume: 1.0 };
}

/// A zonotope around points, in doubles.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Covering {
    pub(super) aim: Aim,
    pub(super) center: [f64; 3],
    pub(super) directions: Vec<[f64; 3]>,
    pub(super) half_lengths: Vec<f64>,
}

impl Covering {
    /// The value of its aim.
    pub(super) fn value(&self) -> f64 {
        let sums = Sums::of(&self.directions, &self.half_lengths);
        self.aim.of_surface * sums.length * sums.area + self.aim.of_volume * sums.volume
    }

    /// The derivatives of the value by the half-lengths, none negative.
    pub(super) fn weights(&self) -> Vec<f64> {
        Sums::of(&self.directions, &self.half_lengths).derivatives(self.aim)
    }

    /// The covering along given directions, re-weighted; `None` where they nearly lie in a plane.
    pub(super) fn along(aim: Aim, points: &[[f64; 3]], directions: &[[f64; 3]]) -> Option<Self> {
        let mut best = Self::with_weights(aim, points, directions, vec![1.0; directions.len()])?;
        for _ in 0..REWEIGHTINGS {
            let Some(next) = Self::with_weights(aim, points, directions, best.weights()) else { break };
            if next.value() >= best.value() {
                break;
            }
            best = next;
        }
        Some(best)
    }

    /// The covering of least weight along given directions; `None` where they nearly lie in a plane.
    pub(super) fn with_weights(
        aim: Aim,
        points: &[[f64; 3]],
        directions: &[[f64; 3]],
        weights: Vec<f64>,
    ) -> Option<Self> {
        if !span_space(directions) {
            return None;
        }
        let heaviest = weights.iter().fold(0.0, |m: f64, w| m.max(*w));
        let weights = if heaviest > 0.0 && heaviest.is_finite() {
            // a direction that costs nothing would grow without need
            weights.iter().map(|w| (w / heaviest).max(1e-3)).collect()
        } else {
            vec![1.0; directions.len()]
        };
        let normals = normals_of_pairs(directions);
        let heights = heights(points, &normals);
        let mut program = Program::with_room(3 + directions.len(), 2 * normals.len());
        for (Normal { unit: u, .. }, [low, high]) in normals.iter().zip(&heights) {
            let extents = || directions.iter().map(|d| dot(d, u).abs());
            let shift = FARTHEST_CENTER * (u[0] + u[1] + u[2]);
            program.add_inequality(u.iter().copied().chain(extents()), high + shift);
            program.add_inequality(u.iter().map(|c| -c).chain(extents()), -low - shift);
        }
        let costs: Vec<f64> = [0.0; 3].into_iter().chain(weights).collect();
        let found = program.minimize(&costs)?;
        let center = [0, 1, 2].map(|k| found[k] - FARTHEST_CENTER);
        let mut half_lengths = found[3..].to_vec();
        // what rounding left outside: the extents of unit vectors that span space add up to a good part of 1
        let missing = normals.iter().zip(&heights).map(|(Normal { unit: u, .. }, [low, high])| {
            let reach: f64 = directions.iter().zip(&half_lengths).map(|(d, c)| c * dot(d, u).abs()).sum();
            let middle = dot(&center, u);
            f64::max(high - middle, middle - low) - reach
        });
        let missing = missing.fold(0.0, f64::max);
        if missing.is_nan() || missing > LARGEST_MISS {
            return None;
        }
        half_lengths.iter_mut().for_each(|c| *c += 2.0 * missing);
        Some(Self { aim, center, directions: directions.to_vec(), half_lengths })
    }
}

/// Whether directions span space, and not nearly a plane alone.
fn span_space(directions: &[[f64; 3]]) -> bool {
    let volumes = directions.iter().enumerate().flat_map(|(k, c)| {
        directions[..k].iter().enumerate().flat_map(move |(j, b)| {
            let normal = cross(b, c);
            directions[..j].iter().map(move |a| dot(a, &normal).abs())
        })
    });
    let unique = |(k, d): (usize, &[f64; 3])| {
        directions[..k].iter().all(|e| euclidean_norm(&cross(d, e)) > FLAT) && unit(d).is_some()
    };
    volumes.fold(0.0, f64::max) > FLAT && directions.iter().enumerate().all(unique)
}

/// The intrinsic volumes of a zonotope: V1, V2, V3, and the derivatives of the last two by its half-lengths.
struct Sums {
    length: f64,
    area: f64,
    volume: f64,
    by_area: Vec<f64>,
    by_volume: Vec<f64>,
}

impl Sums {
    fn of(directions: &[[f64; 3]], half_lengths: &[f64]) -> Self {
        let count = directions.len();
        let length = 2.0 * half_lengths.iter().sum::<f64>();
        let (mut area, mut volume) = (0.0, 0.0);
        let (mut by_area, mut by_volume) = (vec![0.0; count], vec![0.0; count]);
        for k in 0..count {
            for j in 0..k {
                let normal = cross(&directions[j], &directions[k]);
                let sine = 4.0 * euclidean_norm(&normal);
                area += sine * half_lengths[j] * half_lengths[k];
                by_area[j] += sine * half_lengths[k];
                by_area[k] += sine * half_lengths[j];
                for i in 0..j {
                    let [a, b, c] = [half_lengths[i], half_lengths[j], half_lengths[k]];
                    let part = 8.0 * dot(&directions[i], &normal).abs();
                    volume += part * a * b * c;
                    by_volume[i] += part * b * c;
                    by_volume[j] += part * a * c;
                    by_volume[k] += part * a * b;
                }
            }
        }
        Self { length, area, volume, by_area, by_volume }
    }

    /// The derivatives of an aim.
    fn derivatives(&self, aim: Aim) -> Vec<f64> {
        let derivative = |(by_area, by_volume): (&f64, &f64)| {
            aim.of_surface * (2.0 * self.area + self.length * by_area) + aim.of_volume * by_volume
        };
        self.by_area.iter().zip(&self.by_volume).map(derivative).collect()
    }
}

/// The unit vector along another one, if that is long enough to have a direction.
pub(super) fn unit(v: &[f64; 3]) -> Option<[f64; 3]> {
    let length = euclidean_norm(v);
    (length > 1e-9 && length.is_finite()).then(|| v.map(|c| c / length))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cube_costs_its_intrinsic_volumes() {
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let corners: Vec<[f64; 3]> =
            (0..8).map(|i| [0, 1, 2].map(|k| if i >> k & 1 == 0 { -1.0 } else { 1.0 })).collect();
        let found = Covering::along(Aim::EXPECTED_OVERLAPS, &corners, &axes).expect("they span space");
        assert!((found.value() - (6.0 * 12.0 + 16.0)).abs() < 1e-9);
        // by a half-length: 2 · 12 + 6 · 8 + 2 · 8
        assert!(found.weights().iter().all(|w| (w - 88.0).abs() < 1e-9));
        let flat = [axes[0], axes[1], [0.8, 0.6, 0.0]];
        assert_eq!(Covering::along(Aim::EXPECTED_OVERLAPS, &corners, &flat), None);
        let by_volume = Covering::along(Aim::VOLUME, &corners, &axes).expect("they span space");
        assert!((by_volume.value() - 8.0).abs() < 1e-9 && by_volume.weights().iter().all(|w| (w - 8.0).abs() < 1e-9));
    }
}
