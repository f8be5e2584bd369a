//! Zonotopes of R^3 for the checks: random ones from a seed, and the degenerate ones that random draws miss.

use dashu_ratio::RBig;
use rand::RngExt;
use rand_pcg::Pcg64Mcg;

use crate::definitions::ratio::{fraction, integer};
use crate::definitions::space::{Body, Vector};
use crate::definitions::upper_hull::{UpperFacet, upper_facets};

/// A body with the words that name it in a witness; its coordinates are integers.
#[derive(Clone, Debug)]
pub struct BodyInstance {
    /// The words that name the body in a witness.
    pub name: String,
    /// The centre of the body.
    pub center: [i64; 3],
    /// The generators of the body.
    pub generators: Vec<[i64; 3]>,
}

impl BodyInstance {
    /// The body in exact rationals.
    pub fn body(&self) -> Body {
        let mut body = Body::about_origin(&self.generators);
        body.center = Vector::at(self.center);
        body
    }

    /// The body in doubles, as the library takes it.
    pub fn in_doubles(&self) -> zonotope::zonotope::Zonotope<3> {
        zonotope::zonotope::Zonotope::new(doubles(self.center), self.generators.iter().copied().map(doubles).collect())
            .expect("integers of this size are finite doubles")
    }
}

/// Integer coordinates in doubles, exactly.
pub fn doubles(coordinates: [i64; 3]) -> [f64; 3] {
    coordinates.map(|c| c as f64)
}

/// A random lattice vector of a cube of half-width `reach`.
pub fn random_vector(random: &mut Pcg64Mcg, reach: i64) -> [i64; 3] {
    std::array::from_fn(|_| random.random_range(-reach..=reach))
}

/// `count` random generators, again until no three of them are coplanar: then no two are parallel and none is zero.
pub fn generators_in_general_position(random: &mut Pcg64Mcg, count: usize, reach: i64) -> Vec<[i64; 3]> {
    loop {
        let generators: Vec<[i64; 3]> = (0..count).map(|_| random_vector(random, reach)).collect();
        if are_independent(&generators) {
            return generators;
        }
    }
}

/// Whether any three of the generators are linearly independent.
pub fn are_independent(generators: &[[i64; 3]]) -> bool {
    let count = generators.len();
    let triples = (0..count).flat_map(|k| (0..k).flat_map(move |j| (0..j).map(move |i| [i, j, k])));
    triples.into_iter().all(|triple| determinant(triple.map(|i| generators[i])) != 0)
}

fn determinant([a, b, c]: [[i64; 3]; 3]) -> i128 {
    let [a, b, c] = [a, b, c].map(|v| v.map(i128::from));
    a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
}

/// Bodies that random draws miss: flat, parallel, coplanar, empty, vertical, thin.
pub fn degenerate_bodies() -> Vec<BodyInstance> {
    let named: [(&str, &[[i64; 3]]); 14] = [
        ("the point", &[]),
        ("the point with a zero generator", &[[0, 0, 0]]),
        ("a segment", &[[1, 2, 2]]),
        ("a segment of three parallel generators", &[[1, 2, 2], [-2, -4, -4], [1, 2, 2]]),
        ("a square in the plane z = 0", &[[1, 0, 0], [0, 1, 0]]),
        ("a tilted flat hexagon", &[[1, 0, 1], [0, 1, -1], [1, 1, 0]]),
        ("a vertical rectangle", &[[0, 0, 3], [1, 1, 0]]),
        ("the cube", &[[1, 0, 0], [0, 1, 0], [0, 0, 1]]),
        ("the difference of two boxes", &[[2, 0, 0], [0, 3, 0], [0, 0, 1], [1, 0, 0], [0, 1, 0], [0, 0, 5]]),
        ("the rhombic dodecahedron", &[[1, 1, 1], [1, 1, -1], [1, -1, 1], [-1, 1, 1]]),
        ("the truncated octahedron", &[[1, 1, 0], [1, -1, 0], [1, 0, 1], [1, 0, -1], [0, 1, 1], [0, 1, -1]]),
        ("a prism over a hexagon", &[[2, 0, 0], [1, 2, 0], [-1, 2, 0], [0, 0, 3]]),
        ("a needle", &[[1_000_000, 1, 0], [1_000_000, 0, 1], [1_000_001, 1, 1]]),
        ("parallel, coplanar and zero generators", &[[1, 2, 3], [2, 4, 6], [0, 0, 0], [1, 0, 0], [2, 2, 3], [0, 1, 0]]),
    ];
    named
        .into_iter()
        .enumerate()
        .map(|(index, (name, generators))| BodyInstance {
            name: name.to_owned(),
            center: [index as i64, -3, 5],
            generators: generators.to_vec(),
        })
        .collect()
}

/// Random and degenerate bodies together, of at most nine generators.
pub fn bodies(random: &mut Pcg64Mcg, count: usize) -> Vec<BodyInstance> {
    let mut all = degenerate_bodies();
    all.extend((0..count).map(|index| {
        let reach = [1, 3, 20, 1000][index % 4];
        let generators = (0..index % 9 + 1).map(|_| random_vector(random, reach)).collect();
        BodyInstance { name: format!("random body {index}"), center: random_vector(random, reach), generators }
    }));
    all
}

/// Bodies in general position of three to nine generators.
pub fn bodies_in_general_position(random: &mut Pcg64Mcg, count: usize) -> Vec<BodyInstance> {
    (0..count)
        .map(|index| BodyInstance {
            name: format!("random body {index} in general position"),
            center: random_vector(random, 9),
            generators: generators_in_general_position(random, index % 7 + 3, [5, 40, 1000][index % 3]),
        })
        .collect()
}

/// Bodies in general position no two of whose generators have parallel projections: every pair spans a facet that looks
/// up.
pub(crate) fn tilings(random: &mut Pcg64Mcg, count: usize) -> Vec<(BodyInstance, Body, Vec<UpperFacet>)> {
    let instances = bodies_in_general_position(random, count).into_iter();
    instances
        .filter_map(|instance| {
            let body = instance.body();
            let facets = upper_facets(&body);
            let pairs = body.generators.len() * (body.generators.len() - 1) / 2;
            (facets.len() == pairs).then_some((instance, body, facets))
        })
        .collect()
}

/// A point center + Σ δ_i g_i with random δ_i: all of them 1 or −1 for one draw in three, else in quarters of [−1, 1].
pub fn random_member(random: &mut Pcg64Mcg, body: &Body) -> Vector {
    let corner = random.random_range(0..3) == 0;
    body.generators.iter().fold(body.center.clone(), |point, generator| {
        let coefficient: RBig = match corner {
            true => integer(random.random_range(0..2) * 2 - 1),
            false => fraction(random.random_range(-4..=4), 4),
        };
        point.plus(&coefficient, generator)
    })
}

/// The words for where a point lies relative to a body.
pub(crate) const PLACES: [&str; 3] = ["inside", "boundary", "outside"];

/// A point with where it lies relative to a body, by the definition.
pub(crate) struct LocatedPoint {
    /// The point, in doubles.
    pub(crate) point: [f64; 3],
    /// The vector to it from the centre of the body.
    pub(crate) target: Vector,
    /// The index of its place in [`PLACES`].
    pub(crate) place: usize,
}

/// A random member of a body, moved away by nothing, by a little or by more as `trial` counts up, in doubles.
pub(crate) fn located_point(random: &mut Pcg64Mcg, body: &Body, trial: usize) -> LocatedPoint {
    let member = random_member(random, body);
    let shift = fraction([0, 1, 8][trial % 3], 8);
    let point = member.plus(&shift, &Vector::at(random_vector(random, 3))).0.each_ref().map(|c| c.to_f64_fast());
    let target = body.center.to(&Vector::exactly(point));
    let about_origin = Body { center: Vector::at([0; 3]), generators: body.generators.clone() };
    let place = match (about_origin.holds_inside(&target), about_origin.holds(&target)) {
        (true, _) => 0,
        (false, true) => 1,
        (false, false) => 2,
    };
    LocatedPoint { point, target, place }
}
