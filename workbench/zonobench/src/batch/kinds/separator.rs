//! `separator`: the monotone chain through the tiling of Q with so many tiles on its left.

use serde_json::{Value, json};
use zonotope::arrangement::DualArrangement;
use zonotope::arrangement::separator::{SeparatorError, brute_force, by_slope_selection};

use super::{Kind, Solution};
use crate::batch::fields::Fields;
use crate::batch::refusal::{Code, Refusal};

pub(super) const KIND: Kind = Kind {
    name: "separator",
    summary: "the chain from the top to the bottom of the projected upper hull with k tiles on its left, exactly",
    fields: &["generators", "k"],
    methods: || vec![BY_SLOPE_SELECTION, BRUTE_FORCE],
    solve,
};

const BY_SLOPE_SELECTION: &str = "by_slope_selection";
const BRUTE_FORCE: &str = "brute_force";

/// Brute force lists all pairs of so many lines at most.
pub(super) const MOST_LINES_LISTED: usize = 1500;

fn solve(fields: &Fields<'_>, method: Option<&'static str>, seed: u64) -> Result<Solution, Refusal> {
    let generators = fields.vectors::<3>("generators")?;
    let k = fields.count("k")?;
    let dual = DualArrangement::new(&generators).expect("the numbers of a question are finite, and few enough");
    let method = method.unwrap_or(BY_SLOPE_SELECTION);
    let separator = if method == BRUTE_FORCE {
        refuse_many_lines(generators.len())?;
        brute_force::separator(&dual, k)
    } else {
        by_slope_selection::separator(&dual, k, seed)
    };
    let separator = separator.map_err(counted_from_one)?;
    let point = |[x, y]: &[_; 2]| json!([ToString::to_string(x), ToString::to_string(y)]);
    let chain: Vec<Value> = separator.rational_points().iter().map(point).collect();
    Ok(Solution { method, result: json!({"chain": chain}) })
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

/// Refuses brute force where it would take a quadratic amount of memory.
pub(super) fn refuse_many_lines(count: usize) -> Result<(), Refusal> {
    if count <= MOST_LINES_LISTED {
        return Ok(());
    }
    let message = format!("{count} generators, at most {MOST_LINES_LISTED} are taken by `{BRUTE_FORCE}`");
    Err(Refusal::new(Code::TooLarge, message))
}
