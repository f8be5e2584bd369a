//! Families of generators: inputs of everything that is done with zonotopes, and in [`question`] of what is asked about
//! them.
//!
//! | family | what is hard about it |
//! | --- | --- |
//! | `random_bodies` | nothing: the reference |
//! | `box_sums` | six generators are two boxes; the facets of a box have parallel edges in threes |
//! | `polar_bodies` | generators on a cone: every facet meets the axis of symmetry at one of two distances |
//! | `sorted_bodies` | generators in the order of their directions: a strided sample is regular, a prefix is worthless |
//! | `heavy_tailed_bodies` | a few generators are as long as all others together: samples miss them |
//! | `lattice_bodies` | integer generators: parallel and coplanar ones everywhere, facets of many sides, exact touching |
//! | `parallel_bodies` | twenty directions, exactly parallel generators in each |
//! | `noisy_directions_bodies` | eight directions with noise of 1e-9: nearly parallel, never exactly |
//! | `near_plane_bodies` | nine in ten generators within 1e-6 of a plane |
//! | `flat_bodies` | all generators exactly in a plane: the body has no interior |
//! | `wide_scales_bodies` | lengths from 2^-200 to 2^200 |

mod box_sums;
mod directions;
mod lengths;
mod planes;
mod polar;
pub mod question;
mod random;

/// A family of generators in R^D.
#[derive(Clone, Copy, Debug)]
pub struct BodyFamily<const D: usize> {
    /// Stable name: part of every case id.
    pub id: &'static str,
    /// Name for people.
    pub title: &'static str,
    /// The generators, in a sentence.
    pub description: &'static str,
    /// Whether the seed matters; if not, there is one body of each size.
    pub is_random: bool,
    /// `n` generators for a seed: a pure function.
    pub generate: fn(n: usize, seed: u64) -> Vec<[f64; D]>,
}

impl<const D: usize> BodyFamily<D> {
    /// The `n` generators that belong to `seed`.
    pub fn generate(&self, n: usize, seed: u64) -> Vec<[f64; D]> {
        (self.generate)(n, seed)
    }
}

/// Every family in space, in the order in which reports list them.
pub static BODY_FAMILIES: &[BodyFamily<3>] = &[
    random::RANDOM_BODIES,
    box_sums::BOX_SUMS,
    polar::POLAR_BODIES,
    directions::SORTED_BODIES,
    lengths::HEAVY_TAILED_BODIES,
    planes::LATTICE_BODIES,
    directions::PARALLEL_BODIES,
    directions::NOISY_DIRECTIONS_BODIES,
    planes::NEAR_PLANE_BODIES,
    planes::FLAT_BODIES,
    lengths::WIDE_SCALES_BODIES,
];

/// The family whose bodies are nearly balls, which order reduction is measured on beside all others: only for it is the
/// best exponent known.
pub static NEAR_BALLS: &BodyFamily<3> = &random::NEAR_BALLS;

/// Families in the plane.
pub static PLANE_FAMILIES: &[BodyFamily<2>] = &[random::RANDOM_ZONOGONS, planes::LATTICE_ZONOGONS];

/// Families in R^4.
pub static SPACE_TIME_FAMILIES: &[BodyFamily<4>] = &[random::RANDOM_BODIES_4, planes::LATTICE_BODIES_4];

/// The family in space called `id`, if there is one.
pub fn find(id: &str) -> Option<&'static BodyFamily<3>> {
    BODY_FAMILIES.iter().find(|family| family.id == id)
}

/// Whether a family of any dimension is called `id`.
pub fn is_known(id: &str) -> bool {
    let ids = BODY_FAMILIES.iter().map(|family| family.id);
    ids.chain(PLANE_FAMILIES.iter().map(|f| f.id))
        .chain(SPACE_TIME_FAMILIES.iter().map(|f| f.id))
        .any(|known| known == id)
}

#[cfg(test)]
mod tests;
