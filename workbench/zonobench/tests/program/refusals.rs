//! `solve`: every line is answered or refused, in order, with the code of the format.

use std::path::Path;

use crate::run_with_input;
use serde_json::Value;

/// The answers to lines of questions.
fn answers(input: &str) -> Vec<Value> {
    let outcome = run_with_input(Path::new("."), &["solve"], input.as_bytes());
    assert_eq!((outcome.status, outcome.stderr.as_str()), (0, ""));
    outcome.stdout.lines().map(|line| serde_json::from_str(line).expect("an answer is JSON")).collect()
}

/// The code and the message that refuse a single line.
fn refusal(line: &str) -> (String, String) {
    let answers = answers(line);
    assert_eq!(answers.len(), 1, "{line}");
    let text = |name: &str| answers[0]["error"][name].as_str().unwrap_or_default().to_owned();
    assert!(answers[0].get("result").is_none());
    (text("code"), text("message"))
}

fn refused(line: &str, code: &str, message: &str) {
    assert_eq!(refusal(line), (code.to_owned(), message.to_owned()), "{line}");
}

fn min_area(points: &str) -> String {
    format!(r#"{{"id":"q","kind":"min_area","input":{{"points":{points}}}}}"#)
}

fn support(input: &str) -> String {
    format!(r#"{{"id":"q","kind":"support","input":{{{input}}}}}"#)
}

#[test]
fn numbers_that_are_not_finite() {
    refused(&min_area(r#"[[0,0],[1,"NaN"]]"#), "non_finite", "point 2, coordinate 2 is NaN");
    refused(&min_area(r#"[["-Infinity",0]]"#), "non_finite", "point 1, coordinate 1 is -Infinity");
    let input = r#"{"direction":[1,2,3],"generators":[[0,"NaN"]]}"#;
    let first_of_all = &format!(r#"{{"id":"q","kind":"support","method":"none","input":{input},"more":1}}"#);
    refused(first_of_all, "non_finite", "generator 1, coordinate 2 is NaN");
    let line = support(r#""direction":["Infinity",0],"center":[0,0],"generators":[]"#);
    refused(&line, "non_finite", "direction, coordinate 1 is Infinity");
    refused(&min_area("[[0,1e999]]"), "non_finite", "line 1, column 55: a number is outside the range of a double");
    let (code, _) = refusal(&min_area("[[0,NaN]]"));
    assert_eq!(code, "bad_json", "a bare NaN is not JSON");
}

#[test]
fn shapes() {
    let in_the_plane = |point: &str| format!("{point} coordinates, not 2: `min_area` takes points of the plane");
    refused(&min_area("[]"), "empty", &refusal(&min_area("[]")).1);
    refused(&min_area("[[0,0],[1,2,3]]"), "dimension_mismatch", &in_the_plane("point 2 has 3"));
    refused(&min_area("[[]]"), "dimension_mismatch", &in_the_plane("point 1 has 0"));
    refused(&min_area("[[0,0],[1,null]]"), "bad_input", "point 2, coordinate 2 is null, not a number");
    refused(&min_area(r#"[[0,"1"]]"#), "bad_input", "point 1, coordinate 2 is a string, not a number");
    refused(&min_area("[7]"), "bad_input", "point 1 is a number, not a list");
    refused(&min_area("{}"), "bad_input", "`points` is an object, not a list");
    let line = support(r#""direction":[1,0],"center":[0,0,0],"generators":[]"#);
    refused(&line, "dimension_mismatch", "center has 3 coordinates, not 2");
    let line = support(r#""direction":[],"center":[],"generators":[]"#);
    refused(&line, "dimension_mismatch", "direction has 0 coordinates; 1 to 10000 are taken");
    let line = support(r#""direction":[1,2,3,4,5,6,7],"center":[0],"generators":[]"#);
    assert_eq!(refusal(&line).0, "dimension_mismatch");
}

#[test]
fn fields() {
    refused(&support(r#""direction":[1,0],"center":[0,0]"#), "bad_input", "missing field `generators` in the input");
    let line = r#"{"id":"q","kind":"min_area","input":{"points":[[0,0]],"epsilon":1}}"#;
    refused(line, "bad_input", "extra field `epsilon` in the input");
    refused(r#"{"id":"q","kind":"min_area"}"#, "bad_input", "missing field `input` in the question");
    refused(r#"{"kind":"min_area","input":{}}"#, "bad_input", "missing field `id` in the question");
    refused(r#"{"id":"q","input":{}}"#, "bad_input", "missing field `kind` in the question");
    refused(r#"{"id":7,"kind":"min_area","input":{}}"#, "bad_input", "`id` is a number, not a string");
    refused(r#"{"id":"q","kind":"min_area","input":[]}"#, "bad_input", "`input` is a list, not an object");
    refused(r#"{"id":"q","id":"r"}"#, "bad_input", "the field `id` occurs twice in one object");
    refused("[]", "bad_input", "a question is an object, not a list");
    assert_eq!(refusal(r#"{"id":"q","kind":"volume","input":{}}"#).0, "unknown_kind");
    let line = r#"{"id":"q","kind":"min_area","method":"by_luck","input":{"points":[[0,0]]}}"#;
    assert_eq!(refusal(line).0, "unknown_method");
}

#[test]
fn lengths_along_directions() {
    let refusal = |input: &str, code: &str, message: &str| {
        refused(&format!(r#"{{"id":"q","kind":"min_length_dirs","input":{{{input}}}}}"#), code, message);
    };
    let line = r#""points":[[0,0]],"directions":[[1,0],["NaN",1]],"weights":[-1]"#;
    refusal(line, "non_finite", "direction 2, coordinate 1 is NaN");
    let line = r#""points":[[0,0]],"directions":[],"weights":[1,"Infinity"],"more":1"#;
    refusal(line, "non_finite", "weight 2 is Infinity");
    refusal(r#""points":[[0,0]],"directions":[]"#, "bad_input", "missing field `weights` in the input");
    let line = r#""points":[[0,0]],"directions":[],"weights":[],"epsilon":1"#;
    refusal(line, "bad_input", "extra field `epsilon` in the input");
    let line = r#""points":[[0,0]],"directions":[[1,0]],"weights":["1"]"#;
    refusal(line, "bad_input", "weight 1 is a string, not a number");
    let line = r#""points":[[0,0]],"directions":[[1,0,0]],"weights":[1]"#;
    refusal(line, "dimension_mismatch", "direction 1 has 3 coordinates, not 2");
    let line = r#""points":[[0,0,0,0,0]],"directions":[],"weights":[]"#;
    refusal(line, "dimension_mismatch", "point 1 has 5 coordinates; 1 to 4 are taken");
    let line = r#""points":[],"directions":[[1,0]],"weights":[1,2]"#;
    refusal(line, "length_mismatch", "2 weights for 1 directions");
    refusal(r#""points":[],"directions":[],"weights":[]"#, "empty", "there are no points");
    let line = r#""points":[[0,0]],"directions":[[1,0],[0,1]],"weights":[0,-0.5]"#;
    refusal(line, "negative_weight", "weight 2 is -0.5, which is negative");
    let line = r#""points":[[-1e308],[1e308]],"directions":[[1e-300]],"weights":[1]"#;
    refusal(line, "too_large", "a coefficient leaves the range of doubles");
    let many = |item: &str, count: usize| [item].repeat(count).join(",");
    let line = format!(r#""points":[[0,0]],"directions":[{}],"weights":[{}]"#, many("[1,0]", 1001), many("1", 1001));
    refusal(&line, "too_large", "1001 directions, at most 1000 are taken");
    let line = format!(
        r#"{{"id":"q","kind":"min_length_dirs","method":"support_form","input":{{"points":[[0,0,0,0]],"directions":[{}],"weights":[{}]}}}}"#,
        many("[1,0,0,0]", 100),
        many("1", 100)
    );
    refused(&line, "too_large", "the linear program has 33633600 entries, at most 4000000 are taken by this method");
    let line = r#"{"id":"q","kind":"min_length_dirs","method":"by_luck","input":{}}"#;
    assert_eq!(refusal_of(line), "unknown_method");
}

#[test]
fn lengths_along_any_direction() {
    let refusal = |input: &str, code: &str, message: &str| {
        refused(&format!(r#"{{"id":"q","kind":"min_length_all","input":{{{input}}}}}"#), code, message);
    };
    refusal(r#""points":[[0,0,0,0,0]],"epsilon":"NaN""#, "non_finite", "epsilon is NaN");
    refusal(r#""points":[[0,0]],"epsilon":0"#, "bad_epsilon", "epsilon is 0, not between 0 and 1");
    refusal(r#""points":[[0,0]],"epsilon":1"#, "bad_epsilon", "epsilon is 1, not between 0 and 1");
    refusal(r#""points":[],"epsilon":1"#, "empty", "there are no points");
    refusal(r#""points":[[0,0]],"epsilon":[1]"#, "bad_input", "epsilon is a list, not a number");
    refusal(r#""points":[[0,0]]"#, "bad_input", "missing field `epsilon` in the input");
    refusal(r#""points":[[0,0],[1]],"epsilon":0.5"#, "dimension_mismatch", "point 2 has 1 coordinate, not 2");
    refusal(
        r#""points":[[0,0,0,0,0]],"epsilon":0.5"#,
        "dimension_mismatch",
        "point 1 has 5 coordinates; 1 to 4 are taken",
    );
    let line = format!(r#""points":[{}[0,0,0,0]],"epsilon":0.5"#, "[0,0,0,0],".repeat(20_000));
    refusal(
        &line,
        "too_large",
        "20001 points, at most 20000 are taken in 4 dimensions; along given directions, such as `enclose --directions \
         net:4` or the kind `min_length_dirs` has, more are, and a sample of them is enclosed sooner",
    );
    let line =
        r#"{"id":"q","kind":"min_length_all","method":"by_papers_net","input":{"points":[[0,0,0]],"epsilon":0.01}}"#;
    assert_eq!(refusal_of(line), "too_large");
    let line = r#"{"id":"q","kind":"min_length_all","method":"by_luck","input":{}}"#;
    assert_eq!(refusal_of(line), "unknown_method");
}

/// The code that refuses a single line.
fn refusal_of(line: &str) -> String {
    refusal(line).0
}

#[test]
fn ranks() {
    let refusal = |k: &str, code: &str, message: &str| {
        let line = format!(
            r#"{{"id":"q","kind":"slope_selection","input":{{"generators":[[1,1,0],[2,1,0],[0,0,1]],"k":{k}}}}}"#
        );
        refused(&line, code, message);
    };
    refusal("[1,2]", "bad_input", "k, entry 2 is 2, but there are 1 vertices");
    refusal("[0]", "bad_input", "k, entry 1 is 0.0, not a whole number from 1");
    refusal("[1.5]", "bad_input", "k, entry 1 is 1.5, not a whole number from 1");
    refusal(r#"["NaN"]"#, "non_finite", "k, entry 1 is NaN");
    refusal("1", "bad_input", "`k` is a number, not a list");
    refusal(r#"[true]"#, "bad_input", "k, entry 1 is a boolean, not a whole number from 1");
}

#[test]
fn lines_that_are_not_json() {
    let input = "\u{feff}\r\n  \r\nnope\r\n{\"id\":\"q\"\n";
    let answers = answers(input);
    let places: Vec<_> = answers.iter().map(|answer| (&answer["error"]["code"], &answer["error"]["line"])).collect();
    assert_eq!(places, [(&"bad_json".into(), &3.into()), (&"bad_json".into(), &4.into())]);
    assert_eq!(refusal(&"[".repeat(200_000)).0, "bad_json");
    assert_eq!(
        refusal(&format!("{{\"id\":\"q\",\"kind\":\"min_area\",\"input\":{}", "{\"a\":".repeat(200_000))).0,
        "bad_json"
    );
}

#[test]
fn too_much() {
    let line = format!(
        "{{\"id\":\"q\",\"kind\":\"min_area\",\"input\":{{\"points\":[{}[0,0]]}}}}",
        "[0,0],".repeat(2_000_000)
    );
    refused(&line, "too_large", "2000001 points, at most 2000000 are taken");
    let line = format!("{{\"id\":\"q\",\"kind\":\"min_area\",\"input\":{{\"points\":[{}0]}}}}", "0,".repeat(8_000_001));
    let answers = answers(&line);
    assert_eq!(answers[0]["error"]["code"], "too_large");
    assert_eq!((&answers[0]["id"], &answers[0]["kind"]), (&"q".into(), &"min_area".into()));
}

#[test]
fn answers_keep_the_order_and_strict_tells_of_refusals() {
    let input = [
        min_area("[[0,0],[2,0],[0,2]]"),
        min_area("[]"),
        support(r#""direction":[1,2],"center":[5,5],"generators":[[1,0],[0,1]]"#),
    ]
    .join("\n");
    let found = answers(&input);
    assert_eq!(found.len(), 3);
    assert_eq!(found[2]["result"]["value"], 18.0);
    assert_eq!(found[2]["result"]["point"], serde_json::json!([6.0, 6.0]));
    assert!(found[0]["result"]["area"].as_f64().is_some_and(|area| (area - 4.0).abs() < 1e-11));
    let strict = run_with_input(Path::new("."), &["solve", "--strict"], input.as_bytes());
    assert_eq!((strict.status, strict.stdout.lines().count()), (1, 3));
    let refused = strict.stdout.matches("\"error\":").count();
    let told =
        format!("zonobench: --strict: {refused} question{} refused", if refused == 1 { " was" } else { "s were" });
    assert!(strict.stderr.starts_with(&told), "{}", strict.stderr);
    let good = run_with_input(Path::new("."), &["solve", "--strict"], min_area("[[0,0]]").as_bytes());
    assert_eq!(good.status, 0);
}

#[test]
fn values_beyond_the_range_of_doubles_are_spelled() {
    let found = answers(&support(r#""direction":[1e300,0],"center":[-1e300,0],"generators":[]"#));
    assert_eq!(found[0]["result"]["value"], "-Infinity");
}
