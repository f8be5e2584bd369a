//! `upper_hull`: how high a zonotope around the origin reaches over a point of the plane.

use serde_json::json;
use zonotope::collision::upper_hull::{Height, Method};

use crate::claimed::{Traced, boolean, member, vector, vectors};
use crate::fields::Fields;
use crate::json::Tree;
use crate::kinds::{Kind, Solution};
use crate::refusal::{Code, Refusal};

pub(in crate::kinds) const KIND: Kind = Kind {
    name: "upper_hull",
    summary: "the exact height of the upper hull of a zonotope in space over a point of the plane",
    fields: &["generators", "p0"],
    optional: &[],
    methods: || Method::ALL.map(Method::id).to_vec(),
    solve,
    check,
};

/// The most generators of which brute force goes through all pairs.
const PAIRED_GENERATOR_LIMIT: usize = 100;

fn solve(fields: &Fields<'_>, method: Option<&'static str>, seed: u64) -> Result<Solution, Refusal> {
    let generators = fields.vectors::<3>("generators")?;
    let p0 = fields.vector::<2>("p0")?;
    let method = method.and_then(Method::from_id).unwrap_or_default();
    let count = generators.len();
    if method == Method::BruteForce && count > PAIRED_GENERATOR_LIMIT {
        let name = method.id();
        let message = format!("{count} generators, at most {PAIRED_GENERATOR_LIMIT} are taken by `{name}`");
        return Err(Refusal::new(Code::TooLarge, message));
    }
    let height = method.height(&generators, p0, seed);
    let result = match height.expect("the numbers of a question are finite, and few enough") {
        Height::OverQ(z) => json!({"above_q": true, "z": z.to_string()}),
        Height::BesideQ(_) => json!({"above_q": false, "z": null}),
    };
    Ok(Solution { method: method.id(), result })
}

fn check(input: Traced<'_>, result: Traced<'_>, _method: Option<&str>) -> Result<verifier::Verdict, String> {
    let generators = vectors(member(input, "generators")?, "generators")?;
    let p0 = <[f64; 2]>::try_from(vector(member(input, "p0")?, "p0")?).map_err(|_| "p0 is not a point of the plane")?;
    let z = match member(result, "z")?.tree {
        Tree::Null => None,
        value => {
            Some(value.text().and_then(verifier::Fraction::parse).ok_or("`z` is neither an exact number nor null")?)
        }
    };
    Ok(verifier::check_upper_hull(&generators, p0, boolean(result, "above_q")?, z.as_ref()).in_words())
}
