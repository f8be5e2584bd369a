//! Points from a table of separated cells.

use std::path::Path;

use csv::{ByteRecord, Reader, ReaderBuilder};

use super::columns::{Column, Columns};
use super::error::{InputError, Place, Problem};
use super::points::{COORDINATE_LIMIT, Points, Wanted};
use super::push_limited;
use super::reading::{Reading, columns_of};

/// Pairs of header names that are taken for coordinates when no columns are chosen, in the order first, second
/// coordinate.
const KNOWN_NAMES: [[&str; 2]; 6] =
    [["x", "y"], ["lon", "lat"], ["lng", "lat"], ["long", "lat"], ["longitude", "latitude"], ["easting", "northing"]];

/// Names of three coordinates, which come before pairs.
const SPACE_NAMES: [&str; 3] = ["x", "y", "z"];

/// Reads the points of a table.
///
/// The first line is a header if the chosen columns are named, if some cell of it is text where the second line has a
/// number, or if neither chosen cell is a number.
pub(super) fn points(
    file: &Path,
    content: &[u8],
    columns: Option<&Columns>,
    wanted: Wanted,
) -> Result<Reading, InputError> {
    let mut table = Table { file, content, columns: vec![0, 1], width: None };
    table.read(columns, wanted)
}

/// Reads all the numbers of a table, row by row: rows of the same length, after a header line that is recognised as
/// above.
pub(super) fn rows(file: &Path, content: &[u8]) -> Result<Vec<Vec<f64>>, InputError> {
    let mut table = Table { file, content, columns: vec![0], width: None };
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
    columns: Vec<usize>,
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

    fn read(&mut self, columns: Option<&Columns>, wanted: Wanted) -> Result<Reading, InputError> {
        let mut reader = self.reader();
        let mut rows = reader.byte_records().filter(|row| !row.as_ref().is_ok_and(is_blank));

        let Some(first) = rows.next() else {
            return Ok(Reading::without_columns(Points::Plane(Vec::new()), Vec::new()));
        };
        let first = self.parsed(first)?;
        let second = rows.next().map(|row| self.parsed(row)).transpose()?;
        self.columns = self.chosen(&first, columns, wanted)?;

        let mut points = Points::of_dimension(self.columns.len()).expect("no more columns are chosen than are read");
        let named = columns.is_some_and(|Columns(all)| all.iter().any(|column| matches!(column, Column::Name(_))));
        let has_header = named || self.is_header(&first, second.as_ref());
        let names: Vec<String> = if has_header { cells(&first) } else { vec![String::new(); first.len()] };
        let opening = if has_header { None } else { Some(first) };
        for row in opening.into_iter().chain(second).map(Ok).chain(rows.map(|row| self.parsed(row))) {
            let row = row?;
            let mut point = [0.0; COORDINATE_LIMIT];
            for (slot, &column) in point.iter_mut().zip(&self.columns) {
                *slot = self.number(&row, column)?;
            }
            points
                .push(&point[..self.columns.len()])
                .map_err(|problem| problem.at(self.file, Place::Line(self.line(&row))))?;
        }
        Ok(Reading::of(points, columns_of(&names, &self.columns)))
    }

    /// The row, if it parses.
    fn parsed(&self, row: csv::Result<ByteRecord>) -> Result<ByteRecord, InputError> {
        row.map_err(|error| Problem::Table(error.to_string()).at(self.file, Place::File))
    }

    fn chosen(
        &mut self,
        first: &ByteRecord,
        columns: Option<&Columns>,
        wanted: Wanted,
    ) -> Result<Vec<usize>, InputError> {
        self.width = Some(first.len());
        let names = cells(first);
        let position = |wanted: &str| names.iter().position(|name| name.eq_ignore_ascii_case(wanted));
        if let Some(Columns(chosen)) = columns {
            let place = |column: &Column| match column {
                Column::Name(name) if is_repeated(&names, name) => Err(Problem::TwoColumns(name.clone())),
                Column::Number(number) if *number <= names.len() => Ok(number - 1),
                Column::Number(number) => Err(Problem::NoColumnNumber { number: *number, cells: names.len() }),
                Column::Name(name) => position(name)
                    .ok_or_else(|| Problem::NoSuchColumn { name: name.clone(), available: names.join(", ") }),
            };
            let at_first = |problem: Problem| problem.at(self.file, Place::Line(self.line(first)));
            return chosen.iter().map(|column| place(column).map_err(at_first)).collect();
        }
        let known = |names: &[&str]| names.iter().map(|name| position(name)).collect::<Option<Vec<usize>>>();
        let in_space = known(&SPACE_NAMES);
        if wanted == Wanted::Planar && in_space.is_some() {
            return Err(Problem::ThirdCoordinate.at(self.file, Place::Line(self.line(first))));
        }
        if let Some(columns) = in_space.or_else(|| KNOWN_NAMES.iter().find_map(|pair| known(pair))) {
            return match columns.iter().find(|&&column| is_repeated(&names, &names[column])) {
                Some(&column) => {
                    let place = Place::Line(self.line(first));
                    Err(Problem::TwoColumns(names[column].clone()).at(self.file, place))
                }
                None => Ok(columns),
            };
        }
        if wanted.takes_all(first.len()) {
            return Ok((0..first.len()).collect());
        }
        let problem = Problem::ChooseColumns { cells: first.len(), wanted: wanted.in_words() };
        Err(problem.at(self.file, Place::File))
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
            let place = Place::Cell { line: self.line(row), column: row.len().min(width) as u64 + 1 };
            return Err(problem.at(self.file, place));
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

/// The cells of a row as text, without the space around them.
fn cells(row: &ByteRecord) -> Vec<String> {
    row.iter().map(|cell| String::from_utf8_lossy(cell).trim().to_owned()).collect()
}

fn is_repeated(names: &[String], name: &str) -> bool {
    names.iter().filter(|other| other.eq_ignore_ascii_case(name)).count() > 1
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
        let points = points(Path::new("points.csv"), content.as_bytes(), columns.as_ref(), Wanted::Planar);
        match points.map_err(|error| error.to_string())?.points {
            Points::Plane(points) => Ok(points),
            other => panic!("{other:?} are not points of the plane"),
        }
    }

    #[test]
    fn headers_are_recognised_and_may_be_absent() {
        let expected = Ok(vec![[1.0, 2.0], [3.0, 4.0]]);
        assert_eq!(read("1,2\n3,4\n", None), expected);
        assert_eq!(read("a,b\n1,2\n3,4", None), expected);
        assert_eq!(read("y,w,x\n2,0,1\n4,0,3\n", None), expected);
        assert_eq!(read("name,Lat,LON\np,2,1\nq,4,3\n", None), expected);
        assert_eq!(read("150,4,setosa\n1,2,0\n3,4,0\n", Some("1,2")), expected);
        assert_eq!(
            read("7,8\n2,1\n4,3\n", Some("8,7")),
            Err("points.csv: line 1: there is no column 8; the row has 2 cells".into())
        );
        let twice = "points.csv: line 1: two columns are named 'x'; choose with --columns by number";
        assert_eq!(read("x,y,x\n1,2,0\n3,4,0\n", None), Err(twice.into()));
        assert_eq!(read("x,y,x\n1,2,0\n3,4,0\n", Some("x,y")), Err(twice.into()));
        assert_eq!(read("x,y,x\n1,2,0\n3,4,0\n", Some("1,2")), expected);
        let broken = "points.csv: line 1: there is no column 'x'; the columns are a\\nb, c";
        assert_eq!(read("\"a\nb\",c\n1,2\n", Some("x,c")), Err(broken.into()));
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
        assert_eq!(complaint("1,2\n3\n", None), "points.csv: line 2, column 2: the row has 1 cells, not 2");
        assert_eq!(complaint("1,2\n3,4,5\n", None), "points.csv: line 2, column 3: the row has 3 cells, not 2");
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
    fn any_number_of_coordinates() {
        let read = |content: &str, columns: Option<&str>| {
            let columns = columns.map(|columns| columns.parse().expect("well formed"));
            points(Path::new("p.csv"), content.as_bytes(), columns.as_ref(), Wanted::Any)
                .map(|reading| reading.points)
                .map_err(|error| error.to_string())
        };
        assert_eq!(read("z,x,y,w\n3,1,2,9\n", None), Ok(Points::Space(vec![[1.0, 2.0, 3.0]])));
        assert_eq!(read("7\n8\n", None), Ok(Points::Line(vec![[7.0], [8.0]])));
        assert_eq!(read("1,2,3,4\n", None), Ok(Points::Four(vec![[1.0, 2.0, 3.0, 4.0]])));
        assert_eq!(read("id,lon,lat\na,1,2\n", None), Ok(Points::Plane(vec![[1.0, 2.0]])));
        let iris = "150,4,setosa,versicolor,virginica\n5.1,3.5,1.4,0.2,0\n";
        assert_eq!(read(iris, Some("1,2,3,4")), Ok(Points::Four(vec![[5.1, 3.5, 1.4, 0.2]])));
        assert_eq!(read(iris, None), Err("p.csv: has 5 column(s); choose two to four with --columns".into()));
    }

    /// Three columns x, y, z are a point of space each: none of them is dropped unless the others are chosen.
    #[test]
    fn a_third_coordinate_is_not_dropped_in_silence() {
        let read = |columns: Option<&str>, wanted: Wanted| {
            let columns = columns.map(|columns| columns.parse().expect("well formed"));
            let content = b"Name,X,y,Z\na,1,2,3\n";
            points(Path::new("p.csv"), content, columns.as_ref(), wanted).map_err(|error| error.to_string())
        };
        for wanted in [Wanted::PlaneOrSpace, Wanted::Any] {
            let reading = read(None, wanted).expect("points of space");
            assert_eq!(reading.points, Points::Space(vec![[1.0, 2.0, 3.0]]));
            assert_eq!(reading.in_words().as_deref(), Some("X, y, Z; left out: Name"));
        }
        let refused = "p.csv: line 1: has the columns x, y and z, so its points are in space; choose two columns with \
                       --columns";
        assert_eq!(read(None, Wanted::Planar), Err(refused.to_owned()));
        let chosen = read(Some("x,y"), Wanted::Planar).expect("points of the plane");
        assert_eq!(chosen.points, Points::Plane(vec![[1.0, 2.0]]));
        assert_eq!(chosen.in_words().as_deref(), Some("X, y; left out: Name, Z"));
    }

    #[test]
    fn the_columns_told_are_columns_to_choose() {
        for content in ["a,b,c\n1,2,x\n", "7;8;x\n9;9;y\n", "q,q,r\n1,2,3\n", "2,1,z\n5,6,7\n"] {
            let columns: Columns = "2,1".parse().expect("well formed");
            let read = |columns| points(Path::new("p.csv"), content.as_bytes(), Some(columns), Wanted::Planar);
            let reading = read(&columns).expect("two columns of numbers");
            let again = read(&Columns(reading.columns.clone())).expect("the same columns");
            assert_eq!(reading, again, "{content}");
        }
    }

    #[test]
    fn bytes_that_are_not_text_are_named() {
        let error = points(Path::new("p.csv"), b"1,2\n3,\xff\n", None, Wanted::Planar).expect_err("not text");
        assert_eq!(error.to_string(), "p.csv: line 2, column 2: is not UTF-8 text");
    }

    #[test]
    fn nothing_and_a_header_alone_have_no_points() {
        assert_eq!(read("", None), Ok(vec![]));
        assert_eq!(read("\n\r\n", None), Ok(vec![]));
        assert_eq!(read("x,y\n", None), Ok(vec![]));
    }
}
