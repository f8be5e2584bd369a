//! Points from a table of separated cells.

use std::path::Path;

use csv::{ByteRecord, Reader, ReaderBuilder};

use super::columns::{Column, Columns};
use super::error::{InputError, Place, Problem};
use super::push_limited;

/// Pairs of header names that are taken for coordinates when no columns are chosen, in the order first, second coordinate.
const KNOWN_NAMES: [[&str; 2]; 6] =
    [["x", "y"], ["lon", "lat"], ["lng", "lat"], ["long", "lat"], ["longitude", "latitude"], ["easting", "northing"]];

/// Reads the points of a table.
///
/// The first line is a header if the chosen columns are named, if some cell of it is text where the second line has a number,
/// or if neither chosen cell is a number.
pub(super) fn points(file: &Path, content: &[u8], columns: Option<&Columns>) -> Result<Vec<[f64; 2]>, InputError> {
    let mut table = Table { file, content, columns: [0, 1], width: None };
    table.read(columns)
}

/// Reads all the numbers of a table, row by row: rows of the same length, after a header line that is recognised as above.
pub(super) fn rows(file: &Path, content: &[u8]) -> Result<Vec<Vec<f64>>, InputError> {
    let mut table = Table { file, content, columns: [0, 0], width: None };
    let mut reader = table.reader();
    let mut records = reader.byte_records().filter(|row| !row.as_ref().is_ok_and(is_blank));
    let Some(first) = records.next() else {
        return Ok(Vec::new());
    };
    let first = table.parsed(first)?;
    let second = records.next().map(|row| table.parsed(row)).transpose()?;
    table.width = Some(first.len());
    let opening = if table.is_header(&first, second.as_ref()) { None } else { Some(first) };
    let mut rows = Vec::new();
    for row in opening.into_iter().chain(second).map(Ok).chain(records.map(|row| table.parsed(row))) {
        let row = row?;
        let numbers: Result<Vec<f64>, InputError> =
            (0..row.len().max(1)).map(|column| table.number(&row, column)).collect();
        push_limited(&mut rows, numbers?).map_err(|problem| problem.at(file, Place::Line(table.line(&row))))?;
    }
    Ok(rows)
}

struct Table<'a> {
    file: &'a Path,
    content: &'a [u8],
    /// The chosen columns, counted from 0.
    columns: [usize; 2],
    /// The cells of the first row, which every row must have.
    width: Option<usize>,
}

impl<'a> Table<'a> {
    fn reader(&self) -> Reader<&'a [u8]> {
        ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .delimiter(separator(self.content))
            .from_reader(self.content)
    }

    fn read(&mut self, columns: Option<&Columns>) -> Result<Vec<[f64; 2]>, InputError> {
        let mut reader = self.reader();
        let mut rows = reader.byte_records().filter(|row| !row.as_ref().is_ok_and(is_blank));

        let Some(first) = rows.next() else {
            return Ok(Vec::new());
        };
        let first = self.parsed(first)?;
        let second = rows.next().map(|row| self.parsed(row)).transpose()?;
        self.columns = self.chosen(&first, columns)?;

        let mut points = Vec::new();
        let named = columns.is_some_and(|Columns(both)| both.iter().any(|column| matches!(column, Column::Name(_))));
        let opening = if named || self.is_header(&first, second.as_ref()) { None } else { Some(first) };
        for row in opening.into_iter().chain(second).map(Ok).chain(rows.map(|row| self.parsed(row))) {
            let row = row?;
            let point = [self.number(&row, self.columns[0])?, self.number(&row, self.columns[1])?];
            push_limited(&mut points, point).map_err(|problem| problem.at(self.file, Place::Line(self.line(&row))))?;
        }
        Ok(points)
    }

    /// The row, if it parses.
    fn parsed(&self, row: csv::Result<ByteRecord>) -> Result<ByteRecord, InputError> {
        row.map_err(|error| Problem::Table(error.to_string()).at(self.file, Place::File))
    }

    fn chosen(&mut self, first: &ByteRecord, columns: Option<&Columns>) -> Result<[usize; 2], InputError> {
        self.width = Some(first.len());
        let names: Vec<String> = first.iter().map(|cell| String::from_utf8_lossy(cell).trim().to_owned()).collect();
        let position = |wanted: &str| names.iter().position(|name| name.eq_ignore_ascii_case(wanted));
        if let Some(Columns(both)) = columns {
            let place = |column: &Column| match column {
                Column::Number(number) if *number <= names.len() => Ok(number - 1),
                Column::Number(number) => Err(Problem::NoColumnNumber { number: *number, cells: names.len() }),
                Column::Name(name) => position(name)
                    .ok_or_else(|| Problem::NoSuchColumn { name: name.clone(), available: names.join(", ") }),
            };
            let at_first = |problem: Problem| problem.at(self.file, Place::Line(self.line(first)));
            return Ok([place(&both[0]).map_err(at_first)?, place(&both[1]).map_err(at_first)?]);
        }
        for [x, y] in KNOWN_NAMES {
            if let (Some(x), Some(y)) = (position(x), position(y)) {
                return Ok([x, y]);
            }
        }
        if first.len() == 2 {
            return Ok([0, 1]);
        }
        Err(Problem::ChooseColumns { cells: first.len() }.at(self.file, Place::File))
    }

    fn is_header(&self, first: &ByteRecord, second: Option<&ByteRecord>) -> bool {
        let text_above_number = second.is_some_and(|second| {
            first.iter().zip(second).any(|(above, below)| parse(above).is_none() && parse(below).is_some())
        });
        text_above_number || self.columns.iter().all(|&column| parse(&first[column]).is_none())
    }

    fn number(&self, row: &ByteRecord, column: usize) -> Result<f64, InputError> {
        let width = self.width.unwrap_or(row.len());
        if row.len() != width {
            let problem = Problem::Ragged { found: row.len(), expected: width };
            return Err(problem.at(self.file, Place::Line(self.line(row))));
        }
        let problem = match (parse(&row[column]), std::str::from_utf8(&row[column])) {
            (Some(number), _) if number.is_finite() => return Ok(number),
            (Some(_), Ok(cell)) => Problem::NotFinite(cell.trim().to_owned()),
            (None, Ok(cell)) if cell.trim().is_empty() => Problem::EmptyCell,
            (None, Ok(cell)) => Problem::NotANumber(cell.trim().to_owned()),
            (_, Err(_)) => Problem::NotText,
        };
        let place = Place::Cell { line: self.line(row), column: column as u64 + 1 };
        Err(problem.at(self.file, place))
    }

    /// The line on which a row starts: the parser's own count stands before the blank lines that it skips.
    fn line(&self, row: &ByteRecord) -> u64 {
        let offset = row.position().map_or(0, csv::Position::byte);
        let offset = usize::try_from(offset).expect("the content is in memory").min(self.content.len());
        let rest = &self.content[offset..];
        let start = offset + rest.iter().take_while(|byte| byte.is_ascii_whitespace()).count();
        1 + self.content[..start].iter().filter(|&&byte| byte == b'\n').count() as u64
    }
}

fn is_blank(row: &ByteRecord) -> bool {
    row.len() == 1 && row[0].trim_ascii().is_empty()
}

/// The number in a cell, not necessarily finite.
fn parse(cell: &[u8]) -> Option<f64> {
    std::str::from_utf8(cell).ok()?.trim().parse().ok()
}

/// A comma, unless the first line has none and has a semicolon or a tab.
fn separator(content: &[u8]) -> u8 {
    let first = content.split(|&byte| byte == b'\n').find(|line| !line.trim_ascii().is_empty()).unwrap_or_default();
    [b',', b';', b'\t'].into_iter().find(|separator| first.contains(separator)).unwrap_or(b',')
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(content: &str, columns: Option<&str>) -> Result<Vec<[f64; 2]>, String> {
        let columns = columns.map(|columns| columns.parse().expect("the test's columns are well formed"));
        points(Path::new("points.csv"), content.as_bytes(), columns.as_ref()).map_err(|error| error.to_string())
    }

    #[test]
    fn headers_are_recognised_and_may_be_absent() {
        let expected = Ok(vec![[1.0, 2.0], [3.0, 4.0]]);
        assert_eq!(read("1,2\n3,4\n", None), expected);
        assert_eq!(read("a,b\n1,2\n3,4", None), expected);
        assert_eq!(read("y,z,x\n2,0,1\n4,0,3\n", None), expected);
        assert_eq!(read("name,Lat,LON\np,2,1\nq,4,3\n", None), expected);
        assert_eq!(read("150,4,setosa\n1,2,0\n3,4,0\n", Some("1,2")), expected);
        assert_eq!(
            read("7,8\n2,1\n4,3\n", Some("8,7")),
            Err("points.csv: line 1: there is no column 8; the row has 2 cells".into())
        );
    }

    #[test]
    fn line_endings_blank_lines_quotes_and_separators() {
        let expected = Ok(vec![[1.0, 2.0], [3.0, 4.0]]);
        assert_eq!(read("x,y\r\n1,2\r\n\r\n3,4\r\n", None), expected);
        assert_eq!(read("\n\n1,2\n   \n3,4\n\n\n", None), expected);
        assert_eq!(read("\"1\",\"2\"\n\"3\", 4 \n", None), expected);
        assert_eq!(read("1;2\n3;4\n", None), expected);
        assert_eq!(read("1\t2\n3\t4\n", None), expected);
    }

    #[test]
    fn complaints_name_line_and_column() {
        let complaint = |content, columns| read(content, columns).expect_err("the table is wrong");
        assert_eq!(complaint("x,y\n1,2\n\n3,abc\n", None), "points.csv: line 4, column 2: 'abc' is not a number");
        assert_eq!(
            complaint("x,y\r\n1,2\r\n\r\n\r\nnan,2\r\n", None),
            "points.csv: line 5, column 1: 'nan' is not a finite number"
        );
        assert_eq!(complaint("1,2\n1e999,2\n", None), "points.csv: line 2, column 1: '1e999' is not a finite number");
        assert_eq!(complaint("1,2\n3\n", None), "points.csv: line 2: the row has 1 cells, not 2");
        assert_eq!(complaint("1,2\n3,4,5\n", None), "points.csv: line 2: the row has 3 cells, not 2");
        assert_eq!(complaint("1,2\n3,\n", None), "points.csv: line 2, column 2: the cell is empty");
        assert_eq!(complaint("1,2,3\n3,4,5\n", None), "points.csv: has 3 column(s); choose two with --columns");
        assert_eq!(
            complaint("a,b\n1,2\n", Some("a,c")),
            "points.csv: line 1: there is no column 'c'; the columns are a, b"
        );
        assert_eq!(complaint("x,y\n1,\"2\n3\"\n4,z\n", None), "points.csv: line 2, column 2: '2\\n3' is not a number");
        assert_eq!(complaint("1\n2\n", None), "points.csv: has 1 column(s); choose two with --columns");
    }

    #[test]
    fn bytes_that_are_not_text_are_named() {
        let error = points(Path::new("p.csv"), b"1,2\n3,\xff\n", None).expect_err("not text");
        assert_eq!(error.to_string(), "p.csv: line 2, column 2: is not UTF-8 text");
    }

    #[test]
    fn nothing_and_a_header_alone_have_no_points() {
        assert_eq!(read("", None), Ok(vec![]));
        assert_eq!(read("\n\r\n", None), Ok(vec![]));
        assert_eq!(read("x,y\n", None), Ok(vec![]));
    }
}
