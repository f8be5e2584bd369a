//! Zonotopes of questions, with the poses that place them.

use super::reading::{member, vector, vectors};
use super::traced::Traced;
use verifier::{Body, Pose};

/// A zonotope of a question with its pose, if it has one.
pub(crate) struct Placed {
    center: Vec<f64>,
    generators: Vec<Vec<f64>>,
    pose: Option<Pose>,
}

impl Placed {
    /// The zonotope of an object whose centre goes by the name `center`.
    pub(crate) fn read(object: Traced<'_>, center: &str) -> Result<Self, String> {
        Self::around(vector(member(object, center)?, center)?, object)
    }

    /// The zonotope around the origin; without generators, of space.
    pub(crate) fn around_origin(object: Traced<'_>) -> Result<Self, String> {
        let generators = vectors(member(object, "generators")?, "generators")?;
        Self::around(vec![0.0; generators.first().map_or(3, Vec::len)], object)
    }

    fn around(center: Vec<f64>, object: Traced<'_>) -> Result<Self, String> {
        let generators = vectors(member(object, "generators")?, "generators")?;
        let pose = object.field("pose").map(|tree| pose(tree, center.len())).transpose()?;
        Ok(Self { center, generators, pose })
    }

    /// The image of the zonotope, which doubles must hold: centre and generators.
    pub(crate) fn image(&self) -> Result<(Vec<f64>, Vec<Vec<f64>>), String> {
        self.body().image().ok_or_else(|| "the pose gives the body an image that no doubles hold".to_owned())
    }

    /// The zonotope as the verifier takes it.
    pub(crate) fn body(&self) -> Body<'_, Vec<f64>> {
        Body { center: &self.center, generators: &self.generators, pose: self.pose.as_ref() }
    }
}

/// A pose, of which the matrix is the identity and the translation zero where they are absent.
pub(crate) fn pose(tree: Traced<'_>, dimension: usize) -> Result<Pose, String> {
    let row = |row: usize| (0..dimension).map(|column| f64::from(u8::from(row == column))).collect();
    let matrix = tree.field("matrix").map(|rows| vectors(rows, "matrix")).transpose()?;
    let translation = tree.field("translation").map(|moved| vector(moved, "translation")).transpose()?;
    Ok(Pose {
        matrix: matrix.unwrap_or_else(|| (0..dimension).map(row).collect()),
        translation: translation.unwrap_or_else(|| vec![0.0; dimension]),
    })
}
