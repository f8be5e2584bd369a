//! The manual documents every kind of question with its fields, every code of a refusal, every command.

use batch::{Code, KINDS};
use tests::sources::root;

fn manual() -> String {
    std::fs::read_to_string(root().join("workbench/zonobench/MANUAL.md")).expect("the program has a manual")
}

#[test]
fn every_kind_has_its_row_with_its_fields() {
    let manual = manual();
    for kind in KINDS {
        let row = manual.lines().find(|line| line.starts_with(&format!("| `{}` |", kind.name)));
        let row = row.unwrap_or_else(|| panic!("the manual has no row for `{}`", kind.name));
        for field in kind.fields.iter().chain(kind.optional) {
            assert!(row.contains(&format!("`{field}`")), "the row of `{}` leaves out `{field}`", kind.name);
        }
    }
}

#[test]
fn every_row_of_a_kind_is_a_kind() {
    let manual = manual();
    let table = manual.split("| Kind | Input | Result |").nth(1).expect("there is a table of kinds");
    let rows = table.lines().skip(2).take_while(|line| line.starts_with("| "));
    let named: Vec<&str> = rows.filter_map(|row| row.split('`').nth(1)).collect();
    assert_eq!(named.len(), KINDS.len(), "{named:?}");
}

#[test]
fn every_code_is_explained() {
    let manual = manual();
    let table = manual.split("| Code | When |").nth(1).expect("there is a table of codes");
    for code in Code::ALL {
        assert!(table.contains(&format!("`{}`", code.name())), "the manual leaves out `{}`", code.name());
    }
}

#[test]
fn every_command_is_listed() {
    let manual = manual();
    let commands = [
        "enclose",
        "contains",
        "intersect",
        "distance",
        "collide",
        "reduce",
        "inspect",
        "solve",
        "verify",
        "list",
        "figure",
        "draw",
        "records",
        "compare",
        "reproduce",
        "explore",
        "completions",
        "man",
    ];
    for command in commands {
        assert!(manual.contains(&format!("zonobench {command}")), "{command}");
    }
}
