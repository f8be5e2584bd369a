//! Generators of any origin, turned until their lines can be drawn with all separators: no line upright, no two
//! crossings on one vertical line.

use thiserror::Error;
use zonotope::arrangement::slope_selection::{ArrangementVertex, Method};
use zonotope::arrangement::{ArrangementError, LineArrangement, LineIndex};

use super::DualPair;

/// The cosines and sines of the turns that are tried one after the other, of no, a small, and other angles.
const TURNS: [[f64; 2]; 5] = [[1.0, 0.0], [0.936, 0.352], [0.96, -0.28], [0.8, 0.6], [0.28, 0.96]];

/// The separators at the ends stand beside all crossings by this part of the distance between the outermost ones.
const MARGIN: f64 = 0.08;

/// Crossings nearer to one vertical line than this part of the distance between the outermost ones are not told apart,
/// nor are lines this steep drawn.
const LEAST_DISTANCE: f64 = 1e-6;

/// Why generators have no picture of their lines and tiles.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum PositionError {
    /// A coordinate cannot be a coefficient of a line.
    #[error(transparent)]
    Arrangement(#[from] ArrangementError),
    /// No two lines cross, so that there are no tiles.
    #[error("no two generators have lines that cross: there are no tiles")]
    NoCrossing,
    /// Three lines meet in one point, so that a tile has more than four sides.
    #[error(
        "the lines of generators {}, {} and {} meet in one point: their tile is no parallelogram",
        .0[0], .0[1], .0[2]
    )]
    Concurrent([usize; 3]),
    /// However the generators are turned, two crossings are too near to one vertical line.
    #[error("two crossings of lines are too near to each other to be drawn apart")]
    TooNear,
}

/// Generators in general position.
#[derive(Debug)]
pub(crate) struct Placed {
    /// The lines and tiles of those that have a line, in the order of the input.
    pub(crate) pair: DualPair,
    /// Those that point straight up, which have neither.
    pub(crate) upright: Vec<[f64; 3]>,
    /// The cosine and sine of the angle by which all are turned about the vertical axis.
    pub(crate) turn: [f64; 2],
}

impl Placed {
    /// Whether the generators had to be turned.
    pub(crate) fn is_turned(&self) -> bool {
        self.turn != TURNS[0]
    }

    /// A vector after the turn.
    pub(crate) fn turned(&self, v: [f64; 3]) -> [f64; 3] {
        turned(v, self.turn)
    }
}

/// Places generators that have some numbers in a file, from 1.
pub(crate) fn in_general_position(generators: &[[f64; 3]]) -> Result<Placed, PositionError> {
    let has_line = |[a, b, _]: &[f64; 3]| *a != 0.0 || *b != 0.0;
    let upright = generators.iter().copied().filter(|g| !has_line(g)).collect();
    let numbered: Vec<(usize, [f64; 3])> = (1..).zip(generators.iter().copied()).filter(|(_, g)| has_line(g)).collect();
    let slanted: Vec<[f64; 3]> = numbered.iter().map(|(_, generator)| *generator).collect();
    let arrangement = LineArrangement::from_rows(&slanted)?;
    let vertices = Method::BruteForce.all_vertices(&arrangement, 0);
    if vertices.is_empty() {
        return Err(PositionError::NoCrossing);
    }
    if let Some(lines) = vertices.iter().find_map(|vertex| third_line(&arrangement, vertex, slanted.len())) {
        return Err(PositionError::Concurrent(lines.map(|line| numbered[line].0)));
    }
    let mut pairs = TURNS.iter().map(|turn| {
        let generators: Vec<[f64; 3]> = slanted.iter().map(|g| upwards(turned(*g, *turn))).collect();
        (*turn, DualPair::new(&generators))
    });
    let (turn, pair) = pairs.find(|(_, pair)| is_general(pair)).ok_or(PositionError::TooNear)?;
    Ok(Placed { pair: pair.with_margin(MARGIN), upright, turn })
}

/// The lines of a vertex with a third line through it.
fn third_line(arrangement: &LineArrangement<'_>, vertex: &ArrangementVertex, count: usize) -> Option<[usize; 3]> {
    let [first, second] = vertex.lines.map(|line| line.position());
    let place = arrangement.exact_line(vertex.lines[0]).meet(&arrangement.exact_line(vertex.lines[1]));
    let is_through = |line: usize| arrangement.exact_line(LineIndex(line as u32)).evaluate(&place).is_zero();
    let third = (0..count).find(|&line| line != first && line != second && is_through(line));
    third.map(|third| {
        let mut lines = [first, second, third];
        lines.sort_unstable();
        lines
    })
}

fn turned([a, b, c]: [f64; 3], [cosine, sine]: [f64; 2]) -> [f64; 3] {
    [cosine * a - sine * b, sine * a + cosine * b, c]
}

/// The generator or its opposite, whichever has the positive second coordinate.
fn upwards(generator: [f64; 3]) -> [f64; 3] {
    if generator[1] < 0.0 { generator.map(|c| -c) } else { generator }
}

/// Whether no line is upright, and crossings have abscissas that can be told apart on a page.
fn is_general(pair: &DualPair) -> bool {
    let is_steep = |&[a, b, _]: &[f64; 3]| b <= LEAST_DISTANCE * a.abs();
    let x: Vec<f64> = pair.crossings.iter().map(|crossing| crossing.place[0]).collect();
    let (Some(first), Some(last)) = (x.first(), x.last()) else { return false };
    let spread = last - first;
    let is_apart = |pair: &[f64]| pair[1] - pair[0] > LEAST_DISTANCE * spread;
    !pair.generators.iter().any(is_steep) && spread.is_finite() && x.windows(2).all(is_apart)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_axes_are_turned_and_the_upright_one_has_no_line() {
        let axes = [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]];
        let placed = in_general_position(&axes).expect("two lines that cross");
        assert!(placed.is_turned());
        assert_eq!(placed.upright, [[0.0, 0.0, 1.0]]);
        assert_eq!((placed.pair.generators.len(), placed.pair.crossings.len()), (2, 1));
    }

    #[test]
    fn generators_in_general_position_stay_as_they_are() {
        let generators = [[7.0, 2.0, 12.0], [4.0, 6.0, 5.0], [3.0, -8.0, 0.0], [-8.0, 5.0, 2.0]];
        let placed = in_general_position(&generators).expect("as in the first figure");
        assert!(!placed.is_turned());
        assert_eq!((placed.pair.generators[2], placed.pair.crossings.len()), ([-3.0, 8.0, -0.0], 6));
    }

    #[test]
    fn lines_through_one_point_and_parallel_lines_are_refused() {
        let star = [[0.0, 0.0, 5.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]];
        assert_eq!(in_general_position(&star).map(|_| ()), Err(PositionError::Concurrent([2, 3, 4])));
        let parallel = [[1.0, 2.0, 0.0], [2.0, 4.0, 3.0]];
        assert_eq!(in_general_position(&parallel).map(|_| ()), Err(PositionError::NoCrossing));
    }
}
