//! Files of another sort than `verify` expects, and data on standard input.

use std::fs;
use std::path::Path;

use crate::{run, run_with_input};

const QUESTIONS: &str = r#"{"id":"a","kind":"min_area","input":{"points":[[0,0],[2,0],[0,2]]}}
{"id":"b","kind":"support","input":{"direction":[1,2],"center":[5,5],"generators":[[1,0],[0,1]]}}
"#;

const POINTS: &str = "0,0\n2,0\n0,2\n";

const BODY: &str = r#"{"c":[1,1],"G":[[1,0,1],[0,1,1]]}"#;

fn files(folder: &Path) {
    let write = |name: &str, content: &str| fs::write(folder.join(name), content).expect("written");
    write("q.jsonl", QUESTIONS);
    write("others.jsonl", &QUESTIONS.replace("\"a\"", "\"c\"").replace("\"b\"", "\"d\""));
    write("p.csv", POINTS);
    write("z.json", BODY);
    write("y.json", &BODY.replace("[1,1]", "[5,1]"));
    write("z.body", BODY);
    write("empty.jsonl", "");
    write("tool.json", r#"{"answers":[1,2]}"#);
    write("list.json", "[[0,0],[1,1]]");
    write("map.geojson", r#"{"type":"FeatureCollection","features":[]}"#);
    for (words, name) in [
        (&["solve", "q.jsonl"][..], "a.jsonl"),
        (&["solve", "others.jsonl"], "a2.jsonl"),
        (&["enclose", "p.csv", "--json", "-"], "e.json"),
        (&["intersect", "z.json", "y.json", "--json", "-"], "i.json"),
    ] {
        write(name, &run(folder, words).stdout);
    }
}

#[test]
fn files_of_another_sort_are_told_in_one_line() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    files(folder);
    let answers = "where the answers are expected: what `solve` wrote, or a command by --json; before them stand the";
    let questions = "where the questions are expected, and the answer does not record a file that it is about";
    for (given, found, expected) in [
        (&["q.jsonl", "q.jsonl"][..], "q.jsonl holds questions, ", answers),
        (&["q.jsonl", "z.json"], "z.json holds a zonotope, ", answers),
        (&["p.csv", "z.json"], "z.json holds a zonotope, ", answers),
        (&["p.csv", "map.geojson"], "map.geojson holds points, ", answers),
        (&["p.csv", "list.json"], "list.json holds a list in JSON, as points or generators, ", answers),
        (&["q.jsonl", "tool.json"], "tool.json holds JSON that is neither question nor answer, ", answers),
        (&["q.jsonl", "p.csv"], "p.csv holds no JSON, ", answers),
        (&["p.csv", "p.csv"], "p.csv holds no JSON, ", answers),
        (&["q.jsonl", "empty.jsonl"], "empty.jsonl is empty, ", answers),
        (&["empty.jsonl", "empty.jsonl"], "empty.jsonl is empty, ", answers),
        (&["a.jsonl", "q.jsonl"], "q.jsonl holds questions, ", "; a.jsonl holds answers, so name it last"),
        (&["e.json", "p.csv"], "p.csv holds no JSON, ", "; e.json holds answers, so name it last"),
        (&["i.json", "z.json", "y.json"], "y.json holds a zonotope, ", "; i.json holds answers, so name it last"),
        (&["z.json", "i.json", "y.json"], "y.json holds a zonotope, ", "; i.json holds answers, so name it last"),
        (&["a.jsonl", "a.jsonl"], "a.jsonl holds answers, ", "zonobench verify FILE ANSWER, or A B ANSWER"),
        (&["empty.jsonl", "a.jsonl"], "empty.jsonl is empty, ", questions),
        (&["z.body", "a.jsonl"], "z.body holds a zonotope, ", questions),
    ] {
        let outcome = run(folder, &[&["verify"], given].concat());
        assert_eq!((outcome.status, outcome.stderr.as_str()), (1, ""), "{given:?}: {}", outcome.stdout);
        assert_eq!(outcome.stdout.lines().count(), 1, "{given:?}: {}", outcome.stdout);
        assert!(outcome.stdout.starts_with(&format!("-\t-\tunchecked\t{found}")), "{given:?}: {}", outcome.stdout);
        assert!(outcome.stdout.contains(expected), "{given:?}: {}", outcome.stdout);
    }
}

/// The content of a batch is told line by line, and a line at its end says what all of them have in common.
#[test]
fn answers_of_another_run_are_told() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    files(folder);
    let outcome = run(folder, &["verify", "q.jsonl", "a2.jsonl"]);
    let lines: Vec<&str> = outcome.stdout.lines().collect();
    assert_eq!(outcome.status, 1);
    assert_eq!(lines[0], "a\tmin_area\tWRONG\tthe id is `c`, and the question's is `a`");
    assert_eq!(lines[2], "-\t-\tWRONG\tno answer has the id of its question, so they are not of one run");
    // A spoilt line is judged by itself.
    let answers = fs::read_to_string(folder.join("a.jsonl")).expect("written");
    let mixed = format!("not JSON\nno answer\n{answers}");
    fs::write(folder.join("mixed.jsonl"), mixed).expect("written");
    fs::write(folder.join("four.jsonl"), QUESTIONS.repeat(2)).expect("written");
    let outcome = run(folder, &["verify", "four.jsonl", "mixed.jsonl"]);
    let counts = ["the answer is not JSON", "\tright\t"].map(|text| outcome.stdout.matches(text).count());
    assert_eq!((outcome.status, counts), (1, [2, 2]), "{}", outcome.stdout);
}

/// The command that a summary tells to check its answer does so.
#[test]
fn data_on_standard_input_are_verified() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    files(folder);
    let enclosed = run_with_input(folder, &["enclose", "-", "--format", "csv", "--json", "s.json"], POINTS.as_bytes());
    let told = enclosed.stdout.lines().find_map(|line| line.strip_prefix("verify")).expect("the summary says how");
    let told: Vec<&str> = told.split_whitespace().skip(1).collect();
    assert_eq!(told, ["verify", "-", "s.json", "--format", "csv"]);
    for words in [&told[..], &["verify", "-", "s.json"]] {
        let outcome = run_with_input(folder, words, POINTS.as_bytes());
        assert_eq!((outcome.status, outcome.stderr.as_str()), (0, ""), "{words:?}: {}", outcome.stdout);
        assert!(outcome.stdout.starts_with("-\tmin_area\tright\t"), "{words:?}: {}", outcome.stdout);
        let other = run_with_input(folder, words, b"0,0\n2,0\n0,9\n");
        assert_eq!(other.status, 1, "{words:?}: {}", other.stdout);
        assert!(other.stdout.contains("the data are not those that the answer was computed from"), "{}", other.stdout);
    }
    let other = run_with_input(folder, &["verify", "-", "s.json", "--epsilon", "0.1"], POINTS.as_bytes());
    assert!(other.stdout.contains("the options ask for something else"), "{}", other.stdout);

    let inspected = run_with_input(folder, &["inspect", "-", "--format", "json", "--json", "n.json"], BODY.as_bytes());
    assert_eq!(inspected.status, 0, "{}", inspected.stderr);
    let outcome = run_with_input(folder, &["verify", "-", "n.json"], BODY.as_bytes());
    assert!(outcome.stdout.contains("\tcombinatorics\tright\t"), "{}{}", outcome.stdout, outcome.stderr);
    // Questions are told from data by how they begin.
    let questions = run_with_input(folder, &["verify", "-", "a.jsonl"], QUESTIONS.as_bytes());
    assert_eq!((questions.status, questions.stdout.matches("\tright\t").count()), (0, 2), "{}", questions.stdout);
    let words = ["intersect", "z.json", "y.json", "--question", "asked.json", "--json", "met.json"];
    assert_eq!(run(folder, &words).status, 0);
    let asked = fs::read(folder.join("asked.json")).expect("written");
    let outcome = run_with_input(folder, &["verify", "-", "met.json"], &asked);
    assert!(outcome.stdout.contains("\tintersect\tright\t"), "{}{}", outcome.stdout, outcome.stderr);
}
