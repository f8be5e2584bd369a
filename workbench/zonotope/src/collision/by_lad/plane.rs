//! The plane { u : u · p = 1 } in coordinates, and the line that each generator v makes of v · u = 0 in it.
//!
//! Let k be the axis along which p is longest and i, j the others. With u_i = x and u_j = y the plane gives
//! u_k = (1 − x p_i − y p_j) / p_k, hence
//!
//! p_k (v · u) = (v_i p_k − v_k p_i) x + (v_j p_k − v_k p_j) y + v_k,
//!
//! a line whose coefficients are polynomials in the input: the data are not rotated. The objective of the kernel is
//! |p_k| h(u), and u · p = 1 is kept exactly.

use super::sums::signed_sum;
use crate::collision::Displacement;
use crate::lad::LadProblem;
use crate::lad::kernel_input::{Columns, ExactLine, ExactLines, LineError};
use crate::numeric::dyadic::{Dyadic, scale_by_power_of_two};
use crate::numeric::tolerance::UNIT;
use crate::numeric::vector::{ExactVector, exact, multiple, sum};

/// The coordinates of the plane for a displacement that is not zero.
#[derive(Debug, Clone)]
pub(super) struct Plane {
    /// The axes i, j, k.
    axes: [usize; 3],
    p: ExactVector,
}

/// The vectors of a kernel problem.
#[derive(Debug)]
pub(super) enum Vectors<'a> {
    /// The generators of a question.
    All(&'a Displacement<'a, 3>),
    /// Some generators, and last the sum of all others with their signs.
    Few(&'a [[f64; 3]], ExactVector),
}

/// Vectors as lines, normals and offsets each scaled by a power of two.
#[derive(Debug)]
struct GeneratorLines<'a> {
    plane: Plane,
    vectors: Vectors<'a>,
    normal_scale: i64,
    offset_scale: i64,
}

impl Vectors<'_> {
    fn len(&self) -> usize {
        match self {
            Self::All(question) => question.len(),
            Self::Few(vectors, _) => vectors.len() + 1,
        }
    }

    fn get(&self, position: usize) -> ExactVector {
        match self {
            Self::All(question) => exact(question.generator(position)),
            Self::Few(vectors, last) => vectors.get(position).map_or_else(|| last.clone(), |v| exact(*v)),
        }
    }

    fn signed_sum(&self, terms: &mut dyn Iterator<Item = (usize, i8)>) -> ExactVector {
        match self {
            Self::All(question) => signed_sum(terms.map(|(position, sign)| (question.generator(position), sign))),
            Self::Few(vectors, last) => {
                let mut last_sign = 0;
                let few = terms.filter_map(|(position, sign)| {
                    let vector = vectors.get(position);
                    last_sign += if vector.is_none() { sign } else { 0 };
                    vector.map(|v| (*v, sign))
                });
                let few = signed_sum(few);
                sum(&few, &multiple(&Dyadic::from_f64(f64::from(last_sign)), last))
            }
        }
    }
}

/// A kernel problem, and how its points are scaled.
pub(super) struct PlaneProblem<'a> {
    pub(super) problem: LadProblem<'a>,
    plane: Plane,
    point_scale: i64,
}

impl Plane {
    pub(super) fn new(p: ExactVector) -> Self {
        let longest = (0..3).max_by_key(|&axis| p[axis].clone().abs()).expect("there are three axes");
        let axes = [(longest + 1) % 3, (longest + 2) % 3, longest];
        Self { axes, p }
    }

    fn line(&self, v: &ExactVector) -> ExactLine {
        let [i, j, k] = self.axes;
        let p = &self.p;
        let across = |axis: usize| &v[axis] * &p[k] - &v[k] * &p[axis];
        ExactLine { normal: [across(i), across(j)], offset: v[k].clone() }
    }

    /// Whether p_k is negative: then a generator's line is positive where v · u is negative.
    fn is_reversed(&self) -> bool {
        self.p[self.axes[2]].sign().is_lt()
    }

    /// A positive multiple of the u with coordinates (x / w, y / w).
    fn direction(&self, [x, y, w]: [Dyadic; 3]) -> ExactVector {
        let [i, j, k] = self.axes;
        let p = &self.p;
        let last = &w - &(&x * &p[i]) - &y * &p[j];
        let (first, second) = (&x * &p[k], &y * &p[k]);
        let mut u = [Dyadic::zero(), Dyadic::zero(), Dyadic::zero()];
        (u[i], u[j], u[k]) = (first, second, last);
        if self.is_reversed() { u.map(|v| -v) } else { u }
    }
}

impl<'a> PlaneProblem<'a> {
    /// The kernel problem of some vectors and a displacement p that is not zero. O(n) exact operations.
    pub(super) fn new(vectors: Vectors<'a>, p: ExactVector) -> Self {
        let plane = Plane::new(p);
        let leading = |position: usize| {
            let ExactLine { normal: [x, y], offset } = plane.line(&vectors.get(position));
            [x, y, offset].map(|value| value.leading())
        };
        let lines: Vec<[(f64, i64); 3]> = (0..vectors.len()).map(leading).collect();
        let exponent = |(head, exponent): &(f64, i64)| (*head != 0.0).then_some(exponent + 63);
        let largest = |columns: &[usize]| {
            let values = lines.iter().flat_map(|line| columns.iter().filter_map(|&c| exponent(&line[c])));
            values.max().unwrap_or(0)
        };
        let (normal_scale, offset_scale) = (largest(&[0, 1]), largest(&[2]));
        let mut columns = Columns::with_capacity(lines.len());
        for line in &lines {
            let scaled = |c: usize, scale: i64| scale_by_power_of_two(line[c].0, line[c].1 - scale);
            columns.push([scaled(0, normal_scale), scaled(1, normal_scale), scaled(2, offset_scale)]);
        }
        let exact = GeneratorLines { plane: plane.clone(), vectors, normal_scale, offset_scale };
        let error = LineError { offset_relative: 2.0 * UNIT, offset_per_normal: 0.0 };
        let problem = LadProblem::from_exact_lines(columns, error, Box::new(exact));
        Self { problem, plane, point_scale: offset_scale - normal_scale }
    }

    /// A positive multiple of the direction u of a point of the problem in homogeneous coordinates, W > 0.
    pub(super) fn direction(&self, [x, y, w]: [Dyadic; 3]) -> ExactVector {
        self.plane.direction([x.scaled(self.point_scale), y.scaled(self.point_scale), w])
    }
}

impl PlaneProblem<'_> {
    /// The signs of v · u for signs of lines.
    pub(super) fn signs(&self, lines: &[i8]) -> Vec<i8> {
        let factor = if self.plane.is_reversed() { -1 } else { 1 };
        lines.iter().map(|sign| factor * sign).collect()
    }
}

impl ExactLines for GeneratorLines<'_> {
    fn line(&self, position: usize) -> ExactLine {
        let ExactLine { normal, offset } = self.plane.line(&self.vectors.get(position));
        ExactLine { normal: normal.map(|v| v.scaled(-self.normal_scale)), offset: offset.scaled(-self.offset_scale) }
    }

    /// By linearity in the generator: one line, that of the exact sum.
    fn signed_normal_sum(&self, terms: &mut dyn Iterator<Item = (usize, i8)>) -> [Dyadic; 2] {
        let sum = self.vectors.signed_sum(terms);
        let [i, j, k] = self.plane.axes;
        let p = &self.plane.p;
        let across = |axis: usize| (&sum[axis] * &p[k] - &sum[k] * &p[axis]).scaled(-self.normal_scale);
        [across(i), across(j)]
    }
}
