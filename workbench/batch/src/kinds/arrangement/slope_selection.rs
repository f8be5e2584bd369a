//! `slope_selection`: the abscissas of the k-th leftmost vertices of the arrangement that is dual to generators.

use serde_json::json;
use zonotope::arrangement::DualArrangement;
use zonotope::arrangement::slope_selection::Method;

use super::separator::refuse_many_lines;
use crate::claimed::{Traced, fractions, indices, member, vectors};
use crate::fields::Fields;
use crate::kinds::{Kind, Solution};
use crate::refusal::Refusal;

pub(in crate::kinds) const KIND: Kind = Kind {
    name: "slope_selection",
    summary: "the exact abscissas of the k-th leftmost vertices of the arrangement that is dual to generators in space",
    fields: &["generators", "k"],
    optional: &[],
    methods: || Method::ALL.map(Method::id).to_vec(),
    solve,
    check,
};

fn solve(fields: &Fields<'_>, method: Option<&'static str>, seed: u64) -> Result<Solution, Refusal> {
    let generators = fields.vectors::<3>("generators")?;
    let ranks = fields.ranks("k")?;
    let dual = DualArrangement::new(&generators).expect("the numbers of a question are finite, and few enough");
    let method = method.and_then(Method::from_id).unwrap_or_default();
    let vertex_count = dual.lines().vertex_count();
    if let Some((place, rank)) = (1..).zip(&ranks).find(|(_, rank)| **rank > vertex_count) {
        let message = format!("k, entry {place} is {rank}, but there are {vertex_count} vertices");
        return Err(Refusal::bad_input(message));
    }
    if method == Method::BruteForce {
        refuse_many_lines(generators.len(), method.id())?;
    }
    let vertices = method.vertices(dual.lines(), &ranks, seed);
    let vertices = vertices.expect("every rank was compared with the number of vertices");
    let x: Vec<String> = vertices.iter().map(|vertex| vertex.exact_x().to_string()).collect();
    Ok(Solution { method: method.id(), result: json!({"x": x}) })
}

fn check(input: Traced<'_>, result: Traced<'_>, _method: Option<&str>) -> Result<verifier::Verdict, String> {
    let generators = vectors(member(input, "generators")?, "generators")?;
    let ranks: Vec<u64> = indices(input, "k")?.into_iter().map(|rank| rank as u64).collect();
    Ok(verifier::check_slope_selection(&generators, &ranks, &fractions(result, "x")?).in_words())
}
