//! Files that hold a part of some work: one shard each, with a heading that names the work and the program.
//!
//! A shard is written under a temporary name, reaches the disk and is then renamed, so that one that is there is whole.

mod error;
mod heading;
mod place;
mod reading;

pub(super) use heading::Heading;
pub(super) use place::Place;
pub(super) use reading::{Part, read};
