//! Section 4.2, displayed program.

use dashu_ratio::RBig;
use rand_pcg::Pcg64Mcg;
use zonotope::enclosing::fixed_directions::{
    Enclosure, FixedDirections, by_row_generation, papers_program as library_program, support_form,
};
use zonotope::linear_program::Clarabel;

use super::random_problem;
use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::enclosing::{doubles, extreme_points, facet_normals, least_length, papers_program, rows};
use crate::definitions::ratio::{exactly, integer};
use crate::instances::polygons::generator;
use crate::proofs::lengths::check_directed;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "linear-program",
    place: Place { section: "4.2", label: "displayed program" },
    kind: ClaimKind::Statement,
    statement: "The coefficients are the optimum of a linear program with O(k^d) equations and constraints: p_j = p + \
        sum of b_ij v_i, |b_ij| <= c_i, minimise the sum of c_i",
    remedy: Some(
        "k + d unknowns are enough: sum of c_i |u.v_i| + u.p >= max of u.p_j for each facet normal u, both ways; and \
            few of these rows are ever needed",
    ),
    code: &[
        "zonotope::enclosing::fixed_directions::papers_program",
        "zonotope::enclosing::fixed_directions::support_form",
        "zonotope::enclosing::fixed_directions::by_row_generation",
    ],
    figures: &["zonogons-along-directions", "scaling-program-rows", "scaling-program-times"],
    check: Check::Run(check),
    tried: Tried::On(&["directions of R^2 and R^3"]),
};

/// The printed program on the extreme points and one inequality for each normal have one optimum; the library's three
/// forms reach it.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 62);
    let mut seen = Seen::default();
    let tried = (0..10)
        .try_for_each(|index| try_one::<2>(&mut random, index, &mut seen))
        .and_then(|()| (0..5).try_for_each(|index| try_one::<3>(&mut random, index, &mut seen)));
    match tried {
        Err(witness) => Verdict::Refuted(witness),
        Ok(()) => Verdict::Holds(format!(
            "for {} problems in R^2 and R^3 the program as printed, of up to {} equations and bounds, no more than 2 \
             C(k, d-1) (2k + d), and the one over all normals have the same optimum in rationals; the library's three \
             forms come within 1e-12 of it, with points inside and bounds below proven",
            seen.problems, seen.most_rows
        )),
    }
}

#[derive(Default)]
struct Seen {
    problems: usize,
    most_rows: usize,
}

fn try_one<const D: usize>(random: &mut Pcg64Mcg, index: usize, seen: &mut Seen) -> Result<(), String> {
    let (points, directions) = random_problem::<D>(random, 4 + index, if D == 2 { 2 + index % 3 } else { 3 });
    let (exact, along) = (rows(&points), rows(&directions));
    let normals = facet_normals(&along, D);
    let extreme = extreme_points(&exact, &normals);
    let kept: Vec<Vec<RBig>> = extreme.iter().map(|&point| exact[point].clone()).collect();
    let printed = papers_program(&kept, &along, D);
    let Some(optimum) = least_length(&exact, &along, D).filter(|optimum| Some(optimum) == printed.as_ref()) else {
        return Err(format!("{points:?} along {directions:?}: the printed program has {printed:?}"));
    };
    let size = extreme.len() * (D + 2 * along.len());
    let most = if D == 2 { along.len() } else { along.len() * (along.len() - 1) / 2 };
    if size > 2 * most * (D + 2 * along.len()) {
        return Err(format!("{points:?} along {directions:?}: {size} equations and bounds"));
    }
    let (points, directions) = (doubles(&points), doubles(&directions));
    let weights = vec![1.0; directions.len()];
    let problem = FixedDirections::new(&points, &directions, &weights).map_err(|error| error.to_string())?;
    let answers = [
        library_program::min_length_by_papers_program(&problem, &Clarabel, &mut ()),
        support_form::min_length_by_support_form(&problem, &Clarabel, &mut ()),
        by_row_generation::min_length_along(&problem, &mut ()),
    ];
    for answer in answers {
        let Enclosure::Optimal(answer) = answer.map_err(|error| error.to_string())? else {
            return Err(format!("{points:?} along {directions:?} is called infeasible"));
        };
        check_directed(&problem, &answer).map_err(|defect| format!("{points:?} along {directions:?}: {defect}"))?;
        let excess = exactly(answer.value) - &optimum;
        if excess < RBig::ZERO || excess * integer(1_000_000_000_000) > optimum {
            return Err(format!("{points:?} along {directions:?}: {} for {optimum}", answer.value));
        }
    }
    seen.problems += 1;
    seen.most_rows = seen.most_rows.max(size);
    Ok(())
}
