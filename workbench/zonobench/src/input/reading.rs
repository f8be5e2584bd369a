//! The content of a file: the points, and which part of the file they are.

use std::path::Path;

use super::Format;
use super::columns::Column;
use super::error::{InputError, Place, Problem, on_one_line};
use super::points::Points;

/// The points of a file, with the parts of the file that they come from and those that were left out.
#[derive(Debug, Clone, PartialEq)]
pub struct Reading {
    /// The points, in the order of the file.
    pub points: Points,
    /// The faces of a mesh, three points or more each, as far as the file has them; pictures alone show them.
    pub faces: Vec<Box<[usize]>>,
    /// The columns that hold the coordinates, in the order of the coordinates; chosen again, they give the same
    /// points. The list is empty for formats without columns, and for a JSON document that mixes lists and objects.
    pub columns: Vec<Column>,
    /// The columns, or other parts such as altitudes, that the points leave out.
    pub left_out: Vec<String>,
    /// The points that are left out as not finite, counted from 0 among all points of the file, in order.
    pub skipped: Vec<usize>,
    /// Other things to know about the reading, such as decimal commas.
    pub notes: Vec<String>,
    /// The numbers that were rounded though they are whole, or read as zero though they are not, in words.
    pub losses: Option<String>,
    /// The format of the file.
    pub format: Option<Format>,
    /// The SHA-256 of the file.
    pub sha256: String,
}

impl Reading {
    /// Points from the given columns, of a file that is yet to be named.
    pub(super) fn of(points: Points, (columns, left_out): (Vec<Column>, Vec<String>)) -> Self {
        let (faces, skipped, notes, losses) = (Vec::new(), Vec::new(), Vec::new(), None);
        Self { points, faces, columns, left_out, skipped, notes, losses, format: None, sha256: String::new() }
    }

    /// Points of a file that has no columns.
    pub(super) fn without_columns(points: Points, left_out: Vec<String>) -> Self {
        Self::of(points, (Vec::new(), left_out))
    }

    /// The numbers of the points in the file, from 1 on: those that are left out have one, too.
    pub fn numbers(&self) -> impl Iterator<Item = usize> {
        (0..).filter(|place| self.skipped.binary_search(place).is_err()).map(|place| place + 1).take(self.points.len())
    }

    /// Refuses points with another number of coordinates than is wanted.
    pub fn check_dimension(&self, file: &Path, wanted: usize) -> Result<(), InputError> {
        let found = self.points.dimension();
        if found == wanted {
            return Ok(());
        }
        let is_choice = !self.columns.is_empty() && !self.left_out.is_empty();
        let read = if is_choice { self.in_words() } else { None };
        let hint = read.map(|read| format!("; columns read: {read}; --columns chooses others")).unwrap_or_default();
        Err(Problem::Dimension { found, wanted, hint }.at(file, Place::File))
    }

    /// The columns in words, with what they leave out: "x, y; left out: id"; `None` where there is nothing to tell.
    pub fn in_words(&self) -> Option<String> {
        let used: Vec<String> = self.columns.iter().map(Column::to_string).collect();
        let used = (!used.is_empty()).then(|| on_one_line(&used.join(", ")));
        let parts: Vec<String> = used.into_iter().chain(self.remarks()).collect();
        (!parts.is_empty()).then(|| parts.join("; "))
    }

    /// Remarks on the reading beside its columns: what it leaves out, and what it took in a way that is
    /// not plain.
    pub fn remarks(&self) -> Option<String> {
        let left_out = (!self.left_out.is_empty()).then(|| format!("left out: {}", self.left_out.join(", ")));
        let parts: Vec<String> = left_out.into_iter().chain(self.notes.iter().cloned()).collect();
        (!parts.is_empty()).then(|| on_one_line(&parts.join("; ")))
    }
}

/// Points that are left out because a coordinate is missing or not finite, where that is asked for.
#[derive(Debug, Default)]
pub(super) struct Skipping {
    is_on: bool,
    places: Vec<usize>,
}

impl Skipping {
    /// None yet.
    pub(super) fn new(is_on: bool) -> Self {
        Self { is_on, places: Vec::new() }
    }

    /// Whether the point with this problem, before which so many were kept, is left out; its place is noted then.
    pub(super) fn passes_over(&mut self, problem: &Problem, kept: usize) -> bool {
        let is_left_out = self.is_on && problem.is_missing();
        if is_left_out {
            self.places.push(kept + self.places.len());
        }
        is_left_out
    }

    /// The number of points that were left out.
    pub(super) fn count(&self) -> usize {
        self.places.len()
    }

    /// The places of the points that were left out, among all of the file.
    pub(super) fn into_places(self) -> Vec<usize> {
        self.places
    }

    /// The points that were left out, in words.
    pub(super) fn in_words(&self) -> Option<String> {
        counted(self.count(), "point that is not finite", "points that are not finite")
    }
}

/// A number of things in words; `None` of none.
pub(super) fn counted(count: usize, one: &str, several: &str) -> Option<String> {
    match count {
        0 => None,
        1 => Some(format!("1 {one}")),
        count => Some(format!("{count} {several}")),
    }
}

/// The columns of a row, told by their names where a name is there and no other column has it, else by their numbers.
pub(super) fn columns_of(names: &[String], chosen: &[usize]) -> (Vec<Column>, Vec<String>) {
    let column = |index: usize| {
        let name = &names[index];
        let is_unique = names.iter().filter(|other| other.eq_ignore_ascii_case(name)).count() == 1;
        if name.is_empty() || !is_unique { Column::Number(index + 1) } else { Column::Name(name.clone()) }
    };
    let described = |index: usize| match column(index) {
        Column::Number(number) => format!("column {number}"),
        Column::Name(name) => name,
    };
    let left_out = (0..names.len()).filter(|index| !chosen.contains(index)).map(described).collect();
    (chosen.iter().map(|&index| column(index)).collect(), left_out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_told_by_name_where_the_name_is_theirs_alone() {
        let names = ["x", "", "X", "height"].map(str::to_owned);
        let (columns, left_out) = columns_of(&names, &[3, 0]);
        assert_eq!(columns, [Column::Name("height".into()), Column::Number(1)]);
        assert_eq!(left_out, ["column 2", "column 3"]);
        let points = Points::Plane(vec![[1.0, 2.0]]);
        let reading = Reading::of(points.clone(), (columns, left_out));
        assert_eq!(reading.in_words().as_deref(), Some("height, 1; left out: column 2, column 3"));
        let mut bare = Reading::without_columns(points, Vec::new());
        assert_eq!(bare.in_words(), None);
        bare.notes.push("decimal commas".to_owned());
        assert_eq!(bare.in_words().as_deref(), Some("decimal commas"));
    }
}
