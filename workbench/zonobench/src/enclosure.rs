//! The zonogon of least area around points, as an answer: its figures, its JSON, and the exact check of both.

use serde_json::{Value, json};
use zonotope::enclosing::min_area_zonogon::exact::{ExactZonogon, exact_optimum};
use zonotope::enclosing::min_area_zonogon::{Method, MinAreaError, MinAreaZonogon};
use zonotope::numeric::Rational;
use zonotope::numeric::dyadic::Dyadic;

use verifier::{Certificate, MinAreaAnswer, MinAreaProof, Verdict, check_min_area};

/// A solved instance.
#[derive(Debug)]
pub struct Enclosure {
    /// The library's answer.
    pub found: MinAreaZonogon,
    /// The method that found it.
    pub method: Method,
}

impl Enclosure {
    /// Solves an instance; the seed decides how long it takes, never how small the zonogon is.
    pub fn of(points: &[[f64; 2]], method: Method, seed: u64) -> Result<Self, MinAreaError> {
        let found = method.solve(points, seed, &mut ())?;
        Ok(Self { found, method })
    }

    /// The area of the convex hull, and that of the zonogon relative to it (absent where the hull has no area).
    pub fn hull_area_and_ratio(&self) -> (f64, Option<f64>) {
        let vertices: Vec<[Dyadic; 2]> =
            self.found.proof.hull().vertices().iter().map(|vertex| vertex.map(Dyadic::from_f64)).collect();
        let arm = |vertex: &[Dyadic; 2]| [&vertex[0] - &vertices[0][0], &vertex[1] - &vertices[0][1]];
        let doubled = vertices.windows(2).fold(Dyadic::zero(), |sum, pair| {
            let [a, b] = [arm(&pair[0]), arm(&pair[1])];
            sum + (&a[0] * &b[1] - &a[1] * &b[0])
        });
        let area = doubled.scaled(-1);
        let ratio = (!area.is_zero()).then(|| self.found.body.exact_area().ratio(&area));
        (area.to_f64(), ratio)
    }

    /// The answer in the terms of the verifier.
    pub fn answer(&self) -> MinAreaAnswer {
        let found = &self.found;
        MinAreaAnswer {
            area: found.value,
            center: found.body.center(),
            generators: found.body.generators().to_vec(),
            lower_bound: found.lower_bound,
            certificate: Certificate {
                hull: found.proof.hull().indices().iter().map(|index| index.get()).collect(),
                farthest: found.proof.farthest().iter().map(|farthest| farthest.vertex().get()).collect(),
                coefficients: found.proof.certificate().signs.iter().map(|&sign| f64::from(sign)).collect(),
                basis: found.proof.certificate().basis.iter().map(|edge| edge.position()).collect(),
            },
        }
    }

    /// Checks the answer with the verifier, which shares no code with the solver.
    pub fn check(&self, points: &[[f64; 2]]) -> Verdict<MinAreaProof> {
        check_min_area(points, &self.answer())
    }

    /// The optimum without any rounding.
    pub fn exact(&self) -> ExactZonogon {
        exact_optimum(&self.found)
    }

    /// The result of a `min_area` answer.
    pub fn result(&self) -> Value {
        batch::min_area_result(&self.found)
    }
}

/// An exact optimum as JSON: every number a string `num` or `num/den`.
pub fn exact_to_json(exact: &ExactZonogon) -> Value {
    let vector = |[x, y]: &[Rational; 2]| json!([x.to_string(), y.to_string()]);
    json!({
        "area": exact.area.to_string(),
        "center": vector(&exact.center),
        "generators": exact.generators.iter().map(vector).collect::<Vec<_>>(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn answers_pass_the_check_where_doubles_are_coarse() {
        let around = |center: [f64; 2], radius: f64, count: usize| -> Vec<[f64; 2]> {
            let angle = |i: usize| i as f64 * std::f64::consts::TAU / count as f64;
            let point = |i: usize| [center[0] + radius * libm::cos(angle(i)), center[1] + radius * libm::sin(angle(i))];
            (0..count).map(point).collect()
        };
        let mut cases = vec![
            vec![[0.0, 0.0], [5e-324, 0.0], [0.0, 5e-324]],
            vec![[1e16, 0.0], [1.000_000_000_000_000_2e16, 0.0], [1e16, 2.0]],
        ];
        cases.extend([1e-309, 1e-310, 1e-318, 1e-323].map(|radius| around([0.0; 2], radius, 300)));
        cases.extend([1.0, 1e-3, 1e-9].map(|radius| around([5e5, 5.2e6], radius, 300)));
        for points in cases {
            let enclosure = Enclosure::of(&points, Method::default(), 0).expect("finite points");
            assert!(enclosure.check(&points).is_right(), "{:?} {:?}", enclosure.check(&points), points[0]);
        }
    }
}
