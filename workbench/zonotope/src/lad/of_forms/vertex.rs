//! A vertex of the arrangement of planes, with the subdifferential of the objective at it.

use std::cell::OnceCell;
use std::cmp::Ordering;

use super::instance::{Gradient, Instance, Probe, Product};
use super::vector4::{Vector4, cross4, negated4, plus_multiple, primitive};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::dot;
use crate::tally::{Operation, Tally};

/// A plane through a vertex: one of the problem's, or one without weight that only serves to define the vertex.
#[derive(Debug, Clone)]
pub(super) struct Plane {
    pub(super) index: Option<u32>,
    pub(super) form: Vector4,
}

/// A vertex: three independent planes and the side of every plane on which it lies.
#[derive(Debug)]
pub(super) struct Vertex {
    pub(super) basis: [Plane; 3],
    /// The point in homogeneous coordinates, with chart · point > 0.
    pub(super) point: Probe,
    /// The side of each plane on which the vertex lies, 0 for planes through it.
    pub(super) signs: Vec<i8>,
    /// The problem's planes through the vertex, without zero forms.
    pub(super) through: Vec<u32>,
    gradient: Gradient,
    exact_gradient: OnceCell<Vector4>,
}

impl Vertex {
    /// The vertex in which three planes meet, which they do in one point off the plane at infinity. O(n).
    pub(super) fn new(instance: &Instance, basis: [Plane; 3], tally: &mut impl Tally) -> Self {
        let [a, b, c] = [0, 1, 2].map(|k| &basis[k].form);
        let point = primitive(cross4(a, b, c));
        let is_behind = dot(&instance.chart, &point).sign() == Ordering::Less;
        let point = instance.probe(if is_behind { negated4(point) } else { point });
        tally.add(Operation::LineEvaluation, instance.len() as u64);
        let signs: Vec<i8> = (0..instance.len()).map(|i| instance.product(i, &point).sign).collect();
        let on = |i: &usize| signs[*i] == 0 && !instance.is_zero_form(*i);
        let through = (0..signs.len()).filter(on).map(|i| i as u32).collect();
        let gradient = instance.gradient(&signs);
        Self { basis, point, signs, through, gradient, exact_gradient: OnceCell::new() }
    }

    /// The vertex at a point, defined by planes without weight.
    pub(super) fn at(instance: &Instance, point: &Vector4, tally: &mut impl Tally) -> Self {
        let height = dot(&instance.chart, point);
        let pivot = instance.chart.iter().position(|v| !v.is_zero()).expect("a chart is not zero");
        let mut axes = (0..4).filter(|&axis| axis != pivot).map(|axis| {
            let mut form = instance.chart.clone().map(|v| -(&v * &point[axis]));
            form[axis] = &form[axis] + &height;
            Plane { index: None, form: primitive(form) }
        });
        let basis = std::array::from_fn(|_| axes.next().expect("three axes are left"));
        Self::new(instance, basis, tally)
    }

    /// The exact sum linear + Σ sign · form.
    pub(super) fn exact_gradient(&self, instance: &Instance) -> &Vector4 {
        self.exact_gradient.get_or_init(|| instance.exact_gradient(&self.signs))
    }

    /// The direction of the edge that leaves basis plane k and runs on the two others.
    pub(super) fn edge(&self, instance: &Instance, k: usize) -> Vector4 {
        let [a, b] = [(k + 1) % 3, (k + 2) % 3].map(|other| &self.basis[other].form);
        cross4(&instance.chart, a, b)
    }

    /// The slope of the objective at the vertex in a direction, and in the opposite one: rounded values in the
    /// direction's scale, and whether each is negative, exactly.
    pub(super) fn slopes(&self, instance: &Instance, direction: &Probe, tally: &mut impl Tally) -> [(f64, bool); 2] {
        let (along, mut error) = self.gradient.along(direction);
        let mut kinks = 0.0;
        for &i in &self.through {
            let Product { value, bound, .. } = instance.product(i as usize, direction);
            kinks += value.abs();
            error += bound;
        }
        error += (self.through.len() as f64 + 8.0) * f64::EPSILON * (kinks + along.abs());
        let slopes = [kinks + along, kinks - along];
        if slopes.iter().all(|slope| slope.abs() > error) {
            return slopes.map(|slope| (slope, slope < 0.0));
        }
        tally.add(Operation::ExactFallback, 1);
        let along = dot(self.exact_gradient(instance), &direction.exact);
        let kink = |i: &u32| dot(&instance.form(*i as usize), &direction.exact).abs();
        let kinks = self.through.iter().map(kink).fold(Dyadic::zero(), |sum, v| sum + v);
        [&kinks + &along, &kinks - &along].map(|slope| (direction.in_scale(&slope), slope.sign() == Ordering::Less))
    }

    /// Whether the subdifferential holds zero with coefficients 0 for the planes through the vertex off the basis:
    /// those of the basis are then in [−1, 1].
    pub(super) fn is_balanced(&self, instance: &Instance) -> bool {
        let gradient = self.exact_gradient(instance);
        (0..3).all(|k| {
            let edge = self.edge(instance, k);
            let along = dot(gradient, &edge).abs();
            match self.basis[k].index {
                Some(_) => along <= dot(&self.basis[k].form, &edge).abs(),
                None => along.is_zero(),
            }
        })
    }

    /// A plane parallel to a given one through the vertex.
    pub(super) fn parallel(&self, instance: &Instance, plane: &Plane) -> Plane {
        let at = dot(&plane.form, &self.point.exact);
        if at.is_zero() {
            return plane.clone();
        }
        let height = dot(&instance.chart, &self.point.exact);
        let scaled = plane.form.clone().map(|v| v * height.clone());
        Plane { index: None, form: primitive(plus_multiple(&scaled, &-at, &instance.chart)) }
    }
}
