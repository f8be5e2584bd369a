//! Stage: the shortest zonotope along given directions, in the coordinates of the frame and in floating point.

use std::cell::Cell;

use crate::enclosing::fixed_directions::Generation;
use crate::enclosing::min_total_length::box_coordinates::spanning_directions;
use crate::enclosing::min_total_length::by_vertex_sets::limit_around;
use crate::enclosing::min_total_length::frame::Frame;
use crate::numeric::linear::dot;

/// A generator shorter than this, relative to the total length, is left out of a basic solution: rounding has made it.
const NEGLIGIBLE_LENGTH: f64 = 1e-12;

/// No direction costs less than this, relative to the most expensive one: the program is bounded then.
const LEAST_RELATIVE_COST: f64 = 1e-6;

/// A direction at less than this angle to the span of others counts as one of the span.
const LEAST_ANGLE_OFF_SPAN: f64 = 1e-3;

/// The linear programs of a search: those of the points of a frame, to one precision.
pub(super) struct Programs<'a, const D: usize> {
    pub(super) frame: &'a Frame<D>,
    precision: f64,
    /// The entries and products of points that the programs may still read.
    work: Cell<u64>,
}

/// The shortest zonotope along directions: a basic solution of the linear program, so few of its coefficients are
/// positive.
#[derive(Debug, Clone)]
pub(super) struct Along<const D: usize> {
    /// The total length.
    pub(super) length: f64,
    /// The centre.
    pub(super) center: [f64; D],
    /// The coefficient of each direction.
    pub(super) coefficients: Vec<f64>,
    /// The unit vectors along which generators point.
    pub(super) directions: Vec<[f64; D]>,
}

impl<'a, const D: usize> Programs<'a, D> {
    /// Programs that are solved to a relative precision and read no more entries and products of points than a limit,
    /// all together, around up to a thousand points; the limit around more is greater.
    pub(super) fn new(frame: &'a Frame<D>, precision: f64, limit: u64) -> Self {
        Self { frame, precision, work: Cell::new(limit_around(frame.points.len(), limit)) }
    }

    /// The shortest zonotope around the points along the lines of some vectors, of any length. `None` if the vectors do
    /// not span the frame, if the program fails, or if the search has taken its work.
    pub(super) fn along(&self, vectors: &[[f64; D]]) -> Option<Along<D>> {
        self.along_weighted(vectors, |_| 1.0)
    }

    /// The zonotope that [`along`](Self::along) finds if a unit of length costs what `cost` says of the unit vector of
    /// its direction.
    pub(super) fn along_weighted(&self, vectors: &[[f64; D]], cost: impl Fn(&[f64; D]) -> f64) -> Option<Along<D>> {
        let rank = self.frame.rank();
        let directions: Vec<[f64; D]> = vectors.iter().filter_map(unit).collect();
        if self.work.get() == 0 || spanning_directions(&directions).len() < rank {
            return None;
        }
        let costs: Vec<f64> = directions.iter().map(cost).collect();
        let greatest = costs.iter().fold(0.0, |greatest: f64, cost| greatest.max(*cost));
        if greatest <= 0.0 || !greatest.is_finite() {
            return None;
        }
        let weights = costs.iter().map(|cost| (cost / greatest).max(LEAST_RELATIVE_COST)).collect();
        let mut generation = Generation::new(rank, &self.frame.points, directions.clone(), weights, &mut ());
        generation.set_precision(self.precision);
        generation.set_work_limit(self.work.get());
        let ended = generation.run(&mut ());
        self.work.set(self.work.get().saturating_sub(generation.work()));
        ended.ok()?;
        let coefficients: Vec<f64> = generation.program.coefficients().iter().map(|c| c.max(0.0)).collect();
        let length = coefficients.iter().sum::<f64>();
        let center = generation.program.center();
        length.is_finite().then_some(Along { length, center, coefficients, directions })
    }
}

impl<const D: usize> Along<D> {
    /// The generators that are longer than rounding.
    pub(super) fn generators(&self) -> Vec<[f64; D]> {
        let (directions, coefficients) = self.used();
        directions.iter().zip(coefficients).map(|(v, x)| v.map(|c| c * x)).collect()
    }

    /// The directions of the generators that are longer than rounding, and their coefficients.
    pub(super) fn used(&self) -> (Vec<[f64; D]>, Vec<f64>) {
        let least = NEGLIGIBLE_LENGTH * self.length;
        self.directions.iter().zip(&self.coefficients).filter(|(_, c)| **c > least).unzip()
    }

    /// The directions of the generators, and as many more as orthonormal axes have beyond what these span. None is
    /// nearly parallel to another one: of those that are, the longest generator's is kept.
    pub(super) fn completed(&self, axes: &[[f64; D]]) -> Vec<[f64; D]> {
        let mut generators = self.generators();
        generators.sort_by(|a, b| dot(b, b).total_cmp(&dot(a, a)));
        let mut completed: Vec<[f64; D]> = Vec::new();
        let mut span: Vec<[f64; D]> = Vec::new();
        for direction in generators.iter().filter_map(unit) {
            if completed.iter().all(|kept| is_off(&off(&[*kept], &direction))) {
                completed.push(direction);
                span.extend(Some(off(&span, &direction)).filter(is_off).as_ref().and_then(unit));
            }
        }
        while span.len() < axes.len() {
            let rests = axes.iter().map(|axis| off(&span, axis));
            let farthest = rests.max_by(|a, b| dot(a, a).total_cmp(&dot(b, b)));
            let Some(next) = farthest.as_ref().and_then(unit) else { break };
            span.push(next);
            completed.push(next);
        }
        completed
    }

    /// How many generators are longer than rounding.
    pub(super) fn count(&self) -> usize {
        self.coefficients.iter().filter(|c| **c > NEGLIGIBLE_LENGTH * self.length).count()
    }
}

/// What is left of a vector off the span of orthonormal ones.
fn off<const D: usize>(span: &[[f64; D]], v: &[f64; D]) -> [f64; D] {
    span.iter().fold(*v, |rest, u| {
        let along = dot(&rest, u);
        std::array::from_fn(|c| rest[c] - along * u[c])
    })
}

/// Whether a unit vector of which this is left counts as off the span.
fn is_off<const D: usize>(rest: &[f64; D]) -> bool {
    dot(rest, rest).sqrt() > LEAST_ANGLE_OFF_SPAN
}

/// The vector of length 1 along a vector; `None` where there is none in floating point.
pub(super) fn unit<const D: usize>(v: &[f64; D]) -> Option<[f64; D]> {
    let length = dot(v, v).sqrt();
    (length > 1e-150 && length.is_finite()).then(|| v.map(|c| c / length))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_directions_lack_is_orthogonal_to_them() {
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let completed = |directions: &[[f64; 3]]| {
            let coefficients = (0..directions.len()).map(|i| 1.0 - 0.1 * i as f64).collect();
            Along { length: 1.0, center: [0.0; 3], coefficients, directions: directions.to_vec() }.completed(&axes)
        };
        let two = [[0.0, 0.6, 0.8], [1.0, 0.0, 0.0]];
        let three = completed(&two);
        assert_eq!((three.len(), &three[..2]), (3, &two[..]));
        assert!(two.iter().all(|v| dot(v, &three[2]).abs() < 1e-15));
        // of two directions that are nearly one the longer generator's is kept
        let nearly = completed(&[[0.0, 0.0, 1.0], [1e-5, 0.0, 1.0]]);
        assert_eq!((nearly.len(), nearly[0]), (3, [0.0, 0.0, 1.0]));
        assert_eq!(completed(&axes), axes);
    }
}
