//! `separator`: the monotone chain through the tiling of Q with so many tiles on its left.

use serde_json::{Value, json};
use zonotope::arrangement::DualArrangement;
use zonotope::arrangement::separator::{Method, SeparatorError};

use crate::claimed::{Traced, exact_numbers, index, member, vectors};
use crate::fields::Fields;
use crate::kinds::{Kind, Solution};
use crate::refusal::{Code, Refusal};

pub(in crate::kinds) const KIND: Kind = Kind {
    name: "separator",
    summary: "the chain from the top to the bottom of the projected upper hull with k tiles on its left, exactly",
    fields: &["generators", "k"],
    optional: &[],
    methods: || Method::ALL.map(Method::id).to_vec(),
    solve,
    check,
};

/// The most lines of which brute force lists all pairs.
const LISTED_LINE_LIMIT: usize = 1500;

fn solve(fields: &Fields<'_>, method: Option<&'static str>, seed: u64) -> Result<Solution, Refusal> {
    let generators = fields.vectors::<3>("generators")?;
    let k = fields.count("k")?;
    let dual = DualArrangement::new(&generators).expect("the numbers of a question are finite, and few enough");
    let method = method.and_then(Method::from_id).unwrap_or_default();
    if method == Method::BruteForce {
        refuse_many_lines(generators.len(), method.id())?;
    }
    let separator = method.separator(&dual, k, seed).map_err(counted_from_one)?;
    let point = |[x, y]: &[_; 2]| json!([ToString::to_string(x), ToString::to_string(y)]);
    let chain: Vec<Value> = separator.rational_points().iter().map(point).collect();
    Ok(Solution { method: method.id(), result: json!({"chain": chain}) })
}

/// The refusal, with generators as people count them.
fn counted_from_one(error: SeparatorError) -> Refusal {
    Refusal::bad_input(match error {
        SeparatorError::Coplanar { k, generators } => {
            let numbers: Vec<String> = generators.iter().map(|i| (i + 1).to_string()).collect();
            format!(
                "{k} tiles end within a facet: generators {} are coplanar, not in general position",
                numbers.join(", ")
            )
        }
        other => other.to_string(),
    })
}

/// Refuses a method where it would take a quadratic amount of memory.
pub(super) fn refuse_many_lines(count: usize, method: &str) -> Result<(), Refusal> {
    if count <= LISTED_LINE_LIMIT {
        return Ok(());
    }
    let message = format!("{count} generators, at most {LISTED_LINE_LIMIT} are taken by `{method}`");
    Err(Refusal::new(Code::TooLarge, message))
}

fn check(input: Traced<'_>, result: Traced<'_>, _method: Option<&str>) -> Result<verifier::Verdict, String> {
    let generators = vectors(member(input, "generators")?, "generators")?;
    let chain = member(result, "chain")?.elements().ok_or("`chain` is not a list")?;
    let point = |point: Traced<'_>| <[_; 2]>::try_from(exact_numbers(point)?).ok();
    let chain: Vec<_> =
        chain.map(point).collect::<Option<_>>().ok_or("`chain` holds something else than exact points")?;
    let k = index(input, "k")? as u64;
    Ok(verifier::check_separator(&generators, k, &chain).in_words())
}
