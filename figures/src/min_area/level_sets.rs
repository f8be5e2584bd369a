//! Level sets of a convex function that is affine on every cell of a line arrangement.
//!
//! A bounded level set is a convex polygon with its corners on the lines, and a line meets it in at most two points.
//! The corners are found line by line: on a line the function is convex and affine between consecutive crossings,
//! and between (or beyond) the right two of them the level is met.

use super::DrawnLine;
use zonotope::hull::convex_hull;

/// The polygon of the points where the function is at most `level`, its corners counter-clockwise.
///
/// `value` is the function; the level set must be bounded. Empty below the minimum.
pub fn level_set(lines: &[DrawnLine], value: &dyn Fn([f64; 2]) -> f64, level: f64) -> Vec<[f64; 2]> {
    let corners: Vec<[f64; 2]> = lines.iter().flat_map(|line| level_on_line(line, lines, value, level)).collect();
    convex_hull(&corners, &mut ()).map(|hull| hull.vertices().to_vec()).unwrap_or_default()
}

/// The points of a line where the function meets the level: none, or two.
fn level_on_line(line: &DrawnLine, lines: &[DrawnLine], value: &dyn Fn([f64; 2]) -> f64, level: f64) -> Vec<[f64; 2]> {
    let at =
        |parameter: f64| [line.point[0] + parameter * line.direction[0], line.point[1] + parameter * line.direction[1]];
    let mut stops: Vec<f64> = lines.iter().filter_map(|other| crossing_parameter(line, other)).collect();
    stops.sort_by(f64::total_cmp);
    let (Some(&first), Some(&last)) = (stops.first(), stops.last()) else { return Vec::new() };
    // Beyond the outermost crossings the function is affine: a stop on either side shows its slope there.
    let beyond = (last - first).max(1.0);
    stops.insert(0, first - beyond);
    stops.push(last + beyond);
    let values: Vec<f64> = stops.iter().map(|&stop| value(at(stop))).collect();
    let Some(lowest) = (0..stops.len()).min_by(|&a, &b| values[a].total_cmp(&values[b])) else { return Vec::new() };
    if values[lowest] >= level {
        return Vec::new();
    }
    let met = |inner: usize, outer: usize| {
        let part = (level - values[inner]) / (values[outer] - values[inner]);
        at(stops[inner] + part * (stops[outer] - stops[inner]))
    };
    let end = stops.len() - 1;
    let right = (lowest + 1..=end).find(|&stop| values[stop] >= level).unwrap_or(end);
    let left = (0..lowest).rev().find(|&stop| values[stop] >= level).unwrap_or(0);
    vec![met(left + 1, left), met(right - 1, right)]
}

fn crossing_parameter(line: &DrawnLine, other: &DrawnLine) -> Option<f64> {
    let cross = |a: [f64; 2], b: [f64; 2]| a[0] * b[1] - a[1] * b[0];
    let determinant = cross(line.direction, other.direction);
    let apart = [other.point[0] - line.point[0], other.point[1] - line.point[1]];
    (determinant != 0.0).then(|| cross(apart, other.direction) / determinant)
}

#[cfg(test)]
mod tests {
    use super::*;

    const AXES: [DrawnLine; 2] = [
        DrawnLine { point: [0.0, 0.0], direction: [1.0, 0.0] },
        DrawnLine { point: [0.0, 0.0], direction: [0.0, 1.0] },
    ];

    #[test]
    fn the_level_sets_of_the_sum_of_absolute_values_are_diamonds() {
        let value = |[x, y]: [f64; 2]| x.abs() + y.abs();
        let corners = level_set(&AXES, &value, 3.0);
        assert_eq!(corners, [[-3.0, 0.0], [0.0, -3.0], [3.0, 0.0], [0.0, 3.0]]);
    }

    #[test]
    fn below_the_minimum_there_is_nothing() {
        let value = |[x, y]: [f64; 2]| 1.0 + x.abs() + y.abs();
        assert!(level_set(&AXES, &value, 0.5).is_empty());
    }

    #[test]
    fn slopes_change_at_crossings() {
        // |x| + |y| + |x - 1|: on the x axis the value 3 is met at -1 and 2.
        let lines = [AXES[0], AXES[1], DrawnLine { point: [1.0, 0.0], direction: [0.0, 1.0] }];
        let value = |[x, y]: [f64; 2]| x.abs() + y.abs() + (x - 1.0).abs();
        let corners = level_set(&lines, &value, 3.0);
        assert_eq!(corners, [[-1.0, 0.0], [0.0, -2.0], [1.0, -2.0], [2.0, 0.0], [1.0, 2.0], [0.0, 2.0]]);
    }
}
