//! Errors planted in answers to questions that no file asks: convex hulls, least absolute deviations, tilings.
//!
//! Answers are written as JSON, spoilt like the others, and read back; what cannot be read is no answer.

use dashu_ratio::RBig;
use paper_checks::definitions::plane::{self, Point};
use proptest::prelude::*;
use rivals::tiling::{tiling, tiling_answer};
use serde_json::{Value, json};
use verifier::{
    Fraction, Lad, LadAnswer, Tile, TilingAnswer, TilingEdge, Verdict, check_convex_hull, check_lad, check_tiling,
};
use zonotope::hull::convex_hull;
use zonotope::interop::verifier::{lad_answer, lad_of_forms_answer};
use zonotope::lad::of_forms::{self, SpaceLadProblem, WeightedPlane};
use zonotope::lad::{LadProblem, WeightedLine, minimize};

use crate::errors;
use crate::rationals::{absolute, dot, index, indices, number, solved, vector};

/// Every spoilt answer that can be read and that `check` calls right is one that `is_true` finds to be so.
fn errors_are_noticed<A, P>(
    right: &Value,
    read: impl Fn(&Value) -> Option<A>,
    check: impl Fn(&A) -> Verdict<P>,
    is_true: impl Fn(&Value) -> bool,
) -> Result<(), TestCaseError> {
    let verdict = check(&read(right).expect("what was written can be read"));
    prop_assert_eq!(verdict.proof().map(drop), Ok(()), "{}", right);
    for (place, changed) in errors::planted(right) {
        let Some(answer) = read(&changed) else { continue };
        if check(&answer).is_right() {
            prop_assert!(is_true(&changed), "{}: {} is called right, as {} is", place, changed, right);
        }
    }
    Ok(())
}

fn fraction(value: &Value) -> Option<Fraction> {
    value.as_str().and_then(Fraction::parse)
}

fn fractions<const N: usize>(value: &Value) -> Option<[Fraction; N]> {
    value.as_array()?.iter().map(fraction).collect::<Option<Vec<_>>>()?.try_into().ok()
}

fn written(numbers: &[Fraction]) -> Vec<String> {
    numbers.iter().map(|number| format!("{}/{}", number.numerator(), number.denominator())).collect()
}

pub fn in_convex_hulls(points: &[[f64; 2]]) -> Result<(), TestCaseError> {
    let found = convex_hull(points, &mut ()).expect("the points are finite");
    let right: Vec<usize> = found.indices().iter().map(|index| index.get()).collect();
    let exact = |index: &usize| Point::exactly(points[*index]);
    let truth = plane::convex_hull(&points.iter().copied().map(Point::exactly).collect::<Vec<_>>());
    let is_true = |changed: &Value| {
        indices(changed).is_some_and(|indices| indices.iter().map(exact).collect::<Vec<_>>() == truth)
    };
    errors_are_noticed(&json!(right), indices, |hull| check_convex_hull(points, hull), is_true)
}

/// A problem in the rationals of the judge: its linear term, and normals and offsets with the weights multiplied in.
struct Exact {
    linear: Vec<RBig>,
    terms: Vec<(Vec<RBig>, RBig)>,
}

fn exactly(number: f64) -> RBig {
    RBig::try_from(number).expect("the numbers are finite")
}

impl Exact {
    fn new<const D: usize>(linear: [f64; D], terms: &[([f64; D], f64, f64)]) -> Self {
        let term = |(normal, offset, weight): &([f64; D], f64, f64)| {
            let weight = exactly(*weight);
            (normal.iter().map(|&x| exactly(x) * &weight).collect(), exactly(*offset) * weight)
        };
        Self { linear: linear.map(exactly).to_vec(), terms: terms.iter().map(term).collect() }
    }

    /// Whether a changed answer proves what it says, by the definition of its certificate.
    fn is_proved(&self, changed: &Value) -> bool {
        self.proof_of(changed) == Some(true)
    }

    fn proof_of(&self, changed: &Value) -> Option<bool> {
        if changed.get("direction").is_some() {
            let u = vector(&changed["direction"])?;
            let slopes = self.terms.iter().map(|(normal, _)| absolute(dot(normal, &u)));
            return Some(slopes.fold(dot(&self.linear, &u), |sum, slope| sum + slope) < RBig::ZERO);
        }
        let (point, value) = (vector(&changed["point"])?, number(&changed["value"])?);
        let signs: Vec<RBig> = vector(&changed["signs"])?;
        let basis = indices(&changed["basis"])?;
        let heights: Vec<RBig> = self.terms.iter().map(|(normal, offset)| dot(normal, &point) + offset).collect();
        let objective = heights.iter().fold(dot(&self.linear, &point), |sum, height| sum + absolute(height.clone()));
        let agrees = |(sign, height): (&RBig, &RBig)| {
            absolute(sign.clone()) <= RBig::ONE && sign * height == absolute(height.clone())
        };
        let is_idle = basis.iter().all(|&term| signs.get(term) == Some(&RBig::ZERO));
        if objective != value || signs.len() != heights.len() || !signs.iter().zip(&heights).all(agrees) || !is_idle {
            return Some(false);
        }
        let rest = self.terms.iter().zip(&signs).fold(self.linear.clone(), |rest, ((normal, _), sign)| {
            rest.iter().zip(normal).map(|(rest, x)| rest + sign * x).collect()
        });
        let target: Vec<RBig> = rest.into_iter().map(|x| -x).collect();
        let columns: Vec<&Vec<RBig>> = basis.iter().map(|&term| &self.terms[term].0).collect();
        Some(solved(&columns, &target).is_some_and(|solved| solved.into_iter().all(|x| absolute(x) <= RBig::ONE)))
    }
}

fn lad_json<const D: usize>(answer: &LadAnswer<D>) -> Value {
    match answer {
        LadAnswer::Optimal { point, value, signs, basis } => {
            let value = value.as_ref().map(|value| written(std::slice::from_ref(value)).concat());
            json!({"point": written(point), "value": value, "signs": signs, "basis": basis})
        }
        LadAnswer::Unbounded { direction } => json!({"direction": written(direction)}),
    }
}

fn read_lad<const D: usize>(value: &Value) -> Option<LadAnswer<D>> {
    if let Some(direction) = value.get("direction") {
        return Some(LadAnswer::Unbounded { direction: fractions(direction)? });
    }
    let signs = value["signs"].as_array()?.iter().map(|sign| i8::try_from(sign.as_i64()?).ok());
    Some(LadAnswer::Optimal {
        point: fractions(&value["point"])?,
        value: Some(fraction(&value["value"])?),
        signs: signs.collect::<Option<_>>()?,
        basis: indices(&value["basis"])?,
    })
}

fn in_an_optimum<const D: usize>(
    linear: [f64; D],
    terms: &[([f64; D], f64, f64)],
    right: &LadAnswer<D>,
) -> Result<(), TestCaseError> {
    let question = Lad::new(linear, terms).expect("the numbers are finite");
    let exact = Exact::new(linear, terms);
    errors_are_noticed(
        &lad_json(right),
        read_lad::<D>,
        |answer| check_lad(&question, answer),
        |changed| exact.is_proved(changed),
    )
}

pub fn in_optima_by_lines(linear: [f64; 2], terms: &[([f64; 2], f64, f64)]) -> Result<(), TestCaseError> {
    let lines: Vec<WeightedLine> =
        terms.iter().map(|&(normal, offset, weight)| WeightedLine { normal, offset, weight }).collect();
    let problem = LadProblem::new(&lines, linear).expect("the numbers are finite");
    let outcome = minimize(&problem, 1, &mut ());
    let mut right = lad_answer(&problem, &outcome).expect("the minimiser is one of this problem");
    if let (LadAnswer::Optimal { value, .. }, Some(optimum)) = (&mut right, outcome.optimum()) {
        let exact = optimum.exact_value(&problem).expect("the optimum is one of this problem");
        *value = Fraction::new(exact.numerator().clone(), exact.denominator().clone());
    }
    in_an_optimum(linear, terms, &right)
}

pub fn in_optima_by_forms(linear: [f64; 3], terms: &[([f64; 3], f64, f64)]) -> Result<(), TestCaseError> {
    let planes = terms.iter().map(|&(normal, offset, weight)| WeightedPlane { normal, offset, weight });
    let problem = SpaceLadProblem::new(planes.collect(), linear).expect("the numbers are finite");
    in_an_optimum(linear, terms, &lad_of_forms_answer(&of_forms::minimize(&problem, &mut ())))
}

fn tiling_json(answer: &TilingAnswer) -> Value {
    let edges = answer.edges.iter().map(|edge| {
        let TilingEdge { generator, upper, lower, left, right } = edge;
        json!({"generator": generator, "upper": upper, "lower": lower, "left": left, "right": right})
    });
    let tiles = answer.tiles.iter().map(|tile| {
        let Tile { generators, corners, edges, dual } = tile;
        json!({"generators": generators, "corners": corners, "edges": edges, "dual": written(dual)})
    });
    json!({
        "vertices": answer.vertices.iter().map(|vertex| written(vertex)).collect::<Vec<_>>(),
        "edges": edges.collect::<Vec<_>>(),
        "tiles": tiles.collect::<Vec<_>>(),
        "left_side": answer.left_side,
    })
}

fn read_tiling(value: &Value) -> Option<TilingAnswer> {
    let list = |name: &str| value[name].as_array();
    let tile_beside = |side: &Value| if side.is_null() { Some(None) } else { index(side).map(Some) };
    let edge = |edge: &Value| {
        Some(TilingEdge {
            generator: index(&edge["generator"])?,
            upper: index(&edge["upper"])?,
            lower: index(&edge["lower"])?,
            left: tile_beside(&edge["left"])?,
            right: tile_beside(&edge["right"])?,
        })
    };
    let tile = |tile: &Value| {
        Some(Tile {
            generators: indices(&tile["generators"])?.try_into().ok()?,
            corners: indices(&tile["corners"])?.try_into().ok()?,
            edges: indices(&tile["edges"])?.try_into().ok()?,
            dual: fractions(&tile["dual"])?,
        })
    };
    Some(TilingAnswer {
        vertices: list("vertices")?.iter().map(fractions).collect::<Option<_>>()?,
        edges: list("edges")?.iter().map(edge).collect::<Option<_>>()?,
        tiles: list("tiles")?.iter().map(tile).collect::<Option<_>>()?,
        left_side: indices(&value["left_side"])?,
    })
}

/// A tiling has no harmless errors: whatever else is called right says the same.
pub fn in_tilings(generators: &[[f64; 3]]) -> Result<(), TestCaseError> {
    let Ok(found) = tiling(generators) else { return Ok(()) };
    let (right, rows) = (tiling_answer(&found), generators.iter().map(|g| g.to_vec()).collect::<Vec<_>>());
    // Without tiles nothing refers to an edge, so that their order says nothing.
    let in_order = |mut answer: TilingAnswer| {
        if answer.tiles.is_empty() {
            answer.edges.sort_by_key(|edge| edge.generator);
        }
        answer
    };
    let is_same = |changed: &Value| read_tiling(changed).map(in_order) == Some(in_order(right.clone()));
    errors_are_noticed(&tiling_json(&right), read_tiling, |answer| check_tiling(&rows, answer), is_same)
}
