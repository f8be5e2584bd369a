//! Grounds of complaints and remarks on a table: the columns that there are, and cells and points that may be meant
//! otherwise.

use csv::ByteRecord;

use super::header::has_number;
use super::rows::cells;
use super::start::LAST_ELEMENT;
use super::text::Text;
use crate::input::points::Points;

/// Whether the first coordinates are all atomic numbers, beside others that are not all whole.
pub(super) fn may_be_atoms(points: &Points) -> bool {
    let is_element = |x: f64| x.fract() == 0.0 && (1.0..=f64::from(LAST_ELEMENT)).contains(&x);
    points.rows().all(|point| is_element(point[0]))
        && points.rows().any(|point| point[1..].iter().any(|x| x.fract() != 0.0))
}

/// The columns of a table by their names; by their numbers where the first row is one of data.
pub(super) fn available(first: &ByteRecord) -> String {
    if has_number(first) {
        return format!("numbered 1 to {}, as no row names them; a line that begins with # is a comment", first.len());
    }
    let named = |(index, name): (usize, String)| match name.is_empty() {
        true => format!("column {} (unnamed)", index + 1),
        false => name,
    };
    cells(first).into_iter().enumerate().map(named).collect::<Vec<_>>().join(", ")
}

/// Whether a row such as `0,5,-1,25` between commas may hold numbers with decimal commas: behind each whole number
/// there are digits alone.
pub(super) fn may_be_halves(first: &ByteRecord, separator: u8) -> bool {
    let has_digits = |cell: &[u8]| !cell.is_empty() && cell.iter().all(u8::is_ascii_digit);
    let is_half = |(place, cell): (usize, &[u8])| {
        let cell = cell.trim_ascii();
        has_digits(if place % 2 == 0 { cell.strip_prefix(b"-").unwrap_or(cell) } else { cell })
    };
    separator == b',' && first.len() >= 4 && first.len().is_multiple_of(2) && first.iter().enumerate().all(is_half)
}

/// Whether a cell such as `5:0` is two whole numbers with one other character between, as decimal commas on both sides
/// of an unknown separator leave it.
pub(super) fn joins_digits(cell: &str) -> bool {
    let mut parts = cell.split(|letter: char| !letter.is_ascii_digit());
    let is_filled = |part: Option<&str>| part.is_some_and(|part| !part.is_empty());
    is_filled(parts.next()) && is_filled(parts.next()) && parts.next().is_none()
}

/// The cure where the first row has one cell: another format, lines above the table, or another separator.
pub(super) fn on_one_column(text: &Text, first: &ByteRecord) -> String {
    let word = String::from_utf8_lossy(first.get(0).unwrap_or_default()).trim().to_ascii_lowercase();
    let formats = [("ply", "ply"), ("solid", "stl"), ("off", "off"), ("[", "json"), ("{", "json")];
    let is_begun = |mark: &str| word == mark || (mark.len() == 1 && word.starts_with(mark));
    if let Some((mark, format)) = formats.into_iter().find(|(mark, _)| is_begun(mark)) {
        return format!("it begins with `{mark}`, so it may be of the format {format}: --format {format}");
    }
    let wider = text.rows().filter_map(Result::ok).find(|row| row.len() > 1);
    let is_below = |wider: &ByteRecord| text.line(wider) > text.line(first) && !has_number(wider);
    if first.len() > 1 && !wider.as_ref().is_some_and(is_below) {
        let cells = first.len();
        return format!("a row has {cells} cells, of which one has a name; choose columns, as by --columns 1,{cells}");
    }
    match wider {
        Some(wider) => {
            let (line, wide) = (text.line(first), text.line(&wider));
            let (cells, skip) = (wider.len(), wide - 1);
            format!(
                "line {line} has 1 cell, and line {wide} has {cells}; if the table begins there, --skip {skip} \
                 leaves out what stands above it"
            )
        }
        None => "commas, semicolons, tabs, bars and spaces separate the cells of a row".to_owned(),
    }
}
