//! The program, built together with the tests: cargo hands its path only to the tests of the package that builds it.

use std::process::ExitCode;

fn main() -> ExitCode {
    zonobench::run(std::env::args_os())
}
