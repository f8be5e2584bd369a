//! The choice of columns, as written on the command line.

use std::fmt;
use std::str::FromStr;

use super::points::COORDINATE_LIMIT;

/// One column of a table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Column {
    /// By position, counted from 1.
    Number(usize),
    /// By the name in the header.
    Name(String),
}

/// The columns that hold the coordinates, two to four, each once: `2,3` or `lon,lat`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Columns(pub Vec<Column>);

impl Columns {
    /// Columns that are not too many and each there once. One column is enough where the columns were guessed.
    pub fn new(columns: Vec<Column>) -> Result<Self, String> {
        if !(1..=COORDINATE_LIMIT).contains(&columns.len()) {
            return Err(format!("give two to {COORDINATE_LIMIT} columns, such as 2,3 or lon,lat"));
        }
        if columns.iter().enumerate().any(|(index, column)| columns[..index].contains(column)) {
            return Err("two of the columns are the same".to_owned());
        }
        Ok(Self(columns))
    }

    /// The names among them.
    pub(super) fn names(&self) -> impl Iterator<Item = &str> {
        self.0.iter().filter_map(|column| match column {
            Column::Name(name) => Some(name.as_str()),
            Column::Number(_) => None,
        })
    }
}

impl FromStr for Columns {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let columns: Vec<Column> = text.split(',').map(|name| column(name.trim())).collect::<Result<_, _>>()?;
        if columns.len() < 2 {
            return Err(format!("give two to {COORDINATE_LIMIT} columns, such as 2,3 or lon,lat"));
        }
        Self::new(columns)
    }
}

fn column(text: &str) -> Result<Column, String> {
    if text.is_empty() {
        return Err("a column's name is empty".to_owned());
    }
    match text.parse() {
        Ok(0) => Err("columns count from 1".to_owned()),
        Ok(number) => Ok(Column::Number(number)),
        Err(_) => Ok(Column::Name(text.to_owned())),
    }
}

impl fmt::Display for Column {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(number) => write!(f, "{number}"),
            Self::Name(name) => f.write_str(name),
        }
    }
}

impl fmt::Display for Columns {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names: Vec<String> = self.0.iter().map(Column::to_string).collect();
        f.write_str(&names.join(","))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_names_and_mistakes() {
        assert_eq!("2, 3".parse(), Ok(Columns(vec![Column::Number(2), Column::Number(3)])));
        assert_eq!("lon,3".parse(), Ok(Columns(vec![Column::Name("lon".into()), Column::Number(3)])));
        assert_eq!("1,2,3,4".parse::<Columns>().map(|columns| columns.to_string()), Ok("1,2,3,4".to_owned()));
        for wrong in ["", "2", "1,2,3,4,5", "0,1", "2,2", "1,x,1", "x,", ",y"] {
            assert!(wrong.parse::<Columns>().is_err(), "{wrong}");
        }
    }
}
