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
        "hausdorff",
        "collide",
        "mesh",
        "sweep",
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
        "merge",
        "explore",
        "completions",
        "man",
    ];
    for command in commands {
        assert!(manual.contains(&format!("zonobench {command}")), "{command}");
    }
}

/// The most generators that brute force takes in each dimension, which the manual states, are those that questions with
/// more of them are refused by.
#[test]
fn limits_of_brute_force_are_stated() {
    let limit = |dimension: usize| -> String {
        let question = serde_json::json!({"id": "q", "kind": "gauge", "method": "brute_force", "input": {
            "p": vec![0; dimension], "q": vec![1; dimension], "generators": vec![vec![1; dimension]; 3000],
        }});
        let answer = batch::answer_line(1, &batch::Line::Content(question.to_string().into_bytes()), 0).content;
        let message = answer["error"]["message"].as_str().expect("so many generators are refused").to_owned();
        let limit = message.split("at most ").nth(1).and_then(|rest| rest.split(' ').next()).expect("it says the most");
        if limit == "2000" { "2,000".to_owned() } else { limit.to_owned() }
    };
    let limits: Vec<String> = (1..=6).map(limit).collect();
    let sentence = format!("at most {} and {} generators in one to six dimensions", limits[..5].join(", "), limits[5]);
    let manual = manual().replace('\n', " ");
    assert!(manual.contains(&sentence), "the manual lacks: {sentence}");
    let of_gauges = format!("a gauge in five and six dimensions takes at most {} and {}", limits[4], limits[5]);
    assert!(manual.contains(&of_gauges), "the manual lacks: {of_gauges}");
    let default = serde_json::json!({"id": "q", "kind": "gauge", "input": {
        "p": vec![0; 5], "q": vec![1; 5], "generators": vec![vec![1; 5]; 3000],
    }});
    let answer = batch::answer_line(1, &batch::Line::Content(default.to_string().into_bytes()), 0).content;
    assert!(
        answer["error"]["message"].as_str().is_some_and(|message| message.contains("by `brute_force`")),
        "{answer}"
    );
}
