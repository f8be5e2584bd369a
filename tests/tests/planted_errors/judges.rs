//! Whether a changed answer is still true: from the definition, in rationals, given an answer that is right.

use dashu_ratio::RBig;
use serde_json::Value;

use crate::bounds::{self, Known};
use crate::proximity;
use crate::rationals::{absolute, dot, index, indices, minus, number, solved, vector, vectors};
use crate::truth::contains;

/// Figures within a relative error of this are the same but for rounding: both may be off by the stated 1e-12.
const SAME: f64 = 2.01e-12;

/// The relative distance from the lower bound up to which a value is called the least one.
const OPTIMAL: f64 = 1e-11;

/// Whether `changed` answers the question, as `right` does. What cannot be read is false. What takes long to find of
/// the question is kept in `known`.
pub fn is_true(kind: &str, input: &Value, right: &Value, changed: &Value, known: &mut Option<Known>) -> bool {
    let judged = match kind {
        "member" => {
            let body = placed(input, "center");
            let p = body.as_ref().zip(vector(&input["point"])).map(|((center, _), point)| minus(&point, center));
            Some(same_fields(&["member", "status"], right, changed)).zip(proves(
                &p,
                &body.map(|(_, generators)| generators),
                right,
                changed,
            ))
        }
        "intersect" => {
            let bodies = placed(&input["a"], "center").zip(placed(&input["b"], "center"));
            let p = bodies.as_ref().map(|((from, _), (to, _))| minus(to, from));
            let generators = bodies.map(|((_, a), (_, b))| [a, b].concat());
            Some(same_fields(&["intersects", "status"], right, changed)).zip(proves(&p, &generators, right, changed))
        }
        "distance" => proximity::judged(input, right, changed),
        "gauge" => {
            let body = placed(input, "p");
            let p = body.as_ref().zip(vector(&input["q"])).map(|((center, _), q)| minus(&q, center));
            let is_same =
                same_fields(&["at_most_one"], right, changed) && same_figure(&right["gauge"], &changed["gauge"]);
            Some(is_same).zip(proves(&p, &body.map(|(_, generators)| generators), right, changed))
        }
        "member_batch" => {
            let [old, new] = [right, changed].map(|result| result["gauge"].as_array());
            let figures = old.zip(new).map(|(old, new)| {
                old.len() == new.len() && old.iter().zip(new).all(|(old, new)| same_figure(old, new))
            });
            Some(same_fields(&["status"], right, changed)).zip(figures)
        }
        "support" => Some(true).zip(farthest(input, changed)),
        "combinatorics" | "slope_selection" | "upper_hull" => Some((true, is_same(right, changed))),
        "separator" => Some((steps(right).is_some(), steps(right) == steps(changed))),
        "hausdorff" => bounds::of_two_bodies(input, right, changed, known),
        "approx" | "reduce" => bounds::of_enclosing(kind, input, right, changed, known),
        // the order of the neighbours is free
        "walk" => {
            let sorted = |result: &Value| {
                let mut list = vectors(&result["neighbours"])?;
                list.sort();
                Some(list)
            };
            Some((true, sorted(right) == sorted(changed)))
        }
        "min_area" => least_area(input, right, changed),
        "min_length_dirs" => {
            // Value and bound of an answer tell by themselves whether it is optimal.
            if (right["status"] == "infeasible") != (changed["status"] == "infeasible") {
                Some((false, false))
            } else if right["status"] == "infeasible" {
                out_of_reach(input, changed)
            } else {
                cheapest(input, right, changed)
            }
        }
        "min_length_all" => shortest(input, right, changed),
        other => panic!("answers of the kind `{other}` are not judged"),
    };
    judged.is_some_and(|(first, second)| first && second)
}

pub fn same_fields(names: &[&str], right: &Value, changed: &Value) -> bool {
    names.iter().all(|name| right[name] == changed[name])
}

/// Whether two figures are the same but for rounding; zero and infinity are never rounded to.
pub fn same_figure(right: &Value, changed: &Value) -> bool {
    match (right.as_f64(), changed.as_f64()) {
        (Some(right), Some(changed)) if right != 0.0 => (changed - right).abs() <= SAME * right.abs(),
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

fn doubles(value: &Value) -> Option<Vec<f64>> {
    value.as_array()?.iter().map(Value::as_f64).collect()
}

/// The first point of a chain and its steps; steps along one line may come in any order.
fn steps(result: &Value) -> Option<(Vec<RBig>, Vec<Vec<RBig>>)> {
    let chain = vectors(&result["chain"])?;
    if chain.iter().any(|point| point.len() != 2) {
        return None;
    }
    let mut steps: Vec<Vec<RBig>> = chain.windows(2).map(|pair| minus(&pair[1], &pair[0])).collect();
    steps.chunk_by_mut(|a, b| &a[0] * &b[1] == &a[1] * &b[0]).for_each(<[_]>::sort);
    Some((chain.first().cloned()?, steps))
}

/// Whether two values are the same, however their numbers are spelled.
fn is_same(right: &Value, changed: &Value) -> bool {
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
fn farthest(input: &Value, changed: &Value) -> Option<bool> {
    let (u, y) = (vector(&input["direction"])?, vector(&changed["point"])?);
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
        Some("-Infinity") => value < -largest,
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
    for axis in 0..u.len() {
        let room = size(axis) * &same + &smallest;
        face.push((0..u.len()).map(|other| if other == axis { room.clone() } else { RBig::ZERO }).collect());
    }
    Some(y.len() == u.len() && is_value && contains(&middle, &face, &y))
}

/// Whether all points of a question lie in the zonotope of an answer.
fn encloses(input: &Value, center: &Value, generators: &[Vec<RBig>]) -> Option<bool> {
    let (points, center) = (vectors(&input["points"])?, vector(center)?);
    let has_shape = |v: &Vec<RBig>| v.len() == points.first().map_or(0, Vec::len);
    let is_shaped = has_shape(&center) && generators.iter().all(has_shape);
    let used: Vec<Vec<RBig>> = generators.iter().filter(|g| g.iter().any(|c| *c != RBig::ZERO)).cloned().collect();
    Some(is_shaped && points.iter().all(|point| contains(&center, &used, point)))
}

fn least_area(input: &Value, right: &Value, changed: &Value) -> Option<(bool, bool)> {
    let exact = vectors(&changed["generators"])?;
    let encloses = encloses(input, &changed["center"], &exact)?;
    let pairs = (0..exact.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
    let area = pairs.fold(RBig::ZERO, |sum, (i, j)| {
        sum + RBig::from(4) * absolute(&exact[i][0] * &exact[j][1] - &exact[i][1] * &exact[j][0])
    });
    let is_area = near(&area, &changed["area"])? && same_figure(&right["area"], &changed["area"]);
    let (least, most) = (number(&changed["lower_bound"])?, number(&right["area"])?);
    let smallest = RBig::try_from(f64::MIN_POSITIVE).ok()?;
    let allowed = RBig::try_from(SAME).ok()? * &most + rounding(&vectors(&input["points"])?)?;
    let is_near = least >= &most - allowed * RBig::from(2) - smallest;
    let is_bound = least <= most && is_near && bounds_area(input, right, changed)?;
    Some((encloses && is_area, is_bound))
}

fn near(exact: &RBig, claimed: &Value) -> Option<bool> {
    let claimed = claimed.as_f64()?;
    Some((exact.to_f64().value() - claimed).abs() <= SAME * claimed.abs())
}

/// The amount that rounding centre and generators to doubles may add to an area: (2^-49 · largest coordinate + 2^-1068)
/// · (width + height).
fn rounding(points: &[Vec<RBig>]) -> Option<RBig> {
    let extent = |axis: usize| {
        let (least, most) = (points.iter().map(|p| &p[axis]).min()?, points.iter().map(|p| &p[axis]).max()?);
        Some(most - least)
    };
    let largest = points.iter().flatten().map(|c| absolute(c.clone())).max()?;
    let [unit, floor] = [2.0_f64.powi(-49), 64.0 * f64::from_bits(1)].map(|x| RBig::try_from(x).unwrap_or_default());
    Some((largest * unit + floor) * (extent(0)? + extent(1)?))
}

/// Whether the certificate proves the bound: its hull and farthest vertices are the right answer's or as good, its
/// coefficients close the hull, and they lose nothing where the right ones do not.
fn bounds_area(input: &Value, right: &Value, changed: &Value) -> Option<bool> {
    let certificate = &changed["certificate"];
    let points = vectors(&input["points"])?;
    let at = |value: &Value| -> Option<Vec<Vec<RBig>>> {
        indices(value)?.into_iter().map(|index| points.get(index).cloned()).collect()
    };
    let hull = at(&certificate["hull"])?;
    if hull != at(&right["certificate"]["hull"])? {
        return Some(false);
    }
    if hull.len() < 3 {
        return Some(true);
    }
    let (farthest, basis) = (indices(&certificate["farthest"])?, indices(&certificate["basis"])?);
    let mut coefficients = vector(&certificate["coefficients"])?;
    if farthest.len() != hull.len() || coefficients.len() != hull.len() || basis.iter().any(|&b| b >= hull.len()) {
        return Some(false);
    }
    let edges: Vec<Vec<RBig>> = (0..hull.len()).map(|t| minus(&hull[(t + 1) % hull.len()], &hull[t])).collect();
    let cross = |a: &[RBig], b: &[RBig]| &a[0] * &b[1] - &a[1] * &b[0];
    let is_farthest = edges.iter().zip(&farthest).all(|(edge, &far)| {
        hull.get(far).is_some_and(|far| hull.iter().all(|other| cross(edge, other) <= cross(edge, far)))
    });
    if !is_farthest || basis.iter().any(|&b| coefficients[b] != RBig::ZERO) {
        return Some(false);
    }
    let mut open = vec![RBig::ZERO; 2];
    for (edge, coefficient) in edges.iter().zip(&coefficients) {
        open = open.iter().zip(edge).map(|(open, x)| open - coefficient * x).collect();
    }
    let columns: Vec<&Vec<RBig>> = basis.iter().map(|&b| &edges[b]).collect();
    for (&b, exact) in basis.iter().zip(solved(&columns, &open)?) {
        coefficients[b] = exact;
    }
    let center = vector(&right["center"])?;
    let lost = (0..hull.len()).fold(RBig::ZERO, |lost, t| {
        let from = minus(&minus(&center, &hull[t]), &minus(&hull[farthest[t]], &center));
        let v = cross(&edges[t], &from);
        lost + absolute(v.clone()) - &coefficients[t] * v
    });
    let is_within = coefficients.into_iter().all(|c| absolute(c) <= RBig::ONE);
    let allowed = RBig::try_from(SAME).ok()? * number(&right["area"])? + rounding(&points)?;
    Some(is_within && lost <= allowed * RBig::from(2))
}

/// The points and vectors of forces that add up to zero, and what they gain.
fn balanced(input: &Value, changed: &Value) -> Option<(Vec<Vec<RBig>>, RBig)> {
    let points = vectors(&input["points"])?;
    let dimension = points[0].len();
    let mut vectors = Vec::new();
    let mut gain = RBig::ZERO;
    for force in changed["certificate"]["forces"].as_array()? {
        let own = vector(&force["vector"])?;
        let point = points.get(index(&force["point"])?)?;
        gain += dot(&own, point);
        vectors.push(own);
    }
    let is_shaped = vectors.iter().all(|own| own.len() == dimension);
    let zero = |axis| vectors.iter().fold(RBig::ZERO, |sum, own: &Vec<RBig>| sum + &own[axis]) == RBig::ZERO;
    (is_shaped && (0..dimension).all(zero)).then_some((vectors, gain))
}

fn cheapest(input: &Value, right: &Value, changed: &Value) -> Option<(bool, bool)> {
    let (directions, weights) = (vectors(&input["directions"])?, vector(&input["weights"])?);
    let coefficients = vector(&changed["coefficients"])?;
    let has_shape = coefficients.len() == directions.len() && coefficients.iter().all(|c| *c >= RBig::ZERO);
    let generators = directions.iter().zip(&coefficients).map(|(v, c)| v.iter().map(|x| x * c).collect());
    let generators: Vec<Vec<RBig>> = generators.collect();
    let body = encloses(input, &changed["center"], &generators)? && has_shape;
    let value =
        near(&dot(&coefficients, &weights), &changed["value"])? && same_figure(&right["value"], &changed["value"]);
    let (forces, gain) = balanced(input, changed)?;
    let is_loaded = directions.iter().zip(&weights).all(|(direction, weight)| {
        forces.iter().fold(RBig::ZERO, |load, force| load + absolute(dot(force, direction))) <= *weight
    });
    let (least, cost) = (number(&changed["lower_bound"])?, number(&changed["value"])?);
    let gap = RBig::try_from(OPTIMAL).ok()? * &least;
    let is_called = changed["status"] == if cost - &least <= gap { "optimal" } else { "feasible" };
    Some((body && value, is_loaded && least <= gain && is_called))
}

fn out_of_reach(input: &Value, changed: &Value) -> Option<(bool, bool)> {
    let certificate = &changed["certificate"];
    let (points, functional) = (vectors(&input["points"])?, vector(&certificate["functional"])?);
    let [a, b] = <[usize; 2]>::try_from(indices(&certificate["points"])?).ok()?;
    let apart = dot(&functional, &minus(points.get(a)?, points.get(b)?)) != RBig::ZERO;
    let vanishes = vectors(&input["directions"])?.iter().all(|v| dot(&functional, v) == RBig::ZERO);
    Some((apart && functional.len() == points[0].len(), vanishes))
}

fn shortest(input: &Value, right: &Value, changed: &Value) -> Option<(bool, bool)> {
    let generators: Vec<Vec<f64>> = changed["generators"].as_array()?.iter().map(doubles).collect::<Option<_>>()?;
    // Relative to the largest component, no square leaves the range of doubles.
    let largest = generators.iter().flatten().fold(f64::MIN_POSITIVE, |largest, x| largest.max(x.abs()));
    let lengths = generators.iter().map(|g| g.iter().map(|x| (x / largest).powi(2)).sum::<f64>().sqrt());
    let length = largest * lengths.sum::<f64>();
    let claimed = changed["length"].as_f64()?;
    let exact = vectors(&changed["generators"])?;
    let body = encloses(input, &changed["center"], &exact)? && (length - claimed).abs() <= SAME * length;
    let bound = number(&changed["lower_bound"])?;
    let is_ratio = same_figure(&right["ratio"], &changed["ratio"])
        || bound != RBig::ZERO && near(&(number(&changed["length"])? / &bound), &changed["ratio"])?;
    let fields = same_fields(&["within_epsilon"], right, changed) || changed.get("within_epsilon").is_none();
    let (forces, gain) = balanced(input, changed)?;
    let dimension = input["points"][0].as_array()?.len();
    let farthest = (0..1_u32 << forces.len()).fold(RBig::ZERO, |farthest, signs| {
        let zero = vec![RBig::ZERO; dimension];
        let corner = forces.iter().enumerate().fold(zero, |corner, (i, force)| {
            let sign = if signs >> i & 1 == 0 { RBig::ONE } else { RBig::NEG_ONE };
            corner.iter().zip(force).map(|(corner, x)| corner + &sign * x).collect()
        });
        farthest.max(dot(&corner, &corner))
    });
    let is_bound = bound <= RBig::ZERO || gain >= RBig::ZERO && &bound * &bound * farthest <= &gain * &gain;
    Some((body && is_ratio && fields, is_bound))
}
