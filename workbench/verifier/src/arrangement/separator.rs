//! Answers to "which chain from the top to the bottom vertex of Q has k tiles on its left".
//!
//! Q is the zonogon of the projections (a, b) of generators (a, b, c), and a chain steps down by twice each of them,
//! turned to point up (level ones to the left). Its order is the order, from the top, in which a vertical line at some
//! x that leans a little to the left meets the lines a x + b y + c = 0, vertical ones left of it first and those right
//! of it last. Two lines that have changed their order since x = −∞ are a tile on the left. So the pairs that have
//! changed must be k; and of the pairs that are neighbours in the chain, those that have changed must cross before the
//! others do: at a smaller x, or the same x but further down.

use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::fmt::{self, Display};

use crate::verdict::Verdict;

use dashu_int::IBig;

use crate::exact::fraction::Fraction;
use crate::exact::grid::{Grid, check_finite};
use crate::exact::inversions::sort_counting;
use crate::exact::linear::Vector;

/// Checks the points of a chain.
pub fn check_separator(generators: &[Vec<f64>], k: u64, chain: &[[Fraction; 2]]) -> Verdict<SeparatorProof> {
    ordered(generators, k, chain).map(|()| SeparatorProof { left: k }).into()
}

/// The number of tiles that lie on the left of the chain.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SeparatorProof {
    /// The number of tiles.
    pub left: u64,
}

impl Display for SeparatorProof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a chain of the tiling with {} tiles on its left", self.left)
    }
}

fn ordered(generators: &[Vec<f64>], k: u64, chain: &[[Fraction; 2]]) -> Result<(), String> {
    if generators.iter().any(|generator| generator.len() != 3) {
        return Err("answered a question whose generators are not in space".to_owned());
    }
    check_finite("the question", generators.iter().flatten())?;
    let grid = Grid::of(generators.iter().flatten().copied());
    let placed = generators.iter().map(|generator| generator.iter().map(|&x| grid.units(x)).collect::<Vector>());
    let mut lines: Vec<Vector> = placed.filter_map(upward).collect();
    lines.sort_by(from_the_top);
    let mut classes = vec![0; lines.len()];
    for index in 1..lines.len() {
        classes[index] = classes[index - 1] + usize::from(turn(&lines[index - 1], &lines[index]) != IBig::ZERO);
    }

    let points: Option<Vec<[IBig; 2]>> =
        chain.iter().map(|[x, y]| Some([on_grid(x, grid)?, on_grid(y, grid)?])).collect();
    let order = steps(&lines, &points.ok_or("a point of the chain is no sum of generators")?)?;
    let mut sorted: Vec<usize> = order.iter().map(|&line| classes[line]).collect();
    let changed = sort_counting(&mut sorted, &usize::cmp);
    if changed != k {
        return Err(format!("the chain has {changed} tiles on its left, not {k}"));
    }

    let (mut last_changed, mut first_kept): (Option<Crossing>, Option<Crossing>) = (None, None);
    for pair in order.windows(2) {
        let (i, j) = (pair[0], pair[1]);
        let Some(crossing) = Crossing::of(&lines[i], &lines[j]) else {
            if i > j && from_the_top(&lines[i], &lines[j]) != Ordering::Equal {
                return Err("the chain takes parallel steps in the wrong order".to_owned());
            }
            continue;
        };
        if i > j {
            last_changed = Some(last_changed.map_or(crossing.clone(), |last| last.max(crossing)));
        } else {
            first_kept = Some(first_kept.map_or(crossing.clone(), |first| first.min(crossing)));
        }
    }
    match (last_changed, first_kept) {
        (Some(last), Some(first)) if last >= first => {
            Err("the chain is no order of the lines: a tile on its right lies further left than one on its left"
                .to_owned())
        }
        _ => Ok(()),
    }
}

/// The line with its generator turned to point up, or to the left if it is level; `None` if its projection is zero.
pub(super) fn upward(line: Vector) -> Option<Vector> {
    let up = line[1].cmp(&IBig::ZERO).then_with(|| IBig::ZERO.cmp(&line[0]));
    match up {
        Ordering::Greater => Some(line),
        Ordering::Less => Some(line.into_iter().map(|component| -component).collect()),
        Ordering::Equal => None,
    }
}

fn turn(i: &Vector, j: &Vector) -> IBig {
    &i[0] * &j[1] - &i[1] * &j[0]
}

/// The order of lines from the top, far to the left: the largest a / b first, vertical lines last; parallel lines from
/// the top, vertical ones from the left, since a line that leans to the left meets those on the left further up.
fn from_the_top(i: &Vector, j: &Vector) -> Ordering {
    IBig::ZERO.cmp(&turn(i, j)).then_with(|| {
        let size = |line: &Vector| if line[1] == IBig::ZERO { -&line[0] } else { line[1].clone() };
        (&i[2] * size(j)).cmp(&(&j[2] * size(i)))
    })
}

/// A coordinate in units of the grid, if it is a whole number of them.
pub(super) fn on_grid(fraction: &Fraction, grid: Grid) -> Option<IBig> {
    let (numerator, denominator) = (fraction.numerator(), fraction.denominator());
    let shift = grid.exponent().unsigned_abs() as usize;
    let (numerator, denominator) = if grid.exponent() < 0 {
        (numerator << shift, denominator.clone())
    } else {
        (numerator.clone(), denominator << shift)
    };
    let units = &numerator / &denominator;
    (&units * &denominator == numerator).then_some(units)
}

/// The lines whose generators the chain steps down, in its order.
fn steps(lines: &[Vector], points: &[[IBig; 2]]) -> Result<Vec<usize>, String> {
    if points.len() != lines.len() + 1 {
        return Err(format!("the chain has {} points for {} steps", points.len(), lines.len()));
    }
    let top = |axis: usize| lines.iter().map(|line| &line[axis]).sum::<IBig>();
    if points[0] != [top(0), top(1)] {
        return Err("the chain does not start at the top vertex".to_owned());
    }
    // Lines with equal steps are parallel, so they are taken in their order.
    let mut waiting: BTreeMap<[IBig; 2], Vec<usize>> = BTreeMap::new();
    for (index, line) in lines.iter().enumerate().rev() {
        waiting.entry([&line[0] * 2, &line[1] * 2]).or_default().push(index);
    }
    let taken = |(number, pair): (usize, &[[IBig; 2]])| {
        let step = [0, 1].map(|axis: usize| &pair[0][axis] - &pair[1][axis]);
        let line = waiting.get_mut(&step).and_then(Vec::pop);
        line.ok_or_else(|| format!("step {} of the chain is no generator that is left", number + 1))
    };
    points.windows(2).enumerate().map(taken).collect()
}

/// The common point of two lines, ordered by abscissa, then height.
#[derive(Debug, Clone)]
pub(super) struct Crossing {
    x: IBig,
    y: IBig,
    /// The positive denominator of both.
    w: IBig,
}

impl Crossing {
    /// A point as a crossing.
    pub(super) fn at([x, y]: &[Fraction; 2]) -> Self {
        let (v, w) = (x.denominator(), y.denominator());
        Self { x: x.numerator() * w, y: y.numerator() * v, w: v * w }
    }

    /// Whether the lines cross in the point.
    pub(super) fn is_at(&self, point: &[Fraction; 2]) -> bool {
        *self == Self::at(point)
    }

    /// Abscissa and height over the positive third coordinate.
    pub(super) fn homogeneous(&self) -> [&IBig; 3] {
        [&self.x, &self.y, &self.w]
    }

    /// The common point of two lines, unless they are parallel.
    pub(super) fn of(i: &Vector, j: &Vector) -> Option<Self> {
        let w = turn(i, j);
        let [x, y] = [&i[1] * &j[2] - &j[1] * &i[2], &i[2] * &j[0] - &j[2] * &i[0]];
        match w.cmp(&IBig::ZERO) {
            Ordering::Equal => None,
            Ordering::Greater => Some(Self { x, y, w }),
            Ordering::Less => Some(Self { x: -x, y: -y, w: -w }),
        }
    }
}

impl Ord for Crossing {
    fn cmp(&self, other: &Self) -> Ordering {
        let compare = |a: &IBig, b: &IBig| (a * &other.w).cmp(&(b * &self.w));
        compare(&self.x, &other.x).then_with(|| compare(&self.y, &other.y))
    }
}

impl PartialOrd for Crossing {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Crossing {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Crossing {}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(generators: &[[f64; 3]], k: u64, chain: &[[i64; 2]]) -> Result<(), String> {
        let generators: Vec<Vec<f64>> = generators.iter().map(|generator| generator.to_vec()).collect();
        let chain: Vec<[Fraction; 2]> =
            chain.iter().map(|point| point.map(|x| Fraction::new(x, 1).expect("one is not zero"))).collect();
        check_separator(&generators, k, &chain).proof().map(|_| ())
    }

    #[test]
    fn the_sides_of_a_square() {
        let generators = [[1.0, 1.0, 0.0], [1.0, -1.0, 0.0], [0.0, 0.0, 3.0]];
        assert_eq!(check(&generators, 0, &[[0, 2], [-2, 0], [0, -2]]), Ok(()));
        assert_eq!(check(&generators, 1, &[[0, 2], [2, 0], [0, -2]]), Ok(()));
        assert!(check(&generators, 1, &[[0, 2], [-2, 0], [0, -2]]).is_err());
        assert!(check(&generators, 0, &[[0, 2], [-2, 0]]).is_err());
        assert!(check(&generators, 0, &[[0, 2], [-2, 0], [0, 2]]).is_err());
        assert!(check(&generators, 0, &[[1, 3], [-1, 1], [1, -1]]).is_err());
    }

    #[test]
    fn a_hexagon_has_one_tiling() {
        // The lines x + y = 0, y + 1 = 0, −x + y = 0 cross at x = −1, 0, 1 … the middle one below the others' crossing.
        let generators = [[1.0, 1.0, 0.0], [0.0, 1.0, 1.0], [-1.0, 1.0, 0.0]];
        let chains = [
            [[0, 3], [-2, 1], [-2, -1], [0, -3]],
            [[0, 3], [-2, 1], [0, -1], [0, -3]],
            [[0, 3], [2, 1], [0, -1], [0, -3]],
            [[0, 3], [2, 1], [2, -1], [0, -3]],
        ];
        for (k, chain) in (0..).zip(&chains) {
            assert_eq!(check(&generators, k, chain), Ok(()), "{k}");
        }
        let other_tiling = [[0, 3], [0, 1], [-2, -1], [0, -3]];
        assert!(check(&generators, 1, &other_tiling).is_err());
    }

    /// The lines m (x + y) + c = 0, and the level generators' lines x = c / m, are met from the smallest c / m on.
    #[test]
    fn of_parallel_steps_that_along_the_upper_or_left_line_comes_first() {
        let sizes_and_heights = || (1..=3_i64).flat_map(|m| (-3..=3_i64).map(move |c| (m, c)));
        let pairs = sizes_and_heights().flat_map(|first| sizes_and_heights().map(move |second| (first, second)));
        for ((first, c), (second, d)) in pairs {
            for [a, b] in [[1, 1], [-1, 0]] {
                let generators = [(first, c), (second, d)].map(|(m, c)| [m * a, m * b, c].map(|x| x as f64));
                let at = |height: i64| [height * a, height * b];
                let chain = [at(first + second), at(second - first), at(-first - second)];
                // Steps of one length tell nothing of their lines.
                let is_right = first == second || c * second <= d * first;
                assert_eq!(check(&generators, 0, &chain).is_ok(), is_right, "{generators:?} {chain:?}");
            }
        }
    }

    #[test]
    fn lines_through_one_point_change_their_order_all_at_once() {
        // The lines x + y = 0, y = 0 and −x + y = 0 meet at the origin.
        let generators = [[1.0, 1.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 1.0, 0.0]];
        assert_eq!(check(&generators, 0, &[[0, 3], [-2, 1], [-2, -1], [0, -3]]), Ok(()));
        assert_eq!(check(&generators, 3, &[[0, 3], [2, 1], [2, -1], [0, -3]]), Ok(()));
        let between = [
            (1, [[0, 3], [0, 1], [-2, -1], [0, -3]]),
            (1, [[0, 3], [-2, 1], [0, -1], [0, -3]]),
            (2, [[0, 3], [0, 1], [2, -1], [0, -3]]),
            (2, [[0, 3], [2, 1], [0, -1], [0, -3]]),
        ];
        for (k, chain) in &between {
            assert!(check(&generators, *k, chain).expect_err("half a change").contains("no order of the lines"));
        }
    }
}
