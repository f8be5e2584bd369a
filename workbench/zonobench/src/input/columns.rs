//! The choice of two columns, as written on the command line.

use std::fmt;
use std::str::FromStr;

/// One column of a table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Column {
    /// By position, counted from 1.
    Number(usize),
    /// By the name in the header.
    Name(String),
}

/// The columns that hold the first and the second coordinate: `2,3` or `lon,lat`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Columns(pub [Column; 2]);

impl FromStr for Columns {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (first, second) = text
            .split_once(',')
            .filter(|(_, second)| !second.contains(','))
            .ok_or("give two columns, such as 2,3 or lon,lat")?;
        let columns = [column(first.trim())?, column(second.trim())?];
        if columns[0] == columns[1] {
            return Err("the two columns are the same".to_owned());
        }
        Ok(Self(columns))
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
        write!(f, "{},{}", self.0[0], self.0[1])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_names_and_mistakes() {
        assert_eq!("2, 3".parse(), Ok(Columns([Column::Number(2), Column::Number(3)])));
        assert_eq!("lon,3".parse(), Ok(Columns([Column::Name("lon".into()), Column::Number(3)])));
        for wrong in ["", "2", "1,2,3", "0,1", "2,2", "x,", ",y"] {
            assert!(wrong.parse::<Columns>().is_err(), "{wrong}");
        }
    }
}
