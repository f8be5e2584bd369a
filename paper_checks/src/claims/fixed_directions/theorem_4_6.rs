//! Section 4.2, Theorem 4.6.

use experiments::fit::{GrowthModel, fit_growth};
use families::clouds;
use rand_pcg::Pcg64Mcg;
use zonotope::enclosing::fixed_directions::{
    Enclosure, FixedDirections, by_row_generation, papers_program, support_form,
};
use zonotope::linear_program::Clarabel;

use super::random_problem;
use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::enclosing::{doubles, least_length, rows};
use crate::definitions::ratio::{exactly, integer};
use crate::growth::verdict;
use crate::instances::polygons::generator;
use crate::proofs::lengths::check_directed;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "theorem-4.6",
    place: Place { section: "4.2", label: "Theorem 4.6" },
    kind: ClaimKind::Theorem,
    statement: "The discrete oriented zonotope of least total length along k directions containing n points can be \
        computed in O(n k^(d-1) + k^O(d)) time",
    code: &["zonotope::enclosing::fixed_directions", "zonotope::enclosing::fixed_directions::by_row_generation"],
    figures: &["zonogons-along-directions", "mesh-in-zonohedra", "scaling-program-rows", "scaling-program-times"],
    check: Check::Run(check),
    tried: Tried::Growth(&["points on a sphere of R^3"]),
    ..Claim::LISTED
};

/// Answers are optimal in rationals; the rows of the programs grow as their bounds say, and n enters by a few passes
/// alone.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 63);
    let tried = (0..6)
        .try_for_each(|index| optimal::<2>(&mut random, 12 + 8 * index, 4 + index % 3))
        .and_then(|()| (0..4).try_for_each(|index| optimal::<3>(&mut random, 10 + 8 * index, 4 + index % 2)));
    let found = tried.map(|()| {
        "for 10 sets of up to 52 points in R^2 and R^3 along up to 6 directions the value is within 1e-12 of the \
         rational optimum, every point inside and the lower bound proven by forces"
            .to_owned()
    });
    verdict(context, &CLAIM, found, growth, &["papers_program", "support_form", "by_row_generation"])
}

fn optimal<const D: usize>(random: &mut Pcg64Mcg, count: usize, k: usize) -> Result<(), String> {
    let (points, directions) = random_problem::<D>(random, count, k);
    let optimum = least_length(&rows(&points), &rows(&directions), D).ok_or("no optimum along spanning directions")?;
    let (points, directions) = (doubles(&points), doubles(&directions));
    let weights = vec![1.0; k];
    let problem = FixedDirections::new(&points, &directions, &weights).map_err(|error| error.to_string())?;
    let name = || format!("{points:?} along {directions:?}");
    let Enclosure::Optimal(answer) =
        by_row_generation::min_length_along(&problem, &mut ()).map_err(|error| error.to_string())?
    else {
        return Err(format!("{} is called infeasible", name()));
    };
    check_directed(&problem, &answer).map_err(|defect| format!("{}: {defect}", name()))?;
    let (value, lower) = (exactly(answer.value), exactly(answer.lower_bound));
    let tight = (&value - &lower) * integer(1_000_000_000_000) <= lower;
    if lower > optimum || optimum > value || !tight {
        return Err(format!("{}: between {} and {}, not {optimum}", name(), answer.lower_bound, answer.value));
    }
    Ok(())
}

/// Rows of the programs against the number of directions in space, and passes over the points.
fn growth(context: &CheckContext) -> Result<String, String> {
    let points = clouds::on_sphere::<3>(1200, context.seed);
    let (mut printed, mut all, mut needed) = (Vec::new(), Vec::new(), Vec::new());
    for (k, set) in [6, 7, 8, 10, 12].into_iter().flat_map(|k| (0..4).map(move |set| (k, set))) {
        let directions = clouds::on_sphere::<3>(k, context.seed + k as u64 + 100 * set);
        let weights = vec![1.0; k];
        let problem = FixedDirections::new(&points, &directions, &weights).map_err(|error| error.to_string())?;
        let answers = [
            papers_program::min_length_by_papers_program(&problem, &Clarabel, &mut ()),
            support_form::min_length_by_support_form(&problem, &Clarabel, &mut ()),
            by_row_generation::min_length_along(&problem, &mut ()),
        ];
        for (answer, samples) in answers.into_iter().zip([&mut printed, &mut all, &mut needed]) {
            let answer = answer.map_err(|error| error.to_string())?;
            let rows = answer.optimal().map_or(0, |zonotope| zonotope.effort.rows);
            samples.push((k as f64, rows as f64));
        }
    }
    // There are k (k - 1) normals, both ways: multiplied by k / (k - 1) that is a pure power.
    let pure = |samples: &[(f64, f64)]| samples.iter().map(|&(k, rows)| (k, rows * k / (k - 1.0))).collect::<Vec<_>>();
    let fitted = |samples: &[(f64, f64)], bound: GrowthModel| -> Result<f64, String> {
        let growth = fit_growth(samples, &[bound]).map_err(|error| error.to_string())?;
        Ok(growth.exponent.value)
    };
    let printed_power = fitted(&pure(&printed), GrowthModel::Cubic)?;
    let all_power = fitted(&pure(&all), GrowthModel::Quadratic)?;
    let needed_power = fitted(&needed, GrowthModel::Quadratic)?;
    // the bounds are numbers, so each count is held to them
    let printed_kept = printed.iter().all(|&(k, rows)| rows <= k * (k - 1.0) * (2.0 * k + 3.0));
    let all_kept = all.iter().all(|&(k, rows)| rows <= k * (k - 1.0));
    let passes = |n: usize| -> Result<usize, String> {
        let points = clouds::on_sphere::<3>(n, context.seed);
        let directions = clouds::on_sphere::<3>(8, context.seed + 8);
        let problem = FixedDirections::new(&points, &directions, &[1.0; 8]).map_err(|error| error.to_string())?;
        let answer = by_row_generation::min_length_along(&problem, &mut ()).map_err(|error| error.to_string())?;
        Ok(answer.optimal().map_or(0, |zonotope| zonotope.effort.passes))
    };
    let (few, many) = (passes(500)?, passes(8000)?);
    let last = |samples: &[(f64, f64)]| samples.last().map_or(0.0, |sample| sample.1);
    let sentence = format!(
        "for 1200 points on a sphere and four sets each of k = 6 to 12 directions the rows of the printed program, \
         {} for k = 12 and never more than k (k-1) (2k+3), grow like (k-1)/k k^{printed_power:.2}, those over all \
         normals, {} and never more than k (k-1), like (k-1)/k k^{all_power:.2}, those found as needed, {}, like \
         k^{needed_power:.2}; 500 points are read {few} times, 8000 points {many} times; \
         the factorisations of the programs' matrices are not counted",
        last(&printed),
        last(&all),
        last(&needed)
    );
    if printed_kept && all_kept && many <= 2 * few { Ok(sentence) } else { Err(sentence) }
}
