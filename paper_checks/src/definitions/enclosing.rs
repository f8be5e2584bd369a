//! Zonotopes along given directions, in any dimension, from their definition and in exact rationals.
//!
//! Like [`space`](super::space) this is the checks' own side of each comparison, written without regard to speed:
//! normals by elimination for every subset of d − 1 directions, programs by the simplex method of this crate.

use std::collections::BTreeSet;

use dashu_ratio::RBig;

use crate::definitions::linear_program::{Equation, least};
use crate::definitions::ratio::{exactly, integer};

/// A vector of any dimension.
pub(crate) type Row = Vec<RBig>;

/// Integer vectors as rows.
pub(crate) fn rows<const D: usize>(vectors: &[[i64; D]]) -> Vec<Row> {
    vectors.iter().map(|v| v.iter().copied().map(integer).collect()).collect()
}

/// Vectors of finite doubles as rows, exactly.
pub(crate) fn exact_rows<const D: usize>(vectors: &[[f64; D]]) -> Vec<Row> {
    vectors.iter().map(|v| v.iter().copied().map(exactly).collect()).collect()
}

/// Integer vectors in doubles, exactly.
pub(crate) fn doubles<const D: usize>(vectors: &[[i64; D]]) -> Vec<[f64; D]> {
    vectors.iter().map(|v| v.map(|c| c as f64)).collect()
}

/// The scalar product.
pub(crate) fn dot(a: &[RBig], b: &[RBig]) -> RBig {
    a.iter().zip(b).fold(RBig::ZERO, |sum, (x, y)| sum + x * y)
}

/// The absolute value.
pub(crate) fn absolute(value: RBig) -> RBig {
    if value < RBig::ZERO { -value } else { value }
}

/// A rational number at least the square root of `square`, and above it by less than one part in 10^15.
pub(crate) fn root_above(square: &RBig) -> RBig {
    let mut root = square.to_f64_fast().sqrt();
    while exactly(root) * exactly(root) < *square {
        root = root.next_up();
    }
    exactly(root)
}

/// For each subset of `dimension` − 1 vectors whose normal is unique, that normal, its first coordinate that is not
/// zero being 1; each once.
pub(crate) fn facet_normals(vectors: &[Row], dimension: usize) -> BTreeSet<Row> {
    let mut found = BTreeSet::new();
    subsets(vectors.len(), dimension - 1, &mut |subset| {
        let chosen: Vec<Row> = subset.iter().map(|&i| vectors[i].clone()).collect();
        found.extend(normal(chosen, dimension));
    });
    found
}

/// Calls `visit` for every subset of `size` of the numbers below `count`, its members in increasing order.
pub(crate) fn subsets(count: usize, size: usize, visit: &mut impl FnMut(&[usize])) {
    fn extend(start: usize, count: usize, size: usize, chosen: &mut Vec<usize>, visit: &mut impl FnMut(&[usize])) {
        if chosen.len() == size {
            visit(chosen);
            return;
        }
        for next in start..count {
            chosen.push(next);
            extend(next + 1, count, size, chosen, visit);
            chosen.pop();
        }
    }
    extend(0, count, size, &mut Vec::new(), visit);
}

/// The dimension of the span of the vectors.
pub(crate) fn rank(vectors: &[Row]) -> usize {
    eliminated(vectors.to_vec()).1.len()
}

/// The rows reduced by elimination, with the column of the leading one of each row that is not zero.
fn eliminated(mut rows: Vec<Row>) -> (Vec<Row>, Vec<usize>) {
    let mut pivots = Vec::new();
    for column in 0..rows.first().map_or(0, Vec::len) {
        let Some(found) = (pivots.len()..rows.len()).find(|&row| rows[row][column] != RBig::ZERO) else { continue };
        let rank = pivots.len();
        rows.swap(rank, found);
        let head = rows[rank][column].clone();
        rows[rank].iter_mut().for_each(|value| *value /= &head);
        let pivot_row = rows[rank].clone();
        for (_, row) in rows.iter_mut().enumerate().filter(|(index, _)| *index != rank) {
            let factor = row[column].clone();
            for (value, head) in row.iter_mut().zip(&pivot_row) {
                *value -= &factor * head;
            }
        }
        pivots.push(column);
    }
    (rows, pivots)
}

/// The vector orthogonal to all the rows, if it is unique up to a factor.
fn normal(rows: Vec<Row>, dimension: usize) -> Option<Row> {
    let (rows, pivots) = eliminated(rows);
    if pivots.len() + 1 != dimension {
        return None;
    }
    let free = (0..dimension).find(|column| !pivots.contains(column))?;
    let mut normal = vec![RBig::ZERO; dimension];
    normal[free] = RBig::ONE;
    for (row, &column) in rows.iter().zip(&pivots) {
        normal[column] = -&row[free];
    }
    let first = normal.iter().find(|c| **c != RBig::ZERO)?.clone();
    Some(normal.iter().map(|c| c / &first).collect())
}

/// The points that the paper keeps: for each normal the first one that is lowest and the first one that is highest.
pub(crate) fn extreme_points(points: &[Row], normals: &BTreeSet<Row>) -> Vec<usize> {
    let mut found = BTreeSet::new();
    for normal in normals {
        let heights: Vec<RBig> = points.iter().map(|p| dot(normal, p)).collect();
        let first = |wanted: Option<&RBig>| heights.iter().position(|height| Some(height) == wanted);
        found.extend(first(heights.iter().min()));
        found.extend(first(heights.iter().max()));
    }
    found.into_iter().collect()
}

/// The least Σ c_i over zonotopes along directions that span, by one inequality for each facet normal and side.
pub(crate) fn least_length(points: &[Row], directions: &[Row], dimension: usize) -> Option<RBig> {
    let normals = facet_normals(directions, dimension);
    let (count, sides) = (directions.len(), 2 * normals.len());
    let mut equations = Vec::with_capacity(sides);
    for (index, normal) in normals.iter().flat_map(|u| [u.clone(), u.iter().map(|c| -c).collect()]).enumerate() {
        let mut coefficients: Row = directions.iter().map(|v| absolute(dot(&normal, v))).collect();
        coefficients.extend(normal.iter().flat_map(|c| [c.clone(), -c]));
        coefficients.extend((0..sides).map(|side| if side == index { integer(-1) } else { RBig::ZERO }));
        let right = points.iter().map(|p| dot(&normal, p)).max()?;
        equations.push(Equation { coefficients, right });
    }
    let unknowns = count + 2 * dimension + sides;
    let costs: Vec<RBig> = (0..unknowns).map(|i| if i < count { RBig::ONE } else { RBig::ZERO }).collect();
    least(&costs, &equations)
}

/// The least Σ c_i by the program of Section 4.2 as it is printed, on the points given; `None` when it has no solution.
/// With b_ij = s_ij − c_i the bounds are 0 ≤ s_ij and s_ij + t_ij = 2 c_i, t_ij ≥ 0.
pub(crate) fn papers_program(points: &[Row], directions: &[Row], dimension: usize) -> Option<RBig> {
    let (count, number) = (directions.len(), points.len());
    let share = |i: usize, j: usize| count + 2 * dimension + 2 * (j * count + i);
    let unknowns = share(0, number);
    let mut equations = Vec::new();
    for (j, point) in points.iter().enumerate() {
        for c in 0..dimension {
            let mut coefficients = vec![RBig::ZERO; unknowns];
            coefficients[count + 2 * c] = RBig::ONE;
            coefficients[count + 2 * c + 1] = integer(-1);
            for (i, v) in directions.iter().enumerate() {
                coefficients[i] = -&v[c];
                coefficients[share(i, j)] = v[c].clone();
            }
            equations.push(Equation { coefficients, right: point[c].clone() });
        }
        for i in 0..count {
            let mut coefficients = vec![RBig::ZERO; unknowns];
            coefficients[i] = integer(-2);
            coefficients[share(i, j)] = RBig::ONE;
            coefficients[share(i, j) + 1] = RBig::ONE;
            equations.push(Equation { coefficients, right: RBig::ZERO });
        }
    }
    let costs: Vec<RBig> = (0..unknowns).map(|i| if i < count { RBig::ONE } else { RBig::ZERO }).collect();
    least(&costs, &equations)
}

/// Which point lies outside { center + Σ δ_i generators_i : |δ_i| <= 1 }, if any: no normal of the generators and the
/// axes separates the others. The axes decide when the generators do not span.
pub(crate) fn first_outside(center: &[RBig], generators: &[Row], points: &[Row]) -> Option<usize> {
    let dimension = center.len();
    let axes = (0..dimension).map(|a| (0..dimension).map(|c| integer(i64::from(a == c))).collect());
    let spanning: Vec<Row> = generators.iter().cloned().chain(axes).collect();
    let reaches: Vec<(Row, RBig)> = facet_normals(&spanning, dimension)
        .into_iter()
        .map(|u| {
            let reach = generators.iter().fold(RBig::ZERO, |sum, g| sum + absolute(dot(&u, g)));
            (u, reach)
        })
        .collect();
    points.iter().position(|point| {
        let offset: Row = point.iter().zip(center).map(|(p, c)| p - c).collect();
        reaches.iter().any(|(u, reach)| absolute(dot(u, &offset)) > *reach)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::definitions::ratio::fraction;

    #[test]
    fn the_two_programs_by_hand() {
        let triangle = rows(&[[0, 0], [2, 0], [0, 2]]);
        let directions = rows(&[[1, 0], [0, 1], [1, -1]]);
        assert_eq!(least_length(&triangle, &directions, 2), Some(integer(2)));
        assert_eq!(papers_program(&triangle, &directions, 2), Some(integer(2)));
        assert_eq!(papers_program(&triangle, &rows(&[[1, 0]]), 2), None);
        let segment = rows(&[[-1], [4]]);
        assert_eq!(least_length(&segment, &rows(&[[2], [1]]), 1), Some(fraction(5, 4)));
        assert_eq!(papers_program(&segment, &rows(&[[2], [1]]), 1), Some(fraction(5, 4)));
    }

    #[test]
    fn normals_are_orthogonal_and_each_is_there_once() {
        let axes = rows(&[[1, 0, 0], [0, 2, 0], [0, 0, 3], [5, 0, 0]]);
        let expected = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
        assert_eq!(facet_normals(&axes, 3), rows(&expected).into_iter().collect());
        assert_eq!(facet_normals(&rows(&[[3, 1]]), 2), [vec![integer(1), integer(-3)]].into_iter().collect());
    }

    #[test]
    fn a_point_beyond_a_facet_is_found() {
        let (center, generators) = (rows(&[[0, 0]]).remove(0), rows(&[[1, 0], [1, 1]]));
        assert_eq!(first_outside(&center, &generators, &rows(&[[2, 1], [0, 1], [-1, 1]])), Some(2));
        assert_eq!(first_outside(&center, &generators[..1], &rows(&[[1, 0], [0, 1]])), Some(1));
    }

    #[test]
    fn roots_are_above() {
        let root = root_above(&integer(2));
        assert!(&root * &root >= integer(2));
        assert!(&root * &root < integer(2) + fraction(1, 100_000_000_000_000));
        assert_eq!(root_above(&integer(9)), integer(3));
    }
}
