//! Placements: where a body of any dimension stands, as a matrix and a translation that are taken as the exact numbers
//! that they are.

use serde_json::{Value, json};
use zonotope::Pose;
use zonotope::numeric::dyadic::Dyadic;
use zonotope::zonotope::Zonotope;

use crate::json::{rows_to_json, vector_to_json};

/// The fields that a body or a mesh may have beside its own.
pub(crate) const PLACED: [&str; 1] = ["pose"];

/// The number of coordinates of the library's own poses.
const SPACE: usize = 3;

/// The placement x ↦ matrix · x + translation. Any matrix is one: one that mirrors, scales or flattens as well.
#[derive(Debug, Clone, PartialEq)]
pub struct Placement {
    matrix: Vec<Vec<f64>>,
    translation: Vec<f64>,
}

impl Placement {
    /// The placement that moves nothing.
    pub fn identity(dimension: usize) -> Self {
        let row = |row: usize| (0..dimension).map(|column| f64::from(u8::from(row == column))).collect();
        Self { matrix: (0..dimension).map(row).collect(), translation: vec![0.0; dimension] }
    }

    /// The placement of a matrix, by rows, and a translation; none if they are not of one dimension or not finite.
    pub fn new(matrix: Vec<Vec<f64>>, translation: Vec<f64>) -> Option<Self> {
        let is_even = |row: &Vec<f64>| row.len() == translation.len() && row.iter().all(|entry| entry.is_finite());
        let fits = matrix.len() == translation.len() && matrix.iter().chain([&translation]).all(is_even);
        fits.then_some(Self { matrix, translation })
    }

    /// The placement as a `pose` of a question.
    pub fn to_json(&self) -> Value {
        json!({"matrix": rows_to_json(&self.matrix), "translation": vector_to_json(&self.translation)})
    }

    /// The matrix, by rows.
    pub fn matrix(&self) -> &[Vec<f64>] {
        &self.matrix
    }

    /// The translation.
    pub fn translation(&self) -> &[f64] {
        &self.translation
    }

    /// This placement after another one, each number rounded to the nearest double, and whether all are exact; `None`
    /// beyond the range of doubles.
    pub fn after(&self, first: &Self) -> Option<(Self, bool)> {
        let exact = self.exact();
        let column = |column: usize| exact.vector(&first.matrix.iter().map(|row| row[column]).collect::<Vec<_>>());
        let columns: Vec<Vec<Dyadic>> = (0..self.matrix.len()).map(column).collect();
        let translation = exact.point(&first.translation);
        let is_exact = columns.iter().chain([&translation]).all(|numbers| doubles(numbers).is_some());
        let columns: Vec<Vec<f64>> = columns.iter().map(|column| nearest(column)).collect();
        let matrix = (0..columns.len()).map(|row| columns.iter().map(|column| column[row]).collect()).collect();
        Self::new(matrix, nearest(&translation)).map(|both| (both, is_exact))
    }

    /// The placement in exact numbers.
    pub fn exact(&self) -> ExactPlacement {
        let exact = |v: &[f64]| v.iter().map(|&x| Dyadic::from_f64(x)).collect();
        ExactPlacement {
            matrix: self.matrix.iter().map(|row| exact(row)).collect(),
            translation: exact(&self.translation),
        }
    }

    /// The same placement of space for a body of at most three dimensions; it stretches the further coordinates.
    pub(crate) fn of_space(&self, stretch: f64) -> Pose {
        let mut matrix = Pose::IDENTITY.matrix();
        for axis in self.matrix.len()..SPACE {
            matrix[axis][axis] = stretch;
        }
        let mut translation = [0.0; SPACE];
        for (row, own) in matrix.iter_mut().zip(&self.matrix) {
            row[..own.len()].copy_from_slice(own);
        }
        translation[..self.translation.len()].copy_from_slice(&self.translation);
        Pose::new(matrix, translation).expect("a placement is finite")
    }

    /// The image of a body, if doubles hold it.
    pub(crate) fn image<const D: usize>(&self, body: &Zonotope<D>) -> Option<Zonotope<D>> {
        if *self == Self::identity(D) {
            return Some(body.clone());
        }
        let exact = self.exact();
        let doubles = |v: Vec<Dyadic>| <[f64; D]>::try_from(doubles(&v)?).ok();
        let center = doubles(exact.point(&body.center()))?;
        let generators = body.generators().iter().map(|generator| doubles(exact.vector(generator)));
        Zonotope::new(center, generators.collect::<Option<Vec<_>>>()?).ok()
    }
}

/// A placement in exact numbers.
#[derive(Debug, Clone)]
pub struct ExactPlacement {
    matrix: Vec<Vec<Dyadic>>,
    translation: Vec<Dyadic>,
}

impl ExactPlacement {
    /// The image of a generator: matrix · v.
    pub fn vector(&self, v: &[f64]) -> Vec<Dyadic> {
        let v: Vec<Dyadic> = v.iter().map(|&x| Dyadic::from_f64(x)).collect();
        self.matrix.iter().map(|row| dot(row, &v)).collect()
    }

    /// The image of a point: matrix · p + translation.
    pub fn point(&self, p: &[f64]) -> Vec<Dyadic> {
        self.vector(p).iter().zip(&self.translation).map(|(x, moved)| x + moved).collect()
    }

    /// The determinant of the matrix.
    pub fn determinant(&self) -> Dyadic {
        determinant(&self.matrix.iter().map(Vec::as_slice).collect::<Vec<_>>(), 0)
    }
}

fn dot(u: &[Dyadic], v: &[Dyadic]) -> Dyadic {
    u.iter().zip(v).fold(Dyadic::zero(), |sum, (u, v)| sum + u * v)
}

/// The determinant of rows from a column on, along which it is expanded: a placement has six rows at most.
fn determinant(rows: &[&[Dyadic]], column: usize) -> Dyadic {
    let mut sum = Dyadic::one();
    for (index, row) in rows.iter().enumerate() {
        if index == 0 {
            sum = Dyadic::zero();
        }
        if row[column].is_zero() {
            continue;
        }
        let others: Vec<&[Dyadic]> =
            rows.iter().enumerate().filter(|(other, _)| *other != index).map(|(_, r)| *r).collect();
        let term = &row[column] * &determinant(&others, column + 1);
        sum = if index % 2 == 0 { sum + term } else { sum - term };
    }
    sum
}

/// The doubles nearest to exact numbers, within slightly more than half a unit in the last place; infinite beyond their
/// range.
pub fn nearest(exact: &[Dyadic]) -> Vec<f64> {
    exact.iter().map(|x| x.rounded_ratio(&Dyadic::one())).collect()
}

/// The doubles that equal exact numbers, if there are such.
pub fn doubles(exact: &[Dyadic]) -> Option<Vec<f64>> {
    let rounded = nearest(exact);
    let is_equal = |(x, exact): (&f64, &Dyadic)| x.is_finite() && Dyadic::from_f64(*x) == *exact;
    rounded.iter().zip(exact).all(is_equal).then_some(rounded)
}
