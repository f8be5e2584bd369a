//! First contacts of meshes from the definition, in rationals: gaps of corners at many times, every pair of triangles
//! by itself, and a common point of two triangles as a system with a solution of no negative number.

use dashu_ratio::RBig;
use serde_json::Value;
use zonotope::motion::continuous::SeparatingDirection;
use zonotope::motion::continuous::brute_force::{Placement, gap_of_corners};

use super::encounters::{Pieces, floats, interval_is_free, is_bracket};
use crate::fields::has;
use crate::meshes::mesh;
use crate::rationals::{indices, solved};

/// The corners of a triangle.
type Corners = [[f64; 3]; 3];

/// Whether a result about meshes has the fields of its status.
pub fn has_its_fields(result: &Value) -> bool {
    let own: &[&str] = if result["status"] == "separate" { &[] } else { &["time", "triangles"] };
    let certificate = &result["certificate"];
    let fields = ["from", "to", "frame", "direction", "a", "b"];
    has(result, &[&["status", "certificate"], own].concat())
        && has(certificate, &["order", "intervals"])
        && has(&certificate["order"], &["a", "b"])
        && certificate["intervals"].as_array().is_some_and(|all| all.iter().all(|one| has(one, &fields)))
}

/// The triangles of a mesh; of one with a pose nothing is judged.
fn triangles(input: &Value, name: &str) -> Option<Vec<Corners>> {
    let (mesh, _) = mesh(input, name).filter(|_| input[name].get("pose").is_none())?;
    Some((0..mesh.triangles().len()).map(|triangle| mesh.corners(triangle)).collect())
}

/// Whether the changed answer is exact in its form, and whether it is true.
pub fn judged(input: &Value, changed: &Value) -> Option<(bool, bool)> {
    let meshes = [triangles(input, "a")?, triangles(input, "b")?];
    let motions = [Pieces::of(input, "a")?, Pieces::of(input, "b")?];
    let order = &changed["certificate"]["order"];
    let orders = [indices(&order["a"])?, indices(&order["b"])?];
    for (order, mesh) in orders.iter().zip(&meshes) {
        let mut sorted = order.clone();
        sorted.sort_unstable();
        if !sorted.iter().copied().eq(0..mesh.len()) {
            return Some((false, false));
        }
    }
    // the stretches of time in which each pair is free
    let mut free: Vec<Vec<[f64; 2]>> = vec![Vec::new(); meshes[0].len() * meshes[1].len()];
    for interval in changed["certificate"]["intervals"].as_array()? {
        let part = |i: usize| -> Option<&[usize]> {
            let range: [usize; 2] = indices(&interval[["a", "b"][i]])?.try_into().ok()?;
            orders[i].get(range[0]..range[1])
        };
        let (Some(first), Some(second)) = (part(0), part(1)) else { return Some((false, false)) };
        let corners = [(first, &meshes[0]), (second, &meshes[1])]
            .map(|(part, mesh)| part.iter().flat_map(|&triangle| mesh[triangle]).collect::<Vec<_>>());
        if corners.iter().any(Vec::is_empty) {
            return Some((false, false));
        }
        let gap = |placements: [&Placement; 2], direction: &SeparatingDirection| {
            gap_of_corners([&corners[0], &corners[1]], placements, direction).unwrap_or_default()
        };
        let found = interval_is_free(interval, motions.each_ref(), gap)?;
        if found != (true, true) {
            return Some(found);
        }
        let stretch = [interval["from"].as_f64()?, interval["to"].as_f64()?];
        for i in first {
            second.iter().for_each(|j| free[i * meshes[1].len() + j].push(stretch));
        }
    }
    let is_free_until = |end: f64| {
        free.iter().all(|stretches| {
            let mut stretches = stretches.clone();
            stretches.sort_by(|one, other| one[0].total_cmp(&other[0]));
            let further =
                |reached: f64, [from, to]: &[f64; 2]| if *from <= reached { reached.max(*to) } else { reached };
            stretches.iter().fold(0.0, further) >= end
        })
    };
    if changed["status"] == "separate" {
        return Some((true, is_free_until(1.0)));
    }
    let [from, to] = floats(&changed["time"])?;
    let [i, j]: [usize; 2] = indices(&changed["triangles"])?.try_into().ok()?;
    let (Some(p), Some(q)) = (meshes[0].get(i), meshes[1].get(j)) else { return Some((false, false)) };
    match changed["status"].as_str()? {
        "contact" => {
            let at = RBig::try_from(to).ok()?;
            let [of_a, of_b] = motions.each_ref().map(|motion| motion.placements(&at));
            let do_meet = of_a.iter().any(|of_p| of_b.iter().any(|of_q| have_common_point([p, q], [of_p, of_q])));
            Some((is_bracket(&changed["time"])?, is_free_until(from) && do_meet))
        }
        "grazing" => {
            let is_in_doubt = free[i * meshes[1].len() + j].iter().all(|stretch| stretch[1] <= from);
            Some((0.0 <= from && from <= to && to <= 1.0, is_free_until(from) && is_in_doubt))
        }
        _ => Some((false, false)),
    }
}

/// Whether two triangles meet: some corners of both, which are independent, have a common point between them.
fn have_common_point(triangles: [&Corners; 2], placements: [&Placement; 2]) -> bool {
    let columns: Vec<Vec<RBig>> = (0..6)
        .map(|k| {
            let (i, one) = (k / 3, RBig::ONE);
            let place = placements[i].of(triangles[i][k % 3]);
            let [sign, of_a, of_b] = if i == 0 { [one.clone(), one, RBig::ZERO] } else { [-&one, RBig::ZERO, one] };
            place.iter().map(|c| c * &sign).chain([of_a, of_b]).collect()
        })
        .collect();
    let target = [RBig::ZERO, RBig::ZERO, RBig::ZERO, RBig::ONE, RBig::ONE];
    (1..1_u32 << columns.len()).any(|subset| {
        let chosen: Vec<&Vec<RBig>> =
            (0..columns.len()).filter(|k| subset >> k & 1 == 1).map(|k| &columns[k]).collect();
        chosen.len() < 6
            && solved(&chosen, &target).is_some_and(|shares| shares.iter().all(|share| *share >= RBig::ZERO))
    })
}
