//! The fields of answers, of their certificates and of what else several kinds have in common.

use serde_json::Value;

/// Whether a value has exactly these fields.
pub fn has(value: &Value, names: &[&str]) -> bool {
    value
        .as_object()
        .is_some_and(|fields| fields.len() == names.len() && names.iter().all(|&name| fields.contains_key(name)))
}

/// Whether a certificate has the fields of the proof of a location.
pub fn is_location(certificate: &Value) -> bool {
    has(certificate, &["separating_direction"]) || has(certificate, &["coefficients", "basis"])
}

/// Whether the certificate of a result has the fields that its status asks for.
pub fn of_location(result: &Value) -> bool {
    let certificate = &result["certificate"];
    if result["status"] == "outside" {
        has(certificate, &["separating_direction"])
    } else {
        has(certificate, &["coefficients", "basis"])
    }
}

/// Whether a result has the fields of a distance, by its status.
pub fn of_distance(result: &Value) -> bool {
    let all = ["distance", "status", "nearest", "features", "certificate"];
    let own: &[&str] = match result["status"].as_str() {
        Some("outside") => &["distance_certificate"],
        Some("boundary") => &["contact_normal", "penetration"],
        _ => &["penetration"],
    };
    let part = |name: &str, names: &[&str]| result.get(name).is_none_or(|part| has(part, names));
    has(result, &[&all, own].concat())
        && of_location(result)
        && ["nearest", "features"].iter().all(|name| part(name, &["a", "b"]))
        && part("distance_certificate", &["coefficients", "basis"])
        && part("penetration", &["lower", "upper", "direction"])
}

/// Whether a certificate has forces, and nothing else.
pub fn of_forces(certificate: &Value) -> bool {
    let forces = certificate["forces"].as_array();
    has(certificate, &["forces"])
        && forces.is_some_and(|forces| forces.iter().all(|force| has(force, &["point", "vector"])))
}

/// Whether a result has the fields of a first contact, by its status.
pub fn of_first_contact(result: &Value) -> bool {
    let (own, proof): (&[&str], &[&str]) = match result["status"].as_str() {
        Some("separate") => (&[], &[]),
        Some("contact") => (&["time"], &["coefficients", "basis"]),
        _ => (&["time", "distance_at_most"], &[]),
    };
    let intervals = result["certificate"]["intervals"].as_array();
    has(result, &[&["status", "certificate"], own].concat())
        && has(&result["certificate"], &[&["intervals"], proof].concat())
        && intervals.is_some_and(|all| all.iter().all(|one| has(one, &["from", "to", "frame", "direction"])))
}
