//! Questions about a body whose answers are known before any method is asked.
//!
//! The truth comes from the construction, in exact arithmetic, and shares nothing with the methods of `collision`:
//!
//! 1. The normal u of a facet is the cross product of two random generators, exactly.
//! 2. A point b of that facet is the sum of the generators with the signs of u · v, those in the facet's plane with a
//!    random coefficient from −1, −1/2, 0, 1/2, 1. So the gauge of b is 1: u · b = h(u), and the coefficients are a
//!    witness.
//! 3. The point asked about is q = (1 ± gap) b, rounded. u · q / h(u) bounds its gauge from below. From above it is
//!    bounded by the factor plus the gauge of the rounding error, which is at most the largest coefficient when the
//!    error is written in three sums of generators. A question whose two bounds are not within a tenth of the wanted
//!    gap is not asked: the thin bodies of `wide_scales_bodies` have few, and a touching point must be a difference of
//!    doubles.

mod facet;
mod placement;

pub use placement::{PLACEMENTS, Placement};

use crate::seed;
use facet::Facet;
use families::source::RandomSource;
use zonotope::Pose;
use zonotope::collision::Query;
use zonotope::numeric::dyadic::Dyadic;
use zonotope::zonotope::Zonotope;

/// The number of facets that are tried before a placement is given up for a body.
const FACET_LIMIT: usize = 24;

/// Quaternions [w, x, y, z] of turns that permute the axes and change signs: they round no coordinate.
pub const TURNS: [[f64; 4]; 2] = [[0.5, 0.5, 0.5, 0.5], [0.5, -0.5, 0.5, 0.5]];

/// The place of the displacement `to` − `from` relative to the zonotope of the generators, with the truth.
#[derive(Clone, Debug)]
pub struct Question {
    /// The placement that was asked for.
    pub placement: Placement,
    /// The generators, in the order of the family.
    pub generators: Vec<[f64; 3]>,
    /// The start of the displacement.
    pub from: [f64; 3],
    /// The end of the displacement.
    pub to: [f64; 3],
    /// Certified bounds of the gauge less 1; both are zero for a touching question.
    pub excess: [f64; 2],
    /// `inside`, `boundary` or `outside`: the status that [`Location`](zonotope::collision::Location) should have.
    pub status: &'static str,
}

impl Question {
    /// A question of this placement about a body, for a seed; none when the body has no facet or edge on which a
    /// rounded point keeps the wanted gap.
    pub fn about(generators: Vec<[f64; 3]>, placement: Placement, seed: u64) -> Option<Self> {
        let mut source = RandomSource::new(seed::seed_of(seed, placement.id));
        for _ in 0..FACET_LIMIT {
            let facet = Facet::random(&generators, &mut source)?;
            let factor = placement.factor(&mut source);
            let exact = facet.point.each_ref().map(|c| c * &factor);
            let (from, to) = rounded(&exact, placement.is_touching());
            let asked: [Dyadic; 3] = std::array::from_fn(|i| Dyadic::from_f64(to[i]) - Dyadic::from_f64(from[i]));
            let Some(excess) = facet.excess_of(&asked, &factor, &generators) else { continue };
            if !placement.accepts(excess) {
                continue;
            }
            let status = match excess {
                [low, _] if low > 0.0 => "outside",
                [_, high] if high < 0.0 && !facet.is_flat => "inside",
                _ => "boundary",
            };
            return Some(Self { placement, generators, from, to, excess, status });
        }
        None
    }

    /// The question as the library takes it.
    pub fn displacement(&self) -> Query<'_, 3> {
        Query::new(self.from, self.to, &self.generators).expect("generated coordinates are finite")
    }

    /// The same as an intersection of two bodies: the first half of the generators around `from`, the others around
    /// `to`.
    pub fn bodies(&self) -> [Zonotope<3>; 2] {
        let (first, second) = self.generators.split_at(self.generators.len() / 2);
        [(self.from, first), (self.to, second)].map(|(center, generators)| {
            Zonotope::new(center, generators.to_vec()).expect("generated coordinates are finite")
        })
    }

    /// The same two bodies, each around the origin of a frame of its own, and where it stands: under one of [`TURNS`].
    pub fn turned(&self) -> [(Zonotope<3>, Pose); 2] {
        let [a, b] = self.bodies();
        [(a, TURNS[0]), (b, TURNS[1])].map(|(body, turn)| {
            let pose = Pose::from_quaternion(turn, body.center()).expect("generated coordinates are finite");
            let rows = pose.matrix();
            let local = |g: &[f64; 3]| [0, 1, 2].map(|j| rows[0][j] * g[0] + rows[1][j] * g[1] + rows[2][j] * g[2]);
            let generators = body.generators().iter().map(local).collect();
            (Zonotope::new([0.0; 3], generators).expect("generated coordinates are finite"), pose)
        })
    }

    /// Whether the displacement lies outside, so that the two bodies are a distance apart.
    pub fn are_disjoint(&self) -> bool {
        self.status == "outside"
    }

    /// Whether the displacement lies inside, so that the two bodies have inner points in common.
    pub fn overlap(&self) -> bool {
        self.status == "inside"
    }

    /// Whether the displacement lies in the closed body.
    pub fn is_member(&self) -> bool {
        self.status != "outside"
    }
}

/// The exact point as `to` − `from`: both roundings together if it must be exact, otherwise from the origin.
fn rounded(exact: &[Dyadic; 3], with_tail: bool) -> ([f64; 3], [f64; 3]) {
    let to = exact.each_ref().map(Dyadic::to_f64);
    let tail =
        std::array::from_fn(|i| if with_tail { (Dyadic::from_f64(to[i]) - exact[i].clone()).to_f64() } else { 0.0 });
    (tail, to)
}

#[cfg(test)]
mod tests;
