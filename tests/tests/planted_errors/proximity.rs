//! Whether a changed answer about the distance of two bodies is still true.

use dashu_ratio::RBig;
use serde_json::Value;

use crate::judges::{self, placed, proves, same_fields, same_figure};
use crate::rationals::{absolute, dot, indices, minus, number, solved, vector};
use crate::truth::{reach, squared_depth};

/// Bounds of a depth differ by this much of the upper one.
const DEPTH_ACCURACY: f64 = 0.01;

/// The question in rationals.
struct Question {
    p: Vec<RBig>,
    generators: Vec<Vec<RBig>>,
    /// The number of generators of the first body.
    count: usize,
}

/// Whether `changed` answers the question, as `right` does: the status with its proof, and everything else.
pub fn judged(input: &Value, right: &Value, changed: &Value) -> Option<(bool, bool)> {
    let [(from, own), (to, others)] = [placed(&input["a"], "center")?, placed(&input["b"], "center")?];
    let (p, count) = (minus(&to, &from), own.len());
    let question = Question { p, generators: [own, others].concat(), count };
    let is_same = same_fields(&["status", "features"], right, changed)
        && same_figure(&right["distance"], &changed["distance"])
        && is_one_point(right, changed);
    let is_common = right["status"] != "outside";
    // Any common point of bodies that meet is right, and so are any nearest ones of others: along parallel edges there
    // are many.
    let is_placed = if is_common {
        let point = common_point(&question, from.clone(), &changed["certificate"])?;
        is_near(input, &point, &changed["nearest"]["a"])
    } else {
        true
    };
    let is_proved = proves(&Some(question.p.clone()), &Some(question.generators.clone()), right, changed)?;
    let parts = match right["status"].as_str()? {
        "outside" => {
            let points = nearest_points(&question, from, &changed["distance_certificate"])?;
            let is_that = |(name, point): (&str, &Vec<RBig>)| is_near(input, point, &changed["nearest"][name]);
            points.is_some_and(|points| ["a", "b"].into_iter().zip(&points).all(is_that))
        }
        "boundary" => {
            supports(&question, right, changed)? && judges::is_same(&right["penetration"], &changed["penetration"])
        }
        _ => is_deep(&question, &changed["penetration"])?,
    };
    Some((is_same && is_placed && is_proved, parts))
}

/// Whether the nearest points of bodies that meet are one.
fn is_one_point(right: &Value, changed: &Value) -> bool {
    let [a, b] = ["a", "b"].map(|name| coordinates(&changed["nearest"][name]));
    right["status"] == "outside" || a == b
}

/// A point of which infinite coordinates count as the largest double.
fn coordinates(point: &Value) -> Option<Vec<RBig>> {
    let largest = RBig::try_from(f64::MAX).ok()?;
    let coordinate = |value: &Value| match value.as_str() {
        Some("Infinity") => Some(largest.clone()),
        Some("-Infinity") => Some(-largest.clone()),
        _ => number(value),
    };
    point.as_array()?.iter().map(coordinate).collect()
}

/// The point of the first body, around `center`, that the coefficients of a certificate make.
fn common_point(question: &Question, center: Vec<RBig>, certificate: &Value) -> Option<Vec<RBig>> {
    let (mut coefficients, basis) = (vector(&certificate["coefficients"])?, indices(&certificate["basis"])?);
    let add = |sum: Vec<RBig>, factor: &RBig, g: &[RBig]| -> Vec<RBig> {
        sum.iter().zip(g).map(|(sum, c)| sum + factor * c).collect()
    };
    let off = (0..question.generators.len()).filter(|index| !basis.contains(index));
    let rest = off.fold(question.p.clone(), |rest, i| add(rest, &-&coefficients[i], &question.generators[i]));
    let columns: Option<Vec<&Vec<RBig>>> = basis.iter().map(|&index| question.generators.get(index)).collect();
    for (&index, exact) in basis.iter().zip(solved(&columns?, &rest)?) {
        coefficients[index] = exact;
    }
    let own = question.generators.iter().zip(&coefficients).take(question.count);
    let point = own.fold(center, |sum, (g, factor)| add(sum, factor, g));
    Some(within_doubles(point))
}

/// A point of which coordinates beyond the doubles count as the largest one, as [`coordinates`] reads infinities.
fn within_doubles(point: Vec<RBig>) -> Vec<RBig> {
    let largest = RBig::try_from(f64::MAX).unwrap_or_default();
    point.into_iter().map(|c| c.min(largest.clone()).max(-largest.clone())).collect()
}

/// Whether a point is the same but for rounding.
fn is_near(input: &Value, right: &[RBig], changed: &Value) -> bool {
    let Some(changed) = coordinates(changed) else { return false };
    let bodies = [placed(&input["a"], "center"), placed(&input["b"], "center")];
    let size = bodies.iter().flatten().flat_map(|(center, list)| center.iter().chain(list.iter().flatten()));
    let size = size.fold(RBig::ZERO, |sum, c| sum + absolute(c.clone()));
    let [room, smallest] = [4.0 * f64::EPSILON, f64::from_bits(1)].map(|x| RBig::try_from(x).unwrap_or_default());
    let allowed = size * room + smallest;
    right.len() == changed.len() && right.iter().zip(&changed).all(|(a, b)| absolute(a - b) <= allowed)
}

/// The points of the bodies, the first one around `center`, that the coefficients of a certificate make, if they prove
/// them nearest: r = p − Σ δ_i g_i leads nowhere nearer.
fn nearest_points(question: &Question, center: Vec<RBig>, certificate: &Value) -> Option<Option<[Vec<RBig>; 2]>> {
    let (coefficients, basis) = (vector(&certificate["coefficients"])?, indices(&certificate["basis"])?);
    if coefficients.len() != question.generators.len() {
        return Some(None);
    }
    let taken = |residual: &[RBig], factor: &RBig, g: &[RBig]| -> Vec<RBig> {
        residual.iter().zip(g).map(|(rest, c)| rest - factor * c).collect()
    };
    let off = (0..coefficients.len()).filter(|index| !basis.contains(index));
    let rest = off.fold(question.p.clone(), |rest, i| taken(&rest, &coefficients[i], &question.generators[i]));
    let columns: Option<Vec<&Vec<RBig>>> = basis.iter().map(|&index| question.generators.get(index)).collect();
    let columns = columns?;
    let products = |v: &[RBig]| -> Vec<RBig> { columns.iter().map(|column| dot(column, v)).collect() };
    let gram: Vec<Vec<RBig>> = columns.iter().map(|column| products(column)).collect();
    let exact = solved(&gram.iter().collect::<Vec<_>>(), &products(&rest))?;
    let mut all = coefficients;
    let mut residual = rest;
    for ((&index, exact), column) in basis.iter().zip(exact).zip(&columns) {
        let (nearest, given) = (exact.to_f64().value(), certificate["coefficients"][index].as_f64()?);
        if !(nearest.next_down()..=nearest.next_up()).contains(&given) {
            return Some(None);
        }
        residual = taken(&residual, &exact, column);
        all[index] = exact;
    }
    let is_extreme = |(g, delta): (&Vec<RBig>, &RBig)| {
        let along = dot(g, &residual);
        absolute(delta.clone()) <= RBig::ONE
            && (along == RBig::ZERO || *delta == if along > RBig::ZERO { RBig::ONE } else { -RBig::ONE })
    };
    let is_nearest = residual.iter().any(|c| *c != RBig::ZERO) && question.generators.iter().zip(&all).all(is_extreme);
    let own = question.generators.iter().zip(&all).take(question.count);
    let first = own.fold(center, |sum, (g, delta)| taken(&sum, &-delta, g));
    let second = first.iter().zip(&residual).map(|(x, rest)| x + rest).collect();
    Some(is_nearest.then(|| [first, second].map(within_doubles)))
}

/// Whether the hyperplane supports both bodies, in faces of the dimensions of the right one.
fn supports(question: &Question, right: &Value, changed: &Value) -> Option<bool> {
    let [old, new] = [vector(&right["contact_normal"])?, vector(&changed["contact_normal"])?];
    let reach = question.generators.iter().fold(RBig::ZERO, |sum, g| sum + absolute(dot(&new, g)));
    let is_supporting =
        new.len() == question.p.len() && new.iter().any(|c| *c != RBig::ZERO) && dot(&new, &question.p) == reach;
    let ranks = |u: &[RBig]| -> [usize; 2] {
        let (own, others) = question.generators.split_at(question.count);
        [own, others].map(|list| {
            let mut independent: Vec<&Vec<RBig>> = Vec::new();
            for g in list.iter().filter(|g| dot(u, g) == RBig::ZERO) {
                if solved(&independent, g).is_none() {
                    independent.push(g);
                }
            }
            independent.len()
        })
    };
    Some(is_supporting && ranks(&old) == ranks(&new))
}

/// Whether the bounds are true and near each other, and the direction is one in which it is that deep.
fn is_deep(question: &Question, changed: &Value) -> Option<bool> {
    let (lower, u) = (number(&changed["lower"])?, vector(&changed["direction"])?);
    let is_infinite = changed["upper"] == "Infinity";
    // A bound that is rounded up leaves the range of doubles where the depth nearly does.
    let nearly = RBig::try_from(1.0 - 1e-12).ok()? * RBig::try_from(f64::MAX).ok()?;
    let upper = if is_infinite { nearly } else { number(&changed["upper"])? };
    let squared = squared_depth(&question.p, &question.generators)?;
    let is_true = lower >= RBig::ZERO
        && &lower * &lower <= squared
        && (&upper * &upper >= squared) != is_infinite
        && &lower + RBig::try_from(f64::from_bits(64)).ok()? >= &upper * RBig::try_from(1.0 - DEPTH_ACCURACY).ok()?;
    let along = reach(&u, &question.generators) - dot(&u, &question.p);
    let size = question.generators.iter().flatten().fold(RBig::ZERO, |sum, c| sum + absolute(c.clone()));
    let most = upper + size * RBig::try_from(4.0 * f64::EPSILON).ok()?;
    let length = dot(&u, &u);
    let accuracy = RBig::try_from(1.0 - DEPTH_ACCURACY).ok()?;
    let is_near = is_infinite && &along * &along * &accuracy * accuracy <= &squared * &length;
    let is_about = length > RBig::ZERO && (is_near || &along * &along <= &most * &most * length);
    Some(u.len() == question.p.len() && is_true && is_about)
}
