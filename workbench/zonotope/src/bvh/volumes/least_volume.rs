//! Zonotopes around points whose volume no small move of their generators makes less: local optima, from many starts.
//!
//! # Statement
//! Input: points of space, a number of generators, a number of starts and a seed. Output: a zonotope around all points
//! for each start from which one was found. That none is smaller is not proved; the hull of the points has a volume
//! that no zonotope around them undercuts.
//!
//! # Source
//! Section 7 asks how fast the zonotope of least volume is computed, and how many generators it has. The paper has the
//! least total length in its place.
//!
//! # Method
//! 1. Random directions, and half-lengths along them by linear programs with the derivatives of the volume as weights.
//! 2. All generators moved at once by linear programs of small steps, as long as the volume falls.
//! 3. Generators without length are left out, and the body grows about its centre until it contains every point.
//!
//! # Complexity
//! Some hundred linear programs of 3 K + 3 unknowns and O(K²) inequalities a start; O(K² n) for n points each.
//!
//! # Shapes
//! `points`: n × 3, in any order, equal ones allowed; generators are half-lengths.
//!
//! # Numerics
//! The descent is in doubles and ends where a step gains less than 1e-4 of the volume; containment is decided exactly.
//!
//! # Checked by
//! Solids whose least zonotopes are known: a box, a zonotope itself.
//!
//! # Example
//! ```
//! use zonotope::bvh::volumes::least_volume::local_optima;
//! let cube: Vec<[f64; 3]> = (0..8).map(|i| [0, 1, 2].map(|k| f64::from(i >> k & 1))).collect();
//! let volumes = local_optima(&cube, 3, 8, 1).into_iter().map(|body| body.exact_volume().to_f64());
//! let least = volumes.fold(f64::INFINITY, f64::min);
//! assert!((1.0..1.001).contains(&least));
//! ```

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::fitting::{Fitted, fit_volume};
use crate::zonotope::Zonotope;

/// A body that grows by more than this share was no fit.
const LARGEST_GROWTH: f64 = 1e-3;

/// Local optima of the volume among the zonotopes of at most `count` generators around points, in the order of their
/// starts; none of points in a plane.
pub fn local_optima(points: &[[f64; 3]], count: usize, starts: usize, seed: u64) -> Vec<Zonotope<3>> {
    let mut random = Pcg64Mcg::seed_from_u64(seed);
    let mut optimum = |_| {
        let directions: Vec<[f64; 3]> =
            (0..count).map(|_| std::array::from_fn(|_| random.random_range(-1.0..1.0))).collect();
        contained(points, &fit_volume(points, &directions)?)
    };
    (0..starts).filter_map(&mut optimum).collect()
}

/// The body of a fit, a little larger, so that all points are inside.
fn contained(points: &[[f64; 3]], fitted: &Fitted) -> Option<Zonotope<3>> {
    let mut growth = f64::EPSILON;
    while growth < LARGEST_GROWTH {
        let lengths = fitted.half_lengths.iter().map(|c| c * (1.0 + growth));
        let generators = fitted.directions.iter().zip(lengths).map(|(d, c)| d.map(|x| x * c)).collect();
        let body = Zonotope::new(fitted.center, generators).ok()?;
        if points.iter().all(|point| body.contains(*point) == Ok(true)) {
            return Some(body);
        }
        growth *= 8.0;
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use families::bodies::named::{cube, rhombic_dodecahedron};

    /// The least volume over that of a body itself, around its vertices.
    fn least_ratio(body: &Zonotope<3>, count: usize) -> f64 {
        let signs = |bits: usize, k: usize| if bits >> k & 1 == 0 { 1.0 } else { -1.0 };
        let sum = |bits: usize| {
            let center = body.center();
            body.generators()
                .iter()
                .enumerate()
                .fold(center, |p, (k, g)| [0, 1, 2].map(|i| p[i] + signs(bits, k) * g[i]))
        };
        let points: Vec<[f64; 3]> = (0..1 << body.generators().len()).map(sum).collect();
        let found = local_optima(&points, count, 12, 1);
        assert!(found.iter().all(|found| points.iter().all(|point| found.contains(*point) == Ok(true))));
        let volumes = found.iter().map(|found| found.exact_volume().to_f64());
        volumes.fold(f64::INFINITY, f64::min) / body.exact_volume().to_f64()
    }

    #[test]
    fn zonotopes_are_found_again_and_none_is_smaller() {
        let bodies = [(cube(), 3), (cube(), 5), (rhombic_dodecahedron(), 4), (rhombic_dodecahedron(), 6)];
        for (generators, count) in bodies {
            let body = Zonotope::new([0.0; 3], generators).expect("finite");
            let ratio = least_ratio(&body, count);
            assert!((1.0..1.01).contains(&ratio), "{count}: {ratio}");
        }
    }

    #[test]
    fn points_of_a_plane_or_too_few_directions_have_no_optimum_of_a_volume() {
        let square = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]];
        assert_eq!(local_optima(&square, 2, 4, 1), []);
        let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        assert_eq!(local_optima(&corners, 2, 4, 1), []);
        for found in local_optima(&square, 4, 4, 1) {
            assert!(square.iter().all(|point| found.contains(*point) == Ok(true)));
        }
    }
}
