//! The reads of the construction of Lemma 5.5, against the number of generators.

use crate::definition::{Bound, Case, Experiment, FitPlan, Measurement, PerProfile, Variant, Verdict};
use crate::fit::GrowthModel;
use crate::seed::Digest;
use zonotope::reduction::Containment;
use zonotope::reduction::by_patches::patches_within;
use zonotope::tally::OperationCounts;
use zonotope::zonotope::Zonotope;

/// The precision, relative to the diameter.
const EPSILON: f64 = 0.5;

const FAMILIES: &[&str] = &["random_bodies", "heavy_tailed_bodies", "near_plane_bodies"];

/// The reads of the construction of Lemma 5.5, against the number of generators.
pub const EXPERIMENT: Experiment = Experiment {
    id: "patches-scaling",
    title: "Order reduction by patches: growth with the number of generators",
    question: "What does the reduction of Lemma 5.5 read for eps = 1/2, against the number of generators? Each \
               generator is read once for its patch, once for the sum of the patch and once for what is left of it, \
               and the patches are sorted. `generators` is how many the body around it has. Each proof of containment \
               is checked.",
    claims: &["lemma-5.5"],
    families: FAMILIES,
    sizes: super::LINEAR_SIZES,
    instances: PerProfile::both(3),
    variants: &[Variant::at_all_sizes("lemma_5_5", "Lemma 5.5: patches of directions")],
    measure,
    fits: &[FitPlan::of_operations("lemma_5_5", FAMILIES)
        .within(Bound::of_paper(GrowthModel::Linear, "Lemma 5.5"))
        .at_least(GrowthModel::Linear)],
    ..Experiment::COUNTED
};

fn measure(case: &Case) -> Result<Measurement, String> {
    let body = Zonotope::new([0.0; 3], case.body()?).map_err(|error| error.to_string())?;
    let mut counts = OperationCounts::default();
    let reduced = patches_within(&body, EPSILON, &mut counts).map_err(|error| error.to_string())?;
    let check = "shares of the generators, exactly";
    let verdict = match &reduced.proof {
        Containment::Shares(shares) => Verdict::of_check(check, shares.check(&body, &reduced.body)),
        _ => Verdict::Wrong(format!("{check}: the proof is of another kind")),
    };
    let digest = Digest::default().floats(reduced.body.generators().as_flattened()).finish();
    Ok(Measurement::new(&counts, digest, verdict).with_value("generators", reduced.body.generators().len() as f64))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Three reads a generator, and the comparisons that sort at most 108 patches.
    #[test]
    fn the_patches_read_each_generator_three_times() {
        let measured = measure(&Case::new(1, EXPERIMENT.id, "random_bodies", "lemma_5_5", 2000, 0)).expect("a body");
        assert_eq!(measured.counts["generator_read"], 3 * 2000);
        assert!((50..1000).contains(&measured.counts["comparison"]), "{:?}", measured.counts);
        assert!(matches!(measured.verdict, Verdict::Correct(_)), "{:?}", measured.verdict);
    }
}
