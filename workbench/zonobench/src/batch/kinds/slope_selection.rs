//! `slope_selection`: the abscissas of the k-th leftmost vertices of the arrangement that is dual to generators.

use serde_json::json;
use zonotope::arrangement::DualArrangement;
use zonotope::arrangement::slope_selection::{brute_force, kth_leftmost_vertices};

use super::separator::refuse_many_lines;
use super::{Kind, Solution};
use crate::batch::fields::Fields;
use crate::batch::refusal::Refusal;

pub(super) const KIND: Kind = Kind {
    name: "slope_selection",
    summary: "the exact abscissas of the k-th leftmost vertices of the arrangement that is dual to generators in space",
    fields: &["generators", "k"],
    methods: || vec![RANDOMIZED, BRUTE_FORCE],
    solve,
};

const RANDOMIZED: &str = "randomized";
const BRUTE_FORCE: &str = "brute_force";

fn solve(fields: &Fields<'_>, method: Option<&'static str>, seed: u64) -> Result<Solution, Refusal> {
    let generators = fields.vectors::<3>("generators")?;
    let ranks = fields.ranks("k")?;
    let dual = DualArrangement::new(&generators).expect("the numbers of a question are finite, and few enough");
    let method = method.unwrap_or(RANDOMIZED);
    let vertex_count = dual.lines().vertex_count();
    if let Some((place, rank)) = (1..).zip(&ranks).find(|(_, rank)| **rank > vertex_count) {
        let message = format!("k, entry {place} is {rank}, but there are {vertex_count} vertices");
        return Err(Refusal::bad_input(message));
    }
    let x: Vec<String> = if method == BRUTE_FORCE {
        refuse_many_lines(generators.len())?;
        let vertices = brute_force::vertices(dual.lines());
        ranks.iter().map(|&rank| vertices[rank as usize - 1].exact_x().to_string()).collect()
    } else {
        let vertices = kth_leftmost_vertices(dual.lines(), &ranks, seed);
        let vertices = vertices.expect("every rank was compared with the number of vertices");
        vertices.iter().map(|vertex| vertex.exact_x().to_string()).collect()
    };
    Ok(Solution { method, result: json!({"x": x}) })
}
