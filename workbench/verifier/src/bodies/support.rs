//! Answers to "how far does the zonotope reach in this direction, and where".
//!
//! The exact value is h(u) = u·p + Σ |u·v_i|. The farthest points are p + Σ ±v_i with the sign of u·v_i, and any coefficient
//! in [−1, 1] where u·v_i = 0.

use std::cmp::Ordering;

use dashu_int::IBig;
use dashu_int::ops::Abs;

use crate::RELATIVE_ERROR;
use crate::exact::grid::Grid;
use crate::exact::proportion::{Proportion, check_figure};

/// An answer as it was written.
#[derive(Debug, Clone, PartialEq)]
pub struct SupportAnswer {
    /// The claimed value of the support function.
    pub value: f64,
    /// A claimed farthest point.
    pub point: Vec<f64>,
}

/// Checks the value and the point of an answer; vectors of different lengths are the caller's mistake.
///
/// `value` may err by [`RELATIVE_ERROR`] times Σ |u_j p_j| + Σ |u_j v_ij|, each coordinate of `point` by [`RELATIVE_ERROR`]
/// times |p_j| + Σ |v_ij|: what rounding leaves of sums whose terms may cancel.
pub fn check_support(
    direction: &[f64],
    center: &[f64],
    generators: &[Vec<f64>],
    answer: &SupportAnswer,
) -> Result<(), String> {
    if answer.point.len() != direction.len() {
        return Err(format!("point has {} coordinates, not {}", answer.point.len(), direction.len()));
    }
    let directions = Grid::of(direction.iter().copied());
    let lengths = Grid::of(center.iter().chain(generators.iter().flatten()).copied());
    let u: Vec<IBig> = direction.iter().map(|&component| directions.units(component)).collect();
    let placed = |vector: &[f64]| -> Vec<IBig> { vector.iter().map(|&component| lengths.units(component)).collect() };
    let dot = |v: &[IBig]| -> IBig { u.iter().zip(v).map(|(u, v)| u * v).sum() };
    let sizes = |v: &[IBig]| -> IBig { u.iter().zip(v).map(|(u, v)| (u * v).abs()).sum() };

    let p = placed(center);
    let mut value = dot(&p);
    let mut scale = sizes(&p);
    let mut corner = p.clone();
    let mut slack = vec![IBig::ZERO; p.len()];
    let mut reach: Vec<IBig> = p.iter().map(|component| component.clone().abs()).collect();
    for generator in generators {
        let v = placed(generator);
        let along = dot(&v);
        let sign = along.cmp(&IBig::ZERO);
        for (axis, component) in v.iter().enumerate() {
            match sign {
                Ordering::Greater => corner[axis] += component,
                Ordering::Less => corner[axis] -= component,
                Ordering::Equal => slack[axis] += component.clone().abs(),
            }
            reach[axis] += component.clone().abs();
        }
        value += along.abs();
        scale += sizes(&v);
    }

    let tolerance = Proportion::of_double(RELATIVE_ERROR);
    let exponent = directions.exponent() + lengths.exponent();
    let allowed = Proportion::whole(scale, exponent).times(&tolerance);
    check_figure("value", answer.value, &Proportion::whole(value, exponent), &allowed)?;
    let units = |number: &IBig| Proportion::whole(number.clone(), lengths.exponent());
    for (axis, &coordinate) in answer.point.iter().enumerate() {
        let name = format!("coordinate {} of point", axis + 1);
        let rounding = units(&reach[axis]).times(&tolerance);
        if coordinate.is_infinite() {
            // the farthest point that lies farthest out on that side is beyond the range of doubles, or none is
            let outmost = if coordinate > 0.0 { &corner[axis] + &slack[axis] } else { &corner[axis] - &slack[axis] };
            check_figure(&name, coordinate, &units(&outmost), &rounding)?;
        } else {
            check_figure(&name, coordinate, &units(&corner[axis]), &rounding.plus(&units(&slack[axis])))?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_square_by_hand() {
        let generators = [vec![1.0, 0.0], vec![0.0, 1.0]];
        let check = |direction: [f64; 2], value: f64, point: [f64; 2]| {
            let answer = SupportAnswer { value, point: point.to_vec() };
            check_support(&direction, &[5.0, 5.0], &generators, &answer)
        };
        assert_eq!(check([1.0, 2.0], 18.0, [6.0, 6.0]), Ok(()));
        assert_eq!(check([-1.0, 0.0], -4.0, [4.0, 5.5]), Ok(()), "any point of the edge");
        assert!(check([1.0, 2.0], 18.0, [6.0, 4.0]).is_err());
        assert!(check([1.0, 2.0], 18.001, [6.0, 6.0]).is_err());
        assert!(check([-1.0, 0.0], -4.0, [4.0, 7.0]).is_err());
        assert!(check([1.0, 2.0], f64::INFINITY, [6.0, 6.0]).is_err());
    }

    #[test]
    fn values_beyond_the_range_of_doubles() {
        let answer = SupportAnswer { value: f64::INFINITY, point: vec![1e200] };
        assert_eq!(check_support(&[1e200], &[0.0], &[vec![1e200]], &answer), Ok(()));
        let answer = SupportAnswer { value: 0.0, point: vec![1e-200] };
        assert_eq!(check_support(&[1e-200], &[0.0], &[vec![-1e-200]], &answer), Ok(()));
        // every point of the body is a farthest one, some of them beyond the range
        let generators = [vec![f64::MAX], vec![1e300]];
        let check = |coordinate: f64| {
            check_support(&[0.0], &[1.0], &generators, &SupportAnswer { value: 0.0, point: vec![coordinate] })
        };
        assert_eq!((check(f64::INFINITY), check(f64::NEG_INFINITY), check(1e308)), (Ok(()), Ok(()), Ok(())));
        let within = SupportAnswer { value: 0.0, point: vec![f64::INFINITY] };
        assert!(check_support(&[0.0], &[1.0], &[vec![1e308]], &within).is_err());
    }
}
