//! The workbench on the command line.
fn main() {}
