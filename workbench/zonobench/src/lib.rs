//! The workbench on the command line: `reproduce`, `merge`, `figure`, `draw`, `records`, `compare`, `list`, `enclose`,
//! `contains`, `intersect`, `distance`, `hausdorff`, `collide`, `sweep`, `reduce`, `inspect`, `solve`, `verify`,
//! `explore`, `completions`, `man`.
//!
//! - [`cli`] is the command line, [`commands`] has a file for each command.
//! - [`input`] reads points and zonotopes from data files, [`lines`] the lines of a batch; [`output`] writes files
//!   whole or not at all, [`standard_output`] is the other place of results.
//! - [`report`] lays out what `reproduce` found.
//! - `digest` names files by their SHA-256.
//! - [`enclosure`] is the answer of least area, with its exact check.
//!
//! The crate [`batch`] answers questions that are lines of JSON and reads answers to be checked, which the crate
//! `verifier` does with exact arithmetic of its own.
//!
//! Results go to standard output, progress and complaints to standard error. The exit status is 0 for success, 1 for
//! a failure, 2 for a command line that makes no sense and 141 where the reader of standard output went away.

mod absent;
pub mod cli;
pub mod commands;
mod digest;
pub mod enclosure;
pub mod input;
pub mod lines;
pub mod output;
pub mod progress;
pub mod report;
pub mod standard_output;

use std::ffi::OsString;
use std::io;
use std::process::ExitCode;

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{CommandFactory, FromArgMatches};

use cli::{Cli, Command};
use commands::{Ending, Usage};
use standard_output::{check_standard_output, named};

/// The status of a program whose reader went away before the end, as shells tell it of one that SIGPIPE ended.
const READER_GONE: u8 = 141;

/// Runs the program with the given command line, its name included.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> ExitCode {
    let arguments: Vec<OsString> = arguments.into_iter().collect();
    let command = arguments.get(1).map(|word| word.to_string_lossy().into_owned()).unwrap_or_default();
    let parsed = with_negative_numbers(Cli::command()).try_get_matches_from(arguments);
    let cli = match parsed.and_then(|matches| Cli::from_arg_matches(&matches)) {
        Ok(cli) => cli,
        Err(message) => {
            let message = with_reason(without_vain_tip(nearest_first(message)), &command);
            if message.use_stderr() {
                // A reader that has gone away needs no message.
                let _ = message.print();
                return ExitCode::from(2);
            }
            let printed = check_standard_output().and_then(|()| message.print().map_err(named));
            return printed.map_or_else(|error| failure(&error.into()), |()| ExitCode::SUCCESS);
        }
    };
    match dispatch(&cli) {
        Ok(Ending::Good) => ExitCode::SUCCESS,
        Ok(Ending::Bad) => ExitCode::FAILURE,
        Err(error) => failure(&error),
    }
}

/// Tells why a command failed, unless its reader went away and needs no message; gives the status.
fn failure(error: &anyhow::Error) -> ExitCode {
    if is_broken_pipe(error) {
        return ExitCode::from(READER_GONE);
    }
    commands::tell(&told_once(error));
    if error.is::<Usage>() { ExitCode::from(2) } else { ExitCode::FAILURE }
}

fn dispatch(cli: &Cli) -> anyhow::Result<Ending> {
    match &cli.command {
        Command::Reproduce(options) => commands::reproduce::run(options),
        Command::Merge(options) => commands::merge::run(options),
        Command::Figure(options) => commands::figure::run(options),
        Command::Draw(options) => commands::draw::run(options),
        Command::Records(options) => commands::records::run(options),
        Command::Compare(options) => commands::compare::run(options),
        Command::List(options) => commands::list::run(options),
        Command::Enclose(options) => commands::enclose::run(options),
        Command::Intersect(options) => commands::intersect::run(options),
        Command::Contains(options) => commands::contains::run(options),
        Command::Distance(options) => commands::distance::run(options),
        Command::Hausdorff(options) => commands::hausdorff::run(options),
        Command::Collide(options) => commands::collide::run(options),
        Command::Mesh(options) => commands::mesh::run(options),
        Command::Sweep(options) => commands::sweep::run(options),
        Command::Reduce(options) => commands::reduce::run(options),
        Command::Inspect(options) => commands::inspect::run(options),
        Command::Solve(options) => commands::solve::run(options),
        Command::Verify(options) => commands::verify::run(options),
        Command::Explore(options) => commands::explore::run(options),
        Command::Completions(options) => commands::shell::completions(options, Cli::command()),
        Command::Man(options) => commands::shell::man(options, Cli::command()),
    }
}

/// The command line with options that take a negative number for a value and then refuse it, rather than for an option
/// that there is not.
fn with_negative_numbers(command: clap::Command) -> clap::Command {
    let subcommands: Vec<String> = command.get_subcommands().map(|one| one.get_name().to_owned()).collect();
    let command = command.mut_args(|argument| {
        let is_option = argument.get_long().is_some() && argument.get_action().takes_values();
        if is_option { argument.allow_negative_numbers(true) } else { argument }
    });
    subcommands.iter().fold(command, |command, name| command.mut_subcommand(name, with_negative_numbers))
}

/// A complaint about a value such as `-1,2`, taken for an option that there is not, with the way to write it.
fn without_vain_tip(mut message: clap::Error) -> clap::Error {
    let is_number =
        |word: &String| word.strip_prefix('-').is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_digit()));
    if matches!(message.get(ContextKind::InvalidArg), Some(ContextValue::String(word)) if is_number(word)) {
        let tip = "an equals sign stands before a value that begins with a minus, as in '--option=-1'";
        message.insert(ContextKind::Suggested, ContextValue::StyledStrs(vec![tip.to_owned().into()]));
    }
    message
}

/// A complaint about an option of reading that the command does not have, with the reason.
fn with_reason(mut message: clap::Error, command: &str) -> clap::Error {
    let reason = match message.get(ContextKind::InvalidArg) {
        Some(ContextValue::String(option)) if message.kind() == ErrorKind::UnknownArgument => {
            absent::reason(command, option.split('=').next().unwrap_or_default())
        }
        _ => None,
    };
    if let Some(reason) = reason {
        message.insert(ContextKind::Suggested, ContextValue::StyledStrs(vec![reason.to_owned().into()]));
        message.remove(ContextKind::SuggestedArg);
    }
    message
}

/// A complaint about a command that there is not, with the commands of similar names the most similar first.
fn nearest_first(mut message: clap::Error) -> clap::Error {
    if let Some(ContextValue::Strings(similar)) = message.get(ContextKind::SuggestedSubcommand) {
        let nearest_first = similar.iter().rev().cloned().collect();
        message.insert(ContextKind::SuggestedSubcommand, ContextValue::Strings(nearest_first));
    }
    message
}

/// An error with its causes, each told once: many errors tell their cause themselves.
fn told_once(error: &anyhow::Error) -> String {
    error.chain().map(ToString::to_string).fold(String::new(), |told, cause| {
        if told.contains(&cause) {
            told
        } else if cause.contains(&told) {
            cause
        } else {
            format!("{told}: {cause}")
        }
    })
}

/// Whether the reader of standard output went away, as `head` does.
fn is_broken_pipe(error: &anyhow::Error) -> bool {
    error.chain().any(|cause| {
        let direct = cause.downcast_ref::<io::Error>().map(io::Error::kind);
        let through_json = cause.downcast_ref::<serde_json::Error>().and_then(serde_json::Error::io_error_kind);
        direct.or(through_json) == Some(io::ErrorKind::BrokenPipe)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use anyhow::{Context, anyhow};

    #[test]
    fn causes_are_told_once() {
        let missing = || io::Error::new(io::ErrorKind::NotFound, "no such file");
        let file = "a.json".into();
        let repeating = anyhow::Error::new(output::OutputError::Unwritable { file, source: missing() });
        assert_eq!(format!("{repeating:#}").matches("no such file").count(), 2, "it tells its cause itself");
        assert_eq!(told_once(&repeating), "a.json: cannot be written: no such file");
        let silent = anyhow::Error::new(missing()).context("p.csv: cannot be read");
        assert_eq!(told_once(&silent), "p.csv: cannot be read: no such file");
        let named_twice = Err::<(), _>(anyhow!("p.csv: is empty")).context("p.csv").expect_err("an error");
        assert_eq!(told_once(&named_twice), "p.csv: is empty");
    }
}
