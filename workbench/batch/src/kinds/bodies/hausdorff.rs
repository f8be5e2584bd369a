//! `hausdorff`: the Hausdorff distance of two zonotopes, and whether one contains the other.

use serde_json::json;
use zonotope::reduction::contains;
use zonotope::reduction::hausdorff::Distance;
use zonotope::reduction::hausdorff::by_branch_and_bound::hausdorff_by_cones;
use zonotope::reduction::hausdorff::by_vertices::{excess_at_vertices, hausdorff_at_vertices};
use zonotope::zonotope::Zonotope;

use crate::claimed::{Placed, Traced, boolean, float, member, vector};
use crate::dimension::in_dimension;
use crate::fields::Fields;
use crate::json::{to_json, vector_to_json};
use crate::kinds::{BODY, PLACED};
use crate::kinds::{Kind, Solution};
use crate::refusal::{Code, Refusal};

pub(in crate::kinds) const KIND: Kind = Kind {
    name: "hausdorff",
    summary: "the Hausdorff distance of two zonotopes between two bounds, and whether the second contains the first",
    fields: &["a", "b"],
    optional: &[],
    methods: || vec![AT_VERTICES, BY_CONES],
    solve,
    check,
};

/// The method that rounds the distance once, the default for bodies of few vertices.
const AT_VERTICES: &str = "by_vertices";

/// The method that answers by default if there are more.
const BY_CONES: &str = "by_branch_and_bound";

/// The bounds of [`BY_CONES`] differ by at most this part of the lower one, where the search for them allows it.
const WIDTH: f64 = 0.01;

/// The most generators of both bodies.
const GENERATOR_LIMIT: usize = 200_000;

fn solve(fields: &Fields<'_>, method: Option<&'static str>, _seed: u64) -> Result<Solution, Refusal> {
    let bodies = [fields.object("a", &BODY, &PLACED)?, fields.object("b", &BODY, &PLACED)?];
    in_dimension!(bodies[0].dimension("center")?, "the center of a", in_space(&bodies, method))
}

fn in_space<const D: usize>(bodies: &[Fields<'_>; 2], method: Option<&'static str>) -> Result<Solution, Refusal> {
    let [a, b] = [bodies[0].image::<D>()?, bodies[1].image::<D>()?];
    let generators = a.generators().len() + b.generators().len();
    if generators > GENERATOR_LIMIT {
        let message = format!("{generators} generators, at most {GENERATOR_LIMIT} are taken");
        return Err(Refusal::new(Code::TooLarge, message));
    }
    // a lies in b if no vertex of it is off b
    let by_vertices = excess_at_vertices(&a, &b).map(|excess| excess.upper == 0.0);
    let Some(is_subset) = by_vertices.or_else(|| contains(&b, &a)) else {
        return Err(Refusal::new(Code::TooLarge, "b has too many facets to tell whether it contains a"));
    };
    let (method, distance) = distance(&a, &b, method)?;
    let result = json!({
        "value": to_json(distance.value),
        "lower": to_json(distance.lower),
        "upper": to_json(distance.upper),
        "direction": vector_to_json(&distance.direction),
        "a_subset_b": is_subset,
    });
    Ok(Solution { method, result })
}

/// The distance and the method that found it: the one that was asked for, or the first that can.
fn distance<const D: usize>(
    a: &Zonotope<D>,
    b: &Zonotope<D>,
    method: Option<&'static str>,
) -> Result<(&'static str, Distance<D>), Refusal> {
    let by_cones = || (BY_CONES, hausdorff_by_cones(a, b, WIDTH));
    if method == Some(BY_CONES) {
        return Ok(by_cones());
    }
    match (hausdorff_at_vertices(a, b), method) {
        (Some(distance), _) => Ok((AT_VERTICES, distance)),
        (None, None) => Ok(by_cones()),
        (None, Some(_)) => {
            Err(Refusal::new(Code::TooLarge, format!("the bodies have too many vertices for `{AT_VERTICES}`")))
        }
    }
}

fn check(input: Traced<'_>, result: Traced<'_>, _method: Option<&str>) -> Result<verifier::Verdict, String> {
    let body = |name| Placed::read(member(input, name)?, "center")?.image();
    let (a, b) = (body("a")?, body("b")?);
    let answer = verifier::HausdorffAnswer {
        value: float(result, "value")?,
        bounds: [float(result, "lower")?, float(result, "upper")?],
        direction: vector(member(result, "direction")?, "direction")?,
        is_subset: boolean(result, "a_subset_b")?,
    };
    Ok(verifier::check_hausdorff((&a.0, &a.1), (&b.0, &b.1), &answer))
}
