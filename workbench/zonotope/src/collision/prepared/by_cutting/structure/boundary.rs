//! Boundaries of the cutting as planes of directions: the horizon, lines of generators, walls.
//!
//! A point (x, y) of the dual plane is the direction (x, y, 1), so a line of it is a plane through the origin of the
//! space of directions. The directions beyond a boundary are those with u · n > 0, n its normal.

use std::cmp::Ordering;

use crate::arrangement::cutting::{self, Wall};
use crate::collision::prepared::by_cutting::filtered::Vector;
use crate::numeric::double_double::Precision;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::ExactVector;
use crate::numeric::linear::cross;

/// A plane of directions.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Boundary {
    /// The level directions; beyond it are those that point up.
    Horizon,
    /// The line of a generator; beyond it is what is above the line, or right of it if it is vertical.
    Line(u32),
    /// The wall through the vertex in which the lines of two generators cross; beyond it is what is right of it.
    Wall([u32; 2]),
}

impl Boundary {
    /// The boundary along which a cutting was cut.
    pub(crate) fn of_cut(boundary: cutting::Boundary) -> Self {
        match boundary {
            cutting::Boundary::Line(line) | cutting::Boundary::Wall(Wall::Along(line)) => Self::Line(line.0),
            cutting::Boundary::Wall(Wall::Through(pair)) => Self::Wall(pair.map(|line| line.0)),
        }
    }

    /// The normal.
    pub(crate) fn normal(self, generators: &[[f64; 3]]) -> Normal {
        let generator = |line: u32| generators[line as usize];
        match self {
            Self::Horizon => Normal::Doubles([0.0, 0.0, 1.0]),
            Self::Line(line) => {
                let v = generator(line);
                let points_up = v[1] > 0.0 || (v[1] == 0.0 && v[0] > 0.0);
                Normal::Doubles(if points_up { v } else { v.map(|c| -c) })
            }
            Self::Wall(pair) => Normal::OfWall(pair.map(generator)),
        }
    }

    /// A direction off the plane's normal that tells the two halves of the plane: of all boundaries but the horizon
    /// upward directions are the one half.
    pub(crate) fn reference(self) -> [f64; 3] {
        match self {
            Self::Horizon => [0.0, 1.0, 0.0],
            _ => [0.0, 0.0, 1.0],
        }
    }
}

/// The normal of a boundary.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Normal {
    /// That of a line, or of the horizon.
    Doubles([f64; 3]),
    /// That of the wall through the vertex of two generators v and v': the wall holds the directions v × v' and
    /// (0, 1, 0), and their cross product is turned to the right.
    OfWall([[f64; 3]; 2]),
}

impl Vector for Normal {
    fn over<N: Precision>(&self) -> [N; 3] {
        match self {
            Self::Doubles(v) => v.over(),
            Self::OfWall(pair) => {
                let [x, _, z] = cross(&pair[0].over::<N>(), &pair[1].over());
                match z.certain_sign() {
                    Some(Ordering::Less) => [N::ZERO.minus(&z), N::ZERO, x],
                    Some(_) => [z, N::ZERO, N::ZERO.minus(&x)],
                    None => self.exact().over(),
                }
            }
        }
    }

    /// Of a wall, scaled to about 1.
    fn exact(&self) -> ExactVector {
        let normal: ExactVector = self.over();
        match self {
            Self::Doubles(_) => normal,
            Self::OfWall(_) => {
                let exponent = normal.iter().filter_map(Dyadic::binary_exponent).max().unwrap_or(0);
                normal.map(|c| c.scaled(-exponent))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::exact_linear::{dot, exact};

    /// The lines x = 2, y = x and y = 3 − 2 x, the latter two meeting over x = 1.
    #[test]
    fn what_is_beyond_a_boundary_is_right_of_it_or_above() {
        let generators = [[-1.0, 0.0, 2.0], [3.0, -3.0, 0.0], [2.0, 1.0, -3.0]];
        let side = |boundary: Boundary, [x, y]: [f64; 2]| {
            dot(&boundary.normal(&generators).exact(), &exact([x, y, 1.0])).sign() as i8
        };
        let sides = |boundary, points: [[f64; 2]; 3]| points.map(|point| side(boundary, point));
        assert_eq!(sides(Boundary::Line(0), [[1.0, 9.0], [2.0, 7.0], [3.0, -9.0]]), [-1, 0, 1]);
        assert_eq!(sides(Boundary::Line(1), [[5.0, 4.0], [5.0, 5.0], [5.0, 6.0]]), [-1, 0, 1]);
        assert_eq!(sides(Boundary::Wall([1, 2]), [[0.5, 9.0], [1.0, 7.0], [1.5, -9.0]]), [-1, 0, 1]);
        assert_eq!(sides(Boundary::Wall([2, 1]), [[0.5, 9.0], [1.0, 7.0], [1.5, -9.0]]), [-1, 0, 1]);
        assert_eq!(sides(Boundary::Horizon, [[0.5, 9.0], [1.0, 7.0], [1.5, -9.0]]), [1, 1, 1]);
    }
}
