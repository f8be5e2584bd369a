//! A direction within a part of the dual plane, by which the generators whose lines do not cross the part are signed.

use super::boundary::Boundary;
use crate::collision::prepared::by_cutting::filtered::Vector;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, exact};

/// What bounds a part of the plane: a wall on its left and on its right, a line below and above it.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Frame {
    left: Option<Boundary>,
    right: Option<Boundary>,
    bottom: Option<Boundary>,
    top: Option<Boundary>,
}

/// A coordinate as a quotient, the denominator positive.
type Quotient = [Dyadic; 2];

impl Frame {
    /// The frames of the parts before and beyond a boundary.
    pub(crate) fn cut(self, boundary: Boundary, generators: &[[f64; 3]]) -> [Self; 2] {
        let is_wall = match boundary {
            Boundary::Wall(_) => true,
            Boundary::Line(line) => generators[line as usize][1] == 0.0,
            Boundary::Horizon => false,
        };
        let own = Some(boundary);
        if is_wall {
            [Self { right: own, ..self }, Self { left: own, ..self }]
        } else {
            [Self { top: own, ..self }, Self { bottom: own, ..self }]
        }
    }

    /// A direction (x, y, 1), scaled, where (x, y) is in the interior of the part.
    pub(crate) fn inner_direction(&self, generators: &[[f64; 3]]) -> ExactVector {
        // a wall is the plane x n_x + n_z = 0
        let abscissa = |wall: Boundary| {
            let [x, _, z] = wall.normal(generators).exact();
            [-z, x]
        };
        let [x, w] = between(self.left.map(abscissa), self.right.map(abscissa));
        let height = |line: Boundary| {
            let [a, b, c] = line.normal(generators).exact();
            [-(a * x.clone() + c * w.clone()), b * w.clone()]
        };
        let [y, v] = between(self.bottom.map(height), self.top.map(height));
        [x * v.clone(), y * w.clone(), w * v]
    }
}

/// A number strictly between two, or beyond the only one.
fn between(low: Option<Quotient>, high: Option<Quotient>) -> Quotient {
    match (low, high) {
        (Some([a, b]), Some([c, d])) => [&a * &d + &c * &b, (b * d).scaled(1)],
        (Some([a, b]), None) => [&a + &b, b],
        (None, Some([c, d])) => [&c - &d, d],
        (None, None) => {
            let [zero, one] = exact([0.0, 1.0]);
            [zero, one]
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::exact_linear::dot;
    use std::cmp::Ordering;

    /// The square 1 < x < 3, 0 < y < 2, and what is left of it where walls and lines are missing.
    #[test]
    fn the_direction_is_on_the_right_side_of_each_boundary() {
        let generators = [[1.0, 0.0, -1.0], [-2.0, 0.0, 6.0], [0.0, -3.0, 0.0], [0.0, 1.0, -2.0], [1.0, 1.0, -1.0]];
        let sides = [Boundary::Line(0), Boundary::Line(1), Boundary::Line(2), Boundary::Line(3)];
        for present in 0..16 {
            let mut frame = Frame::default();
            let chosen: Vec<(usize, Boundary)> =
                sides.into_iter().enumerate().filter(|(side, _)| present >> side & 1 == 1).collect();
            for &(side, boundary) in &chosen {
                frame = frame.cut(boundary, &generators)[1 - side % 2];
            }
            let direction = frame.inner_direction(&generators);
            assert!(direction[2].sign().is_gt());
            for (side, boundary) in chosen {
                let is_beyond = dot(&boundary.normal(&generators).exact(), &direction).sign();
                assert_eq!(is_beyond, if side % 2 == 0 { Ordering::Greater } else { Ordering::Less }, "{present}");
            }
        }
        // right of the wall through (1, 0), where the line of the last generator meets y = 0
        let [left, right] = Frame::default().cut(Boundary::Wall([2, 4]), &generators);
        assert!(left.inner_direction(&generators)[0].sign().is_le());
        assert!(right.inner_direction(&generators)[0].sign().is_gt());
    }
}
