//! Whether a volume holds placements of a sweep, in rationals: by the library's truth about one placement.

use serde_json::Value;
use zonotope::Zonotope;
use zonotope::motion::space_time::Sweep;
use zonotope::motion::space_time::brute_force::holds_placement;

/// The placements of a sweep that are tried: parts of the angle in sixteenths.
const PARTS: u32 = 16;

fn vector(value: &Value) -> Option<[f64; 3]> {
    let numbers: Vec<f64> = value.as_array()?.iter().map(Value::as_f64).collect::<Option<_>>()?;
    numbers.try_into().ok()
}

fn body(value: &Value) -> Option<Zonotope<3>> {
    let generators = value["generators"].as_array()?.iter().map(vector).collect::<Option<_>>()?;
    Zonotope::new(vector(&value["center"])?, generators).ok()
}

/// Whether placements from the first to nearly the last one lie in a volume.
pub fn are_held(input: &Value, result: &Value) -> Option<bool> {
    let (body, volume) = (body(input)?, body(result)?);
    let axis = vector(&input["axis"])?;
    let angle = input["angle"].as_f64()?;
    let sweep = Sweep::new(vector(&input["axis_point"])?, axis, angle, vector(&input["translation"])?).ok()?;
    let largest = axis.iter().fold(0.0f64, |largest, c| largest.max(c.abs()));
    let length = largest * axis.iter().map(|c| (c / largest).powi(2)).sum::<f64>().sqrt();
    // a little below the angle, since tangent and length are rounded
    let tangents = (0..=PARTS).map(|part| {
        let turned = angle.min(std::f64::consts::TAU) * f64::from(part) / f64::from(PARTS) * (1.0 - 1e-12);
        libm::tan(turned / 2.0) / length
    });
    let holds = |t: f64| [0.0, 1.0].iter().all(|s| holds_placement(&volume, &sweep, &body, t, *s));
    Some(tangents.filter(|t| t.is_finite()).all(holds))
}
