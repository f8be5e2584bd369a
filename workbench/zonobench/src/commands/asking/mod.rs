//! The question about the points of a file: the objective of `enclose`, which `verify` reads from the answer's
//! `request`.

mod directions;
mod points;
mod request;

use std::path::Path;

use clap::{Args, ValueEnum};
use serde_json::{Value, json};

use self::directions::{Directions, length};
pub use self::points::PointOptions;
pub(super) use self::request::Recorded;
pub(crate) use self::request::{POINT_FIELDS, RecordError, field, record_points, recorded_points, truth};
use super::usage::{Usage, read_telling, tell};
use crate::input::{Format, Points, Reading, Wanted};
use batch::json::{self, Tree, to_json, vector_to_json};

/// The options for reading the points, and for the zonotope around them.
#[derive(Debug, Clone, Default, PartialEq, Args)]
pub struct Asking {
    /// The options for reading the points.
    #[command(flatten)]
    pub points: PointOptions,
    /// The objective: the area (in the plane), the total length of the generators, or the volume (in space).
    ///
    /// Of the volume a local minimum is found. Without this option it is the area of points of the plane, and the
    /// length of points of space (a mesh, or three columns) and where three or four columns are chosen, or directions,
    /// a precision or a number of generators are given.
    #[arg(long)]
    objective: Option<Objective>,
    /// Use these directions alone: the rows of a file, the coordinate axes, or a net of K cells a side.
    ///
    /// The directions of a net are the corners of K cells along each side of the faces of a cube.
    #[arg(long, value_name = "FILE|axes|net:K", conflicts_with = "epsilon")]
    directions: Option<Directions>,
    /// The part by which the length may exceed the least one, relative to it: between 0 and 1 [default: 0.001].
    #[arg(long, value_parser = precision)]
    epsilon: Option<f64>,
    /// Use so many generators at most, and as short ones as are found.
    ///
    /// There are at least as many as the points span dimensions. Without this option few generators within epsilon of
    /// the least length are used.
    #[arg(long, value_name = "K", conflicts_with = "directions", value_parser = clap::value_parser!(u64).range(1..))]
    max_generators: Option<u64>,
}

/// The objective.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Objective {
    /// The area, in the plane.
    Area,
    /// The total length: the sum of the half-lengths of the generators.
    Length,
    /// The volume, in space: a local minimum, found from the zonotope of small length that the other options ask for.
    Volume,
}

/// The precision where none is given.
const EPSILON: f64 = 1e-3;

fn precision(text: &str) -> Result<f64, String> {
    let number: f64 = text.parse().map_err(|_| format!("'{text}' is not a number"))?;
    if number > 0.0 && number < 1.0 { Ok(number) } else { Err("it must lie between 0 and 1".to_owned()) }
}

impl Asking {
    /// The files that are read: the points, and perhaps directions.
    pub(super) fn inputs<'a>(&'a self, file: &'a Path) -> Vec<&'a Path> {
        let directions = self.directions.as_ref().and_then(Directions::file);
        [Some(file), directions].into_iter().flatten().collect()
    }

    /// Whether no option is given.
    pub(super) fn is_empty(&self) -> bool {
        let Self { points, objective, directions, epsilon, max_generators } = self;
        let is_open = objective.is_none() && directions.is_none() && epsilon.is_none() && max_generators.is_none();
        is_open && *points == PointOptions::default()
    }

    /// The first option that asks for something around the points, if there is one.
    pub(super) fn goal(&self) -> Option<&'static str> {
        let Self { points: _, objective, directions, epsilon, max_generators } = self;
        let given = [
            ("--objective", objective.is_some()),
            ("--directions", directions.is_some()),
            ("--epsilon", epsilon.is_some()),
            ("--max-generators", max_generators.is_some()),
        ];
        given.into_iter().find_map(|(option, is_given)| is_given.then_some(option))
    }

    /// These options, and for what they leave open those of `other`. A precision takes the place of directions, and
    /// directions that of a precision.
    pub(super) fn or(&self, other: &Self) -> Self {
        let is_told = self.directions.is_some() || self.epsilon.is_some() || self.max_generators.is_some();
        let goal = if is_told { self } else { other };
        Self {
            points: self.points.or(&other.points),
            objective: self.objective.or(other.objective),
            directions: goal.directions.clone(),
            epsilon: goal.epsilon,
            max_generators: goal.max_generators,
        }
    }

    /// The objective, if the options say it and agree about it.
    pub(super) fn stated_objective(&self, file: &Path) -> Result<Option<Objective>, Usage> {
        // An OFF file may be one of the plane, which its content tells.
        let may_be_planar = |format| format == Format::Off && self.objective == Some(Objective::Area);
        let format = self.points.source(file)?.known_format();
        let is_mesh = format.is_some_and(|format| format.is_mesh() && !may_be_planar(format));
        let reason = if self.directions.is_some() {
            Some("--directions ask for the least length")
        } else if self.epsilon.is_some() {
            Some("--epsilon asks for the least length")
        } else if self.max_generators.is_some() {
            Some("--max-generators asks for the least length")
        } else if is_mesh {
            Some("a mesh is not in the plane")
        } else if self.points.columns.as_ref().is_some_and(|columns| columns.0.len() != 2) {
            Some("the area is that of points with two coordinates")
        } else {
            None
        };
        match (self.objective, reason) {
            (Some(Objective::Area), Some(reason)) => Err(Usage::not_applicable("--objective area", reason)),
            (Some(Objective::Volume), Some(reason)) if self.directions.is_some() => {
                Err(Usage::not_applicable("--objective volume", reason))
            }
            (Some(objective), _) => Ok(Some(objective)),
            (None, Some(_)) => Ok(Some(Objective::Length)),
            (None, None) => Ok(None),
        }
    }

    /// The points, and what is to be least around them: where the options leave it open, the area of points of the
    /// plane and the length of points of space.
    pub(super) fn read(&self, file: &Path) -> anyhow::Result<(Reading, Objective)> {
        let stated = self.stated_objective(file)?;
        // Only a stated objective says how many coordinates there are, whatever else is asked for.
        let wanted = match self.objective {
            Some(Objective::Area) => Wanted::Planar,
            Some(Objective::Length | Objective::Volume) => Wanted::Any,
            None => Wanted::PlaneOrSpace,
        };
        let reading = read_telling(&self.points.source(file)?, wanted)?;
        let told = if reading.points.dimension() == 2 { Objective::Area } else { Objective::Length };
        Ok((reading, stated.unwrap_or(told)))
    }

    /// The question about the points of a file, in the format of `solve`.
    pub(super) fn question(&self, id: &str, file: &Path) -> anyhow::Result<(Tree, Reading)> {
        let (reading, objective) = self.read(file)?;
        let question = match objective {
            Objective::Length | Objective::Volume => {
                let question = self.question_of_length(id, &reading.points, objective)?;
                json::read(question.to_string().as_bytes(), usize::MAX)?
            }
            Objective::Area => {
                let point = |row: &[f64]| Tree::List(row.iter().map(|&x| Tree::Number(x)).collect());
                let points = Tree::List(reading.points.rows().map(point).collect());
                let text = |text: &str| Tree::Text(text.to_owned());
                Tree::Object(vec![
                    ("id".to_owned(), text(id)),
                    ("kind".to_owned(), text("min_area")),
                    ("input".to_owned(), Tree::Object(vec![("points".to_owned(), points)])),
                ])
            }
        };
        Ok((question, reading))
    }

    /// The question of least length or volume about the points, in the format of `solve`.
    pub(super) fn question_of_length(&self, id: &str, points: &Points, objective: Objective) -> anyhow::Result<Value> {
        let rows: Vec<Value> = points.rows().map(vector_to_json).collect();
        let Some(directions) = &self.directions else {
            let epsilon = self.epsilon.unwrap_or(EPSILON);
            let mut input = json!({"points": rows, "epsilon": epsilon});
            if let Some(most) = self.max_generators {
                input["max_generators"] = most.into();
            }
            if objective == Objective::Volume {
                input["objective"] = "volume".into();
            }
            return Ok(json!({"id": id, "kind": "min_length_all", "input": input}));
        };
        let (directions, remarks) = directions.read(points.dimension())?;
        remarks.iter().for_each(|remarks| tell(remarks));
        let weights: Vec<Value> = directions.iter().map(|direction| to_json(length(direction))).collect();
        let directions: Vec<Value> = directions.iter().map(|direction| vector_to_json(direction)).collect();
        let input = json!({"points": rows, "directions": directions, "weights": weights});
        Ok(json!({"id": id, "kind": "min_length_dirs", "input": input}))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_take_the_place_of_recorded_ones() {
        let along_axes = Asking { directions: Some(Directions::Axes), ..Asking::default() };
        let points = PointOptions { format: Some(Format::Csv), ..PointOptions::default() };
        let precise = Asking { epsilon: Some(0.5), points, ..Asking::default() };
        let both = precise.or(&along_axes);
        assert_eq!((both.directions, both.epsilon, both.points.format), (None, Some(0.5), Some(Format::Csv)));
        let both = Asking::default().or(&along_axes);
        assert_eq!((both.directions, both.epsilon), (Some(Directions::Axes), None));
        assert!(Asking::default().is_empty() && !precise.is_empty());
    }

    #[test]
    fn the_options_decide_before_the_data_do() {
        let file = Path::new("p.csv");
        let stated = |asking: &Asking| asking.stated_objective(file).map_err(|error| error.to_string());
        assert_eq!(stated(&Asking::default()), Ok(None));
        let along_axes = Asking { directions: Some(Directions::Axes), ..Asking::default() };
        assert_eq!(stated(&along_axes), Ok(Some(Objective::Length)));
        let both = Asking { objective: Some(Objective::Area), ..along_axes };
        assert_eq!(stated(&both), Err("--objective area: --directions ask for the least length".to_owned()));
    }
}
