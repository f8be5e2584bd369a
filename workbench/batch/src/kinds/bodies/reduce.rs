//! `reduce` and `approx`: a zonotope of few generators around a zonotope.

use serde_json::{Value, json};
use zonotope::reduction::by_patches::patches_within;
use zonotope::reduction::{Containment, Method, Problem, Reduced, ReductionError, Share, Shares};
use zonotope::zonotope::Zonotope;

use crate::claimed::{Placed, Traced, boolean, float, index, indices, member, vector, vectors};
use crate::dimension::in_dimension;
use crate::fields::Fields;
use crate::json::Tree;
use crate::json::{to_json, vector_to_json};
use crate::kinds::{Kind, Solution};
use crate::nearest::did_you_mean;
use crate::refusal::{Code, Refusal};

pub(in crate::kinds) const REDUCE: Kind = Kind {
    name: "reduce",
    summary: "a zonotope of at most so many generators around a zonotope, by a rule",
    fields: &["center", "generators", "count", "rule"],
    optional: &["pose"],
    methods: || Method::ALL.map(Method::id).to_vec(),
    solve: reduce,
    check: check_reduce,
};

pub(in crate::kinds) const APPROX: Kind = Kind {
    name: "approx",
    summary: "a zonotope around one at the origin, within a part epsilon of its diameter (Lemma 5.5)",
    fields: &["generators", "epsilon"],
    optional: &[],
    methods: || vec![Method::Patches.id()],
    solve: approx,
    check: check_approx,
};

/// The bounds of a distance differ by at most this part of the lower one, where the search for them allows it.
const HAUSDORFF_WIDTH: f64 = 0.01;

/// The most generators that a rule takes.
const GENERATOR_LIMIT: usize = 200_000;

/// The most that Scott's rule takes, whose time grows with the square of their number, and the best of all rules.
const SLOW_RULE_LIMIT: usize = 2_000;

fn reduce(fields: &Fields<'_>, method: Option<&'static str>, _seed: u64) -> Result<Solution, Refusal> {
    let rule = fields.text("rule")?;
    let Some(rule) = Method::from_id(rule) else {
        let known = Method::ALL.map(Method::id).join(", ");
        let near = did_you_mean(rule, Method::ALL.map(Method::id));
        return Err(Refusal::bad_input(format!("`rule` is \"{rule}\", not one of {known}{near}")));
    };
    if let Some(other) = method.filter(|name| *name != rule.id()) {
        let message = format!("the method `{other}` is not the rule `{}` of the input", rule.id());
        return Err(Refusal::new(Code::UnknownMethod, message));
    }
    let count = usize::try_from(fields.count("count")?).unwrap_or(usize::MAX);
    let result = in_dimension!(fields.dimension("center")?, "center", reduced(fields, rule, count))?;
    Ok(Solution { method: rule.id(), result })
}

fn reduced<const D: usize>(fields: &Fields<'_>, rule: Method, count: usize) -> Result<Value, Refusal> {
    let body = fields.image::<D>()?;
    let is_slow = matches!(rule, Method::Scott | Method::Best);
    refuse_many(body.generators().len(), if is_slow { SLOW_RULE_LIMIT } else { GENERATOR_LIMIT }, rule)?;
    let problem = Problem::new(&body, count).map_err(refusal)?;
    Ok(result(&body, &rule.reduce(&problem).map_err(refusal)?))
}

fn approx(fields: &Fields<'_>, _method: Option<&'static str>, _seed: u64) -> Result<Solution, Refusal> {
    let dimension = fields.dimension_of_first("generators")?.unwrap_or(3);
    let result = in_dimension!(dimension, "generator 1", approximated(fields))?;
    Ok(Solution { method: Method::Patches.id(), result })
}

fn approximated<const D: usize>(fields: &Fields<'_>) -> Result<Value, Refusal> {
    let generators = fields.vectors::<D>("generators")?;
    let epsilon = fields.number("epsilon")?;
    refuse_many(generators.len(), GENERATOR_LIMIT, Method::Patches)?;
    let body = Zonotope::new([0.0; D], generators).expect("the numbers of a question are finite");
    Ok(result(&body, &patches_within(&body, epsilon, &mut ()).map_err(refusal)?))
}

fn refuse_many(generators: usize, most: usize, rule: Method) -> Result<(), Refusal> {
    if generators <= most {
        return Ok(());
    }
    let message = format!("{generators} generators, at most {most} are taken by `{}`", rule.id());
    Err(Refusal::new(Code::TooLarge, message))
}

fn refusal(error: ReductionError) -> Refusal {
    let code = match error {
        ReductionError::TooFew { .. } => Code::BadInput,
        ReductionError::BadEpsilon(_) => Code::BadEpsilon,
        _ => Code::TooLarge,
    };
    Refusal::new(code, error.to_string())
}

fn result<const D: usize>(body: &Zonotope<D>, reduced: &Reduced<D>) -> Value {
    let distance = reduced.distance(body, HAUSDORFF_WIDTH);
    json!({
        "center": vector_to_json(&reduced.body.center()),
        "generators": reduced.body.generators().iter().map(|g| vector_to_json(g)).collect::<Value>(),
        "hausdorff": {
            "lower": to_json(distance.lower),
            "upper": to_json(distance.upper),
            "direction": vector_to_json(&distance.direction),
        },
        "certificate": certificate(&reduced.proof),
    })
}

/// Why the body is contained.
fn certificate(proof: &Containment) -> Value {
    match proof {
        Containment::Shares(Shares { shares, frame }) => {
            let share = |share: &Option<Share>| {
                share.map_or(Value::Null, |share| json!([share.generator, to_json(share.coefficient)]))
            };
            json!({"shares": shares.iter().map(share).collect::<Value>(), "frame": frame})
        }
        _ => json!({"facet_normals": true}),
    }
}

fn check_reduce(input: Traced<'_>, result: Traced<'_>, _method: Option<&str>) -> Result<verifier::Verdict, String> {
    let (center, generators) = Placed::read(input, "center")?.image()?;
    let question = verifier::Reduction { center, generators, count: Some(index(input, "count")?), epsilon: None };
    checked(&question, result)
}

fn check_approx(input: Traced<'_>, result: Traced<'_>, _method: Option<&str>) -> Result<verifier::Verdict, String> {
    let generators = vectors(member(input, "generators")?, "generators")?;
    let center = vec![0.0; generators.first().map_or(3, Vec::len)];
    checked(&verifier::Reduction { center, generators, count: None, epsilon: Some(float(input, "epsilon")?) }, result)
}

fn checked(question: &verifier::Reduction, result: Traced<'_>) -> Result<verifier::Verdict, String> {
    let (certificate, distance) = (member(result, "certificate")?, member(result, "hausdorff")?);
    let answer = verifier::ReductionAnswer {
        center: vector(member(result, "center")?, "center")?,
        generators: vectors(member(result, "generators")?, "generators")?,
        bounds: [float(distance, "lower")?, float(distance, "upper")?],
        direction: vector(member(distance, "direction")?, "direction")?,
        shares: claimed_shares(certificate)?,
    };
    Ok(verifier::check_reduction(question, &answer))
}

/// The shares, or nothing where every facet normal is to be tried: the certificate says which of them.
fn claimed_shares(certificate: Traced<'_>) -> Result<Option<verifier::Shares>, String> {
    if let Some(list) = certificate.field("shares") {
        return listed_shares(list, certificate).map(Some);
    }
    match certificate.field("facet_normals").map(|_| boolean(certificate, "facet_normals")).transpose()? {
        Some(true) => Ok(None),
        Some(false) | None => Err("certificate: there are neither `shares` nor `facet_normals`".to_owned()),
    }
}

fn listed_shares(list: Traced<'_>, certificate: Traced<'_>) -> Result<verifier::Shares, String> {
    let share = |tree: &Tree| match (tree, tree.list()) {
        (Tree::Null, _) => Ok(None),
        (_, Some([generator, coefficient])) => match (generator.index(), coefficient.float()) {
            (Some(generator), Some(coefficient)) => Ok(Some((generator, coefficient))),
            _ => Err("a share is no index with a coefficient".to_owned()),
        },
        _ => Err("a share is neither a pair nor null".to_owned()),
    };
    let list = list.tree.list().ok_or("`shares` is not a list")?;
    Ok(verifier::Shares {
        shares: list.iter().map(share).collect::<Result<_, _>>()?,
        frame: indices(certificate, "frame")?,
    })
}
