//! The reading of the points of a file: the options that every command with points has.

use std::path::Path;

use clap::Args;

use crate::commands::usage::Usage;
use crate::input::{Columns, Format, PointSource};

/// The options for reading the points of a file.
#[derive(Debug, Clone, Default, PartialEq, Eq, Args)]
pub struct PointOptions {
    /// The columns that hold the coordinates, two to four, by name or by number from 1.
    #[arg(long, value_name = "X,Y,…")]
    pub columns: Option<Columns>,
    /// The format, where the extension does not tell it.
    #[arg(long)]
    pub format: Option<Format>,
    /// The number of lines of a table to leave out at its start.
    ///
    /// 1 leaves out a first line that holds other things than data.
    #[arg(long, value_name = "N")]
    pub skip: Option<u64>,
    /// The first line of a table, behind those that are left out, holds data where it might be taken for something
    /// else.
    #[arg(long)]
    pub no_header: bool,
    /// Leave out points of which a coordinate is missing, NaN or infinite, and say how many.
    #[arg(long)]
    pub skip_nan: bool,
}

impl PointOptions {
    /// The points of a file, unless an option does not apply to its format.
    pub(in crate::commands) fn source(&self, file: &Path) -> Result<PointSource, Usage> {
        let source = PointSource {
            file: file.to_path_buf(),
            format: self.format,
            columns: self.columns.clone(),
            skip: self.told_skip(),
            skip_nan: Some(self.skip_nan),
        };
        let Some(format) = source.known_format() else { return Ok(source) };
        if self.columns.is_some() && !format.has_columns() {
            return Err(Usage::not_applicable("--columns", "meshes have no columns to choose"));
        }
        if self.skip.is_some() && !format.is_table() {
            return Err(Usage::not_applicable("--skip", "only tables have lines that are left out"));
        }
        if self.no_header && !format.is_table() {
            return Err(Usage::not_applicable("--no-header", "only tables have a header"));
        }
        Ok(source)
    }

    /// The number of lines that are left out, where the caller said that the next one is data or how many they are.
    pub(in crate::commands) fn told_skip(&self) -> Option<u64> {
        self.skip.or(self.no_header.then_some(0))
    }

    /// These options, and for what they leave open those of `other`.
    pub(in crate::commands) fn or(&self, other: &Self) -> Self {
        Self {
            columns: self.columns.clone().or_else(|| other.columns.clone()),
            format: self.format.or(other.format),
            skip: self.told_skip().or(other.skip),
            no_header: self.no_header || other.no_header,
            skip_nan: self.skip_nan || other.skip_nan,
        }
    }
}
