//! Whether a changed answer about a body around points is still true.

use dashu_ratio::RBig;
use serde_json::Value;

use crate::judges::{SAME, SMALLEST, is_figure, same_figure};
use crate::rationals::{absolute, dot, index, indices, minus, number, solved, vector, vectors};
use crate::truth::contains;

/// The relative distance from the lower bound up to which a value is called the least one.
const OPTIMAL: f64 = 1e-11;

/// Whether all points of a question lie in the zonotope of an answer.
fn encloses(input: &Value, center: &Value, generators: &[Vec<RBig>]) -> Option<bool> {
    let (points, center) = (vectors(&input["points"])?, vector(center)?);
    let has_shape = |v: &Vec<RBig>| v.len() == points.first().map_or(0, Vec::len);
    let is_shaped = has_shape(&center) && generators.iter().all(has_shape);
    let used: Vec<Vec<RBig>> = generators.iter().filter(|g| g.iter().any(|c| *c != RBig::ZERO)).cloned().collect();
    Some(is_shaped && points.iter().all(|point| contains(&center, &used, point)))
}

pub fn least_area(input: &Value, right: &Value, changed: &Value) -> Option<(bool, bool)> {
    let exact = vectors(&changed["generators"])?;
    let encloses = encloses(input, &changed["center"], &exact)?;
    let (area, most) = (area(&exact), area(&vectors(&right["generators"])?));
    let rounding = rounding(&vectors(&input["points"])?)?;
    let allowed = RBig::try_from(SAME).ok()? * &most + &rounding * RBig::from(2);
    let is_area = is_figure(&area, &changed["area"])? && area <= &most + &allowed;
    let largest = RBig::try_from(f64::MAX).ok()?;
    let least = number(&changed["lower_bound"])?;
    let weaker =
        RBig::try_from(SAME).ok()? * &most + rounding * RBig::from(2) + RBig::try_from(f64::MIN_POSITIVE).ok()?;
    let told = (&most).min(&largest) - weaker;
    let is_bound = least <= most && least >= told && bounds_area(input, right, changed, &most)?;
    Some((encloses && is_area, is_bound))
}

/// Four times the sum of |g × h| over all pairs of generators.
fn area(generators: &[Vec<RBig>]) -> RBig {
    let pairs = (0..generators.len()).flat_map(|i| (0..i).map(move |j| [&generators[i], &generators[j]]));
    pairs.fold(RBig::ZERO, |sum, [g, h]| sum + RBig::from(4) * absolute(&g[0] * &h[1] - &g[1] * &h[0]))
}

/// The amount that rounding centre and generators to doubles may add to an area: (2^-49 · largest coordinate along an
/// axis +
/// 2^-1068) · extent along the other one; nothing where an extent is zero.
fn rounding(points: &[Vec<RBig>]) -> Option<RBig> {
    let [unit, floor] = [2.0_f64.powi(-49), 64.0 * f64::from_bits(1)].map(|x| RBig::try_from(x).unwrap_or_default());
    let along = |axis: usize| {
        let (least, most) = (points.iter().map(|p| &p[axis]).min()?, points.iter().map(|p| &p[axis]).max()?);
        let largest = absolute(least.clone()).max(absolute(most.clone()));
        Some((most - least, largest * &unit + &floor))
    };
    let ((width, off_in_x), (height, off_in_y)) = (along(0)?, along(1)?);
    let is_flat = width == RBig::ZERO || height == RBig::ZERO;
    Some(if is_flat { RBig::ZERO } else { width * off_in_y + height * off_in_x })
}

/// Whether the certificate proves the bound: its hull and farthest vertices are the right answer's or as good, its
/// coefficients close the hull, and they lose nothing where the right ones do not.
fn bounds_area(input: &Value, right: &Value, changed: &Value, area: &RBig) -> Option<bool> {
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
    let allowed = RBig::try_from(SAME).ok()? * area + rounding(&points)?;
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

pub fn cheapest(input: &Value, right: &Value, changed: &Value) -> Option<(bool, bool)> {
    let (directions, weights) = (vectors(&input["directions"])?, vector(&input["weights"])?);
    let coefficients = vector(&changed["coefficients"])?;
    let has_shape = coefficients.len() == directions.len() && coefficients.iter().all(|c| *c >= RBig::ZERO);
    let generators = directions.iter().zip(&coefficients).map(|(v, c)| v.iter().map(|x| x * c).collect());
    let generators: Vec<Vec<RBig>> = generators.collect();
    let body = encloses(input, &changed["center"], &generators)? && has_shape;
    // what is called feasible alone need not cost as little as the right answer
    let is_as_cheap = changed["status"] == "feasible" || same_figure(&right["value"], &changed["value"]);
    let value = is_figure(&dot(&coefficients, &weights), &changed["value"])? && is_as_cheap;
    let (forces, gain) = balanced(input, changed)?;
    let is_loaded = directions.iter().zip(&weights).all(|(direction, weight)| {
        forces.iter().fold(RBig::ZERO, |load, force| load + absolute(dot(force, direction))) <= *weight
    });
    let (least, cost) = (number(&changed["lower_bound"])?, number(&changed["value"])?);
    let gap = RBig::try_from(OPTIMAL).ok()? * &least;
    let is_called = changed["status"] == if cost - &least <= gap { "optimal" } else { "feasible" };
    Some((body && value, is_loaded && least <= gain && is_called))
}

pub fn out_of_reach(input: &Value, changed: &Value) -> Option<(bool, bool)> {
    let certificate = &changed["certificate"];
    let (points, functional) = (vectors(&input["points"])?, vector(&certificate["functional"])?);
    let [a, b] = <[usize; 2]>::try_from(indices(&certificate["points"])?).ok()?;
    let apart = dot(&functional, &minus(points.get(a)?, points.get(b)?)) != RBig::ZERO;
    let vanishes = vectors(&input["directions"])?.iter().all(|v| dot(&functional, v) == RBig::ZERO);
    Some((apart && functional.len() == points[0].len(), vanishes))
}

/// Whether an answer says of its length that it is within 1 + ε of its bound, or that it is not, as it is but for
/// rounding, or says nothing of it.
fn is_called_rightly(input: &Value, changed: &Value) -> Option<bool> {
    let Some(claim) = changed.get("within_epsilon") else { return Some(true) };
    let [length, bound, epsilon] = [&changed["length"], &changed["lower_bound"], &input["epsilon"]].map(number);
    let (length, most) = (length?, bound? * (RBig::ONE + epsilon?));
    let room = RBig::try_from(SAME).ok()? * &length;
    Some(if claim.as_bool()? { length <= most + room } else { length + room >= most })
}

/// Whether a length is within 1 + ε of its bound but for what rounding costs: 2^-46 times the largest coordinate of
/// each axis on which the points differ, at least the smallest normal double.
fn is_short(input: &Value, changed: &Value) -> Option<bool> {
    let [length, bound, epsilon] = [&changed["length"], &changed["lower_bound"], &input["epsilon"]].map(number);
    let (length, points) = (length?, vectors(&input["points"])?);
    let [unit, least] = [2.0_f64.powi(-46), f64::MIN_POSITIVE].map(|x| RBig::try_from(x).unwrap_or_default());
    let along = |axis: usize| {
        let is_one = points.iter().all(|point| point[axis] == points[0][axis]);
        let largest = points.iter().fold(least.clone(), |largest, point| largest.max(absolute(point[axis].clone())));
        if is_one { RBig::ZERO } else { largest }
    };
    let rounding = (0..points[0].len()).fold(RBig::ZERO, |sum, axis| sum + along(axis)) * unit;
    let room = RBig::try_from(SAME).ok()? * &length + rounding;
    Some(length <= bound? * (RBig::ONE + epsilon?) + room)
}

pub fn shortest(input: &Value, right: &Value, changed: &Value) -> Option<(bool, bool)> {
    let generators: Vec<Vec<f64>> = changed["generators"].as_array()?.iter().map(doubles).collect::<Option<_>>()?;
    // Relative to the largest component, no square leaves the range of doubles.
    let largest = generators.iter().flatten().fold(f64::MIN_POSITIVE, |largest, x| largest.max(x.abs()));
    let lengths = generators.iter().map(|g| g.iter().map(|x| (x / largest).powi(2)).sum::<f64>().sqrt());
    let length = largest * lengths.sum::<f64>();
    let claimed = changed["length"].as_f64()?;
    let exact = vectors(&changed["generators"])?;
    let body = encloses(input, &changed["center"], &exact)? && (length - claimed).abs() <= SAME * length + SMALLEST;
    let bound = number(&changed["lower_bound"])?;
    // Who bounds the number of generators gets the ratio that is found.
    let is_free = input.get("max_generators").is_some();
    let is_ratio = same_figure(&right["ratio"], &changed["ratio"])
        || bound == RBig::ZERO && claimed > 0.0 && changed["ratio"] == "Infinity"
        || bound != RBig::ZERO && is_figure(&(number(&changed["length"])? / &bound), &changed["ratio"])?;
    let fields = is_called_rightly(input, changed)? && (is_free || is_short(input, changed)?);
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

fn doubles(value: &Value) -> Option<Vec<f64>> {
    value.as_array()?.iter().map(Value::as_f64).collect()
}
