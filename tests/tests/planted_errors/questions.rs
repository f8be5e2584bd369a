//! Small questions of all kinds: whole numbers, for ties and flat bodies, numbers with all their places, numbers an ulp
//! apart and numbers of any size.

use serde_json::{Value, json};

use crate::dice::Dice;

/// The way in which the numbers of a question are made.
#[derive(Clone, Copy)]
enum Style {
    Whole,
    Real,
    Ulps,
    Mixed,
    Wide,
}

fn number(dice: &mut Dice, style: Style) -> f64 {
    let whole = dice.below(7) as f64 - 3.0;
    match style {
        Style::Whole => whole,
        Style::Real => 2.0 * dice.unit(),
        Style::Ulps => *dice.choose(&[whole, whole, whole.next_up(), whole.next_down()]),
        Style::Mixed if dice.one_in(3) => whole,
        Style::Wide if dice.one_in(2) => whole,
        Style::Wide => dice.unit() * 2.0_f64.powi(dice.below(2_040) as i32 - 1_030),
        Style::Mixed => dice.unit() * 10.0_f64.powi(dice.below(25) as i32 - 12),
    }
}

fn vector(dice: &mut Dice, style: Style, dimension: usize) -> Vec<f64> {
    (0..dimension).map(|_| number(dice, style)).collect()
}

/// Some vectors; now and then two are parallel, or all are flat.
fn vectors(dice: &mut Dice, style: Style, dimension: usize, count: usize) -> Vec<Vec<f64>> {
    let mut list: Vec<Vec<f64>> = (0..count).map(|_| vector(dice, style, dimension)).collect();
    if count > 1 && dice.one_in(4) {
        let factor = *dice.choose(&[-2.0, -1.0, 1.0, 0.5]);
        list[0] = list[1].iter().map(|x| x * factor).collect();
    }
    if dimension > 1 && dice.one_in(8) {
        list.iter_mut().for_each(|v| v[dimension - 1] = 0.0);
    }
    list
}

/// A question of the kind with the given id.
pub fn question(dice: &mut Dice, kind: &str, id: &str) -> Value {
    let style = *dice.choose(&[Style::Whole, Style::Whole, Style::Real, Style::Ulps, Style::Mixed, Style::Wide]);
    let dimension = *dice.choose(&[1, 2, 2, 3, 3, 3, 4]);
    json!({"id": id, "kind": kind, "input": input(dice, kind, style, dimension)})
}

/// A zonotope with so many generators.
fn body(dice: &mut Dice, style: Style, dimension: usize, count: usize) -> Value {
    let center = vector(dice, style, dimension);
    json!({"center": center, "generators": vectors(dice, style, dimension, count)})
}

fn input(dice: &mut Dice, kind: &str, style: Style, dimension: usize) -> Value {
    let space = dimension.min(3);
    let count = dice.below(5);
    let some = count.max(1);
    match kind {
        "member" => {
            let point = json!(vector(dice, style, dimension));
            with(body(dice, style, dimension, count), "point", point)
        }
        "intersect" => json!({"a": body(dice, style, dimension, count), "b": body(dice, style, dimension, 4 - count)}),
        "distance" => json!({"a": body(dice, style, space, count), "b": body(dice, style, space, 5 - count)}),
        "hausdorff" => {
            let (a, b) = (body(dice, style, space, count), body(dice, style, space, 4 - count));
            // Of some pairs the second body is the first one and more.
            if dice.one_in(4) {
                let lists = [&a, &b].map(|body| body["generators"].as_array().cloned().unwrap_or_default());
                return json!({"a": a, "b": {"center": a["center"], "generators": lists.concat()}});
            }
            json!({"a": a, "b": b})
        }
        "approx" => json!({
            "generators": vectors(dice, style, space, some), "epsilon": dice.choose(&[0.5, 0.25, 0.1])
        }),
        "reduce" => {
            let rules = ["cluster", "lemma_5_5", "girard", "combastel", "pca", "scott", "adaptive", "best"];
            let body = body(dice, style, space, some);
            with(with(body, "rule", json!(dice.choose(&rules))), "count", json!(space + dice.below(2)))
        }
        "gauge" => json!({
            "p": vector(dice, style, dimension), "q": vector(dice, style, dimension),
            "generators": vectors(dice, style, dimension, count)
        }),
        "member_batch" => {
            with(body(dice, style, dimension, count), "points", json!(vectors(dice, style, dimension, 3)))
        }
        "support" => with(body(dice, style, dimension, count), "direction", json!(vector(dice, style, dimension))),
        "combinatorics" => json!({"generators": vectors(dice, style, dimension, count)}),
        "slope_selection" => json!({"generators": vectors(dice, style, 3, some + 1), "k": [1]}),
        "separator" => json!({"generators": vectors(dice, style, 3, some + 1), "k": 1}),
        "walk" => json!({"generators": vectors(dice, style, 3, some + 2), "facet": [0, 1, 1]}),
        "upper_hull" => json!({"generators": vectors(dice, style, 3, some), "p0": vector(dice, style, 2)}),
        "min_area" => json!({"points": vectors(dice, style, 2, some)}),
        "min_length_dirs" => {
            let weights: Vec<f64> = (0..some).map(|_| dice.below(4) as f64).collect();
            json!({
                "points": vectors(dice, style, space, 1 + count % 3), "directions": vectors(dice, style, space, some),
                "weights": weights
            })
        }
        "min_length_all" => {
            let input = json!({"points": vectors(dice, style, space, some), "epsilon": 0.25});
            if dice.one_in(4) { with(input, "max_generators", json!(space + 1)) } else { input }
        }
        other => panic!("no question is made of the kind `{other}`"),
    }
}

fn with(mut input: Value, field: &str, value: Value) -> Value {
    input[field] = value;
    input
}
