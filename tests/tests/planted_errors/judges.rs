//! Whether a changed answer is still true: from the definition, in rationals, given an answer that is right.

use dashu_ratio::RBig;
use serde_json::Value;
use zonotope::collision::{Query, brute_force};

use crate::proximity;
use crate::rationals::{absolute, dot, index, indices, minus, number, solved, vector, vectors};

/// Figures within a relative error of this are the same but for rounding; planted errors are far smaller or far larger.
const SAME: f64 = 1e-10;

/// Whether `changed` answers the question, as `right` does. What cannot be read is false.
pub fn is_true(kind: &str, input: &Value, right: &Value, changed: &Value) -> bool {
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
        "support" => Some(true).zip(farthest(input, &right["value"], changed)),
        "combinatorics" | "slope_selection" | "separator" | "upper_hull" => Some((true, right == changed)),
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
            if right["status"] != changed["status"] {
                Some((false, false))
            } else if right["status"] == "optimal" {
                cheapest(input, right, changed)
            } else {
                out_of_reach(input, changed)
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

/// Whether two points are the same but for rounding.
pub fn is_near(right: &Value, changed: &Value) -> bool {
    let Some((right, changed)) = doubles(right).zip(doubles(changed)) else { return false };
    let size: f64 = right.iter().map(|c| c.abs()).sum();
    let is_beside = |(a, b): (&f64, &f64)| (a - b).abs() <= SAME * (1.0 + size);
    right.len() == changed.len() && right.iter().zip(&changed).all(is_beside)
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

/// Whether a zonotope contains a point.
fn contains(center: &[f64], generators: &[Vec<f64>], point: &[f64]) -> bool {
    match center.len() {
        2 => contains_in::<2>(center, generators, point),
        _ => contains_in::<3>(center, generators, point),
    }
}

fn contains_in<const D: usize>(center: &[f64], generators: &[Vec<f64>], point: &[f64]) -> bool {
    let array = |v: &[f64]| <[f64; D]>::try_from(v).expect("one dimension");
    let generators: Vec<[f64; D]> = generators.iter().map(|g| array(g)).collect();
    let query = Query::new(array(center), array(point), &generators).expect("finite");
    brute_force::locate(&query).is_member()
}

/// Whether value and point are those of a farthest point, but for rounding.
fn farthest(input: &Value, value: &Value, changed: &Value) -> Option<bool> {
    let (u, center, y) = (doubles(&input["direction"])?, doubles(&input["center"])?, doubles(&changed["point"])?);
    let mut generators: Vec<Vec<f64>> = input["generators"].as_array()?.iter().map(doubles).collect::<Option<_>>()?;
    let size = center.iter().chain(generators.iter().flatten()).fold(0.0, |sum: f64, x| sum + x.abs());
    let room = SAME * size;
    let along: f64 = u.iter().zip(&y).map(|(u, y)| u * y).sum();
    let length: f64 = u.iter().map(|u| u.abs()).sum();
    generators
        .extend((0..u.len()).map(|axis| (0..u.len()).map(|other| if other == axis { room } else { 0.0 }).collect()));
    let is_near = |along: f64| Some((along - value.as_f64()?).abs() <= 2.0 * room * length);
    let is_value = is_near(changed["value"].as_f64()?)? && is_near(along)?;
    Some(y.len() == u.len() && is_value && contains(&center, &generators, &y))
}

/// Whether all points of a question in the plane lie in the zonotope of an answer: each is held against every edge,
/// and, for bodies without area, against their ends.
fn encloses(input: &Value, center: &Value, generators: &[Vec<RBig>]) -> Option<bool> {
    let (points, center) = (vectors(&input["points"])?, vector(center)?);
    let is_planar = |v: &Vec<RBig>| v.len() == 2;
    let holds = |p: &Vec<RBig>| {
        let p = minus(p, &center);
        let is_within = |u: &[RBig]| {
            let reach = generators.iter().fold(RBig::ZERO, |sum, g| sum + absolute(dot(u, g)));
            absolute(dot(u, &p)) <= reach
        };
        let axes = [vec![RBig::ONE, RBig::ZERO], vec![RBig::ZERO, RBig::ONE]];
        generators.iter().all(|g| is_within(&[-g[1].clone(), g[0].clone()])) && axes.iter().all(|u| is_within(u))
    };
    Some(is_planar(&center) && generators.iter().all(is_planar) && points.iter().all(holds))
}

fn rows(value: &Value) -> Option<Vec<Vec<f64>>> {
    value.as_array()?.iter().map(doubles).collect()
}

fn least_area(input: &Value, right: &Value, changed: &Value) -> Option<(bool, bool)> {
    let exact = vectors(&changed["generators"])?;
    let encloses = encloses(input, &changed["center"], &exact)?;
    let pairs = (0..exact.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
    let area = pairs.fold(RBig::ZERO, |sum, (i, j)| {
        sum + RBig::from(4) * absolute(&exact[i][0] * &exact[j][1] - &exact[i][1] * &exact[j][0])
    });
    let is_area = near(&area, &changed["area"])? && same_figure(&right["area"], &changed["area"]);
    let is_bound = number(&changed["lower_bound"])? <= number(&right["area"])? && bounds_area(input, right, changed)?;
    Some((encloses && is_area, is_bound))
}

fn near(exact: &RBig, claimed: &Value) -> Option<bool> {
    let claimed = claimed.as_f64()?;
    Some((exact.to_f64().value() - claimed).abs() <= SAME * claimed.abs())
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
    Some(is_within && lost.to_f64().value() <= SAME * right["area"].as_f64()?)
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
    Some((body && value, is_loaded && number(&changed["lower_bound"])? <= gain))
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
    let generators = rows(&changed["generators"])?;
    let length: f64 = generators.iter().map(|g| g.iter().map(|x| x * x).sum::<f64>().sqrt()).sum();
    let claimed = changed["length"].as_f64()?;
    let exact = vectors(&changed["generators"])?;
    let body = encloses(input, &changed["center"], &exact)? && (length - claimed).abs() <= SAME * length;
    let bound = number(&changed["lower_bound"])?;
    let is_ratio = same_figure(&right["ratio"], &changed["ratio"])
        || bound != RBig::ZERO && near(&(number(&changed["length"])? / &bound), &changed["ratio"])?;
    let fields = same_fields(&["within_epsilon"], right, changed) || changed.get("within_epsilon").is_none();
    let (forces, gain) = balanced(input, changed)?;
    let farthest = (0..1_u32 << forces.len()).fold(RBig::ZERO, |farthest, signs| {
        let zero = vec![RBig::ZERO; 2];
        let corner = forces.iter().enumerate().fold(zero, |corner, (i, force)| {
            let sign = if signs >> i & 1 == 0 { RBig::ONE } else { RBig::NEG_ONE };
            corner.iter().zip(force).map(|(corner, x)| corner + &sign * x).collect()
        });
        farthest.max(dot(&corner, &corner))
    });
    let is_bound = bound <= RBig::ZERO || gain >= RBig::ZERO && &bound * &bound * farthest <= &gain * &gain;
    Some((body && is_ratio && fields, is_bound))
}
