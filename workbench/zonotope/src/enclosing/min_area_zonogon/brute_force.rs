//! Minimum-area enclosing zonogon, by the area of Z(O) at every vertex of the arrangement of the lines ℓ_t: the truth.
//!
//! # Statement
//! Input: points of the plane, at least one, finite. Output: the least area of a zonogon that contains them and every
//! vertex of the arrangement at which it is taken, exactly; area 0 and no centre for points on a line.
//!
//! # Source
//! Section 4.1: f is linear on each cell of the arrangement and has a minimum at a vertex.
//!
//! # Method
//! 1. Compute the convex hull in rationals, and for each edge the farthest vertex by comparing all vertices.
//! 2. At every crossing O of two lines ℓ_t, compute f(O): the area of the convex hull of the hull's vertices and their
//!    reflections in O. Keep the least.
//!
//! # Complexity
//! n points, h hull vertices: O(n log n + h³ log h) rational operations.
//!
//! # Shapes
//! `points`: n × 2, h up to about 20.
//!
//! # Numerics
//! Everything is exact rational arithmetic; above the ground floor no code is shared with the methods.
//!
//! # Panics
//! If there are no points or a coordinate is not finite.
//!
//! # Checked by
//! Hand-worked examples; its simplicity.
//!
//! # Example
//! ```
//! use zonotope::enclosing::min_area_zonogon::brute_force::least_area;
//! assert_eq!(least_area(&[[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]]).0, 4.into());
//! ```

use crate::numeric::Rational;
use crate::numeric::exact_linear::{determinant, rational};

type Point = [Rational; 2];

/// The least area and the vertices of the arrangement at which it is taken.
pub fn least_area(points: &[[f64; 2]]) -> (Rational, Vec<Point>) {
    let hull = convex_hull(points.iter().map(|p| p.map(rational)).collect());
    if hull.len() < 3 {
        return (Rational::ZERO, Vec::new());
    }
    let lines: Vec<[Point; 2]> = (0..hull.len()).map(|t| bisector(&hull, t)).collect();
    let pairs = lines.iter().enumerate().flat_map(|(i, a)| lines[..i].iter().map(move |b| (a, b)));
    let mut best: Option<(Rational, Vec<Point>)> = None;
    for center in pairs.filter_map(|(a, b)| meet(a, b)) {
        let area = centered_area(&hull, &center);
        match &mut best {
            Some((least, _)) if area > *least => {}
            Some((least, centers)) if area == *least => {
                if !centers.contains(&center) {
                    centers.push(center);
                }
            }
            _ => best = Some((area, vec![center])),
        }
    }
    best.expect("the lines of a hull with area are not all parallel")
}

/// The area of Z(O) around points.
fn centered_area(points: &[Point], [ox, oy]: &Point) -> Rational {
    let reflected = points.iter().map(|[x, y]| [ox + ox - x, oy + oy - y]);
    let hull = convex_hull(points.iter().cloned().chain(reflected).collect());
    let next = hull.iter().cycle().skip(1);
    let doubled = hull.iter().zip(next).fold(Rational::ZERO, |sum, (a, b)| sum + determinant(&[a, b]));
    doubled / Rational::from(2)
}

/// The line ℓ_t: the midpoint of P_s P_t, a point on it, and e_t, its direction.
fn bisector(hull: &[Point], t: usize) -> [Point; 2] {
    let (from, to) = (&hull[t], &hull[(t + 1) % hull.len()]);
    let height = |p: &Point| doubled_area(from, to, p);
    let far = hull.iter().max_by_key(|p| height(p)).expect("a hull has vertices");
    let half = Rational::from(2);
    [[(&from[0] + &far[0]) / &half, (&from[1] + &far[1]) / &half], difference(from, to)]
}

/// The crossing of two lines, each a point and a direction; `None` for parallel ones.
fn meet([p, u]: &[Point; 2], [q, v]: &[Point; 2]) -> Option<Point> {
    let turn = determinant(&[u, v]);
    (turn != Rational::ZERO).then(|| {
        let along = determinant(&[&difference(p, q), v]) / turn;
        [&p[0] + &along * &u[0], &p[1] + &along * &u[1]]
    })
}

/// Twice the area of the triangle abc, positive where it turns to the left.
fn doubled_area(a: &Point, b: &Point, c: &Point) -> Rational {
    determinant(&[difference(a, b), difference(a, c)])
}

/// to − from.
fn difference(from: &Point, to: &Point) -> Point {
    [&to[0] - &from[0], &to[1] - &from[1]]
}

/// The strictly convex hull, counter-clockwise from the lexicographically smallest point.
fn convex_hull(mut points: Vec<Point>) -> Vec<Point> {
    points.sort();
    points.dedup();
    if points.len() < 3 {
        return points;
    }
    let chain = |points: &mut dyn Iterator<Item = &Point>| {
        let mut chain: Vec<Point> = Vec::new();
        for p in points {
            while chain.len() > 1 && doubled_area(&chain[chain.len() - 2], &chain[chain.len() - 1], p) <= Rational::ZERO
            {
                chain.pop();
            }
            chain.push(p.clone());
        }
        chain.pop();
        chain
    };
    let mut hull = chain(&mut points.iter());
    hull.extend(chain(&mut points.iter().rev()));
    hull
}
