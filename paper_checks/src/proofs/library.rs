//! Points as the library takes them, and its answers as the checks compare them.

use zonotope::enclosing::centered_zonogon::CenteredZonogon;
use zonotope::enclosing::min_area_zonogon::MinAreaZonogon;
use zonotope::hull::antipodal::farthest_vertices;
use zonotope::hull::convex_hull;

use crate::definitions::plane::{Point, generated_zonogon_contains};

/// The points in doubles, each coordinate rounded.
pub(crate) fn doubles(points: &[Point]) -> Vec<[f64; 2]> {
    points.iter().map(double).collect()
}

/// The point in doubles, each coordinate rounded.
pub(crate) fn double(point: &Point) -> [f64; 2] {
    [point.x.to_f64_fast(), point.y.to_f64_fast()]
}

/// Whether the zonogon of an answer contains every point.
pub(crate) fn encloses(answer: &MinAreaZonogon, points: &[Point]) -> bool {
    let center = Point::exactly(answer.body.center());
    let generators: Vec<Point> = answer.body.generators().iter().copied().map(Point::exactly).collect();
    points.iter().all(|point| generated_zonogon_contains(&center, &generators, point))
}

/// The library's Z(O) of a polygon in doubles: its vertices in order, and the number of runs in its description.
pub(crate) fn centered_zonogon(polygon: &[Point], center: [f64; 2]) -> (Vec<Point>, usize) {
    let hull = convex_hull(&doubles(polygon), &mut ()).expect("a polygon has vertices, and they are finite");
    let farthest = farthest_vertices(&hull, &mut ());
    let zonogon = CenteredZonogon::new(&hull, &farthest, center, &mut ());
    let vertex = |at| {
        let [x, y] = zonogon.exact_vertex(at).map(|coordinate| coordinate.to_rational());
        Point::new(x, y)
    };
    (zonogon.boundary().map(vertex).collect(), zonogon.description().len())
}
