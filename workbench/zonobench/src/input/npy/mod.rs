//! Arrays of NumPy, `.npy` of the versions 1.0 to 3.0: two dimensions, a row for each point or generator, or one
//! dimension of records, whose fields are the columns.

mod header;
mod item;

use std::path::Path;

use self::header::{Descr, Header};
use self::item::Item;
use super::columns::Columns;
use super::error::{InputError, Place, Problem};
use super::names::{self, Order};
use super::points::{COORDINATE_LIMIT, Points, Wanted};
use super::points::{MAX_POINTS, push_limited};
use super::reading::{Reading, Skipping, columns_of};
use super::table::{Counting, Rows};

/// The largest number of columns of an array of points, and of numbers in a record.
const COLUMN_LIMIT: usize = 1 << 16;

const MAGIC: &[u8] = b"\x93NUMPY";

/// Reads the points of an array: all its columns, those that are chosen by number or by the name of a field, or the
/// fields that are named as coordinates.
pub(super) fn points(
    file: &Path,
    content: &[u8],
    columns: Option<&Columns>,
    wanted: Wanted,
    skipping: &mut Skipping,
) -> Result<Reading, InputError> {
    let array = Array::of(content).map_err(|problem| problem.at(file, Place::File))?;
    let chosen = chosen(&array, columns, wanted).map_err(|problem| problem.at(file, Place::File))?;
    let mut points = Points::of_dimension(chosen.len()).expect("no more columns are chosen than are read");
    let is_named = array.names().iter().any(|name| !name.is_empty());
    let mut counting = Counting::new(columns.is_some(), is_named, &chosen);
    let mut point = [0.0; COORDINATE_LIMIT];
    'rows: for row in 0..array.rows {
        for (slot, &column) in point.iter_mut().zip(&chosen) {
            *slot = match array.number(file, row, column) {
                Err(error) if skipping.passes_over(&error.problem, points.len()) => continue 'rows,
                number => number?,
            };
        }
        counting.note(point[0]);
        points.push(&point[..chosen.len()]).map_err(|problem| problem.at(file, Place::File))?;
    }
    let mut reading = Reading::of(points, columns_of(&array.names(), &chosen));
    reading.notes.extend(counting.in_words(&chosen, true));
    if columns.is_none() {
        let names = array.names();
        reading.notes.extend(names::in_another_order(&chosen.iter().map(|&c| names[c].clone()).collect::<Vec<_>>()));
    }
    Ok(reading)
}

/// Reads the rows of an array, with the names of the columns, none of which an array without records has. Fields that
/// are named as coordinates are put in their order, and labels of rows are left out, as `order` says.
pub(super) fn rows(file: &Path, content: &[u8], order: Order) -> Result<Rows, InputError> {
    let at_file = |problem: Problem| problem.at(file, Place::File);
    let array = Array::of(content).map_err(at_file)?;
    let mut rows = Rows::default();
    let all = array.field_names();
    let columns: Vec<usize> = if all.is_empty() {
        (0..array.columns()).collect()
    } else {
        array.check_lists().map_err(at_file)?;
        let vectors = names::of_vectors(&all, order).map_err(at_file)?;
        rows.notes = vectors.notes(&all);
        vectors.places
    };
    for row in 0..array.rows {
        let numbers: Result<Vec<f64>, InputError> =
            columns.iter().map(|&column| array.number(file, row, column)).collect();
        push_limited(&mut rows.numbers, numbers?).map_err(at_file)?;
    }
    rows.names = columns.iter().filter_map(|&column| all.get(column).cloned()).collect();
    Ok(rows)
}

fn chosen(array: &Array, columns: Option<&Columns>, wanted: Wanted) -> Result<Vec<usize>, Problem> {
    let cells = array.columns();
    if cells > COLUMN_LIMIT {
        return Err(Problem::TooMany { what: "columns", limit: COLUMN_LIMIT });
    }
    let names = array.names();
    let is_named = names.iter().any(|name| !name.is_empty());
    if let Some(columns) = columns {
        let available = if is_named { names.join(", ") } else { format!("numbered 1 to {cells}") };
        return names::chosen(&names, columns, &available);
    }
    let of_coordinates = if is_named { names::of_coordinates(&names, wanted)? } else { None };
    match of_coordinates.or_else(|| array.position(wanted)) {
        Some(columns) => Ok(columns),
        None if wanted.takes_all(cells, is_named) => Ok((0..cells).collect()),
        None => {
            let columns = names::advised(&names, 0..cells);
            Err(Problem::ChooseColumns { cells, wanted: wanted.in_words(), columns })
        }
    }
}

/// An array of numbers in the bytes of a file.
struct Array<'a> {
    data: &'a [u8],
    rows: usize,
    layout: Layout,
}

/// The order of the numbers of an array in the file.
enum Layout {
    /// Numbers of one type; the columns follow each other in the order of Fortran, else the rows.
    Grid { item: Item, columns: usize, is_fortran: bool },
    /// Records of so many bytes.
    Records { bytes: usize, columns: Vec<Column> },
}

/// A number of a record.
struct Column {
    /// The name of the field, with the place in it if the field is an array.
    name: String,
    /// The type of the number, or its name where it is not read.
    item: Result<Item, String>,
    /// Its first byte in the record.
    start: usize,
    /// The number of the field, if the field is an array.
    vector: Option<usize>,
    /// Whether that array has more than one dimension.
    is_of_matrix: bool,
}

impl<'a> Array<'a> {
    fn of(content: &'a [u8]) -> Result<Self, Problem> {
        let rest = content.strip_prefix(MAGIC).ok_or_else(|| {
            broken(if content.starts_with(b"PK") {
                "it is an archive of arrays, .npz; save one array as .npy"
            } else {
                "it does not begin as arrays of NumPy do"
            })
        })?;
        let (length, rest) = match rest {
            [1, 0, a, b, rest @ ..] => (u32::from(u16::from_le_bytes([*a, *b])), rest),
            [2 | 3, 0, a, b, c, d, rest @ ..] => (u32::from_le_bytes([*a, *b, *c, *d]), rest),
            _ => return Err(broken("its version is not 1.0, 2.0 or 3.0")),
        };
        let length = usize::try_from(length).unwrap_or(usize::MAX);
        let (header, data) = rest.split_at_checked(length).ok_or_else(|| broken("it ends within the header"))?;
        let header = std::str::from_utf8(header).ok().and_then(Header::parse);
        let header =
            header.ok_or_else(|| broken("its header is not that of an array of plain numbers or of records"))?;
        match header.descr {
            Descr::Plain(kind) => Self::of_numbers(data, kind, &header.shape, header.is_fortran),
            Descr::Records(fields) => Self::of_records(data, &fields, &header.shape),
        }
    }

    fn of_numbers(data: &'a [u8], kind: &str, shape: &[usize], is_fortran: bool) -> Result<Self, Problem> {
        let item = Item::parse(kind).ok_or_else(|| unread_type(kind))?;
        let &[rows, columns] = shape else {
            let found = shape.len();
            let problem = format!("the array has {found} dimension(s), not 2: a row for each point");
            return Err(Problem::Shape(problem));
        };
        check_rows(rows)?;
        let expected = rows.checked_mul(columns).and_then(|count| count.checked_mul(item.bytes()));
        if expected != Some(data.len()) {
            let shape = format!("{rows} × {columns} numbers of {} bytes", item.bytes());
            return Err(broken(&format!("{} bytes follow the header, not {shape}", data.len())));
        }
        Ok(Self { data, rows, layout: Layout::Grid { item, columns, is_fortran } })
    }

    fn of_records(data: &'a [u8], fields: &[header::Field], shape: &[usize]) -> Result<Self, Problem> {
        let &[rows] = shape else {
            let found = shape.len();
            let problem = format!("the records have {found} dimension(s), not 1: a record for each point");
            return Err(Problem::Shape(problem));
        };
        check_rows(rows)?;
        let (mut columns, mut bytes) = (Vec::new(), 0_usize);
        for (number, field) in fields.iter().enumerate() {
            let length = item::bytes_of(field.kind)
                .ok_or_else(|| Problem::Shape(format!("fields of the type '{}' are not read", field.kind)))?;
            if field.count > COLUMN_LIMIT - columns.len() {
                return Err(Problem::TooMany { what: "numbers in a record", limit: COLUMN_LIMIT });
            }
            let is_of_matrix = field.dimensions > 1;
            let is_padding = field.name.is_empty() && field.kind.contains('V');
            for place in 0..field.count {
                let item = Item::parse(field.kind).ok_or_else(|| field.kind.to_owned());
                let name = if field.is_list { format!("{}[{place}]", field.name) } else { field.name.to_owned() };
                if !is_padding {
                    columns.push(Column {
                        name,
                        item,
                        start: bytes,
                        vector: field.is_list.then_some(number),
                        is_of_matrix,
                    });
                }
                bytes = bytes.saturating_add(length);
            }
        }
        if bytes.checked_mul(rows) != Some(data.len()) {
            let shape = format!("{rows} records of {bytes} bytes");
            return Err(broken(&format!("{} bytes follow the header, not {shape}", data.len())));
        }
        Ok(Self { data, rows, layout: Layout::Records { bytes, columns } })
    }

    /// The number of the columns.
    fn columns(&self) -> usize {
        match &self.layout {
            Layout::Grid { columns, .. } => *columns,
            Layout::Records { columns, .. } => columns.len(),
        }
    }

    /// The names of the columns; empty where they have none.
    fn names(&self) -> Vec<String> {
        match &self.layout {
            Layout::Grid { columns, .. } => vec![String::new(); *columns],
            Layout::Records { columns, .. } => columns.iter().map(|column| column.name.clone()).collect(),
        }
    }

    /// The columns of the only field of the records that is an array and is named as a position, if they can be
    /// coordinates.
    fn position(&self, wanted: Wanted) -> Option<Vec<usize>> {
        let Layout::Records { columns, .. } = &self.layout else { return None };
        let vector =
            |index: usize| columns[index].vector.filter(|_| names::is_position(field_of(&columns[index].name)));
        let chosen: Vec<usize> = (0..columns.len()).filter(|&index| vector(index).is_some()).collect();
        let is_one = chosen.windows(2).all(|pair| vector(pair[0]) == vector(pair[1]));
        (is_one && chosen.len() > 1 && wanted.takes_all(chosen.len(), false)).then_some(chosen)
    }

    /// Refuses records of several fields of which one is an array: nothing says what the numbers of a row are then.
    fn check_lists(&self) -> Result<(), Problem> {
        let Layout::Records { columns, .. } = &self.layout else { return Ok(()) };
        let Some(list) = columns.iter().find(|column| column.vector.is_some()) else { return Ok(()) };
        let is_alone = columns.iter().all(|column| column.vector == list.vector);
        if is_alone && !list.is_of_matrix {
            return Ok(());
        }
        let problem = format!(
            "the field `{}` of the records is an array, and a row of vectors has plain numbers: save an array of two \
             dimensions",
            field_of(&list.name)
        );
        Err(Problem::Shape(problem))
    }

    /// The names of the columns of records.
    fn field_names(&self) -> Vec<String> {
        match &self.layout {
            Layout::Grid { .. } => Vec::new(),
            Layout::Records { .. } => self.names(),
        }
    }

    fn number(&self, file: &Path, row: usize, column: usize) -> Result<f64, InputError> {
        let at = |problem: Problem| problem.at(file, Place::Path(format!("[{row}][{column}]")));
        let (item, start) = match &self.layout {
            Layout::Grid { item, is_fortran: true, .. } => (item, (column * self.rows + row) * item.bytes()),
            Layout::Grid { item, columns, .. } => (item, (row * columns + column) * item.bytes()),
            Layout::Records { bytes, columns } => {
                let Column { name, item, start, .. } = &columns[column];
                let item = item.as_ref().map_err(|kind| unread_type(kind).at(file, Place::Path(name.clone())))?;
                (item, start + row * bytes)
            }
        };
        item.read(&self.data[start..][..item.bytes()]).map_err(at)
    }
}

/// The name of the field that a column belongs to.
fn field_of(column: &str) -> &str {
    column.split_once('[').map_or(column, |(field, _)| field)
}

fn check_rows(rows: usize) -> Result<(), Problem> {
    if rows > MAX_POINTS { Err(Problem::TooMany { what: "points", limit: MAX_POINTS }) } else { Ok(()) }
}

/// The complaint about numbers of a type that doubles do not stand for.
fn unread_type(kind: &str) -> Problem {
    Problem::Shape(format!("numbers of the type '{kind}' are not read; real numbers of at most 64 bits are"))
}

fn broken(complaint: &str) -> Problem {
    Problem::Array(complaint.to_owned())
}

#[cfg(test)]
mod tests;
