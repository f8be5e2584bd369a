//! The columns of coordinates, by their names or numbers.

use super::columns::{Column, Columns};
use super::error::Problem;
use super::points::Wanted;

/// Pairs of names that are taken for coordinates when no columns are chosen, in the order first, second coordinate.
const KNOWN_NAMES: [[&str; 2]; 6] =
    [["x", "y"], ["lon", "lat"], ["lng", "lat"], ["long", "lat"], ["longitude", "latitude"], ["easting", "northing"]];

/// Names of three coordinates, which come before pairs.
const SPACE_NAMES: [&str; 3] = ["x", "y", "z"];

/// Names of a field that holds all coordinates of a point.
const POSITION_NAMES: [&str; 14] = [
    "xyz",
    "xy",
    "p",
    "pos",
    "position",
    "positions",
    "point",
    "points",
    "coord",
    "coords",
    "coordinates",
    "vertex",
    "vertices",
    "location",
];

/// Whether the name of a field says that it holds the coordinates of a point; capitals do not matter.
pub(super) fn is_position(name: &str) -> bool {
    POSITION_NAMES.iter().any(|known| known.eq_ignore_ascii_case(name))
}

/// The columns that are named as coordinates, if there are any; capitals do not matter.
pub(super) fn of_coordinates(names: &[String], wanted: Wanted) -> Result<Option<Vec<usize>>, Problem> {
    let known = |known: &[&str]| known.iter().map(|name| position(names, name)).collect::<Option<Vec<usize>>>();
    let in_space = known(&SPACE_NAMES);
    if wanted == Wanted::Planar && in_space.is_some() {
        return Err(Problem::ThirdCoordinate);
    }
    let columns = in_space.or_else(|| KNOWN_NAMES.iter().find_map(|pair| known(pair)));
    match columns.iter().flatten().find(|&&column| is_repeated(names, &names[column])) {
        Some(&column) => Err(Problem::TwoColumns(names[column].clone())),
        None => Ok(columns),
    }
}

/// Whether some names are those of two coordinates.
pub(super) fn are_coordinates(names: &[String]) -> bool {
    KNOWN_NAMES.iter().any(|pair| pair.iter().all(|name| position(names, name).is_some()))
}

/// The chosen columns, counted from 0, of a row with these names; `available` says which columns there are.
pub(super) fn chosen(names: &[String], columns: &Columns, available: &str) -> Result<Vec<usize>, Problem> {
    let place = |column: &Column| match column {
        Column::Name(name) if is_repeated(names, name) => Err(Problem::TwoColumns(name.clone())),
        Column::Number(number) if *number <= names.len() => Ok(number - 1),
        Column::Number(number) => Err(Problem::NoColumnNumber { number: *number, cells: names.len() }),
        Column::Name(name) => position(names, name)
            .ok_or_else(|| Problem::NoSuchColumn { name: name.clone(), available: available.to_owned() }),
    };
    columns.0.iter().map(place).collect()
}

fn position(names: &[String], wanted: &str) -> Option<usize> {
    names.iter().position(|name| name.eq_ignore_ascii_case(wanted))
}

fn is_repeated(names: &[String], name: &str) -> bool {
    names.iter().filter(|other| other.eq_ignore_ascii_case(name)).count() > 1
}
