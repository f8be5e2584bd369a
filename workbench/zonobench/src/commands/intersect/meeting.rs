//! Two bodies and what `solve` says about them, in the terms of the picture and the summary.

use std::path::PathBuf;

use anyhow::anyhow;
use serde_json::{Value, json};
use zonotope::numeric::Rational;
use zonotope::numeric::dyadic::Dyadic;

use crate::commands::asked::{About, Asked, float, floats};
use crate::input::{Body, ExactBody, Placed};
use batch::json::{rows_to_json, vector_to_json};

/// Two bodies, the question about them and its answer.
pub(in crate::commands) struct Meeting {
    pub(in crate::commands) placed: [Placed; 2],
    /// The bodies in doubles: what the picture shows.
    pub(in crate::commands) bodies: [Body; 2],
    pub(in crate::commands) exact: [ExactBody; 2],
    pub(in crate::commands) asked: Asked,
    pub(in crate::commands) status: String,
    /// The factor by which both bodies, as doubles hold them, must be taken about their centres to touch, unless they
    /// are too large for it to be found.
    pub(in crate::commands) gauge: Option<f64>,
    /// Whether doubles hold both bodies, so that the gauge is that of the bodies as they are.
    pub(in crate::commands) is_exact: bool,
    pub(in crate::commands) proof: Proof,
}

/// The proof, rounded for the eye.
pub(in crate::commands) enum Proof {
    Gap(Gap),
    /// A coefficient for each generator, those of the first body first, and the point that they lead to.
    Common {
        coefficients: Vec<f64>,
        point: Vec<f64>,
    },
}

/// Two parallel planes with the first body below one and the second above the other.
pub(in crate::commands) struct Gap {
    /// The unit normal of the planes.
    pub(in crate::commands) direction: Vec<f64>,
    /// Their distance.
    pub(in crate::commands) width: f64,
    /// The height of the second centre above the first in this direction, and the reach of both bodies together.
    pub(in crate::commands) centers: f64,
    pub(in crate::commands) reach: f64,
}

impl Meeting {
    /// Asks about two bodies, which may be refused.
    pub(in crate::commands) fn of(name: &str, files: [&PathBuf; 2], placed: [Placed; 2]) -> anyhow::Result<Self> {
        let rounded = [placed[0].rounded(files[0])?, placed[1].rounded(files[1])?];
        let exact = placed.each_ref().map(Placed::exact);
        let asked = Asked::of(About::Intersect.question(name, &placed.each_ref().map(Placed::question), None, None))?;
        let is_exact = rounded.iter().all(|body| body.off == 0.0);
        let bodies = rounded.map(|rounded| rounded.body);
        let generators = [rows_to_json(&bodies[0].generators), rows_to_json(&bodies[1].generators)].into_iter();
        let generators: Vec<Value> = generators.filter_map(|rows| rows.as_array().cloned()).flatten().collect();
        let [p, q] = bodies.each_ref().map(|body| vector_to_json(&body.center));
        let distance = json!({"p": p, "q": q, "generators": generators});
        let gauge = Asked::of(json!({"id": name, "kind": "gauge", "input": distance})).ok();

        let result = asked.result();
        let certificate = &result["certificate"];
        let proof = match certificate["separating_direction"].as_array() {
            Some(direction) => Proof::Gap(Gap::of(&exact, direction)?),
            None => {
                let coefficients = floats(&certificate["coefficients"]);
                let point = common_point(&exact[0], &coefficients);
                Proof::Common { coefficients, point }
            }
        };
        let status = result["status"].as_str().unwrap_or_default().to_owned();
        let gauge = gauge.map(|asked| float(&asked.result()["gauge"]));
        Ok(Self { placed, bodies, exact, asked, status, gauge, is_exact, proof })
    }

    /// The number of coordinates.
    pub(in crate::commands) fn dimension(&self) -> usize {
        self.bodies[0].center.len()
    }

    /// The distance of the centres.
    pub(in crate::commands) fn distance(&self) -> f64 {
        let [a, b] = &self.exact;
        length(&b.center.iter().zip(&a.center).map(|(b, a)| b - a).collect::<Vec<_>>()).1
    }
}

/// A vector divided by its length, and the length; computed on multiples that neither overflow nor vanish.
fn length(vector: &[Dyadic]) -> (Vec<f64>, f64) {
    let Some(exponent) = vector.iter().filter_map(Dyadic::binary_exponent).max() else {
        return (vec![0.0; vector.len()], 0.0);
    };
    let scaled: Vec<f64> = vector.iter().map(|x| x.clone().scaled(-exponent).to_f64()).collect();
    let norm = scaled.iter().map(|x| x * x).sum::<f64>().sqrt();
    (scaled.iter().map(|x| x / norm).collect(), Dyadic::from_f64(norm).scaled(exponent).to_f64())
}

impl Gap {
    /// The gap in a direction.
    pub(in crate::commands) fn of(bodies: &[ExactBody; 2], direction: &[Value]) -> anyhow::Result<Self> {
        let direction = whole(direction).ok_or_else(|| anyhow!("the direction cannot be read"))?;
        let along = |v: &[Dyadic]| direction.iter().zip(v).fold(Dyadic::zero(), |sum, (u, x)| sum + u * x);
        let centers = along(&bodies[1].center) - along(&bodies[0].center);
        let all = bodies.iter().flat_map(|body| &body.generators);
        let reach = all.fold(Dyadic::zero(), |sum, generator| sum + along(generator).abs());
        let exponent = direction.iter().filter_map(Dyadic::binary_exponent).max().unwrap_or(0);
        let scaled: Vec<Dyadic> = direction.iter().map(|u| u.clone().scaled(-exponent)).collect();
        let (direction, norm) = length(&scaled);
        let per_length = |value: &Dyadic| value.clone().scaled(-exponent).to_f64() / norm;
        Ok(Self {
            direction,
            width: per_length(&(&centers - &reach)),
            centers: per_length(&centers),
            reach: per_length(&reach),
        })
    }
}

/// A multiple of a direction that is written in floats or in exact numbers.
fn whole(direction: &[Value]) -> Option<Vec<Dyadic>> {
    if direction.iter().all(Value::is_f64) {
        return direction.iter().map(|u| u.as_f64().map(Dyadic::from_f64)).collect();
    }
    let exact: Vec<Rational> = direction.iter().map(|u| u.as_str()?.parse().ok()).collect::<Option<_>>()?;
    let common = exact.iter().fold(Rational::ONE, |common, u| common * Rational::from(u.denominator().clone()));
    let whole = exact.into_iter().map(|u| Dyadic::new((u * &common).into_parts().0, 0));
    Some(whole.collect())
}

/// The point of a body to which its coefficients, the first of all, lead.
fn common_point(body: &ExactBody, coefficients: &[f64]) -> Vec<f64> {
    let coordinate = |axis: usize| {
        let terms = body.generators.iter().zip(coefficients);
        let start = body.center[axis].clone();
        let sum = terms.fold(start, |sum, (generator, &delta)| sum + &generator[axis] * &Dyadic::from_f64(delta));
        sum.to_f64()
    };
    (0..body.center.len()).map(coordinate).collect()
}
