//! `upper_hull`: how high a zonotope around the origin reaches over a point of the plane.

use serde_json::json;
use zonotope::collision::upper_hull::{Height, HeightError, brute_force, by_kernel, by_slope_selection};

use super::{Kind, Solution};
use crate::batch::fields::Fields;
use crate::batch::refusal::{Code, Refusal};

pub(super) const KIND: Kind = Kind {
    name: "upper_hull",
    summary: "the exact height of the upper hull of a zonotope in space over a point of the plane",
    fields: &["generators", "p0"],
    methods: || vec![BY_KERNEL, BY_SLOPE_SELECTION, BRUTE_FORCE],
    solve,
};

const BY_KERNEL: &str = "by_kernel";
const BY_SLOPE_SELECTION: &str = "by_slope_selection";
const BRUTE_FORCE: &str = "brute_force";

/// Brute force goes through all pairs of so many generators at most.
const MOST_PAIRED: usize = 100;

fn solve(fields: &Fields<'_>, method: Option<&'static str>, seed: u64) -> Result<Solution, Refusal> {
    let generators = fields.vectors::<3>("generators")?;
    let p0 = fields.vector::<2>("p0")?;
    let method = method.unwrap_or(BY_KERNEL);
    let height: Result<Height, HeightError> = match method {
        BRUTE_FORCE if generators.len() > MOST_PAIRED => {
            let message = format!("{} generators, at most {MOST_PAIRED} are taken by `{method}`", generators.len());
            return Err(Refusal::new(Code::TooLarge, message));
        }
        BRUTE_FORCE => brute_force::height(&generators, p0),
        BY_SLOPE_SELECTION => by_slope_selection::height(&generators, p0, seed),
        _ => by_kernel::height(&generators, p0),
    };
    let result = match height.expect("the numbers of a question are finite, and few enough") {
        Height::OverQ(z) => json!({"above_q": true, "z": z.to_string()}),
        Height::BesideQ(_) => json!({"above_q": false, "z": null}),
    };
    Ok(Solution { method, result })
}
