//! Answers about bodies record what was asked, so that `verify` needs their files alone; two answers are no question.

use std::fs;
use std::path::Path;

use crate::{run, run_with_input};
use serde_json::{Value, json};

const A: &str = r#"{"center":[0,0],"generators":[[1,0],[0.3,1]]}"#;
const B: &str = r#"{"c":[5,1],"G":[[1,0.25],[0,2]]}"#;
const POINTS: &str = "id,x,y\n1,0,0\n2,1,0.5\n3,9,9\n";

const S: &str = "[[1,0,0],[0,1,0],[0,0,1]]";
const T: &str = r#"{"center":[4,0,0],"generators":[[1,0,0],[0,1,0],[0,0,1]]}"#;
const TURN: &str = r#"{"motion":{"axis_point":[0,0,0],"axis":[0,0,1],"angle":3,"translation":[2,0,0]}}"#;

/// Bodies and points under names that tell their format, and under one that does not.
fn files(folder: &Path) {
    for (name, content) in [("a.json", A), ("b.json", B), ("b.body", B), ("g.csv", "1,0\n0.3,1\n"), ("p.csv", POINTS)] {
        fs::write(folder.join(name), content).expect("written");
    }
    for (name, content) in [("s.json", S), ("t.json", T), ("m.json", TURN)] {
        fs::write(folder.join(name), content).expect("written");
    }
}

/// Status and cells of the line that `verify` prints.
fn verified(folder: &Path, words: &[&str]) -> (i32, Vec<String>) {
    let outcome = run(folder, &[&["verify"], words].concat());
    assert_eq!((outcome.stderr.as_str(), outcome.stdout.lines().count()), ("", 1), "{words:?}: {}", outcome.stdout);
    (outcome.status, outcome.stdout.trim_end().split('\t').map(str::to_owned).collect())
}

fn change(folder: &Path, change: impl FnOnce(&mut Value)) {
    let file = folder.join("answer.json");
    let mut answer = serde_json::from_str(&fs::read_to_string(&file).expect("an answer")).expect("JSON");
    change(&mut answer);
    fs::write(&file, answer.to_string()).expect("written");
}

/// The commands about bodies, each with the files that it is given.
const COMMANDS: [(&[&str], &[&str]); 13] = [
    (&["intersect", "a.json", "b.json"], &["a.json", "b.json"]),
    (&["distance", "g.csv", "b.json"], &["g.csv", "b.json"]),
    (&["distance", "a.json", "b.body", "--format", "json"], &["a.json", "b.body"]),
    (&["hausdorff", "a.json", "b.json"], &["a.json", "b.json"]),
    (&["hausdorff", "g.csv", "b.body", "--format-b", "json", "--turn", "z,30"], &["g.csv", "b.body"]),
    (&["collide", "s.json", "t.json", "--translation", "-9,0,0"], &["s.json", "t.json"]),
    (&["collide", "t.json", "s.json", "--motion-b", "m.json", "--resolution", "0.125"], &["t.json", "s.json"]),
    (&["sweep", "t.json", "--axis", "0,0,1", "--angle", "-1", "--turn", "z,30"], &["t.json"]),
    (&["sweep", "s.json", "--motion", "m.json", "--method", "by_turned_generators"], &["s.json"]),
    (&["contains", "a.json", "p.csv"], &["a.json", "p.csv"]),
    (&["contains", "b.body", "p.csv", "--body-format", "json", "--columns", "y,x"], &["b.body", "p.csv"]),
    (&["reduce", "a.json", "--count", "2", "--rule", "girard"], &["a.json"]),
    (&["inspect", "b.json"], &["b.json"]),
];

#[test]
fn answers_about_bodies_are_verified_against_their_files_without_any_option() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    files(folder);
    for (command, given) in COMMANDS {
        let outcome = run(folder, &[command, &["--json", "answer.json", "--force"]].concat());
        assert_eq!(outcome.status, 0, "{command:?}: {}", outcome.stderr);
        let words = [given, &["answer.json"]].concat();
        let told = format!("zonobench verify {}\n", words.join(" "));
        assert!([&outcome.stdout, &outcome.stderr].iter().any(|text| text.ends_with(&told)), "{command:?}");
        let (status, cells) = verified(folder, &words);
        assert_eq!((status, cells[2].as_str()), (0, "right"), "{command:?}: {cells:?}");
        let answer = fs::read_to_string(folder.join("answer.json")).expect("written");
        assert!(answer.contains(&format!("\"request\":{{\"command\":\"{}\",", command[0])), "{answer}");
        assert_eq!(answer.matches("\"sha256\":").count(), given.len(), "{answer}");

        // A field of the request that no command writes is named, a spoilt one makes nothing wrong.
        change(folder, |answer| answer["request"]["padding"] = json!(1));
        let (status, cells) = verified(folder, &words);
        assert_eq!((status, cells[2].as_str()), (0, "unchecked"), "{command:?}: {cells:?}");
        assert!(cells[3].starts_with("the field `request, padding` is not checked; the rest: "), "{cells:?}");
        change(folder, |answer| answer["request"] = json!({"command": command[0]}));
        let (status, cells) = verified(folder, &words);
        assert_eq!((status, cells[2].as_str()), (1, "unchecked"), "{command:?}: {cells:?}");
        assert!(cells[3].contains("has no readable `"), "{cells:?}");
    }
}

#[test]
fn answers_about_other_bodies_are_not_called_wrong() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    files(folder);
    fs::write(folder.join("c.json"), B.replace("[5,1]", "[0,1]")).expect("written");
    let outcome = run(folder, &["intersect", "a.json", "b.json", "--json", "answer.json"]);
    assert_eq!(outcome.status, 0, "{}", outcome.stderr);
    for (given, reason) in [
        (["a.json", "c.json"], "the data are not those that the answer was computed from, and for these it fails: "),
        (["b.json", "a.json"], "the files are those of the answer in the other order, and so it fails: "),
        (["a.json", "lost.json"], "the question that the answer records cannot be asked: lost.json: cannot be read: "),
    ] {
        let (status, cells) = verified(folder, &[&given[..], &["answer.json"]].concat());
        assert_eq!((status, cells[2].as_str()), (1, "unchecked"), "{given:?}: {cells:?}");
        assert!(cells[3].starts_with(reason), "{given:?}: {cells:?}");
    }
    // An answer by `solve` records nothing; what is right is right all the same.
    change(folder, |answer| drop(answer.as_object_mut().expect("an object").remove("request")));
    assert_eq!(verified(folder, &["a.json", "b.json", "answer.json"]).1[2], "right");
    let (status, cells) = verified(folder, &["b.json", "a.json", "answer.json"]);
    assert_eq!((status, cells[2].as_str()), (1, "unchecked"), "{cells:?}");
    change(folder, |answer| answer["result"]["certificate"]["separating_direction"] = json!([-1, 0]));
    let outcome = run(folder, &["intersect", "a.json", "b.json", "--question", "q.json"]);
    assert_eq!(outcome.status, 0, "{}", outcome.stderr);
    let (status, cells) = verified(folder, &["q.json", "answer.json"]);
    assert_eq!((status, cells[2].as_str()), (1, "WRONG"), "{cells:?}");
}

#[test]
fn an_answer_is_a_body_for_the_answer_about_it() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    files(folder);
    for words in [
        &["enclose", "p.csv", "--json", "around.json"][..],
        &["reduce", "around.json", "--count", "2", "--json", "answer.json"],
    ] {
        assert_eq!(run(folder, words).status, 0, "{words:?}");
    }
    assert_eq!(verified(folder, &["p.csv", "around.json"]).1[2], "right");
    assert_eq!(verified(folder, &["around.json", "answer.json"]).1[1..3], ["reduce", "right"]);
    let answer = fs::read(folder.join("answer.json")).expect("written");
    let piped = run_with_input(folder, &["verify", "around.json", "-"], &answer);
    assert!(piped.stdout.contains("\tright\t"), "{}{}", piped.stdout, piped.stderr);
}

#[test]
fn two_answers_are_no_question_and_its_answer() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    files(folder);
    for (words, answer) in [
        (&["enclose", "p.csv"][..], "around.json"),
        (&["intersect", "a.json", "b.json", "--question", "q.json"], "meeting.json"),
    ] {
        assert_eq!(run(folder, &[words, &["--json", answer]].concat()).status, 0, "{words:?}");
    }
    for (given, reason) in [
        (["around.json", "meeting.json"], "around.json holds answers, where the questions are expected, or the files "),
        (["meeting.json", "meeting.json"], "meeting.json holds answers, where the questions are expected, "),
        (["meeting.json", "around.json"], "meeting.json holds answers, where the questions are expected, "),
        (
            ["meeting.json", "q.json"],
            "q.json holds questions, where the answers are expected; meeting.json holds answers, so name it last",
        ),
        (["q.json", "q.json"], "q.json holds questions, where the answers are expected: what `solve` wrote, "),
        (["a.json", "meeting.json"], "the answer is about two files: zonobench verify A B ANSWER checks it"),
    ] {
        let (status, cells) = verified(folder, &given);
        assert_eq!((status, cells[2].as_str()), (1, "unchecked"), "{given:?}: {cells:?}");
        assert!(cells[3].starts_with(reason), "{given:?}: {cells:?}");
    }
    assert_eq!(verified(folder, &["q.json", "meeting.json"]).0, 0);
    for words in [
        &["verify", "a.json", "b.json", "around.json"][..],
        &["verify", "q.json"],
        &["verify", "a.json", "b.json", "meeting.json", "meeting.json"],
        &["verify", "a.json", "b.json", "meeting.json", "--epsilon", "0.1"],
        &["verify", "a.json", "b.json", "meeting.json", "--skip", "1"],
        &["verify", "-", "-", "meeting.json"],
    ] {
        let outcome = run(folder, words);
        assert_eq!((outcome.status, outcome.stdout.as_str()), (2, ""), "{words:?}: {}", outcome.stderr);
    }
    // A batch of answers in the place of questions says it once.
    let answers = fs::read_to_string(folder.join("meeting.json")).expect("written").repeat(2);
    fs::write(folder.join("answers.jsonl"), answers).expect("written");
    let outcome = run(folder, &["verify", "answers.jsonl", "answers.jsonl"]);
    assert_eq!((outcome.status, outcome.stdout.lines().count()), (1, 1), "{}", outcome.stdout);
    assert!(outcome.stdout.starts_with("-\t-\tunchecked\tanswers.jsonl holds answers, where the questions"));
}
