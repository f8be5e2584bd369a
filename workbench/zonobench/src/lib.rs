//! The workbench on the command line.

pub mod input;
pub mod json;
pub mod output;
pub mod verify;
