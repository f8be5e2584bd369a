//! What the check of an answer says of right, wrong and unreadable lines.

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
    assert_eq!(verdict(QUESTION, &other), Verdict::Wrong("the id is not the question's".into()));
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
