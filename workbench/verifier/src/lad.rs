//! Answers to "where is linear · x + Σ abs(normal_i · x + offset_i) least", weights multiplied into the terms.
//!
//! Coefficients δ_i in [−1, 1] with linear + Σ δ_i normal_i = 0 prove that the objective is nowhere below Σ δ_i
//! offset_i: abs(v) ≥ δ v, and what is left of the sum does not depend on x. At a point where δ_i v_i = abs(v_i) for
//! every term the objective is just that, so the point is a minimiser. Where there is no minimum, the objective falls
//! along a direction u with linear · u + Σ abs(normal_i · u) < 0, without end and from every point.

use std::cmp::Ordering;
use std::fmt::{self, Display};

use dashu_int::IBig;
use dashu_int::ops::Abs;

use crate::exact::fraction::{Fraction, common_denominator, whole_numbers};
use crate::exact::grid::{Grid, check_finite};
use crate::exact::linear::{Vector, dot, solve};
use crate::exact::proportion::Proportion;
use crate::exact::whole_direction;
use crate::verdict::Verdict;

/// The question: an objective on R^D, all of whose numbers are whole multiples of one unit.
#[derive(Debug, Clone)]
pub struct Lad<const D: usize> {
    linear: [IBig; D],
    terms: Vec<([IBig; D], IBig)>,
    /// The unit is 2^exponent.
    exponent: i32,
}

impl<const D: usize> Lad<D> {
    /// The objective with a linear term and terms (normal, offset, weight).
    ///
    /// # Errors
    /// A sentence about a number that is not finite, or about a weight that is negative.
    pub fn new(linear: [f64; D], terms: &[([f64; D], f64, f64)]) -> Result<Self, String> {
        let sides = || terms.iter().flat_map(|(normal, offset, _)| normal.iter().chain([offset]));
        let weights = || terms.iter().map(|(_, _, weight)| weight);
        check_finite("the question", linear.iter().chain(sides()).chain(weights()))?;
        if let Some(wrong) = weights().find(|weight| **weight < 0.0) {
            return Err(format!("answered a question with the weight {wrong}"));
        }
        let of_sides = Grid::of(sides().copied());
        let of_weights = Grid::of(weights().copied());
        let products = of_sides.exponent() + of_weights.exponent();
        let exponent = products.min(Grid::of(linear).exponent());
        let up = usize::try_from(products - exponent).expect("the unit is the smaller one");
        let weighed = |(normal, offset, weight): &([f64; D], f64, f64)| {
            let weight = of_weights.units(*weight) << up;
            (normal.map(|x| of_sides.units(x) * &weight), of_sides.units(*offset) * &weight)
        };
        let whole = Grid::at(exponent);
        Ok(Self { linear: linear.map(|x| whole.units(x)), terms: terms.iter().map(weighed).collect(), exponent })
    }

    /// The objective with a linear term and terms (normal, offset) whose weights are multiplied in, all of them whole
    /// numbers.
    pub fn of_whole_numbers(linear: [IBig; D], terms: Vec<([IBig; D], IBig)>) -> Self {
        Self { linear, terms, exponent: 0 }
    }
}

/// An answer as it was written.
#[derive(Debug, Clone, PartialEq)]
pub enum LadAnswer<const D: usize> {
    /// A point that is said to be a minimiser.
    Optimal {
        /// The point.
        point: [Fraction; D],
        /// The claimed minimum, if one is claimed.
        value: Option<Fraction>,
        /// The coefficient −1, 0 or 1 of each term; 0 for those of the basis.
        signs: Vec<i8>,
        /// Terms with independent normals, whose coefficients are solved for.
        basis: Vec<usize>,
    },
    /// There is said to be no minimum.
    Unbounded {
        /// A direction along which the objective falls.
        direction: [Fraction; D],
    },
}

/// The proof of an answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LadProof {
    /// The point is a minimiser.
    Optimal,
    /// There is no minimum.
    Unbounded,
}

impl Display for LadProof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Optimal => "no point has a smaller value",
            Self::Unbounded => "the values fall without end",
        })
    }
}

/// Proves that a point is a minimiser and that the minimum is what it is said to be, or that there is none; or says
/// what fails. O(n) exact operations for n terms.
pub fn check_lad<const D: usize>(question: &Lad<D>, answer: &LadAnswer<D>) -> Verdict<LadProof> {
    let checked = match answer {
        LadAnswer::Optimal { point, value, signs, basis } => {
            optimal(question, point, value.as_ref(), signs, basis).map(|()| LadProof::Optimal)
        }
        LadAnswer::Unbounded { direction } => unbounded(question, direction).map(|()| LadProof::Unbounded),
    };
    checked.into()
}

fn unbounded<const D: usize>(question: &Lad<D>, direction: &[Fraction; D]) -> Result<(), String> {
    let direction = whole_direction(direction);
    let rise: IBig = question.terms.iter().map(|(normal, _)| dot(normal, &direction).abs()).sum();
    if dot(&question.linear, &direction) + rise < IBig::ZERO {
        Ok(())
    } else {
        Err("certificate: the objective does not fall along the direction".to_owned())
    }
}

fn optimal<const D: usize>(
    question: &Lad<D>,
    point: &[Fraction; D],
    value: Option<&Fraction>,
    signs: &[i8],
    basis: &[usize],
) -> Result<(), String> {
    let count = question.terms.len();
    if signs.len() != count {
        return Err(format!("certificate: {} signs for {count} terms", signs.len()));
    }
    if let Some(wrong) = basis.iter().find(|&&term| term >= count) {
        return Err(format!("certificate: basis names term {wrong}, which does not exist"));
    }
    if let Some(wrong) = basis.iter().find(|&&term| signs[term] != 0) {
        return Err(format!(
            "certificate: the coefficient of term {wrong}, of the basis, is solved for, but one is given"
        ));
    }
    let common = common_denominator(point);
    let numerators = whole_numbers(point, &common);
    let mut total = dot(&question.linear, &numerators);
    let mut rest: Vector = question.linear.iter().map(|x| -x).collect();
    for (index, ((normal, offset), &sign)) in question.terms.iter().zip(signs).enumerate() {
        let at_point = dot(normal, &numerators) + offset * &common;
        let agrees = match sign {
            0 => at_point == IBig::ZERO,
            1 => at_point >= IBig::ZERO,
            -1 => at_point <= IBig::ZERO,
            _ => false,
        };
        if !agrees {
            return Err(format!("certificate: the sign {sign} of term {index} is not that of its value at the point"));
        }
        for (rest, component) in rest.iter_mut().zip(normal).filter(|_| sign != 0) {
            if sign > 0 { *rest -= component } else { *rest += component }
        }
        total += at_point.abs();
    }
    let columns: Vec<Vector> = basis.iter().map(|&term| question.terms[term].0.to_vec()).collect();
    let (solved, denominator) = solve(&columns.iter().collect::<Vec<_>>(), &rest)
        .ok_or("certificate: the basis is dependent, or its coefficients do not balance the others")?;
    if let Some(wrong) = solved.iter().position(|solved| solved.clone().abs() > denominator) {
        return Err(format!("certificate: the coefficient of term {}, of the basis, is not in [-1, 1]", basis[wrong]));
    }
    let exact = Proportion::new(total, common, question.exponent);
    match value.map(Proportion::of_fraction) {
        Some(claimed) if claimed.compare(&exact) != Ordering::Equal => {
            Err(format!("value is {:?}, exactly it is {:?}", claimed.nearest(), exact.nearest()))
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn whole<const D: usize>(numbers: [i64; D]) -> [Fraction; D] {
        numbers.map(|number| Fraction::new(number, 1).expect("one is not zero"))
    }

    /// |x − 1| + 2 |y| + |x + y + 1 / 2|, least at (1, 0) with the value 3 / 2: there −1 + δ = 0 along x, and along y
    /// 1 + 2 δ' = 0.
    fn three_lines() -> Lad<2> {
        let terms = [([1.0, 0.0], -1.0, 1.0), ([0.0, 1.0], 0.0, 2.0), ([1.0, 1.0], 0.5, 1.0)];
        Lad::new([0.0, 0.0], &terms).expect("finite")
    }

    fn answer(point: [i64; 2], signs: &[i8], basis: &[usize]) -> LadAnswer<2> {
        let value = Fraction::new(3, 2);
        LadAnswer::Optimal { point: whole(point), value, signs: signs.to_vec(), basis: basis.to_vec() }
    }

    #[test]
    fn a_minimum_of_the_plane_by_hand() {
        let right = answer([1, 0], &[0, 0, 1], &[0, 1]);
        assert_eq!(check_lad(&three_lines(), &right), Verdict::Right(LadProof::Optimal));
        for wrong in [
            answer([0, 0], &[0, 0, 1], &[0, 1]),
            answer([1, 0], &[0, 0, 1], &[0]),
            answer([1, 0], &[0, 0, 1], &[0, 0]),
            answer([1, 0], &[0, 0, 1], &[0, 1, 2]),
            answer([1, 0], &[0, 0, 1], &[0, 1, 3]),
            answer([1, 0], &[0, 0, 1], &[]),
            answer([1, 0], &[0, 0, -1], &[0, 1]),
            answer([1, 0], &[0, 0, i8::MIN], &[0, 1]),
            answer([1, 0], &[0, 0], &[0, 1]),
            answer([1, 0], &[0, 0, 1, 1], &[0, 1]),
            LadAnswer::Unbounded { direction: whole([1, 0]) },
            LadAnswer::Unbounded { direction: whole([0, 0]) },
        ] {
            assert!(check_lad(&three_lines(), &wrong).is_wrong(), "{wrong:?}");
        }
    }

    #[test]
    fn the_value_may_be_left_out_but_not_be_wrong() {
        let claim = |value| {
            let (point, signs, basis) = (whole([1, 0]), vec![0, 0, 1], vec![0, 1]);
            check_lad(&three_lines(), &LadAnswer::Optimal { point, value, signs, basis })
        };
        assert!(claim(None).is_right() && claim(Fraction::new(6, 4)).is_right());
        assert!(claim(Fraction::new(1, 1)).is_wrong());
    }

    #[test]
    fn coefficients_beyond_one_prove_nothing() {
        // |x| + 3 x falls to the left.
        let question = Lad::new([3.0], &[([1.0], 0.0, 1.0)]).expect("finite");
        let at_zero =
            LadAnswer::Optimal { point: whole([0]), value: Fraction::new(0, 1), signs: vec![0], basis: vec![0] };
        assert!(check_lad(&question, &at_zero).is_wrong());
        let down = |x| check_lad(&question, &LadAnswer::Unbounded { direction: whole([x]) });
        assert_eq!(down(-2), Verdict::Right(LadProof::Unbounded));
        assert!(down(1).is_wrong() && down(0).is_wrong());
    }

    #[test]
    fn three_variables_and_fractions() {
        // |x − 1/3| is least where x is 1/3: whole numbers of a third of a unit.
        let terms =
            [[3, 0, 0], [0, 1, 0], [0, 0, 1]].map(|normal| (normal.map(IBig::from), IBig::from(-normal[0] / 3)));
        let question = Lad::of_whole_numbers([0, 0, 0].map(IBig::from), terms.to_vec());
        let point = [Fraction::new(1, 3), Fraction::new(0, 1), Fraction::new(0, 5)].map(|x| x.expect("not zero"));
        let right = LadAnswer::Optimal { point, value: Fraction::new(0, 7), signs: vec![0; 3], basis: vec![0, 1, 2] };
        assert!(check_lad(&question, &right).is_right());
    }

    #[test]
    fn what_is_no_question_is_refused() {
        assert!(Lad::new([f64::NAN], &[]).is_err());
        assert!(Lad::new([0.0], &[([1.0], f64::INFINITY, 1.0)]).is_err());
        assert!(Lad::new([0.0], &[([1.0], 0.0, -1.0)]).is_err());
        let nothing = Lad::new([0.0], &[]).expect("finite");
        let anywhere = LadAnswer::Optimal { point: whole([9]), value: None, signs: vec![], basis: vec![] };
        assert!(check_lad(&nothing, &anywhere).is_right());
    }

    /// |x − 2| + |x + 2| + |x − 1|, and |x − 1| once more, with a small slope: least at 1, where the first term falls.
    #[test]
    fn terms_on_both_sides_and_terms_that_vanish() {
        let terms = [([1.0], -2.0, 1.0), ([1.0], 2.0, 1.0), ([1.0], -1.0, 1.0), ([1.0], -1.0, 1.0)];
        let judged = |slope: f64, value: Fraction, signs: [i8; 4], basis: usize| {
            let question = Lad::new([slope], &terms).expect("finite");
            let answer =
                LadAnswer::Optimal { point: whole([1]), value: Some(value), signs: signs.to_vec(), basis: vec![basis] };
            check_lad(&question, &answer)
        };
        // The slope has a finer unit than the terms: δ = ∓ 1 + 1 / 1024 balances the one sign or the other.
        let value = || Fraction::new(4 * 1024 - 1, 1024).expect("not over zero");
        let slope = -1.0 / 1024.0;
        assert!(judged(slope, value(), [-1, 1, 1, 0], 3).is_right());
        assert!(judged(slope, value(), [-1, 1, 0, 0], 3).is_right());
        assert!(judged(slope, value(), [-1, 1, 0, 1], 2).is_right());
        assert!(judged(slope, value(), [-1, 1, -1, 0], 3).is_wrong(), "δ is 1 + 1 / 1024");
        assert!(
            judged(-slope, Fraction::new(4 * 1024 + 1, 1024).expect("not over zero"), [-1, 1, -1, 0], 3).is_right()
        );
        for signs in [[1, 1, 1, 0], [-1, -1, 1, 0], [0, 1, 1, 0], [-1, 0, 1, 0]] {
            assert!(judged(slope, value(), signs, 3).is_wrong(), "{signs:?}");
        }
        assert!(judged(slope, Fraction::new(4, 1).expect("not over zero"), [-1, 1, 1, 0], 3).is_wrong());
    }
}
