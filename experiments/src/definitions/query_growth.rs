//! The cost of a query to the structure of Lemma 5.3 against the number of generators, for spaces that grow with it.

use super::query_trade_off::measure_with;
use crate::definition::{Bound, Case, Experiment, FitPlan, Measurement, PerProfile, Quantity, Variant};
use crate::fit::GrowthModel;

const FAMILIES: &[&str] = &["random_bodies", "heavy_tailed_bodies"];

/// The space m = n.
const LEAST_SPACE: &str = "by_cutting_least_space";

/// The space m = n^(3/2).
const MIDDLE_SPACE: &str = "by_cutting";

/// The space m = n^2.
const MOST_SPACE: &str = "by_cutting_most_space";

/// The cost of a query to the structure of Lemma 5.3 against the number of generators.
pub const EXPERIMENT: Experiment = Experiment {
    id: "query-growth",
    title: "Repeated queries: growth with the number of generators",
    question: "What does a query cost in the structure of Lemma 5.3, against the lemma's bound? n is the number of \
               generators, and the space m is n, n^(3/2) or n^2. `share_of_bound` is the operations of a query over \
               (n^2 / m) log^2 n. Each answer is compared with the question's construction, and its proof is checked.",
    claims: &["lemma-5.3", "corollary-5.4"],
    families: FAMILIES,
    sizes: PerProfile {
        quick: &[1 << 4, 1 << 5, 1 << 6, 1 << 7, 1 << 8, 1 << 9, 1 << 10],
        full: &[1 << 4, 1 << 5, 1 << 6, 1 << 7, 1 << 8, 1 << 9, 1 << 10, 1 << 11, 1 << 12],
    },
    instances: PerProfile { quick: 9, full: 3 },
    variants: &[
        Variant::at_all_sizes(LEAST_SPACE, "Cutting, m = n"),
        Variant { id: MIDDLE_SPACE, title: "Cutting, m = n^(3/2)", largest: PerProfile::both(1 << 10) },
        Variant { id: MOST_SPACE, title: "Cutting, m = n^2", largest: PerProfile::both(1 << 8) },
    ],
    measure,
    fits: &[share(LEAST_SPACE), share(MIDDLE_SPACE), share(MOST_SPACE)],
    ..Experiment::COUNTED
};

const fn share(variant: &'static str) -> FitPlan {
    FitPlan::new(Quantity::Value("share_of_bound"), variant, FAMILIES, GrowthModel::ALL)
        .within(Bound::of_paper(GrowthModel::Constant, "Lemma 5.3"))
}

fn measure(case: &Case) -> Result<Measurement, String> {
    let n = case.n as u64;
    let space = match case.variant {
        LEAST_SPACE => n,
        MIDDLE_SPACE => (n * n * n).isqrt(),
        _ => n * n,
    };
    measure_with(case, case.n, space)
}
