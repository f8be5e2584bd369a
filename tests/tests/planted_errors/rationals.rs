//! Rationals out of JSON, and systems of equations in them.

use dashu_ratio::RBig;
use serde_json::Value;

/// A double or an exact number; `None` for everything else.
pub fn number(value: &Value) -> Option<RBig> {
    match value {
        Value::Number(number) => RBig::try_from(number.as_f64()?).ok(),
        Value::String(text) => RBig::from_str_radix(text, 10).ok(),
        _ => None,
    }
}

/// A list of numbers.
pub fn vector(value: &Value) -> Option<Vec<RBig>> {
    value.as_array()?.iter().map(number).collect()
}

/// A list of lists of numbers.
pub fn vectors(value: &Value) -> Option<Vec<Vec<RBig>>> {
    value.as_array()?.iter().map(vector).collect()
}

/// A list of indices.
pub fn indices(value: &Value) -> Option<Vec<usize>> {
    value.as_array()?.iter().map(index).collect()
}

/// An index, however it is spelled: 3.0 is 3.
pub fn index(value: &Value) -> Option<usize> {
    let exact = number(value)?;
    exact.is_int().then(|| usize::try_from(exact.numerator().clone()).ok())?
}

/// The inner product.
pub fn dot(a: &[RBig], b: &[RBig]) -> RBig {
    a.iter().zip(b).fold(RBig::ZERO, |sum, (a, b)| sum + a * b)
}

/// The difference.
pub fn minus(a: &[RBig], b: &[RBig]) -> Vec<RBig> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

/// The distance from zero.
pub fn absolute(x: RBig) -> RBig {
    if x < RBig::ZERO { -x } else { x }
}

/// The x with Σ x_j columns_j = target, if there is exactly one.
pub fn solved(columns: &[&Vec<RBig>], target: &[RBig]) -> Option<Vec<RBig>> {
    let mut rows: Vec<Vec<RBig>> = (0..target.len())
        .map(|axis| columns.iter().map(|column| column[axis].clone()).chain([target[axis].clone()]).collect())
        .collect();
    for step in 0..columns.len() {
        let found = (step..rows.len()).find(|&row| rows[row][step] != RBig::ZERO)?;
        rows.swap(step, found);
        let pivot: Vec<RBig> = rows[step].iter().map(|x| x / &rows[step][step]).collect();
        rows[step] = pivot.clone();
        for (_, row) in rows.iter_mut().enumerate().filter(|(index, _)| *index != step) {
            let factor = row[step].clone();
            *row = row.iter().zip(&pivot).map(|(x, above)| x - &factor * above).collect();
        }
    }
    let rest = &rows[columns.len().min(rows.len())..];
    let is_met = rest.iter().all(|row| row[columns.len()] == RBig::ZERO);
    is_met.then(|| rows[..columns.len()].iter().map(|row| row[columns.len()].clone()).collect())
}
