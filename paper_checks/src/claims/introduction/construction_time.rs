//! Section 1: the time in which a zonotope is constructed.

use rand_pcg::Pcg64Mcg;
use zonotope::zonotope::Zonotope;
use zonotope::zonotope::faces::{FaceLattice, Faces, Facet, faces};

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::instances::bodies::{doubles, random_vector};
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "construction-time",
    place: Place { section: "1", label: "fourth paragraph" },
    kind: ClaimKind::Statement,
    statement: "Zonotopes of R^d can be constructed within the time O(n^(d-1)), that of their size",
    code: &["zonotope::zonotope::faces"],
    check: Check::Run(check),
    tried: Tried::On(&["bodies of R^3"]),
    ..Claim::LISTED
};

/// Generators of each body.
const GENERATORS: usize = 256;

/// The largest coordinate of each body: one leaves hardly any three generators coplanar, the other has many that are.
const REACHES: [i64; 2] = [100_000, 8];

/// Edges that a walk may meet for each circle that is there. The zone theorem has ten for each line that a line of the
/// plane is added to, five on either side of a cell, and a sphere has two hemispheres.
const ZONE: f64 = 20.0;

/// The incremental construction that the paper refers to: a great circle is added by a walk through the cells that it
/// crosses, around each of them to the edge where the circle leaves it. Its time is the number of their edges, added up
/// over all circles.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 121);
    let mut bodies = Vec::new();
    for reach in REACHES {
        match walk(&mut random, reach) {
            Ok(walk) if walk.most_a_circle > ZONE => {
                return Verdict::Inconclusive(format!("a walk meets {} edges for each circle", walk.most_a_circle));
            }
            Ok(walk) => bodies.push(walk),
            Err(reason) => return Verdict::Inconclusive(reason),
        }
    }
    let most = bodies.iter().map(|walk| walk.most_a_circle).fold(0.0, f64::max);
    let totals: Vec<String> = bodies.iter().map(|walk| format!("{:.2}", walk.total)).collect();
    Verdict::Holds(format!(
        "an incremental construction of bodies of {GENERATORS} generators, one of them on a lattice, walks around \
         cells of at most {most:.2} edges in all for each circle that is there, where the zone theorem has {ZONE}; \
         in all {} n^2 edges; the library's own sweep sorts along each circle instead, in O(n^2 log n)",
        totals.join(" and ")
    ))
}

/// The walks that add the circles of a body one by one.
struct Walk {
    /// The most edges of one walk, for each circle that was there before it.
    most_a_circle: f64,
    /// The edges of all walks, over the square of the number of generators.
    total: f64,
}

/// Adds the circles of a random body with coordinates up to `reach`.
fn walk(random: &mut Pcg64Mcg, reach: i64) -> Result<Walk, String> {
    let mut generators = vec![[1, 0, 0], [0, 1, 0], [0, 0, 1]];
    let (mut most_a_circle, mut edges) = (0.0f64, 0);
    while generators.len() < GENERATORS {
        let next = random_vector(random, reach);
        let rows = generators.iter().copied().map(doubles).collect();
        let body = Zonotope::new([0.0; 3], rows).map_err(|error| error.to_string())?;
        let Faces::Solid(lattice) = faces(&body, &mut ()).map_err(|error| error.to_string())? else {
            return Err("a body with the three axes is flat".to_owned());
        };
        let met = edges_of_crossed_cells(&lattice, next);
        most_a_circle = most_a_circle.max(met as f64 / generators.len() as f64);
        edges += met;
        generators.push(next);
    }
    Ok(Walk { most_a_circle, total: edges as f64 / (GENERATORS * GENERATORS) as f64 })
}

/// The edges of the cells that a circle crosses: a cell belongs to a vertex, its corners to the facets there, and it is
/// crossed where their normals lie on both sides.
fn edges_of_crossed_cells(lattice: &FaceLattice, circle: [i64; 3]) -> u64 {
    let mut sides = vec![[false; 2]; lattice.vertex_count()];
    let mut corners = vec![0u64; lattice.vertex_count()];
    for facet in (0..lattice.facet_count() as u32).map(Facet) {
        let vertices: Vec<_> = lattice.facet_vertices(facet).collect();
        // coordinates are sums of integers, and exact
        let [a, b, c] = [0, 1, 2].map(|k| lattice.point(vertices[k]).map(|c| c as i128));
        let [u, v]: [[i128; 3]; 2] = [[a, b], [b, c]].map(|[from, to]| std::array::from_fn(|k| to[k] - from[k]));
        let normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        let side: i128 = (0..3).map(|k| normal[k] * i128::from(circle[k])).sum();
        for vertex in vertices {
            let [below, above] = &mut sides[vertex.0 as usize];
            *below |= side < 0;
            *above |= side > 0;
            corners[vertex.0 as usize] += 1;
        }
    }
    sides.iter().zip(corners).filter(|(sides, _)| sides[0] && sides[1]).map(|(_, corners)| corners).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The circles of a cube have eight triangular cells, and another circle that avoids their corners crosses six.
    #[test]
    fn a_circle_crosses_six_octants() {
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let Ok(Faces::Solid(cube)) = faces(&Zonotope::new([0.0; 3], axes.to_vec()).expect("finite"), &mut ()) else {
            panic!("a cube is solid");
        };
        assert_eq!(edges_of_crossed_cells(&cube, [1, 2, 3]), 18);
    }
}
