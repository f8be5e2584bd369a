//! Puts small faults into Rust files, each behind a switch: one build of the tests then tries thousands of them.
//!
//!     mutants SKIPPED LIST FILE...
//!
//! The files are rewritten in place. The fault with the number k is there while `crate::mutants::on(k)` is true. The
//! list gets a line for each of them: number, place, function and what is changed, with tabs between. Numbers that the
//! file SKIPPED names are left out, as those of faults that do not compile.

mod switches;
mod values;

use std::collections::BTreeSet;
use std::error::Error;
use std::{env, fs};

use syn::visit_mut::VisitMut;

use switches::Switches;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let [skipped, list, files @ ..] = &arguments[..] else {
        return Err("mutants SKIPPED LIST FILE...".into());
    };
    let numbers = fs::read_to_string(skipped).unwrap_or_default();
    let skipped = numbers.split_whitespace().map(str::parse).collect::<Result<BTreeSet<u32>, _>>()?;
    let mut switches = Switches::new(skipped);
    for path in files {
        let mut file = syn::parse_file(&fs::read_to_string(path)?)?;
        switches.begin(path);
        switches.visit_file_mut(&mut file);
        fs::write(path, prettyplease::unparse(&file))?;
    }
    Ok(fs::write(list, switches.into_lines())?)
}
