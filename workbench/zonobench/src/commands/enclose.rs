//! `zonobench enclose`: the zonogon of least area around the points of a file.

mod drawing;
mod summary;

use std::io::{self, Write};
use std::path::PathBuf;

use anyhow::anyhow;
use clap::Args;
use serde_json::json;
use zonotope::lad::Method;

use super::Ending;
use super::verify::question_name;
use crate::enclosure::{Enclosure, exact_to_json};
use crate::input::{Columns, Format, PointSource};
use crate::output::{Existing, check_free, write_whole};
use crate::progress::Progress;

/// Options of `enclose`.
#[derive(Debug, Args)]
pub struct Options {
    /// The points: CSV, GeoJSON or JSON, told from the extension; `-` is standard input.
    file: PathBuf,
    /// The two columns that hold the coordinates, by name or by number from 1.
    #[arg(long, value_name = "X,Y")]
    columns: Option<Columns>,
    /// The format, where the extension does not tell it.
    #[arg(long)]
    format: Option<Format>,
    /// Write a picture of the points, their hull and the zonogon.
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,
    /// Write the answer with its certificate, in the format of `solve`.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Also give the optimum in exact rational numbers.
    #[arg(long)]
    exact: bool,
    /// Seed of the method's random numbers: it decides the time, never the area.
    #[arg(long, default_value_t = 0)]
    seed: u64,
    /// Replace files that exist.
    #[arg(long)]
    force: bool,
}

/// Reads, solves, checks, and prints a summary.
pub fn run(options: &Options) -> anyhow::Result<Ending> {
    let existing = Existing::from_force(options.force);
    for file in options.svg.iter().chain(&options.json) {
        check_free(file, existing)?;
    }
    let source = PointSource { file: options.file.clone(), format: options.format, columns: options.columns.clone() };
    let progress = Progress::of(3, "reading");
    let points = source.read()?;
    progress.next("solving");
    let enclosure = Enclosure::of(&points, Method::default(), options.seed)
        .map_err(|error| anyhow!("{}: {error}", options.file.display()))?;
    progress.next("checking");
    let proof = enclosure.check(&points);
    drop(progress);

    let exact = options.exact.then(|| enclosure.exact());
    if let Some(file) = &options.svg {
        let svg = drawing::draw(&options.file, &points, &enclosure);
        write_whole(file, svg.as_bytes(), existing)?;
    }
    if let Some(file) = &options.json {
        let mut result = enclosure.result();
        if let Some(exact) = &exact {
            result["exact"] = exact_to_json(exact);
        }
        let answer = json!({
            "id": question_name(&options.file),
            "kind": "min_area",
            "method": enclosure.method.name(),
            "result": result,
        });
        write_whole(file, format!("{answer}\n").as_bytes(), existing)?;
    }
    let text = summary::summary(options, &points, &enclosure, proof.as_ref(), exact.as_ref());
    io::stdout().lock().write_all(text.as_bytes())?;
    Ok(if proof.is_ok() { Ending::Good } else { Ending::Bad })
}
