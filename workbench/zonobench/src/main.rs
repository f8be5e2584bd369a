//! The workbench on the command line.

use std::process::ExitCode;

fn main() -> ExitCode {
    zonobench::run(std::env::args_os())
}
