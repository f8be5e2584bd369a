//! `zonobench solve`: questions in, answers out, one line of JSON each, in order.

mod shard;

use std::io::{self, BufRead, Write};
use std::path::PathBuf;

use anyhow::Context;
use clap::Args;
use experiments::sharing::Shard;
use thiserror::Error;

pub(super) use self::shard::{KIND, merge};
use super::table::counted;
use super::usage::{tell, tell_losses};
use super::{Ending, open};
use crate::lines::Lines;
use crate::progress::Progress;
use crate::standard_output::StandardOutput;
use batch::MAX_LINE_BYTES;

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
    /// Answer the part I of N of the file's questions alone, from 0/N on; `merge` puts the parts together.
    ///
    /// The part is written into the folder of --out.
    #[arg(long, value_name = "I/N", requires_all = ["file", "out"])]
    shard: Option<Shard>,
    /// The folder of the shard.
    #[arg(long, value_name = "DIR", requires = "shard")]
    out: Option<PathBuf>,
}

/// Answers every question.
pub fn run(options: &Options) -> anyhow::Result<Ending> {
    if let (Some(shard), Some(file), Some(out)) = (options.shard, &options.file, &options.out) {
        let refused = shard::run(file, out, shard, options.seed)?;
        return Ok(ending(refused, options.strict));
    }
    let output = StandardOutput::open().context("the answers cannot be written")?;
    let name = options.file.as_ref().map_or("standard input".to_owned(), |file| file.display().to_string());
    let source = open(options.file.as_deref())?;
    let progress = Progress::counting("questions");
    let refused = answer_all(source, output, options.seed, || progress.step()).map_err(|error| match error {
        BatchError::Read(error) => anyhow::Error::new(error).context(format!("{name}: cannot be read")),
        BatchError::Write(error) => anyhow::Error::new(error).context("the answers cannot be written"),
    })?;
    Ok(ending(refused, options.strict))
}

fn ending(refused: u64, is_strict: bool) -> Ending {
    if !is_strict || refused == 0 {
        return Ending::Good;
    }
    let questions = counted(refused, "question was", "questions were");
    tell(&format!("--strict: {questions} refused; the answers with `error` say why"));
    Ending::Bad
}

/// Why a batch ended before its last line.
#[derive(Debug, Error)]
pub enum BatchError {
    /// The questions cannot be read.
    #[error("the questions cannot be read: {0}")]
    Read(io::Error),
    /// The answers cannot be written.
    #[error("the answers cannot be written: {0}")]
    Write(#[from] io::Error),
}

/// Answers the questions of a reader one by one, each before the next is read, and tells how many were refused. After
/// every answer it calls `answered`.
pub fn answer_all(
    questions: impl BufRead,
    mut answers: impl Write,
    seed: u64,
    mut answered: impl FnMut(),
) -> Result<u64, BatchError> {
    let mut refused = 0_u64;
    for line in Lines::new(questions, MAX_LINE_BYTES) {
        let (number, line) = line.map_err(BatchError::Read)?;
        tell_losses(number, &line);
        let answer = batch::answer_line(number, &line, seed);
        refused += u64::from(answer.refused);
        writeln!(answers, "{}", answer.content)?;
        answers.flush()?;
        answered();
    }
    Ok(refused)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_batch_is_answered_in_memory() {
        let question = r#"{"id":"a","kind":"min_area","input":{"points":[[0,0],[2,0],[0,2]]}}"#;
        let (mut answers, mut count) = (Vec::new(), 0);
        let refused = answer_all(format!("{question}\n\nnope\n").as_bytes(), &mut answers, 0, || count += 1);
        assert_eq!((refused.expect("memory can be read and written"), count), (1, 2));
        let answers = String::from_utf8(answers).expect("answers are text");
        assert_eq!(answers.lines().next(), Some(batch::answer(question).as_str()));
    }
}
