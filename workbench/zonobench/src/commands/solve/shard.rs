//! Batches in parts: the answers to a share of a file's questions, and those of all of them.
//!
//! A question is expected to cost as much as it is long.

use std::collections::BTreeMap;
use std::path::Path;

use anyhow::{Context, bail};
use batch::{Line, MAX_LINE_BYTES};
use experiments::sharing::Shard;
use serde::{Deserialize, Serialize};
use serde_json::json;

use crate::commands::shards::{Heading, Part, Place};
use crate::commands::usage::tell_losses;
use crate::commands::{Ending, Usage, open, tell};
use crate::digest::sha256_of_reader;
use crate::lines::Lines;
use crate::output::{Existing, Outputs};
use crate::progress::Progress;

/// The kind of shards that have answers.
pub(in crate::commands) const KIND: &str = "solve";

/// A line of a shard.
#[derive(Serialize, Deserialize)]
struct Answered {
    /// The number of the question's line in the file.
    line: u64,
    refused: bool,
    answer: String,
}

/// Answers the questions of a shard and writes its file, unless that is there; gives the number of refused questions.
pub(super) fn run(file: &Path, out: &Path, shard: Shard, seed: u64) -> anyhow::Result<u64> {
    if file.as_os_str() == "-" {
        let reason = "a shard reads its questions twice; give the name of a file";
        return Err(Usage::not_applicable("--shard", reason).into());
    }
    let unreadable = || format!("{}: cannot be read", file.display());
    let lengths: Vec<u64> = Lines::new(open(Some(file))?, MAX_LINE_BYTES)
        .map(|line| Ok(length(&line?.1)))
        .collect::<std::io::Result<_>>()
        .with_context(unreadable)?;
    let digest = sha256_of_reader(open(Some(file))?).with_context(unreadable)?;
    let place = Place::new(out, KIND, shard);
    let heading = Heading::new(KIND, shard, json!({"questions": digest, "lines": lengths.len(), "seed": seed}));
    if place.is_written(&heading)? {
        tell(&format!("{}: is there already", place.file().display()));
        return Ok(0);
    }
    let hand = shard.hand(&lengths);
    let progress = Progress::of(hand.iter().filter(|mine| **mine).count() as u64, "questions");
    let (mut answers, mut refused) = (Vec::new(), 0);
    for (line, _) in Lines::new(open(Some(file))?, MAX_LINE_BYTES).zip(hand).filter(|(_, mine)| *mine) {
        let (number, line) = line.with_context(unreadable)?;
        tell_losses(number, &line);
        let answer = batch::answer_line(number, &line, seed);
        refused += u64::from(answer.refused);
        let answer = Answered { line: number, refused: answer.refused, answer: answer.content.to_string() };
        answers.push(serde_json::to_string(&answer)?);
        progress.step();
    }
    place.write(&heading, &answers)?;
    Ok(refused)
}

fn length(line: &Line) -> u64 {
    match line {
        Line::Content(content) => content.len() as u64,
        Line::TooLong => 0,
    }
}

/// Writes the answers of all shards in the order of the questions, as one run writes them.
pub(in crate::commands) fn merge(parts: &[Part], out: Option<&Path>, force: bool) -> anyhow::Result<Ending> {
    let mut answers: BTreeMap<u64, String> = BTreeMap::new();
    for part in parts {
        for line in part.lines() {
            let Answered { line, answer, .. } =
                serde_json::from_str(line).with_context(|| format!("{}: a line is no answer", part.file.display()))?;
            answers.insert(line, answer);
        }
    }
    let expected = parts.first().and_then(|part| part.heading.work["lines"].as_u64());
    if expected != Some(answers.len() as u64) {
        bail!("the shards have {} answers, not {}", answers.len(), expected.unwrap_or_default());
    }
    let out = out.unwrap_or("-".as_ref()).to_path_buf();
    let outputs = Outputs::checked([&out], &[], Existing::from_force(force))?;
    let mut content = answers.into_values().collect::<Vec<_>>().join("\n");
    if !content.is_empty() {
        content.push('\n');
    }
    outputs.write(&out, content.as_bytes())?;
    Ok(Ending::Good)
}
