//! The question of a location: the exact vector from one point to another, and the generators of a zonotope.

use dashu_int::IBig;
use dashu_int::ops::Abs;

use crate::exact::grid::{Grid, check_finite};
use crate::exact::linear::{Vector, dot};

/// A placement of a body of space, x ↦ matrix · x + translation, taken as the exact numbers that they are: nothing is
/// said about a rotation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose {
    /// The rows of the matrix.
    pub matrix: [[f64; 3]; 3],
    /// The image of the origin.
    pub translation: [f64; 3],
}

/// A zonotope of a question, placed by a pose if there is one.
#[derive(Debug, Clone, Copy)]
pub struct Body<'a, G> {
    /// The centre before it is placed.
    pub center: &'a [f64],
    /// The generators before they are placed.
    pub generators: &'a [G],
    /// The placement of both; only bodies of space have one.
    pub pose: Option<&'a Pose>,
}

/// The exact vector from one point to another, and generators, all of one dimension.
#[derive(Debug, Clone)]
pub struct Displaced {
    /// Where the vector begins and ends.
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
    /// As for [`Displaced::new`]; a pose that is not of space.
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
        for body in [a, b] {
            let is_even = |vector: &[f64]| vector.len() == dimension;
            if !is_even(body.center) || !body.generators.iter().all(|generator| is_even(generator.as_ref())) {
                return Err("answered a question whose dimensions do not agree".to_owned());
            }
            if body.pose.is_some() && dimension != 3 {
                return Err(format!("answered a question with a pose in {dimension} dimensions"));
            }
        }
        let own = |body: &Body<'_, G>| -> Vec<f64> {
            let translation = body.pose.iter().flat_map(|pose| pose.translation);
            let generators = body.generators.iter().flat_map(|generator| generator.as_ref());
            body.center.iter().chain(generators).copied().chain(translation).collect()
        };
        let places = [own(a), own(b)].concat();
        let matrices: Vec<f64> =
            [a, b].iter().filter_map(|body| body.pose).flat_map(|pose| pose.matrix.into_iter().flatten()).collect();
        check_finite("the question", places.iter().chain(&matrices))?;
        // An image is a sum of products of numbers of the two grids; what has no pose is multiplied by the 1 of the
        // matrices.
        let frame = Frame { places: Grid::of(places), matrices: Grid::at(Grid::of(matrices).exponent().min(0)) };

        let [from, to] = [a, b].map(|body| frame.placed_point(body.center, body.pose));
        let p = to.iter().zip(&from).map(|(to, from)| to - from).collect();
        let generators = |body: &Body<'_, G>| -> Vec<Vector> {
            body.generators.iter().map(|generator| frame.placed(generator.as_ref(), body.pose)).collect()
        };
        let exponent = frame.places.exponent() + frame.matrices.exponent();
        Ok(Self { from, to, p, generators: [generators(a), generators(b)].concat(), exponent })
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

/// The units in which vectors of placed bodies are whole numbers: the product of those of vectors and of matrices.
struct Frame {
    places: Grid,
    matrices: Grid,
}

impl Frame {
    fn one(&self) -> IBig {
        IBig::ONE << self.matrices.exponent().unsigned_abs() as usize
    }

    /// The image of a generator.
    fn placed(&self, vector: &[f64], pose: Option<&Pose>) -> Vector {
        let units: Vector = vector.iter().map(|&x| self.places.units(x)).collect();
        match pose {
            None => units.into_iter().map(|x| x * self.one()).collect(),
            Some(pose) => {
                pose.matrix.iter().map(|row| dot(&row.map(|entry| self.matrices.units(entry)), &units)).collect()
            }
        }
    }

    /// The image of a point.
    fn placed_point(&self, point: &[f64], pose: Option<&Pose>) -> Vector {
        let mut image = self.placed(point, pose);
        if let Some(pose) = pose {
            for (x, &moved) in image.iter_mut().zip(&pose.translation) {
                *x += self.places.units(moved) * self.one();
            }
        }
        image
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn poses_are_taken_exactly() {
        // A quarter turn about the third axis, stretched by 1.5 along it, then moved.
        let pose =
            Pose { matrix: [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.5]], translation: [0.25, 0.0, -8.0] };
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
        let still = Pose { matrix: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], translation: [0.0; 3] };
        let cube = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let at = |center, pose| Body { center, generators: &cube, pose };
        let both = |pose| Displaced::between(&at(&[0.0; 3], pose), &at(&[0.5, 3.0, 0.1], pose)).expect("space");
        let (plain, placed) = (both(None), both(Some(&still)));
        assert_eq!((&plain.p, &plain.generators), (&placed.p, &placed.generators));
        assert_eq!(plain.generators.len(), 6);
    }

    #[test]
    fn what_is_no_question_is_refused() {
        let pose = Pose { matrix: [[f64::NAN; 3]; 3], translation: [0.0; 3] };
        let segment = [[1.0, 0.0, 0.0]];
        let body = |center, pose| Body { center, generators: &segment, pose };
        assert!(Displaced::to_point(&body(&[0.0; 3], Some(&pose)), &[0.0; 3]).is_err());
        assert!(Displaced::to_point(&body(&[0.0; 3], None), &[0.0, f64::INFINITY, 0.0]).is_err());
        assert!(Displaced::to_point(&body(&[0.0; 3], None), &[0.0; 2]).is_err());
        let plane = [[1.0, 0.0]];
        let turned = Pose { matrix: [[0.0; 3]; 3], ..pose };
        let body = Body { center: &[0.0; 2], generators: &plane, pose: Some(&turned) };
        assert!(Displaced::to_point(&body, &[0.0; 2]).is_err());
    }
}
