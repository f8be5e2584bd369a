//! Bodies with generators that are nearly parallel to others, and points of the facets that they would have if the
//! generators were parallel: a decision about them turns on the last places of sums.

use serde_json::{Value, json};

use crate::dice::Dice;

/// Makes generators of the bodies of a question nearly parallel to others, and puts its points, or its second body,
/// where the boundary nearly is.
pub(super) fn arrange(dice: &mut Dice, input: &mut Value) {
    let own = doubled(dice, Some(input));
    if let Some(first) = own.first() {
        let start = input.get("p").or(input.get("center")).and_then(numbers).unwrap_or_else(|| vec![0.0; first.len()]);
        for name in ["point", "q"] {
            if let Some(point) = input.get_mut(name) {
                *point = json!(near_boundary(dice, &start, &own));
            }
        }
        if let Some(points) = input.get_mut("points").and_then(Value::as_array_mut) {
            points.iter_mut().for_each(|point| *point = json!(near_boundary(dice, &start, &own)));
        }
        return;
    }
    let both = [doubled(dice, input.get_mut("a")), doubled(dice, input.get_mut("b"))].concat();
    let start = input.get("a").and_then(|a| a.get("center")).and_then(numbers);
    if let (Some(start), false, Some(b)) = (start, both.is_empty(), input.get_mut("b")) {
        b["center"] = json!(near_boundary(dice, &start, &both));
    }
}

/// Puts copies of some generators, or of their opposites, in the place of others of a body, each moved by a little;
/// returns the generators as they are without that.
fn doubled(dice: &mut Dice, body: Option<&mut Value>) -> Vec<Vec<f64>> {
    let Some(list) = body.and_then(|body| body.get_mut("generators")) else { return Vec::new() };
    let vectors = list.as_array().map(|list| list.iter().map(numbers).collect::<Option<Vec<_>>>());
    let Some(Some(mut whole)) = vectors else { return Vec::new() };
    let mut moved = whole.clone();
    for i in 1..whole.len() {
        if dice.one_in(2) {
            continue;
        }
        let factor = *dice.choose(&[-2.0, -1.0, -1.0, 1.0, 1.0, 0.5]);
        whole[i] = whole[dice.below(i)].iter().map(|x| x * factor).collect();
        moved[i] = whole[i].clone();
        if dice.one_in(4) {
            continue;
        }
        let place = dice.below(whole[i].len());
        let by = (2.0_f64).powi(dice.below(24) as i32 - 52) * if dice.one_in(2) { 1.0 } else { -1.0 };
        moved[i][place] += by * moved[i][place].abs().max(0.5);
    }
    *list = json!(moved);
    whole
}

fn numbers(list: &Value) -> Option<Vec<f64>> {
    list.as_array()?.iter().map(Value::as_f64).collect()
}

/// A point of the boundary of a zonotope: the sum of the generators, each towards the same side of a plane through the
/// centre, those in the plane with any quarter.
fn near_boundary(dice: &mut Dice, center: &[f64], generators: &[Vec<f64>]) -> Vec<f64> {
    let normal = normal(dice, generators);
    let mut point = center.to_vec();
    for generator in generators {
        let along: f64 = generator.iter().zip(&normal).map(|(g, u)| g * u).sum();
        let share = if along == 0.0 { *dice.choose(&[-1.0, -0.5, 0.0, 0.25, 1.0]) } else { along.signum() };
        point.iter_mut().zip(generator).for_each(|(x, g)| *x += share * g);
    }
    point
}

/// A direction that is orthogonal to one or two generators in the plane and in space, and any one elsewhere.
fn normal(dice: &mut Dice, generators: &[Vec<f64>]) -> Vec<f64> {
    match (&dice.choose(generators)[..], &dice.choose(generators)[..]) {
        ([x, y], _) => vec![-y, *x],
        ([a, b, c], [x, y, z]) => vec![b * z - c * y, c * x - a * z, a * y - b * x],
        (other, _) => other.iter().map(|_| dice.below(7) as f64 - 3.0).collect(),
    }
}
