//! A direction that separates the origin from a convex body of which the lowest point along a direction is known: the
//! search of Gilbert, Johnson and Keerthi, in doubles. It proves nothing.

use super::SeparatingDirection;
use crate::collision::distance::NearestSimplex;
use crate::numeric::linear::dot;

/// Steps of a search; a separation with a gap takes a few, and where there is none the simplex is soon full.
const STEP_LIMIT: usize = 24;

/// The search ends where the nearest point is within this share of the farthest vertex, as squares: the origin is on
/// the body to rounding.
const RELATIVE_DISTANCE: f64 = 1e-28;

/// The search ends where the lowest point along a direction is this near to the point nearest to the origin so far, as
/// a share of its distance: no direction has a gap that is larger by as much.
const CONVERGENCE: f64 = 1e-3;

/// The lowest point of a body along a direction, and whether the direction is one that is looked for.
pub(super) struct Lowest {
    pub(super) point: [f64; 3],
    pub(super) is_found: bool,
}

/// The end of a search.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Outcome {
    /// A direction that is looked for.
    Found([f64; 3]),
    /// The origin is inside the body, as it is rounded.
    Inside,
    /// Neither of both: the origin is near the boundary, or no direction has a gap that is large enough.
    Undecided,
}

impl Outcome {
    /// The direction that was found, as one that is fixed in space.
    pub(super) fn found(self) -> Option<SeparatingDirection> {
        match self {
            Self::Found(u) => Some(SeparatingDirection::Space(u)),
            Self::Inside | Self::Undecided => None,
        }
    }
}

/// Looks for a direction: the first ones, and from their lowest points on. A `quality` above 0 asks for one along which
/// the gap is at least that share of the distance; where that is not reached, one with a gap is found all the same.
pub(super) fn search(first: &[[f64; 3]], quality: f64, mut lowest: impl FnMut(&[f64; 3]) -> Lowest) -> Outcome {
    let mut found = Outcome::Undecided;
    let mut simplex = NearestSimplex::<3>::new();
    let mut known = first.iter();
    let mut nearest = None;
    for _ in 0..STEP_LIMIT {
        let (u, is_nearest) = match (known.next(), nearest) {
            (Some(u), _) => (*u, false),
            (None, Some(nearest)) => (nearest, true),
            (None, None) => return found,
        };
        let Lowest { point, is_found } = lowest(&u);
        if is_found {
            found = Outcome::Found(u);
            if quality == 0.0 || (is_nearest && dot(&u, &point) > quality * dot(&u, &u)) {
                return found;
            }
        }
        if is_nearest && dot(&u, &point) > (1.0 - CONVERGENCE) * dot(&u, &u) {
            return found;
        }
        if simplex.has_vertex(&point) {
            continue;
        }
        let Some(next) = simplex.add(point) else { return found };
        nearest = Some(next);
        if simplex.is_full() {
            return if found == Outcome::Undecided { Outcome::Inside } else { found };
        }
        let square = dot(&next, &next);
        if square.is_nan() || square <= RELATIVE_DISTANCE * simplex.largest_square() {
            return found;
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The cube of half a side about a centre.
    fn of_cube(center: [f64; 3], half: f64, least: f64) -> Outcome {
        search(&[[1.0, 0.2, 0.3]], 0.0, |u| {
            let point = [0, 1, 2].map(|k| center[k] - half.copysign(u[k]));
            let length = dot(u, u).sqrt();
            Lowest { point, is_found: dot(u, &point) > least * length }
        })
    }

    #[test]
    fn a_cube_beside_the_origin_is_separated_and_one_about_it_is_not() {
        let Outcome::Found(u) = of_cube([0.0, 0.0, 1.5], 1.0, 0.0) else { panic!("the origin is outside") };
        assert!(u[2] > u[0].abs() + u[1].abs());
        assert_eq!(of_cube([0.1, -0.3, 0.2], 1.0, 0.0), Outcome::Inside);
    }

    #[test]
    fn a_gap_that_is_too_small_ends_the_search() {
        assert!(matches!(of_cube([0.0, 0.0, 1.5], 1.0, 0.499), Outcome::Found(_)));
        assert_eq!(of_cube([0.0, 0.0, 1.5], 1.0, 0.501), Outcome::Undecided);
    }
}
