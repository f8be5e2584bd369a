//! The signs that generators have throughout a cone of directions.

use crate::lad::of_generators::seam::direction_cone::DirectionCone;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::lanes::signed_factors;
use crate::numeric::reused::Reused;

/// The sign that each generator has throughout a cone, as the pass took it that told which ones cross the cone; 0 for
/// those.
pub(super) fn fixed_signs(query: &dyn KernelQuery, cone: &DirectionCone, crossing: &[u32]) -> Vec<i8> {
    fixed_coefficients(query, cone, crossing).iter().map(|&sign| sign as i8).collect()
}

/// The same signs as coefficients.
pub(super) fn fixed_coefficients(query: &dyn KernelQuery, cone: &DirectionCone, crossing: &[u32]) -> Reused<f64> {
    let mut signs = Reused::with_capacity(query.len());
    for part in query.parts() {
        let center = part.frame.map_or(cone.center, |frame| frame.pulled_cell(cone).center);
        signed_factors(part.rows, &center, 1.0, &mut signs);
    }
    crossing.iter().for_each(|&index| signs[index as usize] = 0.0);
    signs
}
