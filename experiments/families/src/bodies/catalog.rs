//! The lists of the families of generators, by dimension.

use super::family::BodyFamily;
use super::{box_sums, directions, lengths, planes, polar, random};

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
