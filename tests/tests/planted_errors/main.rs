//! Errors planted in right answers: whatever makes an answer false is noticed by the verifier.
//!
//! Every number, name, flag and list of an answer is changed in several ways. A change may leave an answer true:
//! another vertex that is as far away, a figure within the accepted rounding. So whenever the verifier still calls the
//! answer right, a judge decides whether it is, from the definition and in rationals, by code that shares nothing with
//! the verifier. Beside the errors that are planted one by one there are random mutants, of answers about ordinary
//! numbers and about numbers of any size, a million of each where `ZONOTOPE_MUTANTS` asks for so many.

mod bounds;
mod enclosures;
mod errors;
mod fields;
mod judges;
mod kinds;
mod meshes;
mod moving;
mod mutants;
mod mutation;
mod plain;
mod proximity;
mod rationals;
mod truth;

use std::collections::BTreeMap;

use batch::json::{MAX_VALUES, Tree, read};
use batch::{KINDS, Line, Verdict, answer_line, check};
use mutants::{Counts, MUTANTS_AN_ANSWER, answered};
use proptest::prelude::*;
use serde_json::{Value, json};
use tests::dice::Dice;
use tests::questions::{self, Population};
use tests::runner::cases;

fn tree(value: &Value) -> Tree {
    read(value.to_string().as_bytes(), MAX_VALUES).expect("an answer is JSON")
}

/// Asks, and holds every false answer that one error makes against the verifier; how many errors it called right with
/// reason.
fn errors_are_noticed(kind: &str, input: &Value) -> Result<usize, TestCaseError> {
    let question = json!({"id": "q", "kind": kind, "input": input});
    let right = answer_line(1, &Line::Content(question.to_string().into_bytes()), 0).content;
    let asked = tree(&question);
    // Refusals are not judged, nor is what would take too long to prove.
    if right.get("error").is_some() || !check(&asked, &tree(&right)).is_right() {
        return Ok(0);
    }
    let (mut harmless, mut known) = (0, None);
    for (place, result) in errors::planted(&right["result"]) {
        let wrong = json!({"id": "q", "kind": kind, "result": result});
        if matches!(check(&asked, &tree(&wrong)), Verdict::Right(_)) {
            let verdict = kinds::is_true(kind, input, &right["result"], &result, &mut known);
            prop_assert!(
                kinds::has_its_fields(kind, &wrong) && verdict,
                "{}: {} is no answer to {}",
                place,
                wrong,
                question
            );
            harmless += 1;
        }
    }
    Ok(harmless)
}

/// Small whole numbers, so that ties and flat bodies occur, and a few with all their places.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![4 => (-3i32..4).prop_map(f64::from), 1 => -2.0..2.0f64]
}

fn vectors(dimension: usize, counts: std::ops::Range<usize>) -> impl Strategy<Value = Vec<Vec<f64>>> {
    prop::collection::vec(prop::collection::vec(number(), dimension), counts)
}

fn vector(dimension: usize) -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(number(), dimension)
}

/// In two or three dimensions: some generators and three vectors.
fn bodies() -> impl Strategy<Value = (Vec<Vec<f64>>, [Vec<f64>; 3])> {
    (2usize..4).prop_flat_map(|d| (vectors(d, 0..6), [vector(d), vector(d), vector(d)]))
}

/// A matrix that turns, mirrors, stretches or flattens, and a translation.
fn pose(dimension: usize) -> impl Strategy<Value = Value> {
    (vectors(dimension, dimension..dimension + 1), vector(dimension))
        .prop_map(|(matrix, translation)| json!({"matrix": matrix, "translation": translation}))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(cases(120)))]

    #[test]
    fn in_places_of_points_and_bodies((generators, [p, q, r]) in bodies()) {
        let (first, second) = generators.split_at(generators.len() / 2);
        errors_are_noticed("member", &json!({"point": q, "center": p, "generators": generators}))?;
        let [a, b] = [(&p, first), (&q, second)].map(|(center, own)| json!({"center": center, "generators": own}));
        errors_are_noticed("intersect", &json!({"a": a, "b": b}))?;
        errors_are_noticed("distance", &json!({"a": a, "b": b}))?;
        errors_are_noticed("gauge", &json!({"p": p, "q": q, "generators": generators}))?;
        errors_are_noticed("member_batch", &json!({"center": p, "generators": generators, "points": [p, q, r]}))?;
    }

    #[test]
    fn in_places_of_bodies_under_poses(
        (generators, [p, q], from, to) in (2usize..4).prop_flat_map(|d| {
            (vectors(d, 0..6), [vector(d), vector(d)], pose(d), pose(d))
        })
    ) {
        let (first, second) = generators.split_at(generators.len() / 2);
        errors_are_noticed("member", &json!({"point": q, "center": p, "generators": generators, "pose": from}))?;
        let a = json!({"center": p, "generators": first, "pose": from});
        errors_are_noticed("intersect", &json!({"a": a, "b": {"center": q, "generators": second, "pose": to}}))?;
        errors_are_noticed("intersect", &json!({"a": a, "b": {"center": q, "generators": second}}))?;
        errors_are_noticed("distance", &json!({"a": a, "b": {"center": q, "generators": second}}))?;
        errors_are_noticed("gauge", &json!({"p": p, "q": q, "generators": generators, "pose": to}))?;
        errors_are_noticed("support", &json!({"direction": q, "center": p, "generators": generators, "pose": to}))?;
        let points = json!([p, q]);
        let many = json!({"center": p, "generators": generators, "points": points, "pose": to});
        errors_are_noticed("member_batch", &many)?;
    }

    #[test]
    fn in_what_bodies_are_like((generators, [p, u, _]) in bodies()) {
        errors_are_noticed("support", &json!({"direction": u, "center": p, "generators": generators}))?;
        errors_are_noticed("combinatorics", &json!({"generators": generators}))?;
    }

    #[test]
    fn in_distances_of_bodies((generators, [p, q, _]) in bodies()) {
        let (first, second) = generators.split_at(generators.len() / 2);
        let [a, b] = [(&p, first), (&q, second)].map(|(center, own)| json!({"center": center, "generators": own}));
        errors_are_noticed("hausdorff", &json!({"a": a, "b": b}))?;
        errors_are_noticed("approx", &json!({"generators": first, "epsilon": 0.25}))?;
        let around = json!({"center": p, "generators": first, "count": p.len(), "rule": "pca"});
        errors_are_noticed("reduce", &around)?;
    }

    #[test]
    fn in_arrangements(generators in vectors(3, 2..6), k in 1usize..4, p0 in vector(2)) {
        errors_are_noticed("slope_selection", &json!({"generators": generators, "k": [k]}))?;
        errors_are_noticed("separator", &json!({"generators": generators, "k": k}))?;
        errors_are_noticed("upper_hull", &json!({"generators": generators, "p0": p0}))?;
        errors_are_noticed("walk", &json!({"generators": generators, "facet": [0, 1, 1]}))?;
    }

    #[test]
    fn in_bodies_around_points(points in vectors(2, 1..6), directions in vectors(2, 1..5)) {
        errors_are_noticed("min_area", &json!({"points": points}))?;
        let weights: Vec<f64> = (1..=directions.len()).map(|weight| weight as f64).collect();
        let along = json!({"points": points, "directions": directions, "weights": weights});
        errors_are_noticed("min_length_dirs", &along)?;
        errors_are_noticed("min_length_all", &json!({"points": points, "epsilon": 0.25}))?;
    }
}

proptest! {
    // each of these answers takes some seconds to judge by the definition in all its fields
    #![proptest_config(ProptestConfig::with_cases(cases(14)))]

    #[test]
    fn in_swept_volumes(
        (generators, [p, q, v]) in (vectors(3, 0..4), [vector(3), vector(3), vector(3)]),
        axis in 0usize..3,
    ) {
        let directions = [[0.0, 0.0, 1.0], [1.0, -2.0, 0.0], [0.3, 0.1, 0.2]];
        let body = json!({"center": p, "generators": generators, "axis_point": q, "axis": directions[axis],
            "angle": 1.25, "translation": v});
        errors_are_noticed("sweep", &body)?;
    }
}

/// The corners of one triangle or two in small whole numbers, away from the origin or not.
fn triangles(away: i32) -> impl Strategy<Value = Value> {
    let corner = prop::array::uniform3(-2i32..3).prop_map(move |[x, y, z]| [x + away, y, z]);
    (prop::collection::vec(corner, 4), 1usize..3).prop_map(|(vertices, count)| {
        let triangles = [[0, 1, 2], [1, 2, 3]];
        json!({"vertices": vertices, "triangles": triangles[..count]})
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(cases(12)))]

    #[test]
    fn in_first_contacts_of_meshes(
        (a, b) in (triangles(0), triangles(4)),
        turn in prop::array::uniform3(-2i32..3),
        [axis_point, translation] in prop::array::uniform2(prop::array::uniform3(-4i32..5)),
    ) {
        let [x, y, z] = turn;
        let motion = json!({"pieces": [{"until": 1, "from": [1, 0, 0, 0], "to": [2, x, y, z],
            "axis_point": axis_point, "translation": translation}]});
        errors_are_noticed("collide", &json!({"a": a, "b": b, "motion": {"b": motion}}))?;
    }
}

/// Terms of least absolute deviations: normal, offset and weight.
fn terms<const D: usize>() -> impl Strategy<Value = Vec<([f64; D], f64, f64)>> {
    let term = (prop::array::uniform(number()), number(), (0u8..3).prop_map(f64::from));
    prop::collection::vec(term, 1..7)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(cases(120)))]

    #[test]
    fn in_convex_hulls(points in prop::collection::vec(prop::array::uniform(number()), 1..9)) {
        plain::in_convex_hulls(&points)?;
    }

    #[test]
    fn in_optima(
        linear in prop::array::uniform(number()),
        lines in terms(),
        tilt in prop::array::uniform(number()),
        planes in terms(),
    ) {
        plain::in_optima_by_lines(linear, &lines)?;
        plain::in_optima_by_lines([0.0, 0.0], &lines)?;
        plain::in_optima_by_forms(tilt, &planes)?;
        plain::in_optima_by_forms([0.0, 0.0, 0.0], &planes)?;
    }

    #[test]
    fn in_tilings(generators in prop::collection::vec(prop::array::uniform(number()), 1..5)) {
        plain::in_tilings(&generators)?;
    }
}

/// The number of mutants that a long run makes of each population, of all kinds together.
const MUTANTS: u32 = 24_000;

/// The variable of the environment that names another number of mutants.
const MUTANTS_VARIABLE: &str = "ZONOTOPE_MUTANTS";

/// The fewest questions of a kind: of one answer alone, nearly every mutant may happen to be another proof.
const FEWEST_QUESTIONS: usize = 5;

/// The most generators of an answer that is changed: whether a body contains a point is judged by its definition, in
/// 3^n steps for n generators.
const MOST_GENERATORS: usize = 8;

/// The number of generators that an answer writes down.
fn generators(result: &Value) -> usize {
    result.get("generators").and_then(Value::as_array).map_or(0, Vec::len)
}

/// A message shows so many faults of a kind.
const SHOWN: usize = 3;

/// Makes mutants of all kinds from a population of questions: none that is false is called right.
fn mutants_are_judged_as_by_the_definition(population: Population) {
    let wanted = std::env::var(MUTANTS_VARIABLE)
        .map_or(cases(MUTANTS) as usize, |text| text.parse().expect("a number of mutants"));
    let questions = wanted.div_ceil(KINDS.len() * MUTANTS_AN_ANSWER).max(FEWEST_QUESTIONS);
    let mut counts: BTreeMap<String, Counts> = BTreeMap::new();
    let mut faults = Vec::new();
    for (number, kind) in (1..).zip(KINDS) {
        let mut dice = Dice::new(number);
        let mut pairs = Vec::new();
        // Refused questions have no answer to change, and the definition of many generators takes too long.
        while pairs.len() < questions {
            let id = format!("{} {}", kind.name, pairs.len());
            let question = questions::question(&mut dice, population, kind.name, &id);
            let answer = answered(&question);
            if answer.get("result").is_some_and(|result| generators(result) <= MOST_GENERATORS) {
                pairs.push((question, answer));
            }
        }
        mutants::judge(&mut dice, &pairs, &mut counts);
        let Counts { mutants, harmless, wrong, unchecked, faults: own } = &counts[kind.name];
        println!(
            "{}: {mutants} mutants, {wrong} wrong, {unchecked} unchecked, {harmless} right, {} faults",
            kind.name,
            own.len()
        );
        assert!(wrong + unchecked > 2 * harmless, "{harmless} mutants of {} are harmless", kind.name);
        if !own.is_empty() {
            let shown = own[..own.len().min(SHOWN)].join("\n");
            println!("{shown}");
            faults.push(format!("{} of {mutants} mutants of {}: {shown}", own.len(), kind.name));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    let mutants: usize = counts.values().map(|counts| counts.mutants).sum();
    assert!(mutants >= wanted / 2, "{mutants}");
}

#[test]
fn random_mutants_of_ordinary_numbers_are_judged_as_by_the_definition() {
    mutants_are_judged_as_by_the_definition(Population::Ordinary);
}

#[test]
fn random_mutants_of_numbers_of_any_size_are_judged_as_by_the_definition() {
    mutants_are_judged_as_by_the_definition(Population::AnySize);
}

/// Points of a face are as far as any other, so an answer may be changed to another right one.
#[test]
fn another_right_answer_is_right() {
    let input = json!({"direction": [1, 0], "center": [0, 0], "generators": [[1, 0], [0, 1]]});
    assert!(errors_are_noticed("support", &input).expect("no error is overlooked") > 0);
}

/// The answer to a question with a pose is no answer to the same question with another pose.
#[test]
fn an_answer_for_another_pose_is_noticed() {
    let question = |x: f64| {
        let pose = json!({"matrix": [[0, -1, 0], [1, 0, 0], [0, 0, 1]], "translation": [x, 0, 0]});
        let body = |center: [f64; 3]| json!({"center": center, "generators": [[1, 0, 0], [0, 2, 0], [0, 0, 1]]});
        let mut placed = body([0.5, 0.0, 0.0]);
        placed["pose"] = pose;
        json!({"id": "q", "kind": "intersect", "input": {"a": placed, "b": body([0.0; 3])}})
    };
    let answer = |x: f64| answer_line(1, &Line::Content(question(x).to_string().into_bytes()), 0).content;
    let verdict = |x: f64, answer: &Value| check(&tree(&question(x)), &tree(answer));
    // the turned body reaches 2 along the first axis and the other one 1
    for (x, status) in [(2.5, "inside"), (3.0, "boundary"), (3.5, "outside")] {
        let answer = answer(x);
        assert_eq!(answer["result"]["status"], status, "{answer}");
        assert!(verdict(x, &answer).is_right());
        for other in [2.0, 2.75, 3.0, 4.5].into_iter().filter(|other| *other != x) {
            // a direction that separates a body separates it farther away, too
            assert_eq!(verdict(other, &answer).is_right(), status == "outside" && other > x, "{x} {other}");
        }
    }
}
