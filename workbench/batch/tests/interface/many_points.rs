//! Questions about so many points that only the corners of their hull are looked at: certificates name points of the
//! question all the same.

use batch::{Verdict, answer, verify};

/// The points of a lattice with 30 places a side, in an order of no meaning.
fn lattice() -> impl Iterator<Item = [u32; 3]> {
    (0..27_000).map(|i| i * 7919 % 27_000).map(|i| [i % 30, i / 30 % 30, i / 900])
}

/// The answer to a question of a kind, which passes its check.
fn right(kind: &str, input: &str) -> String {
    let question = format!(r#"{{"id":"q","kind":"{kind}","input":{input}}}"#);
    let answer = answer(&question);
    let verdict = verify(&question, &answer);
    assert!(matches!(verdict, Verdict::Right(_)), "{kind}: {verdict:?}");
    answer
}

#[test]
fn certificates_name_points_of_the_question() {
    let solid = format!("{:?}", lattice().collect::<Vec<_>>());
    let flat = format!("{:?}", lattice().map(|[x, y, _]| [x, y]).collect::<Vec<_>>());
    let axes = r#""directions":[[1,0,0],[0,1,0],[0,0,1]],"weights":[1,1,1]"#;
    for (kind, input) in [
        ("min_length_all", format!(r#"{{"points":{solid},"epsilon":0.01}}"#)),
        ("min_length_all", format!(r#"{{"points":{flat},"epsilon":0.01}}"#)),
        ("min_length_dirs", format!(r#"{{"points":{solid},{axes}}}"#)),
    ] {
        assert!(right(kind, &input).contains("\"forces\":[{\"point\":"), "{kind}");
    }
    let level = r#""directions":[[1,0,0],[0,1,0]],"weights":[1,1]"#;
    let infeasible = right("min_length_dirs", &format!(r#"{{"points":{solid},{level}}}"#));
    assert!(infeasible.contains("\"status\":\"infeasible\""), "{infeasible}");
}
