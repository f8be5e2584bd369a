//! Arrays of NumPy, `.npy` of the versions 1.0 to 3.0: two dimensions, a row for each point or generator.

use std::path::Path;

use super::columns::{Column, Columns};
use super::error::{InputError, Place, Problem};
use super::points::{COORDINATE_LIMIT, Points, Wanted};
use super::reading::{Reading, columns_of};
use super::{MAX_POINTS, push_limited};

const MAGIC: &[u8] = b"\x93NUMPY";

/// Reads the points of an array: all its columns, or those that are chosen by number.
pub(super) fn points(
    file: &Path,
    content: &[u8],
    columns: Option<&Columns>,
    wanted: Wanted,
) -> Result<Reading, InputError> {
    let array = Array::of(content).map_err(|problem| problem.at(file, Place::File))?;
    let chosen = chosen(&array, columns, wanted).map_err(|problem| problem.at(file, Place::File))?;
    let mut points = Points::of_dimension(chosen.len()).expect("no more columns are chosen than are read");
    let mut point = [0.0; COORDINATE_LIMIT];
    for row in 0..array.rows {
        for (slot, &column) in point.iter_mut().zip(&chosen) {
            *slot = array.number(file, row, column)?;
        }
        points.push(&point[..chosen.len()]).map_err(|problem| problem.at(file, Place::File))?;
    }
    Ok(Reading::of(points, columns_of(&vec![String::new(); array.columns], &chosen)))
}

/// Reads all the rows of an array.
pub(super) fn rows(file: &Path, content: &[u8]) -> Result<Vec<Vec<f64>>, InputError> {
    let array = Array::of(content).map_err(|problem| problem.at(file, Place::File))?;
    let mut rows = Vec::new();
    for row in 0..array.rows {
        let numbers: Result<Vec<f64>, InputError> =
            (0..array.columns).map(|column| array.number(file, row, column)).collect();
        push_limited(&mut rows, numbers?).map_err(|problem| problem.at(file, Place::File))?;
    }
    Ok(rows)
}

fn chosen(array: &Array, columns: Option<&Columns>, wanted: Wanted) -> Result<Vec<usize>, Problem> {
    let cells = array.columns;
    let position = |column: &Column| match column {
        Column::Number(number) if *number <= cells => Ok(number - 1),
        Column::Number(number) => Err(Problem::NoColumnNumber { number: *number, cells }),
        Column::Name(name) => {
            Err(Problem::NoSuchColumn { name: name.clone(), available: format!("numbered 1 to {cells}") })
        }
    };
    match columns {
        Some(Columns(chosen)) => chosen.iter().map(position).collect(),
        None if wanted.takes_all(cells) || (wanted == Wanted::PlaneOrSpace && cells == 3) => Ok((0..cells).collect()),
        None => Err(Problem::ChooseColumns { cells, wanted: wanted.in_words() }),
    }
}

/// An array of numbers in the bytes of a file.
struct Array<'a> {
    data: &'a [u8],
    item: Item,
    rows: usize,
    columns: usize,
    /// Whether the columns follow each other in the file, and not the rows.
    is_fortran: bool,
}

/// How a number is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Item {
    kind: Kind,
    bytes: usize,
    is_big_endian: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Float,
    Signed,
    Unsigned,
}

impl<'a> Array<'a> {
    fn of(content: &'a [u8]) -> Result<Self, Problem> {
        let broken = |complaint: &str| Problem::Array(complaint.to_owned());
        let rest = content.strip_prefix(MAGIC).ok_or_else(|| broken("it does not begin as arrays of NumPy do"))?;
        let (length, rest) = match rest {
            [1, 0, a, b, rest @ ..] => (u32::from(u16::from_le_bytes([*a, *b])), rest),
            [2 | 3, 0, a, b, c, d, rest @ ..] => (u32::from_le_bytes([*a, *b, *c, *d]), rest),
            _ => return Err(broken("its version is not 1.0, 2.0 or 3.0")),
        };
        let length = usize::try_from(length).unwrap_or(usize::MAX);
        let (header, data) = rest.split_at_checked(length).ok_or_else(|| broken("it ends within the header"))?;
        let header = std::str::from_utf8(header).ok().and_then(Header::parse);
        let header = header.ok_or_else(|| broken("its header is not that of an array of plain numbers"))?;
        let item = Item::parse(header.kind)
            .ok_or_else(|| broken(&format!("numbers of the type '{}' are not read", header.kind)))?;
        let &[rows, columns] = header.shape.as_slice() else {
            let found = header.shape.len();
            return Err(broken(&format!("the array has {found} dimension(s), not 2: a row for each point")));
        };
        if rows > MAX_POINTS {
            return Err(Problem::TooMany { what: "points", limit: MAX_POINTS });
        }
        let expected = rows.checked_mul(columns).and_then(|count| count.checked_mul(item.bytes));
        if expected != Some(data.len()) {
            let shape = format!("{rows} × {columns} numbers of {} bytes", item.bytes);
            return Err(broken(&format!("{} bytes follow the header, not {shape}", data.len())));
        }
        Ok(Self { data, item, rows, columns, is_fortran: header.is_fortran })
    }

    fn number(&self, file: &Path, row: usize, column: usize) -> Result<f64, InputError> {
        let index = if self.is_fortran { column * self.rows + row } else { row * self.columns + column };
        let bytes = &self.data[index * self.item.bytes..][..self.item.bytes];
        self.item.read(bytes).map_err(|problem| problem.at(file, Place::Path(format!("[{row}][{column}]"))))
    }
}

impl Item {
    /// The type of a number, such as `<f8`.
    fn parse(text: &str) -> Option<Self> {
        let mut letters = text.chars();
        let order = letters.next()?;
        let kind = match letters.next()? {
            'f' => Kind::Float,
            'i' => Kind::Signed,
            'u' => Kind::Unsigned,
            _ => return None,
        };
        let bytes = match (kind, letters.as_str()) {
            (_, "8") => 8,
            (_, "4") => 4,
            (Kind::Signed | Kind::Unsigned, "2") => 2,
            (Kind::Signed | Kind::Unsigned, "1") => 1,
            _ => return None,
        };
        let has_order = matches!(order, '<' | '>') || (order == '|' && bytes == 1);
        has_order.then_some(Self { kind, bytes, is_big_endian: order == '>' })
    }

    /// The number, which must be finite and a double.
    fn read(self, bytes: &[u8]) -> Result<f64, Problem> {
        let mut wide = [0; 8];
        wide[..self.bytes].copy_from_slice(bytes);
        if self.is_big_endian {
            wide[..self.bytes].reverse();
        }
        let unused_bits = 64 - 8 * self.bytes as u32;
        let exact = |whole: i128| {
            let number = whole as f64;
            if number as i128 == whole { Ok(number) } else { Err(Problem::NotADouble(whole.to_string())) }
        };
        match self.kind {
            Kind::Signed => exact(i128::from((i64::from_le_bytes(wide) << unused_bits) >> unused_bits)),
            Kind::Unsigned => exact(i128::from(u64::from_le_bytes(wide))),
            Kind::Float => {
                let short = f32::from_le_bytes([wide[0], wide[1], wide[2], wide[3]]);
                let number = if self.bytes == 4 { f64::from(short) } else { f64::from_le_bytes(wide) };
                if number.is_finite() { Ok(number) } else { Err(Problem::NotFinite(number.to_string())) }
            }
        }
    }
}

/// What the header says: a dictionary in the notation of Python.
struct Header<'a> {
    kind: &'a str,
    is_fortran: bool,
    shape: Vec<usize>,
}

impl<'a> Header<'a> {
    fn parse(text: &'a str) -> Option<Self> {
        let mut words = Words(text);
        let (mut kind, mut is_fortran, mut shape) = (None, None, None);
        words.take("{").then_some(())?;
        while !words.take("}") {
            let name = words.quoted()?;
            words.take(":").then_some(())?;
            match name {
                "descr" => kind = Some(words.quoted()?),
                "fortran_order" if words.take("True") => is_fortran = Some(true),
                "fortran_order" if words.take("False") => is_fortran = Some(false),
                "shape" => shape = Some(words.shape()?),
                _ => return None,
            }
            if !words.take(",") {
                words.take("}").then_some(())?;
                break;
            }
        }
        let is_over = words.0.trim().is_empty();
        is_over.then_some(Self { kind: kind?, is_fortran: is_fortran?, shape: shape? })
    }
}

/// The text that is still to be read.
struct Words<'a>(&'a str);

impl<'a> Words<'a> {
    fn take(&mut self, word: &str) -> bool {
        let rest = self.0.trim_start().strip_prefix(word);
        rest.inspect(|rest| self.0 = rest).is_some()
    }

    fn quoted(&mut self) -> Option<&'a str> {
        let quote = if self.take("'") { '\'' } else { self.take("\"").then_some('"')? };
        let (text, rest) = self.0.split_once(quote)?;
        self.0 = rest;
        Some(text)
    }

    fn shape(&mut self) -> Option<Vec<usize>> {
        self.take("(").then_some(())?;
        let (lengths, rest) = self.0.split_once(')')?;
        self.0 = rest;
        let lengths = lengths.trim().trim_end_matches(',');
        if lengths.is_empty() {
            return Some(Vec::new());
        }
        lengths.split(',').map(|length| length.trim().trim_end_matches('L').parse().ok()).collect()
    }
}

#[cfg(test)]
mod tests;
