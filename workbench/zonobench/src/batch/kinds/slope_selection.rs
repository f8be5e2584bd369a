//! `slope_selection`: the abscissas of the k-th leftmost vertices of the arrangement that is dual to generators.

use serde_json::json;
use zonotope::arrangement::LineArrangement;
use zonotope::arrangement::slope_selection::{SlopeSelectionError, brute_force, kth_leftmost_vertex};

use super::{Kind, Solution};
use crate::batch::fields::Fields;
use crate::batch::refusal::{Code, Refusal};

pub(super) const KIND: Kind = Kind {
    name: "slope_selection",
    summary: "the exact abscissas of the k-th leftmost vertices of the arrangement that is dual to generators in space",
    fields: &["generators", "k"],
    methods: || vec![RANDOMIZED, BRUTE_FORCE],
    solve,
};

const RANDOMIZED: &str = "randomized";
const BRUTE_FORCE: &str = "brute_force";

/// Brute force lists all pairs of so many lines at most.
const MOST_LINES_LISTED: usize = 1500;

fn solve(fields: &Fields<'_>, method: Option<&'static str>, seed: u64) -> Result<Solution, Refusal> {
    let generators = fields.vectors::<3>("generators")?;
    let ranks = fields.ranks("k")?;
    let arrangement = LineArrangement::from_rows(&generators)
        .expect("the numbers of a question are finite, and an index can name its generators");
    let method = method.unwrap_or(RANDOMIZED);
    let vertex_count = arrangement.vertex_count();
    if let Some((place, rank)) = (1..).zip(&ranks).find(|(_, rank)| **rank > vertex_count) {
        let message = format!("k, entry {place} is {rank}, but there are {vertex_count} vertices");
        return Err(Refusal::bad_input(message));
    }
    let found: Result<Vec<String>, SlopeSelectionError> = if method == BRUTE_FORCE {
        if generators.len() > MOST_LINES_LISTED {
            let count = generators.len();
            let message = format!("{count} generators, at most {MOST_LINES_LISTED} are taken by `{BRUTE_FORCE}`");
            return Err(Refusal::new(Code::TooLarge, message));
        }
        let vertices = brute_force::vertices(&arrangement);
        Ok(ranks.iter().map(|&rank| vertices[rank as usize - 1].exact_x().to_string()).collect())
    } else {
        let x = |&rank| kth_leftmost_vertex(&arrangement, rank, seed).map(|vertex| vertex.exact_x().to_string());
        ranks.iter().map(x).collect()
    };
    let x = found.expect("every rank was compared with the number of vertices");
    Ok(Solution { method, result: json!({"x": x}) })
}
