//! The lines at the start of a table of vectors: the options of commands with bodies alone.

use std::path::Path;

use clap::Args;

use crate::commands::usage::Usage;
use crate::input::Format;

/// The lines at the start of a body's table.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Args)]
pub struct TableStart {
    /// The number of lines of a table to leave out at its start.
    ///
    /// Of two tables, unless --skip-b or --no-header-b is given for the second one.
    #[arg(long, value_name = "N")]
    skip: Option<u64>,
    /// The first line of a table, behind those that are left out, holds data.
    ///
    /// Otherwise it might be taken for a header or the sizes of the table; of two tables as --skip.
    #[arg(long)]
    no_header: bool,
}

impl TableStart {
    /// The number of lines that are left out, where the caller said that the next one is data or how many they are.
    pub(in crate::commands) fn told(self) -> Option<u64> {
        told(self.skip, self.no_header)
    }

    /// The name of an option that is given, if there is one.
    pub(in crate::commands) fn given(self) -> Option<&'static str> {
        self.skip.map(|_| "--skip").or(self.no_header.then_some("--no-header"))
    }
}

/// The number of lines that are left out, where one of the options is given.
pub(in crate::commands) fn told(skip: Option<u64>, no_header: bool) -> Option<u64> {
    skip.or(no_header.then_some(0))
}

/// Refuses lines of a file that is no table.
pub(super) fn check(skip: Option<u64>, format: Option<Format>, file: &Path, option: &'static str) -> Result<(), Usage> {
    let format = format.or_else(|| Format::of_extension(file));
    if skip.is_some() && format.is_some_and(|format| !format.is_table()) {
        return Err(Usage::not_applicable(option, "only tables have lines that are left out, or a header"));
    }
    Ok(())
}
