//! The fields of an input, taken with their types checked.

use super::MAX_VECTORS;
use super::refusal::{Code, Refusal};
use crate::json::Tree;

/// An input that has exactly the fields of its kind.
#[derive(Debug, Clone, Copy)]
pub struct Fields<'a> {
    input: &'a Tree,
}

impl<'a> Fields<'a> {
    /// Checks that `input` is an object with the expected fields and no others.
    pub(super) fn new(input: &'a Tree, expected: &[&str]) -> Result<Self, Refusal> {
        let Tree::Object(fields) = input else {
            return Err(Refusal::bad_input(format!("`input` is {}, not an object", input.describe())));
        };
        if let Some(missing) = expected.iter().find(|name| input.field(name).is_none()) {
            return Err(Refusal::bad_input(format!("missing field `{missing}` in the input")));
        }
        if let Some((extra, _)) = fields.iter().find(|(name, _)| !expected.contains(&name.as_str())) {
            return Err(Refusal::bad_input(format!("extra field `{extra}` in the input")));
        }
        Ok(Self { input })
    }

    /// The list under an expected name.
    fn list(self, name: &str) -> Result<&'a [Tree], Refusal> {
        let value = self.input.field(name).expect("the fields of an input were checked to be there");
        value.list().ok_or_else(|| Refusal::bad_input(format!("`{name}` is {}, not a list", value.describe())))
    }

    /// The number of coordinates of the vector under `name`.
    pub(super) fn dimension(self, name: &str) -> Result<usize, Refusal> {
        self.list(name).map(<[Tree]>::len)
    }

    /// The vector under `name`.
    pub(super) fn vector<const D: usize>(self, name: &str) -> Result<[f64; D], Refusal> {
        coordinates(self.list(name)?, || name.to_owned())
    }

    /// The vectors under `name`, which ends in s: "point 2" is the second of the points.
    pub(super) fn vectors<const D: usize>(self, name: &str) -> Result<Vec<[f64; D]>, Refusal> {
        let rows = self.list(name)?;
        if rows.len() > MAX_VECTORS {
            let message = format!("{} {name}, at most {MAX_VECTORS} are taken", rows.len());
            return Err(Refusal::new(Code::TooLarge, message));
        }
        let singular = name.strip_suffix('s').unwrap_or(name);
        rows.iter()
            .enumerate()
            .map(|(index, row)| {
                let place = || format!("{singular} {}", index + 1);
                let Tree::List(row) = row else {
                    return Err(Refusal::bad_input(format!("{} is {}, not a list", place(), row.describe())));
                };
                coordinates(row, place)
            })
            .collect()
    }
}

fn coordinates<const D: usize>(row: &[Tree], place: impl Fn() -> String) -> Result<[f64; D], Refusal> {
    let mut vector = [0.0; D];
    for (index, value) in row.iter().enumerate() {
        let Tree::Number(number) = value else {
            let message = format!("{}, coordinate {} is {}, not a number", place(), index + 1, value.describe());
            return Err(Refusal::bad_input(message));
        };
        if let Some(slot) = vector.get_mut(index) {
            *slot = *number;
        }
    }
    if row.len() != D {
        let message = format!("{} has {} coordinates, not {D}", place(), row.len());
        return Err(Refusal::new(Code::DimensionMismatch, message));
    }
    Ok(vector)
}
