//! The problem in homogeneous coordinates, on which the search works.
//!
//! Minimise (linear · u + Σ |f_i · u|) / (chart · u) over the u of R^4 with chart · u > 0: a point of space is u /
//! (chart · u), a term of the objective is a linear form f, and a direction of space is a vector d with chart · d = 0.
//! The problem of planes has the chart (0, 0, 0, 1); the gauge of a point p in R^4 has the chart p and the generators
//! for forms.

use super::vector4::{Vector4, cross4, is_zero4};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::dot;
use crate::numeric::exact_sum::ExactSum;
use crate::numeric::scaling::{binary_exponent, scale_by_power_of_two};
use crate::numeric::tolerance::PRODUCT_OF_ROUNDED_VECTORS;

/// The exact forms.
#[derive(Debug)]
pub(crate) enum Source<'a> {
    /// Forms given as doubles, in two slices one after the other.
    Doubles([&'a [[f64; 4]]; 2]),
    /// Forms given as exact vectors.
    Exact(Vec<Vector4>),
}

impl Source<'_> {
    fn len(&self) -> usize {
        match self {
            Self::Doubles([first, second]) => first.len() + second.len(),
            Self::Exact(forms) => forms.len(),
        }
    }

    fn form(&self, i: usize) -> Vector4 {
        match self {
            Self::Doubles(runs) => double(runs, i).map(Dyadic::from_f64),
            Self::Exact(forms) => forms[i].clone(),
        }
    }

    /// The binary exponents of a form's coordinates.
    fn exponents(&self, i: usize) -> [Option<i64>; 4] {
        match self {
            Self::Doubles(runs) => double(runs, i).map(|v| binary_exponent(v).map(i64::from)),
            Self::Exact(forms) => forms[i].each_ref().map(Dyadic::binary_exponent),
        }
    }

    /// A form with each coordinate scaled down and rounded.
    fn rounded(&self, i: usize, scales: &[i64; 4]) -> [f64; 4] {
        match self {
            Self::Doubles(runs) => {
                let form = double(runs, i);
                std::array::from_fn(|k| scale_by_power_of_two(form[k], -scales[k]))
            }
            Self::Exact(forms) => std::array::from_fn(|k| forms[i][k].clone().scaled(-scales[k]).to_f64()),
        }
    }
}

fn double(runs: &[&[[f64; 4]]; 2], i: usize) -> [f64; 4] {
    let [first, second] = runs;
    if i < first.len() { first[i] } else { second[i - first.len()] }
}

/// A problem in homogeneous coordinates. The four coordinates of forms are scaled by powers of two of their own in
/// `rounded`, those of vectors by the inverse, which leaves products what they are.
#[derive(Debug)]
pub(crate) struct Instance<'a> {
    pub(super) chart: Vector4,
    pub(super) linear: Vector4,
    source: Source<'a>,
    rounded: Vec<[f64; 4]>,
    scales: [i64; 4],
    /// Bounds on the sums Σ |coordinate| over the rounded forms.
    extents: [f64; 4],
}

/// A vector with its rounded coordinates, scaled by a power of two to magnitude at most 2.
#[derive(Debug, Clone)]
pub(super) struct Probe {
    pub(super) exact: Vector4,
    rounded: [f64; 4],
    scale: i64,
}

/// A product of a form and a probe.
#[derive(Debug, Clone, Copy)]
pub(super) struct Product {
    /// The rounded product, in the probe's scale.
    pub(super) value: f64,
    /// A bound on the error of the value.
    pub(super) bound: f64,
    /// The exact sign.
    pub(super) sign: i8,
}

impl<'a> Instance<'a> {
    /// Scales and rounds the forms. O(n).
    pub(crate) fn new(chart: Vector4, linear: Vector4, source: Source<'a>) -> Self {
        let mut scales = [i64::MIN; 4];
        for i in 0..source.len() {
            for (scale, exponent) in scales.iter_mut().zip(source.exponents(i)) {
                *scale = exponent.map_or(*scale, |e| e.max(*scale));
            }
        }
        let scales = scales.map(|scale| if scale == i64::MIN { 0 } else { scale });
        let mut extents = [0.0; 4];
        let mut rounded = Vec::with_capacity(source.len());
        for i in 0..source.len() {
            let form = source.rounded(i, &scales);
            extents.iter_mut().zip(form).for_each(|(sum, v)| *sum += v.abs());
            rounded.push(form);
        }
        let growth = 1.0 + 4.0 * (rounded.len() as f64 + 4.0) * f64::EPSILON;
        Self { chart, linear, source, rounded, scales, extents: extents.map(|sum| sum * growth) }
    }

    /// Every eighth form, with an eighth of the linear term.
    pub(super) fn sample(&self) -> Instance<'static> {
        let forms = (0..self.len()).step_by(8).map(|i| self.form(i)).collect();
        Instance::new(self.chart.clone(), self.linear.clone().map(|v| v.scaled(-3)), Source::Exact(forms))
    }

    pub(super) fn len(&self) -> usize {
        self.rounded.len()
    }

    pub(super) fn form(&self, i: usize) -> Vector4 {
        self.source.form(i)
    }

    pub(super) fn is_zero_form(&self, i: usize) -> bool {
        self.rounded[i] == [0.0; 4] && is_zero4(&self.form(i))
    }

    pub(super) fn probe(&self, exact: Vector4) -> Probe {
        let exponents = exact.iter().zip(self.scales).filter_map(|(v, scale)| Some(v.binary_exponent()? + scale));
        let scale = exponents.max().unwrap_or(0);
        let rounded = std::array::from_fn(|k| exact[k].clone().scaled(self.scales[k] - scale).to_f64());
        Probe { exact, rounded, scale }
    }

    /// The product of a form and a probe.
    pub(super) fn product(&self, i: usize, probe: &Probe) -> Product {
        let terms: [f64; 4] = std::array::from_fn(|k| self.rounded[i][k] * probe.rounded[k]);
        let value = terms.iter().sum::<f64>();
        let size = terms.iter().map(|t| t.abs()).sum::<f64>();
        let bound = PRODUCT_OF_ROUNDED_VECTORS * size + 8.0 * f64::MIN_POSITIVE;
        let sign = if value.abs() > bound {
            if value > 0.0 { 1 } else { -1 }
        } else {
            dot(&self.form(i), &probe.exact).sign() as i8
        };
        Product { value, bound, sign }
    }

    /// Independent forms that span the space of all forms, in increasing order; the given independent ones are among
    /// them.
    pub(crate) fn spanning(&self, start: &[usize]) -> Vec<usize> {
        let mut basis = start.to_vec();
        while basis.len() < 4 {
            let forms: Vec<Vector4> = basis.iter().map(|&b| self.form(b)).collect();
            let normals: Vec<Probe> = normals(&forms).into_iter().map(|normal| self.probe(normal)).collect();
            let height = |i: usize| normals.iter().map(|normal| self.product(i, normal)).fold((0.0, false), add);
            let add_all = (0..self.len()).map(|i| (height(i), i)).filter(|((_, is_off), _)| *is_off);
            let highest = add_all.max_by(|((a, _), _), ((b, _), _)| a.total_cmp(b));
            let Some((_, next)) = highest else { break };
            basis.push(next);
        }
        basis.sort_unstable();
        basis
    }

    /// The rounded sum linear + Σ sign · form over all forms.
    pub(super) fn gradient(&self, signs: &[i8]) -> Gradient {
        let mut sum = [0.0; 4];
        for (form, &sign) in self.rounded.iter().zip(signs) {
            let sign = f64::from(sign);
            sum.iter_mut().zip(form).for_each(|(sum, v)| *sum += sign * v);
        }
        let error = (self.len() as f64 + 16.0) * f64::EPSILON;
        let floor = (self.len() as f64 + 16.0) * f64::MIN_POSITIVE;
        let linear: [f64; 4] = std::array::from_fn(|k| self.linear[k].clone().scaled(-self.scales[k]).to_f64());
        Gradient {
            value: std::array::from_fn(|k| sum[k] + linear[k]),
            error: std::array::from_fn(|k| error * (self.extents[k] + linear[k].abs()) + floor),
        }
    }

    /// The exact sum linear + Σ sign · form over all forms. O(n) exact additions.
    pub(super) fn exact_gradient(&self, signs: &[i8]) -> Vector4 {
        let mut sum = self.linear.clone();
        match &self.source {
            Source::Doubles([first, second]) => {
                let mut sums: [ExactSum; 4] = std::array::from_fn(|_| ExactSum::default());
                for (form, &sign) in first.iter().chain(*second).zip(signs).filter(|(_, sign)| **sign != 0) {
                    sums.iter_mut().zip(form).for_each(|(sum, v)| sum.add(f64::from(sign) * v));
                }
                sum.iter_mut().zip(&sums).for_each(|(a, b)| *a = &*a + &b.value());
            }
            Source::Exact(forms) => {
                for (form, &sign) in forms.iter().zip(signs).filter(|(_, sign)| **sign != 0) {
                    let add = |(a, b): (&mut Dyadic, &Dyadic)| *a = if sign > 0 { &*a + b } else { &*a - b };
                    sum.iter_mut().zip(form).for_each(add);
                }
            }
        }
        sum
    }
}

fn add((height, is_off): (f64, bool), product: Product) -> (f64, bool) {
    (height + product.value.abs(), is_off || product.sign != 0)
}

/// Vectors that span the orthogonal complement of at most three independent ones.
fn normals(independent: &[Vector4]) -> Vec<Vector4> {
    let units: [Vector4; 4] =
        std::array::from_fn(|k| std::array::from_fn(|l| Dyadic::from_f64(if k == l { 1.0 } else { 0.0 })));
    let [x, y, z, w] = &units;
    let found = match independent {
        [] => units.to_vec(),
        [a] => [(x, y), (x, z), (x, w), (y, z), (y, w), (z, w)].map(|(b, c)| cross4(a, b, c)).to_vec(),
        [a, b] => units.iter().map(|c| cross4(a, b, c)).collect(),
        [a, b, c, ..] => vec![cross4(a, b, c)],
    };
    found.into_iter().filter(|normal| !is_zero4(normal)).collect()
}

/// A rounded sum of forms, with a bound on the error of each coordinate.
#[derive(Debug, Clone)]
pub(super) struct Gradient {
    value: [f64; 4],
    error: [f64; 4],
}

impl Gradient {
    /// The product with a probe in the probe's scale, and a bound on its error.
    pub(super) fn along(&self, probe: &Probe) -> (f64, f64) {
        let (mut value, mut error) = (0.0, 8.0 * f64::MIN_POSITIVE);
        for k in 0..4 {
            let term = self.value[k] * probe.rounded[k];
            value += term;
            error += PRODUCT_OF_ROUNDED_VECTORS * term.abs() + 1.01 * self.error[k] * probe.rounded[k].abs();
        }
        (value, error)
    }
}

impl Probe {
    /// An exact product with the vector, rounded to the scale of the other products.
    pub(super) fn in_scale(&self, value: &Dyadic) -> f64 {
        value.clone().scaled(-self.scale).to_f64()
    }
}
