//! Convex polygons and points for the checks: random ones from a seed, and the degenerate ones that random draws miss.

use std::collections::BTreeSet;

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use crate::definitions::plane::{Point, convex_hull};
use crate::definitions::ratio::{fraction, integer};

/// A polygon with the words that name it in a witness.
#[derive(Clone, Debug)]
pub struct Instance {
    /// The words that name the polygon in a witness.
    pub name: String,
    /// The vertices of the polygon, strictly convex, counter-clockwise.
    pub polygon: Vec<Point>,
}

/// The generator of one check's random draws: `stream` keeps the checks apart.
pub fn generator(seed: u64, stream: u64) -> Pcg64Mcg {
    Pcg64Mcg::seed_from_u64(seed ^ stream.wrapping_add(1).wrapping_mul(0x9E37_79B9_7F4A_7C15))
}

/// A polygon from integer coordinates, as their convex hull.
pub fn polygon(coordinates: &[(i64, i64)]) -> Vec<Point> {
    let points: Vec<Point> = coordinates.iter().map(|&(x, y)| Point::at(x, y)).collect();
    convex_hull(&points)
}

/// The convex hull of `draws` random lattice points of a square of half-width `reach`, again until it has area.
pub fn random_polygon(random: &mut Pcg64Mcg, draws: usize, reach: i64) -> Vec<Point> {
    loop {
        let points: Vec<Point> = (0..draws)
            .map(|_| Point::at(random.random_range(-reach..=reach), random.random_range(-reach..=reach)))
            .collect();
        let hull = convex_hull(&points);
        if hull.len() >= 3 {
            return hull;
        }
    }
}

/// A polygon with exactly this many vertices, random ones of the parabola y = x² with |x| ≤ 4000.
pub fn parabola_polygon(random: &mut Pcg64Mcg, vertices: usize) -> Vec<Point> {
    let mut x = BTreeSet::new();
    while x.len() < vertices {
        x.insert(random.random_range(-4000..=4000));
    }
    let points: Vec<Point> = x.into_iter().map(|x| Point::at(x, x * x)).collect();
    convex_hull(&points)
}

/// A random point with coordinates in sevenths within a square of half-width `reach`.
pub fn random_point(random: &mut Pcg64Mcg, reach: i64) -> Point {
    let mut coordinate = || fraction(random.random_range(-7 * reach..=7 * reach), 7);
    let x = coordinate();
    Point::new(x, coordinate())
}

/// A random centre for a polygon: one time in three anywhere about it, else near its middle, where Z(O) changes most.
pub fn random_center(random: &mut Pcg64Mcg, polygon: &[Point]) -> Point {
    let anywhere = random_point(random, reach(polygon));
    let share = [integer(1), fraction(1, 5), fraction(1, 40)][random.random_range(0..3)].clone();
    let middle = polygon.iter().fold(Point::at(0, 0), |sum, point| sum.plus(&fraction(1, polygon.len() as i64), point));
    middle.plus(&share, &middle.to(&anywhere))
}

/// Polygons with parallel edges, vertical and horizontal edges, symmetry, many collinear coincidences, and thin ones.
pub fn degenerate_polygons() -> Vec<Instance> {
    let named: [(&str, &[(i64, i64)]); 12] = [
        ("the triangle (0,0), (4,0), (1,3)", &[(0, 0), (4, 0), (1, 3)]),
        ("the isosceles triangle with a vertical edge", &[(0, -2), (0, 2), (5, 0)]),
        ("the unit square", &[(0, 0), (1, 0), (1, 1), (0, 1)]),
        ("the parallelogram (0,0), (5,1), (7,4), (2,3)", &[(0, 0), (5, 1), (7, 4), (2, 3)]),
        ("the trapezoid (0,0), (6,0), (4,2), (1,2)", &[(0, 0), (6, 0), (4, 2), (1, 2)]),
        ("the kite (0,-3), (2,0), (0,1), (-2,0)", &[(0, -3), (2, 0), (0, 1), (-2, 0)]),
        (
            "the centrally symmetric hexagon (±3,0), ±(1,2), ±(-2,3)",
            &[(3, 0), (1, 2), (-2, 3), (-3, 0), (-1, -2), (2, -3)],
        ),
        (
            "the symmetric lattice octagon (±1,±3), (±3,±1)",
            &[(1, 3), (3, 1), (3, -1), (1, -3), (-1, -3), (-3, -1), (-3, 1), (-1, 3)],
        ),
        ("the house (0,0), (2,0), (2,2), (1,3), (0,2)", &[(0, 0), (2, 0), (2, 2), (1, 3), (0, 2)]),
        ("the needle (0,0), (1000000,1), (1000001,2)", &[(0, 0), (1_000_000, 1), (1_000_001, 2)]),
        (
            "the nearly parallel quadrilateral (0,0), (10^6,0), (10^6,10^6), (0,10^6+1)",
            &[(0, 0), (1_000_000, 0), (1_000_000, 1_000_000), (0, 1_000_001)],
        ),
        ("the hexagon with three parallel pairs and no centre", &[(0, 0), (4, 0), (5, 1), (5, 3), (4, 3), (0, -1)]),
    ];
    named
        .into_iter()
        .map(|(name, coordinates)| Instance { name: name.to_owned(), polygon: polygon(coordinates) })
        .collect()
}

/// `count` random polygons of 3 to about 16 vertices, on coarse and on fine lattices.
pub fn random_polygons(random: &mut Pcg64Mcg, count: usize) -> Vec<Instance> {
    (0..count)
        .map(|index| {
            let draws = [3 + index % 8, 20, 150][index % 3];
            let reach = [6, 40, 10_000, 300][index % 4];
            Instance { name: format!("random polygon {index}"), polygon: random_polygon(random, draws, reach) }
        })
        .collect()
}

/// Random and degenerate polygons together.
pub fn polygons(random: &mut Pcg64Mcg, count: usize) -> Vec<Instance> {
    let mut all = degenerate_polygons();
    all.extend(random_polygons(random, count));
    all
}

/// The half-width of a square about the origin that holds the polygon with room to spare.
fn reach(polygon: &[Point]) -> i64 {
    polygon
        .iter()
        .flat_map(|point| [&point.x, &point.y])
        .map(|coordinate| coordinate.to_f64_fast().abs() as i64 + 1)
        .max()
        .unwrap_or(1)
}

/// The vertices, written out.
pub fn listed(polygon: &[Point]) -> String {
    let points: Vec<String> = polygon.iter().map(Point::to_string).collect();
    points.join(", ")
}
