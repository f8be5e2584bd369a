//! Values of questions and answers, with complaints that name them.

use dashu_int::IBig;
use verifier::{Fraction, whole_direction};

use super::traced::Traced;
use crate::json::Tree;

pub(crate) fn member<'a>(object: Traced<'a>, name: &str) -> Result<Traced<'a>, String> {
    object.field(name).ok_or_else(|| format!("`{name}` is missing"))
}

/// A figure of an answer: possibly an infinity, where the exact value is beyond the range of doubles.
pub(crate) fn float(object: Traced<'_>, name: &str) -> Result<f64, String> {
    member(object, name)?.tree.float().ok_or_else(|| format!("`{name}` is not a number"))
}

/// A point of an answer: coordinates that may be infinite, where the exact ones are beyond the range of doubles.
pub(crate) fn point(value: Traced<'_>, name: &str) -> Result<Vec<f64>, String> {
    let coordinates = value.tree.list().ok_or_else(|| format!("`{name}` is not a list"))?;
    let coordinates = coordinates.iter().map(|x| x.float().filter(|x| !x.is_nan()));
    coordinates.collect::<Option<_>>().ok_or_else(|| format!("`{name}` holds something else than numbers"))
}

pub(crate) fn vector(value: Traced<'_>, name: &str) -> Result<Vec<f64>, String> {
    let components = value.tree.list().ok_or_else(|| format!("`{name}` is not a list"))?;
    components
        .iter()
        .map(|component| component.float().filter(|number| number.is_finite()))
        .collect::<Option<_>>()
        .ok_or_else(|| format!("`{name}` holds something else than finite numbers"))
}

pub(crate) fn vectors(value: Traced<'_>, name: &str) -> Result<Vec<Vec<f64>>, String> {
    let rows = value.elements().ok_or_else(|| format!("`{name}` is not a list"))?;
    rows.map(|row| vector(row, name)).collect()
}

pub(crate) fn planar(value: Traced<'_>, name: &str) -> Result<Vec<[f64; 2]>, String> {
    let rows = vectors(value, name)?;
    rows.into_iter()
        .map(|row| {
            <[f64; 2]>::try_from(row).map_err(|_| format!("`{name}` holds something else than points of the plane"))
        })
        .collect()
}

pub(crate) fn index(object: Traced<'_>, name: &str) -> Result<usize, String> {
    member(object, name)?.tree.index().ok_or_else(|| format!("`{name}` is not a whole number"))
}

pub(crate) fn indices(object: Traced<'_>, name: &str) -> Result<Vec<usize>, String> {
    let list = member(object, name)?.tree.list().ok_or_else(|| format!("`{name}` is not a list"))?;
    list.iter()
        .map(Tree::index)
        .collect::<Option<_>>()
        .ok_or_else(|| format!("`{name}` holds something else than indices"))
}

pub(crate) fn text<'a>(object: Traced<'a>, name: &str) -> Result<&'a str, String> {
    member(object, name)?.text().ok_or_else(|| format!("`{name}` is not a string"))
}

pub(crate) fn boolean(object: Traced<'_>, name: &str) -> Result<bool, String> {
    match member(object, name)?.tree {
        Tree::Bool(value) => Ok(*value),
        _ => Err(format!("`{name}` is not true or false")),
    }
}

pub(crate) fn fractions(object: Traced<'_>, name: &str) -> Result<Vec<Fraction>, String> {
    exact_numbers(member(object, name)?).ok_or_else(|| format!("`{name}` is not a list of exact numbers"))
}

/// A list of exact numbers.
pub(crate) fn exact_numbers(value: Traced<'_>) -> Option<Vec<Fraction>> {
    value.elements()?.map(|value| value.text().and_then(Fraction::parse)).collect()
}

/// A direction as whole numbers: its length says nothing. Components are finite floats, or all of them exact numbers.
pub(crate) fn direction(object: Traced<'_>, name: &str) -> Result<Vec<IBig>, String> {
    let wrong = || format!("`{name}` holds something else than finite or exact numbers");
    let value = member(object, name)?;
    let components = value.tree.list().ok_or_else(|| format!("`{name}` is not a list"))?;
    let floats = || components.iter().map(|component| component.float().and_then(Fraction::of_double)).collect();
    let exact: Option<Vec<Fraction>> = exact_numbers(value).or_else(floats);
    exact.map(|exact| whole_direction(&exact)).ok_or_else(wrong)
}
