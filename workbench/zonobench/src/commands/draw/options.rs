//! Options of `draw`, and what they are read as.

use std::fmt;
use std::path::PathBuf;
use std::str::FromStr;

use clap::{Args, ValueEnum};

use crate::commands::asking::PointOptions;
use crate::commands::collide::Step;
use crate::commands::placing::{Placing, PlacingOfSecond};
use crate::input::Body;

/// Options of `draw`.
#[derive(Debug, Args)]
pub struct Options {
    /// The thing to draw.
    pub(super) what: Picture,
    /// The data: a zonotope of space, or points of the plane; `-` is standard input.
    ///
    /// The tiling, the arrangement, the separators, a motion and a search with --point are those of a zonotope (csv,
    /// json, npy). The zonogon and a search without it are those of points.
    pub(super) file: PathBuf,
    /// The second zonotope of a motion, which the first one may meet.
    pub(super) other: Option<PathBuf>,
    #[command(flatten)]
    pub(super) reading: PointOptions,
    #[command(flatten)]
    pub(super) placing: Placing,
    #[command(flatten)]
    pub(super) placing_of_b: PlacingOfSecond,
    #[command(flatten)]
    pub(super) step: Step,
    /// Search for this point in the tiling of a zonotope (Theorem 5.2).
    ///
    /// Without it, the search is for the centre of the smallest zonogon around points (Theorem 4.5).
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true)]
    pub(super) point: Option<SpacePoint>,
    /// Show the separator with so many crossings, or tiles, on its left.
    #[arg(long, value_name = "K")]
    pub(super) separator: Option<usize>,
    /// Write the picture; `-` is standard output.
    #[arg(long, value_name = "FILE")]
    pub(super) svg: PathBuf,
    /// Replace a file that exists.
    #[arg(long)]
    pub(super) force: bool,
}

/// The things to draw.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Picture {
    /// The upper hull of a zonotope seen from above: a tile for every two generators.
    Tiling,
    /// The lines of the generators, dual to the tiling.
    Arrangement,
    /// Every separator of the tiling, a panel each.
    Separators,
    /// A search by separators, or by vertical lines, a panel a step.
    Search,
    /// The lines of a polygon with the area of its zonogons over their centres.
    Zonogon,
    /// A body in motion in the volume around all its placements, or two bodies with the proof that they do not meet.
    Motion,
}

/// Three finite coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct SpacePoint(pub(super) [f64; 3]);

impl FromStr for SpacePoint {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = |cell: &str| cell.trim().parse().ok().filter(|number: &f64| number.is_finite());
        let numbers: Option<Vec<f64>> = text.split(',').map(number).collect();
        let point = numbers.and_then(|numbers| <[f64; 3]>::try_from(numbers).ok());
        point.map(Self).ok_or_else(|| "a point of space is three finite numbers with commas between".to_owned())
    }
}

impl fmt::Display for Picture {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Tiling => "tiling",
            Self::Arrangement => "arrangement",
            Self::Separators => "separators",
            Self::Search => "search",
            Self::Zonogon => "zonogon",
            Self::Motion => "motion",
        })
    }
}

/// The centre and the generators of a body of space.
pub(super) fn in_space(body: &Body) -> Option<([f64; 3], Vec<[f64; 3]>)> {
    let space = |v: &Vec<f64>| <[f64; 3]>::try_from(v.as_slice()).ok();
    Some((space(&body.center)?, body.generators.iter().map(space).collect::<Option<_>>()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_three_numbers() {
        assert_eq!("1, -2.5,3e2".parse(), Ok(SpacePoint([1.0, -2.5, 300.0])));
        for wrong in ["", "1,2", "1,2,3,4", "1,2,x", "1,2,inf"] {
            assert!(wrong.parse::<SpacePoint>().is_err(), "{wrong}");
        }
    }
}
