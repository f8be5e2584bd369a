//! Answers about meshes against the library's brute force, which shares nothing with the check.

use dashu_ratio::RBig;
use serde_json::Value;
use zonotope::bvh::brute_force::{all_pairs, square_of_distance};
use zonotope::bvh::{Mesh, PlacedMesh};
use zonotope::zonotope::Zonotope;
use zonotope::zonotope::pose::Pose;

use crate::fields::has;
use crate::rationals::{index, indices, number};

/// Whether a result has the fields of its outcome.
pub fn has_its_fields(result: &Value) -> bool {
    let with_pairs: &[&str] =
        if result["intersects"] == true { &["intersects", "witness", "pairs"] } else { &["intersects", "pairs"] };
    let without: &[&str] =
        if result["intersects"] == true { &["intersects", "witness"] } else { &["intersects", "distance"] };
    let is_plain = has(result, without) && result.get("distance").is_none_or(|bounds| has(bounds, &["lower", "upper"]));
    has(result, with_pairs) || is_plain
}

fn floats(value: &Value) -> Option<[f64; 3]> {
    let all: Option<Vec<f64>> = value.as_array()?.iter().map(Value::as_f64).collect();
    all?.try_into().ok()
}

fn rows(value: &Value) -> Option<Vec<[f64; 3]>> {
    value.as_array()?.iter().map(floats).collect()
}

/// A mesh of a question with its pose.
pub fn mesh(input: &Value, name: &str) -> Option<(Mesh, Pose)> {
    let corner = |value: &Value| index(value).and_then(|at| u32::try_from(at).ok());
    let triangle = |row: &Value| -> Option<[u32; 3]> {
        row.as_array()?.iter().map(corner).collect::<Option<Vec<u32>>>()?.try_into().ok()
    };
    let triangles = input[name]["triangles"].as_array()?.iter().map(triangle).collect::<Option<_>>()?;
    let mesh = Mesh::new(rows(&input[name]["vertices"])?, triangles).ok()?;
    let Some(pose) = input[name].get("pose") else { return Some((mesh, Pose::IDENTITY)) };
    let matrix = match pose.get("matrix") {
        Some(matrix) => rows(matrix)?.try_into().ok()?,
        None => Pose::IDENTITY.matrix(),
    };
    let translation = pose.get("translation").map_or(Some([0.0; 3]), floats)?;
    Some((mesh, Pose::new(matrix, translation).ok()?))
}

fn pair(value: &Value) -> Option<[usize; 2]> {
    indices(value)?.try_into().ok()
}

/// Whether a changed answer is one to the question: the outcome, then what belongs to it.
pub fn judged(input: &Value, changed: &Value) -> Option<(bool, bool)> {
    let [(a, of_a), (b, of_b)] = [mesh(input, "a")?, mesh(input, "b")?];
    let (a, b) = (a.at(&of_a), b.at(&of_b));
    let pairs = all_pairs(a, b);
    let has_outcome = changed["intersects"] == !pairs.is_empty();
    let wants_pairs = input["pairs"] == true;
    let is_witness = pairs.is_empty() || pairs.contains(&pair(&changed["witness"])?);
    if wants_pairs {
        let told: Option<Vec<[usize; 2]>> = changed["pairs"].as_array()?.iter().map(pair).collect();
        return Some((has_outcome && is_witness, told? == pairs));
    }
    let is_near = !pairs.is_empty() || is_distance(a, b, &changed["distance"])?;
    Some((has_outcome && is_witness, is_near))
}

/// Whether bounds hold the distance, and are within a thousandth of each other or neighbours of the smallest doubles.
fn is_distance(a: PlacedMesh<'_>, b: PlacedMesh<'_>, bounds: &Value) -> Option<bool> {
    let exact = square_of_distance(a, b);
    let square = |x: &RBig| x * x;
    let lower = number(&bounds["lower"])?;
    let largest = number(&f64::MAX.into())?;
    let is_below = lower >= RBig::ZERO && square(&lower) <= exact;
    let upper = if bounds["upper"] == "Infinity" {
        if exact <= square(&largest) {
            return Some(false);
        }
        largest
    } else {
        let upper = number(&bounds["upper"])?;
        if upper < RBig::ZERO || square(&upper) < exact {
            return Some(false);
        }
        upper
    };
    let width = &upper - &lower;
    let share = number(&1e-3.into())? * &upper;
    Some(is_below && (width <= share || width <= number(&f64::from_bits(2).into())?))
}

/// Whether a result with the nodes of a level has the fields of each.
pub fn nodes_have_their_fields(result: &Value) -> bool {
    let is_node = |node: &Value| has(node, &["center", "generators", "margin", "triangles"]);
    has(result, &["nodes"]) && result["nodes"].as_array().is_some_and(|nodes| nodes.iter().all(is_node))
}

/// Whether the nodes hold every triangle once, no more nodes than a level has, and then whether each volume contains
/// its triangles.
pub fn nodes_judged(input: &Value, changed: &Value) -> Option<(bool, bool)> {
    let (mesh, _) = mesh(input, "a")?;
    let nodes = changed["nodes"].as_array()?;
    let of_node = |node: &Value| indices(&node["triangles"]);
    let lists: Vec<Vec<usize>> = nodes.iter().map(of_node).collect::<Option<_>>()?;
    let mut all = lists.concat();
    all.sort_unstable();
    let level = u32::try_from(index(&input["level"])?).ok()?;
    let is_level = nodes.len() <= 1 << level && lists.iter().all(|list| !list.is_empty());
    let is_whole = all.into_iter().eq(0..mesh.triangles().len());
    let holds = |(node, list): (&Value, &Vec<usize>)| -> Option<bool> {
        let margin = node["margin"].as_f64()?;
        let margins = [[margin, 0.0, 0.0], [0.0, margin, 0.0], [0.0, 0.0, margin]];
        let generators = rows(&node["generators"])?.into_iter().chain(margins).collect();
        let body = Zonotope::new(floats(&node["center"])?, generators).ok()?;
        let mut corners = list.iter().filter(|&&at| at < mesh.triangles().len()).flat_map(|&at| mesh.corners(at));
        Some(margin >= 0.0 && corners.all(|corner| body.contains(corner) == Ok(true)))
    };
    let held = nodes.iter().zip(&lists).map(holds).collect::<Option<Vec<bool>>>()?;
    Some((is_level && is_whole, held.into_iter().all(|holds| holds)))
}
