//! Least total length of a zonogon around points of the plane, by golden-section searches for its centre.
//!
//! # Statement
//! Input: points of the plane, at least one, finite. Output: the least total length of a zonogon that contains them, in
//! floating point; 0 for equal points.
//!
//! # Source
//! Section 4.3 for the problem, which the paper solves along a net of directions in every dimension. In the plane the
//! perimeter of conv(P ∪ P') is a convex function of the centre, so a search without derivatives finds its minimum. It
//! shares nothing with the cutting planes that it is held against.
//!
//! # Method
//! 1. The convex hull of the points.
//! 2. A golden-section search for the abscissa of the centre, and for each abscissa one for the ordinate.
//! 3. For each centre the perimeter of the convex hull of the points and their reflections, a quarter of which is the
//!    length.
//!
//! # Complexity
//! n points, h of them on the hull: O(n log n), then O(h log h) for each of about 3,800 centres.
//!
//! # Shapes
//! `points`: n × 2, any order, duplicates allowed.
//!
//! # Numerics
//! Nothing is exact; the length is right to about a relative 1e-12. A golden-section search can place the centre only
//! to about the square root of that, which costs the length nothing, as it is flat near its minimum.
//!
//! # Panics
//! If there are no points or a coordinate is not finite.
//!
//! # Checked by
//! Vertices of zonogons, whose own length is the optimum; the proven bounds of
//! [`by_vertex_sets`](super::super::by_vertex_sets).
//!
//! # Example
//! ```
//! use zonotope::enclosing::min_total_length::in_the_plane::least_length;
//! // the square [0, 2]² is a zonogon: two generators of half-length 1
//! assert!((least_length(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]) - 2.0).abs() < 1e-9);
//! ```

/// The least total length of a zonogon around points, to about a relative 1e-12. O(n log n) and O(h log h) for each of
/// about 3,800 centres, h the number of the hull's vertices.
///
/// # Panics
/// If there are no points or a coordinate is not finite.
pub fn least_length(points: &[[f64; 2]]) -> f64 {
    assert!(!points.is_empty() && points.iter().flatten().all(|c| c.is_finite()), "finite points, at least one");
    perimeter(points, best_center(points)) / 4.0
}

/// The centre of the shortest zonogon.
fn best_center(points: &[[f64; 2]]) -> [f64; 2] {
    let range = |axis: usize| {
        let values = points.iter().map(|p| p[axis]);
        (values.clone().fold(f64::INFINITY, f64::min), values.fold(f64::NEG_INFINITY, f64::max))
    };
    let hull = convex_hull(points.to_vec());
    let along = |x: f64| minimum(range(1), |y| perimeter(&hull, [x, y]));
    let x = minimum(range(0), |x| along(x).1).0;
    [x, along(x).0]
}

/// The minimiser of a convex function on an interval and the minimum, by a golden-section search.
fn minimum((mut low, mut high): (f64, f64), f: impl Fn(f64) -> f64) -> (f64, f64) {
    const SECTION: f64 = 0.618_033_988_749_894_9;
    let mut best = (low, f(low));
    let mut inner = [high - SECTION * (high - low), low + SECTION * (high - low)];
    let mut values = inner.map(&f);
    for _ in 0..58 {
        let better = usize::from(values[1] < values[0]);
        if values[better] < best.1 {
            best = (inner[better], values[better]);
        }
        if better == 0 {
            high = inner[1];
            inner = [high - SECTION * (high - low), inner[0]];
            values = [f(inner[0]), values[0]];
        } else {
            low = inner[0];
            inner = [inner[1], low + SECTION * (high - low)];
            values = [values[1], f(inner[1])];
        }
    }
    best
}

/// The convex hull of points and their reflections in a centre.
fn symmetric_hull(points: &[[f64; 2]], center: [f64; 2]) -> Vec<[f64; 2]> {
    let reflected = points.iter().map(|p| [2.0 * center[0] - p[0], 2.0 * center[1] - p[1]]);
    convex_hull(points.iter().copied().chain(reflected).collect())
}

/// The perimeter of the convex hull of points and their reflections in a centre.
fn perimeter(points: &[[f64; 2]], center: [f64; 2]) -> f64 {
    let hull = symmetric_hull(points, center);
    let next = hull.iter().cycle().skip(1);
    hull.iter().zip(next).map(|(a, b)| ((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1])).sqrt()).sum()
}

/// The convex hull by Andrew's monotone chain in floating point; points that it misjudges are within rounding of the
/// hull's boundary.
fn convex_hull(mut points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let mut hull: Vec<[f64; 2]> = Vec::new();
    let backward = points.iter().rev().copied().collect::<Vec<_>>();
    for chain in [points, backward] {
        let start = hull.len();
        for p in chain {
            while hull.len() >= start + 2 {
                let (a, b) = (hull[hull.len() - 2], hull[hull.len() - 1]);
                if (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 0.0 {
                    break;
                }
                hull.pop();
            }
            hull.push(p);
        }
        hull.pop();
    }
    hull
}
