//! `zonobench draw`: a reader's own data in the pictures of the paper.

mod moving;

use std::fmt;
use std::path::PathBuf;
use std::str::FromStr;

use anyhow::{Context, bail};
use clap::{Args, ValueEnum};
use figures::own_data;

use super::Ending;
use super::asking::PointOptions;
use super::collide::Step;
use super::placing::{Placing, PlacingOfSecond, in_words, rounded_in_words};
use super::usage::question_name;
use super::usage::{Usage, check_inputs, check_names, tell};
use crate::input::{Body, OptionNames, Points, RoundedBody, Wanted};
use crate::output::{Existing, Outputs};

/// Options of `draw`.
#[derive(Debug, Args)]
pub struct Options {
    /// The thing to draw.
    what: Picture,
    /// The data: a zonotope of space, or points of the plane; `-` is standard input.
    ///
    /// The tiling, the arrangement, the separators, a motion and a search with --point are those of a zonotope (csv,
    /// json, npy). The zonogon and a search without it are those of points.
    file: PathBuf,
    /// The second zonotope of a motion, which the first one may meet.
    other: Option<PathBuf>,
    #[command(flatten)]
    reading: PointOptions,
    #[command(flatten)]
    placing: Placing,
    #[command(flatten)]
    placing_of_b: PlacingOfSecond,
    #[command(flatten)]
    step: Step,
    /// Search for this point in the tiling of a zonotope (Theorem 5.2).
    ///
    /// Without it, the search is for the centre of the smallest zonogon around points (Theorem 4.5).
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true)]
    point: Option<SpacePoint>,
    /// Show the separator with so many crossings, or tiles, on its left.
    #[arg(long, value_name = "K")]
    separator: Option<usize>,
    /// Write the picture; `-` is standard output.
    #[arg(long, value_name = "FILE")]
    svg: PathBuf,
    /// Replace a file that exists.
    #[arg(long)]
    force: bool,
}

/// The things to draw.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Picture {
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
struct SpacePoint([f64; 3]);

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

/// Reads the data and draws them.
pub fn run(options: &Options) -> anyhow::Result<Ending> {
    check_usage(options)?;
    check_names(&[("SVG", Some(&options.svg))])?;
    let of_b = options.placing_of_b.placing();
    let of_b = options.other.as_deref().map(|other| of_b.inputs(other)).unwrap_or_default();
    let inputs = [options.placing.inputs(&options.file), of_b, options.step.inputs()].concat();
    check_inputs(&inputs)?;
    let outputs = Outputs::checked([&options.svg], &inputs, Existing::from_force(options.force))?;
    let name = question_name(&options.file);
    let (svg, more) = match options.what {
        Picture::Motion => moving::picture(options, &name)?,
        _ if shows_body(options) => of_body(options, &name)?,
        _ => (of_points(options, &name)?, String::new()),
    };
    outputs.write(&options.svg, svg.as_bytes())?;
    outputs.tell(&format!("{} of {name} in {}\n{more}", options.what, options.svg.display()))?;
    Ok(Ending::Good)
}

/// Whether the picture is one of generators of space.
fn shows_body(options: &Options) -> bool {
    match options.what {
        Picture::Tiling | Picture::Arrangement | Picture::Separators | Picture::Motion => true,
        Picture::Search => options.point.is_some(),
        Picture::Zonogon => false,
    }
}

/// Refuses options that say nothing about the picture.
fn check_usage(options: &Options) -> Result<(), Usage> {
    if options.point.is_some() && options.what != Picture::Search {
        return Err(Usage::not_applicable("--point", "only a search has a point"));
    }
    if options.separator.is_some() && !matches!(options.what, Picture::Tiling | Picture::Arrangement) {
        return Err(Usage::not_applicable("--separator", "only the tiling and the arrangement show one separator"));
    }
    check_motion(options)?;
    if shows_body(options) {
        if options.reading.columns.is_some() {
            return Err(Usage::not_applicable("--columns", "the rows of a zonotope are read whole"));
        }
        if options.reading.skip.is_some() {
            return Err(Usage::not_applicable("--skip", "no lines of a zonotope are left out"));
        }
        if options.reading.skip_nan {
            return Err(Usage::not_applicable("--skip-nan", "no generators of a zonotope are left out"));
        }
    } else if let Some(option) = options.placing.given() {
        return Err(Usage::not_applicable(option, "it is for a zonotope, and the picture is one of points"));
    }
    Ok(())
}

/// Refuses a motion without one, and what is about a motion, or about a second body, where there is none.
fn check_motion(options: &Options) -> Result<(), Usage> {
    if options.what == Picture::Motion {
        options.step.check()?;
        let of_b = options.placing_of_b.given().or(options.step.given_of_b());
        return match of_b.filter(|_| options.other.is_none()) {
            Some(option) => Err(Usage::not_applicable(option, "there is no second zonotope")),
            None => Ok(()),
        };
    }
    let second = options.other.as_ref().map(|_| "a second file").or(options.placing_of_b.given());
    match second.or(options.step.given()) {
        Some(option) => Err(Usage::not_applicable(option, "it is for `draw motion`")),
        None => Ok(()),
    }
}

/// The picture, and what is to be said of the body's pose.
fn of_body(options: &Options, name: &str) -> anyhow::Result<(String, String)> {
    let placed = options.placing.read(&options.file, options.reading.format, OptionNames::OF_FIRST)?.placed;
    let RoundedBody { body, off } = placed.rounded(&options.file)?;
    let mut more = placed.pose.as_ref().map(|pose| format!("pose: {}\n", in_words(pose))).unwrap_or_default();
    if off > 0.0 {
        more.push_str(&format!("{}\n", rounded_in_words(off)));
    }
    let Some((center, generators)) = in_space(&body) else {
        bail!("{}: has {} coordinates; lines and tiles are those of a zonotope with three", name, body.center.len());
    };
    let drawn = match (options.what, options.point) {
        (Picture::Arrangement, _) => own_data::arrangement(name, &generators, options.separator),
        (Picture::Separators, _) => own_data::separator_sweep(name, &generators),
        (_, Some(SpacePoint(point))) => {
            let from_center = std::array::from_fn(|c| point[c] - center[c]);
            own_data::search_for_point(name, &generators, from_center)
        }
        _ => own_data::tiling(name, &generators, options.separator),
    };
    Ok((drawn.with_context(|| name.to_owned())?, more))
}

/// The centre and the generators of a body of space.
fn in_space(body: &Body) -> Option<([f64; 3], Vec<[f64; 3]>)> {
    let space = |v: &Vec<f64>| <[f64; 3]>::try_from(v.as_slice()).ok();
    Some((space(&body.center)?, body.generators.iter().map(space).collect::<Option<_>>()?))
}

fn of_points(options: &Options, name: &str) -> anyhow::Result<String> {
    let reading = options.reading.source(&options.file)?.read(Wanted::Any)?;
    if let Some(remarks) = reading.remarks() {
        tell(&format!("{name}: {remarks}"));
    }
    let Points::Plane(points) = &reading.points else {
        reading.check_dimension(&options.file, 2)?;
        bail!("{name}: only points of the plane are drawn");
    };
    let drawn = match options.what {
        Picture::Zonogon => own_data::zonogon(name, points),
        _ => own_data::search_for_center(name, points),
    };
    drawn.with_context(|| name.to_owned())
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
