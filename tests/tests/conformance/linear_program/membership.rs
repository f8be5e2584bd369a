//! Questions of membership that the engines must answer, and ones that they need not.

use zonotope::collision::by_linear_program::{Answer, locate};
use zonotope::collision::{Query, brute_force};
use zonotope::interop::verifier::check_location;

use super::ENGINES;

fn check<const D: usize>(to: [f64; D], generators: &[[f64; D]]) -> Vec<Answer<D>> {
    let question = Query::new([0.0; D], to, generators).expect("finite");
    let truth = brute_force::locate(&question);
    let answers = ENGINES.map(|engine| locate(&question, engine));
    for answer in &answers {
        assert!(answer.is_member().is_none_or(|member| member == truth.is_member()), "{answer:?}");
        if let Some(location) = answer.location() {
            assert_eq!(location.status(), truth.status());
            assert_eq!(check_location(&question, location).proof().map(drop), Ok(()));
        }
    }
    answers.to_vec()
}

#[test]
fn clear_questions_are_answered() {
    let generators = [[1.0, 0.25, 0.0], [0.0, 1.0, 0.5], [0.25, 0.0, 1.0], [0.5, 0.5, -0.5]];
    for scale in [1.0, 1e-200, 1e200] {
        let scaled = generators.map(|g| g.map(|v| v * scale));
        for to in [[0.5, 0.25, 0.125], [0.0, 0.0, 1e-9], [3.0, 3.0, 3.0], [1e9, -1.0, 0.5], [0.0; 3]] {
            for answer in check(to.map(|v| v * scale), &scaled) {
                assert!(answer.location().is_some(), "{to:?} at {scale}: {answer:?}");
            }
        }
    }
}

#[test]
fn flat_bodies_are_never_answered_wrong() {
    let flat = [[1.0, 1.0, 0.0], [1.0, -1.0, 0.0]];
    check([0.5, 0.5, 0.0], &flat);
    check([0.5, 0.5, 1e-300], &flat);
    check([0.0; 3], &[]);
    check([1.0, 0.0], &[[0.0; 2]]);
    check([1.0, 1.0], &[[1.0, 0.0], [0.0, 1.0]]);
}
