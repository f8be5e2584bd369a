//! The exact twin of the kernel, from the definition alone: the least value of c·x + Σ w |a·x + b| in rationals.
//!
//! It shares nothing with the library. A convex piecewise linear function that is bounded below has its least value at
//! a vertex of the arrangement, or on one of the lines if all of them are parallel; it is unbounded if it falls along
//! one of finitely many directions, between which its slope at infinity is linear.

use dashu_ratio::RBig;

use families::drawn::lines::Instance;

/// An exact vector of the plane.
pub type Vector = [RBig; 2];

/// An instance in rationals.
#[derive(Clone, Debug)]
pub struct Exact {
    terms: Vec<(Vector, RBig, RBig)>,
    linear: Vector,
}

/// The exact value of a finite double.
pub fn exactly(value: f64) -> RBig {
    RBig::try_from(value).expect("the instances are finite")
}

fn dot(a: &Vector, b: &Vector) -> RBig {
    &a[0] * &b[0] + &a[1] * &b[1]
}

fn turned(a: &Vector) -> Vector {
    [-a[1].clone(), a[0].clone()]
}

fn negated(a: &Vector) -> Vector {
    [-a[0].clone(), -a[1].clone()]
}

fn magnitude(value: RBig) -> RBig {
    if value < RBig::ZERO { -value } else { value }
}

impl From<&Instance> for Exact {
    fn from(instance: &Instance) -> Self {
        let terms = instance.terms.iter().map(|term| (term.a.map(exactly), exactly(term.b), exactly(term.weight)));
        Exact { terms: terms.collect(), linear: instance.linear.map(exactly) }
    }
}

impl Exact {
    /// The value at a point.
    pub fn value(&self, point: &Vector) -> RBig {
        self.terms
            .iter()
            .fold(dot(&self.linear, point), |sum, (a, b, weight)| sum + weight * magnitude(dot(a, point) + b))
    }

    /// The slope far out in a direction: negative exactly if the value falls without bound along it.
    pub fn slope_at_infinity(&self, direction: &Vector) -> RBig {
        self.terms
            .iter()
            .fold(dot(&self.linear, direction), |sum, (a, _, weight)| sum + weight * magnitude(dot(a, direction)))
    }

    /// The least value, or `None` when there is none.
    pub fn least_value(&self) -> Option<RBig> {
        let normals = self.terms.iter().map(|(a, _, _)| a).chain([&self.linear]);
        let mut directions = normals.flat_map(|a| [a.clone(), turned(a)]).flat_map(|u| [negated(&u), u]);
        if directions.any(|direction| self.slope_at_infinity(&direction) < RBig::ZERO) {
            return None;
        }
        let candidates = self.vertices();
        let candidates = if candidates.is_empty() { self.points_on_lines() } else { candidates };
        candidates.iter().map(|point| self.value(point)).min()
    }

    /// The crossing of every pair of lines that are not parallel, one for each pair.
    pub fn vertices(&self) -> Vec<Vector> {
        let mut vertices = Vec::new();
        for (index, (a, b, _)) in self.terms.iter().enumerate() {
            for (c, d, _) in &self.terms[..index] {
                let determinant = &a[0] * &c[1] - &a[1] * &c[0];
                if determinant != RBig::ZERO {
                    let x = (&a[1] * d - b * &c[1]) / &determinant;
                    let y = (b * &c[0] - &a[0] * d) / determinant;
                    vertices.push([x, y]);
                }
            }
        }
        vertices
    }

    /// The foot of the perpendicular from the origin to each line, and the origin.
    fn points_on_lines(&self) -> Vec<Vector> {
        let feet = self.terms.iter().filter_map(|(a, b, _)| {
            let square = dot(a, a);
            (square != RBig::ZERO).then(|| {
                let along = -b / square;
                [&along * &a[0], along * &a[1]]
            })
        });
        feet.chain([[RBig::ZERO, RBig::ZERO]]).collect()
    }
}

impl Exact {
    /// The dimension of the set of minimisers, read off at one of them: that of the span of the directions along which
    /// the value does not change. The cone of those directions is convex and its extreme rays lie along lines through
    /// the point, unless these are all parallel, for which the normals stand in.
    pub fn face_dimension(&self, minimizer: &Vector) -> u8 {
        let through = self.terms.iter().filter(|(a, b, _)| dot(a, minimizer) == -b).map(|(a, _, _)| a.clone());
        let axes = [[RBig::ONE, RBig::ZERO], [RBig::ZERO, RBig::ONE]];
        let normals: Vec<Vector> = through.chain(axes).collect();
        let flat: Vec<Vector> = normals
            .iter()
            .flat_map(|a| [a.clone(), turned(a), negated(a), negated(&turned(a))])
            .filter(|direction| self.slope_at(minimizer, direction) == RBig::ZERO)
            .filter(|direction| direction.iter().any(|value| *value != RBig::ZERO))
            .collect();
        let Some(first) = flat.first() else { return 0 };
        if flat.iter().any(|other| dot(&turned(first), other) != RBig::ZERO) { 2 } else { 1 }
    }

    /// The one-sided derivative at a point in a direction.
    fn slope_at(&self, point: &Vector, direction: &Vector) -> RBig {
        self.terms.iter().fold(dot(&self.linear, direction), |sum, (a, b, weight)| {
            let (height, rate) = (dot(a, point) + b, dot(a, direction));
            let change = if height == RBig::ZERO {
                magnitude(rate)
            } else if height > RBig::ZERO {
                rate
            } else {
                -rate
            };
            sum + weight * change
        })
    }
}
