//! The geometry of section 4.1 from its definitions, in exact rationals and without regard to speed.
//!
//! Everything here is the checks' own side of each comparison, so nothing of it comes from the library: the zonogon
//! about a centre is the convex hull of the points and their reflections, its area is the shoelace sum, and the lines
//! of the arrangement are built by looking at every vertex for every edge.

use std::cmp::Ordering;
use std::fmt;

use dashu_ratio::RBig;

use crate::definitions::ratio::{exactly, integer};

/// A point or vector of the plane.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Point {
    /// The first coordinate.
    pub x: RBig,
    /// The second coordinate.
    pub y: RBig,
}

impl fmt::Display for Point {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "({}, {})", self.x, self.y)
    }
}

impl Point {
    /// The point (x, y).
    pub fn new(x: RBig, y: RBig) -> Self {
        Point { x, y }
    }

    /// The point with these integer coordinates.
    pub fn at(x: i64, y: i64) -> Self {
        Point::new(integer(x), integer(y))
    }

    /// The exact value of a point in finite doubles.
    pub fn exactly([x, y]: [f64; 2]) -> Self {
        Point::new(exactly(x), exactly(y))
    }

    /// The vector from `self` to `other`.
    pub fn to(&self, other: &Point) -> Point {
        Point::new(&other.x - &self.x, &other.y - &self.y)
    }

    /// The point reached from `self` by `factor` times `vector`.
    pub fn plus(&self, factor: &RBig, vector: &Point) -> Point {
        Point::new(&self.x + factor * &vector.x, &self.y + factor * &vector.y)
    }

    /// The midpoint of `self` and `other`.
    pub fn midpoint(&self, other: &Point) -> Point {
        let two = integer(2);
        Point::new((&self.x + &other.x) / &two, (&self.y + &other.y) / two)
    }

    /// The reflection of `self` through `center`.
    pub fn reflected_through(&self, center: &Point) -> Point {
        center.plus(&integer(-1), &center.to(self))
    }

    /// The cross product of two vectors.
    pub fn cross(&self, other: &Point) -> RBig {
        &self.x * &other.y - &self.y * &other.x
    }
}

/// Twice the signed area of the triangle a, b, c: positive when it turns left.
pub fn turn(a: &Point, b: &Point, c: &Point) -> RBig {
    a.to(b).cross(&a.to(c))
}

/// The signed area of a closed polygon, by the shoelace sum.
pub fn signed_area<'a>(polygon: impl IntoIterator<Item = &'a Point>) -> RBig {
    let polygon: Vec<&Point> = polygon.into_iter().collect();
    let mut double = RBig::ZERO;
    for (index, point) in polygon.iter().enumerate() {
        double += point.cross(polygon[(index + 1) % polygon.len()]);
    }
    double / integer(2)
}

/// The strictly convex hull, counter-clockwise from the lexicographically smallest point; one or two points when flat.
pub fn convex_hull(points: &[Point]) -> Vec<Point> {
    let mut sorted = points.to_vec();
    sorted.sort();
    sorted.dedup();
    if sorted.len() <= 2 {
        return sorted;
    }
    let half = |points: &mut dyn Iterator<Item = &Point>| {
        let mut chain: Vec<Point> = Vec::new();
        for point in points {
            while let [.., a, b] = chain.as_slice()
                && turn(a, b, point) <= RBig::ZERO
            {
                chain.pop();
            }
            chain.push(point.clone());
        }
        chain.pop();
        chain
    };
    let mut hull = half(&mut sorted.iter());
    hull.extend(half(&mut sorted.iter().rev()));
    hull
}

/// Z(O): the convex hull of the points and of their reflections through `center`.
pub fn zonogon_about(points: &[Point], center: &Point) -> Vec<Point> {
    let mut all = points.to_vec();
    all.extend(points.iter().map(|point| point.reflected_through(center)));
    convex_hull(&all)
}

/// f(O): the area of Z(O).
pub fn zonogon_area(points: &[Point], center: &Point) -> RBig {
    signed_area(&zonogon_about(points, center))
}

/// Whether a point is in { center + Σ δ_i generators_i : |δ_i| <= 1 }: across no generator, and along no axis, is it
/// farther from the centre than the generators reach. The axes decide when all generators are parallel.
pub fn generated_zonogon_contains(center: &Point, generators: &[Point], point: &Point) -> bool {
    let across = |direction: &Point, vector: &Point| {
        let cross = direction.cross(vector);
        if cross < RBig::ZERO { -cross } else { cross }
    };
    let axes = [Point::at(1, 0), Point::at(0, 1)];
    generators.iter().chain(&axes).all(|direction| {
        let reach = generators.iter().fold(RBig::ZERO, |sum, generator| sum + across(direction, generator));
        across(direction, &center.to(point)) <= reach
    })
}

/// The paper's line ℓ_t for one edge of a convex polygon: the line half way between the edge and the farthest vertex.
#[derive(Clone, Debug)]
pub struct Bisector {
    /// The midpoint of P_s and P_t.
    pub start: Point,
    /// The edge vector from P_t to P_{t+1}; twice the vector between the two midpoints.
    pub edge: Point,
}

impl Bisector {
    /// Positive on the left of the directed line, where the edge appears on Z(O): |e_t| times the signed distance.
    pub fn height(&self, center: &Point) -> RBig {
        self.edge.cross(&self.start.to(center))
    }

    /// The gradient of [`Bisector::height`].
    pub fn gradient(&self) -> Point {
        Point::new(-&self.edge.y, self.edge.x.clone())
    }

    /// The point where the two lines meet, or `None` when they are parallel.
    pub fn intersection(&self, other: &Bisector) -> Option<Point> {
        let determinant = self.edge.cross(&other.edge);
        (determinant != RBig::ZERO).then(|| {
            let along = self.start.to(&other.start).cross(&other.edge) / determinant;
            self.start.plus(&along, &self.edge)
        })
    }
}

/// The vertices farthest from the edge that starts at vertex `t`: one, or two when an edge is parallel to it.
pub fn farthest_vertices(polygon: &[Point], t: usize) -> Vec<usize> {
    let (from, to) = (&polygon[t], &polygon[(t + 1) % polygon.len()]);
    let heights: Vec<RBig> = polygon.iter().map(|point| turn(from, to, point)).collect();
    let farthest = heights.iter().max().expect("a polygon has vertices");
    (0..polygon.len()).filter(|&s| heights[s] == *farthest).collect()
}

/// The line ℓ_t with the farthest vertex `s`.
pub fn bisector(polygon: &[Point], t: usize, s: usize) -> Bisector {
    let (from, to) = (&polygon[t], &polygon[(t + 1) % polygon.len()]);
    Bisector { start: polygon[s].midpoint(from), edge: from.to(to) }
}

/// The lines ℓ_t of a counter-clockwise convex polygon, one for each edge.
pub fn bisectors(polygon: &[Point]) -> Vec<Bisector> {
    (0..polygon.len()).map(|t| bisector(polygon, t, farthest_vertices(polygon, t)[0])).collect()
}

/// All points where two of the lines meet, in order and without repetition.
pub fn arrangement_vertices(lines: &[Bisector]) -> Vec<Point> {
    let mut vertices: Vec<Point> = lines
        .iter()
        .enumerate()
        .flat_map(|(index, line)| lines[..index].iter().filter_map(|other| line.intersection(other)))
        .collect();
    vertices.sort();
    vertices.dedup();
    vertices
}

/// The hinge sum 2 Σ max(0, e_t × (O − m_t)): f(O) without its constant.
pub fn hinge_sum(lines: &[Bisector], center: &Point) -> RBig {
    let mut sum = RBig::ZERO;
    for line in lines {
        let height = line.height(center);
        if height > RBig::ZERO {
            sum += height;
        }
    }
    sum * integer(2)
}

/// The side of each line on which `center` lies: the name of its cell.
pub fn cell(lines: &[Bisector], center: &Point) -> Vec<Ordering> {
    lines.iter().map(|line| line.height(center).cmp(&RBig::ZERO)).collect()
}

/// The gradient of f inside the cell of `center`, which must lie on none of the lines.
pub fn cell_gradient(lines: &[Bisector], center: &Point) -> Point {
    lines
        .iter()
        .filter(|line| line.height(center) > RBig::ZERO)
        .fold(Point::at(0, 0), |sum, line| sum.plus(&integer(2), &line.gradient()))
}

/// The least value of f, by looking at every vertex of the arrangement, and where it is attained.
pub fn least_area(polygon: &[Point]) -> (RBig, Vec<Point>) {
    let lines = bisectors(polygon);
    let constant = zonogon_area(polygon, &polygon[0]) - hinge_sum(&lines, &polygon[0]);
    let mut best: Option<RBig> = None;
    let mut minimizers = Vec::new();
    for vertex in arrangement_vertices(&lines) {
        let value = &constant + hinge_sum(&lines, &vertex);
        let order = best.as_ref().map_or(Ordering::Less, |least| value.cmp(least));
        if order == Ordering::Less {
            minimizers.clear();
            best = Some(value);
        }
        if order != Ordering::Greater {
            minimizers.push(vertex);
        }
    }
    (best.expect("the edges of a polygon are not all parallel"), minimizers)
}
