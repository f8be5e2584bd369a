//! The combinatorial description of Z(O) and the four displayed lines of the paper's area formula.

use dashu_ratio::RBig;

use crate::definitions::plane::{Point, signed_area, zonogon_about};
use crate::definitions::ratio::integer;

/// One period of the description: P_a … P_b and the reflected P'_{a'} … P'_{b'} that follow it.
#[derive(Clone, Debug)]
pub(crate) struct Run {
    /// P_a … P_b.
    pub(crate) original: Vec<Point>,
    /// P'_{a'} … P'_{b'}.
    pub(crate) reflected: Vec<Point>,
}

/// The description of Z(O), or `None` when some vertex of it is both a point and a reflected point.
pub(crate) fn runs(polygon: &[Point], center: &Point) -> Option<Vec<Run>> {
    let zonogon = zonogon_about(polygon, center);
    let is_original: Vec<bool> = zonogon.iter().map(|vertex| polygon.contains(vertex)).collect();
    let is_reflected = |vertex: &Point| polygon.contains(&vertex.reflected_through(center));
    if zonogon.iter().zip(&is_original).any(|(vertex, &original)| original && is_reflected(vertex)) {
        return None;
    }
    let count = zonogon.len();
    let first = (0..count).find(|&index| is_original[index] && !is_original[(index + count - 1) % count])?;
    let mut runs: Vec<Run> = Vec::new();
    for step in 0..count {
        let index = (first + step) % count;
        let vertex = zonogon[index].clone();
        if is_original[index] {
            if runs.last().is_none_or(|run| !run.reflected.is_empty()) {
                runs.push(Run { original: Vec::new(), reflected: Vec::new() });
            }
            runs.last_mut()?.original.push(vertex);
        } else {
            runs.last_mut()?.reflected.push(vertex);
        }
    }
    Some(runs)
}

/// The right-hand sides of the area formula, as printed, in the order of the page.
pub(crate) fn displayed_lines(runs: &[Run], center: &Point) -> [RBig; 4] {
    let o = center;
    let area = |points: &[&Point]| signed_area(points.iter().copied());
    let mut lines = [RBig::ZERO, RBig::ZERO, RBig::ZERO, RBig::ZERO];
    for (s, run) in runs.iter().enumerate() {
        let (a, next_a) = (&run.original[0], &runs[(s + 1) % runs.len()].original[0]);
        let reflected_a = &run.reflected[0];
        let plain_a = &reflected_a.reflected_through(o);
        let chain_and = |apex| area(&run.original.iter().chain([apex]).collect::<Vec<_>>());
        let reflected_cap = area(&run.reflected.iter().chain([next_a]).collect::<Vec<_>>());

        lines[0] += area(&[o, a, reflected_a, next_a]) + chain_and(reflected_a) + reflected_cap;
        let quadrilateral = area(&[plain_a, a, o, next_a]);
        lines[1] += &quadrilateral + integer(2) * chain_and(reflected_a);
        let common = integer(4) * chain_and(o) - integer(2) * chain_and(plain_a);
        lines[2] += quadrilateral - area(&[o, a, next_a]) + &common;
        lines[3] += area(&[plain_a, a, next_a]) + common;
    }
    lines[3] -= first_points_area(runs);
    lines
}

/// The area of P_{a_1} … P_{a_k}, the polygon of the first points of the runs.
pub(crate) fn first_points_area(runs: &[Run]) -> RBig {
    signed_area(runs.iter().map(|run| &run.original[0]))
}
