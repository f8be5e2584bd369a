//! The error of Lemma 5.5's reduction against its number of generators.

use super::reduction_error;
use crate::definition::{Bound, Case, Experiment, FitPlan, Measurement, PerProfile, Quantity, Variant};
use crate::fit::GrowthModel;

const FAMILIES: &[&str] = &["random_bodies", "heavy_tailed_bodies", "lattice_bodies"];

/// Three generators more than a grid of m by m cells on each of three faces has cells, for m from 2 to 9. Between such
/// counts the reduction stays as it is, and its error would fall in steps.
const SIZES: &[usize] = &[15, 30, 51, 78, 111, 150, 195, 246];

/// The error of Lemma 5.5's reduction against its number of generators.
pub const EXPERIMENT: Experiment = Experiment {
    id: "patches-error",
    title: "Order reduction by patches: error against generators",
    question: "How far from the body is the reduction of Lemma 5.5, against the number of generators? n is the number \
               k of generators that a body of many is reduced to by its patches: 3 m^2 patches and three generators \
               for what is left of them. `error` is the proven upper bound of the Hausdorff distance in terms of the \
               diameter, and `share_of_bound` its part of the eps for which our grid takes so many patches: \
               k = 24 / eps^2 + 3. The lemma has k = c / eps^2 and leaves c open; 24 is ours, and where no \
               error exceeds its eps, the lemma's k is enough with it. The exponent of the error \
               against k is measured beside it.",
    claims: &["lemma-5.5"],
    families: FAMILIES,
    sizes: PerProfile::both(SIZES),
    instances: PerProfile::both(12),
    variants: &[Variant::at_all_sizes("lemma_5_5", "Lemma 5.5: patches of directions")],
    measure,
    fits: &[
        FitPlan::new(Quantity::Value("share_of_bound"), "lemma_5_5", FAMILIES, GrowthModel::ALL)
            .within(Bound::number_of_paper(1.0, "Lemma 5.5 with c = 24")),
        FitPlan::new(Quantity::Value("error"), "lemma_5_5", FAMILIES, GrowthModel::FALLING),
    ],
    ..Experiment::COUNTED
};

/// The patches that eps takes in our grid, times eps squared: three faces with (√2 / (c_3 eps))² cells each, where the
/// paper leaves the constant c_3 open and ours is 1/2.
const PATCHES_AT_ONE: f64 = 24.0;

/// The generators for what the patches leave.
const FOR_THE_REST: usize = 3;

fn measure(case: &Case) -> Result<Measurement, String> {
    let measured = reduction_error::measure(case)?;
    let error = *measured.values.get("error").ok_or("no error was measured")?;
    let epsilon = (PATCHES_AT_ONE / (case.n - FOR_THE_REST) as f64).sqrt();
    Ok(measured.with_value("share_of_bound", error / epsilon))
}

#[cfg(test)]
mod tests {
    use super::*;
    use zonotope::reduction::by_patches::patch_count;

    /// The sizes are the counts of generators that the library's precisions give.
    #[test]
    fn the_bound_of_a_size_is_the_precision_that_takes_its_grid() {
        for &k in SIZES {
            let patches = (k - FOR_THE_REST) as f64;
            let epsilon = (PATCHES_AT_ONE / patches).sqrt();
            assert_eq!(patch_count(3, epsilon * (1.0 + 1e-9)), patches, "{k} generators");
        }
    }
}
