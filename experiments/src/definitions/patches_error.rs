//! The error of Lemma 5.5's reduction against its number of generators.

use super::reduction_error::measure;
use crate::definition::{Bound, Experiment, FitPlan, PerProfile, Quantity, Tabulated, Variant};
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
               diameter.",
    claims: &["lemma-5.5"],
    families: FAMILIES,
    real_inputs: &[],
    sizes: PerProfile::both(SIZES),
    instances: PerProfile::both(12),
    variants: &[Variant {
        id: "lemma_5_5",
        title: "Lemma 5.5: patches of directions",
        largest: PerProfile::both(usize::MAX),
    }],
    measure,
    table: Tabulated::MedianAtLargest,
    timing: None,
    fits: &[FitPlan::new(Quantity::Value("error"), "lemma_5_5", FAMILIES, GrowthModel::FALLING)
        .within(Bound::of_paper(GrowthModel::InverseSquareRoot, "Lemma 5.5"))],
};
