//! The signs that generators have throughout a cone of directions.

use crate::lad::of_generators::seam::direction_cone::DirectionCone;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::lanes::signed_factors;

/// The sign that each generator has throughout a cone, as the pass took it that told which ones cross the cone; 0 for
/// those.
pub(super) fn fixed_signs(query: &dyn KernelQuery, cone: &DirectionCone, crossing: &[u32]) -> Vec<i8> {
    let mut signs = Vec::with_capacity(query.len());
    for part in query.parts() {
        let center = part.frame.map_or(cone.center, |frame| frame.pulled_cell(cone).center);
        let mut factors = Vec::new();
        signed_factors(part.rows, &center, 1.0, &mut factors);
        signs.extend(factors.into_iter().map(|factor| if factor < 0.0 { -1 } else { 1 }));
    }
    for &index in crossing {
        signs[index as usize] = 0;
    }
    signs
}
