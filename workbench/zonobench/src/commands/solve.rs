//! `zonobench solve`: questions in, answers out, one line of JSON each, in order.

use std::io::{self, BufWriter, Write};
use std::path::PathBuf;

use anyhow::Context;
use clap::Args;

use super::{Ending, open};
use crate::batch::{self, MAX_LINE_BYTES};
use crate::json::Lines;
use crate::progress::Progress;

/// Options of `solve`.
#[derive(Debug, Args)]
pub struct Options {
    /// The questions; standard input if absent.
    file: Option<PathBuf>,
    /// End with status 1 if any question was refused.
    #[arg(long)]
    strict: bool,
    /// Seed of the methods that use random numbers; the answers' optima do not depend on it.
    #[arg(long, default_value_t = 0)]
    seed: u64,
}

/// Answers every question.
pub fn run(options: &Options) -> anyhow::Result<Ending> {
    let name = options.file.as_ref().map_or("standard input".to_owned(), |file| file.display().to_string());
    let source = open(options.file.as_deref())?;
    let mut output = BufWriter::new(io::stdout().lock());
    let progress = Progress::counting("questions");
    let mut refused = 0_u64;
    for line in Lines::new(source, MAX_LINE_BYTES) {
        let (number, line) = line.with_context(|| format!("{name}: cannot be read"))?;
        let answer = batch::answer(number, &line, options.seed);
        refused += u64::from(answer.refused);
        serde_json::to_writer(&mut output, &answer.content)?;
        output.write_all(b"\n")?;
        output.flush()?;
        progress.step();
    }
    Ok(if options.strict && refused > 0 { Ending::Bad } else { Ending::Good })
}
