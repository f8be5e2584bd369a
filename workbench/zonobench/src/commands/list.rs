//! `zonobench list`: what there is, by id.

use std::io::Write;

use clap::{Args, ValueEnum};

use super::Ending;
use crate::standard_output::StandardOutput;
use batch::KINDS;

/// Options of `list`.
#[derive(Debug, Args)]
pub struct Options {
    /// The list to print; all of them if absent.
    what: Option<What>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum What {
    /// Experiments, with the question that each one puts.
    Experiments,
    /// Figures.
    Figures,
    /// The paper's statements.
    Claims,
    /// The kinds of question that `solve` answers, with their methods, the default first.
    Methods,
}

/// Prints a line for each: id, then what it is.
pub fn run(options: &Options) -> anyhow::Result<Ending> {
    let mut output = StandardOutput::open()?;
    for &what in What::value_variants() {
        if options.what.is_some_and(|chosen| chosen != what) {
            continue;
        }
        if options.what.is_none() {
            let name = what.to_possible_value().expect("no variant is skipped");
            writeln!(output, "{}:", name.get_name())?;
        }
        for (id, text) in entries(what) {
            writeln!(output, "{id}\t{text}")?;
        }
        if options.what.is_none() {
            writeln!(output)?;
        }
    }
    output.finish()?;
    Ok(Ending::Good)
}

fn entries(what: What) -> Vec<(String, String)> {
    let entry = |id: &str, text: &str| (id.to_owned(), text.to_owned());
    match what {
        What::Experiments => {
            let all = experiments::catalog::EXPERIMENTS.iter();
            all.map(|experiment| entry(experiment.id, experiment.question)).collect()
        }
        What::Figures => figures::catalog::FIGURES.iter().map(|figure| entry(figure.id, figure.title)).collect(),
        What::Claims => paper_checks::catalog::CLAIMS.iter().map(|claim| entry(claim.id, claim.statement)).collect(),
        What::Methods => KINDS
            .iter()
            .map(|kind| entry(kind.name, &format!("{} ({})", kind.summary, (kind.methods)().join(", "))))
            .collect(),
    }
}
