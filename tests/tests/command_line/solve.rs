//! `solve` and `verify`: questions in, answers out, one line each.

use std::fs;

use serde_json::Value;

use crate::program::zonobench;

/// The answers to questions given on standard input.
fn solved(questions: &str) -> Vec<Value> {
    let assertion = zonobench().arg("solve").write_stdin(questions).assert().success();
    let output = String::from_utf8(assertion.get_output().stdout.clone()).expect("answers are text");
    output.lines().map(|line| serde_json::from_str(line).expect("an answer is JSON")).collect()
}

const SUPPORT: &str =
    r#"{"id":"s","kind":"support","input":{"direction":[1,2],"center":[10,0],"generators":[[1,0],[0,1],[-1,1]]}}"#;

#[test]
fn support_of_a_hexagon() {
    let answers = solved(&format!("{SUPPORT}\n"));
    assert_eq!(answers.len(), 1);
    assert_eq!(answers[0]["id"], "s");
    assert_eq!(answers[0]["kind"], "support");
    assert_eq!(answers[0]["result"]["value"].as_f64(), Some(10.0 + 1.0 + 2.0 + 1.0));
    let point: Vec<Option<f64>> =
        answers[0]["result"]["point"].as_array().expect("a point").iter().map(Value::as_f64).collect();
    assert_eq!(point, [Some(10.0), Some(2.0)]);
}

/// The refusals of the format, with the code that it promises.
const REFUSED: [(&str, &str); 12] = [
    ("not json", "bad_json"),
    (r#"{"id":"a","kind":"support""#, "bad_json"),
    (r#"{"id":"a","kind":"no_such_kind","input":{}}"#, "unknown_kind"),
    (
        r#"{"id":"a","kind":"support","method":"guess","input":{"direction":[1,0],"center":[0,0],"generators":[]}}"#,
        "unknown_method",
    ),
    (r#"{"id":"a","kind":"support","input":{"direction":[1,0],"center":[0,0]}}"#, "bad_input"),
    (
        r#"{"id":"a","kind":"support","input":{"direction":[1,0],"center":[0,0],"generators":[],"extra":1}}"#,
        "bad_input",
    ),
    (r#"{"id":"a","kind":"support","input":{"direction":[1,0],"center":"here","generators":[]}}"#, "bad_input"),
    (
        r#"{"id":"a","kind":"support","input":{"direction":[1,0],"center":[0,0,0],"generators":[]}}"#,
        "dimension_mismatch",
    ),
    (r#"{"id":"a","kind":"support","input":{"direction":["NaN",0],"center":[0,0],"generators":[]}}"#, "non_finite"),
    (
        r#"{"id":"a","kind":"support","input":{"direction":[1,0],"center":[0,0],"generators":[[1,"Infinity"]]}}"#,
        "non_finite",
    ),
    (r#"{"id":"a","kind":"min_area","input":{"points":[]}}"#, "empty"),
    (r#"{"id":"a","kind":"min_area","input":{"points":[[0,0],[1,"-Infinity"]]}}"#, "non_finite"),
];

#[test]
fn refusals_carry_the_promised_codes() {
    let questions: String = REFUSED.iter().map(|(question, _)| format!("{question}\n")).collect();
    let answers = solved(&questions);
    assert_eq!(answers.len(), REFUSED.len());
    for ((question, code), answer) in REFUSED.iter().zip(&answers) {
        assert_eq!(answer["error"]["code"], *code, "{question}: {answer}");
        assert!(answer.get("result").is_none(), "{answer}");
        let message = answer["error"]["message"].as_str().expect("a refusal has a message");
        assert!(!message.is_empty() && !message.contains('\n'), "{message}");
    }
}

#[test]
fn a_refusal_does_not_stop_the_batch_unless_it_is_strict() {
    let questions = format!("{SUPPORT}\nnot json\n{SUPPORT}\n");
    let answers = solved(&questions);
    assert_eq!(answers.len(), 3);
    assert_eq!(answers[1]["error"]["code"], "bad_json");
    assert_eq!(answers[1]["error"]["line"].as_u64(), Some(2));
    assert_eq!(answers[0], answers[2]);
    zonobench().args(["solve", "--strict"]).write_stdin(questions).assert().code(1);
    zonobench().args(["solve", "--strict"]).write_stdin(SUPPORT).assert().code(0);
}

/// The questions of the tests below: points with every degeneracy, in several notations of numbers.
const MIN_AREA: [(&str, &str); 7] = [
    ("triangle", "[[0,0],[6,0],[0,6]]"),
    ("square", "[[0,0],[1,0],[1,1],[0,1]]"),
    ("point", "[[3,4]]"),
    ("segment", "[[0,0],[2,1],[4,2],[2,1]]"),
    ("erratum", "[[0,6],[1,3],[6,1],[5,2]]"),
    ("tiny", "[[0,0],[5e-324,0],[0,5e-324]]"),
    ("tenths", "[[0.1,0.2],[0.3,0.7],[-0.9,0.4],[0.5,-0.6],[1e-3,1e2]]"),
];

fn min_area_questions() -> String {
    MIN_AREA
        .iter()
        .map(|(id, points)| format!("{{\"id\":\"{id}\",\"kind\":\"min_area\",\"input\":{{\"points\":{points}}}}}\n"))
        .collect()
}

#[test]
fn answers_pass_verification() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let (questions, answers) = (folder.path().join("questions.jsonl"), folder.path().join("answers.jsonl"));
    fs::write(&questions, min_area_questions() + SUPPORT + "\n").expect("the questions are written");
    let output = zonobench().arg("solve").arg(&questions).assert().success().get_output().stdout.clone();
    fs::write(&answers, &output).expect("the answers are written");
    let verdicts =
        zonobench().arg("verify").args([&questions, &answers]).assert().success().get_output().stdout.clone();
    let verdicts = String::from_utf8(verdicts).expect("verdicts are text");
    assert_eq!(verdicts.lines().count(), MIN_AREA.len() + 1);
    for line in verdicts.lines() {
        assert_eq!(line.split('\t').nth(2), Some("right"), "{line}");
    }
}

#[test]
fn wrong_answers_do_not_pass_verification() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let (questions, answers) = (folder.path().join("questions.jsonl"), folder.path().join("answers.jsonl"));
    fs::write(&questions, min_area_questions()).expect("the questions are written");
    let right = solved(&min_area_questions());
    let mut spoilt = 0;
    for (index, answer) in right.iter().enumerate() {
        let mut lines: Vec<Value> = right.clone();
        for field in ["area", "lower_bound", "center", "generators"] {
            let value = match (&answer["result"][field], field) {
                (_, "area" | "lower_bound") => {
                    Value::from(answer["result"][field].as_f64().unwrap_or(0.0) * 1.5 + 1e-3)
                }
                (_, "center") => serde_json::json!([1e6, 1e6]),
                (generators, _) if generators.as_array().is_some_and(|list| !list.is_empty()) => serde_json::json!([]),
                _ => continue,
            };
            lines[index] = answer.clone();
            lines[index]["result"][field] = value;
            let text: String = lines.iter().map(|line| format!("{line}\n")).collect();
            fs::write(&answers, text).expect("the answers are written");
            let assertion = zonobench().arg("verify").args([&questions, &answers]).assert().code(1);
            let verdicts = String::from_utf8_lossy(&assertion.get_output().stdout).into_owned();
            let wrong: Vec<usize> =
                (0..).zip(verdicts.lines()).filter(|(_, line)| line.contains("\tWRONG\t")).map(|(at, _)| at).collect();
            assert_eq!(wrong, [index], "{field} of {}: {verdicts}", MIN_AREA[index].0);
            spoilt += 1;
        }
    }
    assert!(spoilt >= 3 * MIN_AREA.len());
}
