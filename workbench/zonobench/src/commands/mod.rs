//! The commands, one file each.

mod asked;
mod asking;
pub mod collide;
pub mod compare;
pub mod contains;
pub mod distance;
pub mod draw;
pub mod enclose;
pub mod explore;
pub mod figure;
pub mod hausdorff;
pub mod inspect;
pub mod intersect;
pub mod list;
pub mod merge;
pub mod mesh;
mod mesh_files;
mod motion;
mod page;
mod placing;
pub mod records;
pub mod reduce;
pub mod reproduce;
mod shards;
pub mod shell;
pub mod solve;
pub mod sweep;
mod table;
mod usage;
pub mod verify;
mod view;

use std::fs::File;
use std::io::{self, BufRead, BufReader};
use std::path::Path;

use anyhow::Context;

pub use usage::Usage;
pub(crate) use usage::tell;

/// The ending of a command that ran to its end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ending {
    /// Everything is as it should be.
    Good,
    /// Something that was looked at is not as it should be; the output says what.
    Bad,
}

/// Opens a file for reading; standard input where `-` or nothing is given.
fn open(file: Option<&Path>) -> anyhow::Result<Box<dyn BufRead>> {
    match file.filter(|file| file.as_os_str() != "-") {
        None => Ok(Box::new(io::stdin().lock())),
        Some(file) => {
            let opened = File::open(file).with_context(|| format!("{}: cannot be read", file.display()))?;
            Ok(Box::new(BufReader::new(opened)))
        }
    }
}
