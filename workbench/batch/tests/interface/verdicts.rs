//! The verdicts of the check of an answer on right, wrong and unreadable lines.

use batch::json::{MAX_VALUES, read};
use batch::{Verdict, check, verify};

fn verdict(question: &str, answer: &str) -> Verdict {
    let tree = |text: &str| read(text.as_bytes(), MAX_VALUES).expect("the test's lines are JSON");
    check(&tree(question), &tree(answer))
}

const QUESTION: &str = r#"{"id":"t","kind":"min_area","input":{"points":[[0,0],[2,0],[0,2]]}}"#;

#[test]
fn an_answer_is_read_and_proved() {
    let answer = r#"{"id":"t","kind":"min_area","method":"m","result":{"area":4,"center":[1,1],
        "generators":[[1,0],[0,1]],"lower_bound":4,
        "certificate":{"hull":[0,1,2],"farthest":[2,0,1],"coefficients":[0,-1,0],"basis":[0,2]}}}"#;
    assert!(matches!(verdict(QUESTION, answer), Verdict::Right(_)));
    let other = answer.replace("\"t\"", "\"s\"");
    assert_eq!(verdict(QUESTION, &other), Verdict::Wrong("the id is `s`, and the question's is `t`".into()));
    let unnamed = answer.replace("\"m\"", "7");
    assert_eq!(verdict(QUESTION, &unnamed), Verdict::Wrong("`method` is a number, not a name".into()));
    let partial = answer.replace("\"basis\"", "\"base\"");
    assert_eq!(verdict(QUESTION, &partial), Verdict::Wrong("`basis` is missing".into()));
}

#[test]
fn lines_that_are_not_json() {
    let refusal = r#"{"id":null,"kind":null,"error":{"code":"bad_json","message":"m","line":1}}"#;
    assert!(matches!(verify("nope", refusal), Verdict::Unchecked(_)));
    assert!(matches!(verify("nope", r#"{"id":"t","result":{}}"#), Verdict::Wrong(_)));
    assert_eq!(verify(QUESTION, "nope"), Verdict::Wrong("the answer is not JSON".into()));
}

#[test]
fn refusals_and_unknown_kinds_are_not_judged() {
    let refusal = r#"{"id":"t","kind":"min_area","error":{"code":"too_large","message":"m"}}"#;
    assert_eq!(verdict(QUESTION, refusal), Verdict::Unchecked("refused: too_large: m".into()));
    let unknown = refusal.replace("too_large", "nonsense");
    assert_eq!(verdict(QUESTION, &unknown), Verdict::Wrong("there is no code `nonsense`".into()));
    let both = refusal.replace("\"error\"", "\"result\":{},\"error\"");
    assert_eq!(verdict(QUESTION, &both), Verdict::Wrong("there is a result beside the refusal".into()));
    let line = r#"{"id":"t","kind":"weather","input":{},"result":{}}"#;
    assert!(matches!(verdict(line, line), Verdict::Unchecked(_)));
}

#[test]
fn what_no_check_reads_is_not_called_right() {
    let answer = r#"{"id":"t","kind":"min_area","method":"m","request":{"skip":1},"result":{"area":4,"center":[1,1],
        "generators":[[1,0],[0,1]],"lower_bound":4,
        "certificate":{"hull":[0,1,2],"farthest":[2,0,1],"coefficients":[0,-1,0],"basis":[0,2]}}}"#;
    let unread = |question: &str, answer: &str| match verdict(question, answer) {
        Verdict::Unchecked(reason) => reason.split("; the rest: ").next().unwrap_or_default().to_owned(),
        other => panic!("{other:?}"),
    };
    assert!(matches!(verdict(QUESTION, answer), Verdict::Right(_)));
    let with = |place: &str, claim: &str| answer.replace(place, &format!("{claim},{place}"));
    for (claimed, place) in [
        (with("\"area\"", "\"gap\":0"), "result, gap"),
        (with("\"hull\"", "\"gap\":[{\"x\":0}]"), "result, certificate, gap"),
        (with("\"method\"", "\"gap\":0"), "gap"),
    ] {
        assert_eq!(unread(QUESTION, &claimed), format!("the field `{place}` is not checked"));
        // An answer that is wrong stays wrong, whatever else is claimed.
        assert!(matches!(verdict(QUESTION, &claimed.replace("\"area\":4", "\"area\":5")), Verdict::Wrong(_)));
    }
    let several = with("\"area\"", "\"gap\":0,\"ratio\":1,\"length\":2");
    assert_eq!(unread(QUESTION, &several), "the field `result, gap` and 2 more are not checked");
    // Fields that some answers of the kind have are not checked where they belong to none of this sort.
    let question = r#"{"id":"t","kind":"member","input":{"point":[3,0],"center":[0,0],"generators":[[1,0],[0,1]]}}"#;
    let outside = r#"{"id":"t","kind":"member","result":{"member":false,"status":"outside","certificate":
        {"separating_direction":[1,0]}}}"#;
    assert!(matches!(verdict(question, outside), Verdict::Right(_)));
    let both = outside.replace("[1,0]}", "[1,0],\"basis\":[]}");
    assert_eq!(unread(question, &both), "the field `result, certificate, basis` is not checked");
}

#[test]
fn fields_of_the_elements_of_a_list_are_claims_as_well() {
    let question = r#"{"id":"t","kind":"min_length_dirs","input":{"points":[[0],[2]],"directions":[[1]],
        "weights":[1]}}"#;
    let answer = r#"{"id":"t","kind":"min_length_dirs","result":{"status":"optimal","value":1,"center":[1],
        "coefficients":[1],"lower_bound":1,"certificate":{"forces":[{"point":0,"vector":["-1/2"]},
        {"point":1,"vector":["1/2"]}]}}}"#;
    assert!(matches!(verdict(question, answer), Verdict::Right(_)), "{:?}", verdict(question, answer));
    let claimed = answer.replace("{\"point\":1", "{\"weight\":1,\"point\":1");
    let Verdict::Unchecked(reason) = verdict(question, &claimed) else { panic!("an invented weight is right") };
    assert!(reason.starts_with("the field `result, certificate, force"), "{reason}");
}

#[test]
fn what_a_question_asks_beyond_its_kind_is_not_called_answered() {
    let answer = r#"{"id":"t","kind":"min_area","result":{"area":4,"center":[1,1],"generators":[[1,0],[0,1]],
        "lower_bound":4,"certificate":{"hull":[0,1,2],"farthest":[2,0,1],"coefficients":[0,-1,0],"basis":[0,2]}}}"#;
    let reason = |question: &str, answer: &str| match verdict(question, answer) {
        Verdict::Unchecked(reason) => reason.split("; the rest: ").next().unwrap_or_default().to_owned(),
        other => panic!("{other:?}"),
    };
    assert!(matches!(verdict(QUESTION, answer), Verdict::Right(_)));
    let weighed = QUESTION.replace("\"points\"", "\"weights\":[1,2,3],\"points\"");
    assert_eq!(reason(&weighed, answer), "the field `input, weights` is not checked");
    assert!(matches!(verdict(&weighed, &answer.replace("\"area\":4", "\"area\":5")), Verdict::Wrong(_)));
    let hurried = QUESTION.replace("\"kind\"", "\"seconds\":1,\"kind\"");
    assert_eq!(reason(&hurried, answer), "the field `seconds` is not checked");
    let both = answer.replace("\"area\"", "\"gap\":0,\"area\"");
    assert_eq!(reason(&weighed, &both), "the field `input, weights` and 1 more are not checked");
    let by_method = QUESTION.replace("\"kind\"", "\"method\":\"m\",\"kind\"");
    assert!(matches!(verdict(&by_method, answer), Verdict::Right(_)));

    let apart = r#"{"id":"t","kind":"intersect","result":{"intersects":false,"status":"outside","certificate":
        {"separating_direction":[1,0]}}}"#;
    let bodies = r#"{"id":"t","kind":"intersect","input":{"a":{"center":[0,0],"generators":[[1,0],[0,1]]},
        "b":{"center":[5,0],"generators":[[1,0]]}}}"#;
    let moved = bodies.replace("[[1,0]]", "[[1,0]],\"velocity\":[1,0]");
    assert!(matches!(verdict(bodies, apart), Verdict::Right(_)), "{:?}", verdict(bodies, apart));
    assert_eq!(reason(&moved, apart), "the field `input, b, velocity` is not checked");
}

/// A rule says how few generators are looked for, and a reduction by another one would be as right.
#[test]
fn what_a_question_may_have_need_not_be_read() {
    let question = r#"{"id":"t","kind":"reduce","input":{"center":[0,0,0],"generators":[[1,0,0],[0,1,0],[0,0,1]],
        "count":3,"rule":"pca"}}"#;
    let answer = batch::answer(question);
    assert!(matches!(verify(question, &answer), Verdict::Right(_)), "{answer}: {:?}", verify(question, &answer));
    let volume = r#"{"id":"t","kind":"min_length_all","input":{"points":[[0,0],[2,0]],"epsilon":0.1,
        "objective":"weight"}}"#;
    let answer = batch::answer(&volume.replace("weight", "length"));
    assert!(matches!(verify(&volume.replace("weight", "length"), &answer), Verdict::Right(_)));
    let expected = "the question's `objective` is neither length nor volume";
    assert_eq!(verify(volume, &answer), Verdict::Unchecked(expected.to_owned()));
}
