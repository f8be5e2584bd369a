//! The columns of coordinates, by their names or numbers.

mod alike;
pub(super) mod bodies;

use self::alike::of_alike_names;
use super::columns::{Column, Columns};
use super::error::Problem;
use super::points::Wanted;

/// Pairs of names that are taken for coordinates when no columns are chosen, in the order first, second coordinate.
const KNOWN_NAMES: [[&str; 2]; 8] = [
    ["x", "y"],
    ["lon", "lat"],
    ["lng", "lat"],
    ["long", "lat"],
    ["longitude", "latitude"],
    ["easting", "northing"],
    ["e", "n"],
    ["rechtswert", "hochwert"],
];

/// Words before or behind the name of a coordinate that say that it is one.
const POSITION_WORDS: [&str; 7] = ["pos", "position", "coord", "coordinate", "point", "p", "utm"];

/// Units of a length or an angle behind a name.
const UNITS: [&str; 10] = ["m", "mm", "cm", "km", "ft", "in", "deg", "rad", "degrees", "px"];

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

/// The name without a unit, in brackets or behind a line, and without words that say that it is a coordinate.
fn bare(name: &str) -> String {
    let name = name.split(['[', '(']).next().unwrap_or_default().trim().to_lowercase();
    let is_between = |c: char| " _-.:".contains(c);
    let mut words: Vec<&str> = name.split(is_between).filter(|word| !word.is_empty()).collect();
    if words.len() > 1 && UNITS.contains(&words[words.len() - 1]) {
        words.pop();
    }
    if words.len() > 1 && POSITION_WORDS.contains(&words[0]) {
        words.remove(0);
    }
    if words.len() > 1 && POSITION_WORDS.contains(&words[words.len() - 1]) {
        words.pop();
    }
    match words.as_slice() {
        ["px"] => "x".to_owned(),
        ["py"] => "y".to_owned(),
        ["pz"] => "z".to_owned(),
        words => words.join(" "),
    }
}

/// The columns that are named as coordinates, if there are any, as they stand, without units and words that say that
/// they are coordinates, or alike but for the coordinate; capitals do not matter.
pub(super) fn of_coordinates(names: &[String], wanted: Wanted) -> Result<Option<Vec<usize>>, Problem> {
    if let Some(columns) = of_plain_names(names, wanted)? {
        return Ok(Some(columns));
    }
    if let Some(columns) = of_plain_names(&names.iter().map(|name| bare(name)).collect::<Vec<_>>(), wanted)? {
        return Ok(Some(columns));
    }
    match of_alike_names(names) {
        Some(columns) if columns.len() == 3 && wanted == Wanted::Planar => Err(Problem::ThirdCoordinate),
        columns => Ok(columns),
    }
}

fn of_plain_names(names: &[String], wanted: Wanted) -> Result<Option<Vec<usize>>, Problem> {
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
    let are = |names: &[String]| KNOWN_NAMES.iter().any(|pair| pair.iter().all(|name| position(names, name).is_some()));
    are(names) || are(&names.iter().map(|name| bare(name)).collect::<Vec<_>>()) || of_alike_names(names).is_some()
}

/// Names of columns that number or weigh the rows of a table.
const LABELS: [&str; 13] =
    ["id", "index", "idx", "fid", "oid", "objectid", "rowid", "row", "rownames", "uuid", "weight", "weights", "w"];

/// Whether a name is that of a column that numbers or weighs the rows of a table; capitals do not matter.
pub(super) fn is_label(name: &str) -> bool {
    LABELS.iter().any(|label| label.eq_ignore_ascii_case(name))
}

/// The columns that may hold coordinates, as `--columns` takes them: of those given by place, the ones that are no
/// labels, by name where a shell leaves the name as it is and no other column has it, else by number.
pub(super) fn advised(names: &[String], places: impl IntoIterator<Item = usize>) -> Vec<String> {
    let is_plain = |name: &String| {
        let begins = name.starts_with(|c: char| c.is_alphabetic() || c == '_');
        begins && name.chars().all(|c| c.is_alphanumeric() || "_-.".contains(c)) && !is_repeated(names, name)
    };
    let places = places.into_iter().filter(|&place| !is_label(&names[place]));
    places.map(|place| if is_plain(&names[place]) { names[place].clone() } else { (place + 1).to_string() }).collect()
}

/// The way in which the named columns of vectors are put in order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Order {
    /// Each row is a vector: columns that are named as coordinates are its coordinates, others are left out.
    Coordinates,
    /// Each column is a vector, whose order does not matter.
    AsTheyStand,
    /// The rows are those of a matrix, whose columns must stand in the order of the coordinates.
    Matrix,
}

/// The columns of vectors, by their places.
pub(super) struct Vectors {
    pub(super) places: Vec<usize>,
}

impl Vectors {
    /// The columns that hold no coordinates, and the order of the others if it is not that of the file, in words.
    pub(super) fn notes(&self, names: &[String]) -> Vec<String> {
        let used: Vec<String> = self.places.iter().map(|&place| names[place].clone()).collect();
        let is_left_out = |place: &usize| !self.places.contains(place);
        let others = (0..names.len()).filter(is_left_out);
        let mut notes: Vec<String> = others.map(|place| format!("left out: the column {}", names[place])).collect();
        if !self.places.is_sorted() {
            let order: Vec<&str> = self.places.iter().map(|&place| names[place].as_str()).collect();
            notes.push(format!("the columns are read in the order {}", order.join(", ")));
        }
        notes.extend(in_another_order(&used));
        notes
    }
}

/// Names of the second coordinate before the first: numbers of rows and columns, and parts of complex numbers.
const REVERSED: [[&str; 2]; 4] = [["row", "col"], ["row", "column"], ["imag", "real"], ["im", "re"]];

/// The remark on columns under names that count down, such as `b, a` or `col2, col1`, or that stand for a point in the
/// reverse order, and that are no names of coordinates: they are read as they stand.
pub(super) fn in_another_order(names: &[String]) -> Option<String> {
    let lower: Vec<String> = names.iter().map(|name| name.trim().to_lowercase()).collect();
    let is_filled = lower.len() > 1 && lower.iter().all(|name| !name.is_empty());
    if !is_filled || are_coordinates(names) {
        return None;
    }
    let in_words = || format!("the columns {} are read in the order in which they stand", names.join(", "));
    if lower.windows(2).any(|names| REVERSED.iter().any(|pair| pair.iter().eq(names))) {
        return Some(in_words());
    }
    // The letters that all names begin with, digits apart.
    let letters = |name: &str| name.trim_end_matches(|c: char| c.is_ascii_digit()).to_owned();
    let number = |name: &str| name[letters(name).len()..].parse::<u64>().ok();
    let is_single = lower.iter().all(|name| name.chars().count() == 1);
    let has_one_stem = lower.iter().all(|name| letters(name) == letters(&lower[0]));
    let places: Vec<u64> = match (is_single, has_one_stem) {
        (true, _) => {
            lower.iter().filter_map(|name| name.chars().next()).map(|letter| u64::from(u32::from(letter))).collect()
        }
        (_, true) => lower.iter().filter_map(|name| number(name)).collect(),
        _ => return None,
    };
    let is_in_order = places.is_sorted() || places.len() != names.len();
    (!is_in_order).then(in_words)
}

/// The columns of vectors under these names: none that numbers or weighs the rows, and those of coordinates in their
/// order.
pub(super) fn of_vectors(names: &[String], order: Order) -> Result<Vectors, Problem> {
    let in_order = if order == Order::AsTheyStand { None } else { of_coordinates(names, Wanted::Any)? };
    if let Some(places) = in_order {
        match order {
            Order::Matrix if !places.is_sorted() => {
                let problem = format!(
                    "the columns are named {}, in another order than the coordinates; write them in that order",
                    names.join(", ")
                );
                return Err(Problem::Shape(problem));
            }
            Order::Matrix => {}
            _ => return Ok(Vectors { places }),
        }
    }
    let is = |name: &str, other: &str| name.eq_ignore_ascii_case(other);
    // A column w beside u and v is a coordinate.
    let is_velocity = ["u", "v"].iter().all(|name| position(names, name).is_some());
    let is_left_out = |name: &str| is_label(name) && !(is(name, "w") && is_velocity);
    let places: Vec<usize> = (0..names.len()).filter(|&place| !is_left_out(&names[place])).collect();
    Ok(Vectors { places: if places.is_empty() { (0..names.len()).collect() } else { places } })
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
