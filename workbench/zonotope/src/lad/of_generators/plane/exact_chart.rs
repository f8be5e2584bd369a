//! The plane { u : u · p = c · p } in coordinates, and the line that each generator v makes of v · u = 0 in it.
//!
//! Let c be any vector with c · p > 0, k the axis along which p is longest and i, j the others. With e_1 = p_k î −
//! p_i k̂ and e_2 = p_k ĵ − p_j k̂, both orthogonal to p, the plane is u = c + x e_1 + y e_2, hence
//!
//! v · u = (v_i p_k − v_k p_i) x + (v_j p_k − v_k p_j) y + v · c,
//!
//! a line whose coefficients are polynomials in the input and c: the data are not rotated, and the plane is kept
//! exactly. The objective in this chart is h(u). Each coefficient is rounded once. So where c is near the optimum,
//! lines that nearly meet there have small offsets that are known to all their digits: doubles tell apart what in
//! other coordinates differs by less than a rounding.

use crate::lad::LadProblem;
use crate::lad::kernel_input::{Columns, ExactLine, ExactLines, LineError};
use crate::lad::of_generators::seam::direction_signs::DirectionSigns;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, dot, exact, multiple};
use crate::numeric::scaling::scale_by_power_of_two;
use crate::numeric::tolerance::UNIT;

/// The coordinates of the plane for a displacement that is not zero.
#[derive(Debug, Clone)]
pub(crate) struct ExactChart {
    /// The axes i, j, k.
    axes: [usize; 3],
    p: ExactVector,
    center: ExactVector,
}

/// The generators of a kernel problem: all of a query, or some.
#[derive(Debug)]
pub(crate) struct Vectors<'a> {
    query: &'a dyn KernelQuery,
    /// The indices of the generators of the problem; `None` for all.
    chosen: Option<Vec<usize>>,
}

/// Generators as lines, whose normals are scaled by one power of two and whose offsets by another.
#[derive(Debug)]
struct GeneratorLines<'a> {
    plane: ExactChart,
    vectors: Vectors<'a>,
    normal_scale: i64,
    offset_scale: i64,
}

impl<'a> Vectors<'a> {
    pub(crate) fn all(query: &'a dyn KernelQuery) -> Self {
        Self { query, chosen: None }
    }

    pub(crate) fn some(query: &'a dyn KernelQuery, chosen: Vec<usize>) -> Self {
        Self { query, chosen: Some(chosen) }
    }

    fn len(&self) -> usize {
        self.chosen.as_ref().map_or_else(|| self.query.len(), Vec::len)
    }

    fn index(&self, position: usize) -> usize {
        self.chosen.as_ref().map_or(position, |chosen| chosen[position])
    }

    fn get(&self, position: usize) -> ExactVector {
        self.query.exact_generator(self.index(position))
    }
}

/// A kernel problem, and how its points are scaled.
pub(crate) struct ChartProblem<'a> {
    pub(crate) problem: LadProblem<'a>,
    plane: ExactChart,
    point_scale: i64,
}

impl ExactChart {
    /// The coordinates around a centre; around an axis where no centre is given, or where it is not on the side of p.
    pub(crate) fn new(p: ExactVector, center: Option<[f64; 3]>) -> Self {
        let longest = (0..3).max_by_key(|&axis| p[axis].clone().abs()).expect("there are three axes");
        let axes = [(longest + 1) % 3, (longest + 2) % 3, longest];
        let near = center.filter(|c| c.iter().all(|c| c.is_finite())).map(exact).filter(|c| dot(c, &p).sign().is_gt());
        let center = near.unwrap_or_else(|| {
            let side = f64::from(p[longest].sign() as i8);
            exact([0, 1, 2].map(|axis| if axis == longest { side } else { 0.0 }))
        });
        Self { axes, p, center }
    }

    fn normal(&self, v: &ExactVector) -> [Dyadic; 2] {
        let [i, j, k] = self.axes;
        [i, j].map(|axis| &v[axis] * &self.p[k] - &v[k] * &self.p[axis])
    }

    fn line(&self, v: &ExactVector) -> ExactLine {
        ExactLine { normal: self.normal(v), offset: dot(v, &self.center) }
    }

    /// A positive multiple of the u with coordinates (x / w, y / w).
    fn direction(&self, [x, y, w]: [Dyadic; 3]) -> ExactVector {
        let [i, j, k] = self.axes;
        let p = &self.p;
        let mut u = multiple(&w, &self.center);
        u[i] = &u[i] + &(&x * &p[k]);
        u[j] = &u[j] + &(&y * &p[k]);
        u[k] = &u[k] - &(&x * &p[i] + &y * &p[j]);
        u
    }
}

impl<'a> ChartProblem<'a> {
    /// The problem in the plane of some generators and the sum of all others with their signs. O(n) exact operations.
    pub(crate) fn new(vectors: Vectors<'a>, others: &ExactVector, plane: ExactChart) -> Self {
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
        let linear = plane.normal(others).map(|v| v.scaled(-normal_scale));
        let exact = GeneratorLines { plane: plane.clone(), vectors, normal_scale, offset_scale };
        let error = LineError { offset_relative: 2.0 * UNIT, offset_per_normal: 0.0 };
        let problem = LadProblem::from_exact_lines(columns, error, linear, Box::new(exact));
        Self { problem, plane, point_scale: offset_scale - normal_scale }
    }

    /// A positive multiple of the direction u of a point of the problem in homogeneous coordinates, W > 0.
    pub(crate) fn direction(&self, [x, y, w]: [Dyadic; 3]) -> ExactVector {
        self.plane.direction([x.scaled(self.point_scale), y.scaled(self.point_scale), w])
    }
}

impl ExactLines for GeneratorLines<'_> {
    fn line(&self, position: usize) -> ExactLine {
        let ExactLine { normal, offset } = self.plane.line(&self.vectors.get(position));
        ExactLine { normal: normal.map(|v| v.scaled(-self.normal_scale)), offset: offset.scaled(-self.offset_scale) }
    }

    /// The line's value is v · u for one direction u: a sum of three products of pairs of doubles.
    fn certain_signs(&self, [x, y, w]: &[Dyadic; 3]) -> Box<dyn Fn(usize) -> Option<i8> + '_> {
        let scale = self.offset_scale - self.normal_scale;
        let direction = self.plane.direction([x.clone().scaled(scale), y.clone().scaled(scale), w.clone()]);
        let signs = DirectionSigns::new(self.vectors.query, &direction);
        Box::new(move |position| signs.certain_sign(self.vectors.index(position)))
    }

    /// By linearity in the generator: one line, that of the exact sum.
    fn signed_normal_sum(&self, terms: &mut dyn Iterator<Item = (usize, i8)>) -> [Dyadic; 2] {
        let sum =
            self.vectors.query.signed_sum_of(&mut terms.map(|(position, sign)| (self.vectors.index(position), sign)));
        self.plane.normal(&sum).map(|v| v.scaled(-self.normal_scale))
    }
}
