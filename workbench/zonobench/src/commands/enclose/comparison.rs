//! Comparison of a zonotope with the convex hull and with boxes around the same points.
//!
//! All sizes are ratios in floating point, of lengths scaled by a power of two: they are not proven. The boxes are
//! those of [`oriented_box`](zonotope::enclosing::oriented_box): the smallest rectangle in the plane, and the smallest
//! box that a search finds in space, with which the search for few generators begins as well.

use zonotope::enclosing::oriented_box::{OrientedBox, small_box, smallest_rectangle};
use zonotope::hull::by_monotone_chain::convex_hull;
use zonotope::hull::in_space::{hull_corners, solid_hull};
use zonotope::numeric::scaling::{binary_exponent, scale_by_power_of_two};
use zonotope::zonotope::Zonotope;

use crate::input::{Body, Points};

/// The exact volume of bodies with more generators than this takes too long for a summary.
const GENERATOR_LIMIT: usize = 250;

/// Volume, or area in the plane, and half the sum of the sides.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Size {
    measure: f64,
    length: f64,
}

/// A body whose measure is a smaller part of that of a cube as long has none beside the roundings of a hull's measure.
const FLAT: f64 = 1e-14;

impl Size {
    /// Whether the measure is zero, or so small beside the length that it comes from roundings.
    fn is_flat(&self, measure: &str) -> bool {
        let powers = if measure == "area" { 2 } else { 3 };
        self.measure <= FLAT * self.length.powi(powers)
    }

    fn of_box<const D: usize>(found: &OrientedBox<D>) -> Self {
        let sides = found.half_sides.map(|half| 2.0 * half);
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
    let (points, body, _) = scaled(points, body);
    let Some((hull, rectangle)) = hull_area(&points).zip(smallest_rectangle(&points)) else { return Vec::new() };
    let zonogon = Size { measure: body.exact_area().to_f64(), length: total_length(body.generators()) };
    let axis_box = axis_box(&points);
    let advice = if is_least_length { advice("area", axis_box, zonogon) } else { String::new() };
    vec![
        ("hull", hull_compared("area", hull, zonogon)),
        ("axis box", compared("area", axis_box, zonogon) + &advice),
        ("oriented box", format!("{}; none is smaller", compared("area", Size::of_box(&rectangle), zonogon))),
    ]
}

fn in_space(points: &[[f64; 3]], body: &Body, is_least_length: bool) -> Vec<(&'static str, String)> {
    if body.generators.len() > GENERATOR_LIMIT {
        return Vec::new();
    }
    let found = small_box(points);
    let (points, body, shrink) = scaled(points, body);
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
        ("hull", hull_compared("volume", hull, zonotope)),
        ("axis box", compared("volume", axis_box, zonotope) + &advice),
    ];
    if let Some(mut found) = found {
        found.half_sides = found.half_sides.map(|half| scale_by_power_of_two(half, shrink));
        let size = Size::of_box(&found);
        rows.push(("oriented box", format!("{}; the smallest found", compared("volume", size, zonotope))));
    }
    rows
}

fn compared(measure: &str, size: Size, body: Size) -> String {
    let longer = ratio(size.length, body.length);
    if body.is_flat(measure) {
        format!("{longer} times the length of the zonotope, which is flat")
    } else {
        format!("{} times the zonotope's {measure}, {longer} times its length", ratio(size.measure, body.measure))
    }
}

fn hull_compared(measure: &str, hull: f64, body: Size) -> String {
    if body.is_flat(measure) {
        "flat within rounding, as the zonotope is: volumes and areas of these do not compare".to_owned()
    } else {
        format!("{} times the zonotope's {measure}", ratio(hull, body.measure))
    }
}

/// The advice where the box along the axes is smaller than a body of least length; nothing where it is not.
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

/// Points relative to the first, and the body about the origin, scaled to ordinary size, and the power of two of that.
fn scaled<const D: usize>(points: &[[f64; D]], body: &Body) -> (Vec<[f64; D]>, Zonotope<D>, i64) {
    let largest = body.generators.iter().flatten().fold(0.0f64, |largest, c| largest.max(c.abs()));
    let shrink = -i64::from(binary_exponent(largest).unwrap_or(0));
    let scale = |c: f64| scale_by_power_of_two(c, shrink);
    let first = points.first().copied().unwrap_or([0.0; D]);
    let relative = |p: &[f64; D]| std::array::from_fn(|c| scale(p[c] / 2.0 - first[c] / 2.0) * 2.0);
    let generators = body.generators.iter().map(|g| std::array::from_fn(|c| scale(g[c]))).collect();
    let body = Zonotope::new([0.0; D], generators).expect("scaled generators are finite");
    (points.iter().map(relative).collect(), body, shrink)
}

fn total_length<const D: usize>(generators: &[[f64; D]]) -> f64 {
    generators.iter().map(|g| dot(g, g).sqrt()).sum()
}

fn dot<const D: usize>(a: &[f64; D], b: &[f64; D]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn axis_box<const D: usize>(points: &[[f64; D]]) -> Size {
    let axes = std::array::from_fn(|axis| std::array::from_fn(|c| f64::from(u8::from(c == axis))));
    Size::of_box(&OrientedBox::along(points, axes))
}

/// The area of the convex hull.
fn hull_area(points: &[[f64; 2]]) -> Option<f64> {
    let hull = convex_hull(points, &mut ()).ok()?;
    let corners = hull.vertices();
    let first = corners[0];
    let double = |i: usize| {
        let [a, b] = [i, (i + 1) % corners.len()].map(|i| [corners[i][0] - first[0], corners[i][1] - first[1]]);
        a[0] * b[1] - a[1] * b[0]
    };
    Some((0..corners.len()).map(double).sum::<f64>().abs() / 2.0)
}

#[cfg(test)]
mod tests {
    use super::*;

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
    fn a_flat_body_has_no_ratio_of_measures() {
        let size = |measure: f64| Size { measure, length: 2.0 };
        for flat in [0.0, 1e-20] {
            let told = [hull_compared("volume", 1e-17, size(flat)), compared("volume", size(1e-3), size(flat))];
            assert!(told[0].starts_with("flat within rounding"), "{}", told[0]);
            assert_eq!(told[1], "1.0000 times the length of the zonotope, which is flat");
        }
        assert_eq!(hull_compared("area", 1.0, size(2.0)), "0.5000 times the zonotope's area");
        assert_eq!(compared("area", size(4.0), size(2.0)), "2.0000 times the zonotope's area, 1.0000 times its length");
    }

    #[test]
    fn a_triangle_is_half_of_its_rectangle() {
        let points = [[0.0, 0.0], [3.0, 0.0], [0.0, 4.0]];
        let rectangle = Size::of_box(&smallest_rectangle(&points).expect("a rectangle"));
        let hull = hull_area(&points).expect("an area");
        assert!((rectangle.measure - 12.0).abs() < 1e-12 && (hull - 6.0).abs() < 1e-12, "{rectangle:?}");
    }
}
