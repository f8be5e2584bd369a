//! Answers changed at random: numbers by near and far ones, words by others, lists shortened, extended, turned and
//! shuffled, fields removed, renamed, swapped, or taken over from other answers, names and ids by others.

use serde_json::{Map, Value, json};
use tests::dice::Dice;

/// The answer with one to three changes in its result, seldom around it. Fields and values are taken from `others` as
/// well: results of other questions, and of questions that differ from this one by a number.
pub fn mutant(dice: &mut Dice, answer: &Value, others: &[Value]) -> Value {
    let mut changed = answer.clone();
    let changes = *dice.choose(&[1, 1, 1, 2, 3]);
    for _ in 0..changes {
        let donor = dice.choose(others).clone();
        match dice.below(60) {
            0 => change_here(dice, &mut changed, &donor),
            1 => change_envelope(dice, &mut changed, &donor),
            2..6 => exchange_leaves(dice, &mut changed["result"]),
            _ => change(dice, &mut changed["result"], &donor),
        }
    }
    changed
}

/// Changes what stands around the result: which question is answered, and how.
fn change_envelope(dice: &mut Dice, answer: &mut Value, donor: &Value) {
    let name = *dice.choose(&["id", "kind", "method"]);
    let text = answer[name].as_str().unwrap_or_default().to_owned();
    answer[name] = match dice.below(7) {
        0 => json!(format!("{text} ")),
        1 => json!(text.to_uppercase()),
        2 => json!(dice.choose(&["member", "intersect", "min_area", "by_lad", "q", ""])),
        3 => json!(dice.below(9)),
        4 => Value::Null,
        5 => json!([text]),
        _ => {
            answer["error"] = json!({"code": "too_large", "message": text});
            donor.clone()
        }
    };
}

/// Two leaves of a value change places, or one is written over the other.
fn exchange_leaves(dice: &mut Dice, value: &mut Value) {
    let mut places = Vec::new();
    leaves(value, &mut String::new(), &mut places);
    if places.is_empty() {
        return;
    }
    let [from, to] = [dice.choose(&places).clone(), dice.choose(&places).clone()];
    let [first, second] = [&from, &to].map(|place| value.pointer(place).cloned().unwrap_or_default());
    if let Some(slot) = value.pointer_mut(&to) {
        *slot = first;
    }
    if dice.one_in(2)
        && let Some(slot) = value.pointer_mut(&from)
    {
        *slot = second;
    }
}

/// The places of all values that hold no others.
fn leaves(value: &Value, place: &mut String, places: &mut Vec<String>) {
    let length = place.len();
    let mut enter = |name: &str, value: &Value| {
        place.push('/');
        place.push_str(name);
        leaves(value, place, places);
        place.truncate(length);
    };
    match value {
        Value::Array(list) => {
            (0..).zip(list).for_each(|(index, element): (usize, _)| enter(&index.to_string(), element))
        }
        Value::Object(fields) => fields.iter().for_each(|(name, field)| enter(name, field)),
        _ => places.push(place.clone()),
    }
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
    match dice.below(19) {
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
        15 => json!(x.to_string()),
        16 => dice.choose(&[Value::Null, json!([]), json!({}), json!(true), json!([x])]).clone(),
        17 => {
            json!(dice.choose(&[-0.0, f64::MIN_POSITIVE.next_down(), -f64::from_bits(1), f64::MAX.next_down(), 1e16]))
        }
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
    match dice.below(8) {
        0 => json!(text.strip_prefix('-').map_or(format!("-{text}"), str::to_owned)),
        1 => json!(format!("{text}1")),
        2 => json!(format!("{text}/3")),
        3 => some_leaf(dice, donor),
        4 => text.parse::<i64>().map_or(json!(text), |whole| json!(whole.saturating_add(1).to_string())),
        5 => text.parse::<f64>().map_or(json!(text.to_uppercase()), |number| json!(number)),
        6 => json!(format!(" {text}")),
        _ => json!(dice.choose(&WORDS)),
    }
}

fn change_list(dice: &mut Dice, list: &mut Vec<Value>, donor: &Value) {
    let (count, place) = (list.len(), dice.below(list.len()));
    match dice.below(13) {
        0 if count > 0 => drop(list.remove(place)),
        1 if count > 0 => list.insert(place, list[place].clone()),
        2 if count > 1 => list.swap(place, (place + 1) % count),
        3 => list.clear(),
        4 => list.reverse(),
        5 => list.push(donor.get(0).unwrap_or(donor).clone()),
        6 => list.truncate(place),
        7 if count > 0 => list.rotate_left(place),
        8 => (1..count).for_each(|last| list.swap(last, dice.below(last + 1))),
        9 if count > 1 => list[place] = list[(place + 1) % count].clone(),
        10 => multiply(list, -1.0),
        11 => multiply(list, *dice.choose(&[0.0, 0.5, 2.0, 1.0 + f64::EPSILON, 1.0 - 1e-13, 1.0 + 1e-9])),
        _ => list.push(json!(0)),
    }
}

/// Multiplies all numbers in a list.
fn multiply(list: &mut [Value], factor: f64) {
    for element in list {
        match element {
            Value::Number(number) => *element = json!(number.as_f64().unwrap_or_default() * factor),
            Value::Array(inner) => multiply(inner, factor),
            _ => {}
        }
    }
}

fn change_fields(dice: &mut Dice, fields: &mut Map<String, Value>, donor: &Value) {
    let own = names(fields);
    match (dice.below(7), donor.as_object()) {
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
        (4, _) if !own.is_empty() => {
            let name = dice.choose(&own);
            let value = fields.remove(name).unwrap_or_default();
            fields.insert(if dice.one_in(2) { name.to_uppercase() } else { format!("{name}s") }, value);
        }
        (5, _) if own.len() > 1 => {
            let value = fields[dice.choose(&own)].clone();
            fields[dice.choose(&own)] = value;
        }
        _ => {
            let name = *dice.choose(&["extra", "pose", "shares", "exact", "volume", "penetration", "contact_normal"]);
            let value = if dice.one_in(2) { json!({}) } else { donor.clone() };
            fields.insert(name.to_owned(), value);
        }
    }
}

/// The text of an answer changed as no value of JSON can be: a field twice, a list without end, numbers that are none.
pub fn damaged(dice: &mut Dice, text: &str) -> String {
    let places = |sign: char| text.match_indices(sign).map(|(at, _)| at).collect::<Vec<_>>();
    let digits: Vec<usize> = text.match_indices(|c: char| c.is_ascii_digit()).map(|(at, _)| at).collect();
    let put = |at: usize, new: &str| format!("{}{new}{}", &text[..at], &text[at..]);
    match dice.below(6) {
        // Each field stands behind a brace or a comma; what is put there stands twice or stands for another.
        0 => {
            let at = *dice.choose(&places('{')) + 1;
            let fields =
                ["\"result\":{},", "\"status\":\"inside\",", "\"id\":\"q\",", "\"area\":1,", "\"center\":[0,0],"];
            put(at, dice.choose::<&str>(&fields))
        }
        1 => put(1, text.get(1..=text.find(',').unwrap_or(0)).unwrap_or_default()),
        2 => text[..dice.below(text.len())].to_owned(),
        3 if !digits.is_empty() => {
            let at = *dice.choose(&digits);
            let depth = *dice.choose(&[1, 100, 200, 100_000]);
            format!("{}{}{}{}", &text[..at], "[".repeat(depth), "]".repeat(depth), &text[at + 1..])
        }
        4 if !digits.is_empty() => {
            let at = *dice.choose(&digits);
            let number =
                *dice.choose(&["1e400", "-1e999", "NaN", "Infinity", "0x1", "01", "+1", "1.", "1e-400", "--1"]);
            format!("{}{number}{}", &text[..at], &text[at + 1..])
        }
        _ => put(text.len(), dice.choose::<&str>(&["}", "{}", ",", "\0", text])),
    }
}
