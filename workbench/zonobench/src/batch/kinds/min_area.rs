//! `min_area`: the zonogon of least area that contains points of the plane.

use zonotope::enclosing::min_area_zonogon::MinAreaError;
use zonotope::hull::HullError;
use zonotope::lad::Method;

use super::{Kind, Solution};
use crate::batch::fields::Fields;
use crate::batch::refusal::{Code, Refusal};
use crate::enclosure::Enclosure;

pub(super) const KIND: Kind = Kind {
    name: "min_area",
    summary: "the zonogon of least area that contains points of the plane",
    fields: &["points"],
    methods: || {
        let default = Method::default();
        let others = Method::FAST.into_iter().filter(|&method| method != default);
        std::iter::once(default).chain(others).map(Method::id).collect()
    },
    solve,
};

fn solve(fields: &Fields<'_>, method: Option<&'static str>, seed: u64) -> Result<Solution, Refusal> {
    let points = fields.vectors::<2>("points")?;
    let named = |name| Method::from_id(name).expect("the kind lists the names of these methods");
    let method = method.map_or(Method::default(), named);
    let enclosure = Enclosure::of(&points, method, seed).map_err(|error| {
        let code = match error {
            MinAreaError::Points(HullError::Empty) => Code::Empty,
            _ => Code::TooLarge,
        };
        Refusal::new(code, error.to_string())
    })?;
    Ok(Solution { method: method.id(), result: enclosure.result() })
}
