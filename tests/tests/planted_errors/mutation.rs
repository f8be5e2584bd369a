//! Answers changed at random: numbers by near and far ones, words by others, lists shortened and extended, fields
//! removed, swapped, or taken over from other answers.

use serde_json::{Map, Value, json};

use crate::dice::Dice;

/// The answer with one to three changes in its result, seldom around it. Fields and values are taken from `others`,
/// results of other questions, as well.
pub fn mutant(dice: &mut Dice, answer: &Value, others: &[Value]) -> Value {
    let mut changed = answer.clone();
    let changes = *dice.choose(&[1, 1, 1, 2, 3]);
    for _ in 0..changes {
        let donor = dice.choose(others).clone();
        if dice.one_in(40) {
            change_here(dice, &mut changed, &donor);
        } else {
            change(dice, &mut changed["result"], &donor);
        }
    }
    changed
}

/// Changes a value or something in it.
fn change(dice: &mut Dice, value: &mut Value, donor: &Value) {
    let is_deeper = !dice.one_in(4);
    match value {
        Value::Array(list) if is_deeper && !list.is_empty() => {
            let place = dice.below(list.len());
            let own = donor.get(place).unwrap_or(donor).clone();
            change(dice, &mut list[place], &own);
        }
        Value::Object(fields) if is_deeper && !fields.is_empty() => {
            let name = dice.choose(&names(fields)).clone();
            let own = donor.get(&name).unwrap_or(donor).clone();
            change(dice, &mut fields[&name], &own);
        }
        _ => change_here(dice, value, donor),
    }
}

fn names(fields: &Map<String, Value>) -> Vec<String> {
    fields.keys().cloned().collect()
}

fn change_here(dice: &mut Dice, value: &mut Value, donor: &Value) {
    if dice.one_in(12) {
        *value = donor.clone();
        return;
    }
    match value {
        Value::Null => *value = json!(0),
        Value::Bool(flag) => *flag = !*flag,
        Value::Number(number) => {
            let number = number.as_f64().unwrap_or(0.0);
            *value = other_number(dice, number, donor);
        }
        Value::String(text) => *value = other_text(dice, text, donor),
        Value::Array(list) => change_list(dice, list, donor),
        Value::Object(fields) => change_fields(dice, fields, donor),
    }
}

fn other_number(dice: &mut Dice, x: f64, donor: &Value) -> Value {
    let tiny = 10.0_f64.powi(-(dice.below(16) as i32));
    let steps = dice.below(4) + 1;
    match dice.below(16) {
        0 | 1 => json!((0..steps).fold(x, |x, _| x.next_up())),
        2 | 3 => json!((0..steps).fold(x, |x, _| x.next_down())),
        4 => json!(-x),
        5 => json!(x * (1.0 + tiny)),
        6 => json!(x * (1.0 - tiny)),
        7 => json!(x + tiny),
        8 => json!(dice.choose(&[0.0, 1.0, -1.0, 0.5, 2.0])),
        9 => json!(dice.choose(&[f64::MAX, -f64::MAX, f64::MIN_POSITIVE, f64::from_bits(1), 1e300, 1e-300])),
        10 => json!(dice.choose(&["Infinity", "-Infinity", "NaN", "1/3", "0", "-7/2"])),
        11 => json!(x * 2.0),
        12 => json!(x / 2.0),
        13 => json!((x as i64).saturating_add(1)),
        14 => json!((x as i64).saturating_sub(1)),
        _ => some_leaf(dice, donor),
    }
}

/// A number or a word of a value, if it holds one.
fn some_leaf(dice: &mut Dice, value: &Value) -> Value {
    match value {
        Value::Array(list) if !list.is_empty() => {
            let place = dice.below(list.len());
            some_leaf(dice, &list[place])
        }
        Value::Object(fields) if !fields.is_empty() => {
            let name = dice.choose(&names(fields)).clone();
            some_leaf(dice, &fields[&name])
        }
        other => other.clone(),
    }
}

fn other_text(dice: &mut Dice, text: &str, donor: &Value) -> Value {
    const WORDS: [&str; 16] = [
        "inside",
        "boundary",
        "outside",
        "optimal",
        "feasible",
        "infeasible",
        "vertex",
        "edge",
        "facet",
        "interior",
        "Infinity",
        "-Infinity",
        "NaN",
        "0",
        "1",
        "",
    ];
    match dice.below(6) {
        0 => json!(text.strip_prefix('-').map_or(format!("-{text}"), str::to_owned)),
        1 => json!(format!("{text}1")),
        2 => json!(format!("{text}/3")),
        3 => some_leaf(dice, donor),
        4 => text.parse::<i64>().map_or(json!(text), |whole| json!(whole.saturating_add(1).to_string())),
        _ => json!(dice.choose(&WORDS)),
    }
}

fn change_list(dice: &mut Dice, list: &mut Vec<Value>, donor: &Value) {
    let (count, place) = (list.len(), dice.below(list.len()));
    match dice.below(7) {
        0 if count > 0 => drop(list.remove(place)),
        1 if count > 0 => list.insert(place, list[place].clone()),
        2 if count > 1 => list.swap(place, (place + 1) % count),
        3 => list.clear(),
        4 => list.reverse(),
        5 => list.push(donor.get(0).unwrap_or(donor).clone()),
        _ => list.push(json!(0)),
    }
}

fn change_fields(dice: &mut Dice, fields: &mut Map<String, Value>, donor: &Value) {
    let own = names(fields);
    match (dice.below(5), donor.as_object()) {
        (0, _) if !own.is_empty() => drop(fields.remove(dice.choose(&own))),
        (1, _) if own.len() > 1 => {
            let (first, second) = (dice.choose(&own).clone(), dice.choose(&own).clone());
            let value = fields[&first].clone();
            fields[&first] = std::mem::replace(&mut fields[&second], value);
        }
        (2 | 3, Some(others)) if !others.is_empty() => {
            let name = dice.choose(&names(others)).clone();
            fields.insert(name.clone(), others[&name].clone());
        }
        _ => {
            let name = *dice.choose(&["extra", "pose", "shares", "exact", "volume", "penetration", "contact_normal"]);
            let value = if dice.one_in(2) { json!({}) } else { donor.clone() };
            fields.insert(name.to_owned(), value);
        }
    }
}
