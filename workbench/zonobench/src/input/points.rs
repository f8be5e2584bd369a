//! Points of one dimension, as they come from a file.

use super::error::{Problem, TWO};

/// Points with up to this many coordinates are read.
pub const COORDINATE_LIMIT: usize = 4;

/// Points of the line, the plane, space or four dimensions.
#[derive(Debug, Clone, PartialEq)]
pub enum Points {
    /// With one coordinate.
    Line(Vec<[f64; 1]>),
    /// With two coordinates.
    Plane(Vec<[f64; 2]>),
    /// With three coordinates.
    Space(Vec<[f64; 3]>),
    /// With four coordinates.
    Four(Vec<[f64; 4]>),
}

impl Points {
    /// None yet, of the given dimension.
    pub(super) fn of_dimension(dimension: usize) -> Option<Self> {
        Some(match dimension {
            1 => Self::Line(Vec::new()),
            2 => Self::Plane(Vec::new()),
            3 => Self::Space(Vec::new()),
            4 => Self::Four(Vec::new()),
            _ => return None,
        })
    }

    /// Adds a point whose coordinates are as many as these points have.
    pub(super) fn push(&mut self, coordinates: &[f64]) -> Result<(), Problem> {
        fn add<const D: usize>(points: &mut Vec<[f64; D]>, coordinates: &[f64]) -> Result<(), Problem> {
            push_limited(points, coordinates.try_into().expect("rows of one table have one length"))
        }
        match self {
            Self::Line(points) => add(points, coordinates),
            Self::Plane(points) => add(points, coordinates),
            Self::Space(points) => add(points, coordinates),
            Self::Four(points) => add(points, coordinates),
        }
    }

    /// The number of coordinates of each.
    pub fn dimension(&self) -> usize {
        match self {
            Self::Line(_) => 1,
            Self::Plane(_) => 2,
            Self::Space(_) => 3,
            Self::Four(_) => 4,
        }
    }

    /// The number of them.
    pub fn len(&self) -> usize {
        self.rows().len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The points one by one.
    pub fn rows(&self) -> Box<dyn ExactSizeIterator<Item = &[f64]> + '_> {
        match self {
            Self::Line(points) => Box::new(points.iter().map(<[f64; 1]>::as_slice)),
            Self::Plane(points) => Box::new(points.iter().map(<[f64; 2]>::as_slice)),
            Self::Space(points) => Box::new(points.iter().map(<[f64; 3]>::as_slice)),
            Self::Four(points) => Box::new(points.iter().map(<[f64; 4]>::as_slice)),
        }
    }
}

/// The points that a file should hold.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wanted {
    /// Two coordinates: of a table with more, two columns are guessed by their names or must be chosen. Columns x, y
    /// and z are no points of the plane, unless two of them are chosen.
    Planar,
    /// Three coordinates if the columns are named x, y and z or if there are three without names, else two.
    PlaneOrSpace,
    /// One to four coordinates: as many as there are.
    Any,
}

impl Wanted {
    /// Whether a row of so many cells, without names or under names that say nothing, holds nothing but coordinates.
    pub(super) fn takes_all(self, cells: usize, are_named: bool) -> bool {
        match self {
            Self::Planar => cells == 2,
            Self::PlaneOrSpace => cells == 2 || (cells == 3 && !are_named),
            Self::Any => (1..=COORDINATE_LIMIT).contains(&cells),
        }
    }

    /// The number of columns that there should be, in words.
    pub(super) fn in_words(self) -> &'static str {
        match self {
            Self::Planar => TWO,
            Self::PlaneOrSpace | Self::Any => "two to four",
        }
    }
}

/// The largest number of points that a file may hold.
pub const MAX_POINTS: usize = 10_000_000;

/// Adds a point, or a generator, unless the limit is reached.
pub(in crate::input) fn push_limited<T>(points: &mut Vec<T>, point: T) -> Result<(), Problem> {
    if points.len() >= MAX_POINTS {
        return Err(Problem::TooMany { what: "points", limit: MAX_POINTS });
    }
    points.push(point);
    Ok(())
}
