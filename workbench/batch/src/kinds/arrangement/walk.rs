//! `walk`: the facets that have an edge in common with a facet.

use serde_json::{Value, json};
use zonotope::arrangement::facet_walk::{FacetName, GeneralPositionError, Method, NormalSense, adjacent_facets};

use crate::claimed::{Traced, member, vectors};
use crate::fields::Fields;
use crate::json::Tree;
use crate::kinds::{Kind, Solution};
use crate::refusal::Refusal;

pub(in crate::kinds) const KIND: Kind = Kind {
    name: "walk",
    summary: "the four facets that have an edge in common with a facet of generators in general position",
    fields: &["generators", "facet"],
    optional: &[],
    methods: || vec![Method::ByScan.id()],
    solve,
    check,
};

fn solve(fields: &Fields<'_>, _method: Option<&'static str>, _seed: u64) -> Result<Solution, Refusal> {
    let generators = fields.vectors::<3>("generators")?;
    let facet = fields.vector::<3>("facet")?;
    let [Some(first), Some(second)] = [facet[0], facet[1]].map(index) else {
        return Err(Refusal::bad_input("facet has an index that is not a whole number from 0"));
    };
    let sign = [-1, 1].into_iter().find(|sign| *sign as f64 == facet[2]).and_then(NormalSense::from_sign);
    let sense = sign.ok_or_else(|| Refusal::bad_input("facet, coordinate 3 is neither 1 nor -1"))?;
    let found = adjacent_facets(&generators, FacetName::new(first, second, sense)).map_err(counted_from_one)?;
    let triple = |facet: &FacetName| json!([facet.first, facet.second, facet.normal.sign()]);
    Ok(Solution {
        method: Method::ByScan.id(),
        result: json!({"neighbours": found.iter().map(triple).collect::<Value>()}),
    })
}

fn index(number: f64) -> Option<usize> {
    let is_index = number >= 0.0 && number.fract() == 0.0 && number <= f64::from(u32::MAX);
    is_index.then_some(number as usize)
}

/// The refusal, with generators as people count them where they are not those of the facet's name.
fn counted_from_one(error: GeneralPositionError) -> Refusal {
    Refusal::bad_input(match error {
        GeneralPositionError::Zero { generator } => {
            format!("generator {} is zero, not in general position", generator + 1)
        }
        GeneralPositionError::Parallel { generators: [a, b] } => {
            format!("generators {} and {} are parallel, not in general position", a + 1, b + 1)
        }
        GeneralPositionError::Coplanar { generators: [a, b, c] } => {
            format!("generators {}, {} and {} are coplanar, not in general position", a + 1, b + 1, c + 1)
        }
        other => other.to_string(),
    })
}

fn check(input: Traced<'_>, result: Traced<'_>, _method: Option<&str>) -> Result<verifier::Verdict, String> {
    let generators = vectors(member(input, "generators")?, "generators")?;
    let triple = |tree: &Tree| -> Option<verifier::FacetTriple> {
        let [first, second, sign] = tree.list()? else { return None };
        let sign = [-1, 1].into_iter().find(|candidate| Some(*candidate as f64) == sign.float())?;
        Some((first.index()?, second.index()?, sign))
    };
    let facet = triple(member(input, "facet")?.tree).ok_or("`facet` is no facet")?;
    let list = member(result, "neighbours")?.tree.list().ok_or("`neighbours` is not a list")?;
    let neighbours: Vec<verifier::FacetTriple> =
        list.iter().map(triple).collect::<Option<_>>().ok_or("a neighbour is no facet")?;
    Ok(verifier::check_walk(&generators, facet, &neighbours).in_words())
}
