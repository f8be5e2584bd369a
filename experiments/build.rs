//! Hands the compiler's version and flags to the environment record.

use std::env::var;
use std::process::Command;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-env-changed=CARGO_ENCODED_RUSTFLAGS");
    let toolchain = var("RUSTC")
        .ok()
        .and_then(|rustc| Command::new(rustc).arg("--version").output().ok())
        .map_or_else(|| "unknown".to_owned(), |output| String::from_utf8_lossy(&output.stdout).trim().to_owned());
    let value = |name: &str| var(name).unwrap_or_else(|_| "unknown".to_owned());
    let flags = value("CARGO_ENCODED_RUSTFLAGS").replace('\u{1f}', " ");
    println!("cargo::rustc-env=EXPERIMENTS_TOOLCHAIN={toolchain}");
    println!(
        "cargo::rustc-env=EXPERIMENTS_BUILD={}, opt-level {}, flags [{flags}]",
        value("TARGET"),
        value("OPT_LEVEL"),
    );
}
