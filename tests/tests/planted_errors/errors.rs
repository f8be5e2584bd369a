//! Every way in which one error is planted in a JSON value.

use serde_json::{Number, Value};

/// The changed values, each with the place of its change.
pub fn planted(value: &Value) -> Vec<(String, Value)> {
    let mut found: Vec<(String, Value)> = changes(value).into_iter().map(|changed| (String::new(), changed)).collect();
    let parts: Vec<(String, &Value)> = match value {
        Value::Array(list) => list.iter().enumerate().map(|(i, part)| (i.to_string(), part)).collect(),
        Value::Object(fields) => fields.iter().map(|(name, part)| (name.clone(), part)).collect(),
        _ => Vec::new(),
    };
    for (name, part) in parts {
        for (place, changed) in planted(part) {
            let mut whole = value.clone();
            match &mut whole {
                Value::Array(list) => list[name.parse::<usize>().expect("a list is numbered")] = changed,
                other => other[&name] = changed,
            }
            found.push((format!("/{name}{place}"), whole));
        }
    }
    found
}

/// The values that one value may be changed to, its parts as they are.
fn changes(value: &Value) -> Vec<Value> {
    match value {
        Value::Bool(flag) => vec![Value::Bool(!flag)],
        Value::Number(number) => numbers(number),
        Value::String(text) => texts(text),
        Value::Array(list) => lists(list),
        Value::Null | Value::Object(_) => Vec::new(),
    }
}

fn numbers(number: &Number) -> Vec<Value> {
    let mut changed = Vec::new();
    if let Some(index) = number.as_u64() {
        changed.extend([index + 1, index.saturating_sub(1), 1 << 40].map(Value::from));
    }
    let x = number.as_f64().expect("a number of an answer is a double");
    changed.extend([-x, x.next_up(), x.next_down(), x * (1.0 + 1e-6) + 1e-6, x + 1.0, x / 2.0].map(Value::from));
    changed.retain(|value| value.as_f64() != Some(x) && !value.is_null());
    changed
}

fn texts(text: &str) -> Vec<Value> {
    if let Some(exact) = text.strip_prefix('-') {
        return vec![exact.into()];
    }
    let names = ["inside", "boundary", "outside", "optimal", "infeasible", "Infinity", "-Infinity", "0", "1", "1/3"];
    let mut changed: Vec<Value> = names.into_iter().filter(|name| *name != text).map(Value::from).collect();
    if text != "0" && text.starts_with(|c: char| c.is_ascii_digit()) {
        changed.push(format!("-{text}").into());
    }
    changed
}

/// An element less, an element twice, the last two the other way round.
fn lists(list: &[Value]) -> Vec<Value> {
    let mut changed = Vec::new();
    if let [rest @ .., last] = list {
        changed.push(rest.to_vec());
        changed.push([list, std::slice::from_ref(last)].concat());
    }
    if let [rest @ .., a, b] = list
        && a != b
    {
        changed.push([rest, &[b.clone(), a.clone()]].concat());
    }
    changed.into_iter().map(Value::from).collect()
}
