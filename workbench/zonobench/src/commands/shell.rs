//! `zonobench completions` and `zonobench man`: what a shell and its manual know of the program.

use batch::did_you_mean;
use clap::{Args, Command};
use clap_complete::Shell;
use clap_mangen::Man;

use super::Ending;
use super::usage::Usage;
use crate::standard_output::StandardOutput;

/// Options of `completions`.
#[derive(Debug, Args)]
pub struct CompletionOptions {
    /// The shell.
    shell: Shell,
}

/// Options of `man`.
#[derive(Debug, Args)]
pub struct ManOptions {
    /// The command whose page is printed; that of the program if absent.
    command: Option<String>,
}

/// Prints the completions of the given command line for a shell.
pub fn completions(options: &CompletionOptions, mut program: Command) -> anyhow::Result<Ending> {
    let name = program.get_name().to_owned();
    let mut script = Vec::new();
    clap_complete::generate(options.shell, &mut program, name, &mut script);
    StandardOutput::print(&script)?;
    Ok(Ending::Good)
}

/// Prints a page of the manual, in the format of `man`.
pub fn man(options: &ManOptions, mut program: Command) -> anyhow::Result<Ending> {
    program.build();
    let page = match &options.command {
        None => program,
        Some(name) => {
            let found = program.find_subcommand(name).ok_or_else(|| {
                let near = did_you_mean(name, program.get_subcommands().map(Command::get_name));
                Usage::UnknownCommand { name: name.clone(), near }
            })?;
            found.clone()
        }
    };
    let mut text = Vec::new();
    Man::new(page).render(&mut text)?;
    StandardOutput::print(&text)?;
    Ok(Ending::Good)
}
