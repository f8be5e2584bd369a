//! An answer about the bodies of files, and perhaps about points: the question that it answers.

use std::path::{Path, PathBuf};

use anyhow::{Context, anyhow};
use batch::json::{self, MAX_VALUES, Tree};
use batch::read_pose;
use serde_json::Value;

use super::about::{AboutData, NO_RECORD, OTHER_DATA, cannot_be_asked};
use crate::commands::asked::{About, Recorded, zonotope_of};
use crate::commands::asking::{Asking, PointOptions};
use crate::commands::mesh::Read;
use crate::commands::usage::question_name;
use crate::commands::usage::{Usage, read_telling, tell};
use crate::input::{BodySource, Format, OptionNames, Reading, Wanted};

/// The note where two files are those of the answer, but in the other order.
const OTHER_ORDER: &str = "the files are those of the answer in the other order, and so it fails";

/// The question about the files that an answer is about.
pub(super) fn question(files: &[PathBuf], asking: &Asking, about: About, answer: &Tree) -> anyhow::Result<AboutData> {
    check_options(asking, about)?;
    let recorded = match Recorded::of(about, answer) {
        Some(Ok(recorded)) => Some(recorded),
        Some(Err(error)) => return Ok(AboutData::without_question(error.to_string())),
        None if about == About::Reduce => {
            let reason = "the answer does not record how many generators and which rule were asked for; `zonobench \
                          verify` checks it against its question";
            return Ok(AboutData::without_question(reason.to_owned()));
        }
        None if matches!(about, About::Collide | About::Sweep) => {
            let reason = "the answer does not record the motions of the bodies; `zonobench verify` checks it against \
                          its question";
            return Ok(AboutData::without_question(reason.to_owned()));
        }
        None => None,
    };
    let is_recorded = recorded.is_some();
    let recorded = recorded.unwrap_or_else(|| Recorded::nothing(about));
    let (question, hashes) = match ask_again(files, asking, about, &recorded) {
        Ok(found) => found,
        Err(error) => {
            let kept = recorded.files.iter().map(|file| file.sha256.as_deref());
            let files = files.iter().map(PathBuf::as_path).zip(kept);
            let reason = cannot_be_asked(files, "", &error);
            return Ok(AboutData::without_question(reason));
        }
    };
    let kept: Vec<&str> = recorded.files.iter().filter_map(|file| file.sha256.as_deref()).collect();
    let doubt = if !is_recorded {
        Some(NO_RECORD)
    } else if hashes == kept {
        None
    } else if hashes.iter().rev().eq(kept.iter()) {
        Some(OTHER_ORDER)
    } else {
        Some(OTHER_DATA)
    };
    Ok(AboutData { question: Ok(question), doubt, unknown: recorded.unknown })
}

/// Refuses options that say nothing about such files.
fn check_options(asking: &Asking, about: About) -> Result<(), Usage> {
    if let Some(option) = asking.goal() {
        return Err(Usage::not_applicable(option, "the answer is about bodies, not around points"));
    }
    let PointOptions { columns, skip, no_header, skip_nan, .. } = &asking.points;
    let given = [
        ("--columns", columns.is_some()),
        ("--skip", skip.is_some()),
        ("--no-header", *no_header),
        ("--skip-nan", *skip_nan),
    ];
    match given.into_iter().find(|(_, is_given)| *is_given && about != About::Contains) {
        Some((option, _)) => Err(Usage::not_applicable(option, "the answer is about bodies alone")),
        None => Ok(()),
    }
}

/// The question with the SHA-256 of every file.
fn ask_again(
    files: &[PathBuf],
    asking: &Asking,
    about: About,
    recorded: &Recorded,
) -> anyhow::Result<(Tree, Vec<String>)> {
    let mut bodies: Vec<Value> = Vec::new();
    let mut points: Option<Reading> = None;
    let mut hashes = Vec::new();
    for ((file, record), is_body) in files.iter().zip(&recorded.files).zip(about.are_bodies()) {
        if is_body {
            let chosen = asking.points.format.filter(|_| about != About::Contains);
            let (format, layout) = (chosen.or(record.points.format), record.layout);
            if about == About::Collide && format.is_some_and(Format::is_mesh) {
                let pose = record.pose.as_ref().map(|pose| read_pose(pose, 3)).transpose();
                let pose = pose.map_err(|refusal| anyhow!("{}", refusal.message))?;
                let read = Read::in_doubles(file, format, pose.as_ref())?;
                hashes.push(read.sha256);
                bodies.push(read.question);
                continue;
            }
            let (mut placed, origin) =
                BodySource { file: file.clone(), format, layout, options: OptionNames::OF_FIRST }.read(tell)?;
            if let Some(pose) = &record.pose {
                let read = read_pose(pose, placed.dimension()).map_err(|refusal| anyhow!("{}", refusal.message))?;
                placed.pose = Some(read);
            }
            hashes.push(origin.sha256);
            bodies.push(if about.takes_rounded() {
                zonotope_of(&placed.rounded(file)?.body)
            } else {
                placed.question()
            });
        } else {
            let reading = read_telling(&asking.points.or(&record.points).source(file)?, Wanted::Any)?;
            hashes.push(reading.sha256.clone());
            points = Some(reading);
        }
    }
    let names: Vec<String> = files.iter().map(|file| question_name(file)).collect();
    let reduction = recorded.reduction.as_ref().map(|(count, rule)| (*count, rule.as_str()));
    let mut question = about.question(&names.join(" and "), &bodies, points.as_ref(), reduction);
    for (name, value) in &recorded.step {
        question["input"][*name] = value.clone();
    }
    let read = json::read(question.to_string().as_bytes(), MAX_VALUES);
    Ok((read.with_context(|| display(files))?, hashes))
}

fn display(files: &[PathBuf]) -> String {
    files.iter().map(|file| Path::new(file).display().to_string()).collect::<Vec<_>>().join(" and ")
}
