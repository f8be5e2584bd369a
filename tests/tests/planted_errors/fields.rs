//! The fields that an answer of each kind has, by its status: these, and no others.

use serde_json::Value;

/// Whether an answer has exactly its fields, in everything that it holds.
pub fn are_exact(kind: &str, answer: &Value) -> bool {
    let Some(envelope) = answer.as_object() else { return false };
    let known = ["id", "kind", "method", "request", "result"];
    envelope.keys().all(|name| known.contains(&name.as_str()))
        && envelope.get("method").is_none_or(Value::is_string)
        && of_result(kind, &answer["result"])
}

fn of_result(kind: &str, result: &Value) -> bool {
    match kind {
        "member" => has(result, &["member", "status", "certificate"]) && of_location(result),
        "intersect" => has(result, &["intersects", "status", "certificate"]) && of_location(result),
        "gauge" => has(result, &["gauge", "at_most_one", "certificate"]) && is_location(&result["certificate"]),
        "member_batch" => has(result, &["status", "gauge", "build", "query"]),
        "distance" => of_distance(result),
        "hausdorff" => has(result, &["value", "lower", "upper", "direction", "a_subset_b"]),
        "approx" | "reduce" => {
            let certificate = &result["certificate"];
            has(result, &["center", "generators", "hausdorff", "certificate"])
                && has(&result["hausdorff"], &["lower", "upper", "direction"])
                && (has(certificate, &["shares", "frame"]) || has(certificate, &["facet_normals"]))
        }
        "sweep" => has(result, &["center", "generators"]),
        "support" => has(result, &["value", "point"]),
        "combinatorics" => has(result, &["affine_dim", "vertices", "edges", "facets", "facet_sizes", "measure"]),
        "slope_selection" => has(result, &["x"]),
        "separator" => has(result, &["chain"]),
        "upper_hull" => has(result, &["above_q", "z"]),
        "walk" => has(result, &["neighbours"]),
        "min_area" => {
            has(result, &["area", "center", "generators", "lower_bound", "certificate"])
                && has(&result["certificate"], &["hull", "farthest", "coefficients", "basis"])
        }
        "min_length_dirs" if result["status"] == "infeasible" => {
            has(result, &["status", "certificate"]) && has(&result["certificate"], &["points", "functional"])
        }
        "min_length_dirs" => {
            has(result, &["status", "value", "center", "coefficients", "lower_bound", "certificate"])
                && of_forces(&result["certificate"])
        }
        "min_length_all" => {
            let own = ["length", "center", "generators", "lower_bound", "ratio", "certificate"];
            let claimed = [&own[..], &["within_epsilon"]].concat();
            (has(result, &own) || has(result, &claimed)) && of_forces(&result["certificate"])
        }
        other => panic!("the fields of the kind `{other}` are not known"),
    }
}

fn has(value: &Value, names: &[&str]) -> bool {
    value
        .as_object()
        .is_some_and(|fields| fields.len() == names.len() && names.iter().all(|&name| fields.contains_key(name)))
}

fn is_location(certificate: &Value) -> bool {
    has(certificate, &["separating_direction"]) || has(certificate, &["coefficients", "basis"])
}

fn of_location(result: &Value) -> bool {
    let certificate = &result["certificate"];
    if result["status"] == "outside" {
        has(certificate, &["separating_direction"])
    } else {
        has(certificate, &["coefficients", "basis"])
    }
}

fn of_distance(result: &Value) -> bool {
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

fn of_forces(certificate: &Value) -> bool {
    let forces = certificate["forces"].as_array();
    has(certificate, &["forces"])
        && forces.is_some_and(|forces| forces.iter().all(|force| has(force, &["point", "vector"])))
}
