//! `zonobench explore`: the teaching page, one file that opens in a browser and needs nothing else.

use std::env;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use anyhow::{Context, bail};
use clap::Args;

use super::{Ending, Usage};
use crate::output::{Existing, Outputs, write_whole};
use crate::standard_output::StandardOutput;

/// The page as `workbench/explorer/build` makes it.
static PAGE: &[u8] = include_bytes!("../../../explorer/explorer.html");

/// The name of the page where none is given.
const NAME: &str = "zonotope-explorer.html";

/// Options of `explore`.
#[derive(Debug, Args)]
pub struct Options {
    /// Write the page; `-` is standard output.
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Open the page in the browser; without --out it is written to the folder for temporary files.
    #[arg(long)]
    open: bool,
    /// Replace a file that exists.
    #[arg(long)]
    force: bool,
}

/// Writes the page, and opens it.
pub fn run(options: &Options) -> anyhow::Result<Ending> {
    let page = match &options.out {
        None if options.open => {
            let page = env::temp_dir().join(NAME);
            write_whole(&page, PAGE, Existing::Replace)?;
            page
        }
        None => {
            return Err(Usage::not_applicable("explore", "give --out FILE to write the page, --open to open it").into());
        }
        Some(out) if options.open && out.as_os_str() == "-" => {
            return Err(
                Usage::not_applicable("--open", "standard output has no place that a browser could open").into()
            );
        }
        Some(out) => {
            let outputs = Outputs::checked([out], &[], Existing::from_force(options.force))?;
            let told = format!("{}: the page; it opens in any browser, without a network\n", out.display());
            outputs.finish_one(out, PAGE, &told)?;
            out.clone()
        }
    };
    if options.open {
        let page = page.canonicalize().with_context(|| format!("{}: cannot be found", page.display()))?;
        open(&page)
            .with_context(|| format!("{}: is written, but cannot be opened; open it by hand", page.display()))?;
        if options.out.is_none() {
            let told = format!("{}: the page, which opens in the browser\n", page.display());
            StandardOutput::print(told.as_bytes())?;
        }
    }
    Ok(Ending::Good)
}

/// Hands a page to the program that the system opens pages with, which need not end before this one does.
fn open(page: &Path) -> anyhow::Result<()> {
    let (program, words): (OsString, &[&str]) = if cfg!(target_os = "macos") {
        ("open".into(), &[])
    } else if cfg!(windows) {
        ("cmd".into(), &["/C", "start", ""])
    } else {
        (env::var_os("BROWSER").filter(|name| !name.is_empty()).unwrap_or_else(|| "xdg-open".into()), &[])
    };
    let silent = Stdio::null;
    let mut started =
        Command::new(&program).args(words).arg(page).stdin(silent()).stdout(silent()).stderr(silent()).spawn();
    match &mut started {
        Ok(child) => match child.try_wait()? {
            Some(status) if !status.success() => bail!("{} ended with {status}", program.display()),
            _ => Ok(()),
        },
        Err(error) => bail!("{}: {error}", program.display()),
    }
}
