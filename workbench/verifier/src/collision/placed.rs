//! Zonotopes of a question where their poses put them, exactly: vectors of whole numbers of one unit.

use dashu_int::IBig;

use crate::exact::grid::{Grid, check_finite};
use crate::exact::linear::{Vector, dot};
use crate::exact::proportion::Proportion;

/// A placement of a body, x ↦ matrix · x + translation, taken as the exact numbers that they are: nothing is said about
/// a rotation.
#[derive(Debug, Clone, PartialEq)]
pub struct Pose {
    /// The rows of the matrix, as many as the space has dimensions.
    pub matrix: Vec<Vec<f64>>,
    /// The image of the origin.
    pub translation: Vec<f64>,
}

/// A zonotope of a question, placed by a pose if there is one.
#[derive(Debug, Clone, Copy)]
pub struct Body<'a, G> {
    /// The centre before it is placed.
    pub center: &'a [f64],
    /// The generators before they are placed.
    pub generators: &'a [G],
    /// The placement of both.
    pub pose: Option<&'a Pose>,
}

impl<G: AsRef<[f64]>> Body<'_, G> {
    /// Centre and generators of the image, if doubles hold them.
    pub fn image(&self) -> Option<(Vec<f64>, Vec<Vec<f64>>)> {
        if self.pose.is_none() {
            let generators = self.generators.iter().map(|generator| generator.as_ref().to_vec());
            return Some((self.center.to_vec(), generators.collect()));
        }
        self.check_dimension(self.center.len()).ok()?;
        let frame = Frame::of(&[self], &[]).ok()?;
        let doubles = |v: &Vector| v.iter().map(|x| double(x, frame.exponent())).collect::<Option<Vec<f64>>>();
        Some((doubles(&frame.center(self))?, frame.generators(self).iter().map(doubles).collect::<Option<_>>()?))
    }

    /// Refuses a body or a pose that is not of the dimension.
    pub(crate) fn check_dimension(&self, dimension: usize) -> Result<(), String> {
        let is_even = |vector: &[f64]| vector.len() == dimension;
        let is_posed = |pose: &Pose| {
            let rows = pose.matrix.iter().map(Vec::as_slice);
            pose.matrix.len() == dimension && rows.chain([pose.translation.as_slice()]).all(is_even)
        };
        let is_own = is_even(self.center) && self.generators.iter().all(|generator| is_even(generator.as_ref()));
        match is_own && self.pose.is_none_or(is_posed) {
            true => Ok(()),
            false => Err("answered a question whose dimensions do not agree".to_owned()),
        }
    }

    /// The numbers of the body and of its translation.
    fn places(&self) -> impl Iterator<Item = &f64> {
        let translation = self.pose.iter().flat_map(|pose| &pose.translation);
        self.center.iter().chain(self.generators.iter().flat_map(|generator| generator.as_ref())).chain(translation)
    }

    /// The numbers of the matrix.
    fn matrix(&self) -> impl Iterator<Item = &f64> {
        self.pose.into_iter().flat_map(|pose| pose.matrix.iter().flatten())
    }
}

/// The double that equals so many units 2^exponent, if there is one.
fn double(units: &IBig, exponent: i32) -> Option<f64> {
    let exact = Proportion::whole(units.clone(), exponent);
    let double = exact.nearest();
    (double.is_finite() && Proportion::of_double(double).compare(&exact).is_eq()).then_some(double)
}

/// The unit in which vectors of placed bodies are whole numbers: the product of those of vectors and of matrices.
pub(crate) struct Frame {
    places: Grid,
    matrices: Grid,
}

impl Frame {
    /// The frame of bodies and of points beside them.
    ///
    /// # Errors
    /// A sentence about a number that is not finite.
    pub(crate) fn of<G: AsRef<[f64]>>(bodies: &[&Body<'_, G>], points: &[&[f64]]) -> Result<Self, String> {
        let places = || bodies.iter().flat_map(|body| body.places()).chain(points.iter().copied().flatten());
        let matrices = || bodies.iter().flat_map(|body| body.matrix());
        check_finite("the question", places().chain(matrices()))?;
        // A vector without a pose is multiplied by the 1 of the matrices.
        let matrices = Grid::at(Grid::of(matrices().copied()).exponent().min(0));
        Ok(Self { places: Grid::of(places().copied()), matrices })
    }

    /// The exponent of the unit.
    pub(crate) fn exponent(&self) -> i32 {
        self.places.exponent() + self.matrices.exponent()
    }

    /// A point of the question, which nothing places.
    pub(crate) fn point(&self, point: &[f64]) -> Vector {
        self.placed(point, None)
    }

    /// The image of a body's centre.
    pub(crate) fn center<G>(&self, body: &Body<'_, G>) -> Vector {
        let mut image = self.placed(body.center, body.pose);
        if let Some(pose) = body.pose {
            for (x, &moved) in image.iter_mut().zip(&pose.translation) {
                *x += self.places.units(moved) * self.one();
            }
        }
        image
    }

    /// The images of a body's generators.
    pub(crate) fn generators<G: AsRef<[f64]>>(&self, body: &Body<'_, G>) -> Vec<Vector> {
        body.generators.iter().map(|generator| self.placed(generator.as_ref(), body.pose)).collect()
    }

    fn one(&self) -> IBig {
        IBig::ONE << self.matrices.exponent().unsigned_abs() as usize
    }

    /// The image of a vector.
    fn placed(&self, vector: &[f64], pose: Option<&Pose>) -> Vector {
        let units: Vector = vector.iter().map(|&x| self.places.units(x)).collect();
        let Some(pose) = pose else { return units.into_iter().map(|x| x * self.one()).collect() };
        let row = |row: &Vec<f64>| -> Vector { row.iter().map(|&entry| self.matrices.units(entry)).collect() };
        pose.matrix.iter().map(|entries| dot(&row(entries), &units)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shear_of_the_plane_by_hand() {
        let pose = Pose { matrix: vec![vec![1.0, 0.5], vec![0.0, 1.0]], translation: vec![0.0, -3.0] };
        let generators = [[1.0, 2.0]];
        let body = Body { center: &[4.0, 1.0], generators: &generators, pose: Some(&pose) };
        let frame = Frame::of(&[&body], &[&[0.25, 0.0]]).expect("finite");
        // Quarters of the point times halves of the matrix are eighths.
        let eighths = |x: [f64; 2]| x.map(|x| IBig::from((x * 8.0) as i64)).to_vec();
        assert_eq!(frame.exponent(), -3);
        assert_eq!(frame.center(&body), eighths([4.5, -2.0]));
        assert_eq!(frame.generators(&body), [eighths([2.0, 2.0])]);
        assert_eq!(frame.point(&[0.25, 0.0]), eighths([0.25, 0.0]));
    }

    #[test]
    fn an_image_that_doubles_hold_and_one_that_they_do_not() {
        let image = |entry: f64| {
            let pose = Pose { matrix: vec![vec![entry]], translation: vec![0.1] };
            Body { center: &[0.0], generators: &[[3.0], [0.1]], pose: Some(&pose) }.image()
        };
        assert_eq!(image(-4.0), Some((vec![0.1], vec![vec![-12.0], vec![-0.4]])));
        assert_eq!(image(0.1), None);
        assert_eq!(image(f64::MAX), None, "beyond the range");
    }

    #[test]
    fn poses_of_other_dimensions_are_refused() {
        let is_posed = |matrix: &[Vec<f64>], translation: &[f64]| {
            let pose = Pose { matrix: matrix.to_vec(), translation: translation.to_vec() };
            Body::<[f64; 2]> { center: &[0.0; 2], generators: &[], pose: Some(&pose) }.check_dimension(2).is_ok()
        };
        let square = [vec![1.0, 0.0], vec![0.0, 1.0]];
        assert!(is_posed(&square, &[0.0; 2]));
        assert!(!is_posed(&square, &[0.0; 3]));
        assert!(!is_posed(&square[..1], &[0.0; 2]));
        assert!(!is_posed(&[vec![1.0], vec![1.0]], &[0.0; 2]));
    }
}
