//! Answers to "how high is the upper hull of a zonotope around the origin over the point p_0 of the plane".
//!
//! For every direction (x, y, 1) the hull over p_0 is no higher than Σ |a x + b y + c| − (x, y) · p_0, and where p_0
//! lies in the projection Q the lowest of these bounds is reached at a vertex of the lines a x + b y + c = 0. Where Q
//! is a segment or a point, one coordinate or none is enough. All vertices are gone through; a body with too many is
//! not checked.

use std::cmp::Ordering;

use dashu_int::IBig;
use dashu_int::ops::Abs;

use crate::exact::fraction::Fraction;
use crate::exact::grid::{Grid, check_finite};
use crate::exact::linear::{Echelon, Vector, dot};
use crate::exact::polygon::ConvexPolygon;
use crate::exact::proportion::Proportion;
use crate::exact::subsets::{count_subsets, subsets};
use crate::verdict::{Proved, Stop, Verdict};

/// The number of products of vertices and generators that are tried.
const MOST_TRIALS: u64 = 3_000_000;

/// Checks the height over p_0, which is absent beside Q, if the body is small enough for that.
pub fn check_upper_hull(generators: &[Vec<f64>], p0: [f64; 2], above_q: bool, z: Option<&Fraction>) -> Verdict<Proved> {
    lowest(generators, p0, above_q, z).into()
}

fn lowest(generators: &[Vec<f64>], p0: [f64; 2], above_q: bool, z: Option<&Fraction>) -> Result<Proved, Stop> {
    let right = Proved("the lowest of the bounds of all vertices");
    if generators.iter().any(|generator| generator.len() != 3) {
        return Err("answered a question whose generators are not in space".into());
    }
    check_finite("the question", generators.iter().flatten().chain(&p0))?;
    let grid = Grid::of(generators.iter().flatten().chain(&p0).copied());
    let p0 = grid.point(p0);
    let vectors: Vec<Vector> =
        generators.iter().map(|generator| generator.iter().map(|&x| grid.units(x)).collect()).collect();
    let shadows: Vec<[IBig; 2]> = vectors.iter().map(|v| [v[0].clone(), v[1].clone()]).collect();
    let inside = ConvexPolygon::zonogon(&[IBig::ZERO, IBig::ZERO], &shadows).contains(&p0);
    if above_q != inside {
        return Err(format!("above_q is {above_q}, but p0 lies {} Q", if inside { "in" } else { "beside" }).into());
    }
    let Some(z) = z else {
        return if inside { Err("z is missing".into()) } else { Ok(right) };
    };
    if !inside {
        return Err("there is no hull beside Q, but z is given".into());
    }

    let plane: Vec<Vector> = shadows.into_iter().map(Vec::from).collect();
    let pivots = Echelon::spanned(2, &plane).pivots();
    if count_subsets(vectors.len(), pivots.len()).saturating_mul(vectors.len() as u64) > MOST_TRIALS {
        return Err(Stop::Unchecked("too many vertices to go through".to_owned()));
    }
    let kept = |v: &[IBig]| -> Vector { pivots.iter().map(|&axis| v[axis].clone()).collect() };
    let upright: Vec<Vector> = vectors.iter().map(|v| [kept(v), vec![v[2].clone()]].concat()).collect();
    let p0 = kept(&p0);
    let mut lowest: Option<Proportion> = None;
    for subset in subsets(upright.len(), pivots.len()) {
        let span = Echelon::spanned(pivots.len() + 1, subset.iter().map(|&index| &upright[index]));
        let Ok([u]) = <[Vector; 1]>::try_from(span.complement(pivots.len() + 1)) else { continue };
        let (height, beside) = u.split_last().expect("a normal has components");
        if *height == IBig::ZERO {
            continue;
        }
        let reach: IBig = upright.iter().map(|v| dot(&u, v).abs()).sum();
        let along = dot(beside, &p0);
        let bound =
            Proportion::new(if *height < IBig::ZERO { reach + along } else { reach - along }, height.clone().abs(), 0);
        if lowest.as_ref().is_none_or(|lowest| bound.compare(lowest) == Ordering::Less) {
            lowest = Some(bound);
        }
    }
    let lowest = lowest.ok_or("no direction bounds the hull")?;
    let exact = lowest.times(&Proportion::whole(IBig::ONE, grid.exponent()));
    let claimed = Proportion::of_fraction(z);
    if claimed.compare(&exact) == Ordering::Equal {
        Ok(right)
    } else {
        Err(format!("z is {:?}, exactly it is {:?}", claimed.nearest(), exact.nearest()).into())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(generators: &[[f64; 3]], p0: [f64; 2], z: Option<(i64, i64)>) -> Result<bool, String> {
        let generators: Vec<Vec<f64>> = generators.iter().map(|generator| generator.to_vec()).collect();
        let z = z.and_then(|(numerator, denominator)| Fraction::new(numerator, denominator));
        check_upper_hull(&generators, p0, z.is_some(), z.as_ref()).proof().map(|_| true)
    }

    #[test]
    fn roofs_by_hand() {
        let tilted = [[1.0, 0.0, 1.0], [0.0, 1.0, 0.0], [0.0, 0.0, 2.0]];
        assert_eq!(check(&tilted, [0.5, 0.5], Some((5, 2))), Ok(true));
        assert_eq!(check(&tilted, [-1.0, 1.0], Some((1, 1))), Ok(true));
        assert_eq!(check(&tilted, [1.5, 0.0], None), Ok(true));
        assert!(check(&tilted, [0.5, 0.5], Some((2, 1))).is_err());
        assert!(check(&tilted, [0.5, 0.5], None).is_err());
        assert!(check(&tilted, [1.5, 0.0], Some((1, 1))).is_err());
        let roof = [[1.0, 0.0, 1.0], [1.0, 0.0, -1.0], [0.0, 1.0, 0.0]];
        assert_eq!(check(&roof, [0.5, 0.25], Some((3, 2))), Ok(true));
    }

    #[test]
    fn projections_without_area() {
        assert_eq!(check(&[[0.0, 0.0, -3.0]], [0.0, 0.0], Some((3, 1))), Ok(true));
        assert_eq!(check(&[], [0.0, 0.0], Some((0, 1))), Ok(true));
        assert_eq!(check(&[], [0.0, 1.0], None), Ok(true));
        let gable = [[1.0, 2.0, 1.0], [1.0, 2.0, -1.0]];
        assert_eq!(check(&gable, [1.0, 2.0], Some((1, 1))), Ok(true));
        assert_eq!(check(&gable, [1.0, 2.5], None), Ok(true));
    }

    /// The directions orthogonal to two of four generators, turned up, are gone through once more in small numbers.
    #[test]
    fn roofs_are_the_lowest_bounds_of_all_pairs() {
        let mut state = 1_u64;
        let mut next = |below: i64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as i64 % (2 * below + 1) - below
        };
        for _ in 0..200 {
            let body: [[i64; 3]; 4] = std::array::from_fn(|_| std::array::from_fn(|_| next(4)));
            // A point of Q: a part of each generator.
            let p0 = body.iter().fold([0, 0], |[x, y], [a, b, _]| {
                let part = next(1);
                [x + part * a, y + part * b]
            });
            let pairs = body.iter().enumerate().flat_map(|(at, v)| body[..at].iter().map(move |w| (v, w)));
            let bounds = pairs.filter_map(|(v, w)| {
                let [x, y, up] = [1, 2, 0].map(|k: usize| v[k] * w[(k + 1) % 3] - v[(k + 1) % 3] * w[k]);
                let reach: i64 = body.iter().map(|[a, b, c]| (x * a + y * b + up * c).abs()).sum();
                (up != 0).then(|| (reach - (x * p0[0] + y * p0[1]) * up.signum(), up.abs()))
            });
            let Some((z, up)) = bounds.min_by(|(z, up), (other, higher)| (z * higher).cmp(&(other * up))) else {
                continue;
            };
            let (body, p0) = (body.map(|v| v.map(|x| x as f64)), p0.map(|x| x as f64));
            assert_eq!(check(&body, p0, Some((z, up))), Ok(true), "{body:?} {p0:?}");
            assert!(check(&body, p0, Some((z + 1, up))).is_err() && check(&body, p0, Some((z - 1, up))).is_err());
        }
    }
}
