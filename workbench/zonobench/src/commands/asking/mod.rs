//! What is asked of the points of a file: the objective of `enclose`, told `verify` in the same words.

use std::path::{Path, PathBuf};
use std::str::FromStr;

use anyhow::{Context, bail};
use clap::{Args, ValueEnum};
use serde_json::{Value, json};
use thiserror::Error;
use zonotope::enclosing::min_total_length::direction_net::cell_corners;

use crate::input::{Columns, Format, PointSource, Points};
use crate::json::{to_json, vector_to_json};

/// A command line that parses but makes no sense.
#[derive(Debug, Error)]
#[error("{0}")]
pub struct Usage(pub String);

/// How to read the points, and what zonotope around them is wanted.
#[derive(Debug, Clone, Args)]
pub struct Asking {
    /// The columns that hold the coordinates, two to four, by name or by number from 1.
    #[arg(long, value_name = "X,Y,…")]
    pub columns: Option<Columns>,
    /// The format, where the extension does not tell it.
    #[arg(long)]
    pub format: Option<Format>,
    /// What is to be least: the area (in the plane) or the total length of the generators. Without it, the area of points of
    /// the plane, the length where three or four columns, a mesh, directions or a precision are given.
    #[arg(long)]
    objective: Option<Objective>,
    /// Use these directions alone: a file with a direction a row, `axes`, or `net:K`, the corners of K cells along each side
    /// of the faces of a cube.
    #[arg(long, value_name = "FILE|axes|net:K", conflicts_with = "epsilon")]
    directions: Option<Directions>,
    /// How far the length may exceed the least one, relative to it: between 0 and 1, by default 0.001.
    #[arg(long, value_parser = precision)]
    epsilon: Option<f64>,
}

/// What is to be least.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Objective {
    /// The area, in the plane.
    Area,
    /// The total length: the sum of the half-lengths of the generators.
    Length,
}

/// Where directions come from.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Directions {
    Axes,
    Net(usize),
    File(PathBuf),
}

/// The precision where none is given.
const EPSILON: f64 = 1e-3;

/// Nets of more directions are not made.
const MOST_DIRECTIONS: usize = 1000;

impl FromStr for Directions {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text == "axes" {
            return Ok(Self::Axes);
        }
        let Some(cells) = text.strip_prefix("net:") else {
            return Ok(Self::File(PathBuf::from(text)));
        };
        match cells.parse() {
            Ok(cells) if (1..=MOST_DIRECTIONS).contains(&cells) => Ok(Self::Net(cells)),
            _ => Err(format!("a net has 1 to {MOST_DIRECTIONS} cells a side")),
        }
    }
}

fn precision(text: &str) -> Result<f64, String> {
    let number: f64 = text.parse().map_err(|_| format!("'{text}' is not a number"))?;
    if number > 0.0 && number < 1.0 { Ok(number) } else { Err("it must lie between 0 and 1".to_owned()) }
}

impl Asking {
    /// Where the points are.
    pub(super) fn source(&self, file: &Path) -> PointSource {
        PointSource { file: file.to_path_buf(), format: self.format, columns: self.columns.clone() }
    }

    /// What is to be least, if the options agree about it.
    pub(super) fn objective(&self, file: &Path) -> Result<Objective, Usage> {
        let is_mesh = self.source(file).known_format().is_some_and(Format::is_mesh);
        let reason = if self.directions.is_some() {
            Some("--directions ask for the least length")
        } else if self.epsilon.is_some() {
            Some("--epsilon asks for the least length")
        } else if is_mesh {
            Some("a mesh is not in the plane")
        } else if self.columns.as_ref().is_some_and(|columns| columns.0.len() != 2) {
            Some("the area is that of points with two coordinates")
        } else {
            None
        };
        match (self.objective, reason) {
            (Some(Objective::Area), Some(reason)) => Err(Usage(format!("--objective area: {reason}"))),
            (Some(objective), _) => Ok(objective),
            (None, Some(_)) => Ok(Objective::Length),
            (None, None) => Ok(Objective::Area),
        }
    }

    /// The question of least length about the points, in the format of `solve`.
    pub(super) fn question_of_length(&self, id: &str, points: &Points) -> anyhow::Result<Value> {
        let rows: Vec<Value> = points.rows().map(vector_to_json).collect();
        let Some(directions) = &self.directions else {
            let epsilon = self.epsilon.unwrap_or(EPSILON);
            return Ok(json!({"id": id, "kind": "min_length_all", "input": {"points": rows, "epsilon": epsilon}}));
        };
        let directions = match directions {
            Directions::File(file) => {
                let source = PointSource { file: file.clone(), format: None, columns: None };
                let directions = source.read_any().context("--directions")?;
                if directions.dimension() != points.dimension() {
                    bail!(
                        "{}: directions with {} coordinates for points with {}",
                        file.display(),
                        directions.dimension(),
                        points.dimension()
                    );
                }
                directions.rows().map(<[f64]>::to_vec).collect()
            }
            Directions::Axes => axes(points.dimension()),
            Directions::Net(cells) => net(*cells, points.dimension())?,
        };
        let weights: Vec<Value> = directions.iter().map(|direction| to_json(length(direction))).collect();
        let directions: Vec<Value> = directions.iter().map(|direction| vector_to_json(direction)).collect();
        let input = json!({"points": rows, "directions": directions, "weights": weights});
        Ok(json!({"id": id, "kind": "min_length_dirs", "input": input}))
    }

    /// The options as they are written on a command line.
    pub(super) fn words(&self) -> String {
        let mut words = String::new();
        if let Some(columns) = &self.columns {
            words.push_str(&format!(" --columns {columns}"));
        }
        if let Some(format) = self.format {
            words.push_str(&format!(" --format {format}"));
        }
        if let Some(objective) = self.objective.and_then(|objective| objective.to_possible_value()) {
            words.push_str(&format!(" --objective {}", objective.get_name()));
        }
        match &self.directions {
            None => {}
            Some(Directions::Axes) => words.push_str(" --directions axes"),
            Some(Directions::Net(cells)) => words.push_str(&format!(" --directions net:{cells}")),
            Some(Directions::File(file)) => words.push_str(&format!(" --directions {}", file.display())),
        }
        if let Some(epsilon) = self.epsilon {
            words.push_str(&format!(" --epsilon {epsilon:?}"));
        }
        words
    }
}

fn axes(dimension: usize) -> Vec<Vec<f64>> {
    let unit = |axis: usize| (0..dimension).map(|other| f64::from(u8::from(other == axis))).collect();
    (0..dimension).map(unit).collect()
}

fn net(cells: usize, dimension: usize) -> anyhow::Result<Vec<Vec<f64>>> {
    let faces = dimension.saturating_mul((cells + 1).saturating_pow(dimension as u32 - 1));
    if faces > 4 * MOST_DIRECTIONS {
        bail!("--directions net:{cells}: more than {MOST_DIRECTIONS} directions in {dimension} dimensions");
    }
    Ok(match dimension {
        1 => axes(1),
        2 => cell_corners::<2>(cells).iter().map(|v| v.to_vec()).collect(),
        3 => cell_corners::<3>(cells).iter().map(|v| v.to_vec()).collect(),
        _ => cell_corners::<4>(cells).iter().map(|v| v.to_vec()).collect(),
    })
}

/// The Euclidean length: what a unit of a direction costs if the total length is to be least.
fn length(v: &[f64]) -> f64 {
    let largest = v.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
    if largest == 0.0 {
        return 0.0;
    }
    largest * v.iter().map(|x| (x / largest) * (x / largest)).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_by_name() {
        assert_eq!("axes".parse(), Ok(Directions::Axes));
        assert_eq!("net:3".parse(), Ok(Directions::Net(3)));
        assert_eq!("a.csv".parse(), Ok(Directions::File("a.csv".into())));
        for wrong in ["net:", "net:0", "net:x", "net:1001"] {
            assert!(wrong.parse::<Directions>().is_err(), "{wrong}");
        }
    }

    #[test]
    fn nets_and_lengths() {
        assert_eq!([1, 2, 3].map(|cells| net(cells, 2).expect("small").len()), [2, 4, 6]);
        assert_eq!(net(1, 3).expect("small").len(), 4);
        assert!(net(100, 4).is_err());
        assert_eq!((length(&[3.0, 4.0]), length(&[0.0]), length(&[1e300, 0.0])), (5.0, 0.0, 1e300));
    }
}
