//! Convex polygons with integer vertices.

use std::cmp::Ordering;

use dashu_int::IBig;

/// A point on the grid.
pub(crate) type Point = [IBig; 2];

/// The vector from `a` to `b`.
pub(crate) fn vector(a: &Point, b: &Point) -> Point {
    [&b[0] - &a[0], &b[1] - &a[1]]
}

/// The cross product u × v = u_x v_y − u_y v_x.
pub(crate) fn cross(u: &Point, v: &Point) -> IBig {
    &u[0] * &v[1] - &u[1] * &v[0]
}

/// A point that can be a corner of a polygon: points are ordered by abscissa, then ordinate.
pub(crate) trait Corner: Ord {
    /// The side of the directed line a b on which p lies, exactly: greater on the left.
    fn side(a: &Self, b: &Self, p: &Self) -> Ordering;
}

impl Corner for Point {
    fn side(a: &Self, b: &Self, p: &Self) -> Ordering {
        cross(&vector(a, b), &vector(a, p)).cmp(&IBig::ZERO)
    }
}

/// A convex polygon, counter-clockwise from its lexicographically smallest vertex, every turn strictly to the left;
/// a segment has two vertices, a point one.
#[derive(Debug, Clone)]
pub(crate) struct ConvexPolygon<P = Point> {
    vertices: Vec<P>,
    /// The index of the lexicographically largest vertex: the lower chain ends and the upper one begins there.
    top: usize,
}

impl<P: Corner> ConvexPolygon<P> {
    /// The polygon with the given vertices, if they are as the type promises.
    pub(crate) fn from_vertices(vertices: Vec<P>) -> Option<Self> {
        let count = vertices.len();
        let top = (0..count).max_by(|&i, &j| vertices[i].cmp(&vertices[j]))?;
        let rising = vertices[..=top].is_sorted_by(|a, b| a < b);
        let falling =
            vertices[top..].is_sorted_by(|a, b| a > b) && (top + 1 >= count || vertices[count - 1] > vertices[0]);
        let turning = count < 3
            || (0..count).all(|i| {
                let [a, b, c] = [i, i + 1, i + 2].map(|j| &vertices[j % count]);
                P::side(a, b, c) == Ordering::Greater
            });
        (rising && falling && turning).then_some(Self { vertices, top })
    }

    /// Whether the point lies in the polygon, its boundary included.
    pub(crate) fn contains(&self, point: &P) -> bool {
        let [first, last] = [&self.vertices[0], &self.vertices[self.top]];
        if point < first || point > last {
            return false;
        }
        if self.vertices.len() == 1 {
            return true;
        }
        let above = 1 + self.vertices[1..self.top].partition_point(|vertex| vertex < point);
        if P::side(&self.vertices[above - 1], &self.vertices[above], point) == Ordering::Less {
            return false;
        }
        let upper = &self.vertices[self.top..];
        let below = upper.partition_point(|vertex| vertex > point).max(1);
        let end = upper.get(below).unwrap_or(first);
        P::side(&upper[below - 1], end, point) != Ordering::Less
    }
}

impl ConvexPolygon {
    /// The convex hull of points (at least one), by the monotone chain.
    pub(crate) fn hull(mut points: Vec<Point>) -> Self {
        points.sort_unstable();
        points.dedup();
        let mut vertices: Vec<Point> = Vec::new();
        let mut chain = |points: &mut dyn Iterator<Item = &Point>| {
            let start = vertices.len();
            for point in points {
                while let [.., a, b] = &vertices[start..] {
                    if Point::side(a, b, point) == Ordering::Greater {
                        break;
                    }
                    vertices.pop();
                }
                vertices.push(point.clone());
            }
            vertices.pop();
        };
        if points.len() > 1 {
            chain(&mut points.iter());
            chain(&mut points.iter().rev());
        } else {
            vertices = points;
        }
        Self::from_vertices(vertices).expect("the monotone chain turns left only")
    }

    /// The zonogon { center + Σ δ_i g_i : |δ_i| ≤ 1 }.
    pub(crate) fn zonogon(center: &Point, generators: &[Point]) -> Self {
        let zero = IBig::ZERO;
        let mut upward: Vec<Point> = generators
            .iter()
            .filter(|[x, y]| *x != zero || *y != zero)
            .map(|[x, y]| match (x.cmp(&zero), y.cmp(&zero)) {
                (Ordering::Greater, _) | (Ordering::Equal, Ordering::Greater) => [x.clone(), y.clone()],
                _ => [-x, -y],
            })
            .collect();
        upward.sort_by(|u, v| zero.cmp(&cross(u, v)));
        let mut merged: Vec<Point> = Vec::new();
        for generator in upward {
            match merged.last_mut() {
                Some(last) if cross(last, &generator) == zero => {
                    last[0] += &generator[0];
                    last[1] += &generator[1];
                }
                _ => merged.push(generator),
            }
        }
        let mut corner = center.clone();
        for generator in &merged {
            corner = vector(generator, &corner);
        }
        let mut vertices = vec![corner.clone()];
        let there = merged.iter().map(|[x, y]| [x * 2, y * 2]);
        let back = merged.iter().map(|[x, y]| [x * -2, y * -2]);
        for step in there.chain(back) {
            corner = [&corner[0] + &step[0], &corner[1] + &step[1]];
            vertices.push(corner.clone());
        }
        if vertices.len() > 1 {
            vertices.pop();
        }
        Self::from_vertices(vertices).expect("generators in angular order bound a convex polygon")
    }

    /// The vertices.
    #[cfg(test)]
    pub(crate) fn vertices(&self) -> &[Point] {
        &self.vertices
    }

    /// Twice the area.
    pub(crate) fn doubled_area(&self) -> IBig {
        let first = &self.vertices[0];
        self.vertices.windows(2).map(|pair| cross(&vector(first, &pair[0]), &vector(first, &pair[1]))).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(coordinates: &[[i64; 2]]) -> Vec<Point> {
        coordinates.iter().map(|point| point.map(IBig::from)).collect()
    }

    /// Whether p is a convex combination of a and b, or of some triangle of the points: by definition.
    fn in_some_triangle(points: &[Point], p: &Point) -> bool {
        let inside = |a: &Point, b: &Point, c: &Point| {
            let sides = [Point::side(a, b, p), Point::side(b, c, p), Point::side(c, a, p)];
            let flat = Point::side(a, b, c) == Ordering::Equal;
            let within = (0..2).all(|axis| {
                let range = [&a[axis], &b[axis], &c[axis]];
                range.iter().any(|&end| *end <= p[axis]) && range.iter().any(|&end| *end >= p[axis])
            });
            within
                && !(sides.contains(&Ordering::Less) && sides.contains(&Ordering::Greater))
                && (!flat || sides.iter().all(|&side| side == Ordering::Equal))
        };
        points.iter().any(|a| points.iter().any(|b| points.iter().any(|c| inside(a, b, c))))
    }

    #[test]
    fn containment_agrees_with_triangles_on_small_lattices() {
        // A linear congruential sequence is enough variety for sets of up to six points of a 5 × 5 lattice.
        let mut state = 7_u64;
        let mut next = |bound: u64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            ((state >> 33) % bound) as i64
        };
        for _ in 0..300 {
            let count = 1 + next(6);
            let set: Vec<[i64; 2]> = (0..count).map(|_| [next(5), next(5)]).collect();
            let set = points(&set);
            let hull = ConvexPolygon::hull(set.clone());
            for x in -1..6 {
                for y in -1..6 {
                    let p = [IBig::from(x), IBig::from(y)];
                    assert_eq!(hull.contains(&p), in_some_triangle(&set, &p), "{set:?} {p:?}");
                }
            }
        }
    }

    #[test]
    fn zonogons_by_hand() {
        let zonogon =
            |center, generators: &[[i64; 2]]| ConvexPolygon::zonogon(&points(&[center])[0], &points(generators));
        let square = zonogon([1, 1], &[[1, 0], [0, -1]]);
        assert_eq!(square.vertices(), points(&[[0, 0], [2, 0], [2, 2], [0, 2]]));
        assert_eq!(square.doubled_area(), IBig::from(8));
        let merged = zonogon([0, 0], &[[1, 0], [-2, 0], [0, 0], [0, 1]]);
        assert_eq!(merged.vertices(), points(&[[-3, -1], [3, -1], [3, 1], [-3, 1]]));
        assert_eq!(zonogon([5, 5], &[[0, 0]]).vertices(), points(&[[5, 5]]));
        assert_eq!(zonogon([0, 0], &[[0, -2]]).vertices(), points(&[[0, -2], [0, 2]]));
        assert_eq!(zonogon([0, 0], &[[2, 1], [1, 2], [1, -1]]).doubled_area(), IBig::from(8 * (3 + 3 + 3)));
    }

    #[test]
    fn only_convex_counter_clockwise_sequences_are_polygons() {
        let polygon = |vertices: &[[i64; 2]]| ConvexPolygon::from_vertices(points(vertices)).is_some();
        assert!(polygon(&[[0, 0], [2, 0], [2, 2], [0, 2]]));
        assert!(polygon(&[[0, 0], [1, 1]]));
        assert!(polygon(&[[3, 3]]));
        assert!(!polygon(&[]));
        assert!(!polygon(&[[2, 0], [2, 2], [0, 2], [0, 0]]), "starts elsewhere");
        assert!(!polygon(&[[0, 0], [0, 2], [2, 2], [2, 0]]), "clockwise");
        assert!(!polygon(&[[0, 0], [1, 0], [2, 0], [1, 1]]), "a straight corner");
        assert!(!polygon(&[[0, 0], [0, 0]]), "a repeated vertex");
        let star = [[0, 5], [8, 5], [1, 0], [4, 8], [7, 0]];
        assert!(!polygon(&star), "a star turns left twice around");
    }
}
