//! Answers to "how far does the zonotope reach in this direction, and where".
//!
//! The exact value is h(u) = u·p + Σ |u·v_i|. The farthest points are p + Σ ±v_i with the sign of u·v_i, and any
//! coefficient in [−1, 1] where u·v_i = 0: a face, itself a zonotope. The point of an answer must lie in the face but
//! for rounding, that is, in the sum of the face and a box; that sum is a zonotope, too, and the point is held against
//! all of its facets. Coordinate by coordinate would not do: the generator (1, −1) is orthogonal to (1, 1), and the
//! point (1, 1) is within its reach on either axis, but not on both at once.

use std::cmp::Ordering;
use std::fmt::{self, Display};

use dashu_int::IBig;
use dashu_int::ops::Abs;

use crate::RELATIVE_ERROR;
use crate::collision::placed::{Body, Frame};
use crate::exact::grid::{Grid, check_finite};
use crate::exact::linear::Vector;
use crate::exact::proportion::{Proportion, check_figure};
use crate::faces::containment::one_outside;
use crate::faces::normals::TooMany;
use crate::verdict::{Stop, Verdict};

/// An answer as it was written.
#[derive(Debug, Clone, PartialEq)]
pub struct SupportAnswer {
    /// The claimed value of the support function.
    pub value: f64,
    /// A claimed farthest point.
    pub point: Vec<f64>,
}

/// The value that was proved, up to rounding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SupportProof {
    /// The value as it was written.
    pub value: f64,
}

impl Display for SupportProof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "value {:?} and point agree with the exact sums", self.value)
    }
}

/// Checks the value and the point of an answer.
///
/// `value` may err by [`RELATIVE_ERROR`] times Σ |u_j p_j| + Σ |u_j v_ij|, each coordinate of `point` by
/// [`RELATIVE_ERROR`] times |p_j| + Σ |v_ij|: what rounding leaves of sums whose terms may cancel. A coordinate beyond
/// the range of doubles is an infinity.
pub fn check_support<G: AsRef<[f64]>>(
    direction: &[f64],
    body: &Body<'_, G>,
    answer: &SupportAnswer,
) -> Verdict<SupportProof> {
    proved(direction, body, answer).into()
}

fn proved<G: AsRef<[f64]>>(
    direction: &[f64],
    body: &Body<'_, G>,
    answer: &SupportAnswer,
) -> Result<SupportProof, Stop> {
    let dimension = direction.len();
    body.check_dimension(dimension)?;
    check_finite("the question", direction)?;
    if answer.point.len() != dimension {
        return Err(format!("point has {} coordinates, not {dimension}", answer.point.len()).into());
    }
    let directions = Grid::of(direction.iter().copied());
    let frame = Frame::of(&[body], &[])?;
    let lengths = Grid::at(frame.exponent());
    let u: Vec<IBig> = direction.iter().map(|&component| directions.units(component)).collect();
    let sum = |v: &[IBig]| -> IBig { u.iter().zip(v).map(|(u, v)| u * v).sum() };
    let sizes = |v: &[IBig]| -> IBig { u.iter().zip(v).map(|(u, v)| (u * v).abs()).sum() };

    let p = frame.center(body);
    let (mut value, mut scale) = (sum(&p), sizes(&p));
    let mut face = Face { middle: p.clone(), generators: Vec::new(), reach: p.into_iter().map(Abs::abs).collect() };
    for v in frame.generators(body) {
        let along = sum(&v);
        value += along.clone().abs();
        scale += sizes(&v);
        face.add(v, along.cmp(&IBig::ZERO));
    }
    let exponent = directions.exponent() + lengths.exponent();
    let allowed = Proportion::whole(scale, exponent).times(&Proportion::of_double(RELATIVE_ERROR));
    check_figure("value", answer.value, &Proportion::whole(value, exponent), &allowed)?;
    face.check_point(&answer.point, lengths)?;
    Ok(SupportProof { value: answer.value })
}

/// The farthest points, in units of a grid.
struct Face {
    middle: Vector,
    generators: Vec<Vector>,
    /// |p_j| + Σ |v_ij| over all generators of the body, which is what rounding is measured by.
    reach: Vector,
}

impl Face {
    /// Adds a generator of the body on its side of the direction.
    fn add(&mut self, v: Vector, side: Ordering) {
        for (axis, component) in v.iter().enumerate() {
            match side {
                Ordering::Greater => self.middle[axis] += component,
                Ordering::Less => self.middle[axis] -= component,
                Ordering::Equal => {}
            }
            self.reach[axis] += component.clone().abs();
        }
        if side.is_eq() {
            self.generators.push(v);
        }
    }

    /// Accepts a point of the face, but for rounding.
    fn check_point(&self, point: &[f64], lengths: Grid) -> Result<(), Stop> {
        let ranges: Vec<[Proportion; 2]> = point
            .iter()
            .enumerate()
            .map(|(axis, &coordinate)| self.range(axis, coordinate, lengths))
            .collect::<Result<_, String>>()?;
        if self.generators.is_empty() {
            return Ok(());
        }
        // Point minus middle must be a point of the face about the origin plus one of the box of the ranges, with all
        // of them in halves of one unit.
        let exponent = ranges.iter().flatten().map(Proportion::exponent).fold(lengths.exponent(), i32::min);
        let units = |range: &[Proportion; 2]| range.each_ref().map(|end| end.floor_at(exponent));
        let up = usize::try_from(lengths.exponent() - exponent).map_err(|_| "the unit is the smallest one")?;
        let mut generators: Vec<Vector> =
            self.generators.iter().map(|v| v.iter().map(|x| (x << up) * 2).collect()).collect();
        let mut apart = Vec::with_capacity(point.len());
        for (axis, range) in ranges.iter().enumerate() {
            let [low, high] = units(range);
            let mut edge = vec![IBig::ZERO; point.len()];
            edge[axis] = &high - &low;
            generators.push(edge);
            apart.push(low + high - (&self.middle[axis] << up) * 2);
        }
        match one_outside(point.len(), &generators, &[apart]) {
            Ok(None) => Ok(()),
            Ok(Some(_)) => Err("point is not among the farthest ones".into()),
            Err(TooMany) => {
                let reason =
                    "value agrees, but the face of the farthest points has too many facets to hold `point` against";
                Err(Stop::Unchecked(reason.to_owned()))
            }
        }
    }

    /// The exact coordinates for which a coordinate may stand; an error if the face has none of them.
    fn range(&self, axis: usize, coordinate: f64, lengths: Grid) -> Result<[Proportion; 2], String> {
        let name = format!("coordinate {} of point", axis + 1);
        let units = |number: IBig| Proportion::whole(number, lengths.exponent());
        let slack: IBig = self.generators.iter().map(|v| v[axis].clone().abs()).sum();
        let rounding = units(self.reach[axis].clone()).times(&Proportion::of_double(RELATIVE_ERROR));
        if coordinate.is_infinite() {
            // A coordinate of the face that is beyond the range of doubles, if there is one.
            let sign = if coordinate > 0.0 { slack } else { -slack };
            let outmost = units(&self.middle[axis] + sign);
            check_figure(&name, coordinate, &outmost, &rounding)?;
            let largest = Proportion::of_double(f64::MAX.copysign(coordinate));
            return Ok(if coordinate > 0.0 { [largest, outmost] } else { [outmost, largest] });
        }
        check_figure(&name, coordinate, &units(self.middle[axis].clone()), &rounding.plus(&units(slack)))?;
        let rounding = if rounding.compare(&smallest()).is_lt() { rounding.plus(&smallest()) } else { rounding };
        let coordinate = Proportion::of_double(coordinate);
        Ok([coordinate.minus(&rounding), coordinate.plus(&rounding)])
    }
}

/// The smallest double: a coordinate of the last places is rounded by less.
fn smallest() -> Proportion {
    Proportion::of_double(f64::from_bits(1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::placed::Pose;

    fn check_support(
        u: &[f64],
        center: &[f64],
        generators: &[Vec<f64>],
        answer: &SupportAnswer,
    ) -> Verdict<SupportProof> {
        super::check_support(u, &Body { center, generators, pose: None }, answer)
    }

    #[test]
    fn a_posed_square_by_hand() {
        // (x, y) to (x − y, x + y) + (0, 10): the square around the origin becomes the diamond |x| + |y − 10| ≤ 2
        let pose = Pose { matrix: vec![vec![1.0, -1.0], vec![1.0, 1.0]], translation: vec![0.0, 10.0] };
        let body = Body { center: &[0.0, 0.0], generators: &[[1.0, 0.0], [0.0, 1.0]], pose: Some(&pose) };
        let check = |value: f64, point: [f64; 2]| {
            super::check_support(&[0.0, 1.0], &body, &SupportAnswer { value, point: point.to_vec() })
        };
        assert!(check(12.0, [0.0, 12.0]).is_right());
        assert!(check(11.0, [0.0, 11.0]).is_wrong() && check(12.0, [1.0, 11.0]).is_wrong());
    }

    #[test]
    fn a_square_by_hand() {
        let generators = [vec![1.0, 0.0], vec![0.0, 1.0]];
        let check = |direction: [f64; 2], value: f64, point: [f64; 2]| {
            let answer = SupportAnswer { value, point: point.to_vec() };
            check_support(&direction, &[5.0, 5.0], &generators, &answer).proof().map(|proof| proof.value)
        };
        assert_eq!(check([1.0, 2.0], 18.0, [6.0, 6.0]), Ok(18.0));
        assert_eq!(check([-1.0, 0.0], -4.0, [4.0, 5.5]), Ok(-4.0), "any point of the edge");
        assert!(check([1.0, 2.0], 18.0, [6.0, 4.0]).is_err());
        assert!(check([1.0, 2.0], 18.001, [6.0, 6.0]).is_err());
        assert!(check([-1.0, 0.0], -4.0, [4.0, 7.0]).is_err());
        assert!(check([1.0, 2.0], f64::INFINITY, [6.0, 6.0]).is_err());
    }

    #[test]
    fn values_beyond_the_range_of_doubles() {
        let answer = SupportAnswer { value: f64::INFINITY, point: vec![1e200] };
        assert!(check_support(&[1e200], &[0.0], &[vec![1e200]], &answer).is_right());
        let answer = SupportAnswer { value: 0.0, point: vec![1e-200] };
        assert!(check_support(&[1e-200], &[0.0], &[vec![-1e-200]], &answer).is_right());
        // every point of the body is a farthest one, some of them beyond the range
        let generators = [vec![f64::MAX], vec![1e300]];
        let check = |coordinate: f64| {
            check_support(&[0.0], &[1.0], &generators, &SupportAnswer { value: 0.0, point: vec![coordinate] })
                .is_right()
        };
        assert!(check(f64::INFINITY) && check(f64::NEG_INFINITY) && check(1e308));
        let within = SupportAnswer { value: 0.0, point: vec![f64::INFINITY] };
        assert!(check_support(&[0.0], &[1.0], &[vec![1e308]], &within).is_wrong());
    }

    /// The generators along a facet are decided on all axes at once.
    #[test]
    fn points_beside_a_face_within_its_reach_on_every_axis() {
        let generators = [vec![1.0, -1.0]];
        let check = |point: [f64; 2]| {
            let answer = SupportAnswer { value: 0.0, point: point.to_vec() };
            check_support(&[1.0, 1.0], &[0.0, 0.0], &generators, &answer)
        };
        for right in [[1.0, -1.0], [0.0, 0.0], [-0.25, 0.25], [0.1 + 0.2, -0.3]] {
            assert!(check(right).is_right(), "{right:?}");
        }
        for wrong in [[1.0, 1.0], [-1.0, -1.0], [0.5, 0.5], [0.25, -0.25 + 1e-11], [1.0 + 1e-11, -1.0 - 1e-11]] {
            assert!(check(wrong).is_wrong(), "{wrong:?}");
        }
        // The facet of a cube spanned by (0, 1, 1) and (0, 1, −1): a square on its corner.
        let cube = [vec![1.0, 0.0, 0.0], vec![0.0, 1.0, 1.0], vec![0.0, 1.0, -1.0]];
        let check = |y: f64, z: f64| {
            check_support(&[2.0, 0.0, 0.0], &[0.0; 3], &cube, &SupportAnswer { value: 2.0, point: vec![1.0, y, z] })
        };
        assert!(check(2.0, 0.0).is_right() && check(1.0, -1.0).is_right() && check(0.5, 1.5).is_right());
        assert!(check(2.0, 0.5).is_wrong() && check(-1.5, -1.0).is_wrong());
    }

    #[test]
    fn figures_off_by_the_smallest_double() {
        let smallest = f64::from_bits(1);
        let nothing = |value: f64, x: f64| {
            check_support(&[1.0], &[0.0], &[vec![0.0]], &SupportAnswer { value, point: vec![x] }).is_right()
        };
        assert!(nothing(0.0, 0.0) && !nothing(smallest, 0.0) && !nothing(0.0, smallest) && !nothing(0.0, -smallest));
        let nan = SupportAnswer { value: f64::NAN, point: vec![0.0] };
        assert!(check_support(&[1.0], &[0.0], &[], &nan).is_wrong());
        assert!(check_support(&[f64::NAN], &[0.0], &[], &nan).is_wrong());
    }

    #[test]
    fn rounding_is_measured_by_all_that_is_added_up() {
        // The segment from −2 to 2, whose value may err by two parts in 10¹².
        let check = |value: f64| {
            let answer = SupportAnswer { value, point: vec![2.0] };
            check_support(&[1.0], &[0.0], &[vec![1.0], vec![-1.0]], &answer)
        };
        assert!(check(2.0 + 1e-12).is_right() && check(2.0 - 1e-12).is_right());
        assert!(check(2.0 + 3e-12).is_wrong() && check(2.0 - 3e-12).is_wrong());
    }

    #[test]
    fn faces_around_the_origin_reach_beyond_the_range_of_doubles() {
        let check = |coordinate: f64, shorter: f64| {
            let answer = SupportAnswer { value: 0.0, point: vec![coordinate] };
            check_support(&[0.0], &[0.0], &[vec![f64::MAX], vec![shorter]], &answer)
        };
        assert!(check(f64::INFINITY, 1e300).is_right() && check(f64::NEG_INFINITY, 1e300).is_right());
        assert!(check(f64::INFINITY, 0.0).is_wrong() && check(f64::NEG_INFINITY, 0.0).is_wrong());
    }
}
