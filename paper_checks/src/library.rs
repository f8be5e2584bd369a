//! Points as the library takes them, and its answers as the checks compare them.

use zonotope::enclosing::min_area_zonogon::MinAreaZonogon;

use crate::plane::Point;
use crate::ratio::{exactly, integer};

/// The points in doubles, each coordinate rounded.
pub(crate) fn doubles(points: &[Point]) -> Vec<[f64; 2]> {
    points.iter().map(|point| [point.x.to_f64_fast(), point.y.to_f64_fast()]).collect()
}

/// The exact values of points in doubles.
pub(crate) fn exact([x, y]: [f64; 2]) -> Point {
    Point::new(exactly(x), exactly(y))
}

/// Whether the zonogon contains every point: none is farther from the centre, across a generator, than the zonogon reaches.
pub(crate) fn encloses(answer: &MinAreaZonogon, points: &[Point]) -> bool {
    let center = exact(answer.zonogon.center());
    let generators: Vec<Point> = answer.zonogon.generators().iter().copied().map(exact).collect();
    let across = |direction: &Point, vector: &Point| {
        let cross = direction.cross(vector);
        if cross < integer(0) { -cross } else { cross }
    };
    let axes = [Point::at(1, 0), Point::at(0, 1)];
    generators.iter().chain(&axes).all(|direction| {
        let reach = generators.iter().fold(integer(0), |sum, generator| sum + across(direction, generator));
        points.iter().all(|point| across(direction, &center.to(point)) <= reach)
    })
}
