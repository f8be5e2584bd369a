//! Slope selection against a sorted list of all crossings, on all line families, for every rank.

use dashu_ratio::RBig;
use families::drawn::lines::Instance;
use proptest::prelude::*;
use tests::kernel_twin::Exact;
use zonotope::arrangement::LineArrangement;
use zonotope::arrangement::slope_selection::{brute_force, randomized};

const CASES: u32 = 120;
const LARGE_CASES: u32 = 12;

fn arrangement(instance: &Instance) -> LineArrangement<'static> {
    let rows: Vec<[f64; 3]> = instance.terms.iter().map(|term| [term.a[0], term.a[1], term.b]).collect();
    LineArrangement::from_rows(&rows).expect("the families are finite")
}

/// The abscissas of all crossings, from the left.
fn abscissas(instance: &Instance) -> Vec<RBig> {
    let mut all: Vec<RBig> = Exact::from(instance).vertices().into_iter().map(|[x, _]| x).collect();
    all.sort();
    all
}

fn agrees(instance: Instance) -> Result<(), TestCaseError> {
    let arrangement = arrangement(&instance);
    let expected = abscissas(&instance);
    prop_assert_eq!(arrangement.vertex_count(), expected.len() as u64);
    for (rank, x) in (1..).zip(&expected) {
        let truth = brute_force::kth_leftmost_vertex(&arrangement, rank).map(|vertex| vertex.exact_x());
        prop_assert_eq!(truth.as_ref().ok(), Some(x), "brute_force, rank {}", rank);
        for seed in [1, 2] {
            let found = randomized::kth_leftmost_vertex(&arrangement, rank, seed, &mut ());
            prop_assert!(found.is_ok(), "rank {}: {:?}", rank, found);
            let found = found.expect("that was just asserted");
            prop_assert_eq!(&found.exact_x(), x, "rank {}", rank);
            let lines = found.lines;
            let pair = lines.map(|line| instance.terms[line.position()]);
            let alone = Instance { terms: pair.to_vec(), linear: [0.0, 0.0] };
            prop_assert_eq!(abscissas(&alone), std::slice::from_ref(x), "the lines {:?} cross elsewhere", lines);
        }
    }
    for rank in [0, expected.len() as u64 + 1] {
        prop_assert!(randomized::kth_leftmost_vertex(&arrangement, rank, 1, &mut ()).is_err());
        prop_assert!(brute_force::kth_leftmost_vertex(&arrangement, rank).is_err());
    }
    Ok(())
}

/// More lines than can be listed at once: ranks across the whole range.
fn some_ranks_agree(instance: Instance) -> Result<(), TestCaseError> {
    let arrangement = arrangement(&instance);
    let expected = abscissas(&instance);
    for twelfth in 0..=12 {
        let Some(last) = expected.len().checked_sub(1) else { break };
        let index = last * twelfth / 12;
        let found =
            randomized::kth_leftmost_vertex(&arrangement, index as u64 + 1, 3, &mut ()).map(|vertex| vertex.exact_x());
        prop_assert_eq!(found.as_ref().ok(), Some(&expected[index]), "rank {}", index + 1);
    }
    Ok(())
}

tests::test_on_line_families!(mod small: 1..=12, mixed 1..=7, CASES, agrees);
tests::test_on_line_families!(mod large: 40..=90, mixed 40..=90, LARGE_CASES, some_ranks_agree);
