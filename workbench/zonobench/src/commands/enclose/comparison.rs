//! How a zonotope compares with the convex hull and with boxes around the same points.
//!
//! All sizes are ratios in floating point, of lengths scaled by a power of two: they are not proven. The smallest
//! rectangle around points of the plane has a side along an edge of their hull. A box of space is searched for: it is
//! the smallest rectangle in projection along an axis, times the extent along it, and the axis begins at the corners of
//! a net and the generators and moves while the box gets smaller.

use zonotope::enclosing::min_total_length::direction_net::cell_corners;
use zonotope::hull::by_monotone_chain::convex_hull;
use zonotope::hull::in_space::{hull_corners, solid_hull};
use zonotope::numeric::scaling::{binary_exponent, scale_by_power_of_two};
use zonotope::zonotope::Zonotope;

use crate::input::{Body, Points};

/// The exact volume of bodies with more generators than this takes too long for a summary.
const GENERATOR_LIMIT: usize = 250;

/// The search for a box goes by the points that are farthest along the corners of a net of so many cells.
const FAR_POINT_CELLS: usize = 10;

/// The axes that the search for a box begins with: the corners of a net of so many cells, and as many generators.
const AXIS_CELLS: usize = 4;

/// The axis moves by an angle that begins with this and is halved where no move helps.
const FIRST_ANGLE: f64 = 0.2;

/// The axis stops moving once the angle is less than this.
const LAST_ANGLE: f64 = 1e-3;

/// Volume, or area in the plane, and half the sum of the sides.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Size {
    measure: f64,
    length: f64,
}

impl Size {
    fn of_box(sides: &[f64]) -> Self {
        Self { measure: sides.iter().product(), length: sides.iter().sum::<f64>() / 2.0 }
    }
}

/// Labels and texts for the summary; none for points that do not have two or three coordinates. Where the body has the
/// least length and the box along the axes is smaller, the objective is named that makes the body small.
pub(super) fn rows(points: &Points, body: &Body, is_least_length: bool) -> Vec<(&'static str, String)> {
    match points {
        Points::Plane(points) => in_plane(points, body, is_least_length),
        Points::Space(points) => in_space(points, body, is_least_length),
        Points::Line(_) | Points::Four(_) => Vec::new(),
    }
}

fn in_plane(points: &[[f64; 2]], body: &Body, is_least_length: bool) -> Vec<(&'static str, String)> {
    let (points, body) = scaled(points, body);
    let Some((rectangle, hull)) = smallest_rectangle(&points) else { return Vec::new() };
    let zonogon = Size { measure: body.exact_area().to_f64(), length: total_length(body.generators()) };
    let axis_box = axis_box(&points);
    let advice = if is_least_length { advice("area", axis_box, zonogon) } else { String::new() };
    vec![
        ("hull", format!("{} times the zonotope's area", ratio(hull, zonogon.measure))),
        ("axis box", compared("area", axis_box, zonogon) + &advice),
        ("oriented box", format!("{}; none is smaller", compared("area", rectangle, zonogon))),
    ]
}

fn in_space(points: &[[f64; 3]], body: &Body, is_least_length: bool) -> Vec<(&'static str, String)> {
    if body.generators.len() > GENERATOR_LIMIT {
        return Vec::new();
    }
    let (points, body) = scaled(points, body);
    let zonotope = Size { measure: body.exact_volume().to_f64(), length: total_length(body.generators()) };
    // A box around the corners of the hull is one around all points.
    let (hull, corners) = match solid_hull(&points) {
        Ok(Some(hull)) => (hull.volume(&points), hull.vertices()),
        _ => (0.0, hull_corners(&points).unwrap_or_default()),
    };
    let corners: Vec<[f64; 3]> = corners.into_iter().map(|corner| points[corner]).collect();
    let axis_box = axis_box(&corners);
    let advice = if is_least_length { advice("volume", axis_box, zonotope) } else { String::new() };
    let mut rows = vec![
        ("hull", format!("{} times the zonotope's volume", ratio(hull, zonotope.measure))),
        ("axis box", compared("volume", axis_box, zonotope) + &advice),
    ];
    if let Some(found) = small_box(&corners, body.generators()) {
        rows.push(("oriented box", format!("{}; the smallest found", compared("volume", found, zonotope))));
    }
    rows
}

fn compared(measure: &str, size: Size, body: Size) -> String {
    let [larger, longer] = [ratio(size.measure, body.measure), ratio(size.length, body.length)];
    format!("{larger} times the zonotope's {measure}, {longer} times its length")
}

/// What to ask for where the box along the axes is smaller than a body of least length; nothing where it is not.
fn advice(measure: &str, axis_box: Size, body: Size) -> String {
    if axis_box.measure < body.measure {
        format!("; the length was asked for and not the {measure}, which is --objective {measure}")
    } else {
        String::new()
    }
}

fn ratio(value: f64, of: f64) -> String {
    if of > 0.0 { format!("{:.4}", value / of) } else { "any number of".to_owned() }
}

/// Points relative to the first, and the body about the origin, scaled to ordinary size.
fn scaled<const D: usize>(points: &[[f64; D]], body: &Body) -> (Vec<[f64; D]>, Zonotope<D>) {
    let largest = body.generators.iter().flatten().fold(0.0f64, |largest, c| largest.max(c.abs()));
    let shrink = -i64::from(binary_exponent(largest).unwrap_or(0));
    let scale = |c: f64| scale_by_power_of_two(c, shrink);
    let first = points.first().copied().unwrap_or([0.0; D]);
    let relative = |p: &[f64; D]| std::array::from_fn(|c| scale(p[c] / 2.0 - first[c] / 2.0) * 2.0);
    let generators = body.generators.iter().map(|g| std::array::from_fn(|c| scale(g[c]))).collect();
    let body = Zonotope::new([0.0; D], generators).expect("scaled generators are finite");
    (points.iter().map(relative).collect(), body)
}

fn total_length<const D: usize>(generators: &[[f64; D]]) -> f64 {
    generators.iter().map(|g| dot(g, g).sqrt()).sum()
}

fn dot<const D: usize>(a: &[f64; D], b: &[f64; D]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// The extent of points along a vector.
fn extent<const D: usize>(points: &[[f64; D]], along: &[f64; D]) -> f64 {
    let heights = points.iter().map(|p| dot(p, along));
    let (low, high) = heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), h| (low.min(h), high.max(h)));
    high - low
}

fn axis_box<const D: usize>(points: &[[f64; D]]) -> Size {
    let side = |axis: usize| extent(points, &std::array::from_fn(|c| f64::from(u8::from(c == axis))));
    Size::of_box(&std::array::from_fn::<f64, D, _>(side))
}

/// The rectangle of least area around points of the plane, and the area of their hull.
fn smallest_rectangle(points: &[[f64; 2]]) -> Option<(Size, f64)> {
    let hull = convex_hull(points).ok()?;
    let corners = hull.vertices();
    let next = |i: usize| corners[(i + 1) % corners.len()];
    let rectangle = |i: usize| {
        let edge = [next(i)[0] - corners[i][0], next(i)[1] - corners[i][1]];
        let length = dot(&edge, &edge).sqrt();
        let along = edge.map(|c| c / length);
        Size::of_box(&[extent(corners, &along), extent(corners, &[-along[1], along[0]])])
    };
    let rectangles = (0..corners.len()).map(rectangle).filter(|size| size.measure.is_finite());
    let least = rectangles.min_by(|a, b| a.measure.total_cmp(&b.measure))?;
    let first = corners[0];
    let double = |i: usize| {
        let [a, b] = [corners[i], next(i)].map(|p| [p[0] - first[0], p[1] - first[1]]);
        a[0] * b[1] - a[1] * b[0]
    };
    Some((least, (0..corners.len()).map(double).sum::<f64>().abs() / 2.0))
}

/// The smallest box around points of space that the search finds.
fn small_box(points: &[[f64; 3]], generators: &[[f64; 3]]) -> Option<Size> {
    let far = far_points(points);
    let mut best: Option<([f64; 3], f64)> = None;
    let nearer = |axis: [f64; 3], best: &mut Option<([f64; 3], f64)>| {
        let Some(size) = box_along(&far, &axis) else { return false };
        let is_smaller = best.is_none_or(|(_, least)| size.measure < least);
        if is_smaller {
            *best = Some((axis, size.measure));
        }
        is_smaller
    };
    let mut long = generators.to_vec();
    long.sort_by(|a, b| dot(b, b).total_cmp(&dot(a, a)));
    let corners = cell_corners::<3>(AXIS_CELLS);
    long.truncate(corners.len());
    for axis in corners.into_iter().chain(long) {
        nearer(axis, &mut best);
    }
    let mut angle = FIRST_ANGLE;
    while angle > LAST_ANGLE {
        let (axis, _) = best?;
        let across = frame_of(&axis)?;
        let mut moves = across[1..].iter().flat_map(|v| [angle, -angle].map(|turn| (v, turn)));
        let moved = |v: &[f64; 3], turn: f64| std::array::from_fn(|c| across[0][c] + turn * v[c]);
        if !moves.any(|(v, turn)| nearer(moved(v, turn), &mut best)) {
            angle /= 2.0;
        }
    }
    box_along(points, &best?.0)
}

/// The points that are farthest along the corners of a net, and opposite to them.
fn far_points(points: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let mut far = Vec::new();
    for u in cell_corners::<3>(FAR_POINT_CELLS) {
        let order = |a: &&[f64; 3], b: &&[f64; 3]| dot(a, &u).total_cmp(&dot(b, &u));
        far.extend(points.iter().max_by(order));
        far.extend(points.iter().min_by(order));
    }
    far
}

/// The smallest box around points with a side along an axis.
fn box_along(points: &[[f64; 3]], axis: &[f64; 3]) -> Option<Size> {
    let [along, a, b] = frame_of(axis)?;
    let shadow: Vec<[f64; 2]> = points.iter().map(|p| [dot(p, &a), dot(p, &b)]).collect();
    let (rectangle, _) = smallest_rectangle(&shadow)?;
    let height = extent(points, &along);
    Some(Size { measure: rectangle.measure * height, length: rectangle.length + height / 2.0 })
}

/// An orthonormal frame whose first vector is along the given one.
fn frame_of(v: &[f64; 3]) -> Option<[[f64; 3]; 3]> {
    let unit = |v: [f64; 3]| {
        let length = dot(&v, &v).sqrt();
        (length > 0.0 && length.is_finite()).then(|| v.map(|c| c / length))
    };
    let along = unit(*v)?;
    let least = (0..3).min_by(|&a, &b| along[a].abs().total_cmp(&along[b].abs()))?;
    let off: [f64; 3] = std::array::from_fn(|c| f64::from(u8::from(c == least)) - along[least] * along[c]);
    let a = unit(off)?;
    let cross = |a: &[f64; 3], b: &[f64; 3]| -> [f64; 3] {
        std::array::from_fn(|c| a[(c + 1) % 3] * b[(c + 2) % 3] - a[(c + 2) % 3] * b[(c + 1) % 3])
    };
    Some([along, a, cross(&along, &a)])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_turned_box_is_found() {
        // sides of 4, 2 and 1 along orthogonal vectors of length 3
        let sides = [[2.0, 1.0, 2.0], [-2.0, 2.0, 1.0], [1.0, 2.0, -2.0]];
        let corner = |i: usize| -> [f64; 3] {
            let along = |k: usize| f64::from(u8::from(i >> k & 1 == 1)) * [4.0, 2.0, 1.0][k] / 3.0;
            std::array::from_fn(|c| (0..3).map(|k| along(k) * sides[k][c]).sum())
        };
        let points: Vec<[f64; 3]> = (0..8).map(corner).collect();
        let found = small_box(&points, &sides).expect("a box");
        assert!((found.measure - 8.0).abs() < 1e-9 && (found.length - 3.5).abs() < 1e-9, "{found:?}");
        assert!(axis_box(&points).measure > 8.5);
    }

    #[test]
    fn a_smaller_box_names_the_other_objective() {
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let body = |generators: Vec<Vec<f64>>| Body { center: vec![0.5, 0.5], generators, is_rounded: false };
        let of_axis_box = |body: &Body, is_least_length| {
            let rows = rows(&Points::Plane(square.to_vec()), body, is_least_length);
            rows.into_iter().find(|(label, _)| *label == "axis box").expect("a row").1
        };
        let large = body(vec![vec![1.0, 0.0], vec![0.0, 1.0]]);
        assert!(of_axis_box(&large, true).ends_with("not the area, which is --objective area"));
        assert!(!of_axis_box(&large, false).contains("objective"), "nothing else was asked for");
        let least = body(vec![vec![0.5, 0.0], vec![0.0, 0.5]]);
        assert!(!of_axis_box(&least, true).contains("objective"), "the box is no smaller");
    }

    #[test]
    fn a_triangle_is_half_of_its_rectangle() {
        let (rectangle, hull) = smallest_rectangle(&[[0.0, 0.0], [3.0, 0.0], [0.0, 4.0]]).expect("a rectangle");
        assert!((rectangle.measure - 12.0).abs() < 1e-12 && (hull - 6.0).abs() < 1e-12, "{rectangle:?}");
    }
}
