//! The machines and the programs of two runs.

use experiments::environment::Environment;

use crate::commands::table::{Table, counted};

/// Adds a row for what both runs have in common, or one for each of them.
pub(super) fn add_to(table: &mut Table, [first, second]: [Option<&Environment>; 2]) {
    match (first, second) {
        (Some(first), Some(second)) if first.id() == second.id() => {
            table.row("machine", format!("of both runs {}", in_words(first)));
        }
        _ => {
            for (label, environment) in [("machine of 1", first), ("machine of 2", second)] {
                table.row(label, environment.map_or_else(|| "not recorded".to_owned(), in_words));
            }
        }
    }
}

fn in_words(environment: &Environment) -> String {
    let Environment { build, program, cpu, processors, host, .. } = environment;
    let host = if host.is_empty() { String::new() } else { format!("{host}, ") };
    format!("{host}{cpu}, {}; program {program}, {build}", counted(*processors, "processor", "processors"))
}
