//! The data of a picture: JSON with tables in it. A table is written as JSON for those who read lines, or as the bytes
//! of its numbers for a host that shares memory with the library and draws while somebody drags.

use serde_json::{Map, Value, json};

use crate::json::to_json;

/// The data of a picture, part by part.
#[derive(Debug)]
pub(crate) struct Sheet {
    parts: Vec<(String, Part)>,
}

/// A part of a sheet.
#[derive(Debug)]
pub(crate) enum Part {
    /// Few values of any shape.
    Plain(Value),
    /// A list.
    Table(Table),
    /// A list of objects with the same fields, by the table of each field.
    Records(Vec<(&'static str, Table)>),
}

/// A list of numbers, or of rows of numbers.
#[derive(Debug)]
pub(crate) enum Table {
    /// Floats, in rows of a width.
    Floats(Width, Vec<f64>),
    /// Indices, in rows of a width; [`NONE`] where there is none.
    Indices(Width, Vec<u32>),
    /// Rows of indices that are not equally long: the end of each, and all of them behind each other.
    Rows(Vec<u32>, Vec<u32>),
}

/// The number of entries of a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Width {
    /// The entries stand by themselves.
    Single,
    /// Each row is a list.
    Of(usize),
}

/// No index.
pub(crate) const NONE: u32 = u32::MAX;

impl Table {
    /// The coordinates of vectors.
    pub(crate) fn vectors<'a, const D: usize>(vectors: impl IntoIterator<Item = &'a [f64; D]>) -> Self {
        Self::Floats(Width::Of(D), vectors.into_iter().flatten().copied().collect())
    }

    /// Indices by themselves.
    pub(crate) fn indices(indices: impl IntoIterator<Item = u32>) -> Self {
        Self::Indices(Width::Single, indices.into_iter().collect())
    }

    /// Pairs of indices, of which some may be missing.
    pub(crate) fn pairs<I: Into<Option<u32>>>(pairs: impl IntoIterator<Item = [I; 2]>) -> Self {
        Self::Indices(Width::Of(2), pairs.into_iter().flatten().map(|index| index.into().unwrap_or(NONE)).collect())
    }

    /// Lists of indices.
    pub(crate) fn rows<Row: IntoIterator<Item = u32>>(rows: impl IntoIterator<Item = Row>) -> Self {
        let (mut ends, mut all) = (Vec::new(), Vec::new());
        for row in rows {
            all.extend(row);
            ends.push(index(all.len()));
        }
        Self::Rows(ends, all)
    }

    fn to_json(&self) -> Vec<Value> {
        let of_index = |&index: &u32| if index == NONE { Value::Null } else { index.into() };
        match self {
            Self::Floats(width, numbers) => in_rows(*width, numbers, |&number| to_json(number)),
            Self::Indices(width, numbers) => in_rows(*width, numbers, of_index),
            Self::Rows(ends, all) => {
                let begins = std::iter::once(&0).chain(ends);
                let row = |(&begin, &end)| all[begin as usize..end as usize].iter().map(of_index).collect();
                begins.zip(ends).map(row).collect()
            }
        }
    }

    /// The lists of numbers that the table is made of, as the name of their type and their bytes.
    fn columns(&self) -> Vec<(&'static str, Vec<u8>)> {
        let indices = |numbers: &[u32]| ("u32", numbers.iter().flat_map(|number| number.to_le_bytes()).collect());
        match self {
            Self::Floats(_, numbers) => vec![("f64", numbers.iter().flat_map(|number| number.to_le_bytes()).collect())],
            Self::Indices(_, numbers) => vec![indices(numbers)],
            Self::Rows(ends, all) => vec![indices(ends), indices(all)],
        }
    }

    /// The width of its rows: 0 where entries stand by themselves, null where each row has its own.
    fn width(&self) -> Value {
        match self {
            Self::Floats(Width::Of(width), _) | Self::Indices(Width::Of(width), _) => json!(width),
            Self::Floats(Width::Single, _) | Self::Indices(Width::Single, _) => json!(0),
            Self::Rows(..) => Value::Null,
        }
    }
}

fn in_rows<T>(width: Width, numbers: &[T], write: impl Fn(&T) -> Value) -> Vec<Value> {
    match width {
        Width::Single => numbers.iter().map(write).collect(),
        Width::Of(width) => numbers.chunks(width).map(|row| row.iter().map(&write).collect()).collect(),
    }
}

/// An index of a face or a generator, of which there are far fewer than 2^32.
pub(crate) fn index(index: usize) -> u32 {
    u32::try_from(index).expect("fewer things than 2^32 are listed")
}

/// A sheet whose lists of numbers are apart.
#[derive(Debug, Default)]
pub(crate) struct Unfolded {
    /// The parts that are no table.
    pub(crate) plain: Map<String, Value>,
    /// The place of each table, its width, and the types and counts of its columns.
    pub(crate) tables: Vec<Value>,
    /// The columns, those of floats first.
    pub(crate) columns: Vec<u8>,
}

impl Sheet {
    /// A sheet of some parts.
    pub(crate) fn new<const N: usize>(parts: [(&str, Part); N]) -> Self {
        Self { parts: parts.into_iter().map(|(name, part)| (name.to_owned(), part)).collect() }
    }

    /// One object of JSON.
    pub(crate) fn into_json(self) -> Value {
        let written = self.parts.into_iter().map(|(name, part)| {
            let value = match part {
                Part::Plain(value) => value,
                Part::Table(table) => table.to_json().into(),
                Part::Records(fields) => {
                    let columns = fields.iter().map(|(name, table)| (*name, table.to_json()));
                    joined(columns.collect()).into()
                }
            };
            (name, value)
        });
        Value::Object(written.collect())
    }

    /// The plain parts, and the numbers of the tables as bytes.
    pub(crate) fn unfolded(self) -> Unfolded {
        let mut unfolded = Unfolded::default();
        let mut tables: Vec<(Value, Table)> = Vec::new();
        for (name, part) in self.parts {
            match part {
                Part::Plain(value) => drop(unfolded.plain.insert(name, value)),
                Part::Table(table) => tables.push((json!([name]), table)),
                Part::Records(fields) => {
                    tables.extend(fields.into_iter().map(|(field, table)| (json!([name, field]), table)));
                }
            }
        }
        // Floats come first, so that each number is at a multiple of its size.
        tables.sort_by_key(|(_, table)| !matches!(table, Table::Floats(..)));
        for (place, table) in tables {
            let columns = table.columns();
            let told: Vec<Value> = columns.iter().map(|(of, bytes)| json!([of, bytes.len()])).collect();
            unfolded.tables.push(json!({"at": place, "width": table.width(), "columns": told}));
            columns.iter().for_each(|(_, bytes)| unfolded.columns.extend(bytes));
        }
        unfolded
    }
}

/// Objects from the columns of their fields.
fn joined(columns: Vec<(&str, Vec<Value>)>) -> Vec<Value> {
    let count = columns.first().map_or(0, |(_, column)| column.len());
    let mut objects = vec![Map::new(); count];
    for (name, column) in columns {
        for (object, value) in objects.iter_mut().zip(column) {
            object.insert(name.to_owned(), value);
        }
    }
    objects.into_iter().map(Value::Object).collect()
}

impl From<Value> for Sheet {
    /// An object, whose fields are the parts.
    fn from(value: Value) -> Self {
        let Value::Object(fields) = value else { unreachable!("the data of a picture are an object") };
        Self { parts: fields.into_iter().map(|(name, value)| (name, Part::Plain(value))).collect() }
    }
}
