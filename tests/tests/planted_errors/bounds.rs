//! Whether changed bounds of the distance of two bodies, and a changed body around another one, are still true.

use dashu_ratio::RBig;
use serde_json::Value;

use crate::judges::same_fields;
use crate::rationals::{absolute, dot, indices, minus, number, solved, vector, vectors};
use crate::truth::{contains, corners, reach, squared_excess};

/// Bounds of a distance differ by this much of the upper one, or by what rounding leaves of the bodies.
const ACCURACY: f64 = 0.01;
const ROUNDING: f64 = 1.0 / (1_u64 << 40) as f64;

/// Of a question and a right answer, what takes long to find.
pub struct Known {
    squared_distance: RBig,
}

struct Pair {
    /// From the centre of the first body to that of the second.
    offset: Vec<RBig>,
    first: Vec<Vec<RBig>>,
    second: Vec<Vec<RBig>>,
}

impl Pair {
    fn of_two(input: &Value) -> Option<Self> {
        let center = |name: &str| vector(&input[name]["center"]);
        Some(Self {
            offset: minus(&center("b")?, &center("a")?),
            first: vectors(&input["a"]["generators"])?,
            second: vectors(&input["b"]["generators"])?,
        })
    }

    /// The body of an answer and the one that it encloses.
    fn of_enclosing(input: &Value, result: &Value) -> Option<Self> {
        let (first, second) = (vectors(&result["generators"])?, vectors(&input["generators"])?);
        let dimension = result["center"].as_array()?.len();
        Some(Self { offset: vec![RBig::ZERO; dimension], first, second })
    }

    fn squared_distance(&self) -> RBig {
        let back: Vec<RBig> = self.offset.iter().map(|c| -c).collect();
        squared_excess(&back, &self.first, &self.second).max(squared_excess(&self.offset, &self.second, &self.first))
    }

    /// Whether the bounds are true, the direction proves the lower one, and they are as near as they are said to be.
    fn is_bounded(&self, bounds: &Value, squared: &RBig) -> Option<bool> {
        let lower = number(&bounds["lower"])?;
        let u = vector(&bounds["direction"])?;
        let is_infinite = bounds["upper"] == "Infinity";
        let upper = if is_infinite { double(f64::MAX)? } else { number(&bounds["upper"])? };
        let difference = absolute(reach(&u, &self.first) - reach(&u, &self.second)) + absolute(dot(&u, &self.offset));
        let is_proved = lower == RBig::ZERO
            || dot(&u, &u) != RBig::ZERO && &difference * &difference >= &lower * &lower * dot(&u, &u);
        let components = self.first.iter().chain(&self.second).flatten().chain(&self.offset);
        let size = components.fold(RBig::ZERO, |sum, c| sum + absolute(c.clone()));
        let is_narrow =
            &lower + size * double(ROUNDING)? + double(f64::from_bits(64))? >= &upper * double(1.0 - ACCURACY)?;
        let is_above = is_infinite || &upper * &upper >= *squared;
        Some(
            u.len() == self.offset.len() && lower >= RBig::ZERO && lower <= upper && is_proved && is_above && is_narrow,
        )
    }
}

fn double(x: f64) -> Option<RBig> {
    RBig::try_from(x).ok()
}

pub fn of_two_bodies(input: &Value, right: &Value, changed: &Value, known: &mut Option<Known>) -> Option<(bool, bool)> {
    let pair = Pair::of_two(input)?;
    let known = known.get_or_insert_with(|| Known { squared_distance: pair.squared_distance() });
    let [lower, value] = [&changed["lower"], &changed["value"]].map(number);
    let is_below = changed["upper"] == "Infinity" || value.as_ref()? <= &number(&changed["upper"])?;
    let is_between = changed["value"] == "Infinity" && changed["upper"] == "Infinity" || value? >= lower? && is_below;
    Some((
        same_fields(&["a_subset_b"], right, changed) && is_between,
        pair.is_bounded(changed, &known.squared_distance)?,
    ))
}

pub fn of_enclosing(
    kind: &str,
    input: &Value,
    right: &Value,
    changed: &Value,
    known: &mut Option<Known>,
) -> Option<(bool, bool)> {
    let pair = Pair::of_enclosing(input, changed)?;
    let center = vector(&changed["center"])?;
    let asked = if kind == "reduce" { vector(&input["center"])? } else { vec![RBig::ZERO; pair.offset.len()] };
    let is_same = vectors(&changed["generators"]) == vectors(&right["generators"]);
    let is_around =
        is_same || corners(pair.offset.len(), &pair.second).all(|corner| contains(&pair.offset, &pair.first, &corner));
    let few = kind != "reduce" || pair.first.len() as u64 <= input["count"].as_u64()?;
    let squared = if is_same {
        known.get_or_insert_with(|| Known { squared_distance: pair.squared_distance() }).squared_distance.clone()
    } else {
        pair.squared_distance()
    };
    let distance = &changed["hausdorff"];
    let is_precise = kind != "approx" || {
        let diameter = corners(pair.offset.len(), &pair.second).map(|v| dot(&v, &v)).max()? * RBig::from(4);
        let (upper, epsilon) = (number(&distance["upper"])?, number(&input["epsilon"])?);
        &upper * &upper <= diameter * &epsilon * epsilon
    };
    let is_proved = is_shared(&pair, &changed["certificate"])?;
    Some((center == asked && few && is_around && is_proved, pair.is_bounded(distance, &squared)? && is_precise))
}

/// Whether shares prove containment; facet normals prove themselves.
fn is_shared(pair: &Pair, certificate: &Value) -> Option<bool> {
    if certificate.get("shares").is_none() {
        return Some(certificate["facet_normals"] == true);
    }
    let (shares, frame) = (certificate["shares"].as_array()?, indices(&certificate["frame"])?);
    let columns: Vec<&Vec<RBig>> = frame.iter().map(|&index| pair.first.get(index)).collect::<Option<_>>()?;
    let mut used = vec![RBig::ZERO; pair.first.len()];
    for (v, share) in pair.second.iter().zip(shares) {
        let mut rest = v.clone();
        if !share.is_null() {
            let index = usize::try_from(share[0].as_f64().filter(|x| x.fract() == 0.0)? as i64).ok()?;
            let part = RBig::try_from(share[1].as_f64()?).ok()?;
            rest = rest.iter().zip(pair.first.get(index)?).map(|(r, c)| r - &part * c).collect();
            used[index] += absolute(part);
        }
        for (&index, x) in frame.iter().zip(solved(&columns, &rest)?) {
            used[index] += absolute(x);
        }
    }
    Some(shares.len() == pair.second.len() && used.iter().all(|used| *used <= RBig::ONE))
}
