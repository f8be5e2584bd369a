//! A zonotope of any dimension as a file has it.

use crate::input::error::{InputError, Place, Problem};
use std::path::Path;

/// A zonotope of any dimension: every vector has as many coordinates as the centre, at least one, all finite.
#[derive(Debug, Clone, PartialEq)]
pub struct Body {
    /// The centre; the origin where the file has none.
    pub center: Vec<f64>,
    /// The generators.
    pub generators: Vec<Vec<f64>>,
    /// Whether the generators are rounded: products of directions and coefficients of an answer that no doubles equal.
    pub is_rounded: bool,
}

impl Body {
    /// The largest reach from the centre along an axis; infinite beyond the range of doubles.
    pub fn reach(&self) -> f64 {
        let along = |axis: usize| self.generators.iter().map(|generator| generator[axis].abs()).sum();
        (0..self.center.len()).map(along).fold(0.0, f64::max)
    }
}

pub(super) fn body(file: &Path, center: Option<Vec<f64>>, generators: Vec<Vec<f64>>) -> Result<Body, InputError> {
    let Some(dimension) = center.as_ref().or(generators.first()).map(Vec::len).filter(|&dimension| dimension > 0)
    else {
        return Err(Problem::NoBody.at(file, Place::File));
    };
    if let Some(index) = generators.iter().position(|generator| generator.len() != dimension) {
        let problem = Problem::Ragged { found: generators[index].len(), expected: dimension };
        return Err(problem.at(file, Place::Path(format!("generators[{index}]"))));
    }
    Ok(Body { center: center.unwrap_or_else(|| vec![0.0; dimension]), generators, is_rounded: false })
}
