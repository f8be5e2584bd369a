//! Parts of the judgement whether a changed answer is still true: from the definition, in rationals.

use dashu_ratio::RBig;
use serde_json::Value;

use crate::rationals::{absolute, dot, indices, minus, number, solved, vector, vectors};
use crate::truth::contains;

/// Figures within a relative error of this are the same but for rounding: both may be off by the stated 1e-12.
pub const SAME: f64 = 2.01e-12;

/// Whether two results say the same in these fields.
pub fn same_fields(names: &[&str], right: &Value, changed: &Value) -> bool {
    names.iter().all(|name| right[name] == changed[name])
}

/// The smallest double: figures without places differ by this where each is one of the two around the exact one.
pub const SMALLEST: f64 = f64::from_bits(1);

/// Whether two figures are the same but for rounding; zero and infinity are never rounded to.
pub fn same_figure(right: &Value, changed: &Value) -> bool {
    match (right.as_f64(), changed.as_f64()) {
        (Some(right), Some(changed)) if right != 0.0 => (changed - right).abs() <= (SAME * right.abs()).max(SMALLEST),
        (Some(right), Some(changed)) => right == changed,
        _ => right == changed,
    }
}

/// The centre, under the given name, and the generators of a body where its pose puts them.
pub fn placed(body: &Value, center: &str) -> Option<(Vec<RBig>, Vec<Vec<RBig>>)> {
    let (center, generators) = (vector(&body[center])?, vectors(&body["generators"])?);
    let Some(pose) = body.get("pose") else { return Some((center, generators)) };
    let (matrix, translation) = (vectors(&pose["matrix"])?, vector(&pose["translation"])?);
    let image = |v: &Vec<RBig>| matrix.iter().map(|row| dot(row, v)).collect::<Vec<_>>();
    let center = image(&center).iter().zip(&translation).map(|(x, moved)| x + moved).collect();
    Some((center, generators.iter().map(image).collect()))
}

/// Whether the certificate proves what that of the right answer does: that p lies in the zonotope of the generators,
/// or that it does not.
pub fn proves(
    p: &Option<Vec<RBig>>,
    generators: &Option<Vec<Vec<RBig>>>,
    right: &Value,
    changed: &Value,
) -> Option<bool> {
    let (p, generators) = (p.as_ref()?, generators.as_ref()?);
    let (old, certificate) = (&right["certificate"], &changed["certificate"]);
    if old.get("separating_direction").is_some() {
        let u = vector(&certificate["separating_direction"])?;
        let reach = generators.iter().fold(RBig::ZERO, |sum, g| sum + absolute(dot(&u, g)));
        return Some(u.len() == p.len() && dot(&u, p) > reach);
    }
    let coefficients = vector(&certificate["coefficients"])?;
    let basis = indices(&certificate["basis"])?;
    let is_within = |x: &RBig| absolute(x.clone()) <= RBig::ONE;
    if coefficients.len() != generators.len() || !coefficients.iter().all(is_within) {
        return Some(false);
    }
    let off = (0..generators.len()).filter(|i| !basis.contains(i));
    let rest = off.fold(p.clone(), |rest, i| {
        rest.iter().zip(&generators[i]).map(|(rest, g)| rest - &coefficients[i] * g).collect()
    });
    let columns: Option<Vec<&Vec<RBig>>> = basis.iter().map(|&b| generators.get(b)).collect();
    let exact = solved(&columns?, &rest)?;
    let is_beside = |(&b, exact): (&usize, &RBig)| {
        let (nearest, given) = (exact.to_f64().value(), certificate["coefficients"][b].as_f64());
        is_within(exact) && given.is_some_and(|given| (nearest.next_down()..=nearest.next_up()).contains(&given))
    };
    Some(basis.iter().zip(&exact).all(is_beside))
}

/// The first point of a chain and its steps; steps along one line may come in any order.
pub fn steps(result: &Value) -> Option<(Vec<RBig>, Vec<Vec<RBig>>)> {
    let chain = vectors(&result["chain"])?;
    if chain.iter().any(|point| point.len() != 2) {
        return None;
    }
    let mut steps: Vec<Vec<RBig>> = chain.windows(2).map(|pair| minus(&pair[1], &pair[0])).collect();
    steps.chunk_by_mut(|a, b| &a[0] * &b[1] == &a[1] * &b[0]).for_each(<[_]>::sort);
    Some((chain.first().cloned()?, steps))
}

/// Whether two values are the same, however their numbers are spelled.
pub fn is_same(right: &Value, changed: &Value) -> bool {
    match (right, changed) {
        (Value::Array(right), Value::Array(changed)) => {
            right.len() == changed.len() && right.iter().zip(changed).all(|(right, changed)| is_same(right, changed))
        }
        (Value::Object(right), Value::Object(changed)) => {
            right.len() == changed.len()
                && right.iter().all(|(name, right)| changed.get(name).is_some_and(|changed| is_same(right, changed)))
        }
        (Value::String(_), Value::String(_)) => match (number(right), number(changed)) {
            (Some(right), Some(changed)) => right == changed,
            _ => right == changed,
        },
        _ => right == changed || right.is_number() && right.as_f64() == changed.as_f64(),
    }
}

/// Whether value and point are those of a farthest point, but for rounding.
pub fn farthest(input: &Value, changed: &Value) -> Option<bool> {
    let (u, y) = (vector(&input["direction"])?, changed["point"].as_array()?);
    let (center, generators) = placed(input, "center")?;
    let size =
        |axis: usize| generators.iter().fold(absolute(center[axis].clone()), |sum, g| sum + absolute(g[axis].clone()));
    let same = RBig::try_from(SAME).ok()?;
    let smallest = RBig::try_from(f64::from_bits(1)).ok()?;
    let value = generators.iter().fold(dot(&u, &center), |sum, g| sum + absolute(dot(&u, g)));
    let scale = (0..u.len()).fold(RBig::ZERO, |sum, axis| sum + absolute(u[axis].clone()) * size(axis));
    let largest = RBig::try_from(f64::MAX).ok()?;
    let is_value = match changed["value"].as_str() {
        Some("Infinity") => value > largest,
        Some("-Infinity") => value < -largest.clone(),
        _ => absolute(number(&changed["value"])? - value) <= scale * &same + &smallest,
    };
    // The point must be one of the face of all farthest points, but for a box of rounding.
    let mut middle = center.clone();
    let mut face: Vec<Vec<RBig>> = Vec::new();
    for g in &generators {
        let along = dot(&u, g);
        if along == RBig::ZERO {
            face.push(g.clone());
        } else {
            let is_minus = along < RBig::ZERO;
            middle = middle.iter().zip(g).map(|(sum, c)| if is_minus { sum - c } else { sum + c }).collect();
        }
    }
    if y.len() != u.len() {
        return Some(false);
    }
    let mut target = Vec::new();
    for (axis, claimed) in y.iter().enumerate() {
        let mut room = size(axis) * &same + &smallest;
        // An infinite coordinate stands for all that are beyond the largest double.
        target.push(match claimed.as_str() {
            Some(name @ ("Infinity" | "-Infinity")) => {
                let beyond = &largest + size(axis);
                room += size(axis);
                if name == "Infinity" { beyond } else { -beyond }
            }
            _ => number(claimed)?,
        });
        face.push((0..u.len()).map(|other| if other == axis { room.clone() } else { RBig::ZERO }).collect());
    }
    Some(is_value && contains(&middle, &face, &target))
}

/// Whether a figure is the exact one but for rounding, to one of the doubles around it where these are far apart.
pub fn is_figure(exact: &RBig, claimed: &Value) -> Option<bool> {
    let largest = RBig::try_from(f64::MAX).ok()?;
    if claimed == "Infinity" {
        return Some(*exact > largest);
    }
    let off = absolute(exact - number(claimed)?);
    Some(off <= RBig::try_from(SAME).ok()? * exact || off < RBig::try_from(SMALLEST).ok()?)
}
