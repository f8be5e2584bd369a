//! The question of a location: the exact vector from one point to another, and the generators of a zonotope.

use dashu_int::IBig;
use dashu_int::ops::Abs;

use super::placed::{Body, Frame};
use crate::exact::linear::{Vector, dot};

/// The exact vector from one point to another, and generators, all of one dimension.
#[derive(Debug, Clone)]
pub struct Displaced {
    /// The start and the end of the vector.
    pub(crate) from: Vector,
    pub(crate) to: Vector,
    pub(crate) p: Vector,
    pub(crate) generators: Vec<Vector>,
    /// Of the unit 2^exponent in which all are whole numbers.
    exponent: i32,
}

impl Displaced {
    /// The vector `to` − `from` and the generators.
    ///
    /// # Errors
    /// A sentence about dimensions that do not agree, or a number that is not finite.
    pub fn new<G: AsRef<[f64]>>(from: &[f64], to: &[f64], generators: &[G]) -> Result<Self, String> {
        Self::to_point(&Body { center: from, generators, pose: None }, to)
    }

    /// The vector from the centre of a placed body to a point, and the generators of the body: whether it contains the
    /// point.
    ///
    /// # Errors
    /// As for [`Displaced::new`]; a pose of another dimension.
    pub fn to_point<G: AsRef<[f64]>>(body: &Body<'_, G>, point: &[f64]) -> Result<Self, String> {
        Self::between(body, &Body { center: point, generators: &[], pose: None })
    }

    /// The vector from the centre of one placed body to that of another, and the generators of both, those of `a`
    /// first: whether they intersect.
    ///
    /// # Errors
    /// As for [`Displaced::to_point`].
    pub fn between<G: AsRef<[f64]>>(a: &Body<'_, G>, b: &Body<'_, G>) -> Result<Self, String> {
        let dimension = a.center.len();
        a.check_dimension(dimension)?;
        b.check_dimension(dimension)?;
        let frame = Frame::of(&[a, b], &[])?;
        let [from, to] = [a, b].map(|body| frame.center(body));
        let p = to.iter().zip(&from).map(|(to, from)| to - from).collect();
        let generators = [frame.generators(a), frame.generators(b)].concat();
        Ok(Self { from, to, p, generators, exponent: frame.exponent() })
    }

    /// The vector between two points and generators, all in units of 2^`exponent`, or of a multiple of it.
    pub(crate) fn of_vectors(from: Vector, to: Vector, generators: Vec<Vector>, exponent: i32) -> Self {
        let p = to.iter().zip(&from).map(|(to, from)| to - from).collect();
        Self { from, to, p, generators, exponent }
    }

    pub(crate) fn dimension(&self) -> usize {
        self.p.len()
    }

    /// The exponent of the unit in which the vectors are whole numbers.
    pub(crate) fn exponent(&self) -> i32 {
        self.exponent
    }

    /// The exact support function Σ |u · g_i|.
    pub(crate) fn support(&self, u: &[IBig]) -> IBig {
        self.generators.iter().map(|generator| dot(u, generator).abs()).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::super::placed::Pose;
    use super::*;

    fn pose(matrix: [[f64; 3]; 3], translation: [f64; 3]) -> Pose {
        Pose { matrix: matrix.map(|row| row.to_vec()).to_vec(), translation: translation.to_vec() }
    }

    #[test]
    fn poses_are_taken_exactly() {
        // A quarter turn about the third axis, stretched by 1.5 along it, then moved.
        let pose = pose([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.5]], [0.25, 0.0, -8.0]);
        let generators = [[1.0, 2.0, 0.5]];
        let body = Body { center: &[1.0, 0.0, 2.0], generators: &generators, pose: Some(&pose) };
        let question = Displaced::to_point(&body, &[0.5, 1.0, -5.0]).expect("space");
        // The centre goes to (0.25, 1, −5), the generator to (−2, 1, 0.75); halves of the matrix times quarters are
        // eighths.
        let eighths = |x: [f64; 3]| x.map(|x| IBig::from((x * 8.0) as i64)).to_vec();
        assert_eq!(question.p, eighths([0.25, 0.0, 0.0]));
        assert_eq!(question.generators, [eighths([-2.0, 1.0, 0.75])]);
    }

    #[test]
    fn bodies_without_a_pose_stand_where_they_are() {
        let still = pose([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], [0.0; 3]);
        let cube = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let at = |center, pose| Body { center, generators: &cube, pose };
        let both = |pose| Displaced::between(&at(&[0.0; 3], pose), &at(&[0.5, 3.0, 0.1], pose)).expect("space");
        let (plain, placed) = (both(None), both(Some(&still)));
        assert_eq!((&plain.p, &plain.generators), (&placed.p, &placed.generators));
        assert_eq!(plain.generators.len(), 6);
    }

    #[test]
    fn what_is_no_question_is_refused() {
        let spoilt = pose([[f64::NAN; 3]; 3], [0.0; 3]);
        let segment = [[1.0, 0.0, 0.0]];
        let body = |center, pose| Body { center, generators: &segment, pose };
        assert!(Displaced::to_point(&body(&[0.0; 3], Some(&spoilt)), &[0.0; 3]).is_err());
        assert!(Displaced::to_point(&body(&[0.0; 3], None), &[0.0, f64::INFINITY, 0.0]).is_err());
        assert!(Displaced::to_point(&body(&[0.0; 3], None), &[0.0; 2]).is_err());
        let plane = [[1.0, 0.0]];
        let turned = pose([[0.0; 3]; 3], [0.0; 3]);
        let body = Body { center: &[0.0; 2], generators: &plane, pose: Some(&turned) };
        assert!(Displaced::to_point(&body, &[0.0; 2]).is_err());
    }

    #[test]
    fn the_vector_leads_from_the_first_point_to_the_second() {
        let point = |x: i32, y: i32| vec![IBig::from(x), IBig::from(y)];
        let question = Displaced::of_vectors(point(1, -2), point(5, 3), vec![point(1, 0)], -4);
        assert_eq!((question.p.clone(), question.exponent(), question.dimension()), (point(4, 5), -4, 2));
    }
}
