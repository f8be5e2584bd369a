//! The kernel's plane of directions u with u · p = 1, p the displacement of a point from the centre of a body: the line
//! a x + b y + c = v · u of each generator v, and the point at which Σ |v · u| is least.

use serde_json::json;
use zonotope::collision::{Query, by_lad};
use zonotope::numeric::dyadic::Dyadic;

use super::picture::{Picture, optional, vectors};
use crate::json::{to_json, vector_to_json};
use crate::refusal::Refusal;

pub(super) const PLANE_OF_DIRECTIONS: Picture = Picture {
    name: "plane_of_directions",
    summary: "the kernel's plane of directions: the line of each generator, and the optimum",
    fields: &["point", "center", "generators"],
    draw: |fields| {
        let body = fields.zonotope::<3>()?;
        let query = Query::of_point(fields.vector("point")?, &body).expect("the numbers of a question are finite");
        let exact_displacement = query.exact();
        let displacement = exact_displacement.each_ref().map(Dyadic::to_f64);
        if displacement == [0.0; 3] || displacement.iter().any(|c| !c.is_finite()) {
            let message = "the point is the centre, or farther from it than doubles reach: there is no plane";
            return Err(Refusal::bad_input(message));
        }
        let chart = Chart::new(displacement);
        let origin = chart.direction([0.0, 0.0]);
        let axes = [[1.0, 0.0], [0.0, 1.0]].map(|step| {
            let along = chart.direction(step);
            [0, 1, 2].map(|axis| along[axis] - origin[axis])
        });
        let lines: Vec<[f64; 3]> = query.generators().map(|generator| chart.line(generator)).collect();
        let facet = by_lad::facet(&query, &mut ());
        // a normal of the facet through which the ray along p leaves; none is known of generators on a line
        let optimum = match *facet.basis() {
            [first, second] => {
                let [a, b] = [first, second].map(|index| query.generator(index).map(Dyadic::from_f64));
                let minor = |i: usize, j: usize| &a[i] * &b[j] - &a[j] * &b[i];
                let normal = [minor(1, 2), minor(2, 0), minor(0, 1)];
                let terms = normal.iter().zip(&exact_displacement).map(|(u, p)| u * p);
                let along = terms.fold(Dyadic::zero(), |sum, term| sum + term);
                let [i, j, _] = chart.axes;
                (!along.is_zero()).then(|| [normal[i].ratio(&along), normal[j].ratio(&along)])
            }
            _ => None,
        };
        let content = json!({
            "displacement": vector_to_json(&displacement),
            "origin": vector_to_json(&origin),
            "axes": vectors(&axes),
            "lines": vectors(&lines),
            "optimum": optional(optimum, |point| vector_to_json(&point)),
            "gauge": to_json(facet.value().0),
        });
        Ok(content.into())
    },
};

/// Coordinates (x, y) = (u_i, u_j) of the plane, k the axis along which p is longest, as the kernel has them.
struct Chart {
    /// The axes i, j, k.
    axes: [usize; 3],
    /// p_i / p_k and p_j / p_k.
    slopes: [f64; 2],
    /// 1 / p_k.
    inverse: f64,
}

impl Chart {
    fn new(p: [f64; 3]) -> Self {
        let sizes = p.map(f64::abs);
        // of equal ones the first
        let k = (1..3).fold(0, |longest, axis| if sizes[axis] > sizes[longest] { axis } else { longest });
        let [i, j] = [(k + 1) % 3, (k + 2) % 3];
        Self { axes: [i, j, k], slopes: [p[i] / p[k], p[j] / p[k]], inverse: 1.0 / p[k] }
    }

    /// The line of a generator; (0, 0, c) for one that is parallel to p.
    fn line(&self, v: &[f64; 3]) -> [f64; 3] {
        let [i, j, k] = self.axes;
        [v[i] - v[k] * self.slopes[0], v[j] - v[k] * self.slopes[1], v[k] * self.inverse]
    }

    /// The direction of a point.
    fn direction(&self, [x, y]: [f64; 2]) -> [f64; 3] {
        let [i, j, k] = self.axes;
        let mut u = [0.0; 3];
        u[i] = x;
        u[j] = y;
        u[k] = self.inverse - x * self.slopes[0] - y * self.slopes[1];
        u
    }
}
