//! Sign vectors of the arrangement: on which side of each line a point lies, or all points of a small set.

use super::cells::Cell;
use super::descent::Near;
use super::input::LadProblem;
use super::optimum::LadOptimum;
use super::subproblem::{ExactLinear, Subdifferential, Subproblem, Vertex};
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::tolerance::{UNDERFLOW, UNIT};
use crate::tally::Tally;

impl LadProblem<'_> {
    /// The side of each line on which a point of the scaled frame lies, given in homogeneous coordinates with W > 0.
    /// O(n).
    pub(crate) fn signs_at(&self, point: &[Dyadic; 3], tally: &mut impl Tally) -> Vec<i8> {
        let mut around = Subdifferential::default();
        Subproblem::whole(self).read_at(&Vertex::at(point.clone()), &mut around, tally);
        around.signs
    }

    /// The lines that may pass between given points of the scaled frame, with W = 1, and the side of every other line
    /// on which all of the points lie; 0 for the lines that may pass. One pass, whatever the number of points.
    pub(crate) fn sides_around(&self, points: &[[Dyadic; 3]]) -> (Vec<u32>, Vec<i8>) {
        let center = [0, 1].map(|axis| points[0][axis].to_f64());
        let widest = |axis: usize| {
            let distance = |point: &[Dyadic; 3]| (&point[axis] - &Dyadic::from_f64(center[axis])).abs().to_f64();
            points.iter().map(distance).fold(UNDERFLOW, f64::max) * (1.0 + 8.0 * UNIT)
        };
        let split = Cell::upright(center, [widest(0), widest(1)]).split(&Subproblem::whole(self), &mut ());
        (split.crossing, split.signs)
    }
}

impl LadOptimum {
    /// The side of each line on which the minimiser lies.
    pub(crate) fn signs(&self) -> Vec<i8> {
        let mut signs = self.certificate.signs.clone();
        self.through.iter().for_each(|&line| signs[line as usize] = 0);
        signs
    }

    /// The side of each line on which a point of the scaled frame lies, given in homogeneous coordinates with W > 0. At
    /// the minimiser no line is read, near it only the lines that may pass between it and the point.
    pub(crate) fn signs_at(&self, problem: &LadProblem, point: &[Dyadic; 3]) -> Vec<i8> {
        if self.is_at(problem, point) {
            return self.signs();
        }
        self.signs_at_vertex(problem, &Vertex::at(point.clone()))
    }

    /// The side of each line on which a point of the scaled frame lies that is not the minimiser, given by pairs of
    /// doubles that are exact. Near the minimiser only the lines are read that may pass between it and the point.
    pub(crate) fn signs_beside(&self, problem: &LadProblem, place: [BoundedDoubleDouble; 2]) -> Vec<i8> {
        self.signs_at_vertex(problem, &Vertex::at_pairs(place))
    }

    fn signs_at_vertex(&self, problem: &LadProblem, vertex: &Vertex) -> Vec<i8> {
        let mut around = Subdifferential::default();
        let Some(Near { crossing, .. }) = self.near.as_ref().filter(|near| near.contains(vertex.point)) else {
            Subproblem::whole(problem).read_at(vertex, &mut around, &mut ());
            return around.signs;
        };
        let crossing_lines = Subproblem::whole(problem).selection(crossing, [0.0, 0.0], ExactLinear::zero());
        crossing_lines.read_at(vertex, &mut around, &mut ());
        let mut signs = self.certificate.signs.clone();
        for (&line, sign) in crossing.iter().zip(around.signs) {
            signs[line as usize] = sign;
        }
        signs
    }

    /// Whether a point of the scaled frame is the minimiser.
    pub(crate) fn is_at(&self, problem: &LadProblem, [x, y, w]: &[Dyadic; 3]) -> bool {
        let [own_x, own_y, own_w] = self.minimizer.homogeneous_point(|line| problem.exact.line(line.position()));
        &own_x * w == x * &own_w && &own_y * w == y * &own_w
    }
}
