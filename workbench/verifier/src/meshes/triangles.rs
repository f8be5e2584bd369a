//! Two closed triangles in whole numbers: whether they have a point in common, and the square of their distance.

use dashu_int::IBig;

use crate::exact::linear::product;

/// A point in units of a question.
pub(crate) type Point = [IBig; 3];

/// Three corners, in any position.
pub(crate) type Triangle = [Point; 3];

/// The edges by their ends.
const EDGES: [[usize; 2]; 3] = [[0, 1], [1, 2], [2, 0]];

fn minus(p: &Point, q: &Point) -> Point {
    [&p[0] - &q[0], &p[1] - &q[1], &p[2] - &q[2]]
}

fn dot(u: &Point, v: &Point) -> IBig {
    product(&u[0], &v[0]) + product(&u[1], &v[1]) + product(&u[2], &v[2])
}

fn cross(u: &Point, v: &Point) -> Point {
    let minor = |i: usize, j: usize| product(&u[i], &v[j]) - product(&u[j], &v[i]);
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

fn is_zero(v: &Point) -> bool {
    v.iter().all(|c| *c == IBig::ZERO)
}

/// Whether two triangles have a point in common.
///
/// Their difference is a polytope, and the origin is outside just when a direction separates it: the normal of a facet
/// where the polytope is solid; where it is flat, the normal of its plane, or that of an edge in the plane; where it
/// lies on a line, the part of a difference across the line, or the line; of a point, the difference itself. Facets,
/// planes and lines are spanned by edges of the triangles. All of these directions are tried.
pub(crate) fn meet(a: &Triangle, b: &Triangle) -> bool {
    let of = |t: &Triangle| EDGES.map(|[i, j]| minus(&t[j], &t[i]));
    let edges: Vec<Point> = of(a).into_iter().chain(of(b)).filter(|edge| !is_zero(edge)).collect();
    let mut normals = Vec::new();
    for (k, u) in edges.iter().enumerate() {
        for v in &edges[..k] {
            let normal = cross(v, u);
            if !is_zero(&normal) {
                if separates(&normal, a, b) {
                    return false;
                }
                normals.push(normal);
            }
        }
    }
    let between = minus(&b[0], &a[0]);
    let mut others = edges.clone();
    others.extend(normals.first().iter().flat_map(|normal| edges.iter().map(|edge| cross(normal, edge))));
    others.extend(edges.first().map(|edge| cross(edge, &cross(&between, edge))));
    others.push(between);
    others.iter().all(|direction| !separates(direction, a, b))
}

/// Whether one triangle is below the other one along a direction, with a gap between.
fn separates(direction: &Point, a: &Triangle, b: &Triangle) -> bool {
    let ends = |t: &Triangle| {
        let mut heights = t.each_ref().map(|corner| dot(direction, corner));
        heights.sort();
        heights
    };
    let (a, b) = (ends(a), ends(b));
    a[2] < b[0] || b[2] < a[0]
}

/// The square of the distance of two triangles that do not meet, as numerator and positive denominator.
///
/// The nearest points lie on features of dimension at most two together; a pair of features counts if the nearest
/// points of their lines and planes lie on them.
pub(super) fn squared_distance(a: &Triangle, b: &Triangle) -> [IBig; 2] {
    let mut squares: Vec<[IBig; 2]> = Vec::new();
    for p in a {
        for q in b {
            let between = minus(q, p);
            squares.push([dot(&between, &between), IBig::ONE]);
        }
    }
    for (surface, corners) in [(a, b), (b, a)] {
        for corner in corners {
            squares.extend(to_plane(surface, corner));
            squares.extend(EDGES.iter().filter_map(|&[i, j]| to_line(&surface[i], &surface[j], corner)));
        }
    }
    for [i, j] in EDGES {
        squares.extend(EDGES.iter().filter_map(|&[k, l]| between_lines([&a[i], &a[j]], [&b[k], &b[l]])));
    }
    let least = squares.into_iter().reduce(|least, next| if is_below(&next, &least) { next } else { least });
    least.unwrap_or([IBig::ZERO, IBig::ONE])
}

/// Whether one fraction is below another one.
pub(super) fn is_below(first: &[IBig; 2], second: &[IBig; 2]) -> bool {
    product(&first[0], &second[1]) < product(&second[0], &first[1])
}

fn is_share(part: &IBig, whole: &IBig) -> bool {
    *part >= IBig::ZERO && part <= whole
}

fn to_line(p: &Point, q: &Point, corner: &Point) -> Option<[IBig; 2]> {
    let (along, from) = (minus(q, p), minus(corner, p));
    let square = dot(&along, &along);
    let off = cross(&from, &along);
    (square > IBig::ZERO && is_share(&dot(&from, &along), &square)).then(|| [dot(&off, &off), square])
}

fn to_plane([p, q, r]: &Triangle, corner: &Point) -> Option<[IBig; 2]> {
    let (u, v, from) = (minus(q, p), minus(r, p), minus(corner, p));
    let normal = cross(&u, &v);
    let square = dot(&normal, &normal);
    let shares = [dot(&normal, &cross(&from, &v)), dot(&normal, &cross(&u, &from))];
    let rest = &square - &shares[0] - &shares[1];
    let is_over = square > IBig::ZERO && shares.iter().chain([&rest]).all(|share| is_share(share, &square));
    let height = dot(&normal, &from);
    is_over.then(|| [product(&height, &height), square])
}

fn between_lines([p, q]: [&Point; 2], [r, s]: [&Point; 2]) -> Option<[IBig; 2]> {
    let (u, v, from) = (minus(q, p), minus(s, r), minus(r, p));
    let normal = cross(&u, &v);
    let square = dot(&normal, &normal);
    let shares = [dot(&normal, &cross(&from, &v)), dot(&normal, &cross(&from, &u))];
    let crosses = square > IBig::ZERO && shares.iter().all(|share| is_share(share, &square));
    let height = dot(&normal, &from);
    crosses.then(|| [product(&height, &height), square])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn triangle(corners: [[i32; 3]; 3]) -> Triangle {
        corners.map(|corner| corner.map(IBig::from))
    }

    #[test]
    fn triangles_that_touch_meet() {
        let floor = triangle([[0, 0, 0], [4, 0, 0], [0, 4, 0]]);
        for touching in [
            [[1, 1, 0], [1, 1, 5], [2, 1, 5]],
            [[4, 0, 0], [9, 0, 0], [9, 1, 0]],
            [[2, 2, -1], [2, 2, 1], [9, 9, 0]],
            [[-1, 2, 0], [1, 2, 0], [-1, 3, 0]],
            [[1, 1, 0]; 3],
            [[0, 0, 0], [0, 0, 3], [0, 0, 7]],
        ] {
            assert!(meet(&floor, &triangle(touching)), "{touching:?}");
        }
        for apart in [
            [[1, 1, 1], [1, 1, 5], [2, 1, 5]],
            [[5, 0, 0], [9, 0, 0], [9, 1, 0]],
            [[3, 3, -1], [3, 3, 1], [9, 9, 0]],
            [[3, 3, 0]; 3],
        ] {
            assert!(!meet(&floor, &triangle(apart)), "{apart:?}");
        }
        let [one, two] = [triangle([[0, 0, 0], [2, 2, 2], [1, 1, 1]]), triangle([[3, 3, 3], [4, 4, 4], [3, 3, 3]])];
        assert!(!meet(&one, &two) && meet(&one, &one));
        // A segment of the plane below the side from (0, 0) to (2, 1).
        let below = triangle([[2, 0, 0], [2, 0, 0], [1, 0, 0]]);
        assert!(!meet(&below, &triangle([[0, 0, 0], [2, 1, 0], [0, 1, 0]])));
    }

    #[test]
    fn distances_by_hand() {
        let floor = triangle([[0, 0, 0], [4, 0, 0], [0, 4, 0]]);
        let square = |corners| {
            let [numerator, denominator] = squared_distance(&floor, &triangle(corners));
            assert_eq!(&numerator % &denominator, IBig::ZERO);
            numerator / denominator
        };
        assert_eq!(square([[1, 1, 2], [1, 2, 5], [9, 9, 9]]), IBig::from(4));
        assert_eq!(square([[1, -1, 1], [2, -1, 1], [3, -8, 1]]), IBig::from(2));
        assert_eq!(square([[-3, -4, 0]; 3]), IBig::from(25));
        assert_eq!(square([[4, 4, 3], [4, 4, -3], [9, 9, 0]]), IBig::from(8));
    }

    /// Corners over the plane of a triangle, beyond each of its edges: the nearest point is on the edge.
    #[test]
    fn corners_beside_a_triangle_are_near_its_edges() {
        let point = |x: i32, y: i32, z: i32| [x, y, z].map(IBig::from);
        let flat = [point(0, 0, 0), point(10, 0, 0), point(0, 10, 0)];
        let above = |x: i32, y: i32| [point(x, y, 30), point(x, y, 31), point(x, y + 1, 31)];
        let square = |x: i32, y: i32| {
            let [numerator, denominator] = squared_distance(&flat, &above(x, y));
            let turned = squared_distance(&above(x, y), &flat);
            assert!(!is_below(&[numerator.clone(), denominator.clone()], &turned));
            assert!(!is_below(&turned, &[numerator.clone(), denominator.clone()]));
            (&numerator / &denominator, numerator % denominator)
        };
        for (at, exact) in
            [((3, 3), 900), ((9, 9), 932), ((4, -4), 916), ((-4, 4), 916), ((-3, -4), 925), ((14, 0), 916)]
        {
            assert_eq!(square(at.0, at.1), (IBig::from(exact), IBig::ZERO), "{at:?}");
        }
    }
}
