//! `verify`: right answers pass, every changed one is caught.

mod files;
mod requests;

use std::fs;
use std::path::Path;

use crate::run;
use serde_json::{Value, json};

/// Writes the files, verifies them, and gives status and output.
fn verify(folder: &Path, questions: &str, answers: &str) -> (i32, String) {
    fs::write(folder.join("q.jsonl"), questions).expect("written");
    fs::write(folder.join("a.jsonl"), answers).expect("written");
    let outcome = run(folder, &["verify", "q.jsonl", "a.jsonl"]);
    assert_eq!(outcome.stderr, "");
    (outcome.status, outcome.stdout)
}

fn solved(folder: &Path, questions: &str) -> Vec<Value> {
    fs::write(folder.join("q.jsonl"), questions).expect("written");
    let outcome = run(folder, &["solve", "q.jsonl"]);
    outcome.stdout.lines().map(|line| serde_json::from_str(line).expect("an answer is JSON")).collect()
}

fn questions() -> String {
    let clouds = [
        json!([[0, 0], [2, 0], [0, 2]]),
        json!([[1, 1]]),
        json!([[0, 0], [1, 3], [0.5, 1.5]]),
        json!([[0, 0], [0, 0]]),
        json!([[0, 0], [1, 0], [1, 1], [0, 1]]),
        json!([[0.1, 0.7], [5.3, -2.2], [3.3, 9.1], [-4.4, 1.5], [2.0, 2.0], [-1.9, -3.3], [6.1, 4.7]]),
        json!([[1e-300, 0], [0, 1e-300], [3e-300, 2e-300]]),
        json!([[1e300, 0], [0, 1e300], [3e300, 2e300]]),
    ];
    let lines = clouds.iter().enumerate().map(|(index, points)| {
        json!({"id": format!("cloud {index}"), "kind": "min_area", "input": {"points": points}}).to_string()
    });
    let input = json!({"direction": [1, -3], "center": [0.1, 0.2], "generators": [[1, 2], [3, 1], [0, -0.5]]});
    let support = json!({"id": "s", "kind": "support", "input": input});
    lines.chain([support.to_string()]).collect::<Vec<_>>().join("\n")
}

fn lines(answers: &[Value]) -> String {
    answers.iter().map(|answer| format!("{answer}\n")).collect()
}

#[test]
fn answers_of_the_program_are_right() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let questions = questions();
    let answers = solved(folder.path(), &questions);
    let (status, output) = verify(folder.path(), &questions, &lines(&answers));
    assert_eq!(status, 0, "{output}");
    assert_eq!(output.lines().filter(|line| line.contains("\tright\t")).count(), 9, "{output}");
}

#[test]
fn changed_answers_are_caught() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let questions = questions();
    let answers = solved(folder.path(), &questions);
    type Change = fn(&mut Value);
    let changes: [(usize, &str, Change); 8] = [
        (5, "area", |result| result["area"] = json!(result["area"].as_f64().expect("a number") * (1.0 + 1e-11))),
        (5, "bound", |result| {
            result["lower_bound"] = json!(result["area"].as_f64().expect("a number") * (1.0 + 1e-15))
        }),
        (5, "no bound", |result| result["lower_bound"] = json!(0)),
        (5, "centre", |result| result["center"][0] = json!(result["center"][0].as_f64().expect("a number") + 1e-9)),
        (5, "generator", |result| result["generators"][0] = json!([0, 0])),
        (5, "certificate", |result| result["certificate"]["hull"][1] = json!(4)),
        (5, "proof", |result| result["certificate"]["basis"] = json!([])),
        (8, "value", |result| result["value"] = json!(result["value"].as_f64().expect("a number") + 1e-9)),
    ];
    for (index, what, change) in changes {
        let mut changed = answers.clone();
        change(&mut changed[index]["result"]);
        let (status, output) = verify(folder.path(), &questions, &lines(&changed));
        let wrong: Vec<_> =
            output.lines().enumerate().filter(|(_, line)| line.contains("\tWRONG\t")).map(|(line, _)| line).collect();
        assert_eq!((status, wrong), (1, vec![index]), "{what}: {output}");
    }
}

#[test]
fn missing_extra_and_exchanged_answers_are_caught() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let questions = questions();
    let answers = solved(folder.path(), &questions);
    let (status, output) = verify(folder.path(), &questions, &lines(&answers[..8]));
    assert_eq!((status, output.matches("there is no answer").count()), (1, 1));
    let (status, _) = verify(folder.path(), &questions, &lines(&[&answers[..], &answers[..1]].concat()));
    assert_eq!(status, 1);
    let mut exchanged = answers.clone();
    exchanged.swap(0, 1);
    let (status, output) = verify(folder.path(), &questions, &lines(&exchanged));
    assert_eq!((status, output.matches("WRONG").count()), (1, 2));
    let (status, _) = verify(folder.path(), &questions, "not JSON\n");
    assert_eq!(status, 1);
}

#[test]
fn a_data_file_is_verified_against_the_answer_of_enclose() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("p.csv"), "id,b,a\n1,0.5,3\n2,4,1\n3,7,8\n4,2,2\n").expect("written");
    let outcome = run(folder.path(), &["enclose", "p.csv", "--columns", "a,b", "--json", "p.answer.json", "--exact"]);
    assert_eq!(outcome.status, 0, "{}", outcome.stderr);
    let command = outcome.stdout.lines().find_map(|line| line.strip_prefix("verify")).expect("the summary says how");
    let words: Vec<&str> = command.split_whitespace().skip(1).collect();
    let checked = run(folder.path(), &words);
    assert_eq!((checked.status, checked.stderr.as_str()), (0, ""), "{}", checked.stdout);
    assert!(checked.stdout.starts_with("p.csv\tmin_area\tright\t"), "{}", checked.stdout);
    let other = run(folder.path(), &["verify", "p.csv", "p.answer.json", "--columns", "b,a"]);
    assert_eq!(other.status, 1, "{}", other.stdout);
    assert!(other.stdout.starts_with("p.csv\t-\tunchecked\tthe options ask for something else"), "{}", other.stdout);
}

/// A claim that no check knows is neither right nor wrong.
#[test]
fn an_invented_claim_is_not_called_right() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    fs::write(folder.join("p.csv"), "x,y\n0,0\n2,0\n0,2\n").expect("written");
    for words in [&[][..], &["--exact"], &["--epsilon", "0.1"], &["--directions", "net:2"]] {
        let enclosed = [&["enclose", "p.csv", "--json", "a.json", "--force"], words].concat();
        assert_eq!(run(folder, &enclosed).status, 0);
        assert!(run(folder, &["verify", "p.csv", "a.json"]).stdout.contains("\tright\t"), "{words:?}");
        let text = fs::read_to_string(folder.join("a.json")).expect("written");
        for place in ["result", "request"] {
            let mut answer: Value = serde_json::from_str(&text).expect("an answer is JSON");
            answer[place]["gap"] = json!(0);
            fs::write(folder.join("a.json"), answer.to_string()).expect("written");
            let outcome = run(folder, &["verify", "p.csv", "a.json"]);
            let expected = format!("\tunchecked\tthe field `{place}, gap` is not checked; the rest: ");
            assert!(outcome.stdout.contains(&expected), "{words:?}: {}", outcome.stdout);
            assert_eq!(outcome.status, 0, "{words:?}");
        }
    }
}
