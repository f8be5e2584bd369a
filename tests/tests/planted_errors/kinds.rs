//! The kinds of question by what the tests must know of their answers: one row each.

use dashu_ratio::RBig;
use serde_json::Value;

use crate::bounds::{self, Known};
use crate::fields::{has, is_location, of_distance, of_first_contact, of_forces, of_location};
use crate::judges::{SMALLEST, farthest, is_same, placed, proves, same_fields, same_figure, steps};
use crate::moving::{encounters, sweeps};
use crate::rationals::{minus, vector, vectors};
use crate::{enclosures, meshes, moving, proximity};

/// A right answer with one that was changed.
struct Pair<'a> {
    kind: &'static str,
    input: &'a Value,
    right: &'a Value,
    changed: &'a Value,
}

/// The judgement on a pair: two conditions, of which both must hold; `None` where something cannot be read.
type Judged = Option<(bool, bool)>;

/// A kind of question with the fields of its results, by their status, and the judge of changed results.
struct Row {
    kind: &'static str,
    has_fields: fn(&Value) -> bool,
    judge: fn(&Pair<'_>, &mut Option<Known>) -> Judged,
}

const ROWS: [Row; 21] = [
    Row {
        kind: "member",
        has_fields: |result| has(result, &["member", "status", "certificate"]) && of_location(result),
        judge: |pair, _| member(pair),
    },
    Row {
        kind: "intersect",
        has_fields: |result| has(result, &["intersects", "status", "certificate"]) && of_location(result),
        judge: |pair, _| intersect(pair),
    },
    Row {
        kind: "gauge",
        has_fields: |result| {
            has(result, &["gauge", "at_most_one", "certificate"]) && is_location(&result["certificate"])
        },
        judge: |pair, _| gauge(pair),
    },
    Row {
        kind: "distance",
        has_fields: of_distance,
        judge: |pair, _| proximity::judged(pair.input, pair.right, pair.changed),
    },
    Row {
        kind: "collide",
        has_fields: |result| match result["certificate"].get("order") {
            Some(_) => moving::meshes::has_its_fields(result),
            None => of_first_contact(result),
        },
        judge: |pair, _| match pair.input["a"].get("triangles") {
            Some(_) => moving::meshes::judged(pair.input, pair.changed),
            None => encounters::judged(pair.input, pair.changed),
        },
    },
    Row { kind: "mesh", has_fields: meshes::has_its_fields, judge: |pair, _| meshes::judged(pair.input, pair.changed) },
    Row {
        kind: "mesh_level",
        has_fields: meshes::nodes_have_their_fields,
        judge: |pair, _| meshes::nodes_judged(pair.input, pair.changed),
    },
    Row {
        kind: "sweep",
        has_fields: |result| has(result, &["center", "generators"]),
        judge: |pair, _| sweeps::are_held(pair.input, pair.right).zip(sweeps::are_held(pair.input, pair.changed)),
    },
    Row { kind: "approx", has_fields: of_enclosing, judge: enclosing },
    Row { kind: "reduce", has_fields: of_enclosing, judge: enclosing },
    Row {
        kind: "hausdorff",
        has_fields: |result| has(result, &["value", "lower", "upper", "direction", "a_subset_b"]),
        judge: |pair, known| bounds::of_two_bodies(pair.input, pair.right, pair.changed, known),
    },
    Row {
        kind: "member_batch",
        has_fields: |result| has(result, &["status", "gauge", "build", "query"]),
        judge: |pair, _| member_batch(pair),
    },
    Row {
        kind: "support",
        has_fields: |result| has(result, &["value", "point"]),
        judge: |pair, _| Some(true).zip(farthest(pair.input, pair.changed)),
    },
    Row {
        kind: "combinatorics",
        has_fields: |result| has(result, &["affine_dim", "vertices", "edges", "facets", "facet_sizes", "measure"]),
        judge: unchanged,
    },
    Row { kind: "slope_selection", has_fields: |result| has(result, &["x"]), judge: unchanged },
    Row {
        kind: "separator",
        has_fields: |result| has(result, &["chain"]),
        judge: |pair, _| Some((steps(pair.right).is_some(), steps(pair.right) == steps(pair.changed))),
    },
    Row { kind: "upper_hull", has_fields: |result| has(result, &["above_q", "z"]), judge: unchanged },
    Row { kind: "walk", has_fields: |result| has(result, &["neighbours"]), judge: |pair, _| walk(pair) },
    Row {
        kind: "min_area",
        has_fields: |result| {
            has(result, &["area", "center", "generators", "lower_bound", "certificate"])
                && has(&result["certificate"], &["hull", "farthest", "coefficients", "basis"])
        },
        judge: |pair, _| enclosures::least_area(pair.input, pair.right, pair.changed),
    },
    Row { kind: "min_length_dirs", has_fields: of_directions, judge: |pair, _| along_directions(pair) },
    Row {
        kind: "min_length_all",
        has_fields: |result| {
            let own = ["length", "center", "generators", "lower_bound", "ratio", "certificate"];
            let claimed = [&own[..], &["within_epsilon"]].concat();
            (has(result, &own) || has(result, &claimed)) && of_forces(&result["certificate"])
        },
        judge: |pair, _| enclosures::shortest(pair.input, pair.right, pair.changed),
    },
];

fn row(kind: &str) -> &'static Row {
    ROWS.iter().find(|row| row.kind == kind).unwrap_or_else(|| panic!("the kind `{kind}` has no row here"))
}

/// Whether an answer has exactly its fields, in everything that it holds.
pub fn has_its_fields(kind: &str, answer: &Value) -> bool {
    let Some(envelope) = answer.as_object() else { return false };
    let known = ["id", "kind", "method", "request", "result"];
    envelope.keys().all(|name| known.contains(&name.as_str()))
        && envelope.get("method").is_none_or(Value::is_string)
        && (row(kind).has_fields)(&answer["result"])
}

/// Whether `changed` answers the question, as `right` does. What cannot be read is false. What takes long to find of
/// the question is kept in `known`.
pub fn is_true(kind: &str, input: &Value, right: &Value, changed: &Value, known: &mut Option<Known>) -> bool {
    let Row { kind, judge, .. } = row(kind);
    judge(&Pair { kind, input, right, changed }, known).is_some_and(|(first, second)| first && second)
}

fn member(pair: &Pair<'_>) -> Judged {
    let body = placed(pair.input, "center");
    let p = body.as_ref().zip(vector(&pair.input["point"])).map(|((center, _), point)| minus(&point, center));
    let generators = body.map(|(_, generators)| generators);
    let is_same = same_fields(&["member", "status"], pair.right, pair.changed);
    Some(is_same).zip(proves(&p, &generators, pair.right, pair.changed))
}

fn intersect(pair: &Pair<'_>) -> Judged {
    let bodies = placed(&pair.input["a"], "center").zip(placed(&pair.input["b"], "center"));
    let p = bodies.as_ref().map(|((from, _), (to, _))| minus(to, from));
    let generators = bodies.map(|((_, a), (_, b))| [a, b].concat());
    let is_same = same_fields(&["intersects", "status"], pair.right, pair.changed);
    Some(is_same).zip(proves(&p, &generators, pair.right, pair.changed))
}

fn gauge(pair: &Pair<'_>) -> Judged {
    let Pair { input, right, changed, .. } = pair;
    let body = placed(input, "p");
    let p = body.as_ref().zip(vector(&input["q"])).map(|((center, _), q)| minus(&q, center));
    let is_same =
        same_fields(&["at_most_one"], right, changed) && is_gauge_of(p.as_deref(), &right["gauge"], &changed["gauge"]);
    Some(is_same).zip(proves(&p, &body.map(|(_, generators)| generators), right, changed))
}

/// Whether a changed gauge of a point, which is seen from the centre, is as right. The smallest double is a figure of
/// any gauge below it, but for that of the centre.
fn is_gauge_of(point: Option<&[RBig]>, right: &Value, changed: &Value) -> bool {
    let is_off_the_center = || point.is_some_and(|p| p.iter().any(|c| *c != RBig::ZERO));
    same_figure(right, changed) || (*right == 0.0 && *changed == SMALLEST && is_off_the_center())
}

fn member_batch(pair: &Pair<'_>) -> Judged {
    let center = placed(pair.input, "center").map(|(center, _)| center);
    let points: Option<Vec<Vec<RBig>>> =
        center.zip(vectors(&pair.input["points"])).map(|(c, points)| points.iter().map(|p| minus(p, &c)).collect());
    let point = |at: usize| points.as_ref().and_then(|points| points.get(at)).map(Vec::as_slice);
    let [old, new] = [pair.right, pair.changed].map(|result| result["gauge"].as_array());
    let figures = old.zip(new).map(|(old, new)| {
        let mut pairs = old.iter().zip(new).enumerate();
        old.len() == new.len() && pairs.all(|(at, (old, new))| is_gauge_of(point(at), old, new))
    });
    Some(same_fields(&["status"], pair.right, pair.changed)).zip(figures)
}

fn unchanged(pair: &Pair<'_>, _known: &mut Option<Known>) -> Judged {
    Some((true, is_same(pair.right, pair.changed)))
}

fn of_enclosing(result: &Value) -> bool {
    let certificate = &result["certificate"];
    has(result, &["center", "generators", "hausdorff", "certificate"])
        && has(&result["hausdorff"], &["lower", "upper", "direction"])
        && (has(certificate, &["shares", "frame"]) || has(certificate, &["facet_normals"]))
}

fn enclosing(pair: &Pair<'_>, known: &mut Option<Known>) -> Judged {
    bounds::of_enclosing(pair.kind, pair.input, pair.right, pair.changed, known)
}

/// The order of the neighbours is free.
fn walk(pair: &Pair<'_>) -> Judged {
    let sorted = |result: &Value| {
        let mut list = vectors(&result["neighbours"])?;
        list.sort();
        Some(list)
    };
    Some((true, sorted(pair.right) == sorted(pair.changed)))
}

fn of_directions(result: &Value) -> bool {
    if result["status"] == "infeasible" {
        return has(result, &["status", "certificate"]) && has(&result["certificate"], &["points", "functional"]);
    }
    has(result, &["status", "value", "center", "coefficients", "lower_bound", "certificate"])
        && of_forces(&result["certificate"])
}

/// Value and bound of an answer tell by themselves whether it is optimal.
fn along_directions(pair: &Pair<'_>) -> Judged {
    let [was, is] = [pair.right, pair.changed].map(|result| result["status"] == "infeasible");
    match (was, is) {
        (true, true) => enclosures::out_of_reach(pair.input, pair.changed),
        (false, false) => enclosures::cheapest(pair.input, pair.right, pair.changed),
        _ => Some((false, false)),
    }
}
