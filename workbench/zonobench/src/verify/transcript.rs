//! A question and its answer, as lines of JSON.

use super::min_area::{Certificate, MinAreaAnswer, check_min_area};
use super::support::{SupportAnswer, check_support};
use crate::json::Tree;

/// What the check says about one answer.
#[derive(Debug, Clone, PartialEq)]
pub enum Verdict {
    /// Proved right; what was proved.
    Right(String),
    /// Wrong; why.
    Wrong(String),
    /// A refusal, or a kind that this verifier does not know.
    Unchecked(String),
}

/// Checks an answer against its question.
pub fn check(question: &Tree, answer: &Tree) -> Verdict {
    match checked(question, answer) {
        Ok(verdict) => verdict,
        Err(complaint) => Verdict::Wrong(complaint),
    }
}

fn checked(question: &Tree, answer: &Tree) -> Result<Verdict, String> {
    for name in ["id", "kind"] {
        let (asked, answered) = (question.field(name), answer.field(name));
        if asked.and_then(Tree::text) != answered.and_then(Tree::text) {
            return Err(format!("the {name} is not the question's"));
        }
    }
    if let Some(error) = answer.field("error") {
        let text = |name| error.field(name).and_then(Tree::text).unwrap_or("?");
        return Ok(Verdict::Unchecked(format!("refused: {}: {}", text("code"), text("message"))));
    }
    let input = member(question, "input")?;
    let result = member(answer, "result")?;
    match question.field("kind").and_then(Tree::text).unwrap_or_default() {
        "min_area" => {
            let points = planar(member(input, "points")?, "points")?;
            let proof = check_min_area(&points, &min_area_answer(result)?)?;
            Ok(Verdict::Right(format!(
                "contains all {} points; area {:?} is within {:.1e} of the proven bound",
                points.len(),
                proof.area,
                proof.gap
            )))
        }
        "support" => {
            let direction = vector(member(input, "direction")?, "direction")?;
            let center = vector(member(input, "center")?, "center")?;
            let generators = vectors(member(input, "generators")?, "generators")?;
            if center.len() != direction.len() || generators.iter().any(|generator| generator.len() != direction.len())
            {
                return Err("answered a question whose dimensions do not agree".to_owned());
            }
            let answer =
                SupportAnswer { value: float(result, "value")?, point: vector(member(result, "point")?, "point")? };
            check_support(&direction, &center, &generators, &answer)?;
            Ok(Verdict::Right(format!("value {:?} and point agree with the exact sums", answer.value)))
        }
        other => Ok(Verdict::Unchecked(format!("the kind `{other}` is not checked"))),
    }
}

fn min_area_answer(result: &Tree) -> Result<MinAreaAnswer, String> {
    let center = vector(member(result, "center")?, "center")?;
    let certificate = member(result, "certificate")?;
    Ok(MinAreaAnswer {
        area: float(result, "area")?,
        center: <[f64; 2]>::try_from(center).map_err(|_| "center is not a point of the plane")?,
        generators: planar(member(result, "generators")?, "generators")?,
        lower_bound: float(result, "lower_bound")?,
        certificate: Certificate {
            hull: indices(certificate, "hull")?,
            farthest: indices(certificate, "farthest")?,
            coefficients: vector(member(certificate, "coefficients")?, "coefficients")?,
            basis: indices(certificate, "basis")?,
        },
    })
}

fn member<'a>(object: &'a Tree, name: &str) -> Result<&'a Tree, String> {
    object.field(name).ok_or_else(|| format!("`{name}` is missing"))
}

/// A figure of an answer: possibly an infinity, where the exact value is beyond the range of doubles.
fn float(object: &Tree, name: &str) -> Result<f64, String> {
    member(object, name)?.float().ok_or_else(|| format!("`{name}` is not a number"))
}

fn vector(value: &Tree, name: &str) -> Result<Vec<f64>, String> {
    let components = value.list().ok_or_else(|| format!("`{name}` is not a list"))?;
    components
        .iter()
        .map(|component| component.float().filter(|number| number.is_finite()))
        .collect::<Option<_>>()
        .ok_or_else(|| format!("`{name}` holds something else than finite numbers"))
}

fn vectors(value: &Tree, name: &str) -> Result<Vec<Vec<f64>>, String> {
    let rows = value.list().ok_or_else(|| format!("`{name}` is not a list"))?;
    rows.iter().map(|row| vector(row, name)).collect()
}

fn planar(value: &Tree, name: &str) -> Result<Vec<[f64; 2]>, String> {
    let rows = vectors(value, name)?;
    rows.into_iter()
        .map(|row| {
            <[f64; 2]>::try_from(row).map_err(|_| format!("`{name}` holds something else than points of the plane"))
        })
        .collect()
}

fn indices(object: &Tree, name: &str) -> Result<Vec<usize>, String> {
    let list = member(object, name)?.list().ok_or_else(|| format!("`{name}` is not a list"))?;
    list.iter()
        .map(Tree::index)
        .collect::<Option<_>>()
        .ok_or_else(|| format!("`{name}` holds something else than indices"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::json::{MAX_VALUES, read};

    fn verdict(question: &str, answer: &str) -> Verdict {
        let tree = |text: &str| read(text.as_bytes(), MAX_VALUES).expect("the test's lines are JSON");
        check(&tree(question), &tree(answer))
    }

    const QUESTION: &str = r#"{"id":"t","kind":"min_area","input":{"points":[[0,0],[2,0],[0,2]]}}"#;

    #[test]
    fn an_answer_is_read_and_proved() {
        let answer = r#"{"id":"t","kind":"min_area","method":"m","result":{"area":4,"center":[1,1],"generators":[[1,0],[0,1]],
            "lower_bound":4,"certificate":{"hull":[0,1,2],"farthest":[2,0,1],"coefficients":[0,-1,0],"basis":[0,2]}}}"#;
        assert!(matches!(verdict(QUESTION, answer), Verdict::Right(_)));
        let other = answer.replace("\"t\"", "\"s\"");
        assert_eq!(verdict(QUESTION, &other), Verdict::Wrong("the id is not the question's".into()));
        let partial = answer.replace("\"basis\"", "\"base\"");
        assert_eq!(verdict(QUESTION, &partial), Verdict::Wrong("`basis` is missing".into()));
    }

    #[test]
    fn refusals_and_unknown_kinds_are_not_judged() {
        let refusal = r#"{"id":"t","kind":"min_area","error":{"code":"too_large","message":"m"}}"#;
        assert_eq!(verdict(QUESTION, refusal), Verdict::Unchecked("refused: too_large: m".into()));
        let line = r#"{"id":"t","kind":"gauge","input":{},"result":{}}"#;
        assert!(matches!(verdict(line, line), Verdict::Unchecked(_)));
    }
}
