//! `zonobench draw`: a reader's own data in the pictures of the paper.

mod moving;
mod options;

use anyhow::{Context, bail};
use figures::own_data;

pub use options::Options;
use options::{Picture, SpacePoint, in_space};

use super::Ending;
use super::placing::{in_words, rounded_in_words};
use super::usage::question_name;
use super::usage::{Usage, check_inputs, check_names, read_telling, tell};
use crate::input::{OptionNames, Points, RoundedBody, Wanted};
use crate::output::{Existing, Outputs};

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
    let told = format!("{} of {name} in {}\n{more}", options.what, options.svg.display());
    outputs.finish_one(&options.svg, svg.as_bytes(), &told)?;
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
    let (format, skip) = (options.reading.format, options.reading.told_skip());
    let placed = options.placing.read(&options.file, format, skip, OptionNames::OF_FIRST)?.placed;
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

fn of_points(options: &Options, name: &str) -> anyhow::Result<String> {
    let reading = read_telling(&options.reading.source(&options.file)?, Wanted::Any)?;
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
