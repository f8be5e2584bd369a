//! Section 4.2, second paragraph.

use dashu_ratio::RBig;
use rand_pcg::Pcg64Mcg;
use zonotope::enclosing::fixed_directions::FixedDirections;
use zonotope::enclosing::fixed_directions::rational::min_length_in_rationals;

use super::random_problem;
use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::enclosing::{doubles, extreme_points, facet_normals, least_length, rows};
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "extreme-points-suffice",
    place: Place { section: "4.2", label: "second paragraph" },
    kind: ClaimKind::Statement,
    statement: "Only the two extreme points along each facet normal, n' = O(k^(d-1)) in all, matter to the discrete \
        oriented enclosing zonotope",
    remedy: Some("for directions that span; see the correction for those that do not"),
    code: &["zonotope::enclosing::fixed_directions", "zonotope::enclosing::fixed_directions::papers_program"],
    check: Check::Run(check),
    tried: Tried::On(&["directions of R^2 and R^3"]),
    ..Claim::LISTED
};

/// Random points and directions that span: the least length of all points is that of the extreme ones.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 61);
    let mut seen = Seen::default();
    let tried = (0..12)
        .try_for_each(|index| try_one::<2>(&mut random, index, &mut seen))
        .and_then(|()| (0..10).try_for_each(|index| try_one::<3>(&mut random, index, &mut seen)));
    match tried {
        Err(witness) => Verdict::Refuted(witness),
        Ok(()) => Verdict::Holds(format!(
            "for {} sets of up to {} points in R^2 and R^3 and up to {} spanning directions, parallel ones among them, \
             the extreme points, at most two for each of the C(k, d-1) normals and {} in all of {} points, have the \
             least length of all points, as rational numbers",
            seen.problems, seen.most_points, seen.most_directions, seen.extreme, seen.points
        )),
    }
}

#[derive(Default)]
struct Seen {
    problems: usize,
    points: usize,
    extreme: usize,
    most_points: usize,
    most_directions: usize,
}

fn try_one<const D: usize>(random: &mut Pcg64Mcg, index: usize, seen: &mut Seen) -> Result<(), String> {
    let (points, directions) = random_problem::<D>(random, 6 + 3 * index, D + index % 3);
    let (exact, along) = (rows(&points), rows(&directions));
    let normals = facet_normals(&along, D);
    let extreme = extreme_points(&exact, &normals);
    let most = if D == 2 { along.len() } else { along.len() * (along.len() - 1) / 2 };
    if extreme.len() > 2 * most {
        return Err(format!("{} extreme points of {points:?} along {directions:?}", extreme.len()));
    }
    let kept: Vec<Vec<RBig>> = extreme.iter().map(|&point| exact[point].clone()).collect();
    let (all, few) = (least_length(&exact, &along, D), least_length(&kept, &along, D));
    if all != few || all.is_none() {
        return Err(format!("{points:?} along {directions:?}: {all:?}, of the extreme points {few:?}"));
    }
    let (points, directions) = (doubles(&points), doubles(&directions));
    let weights = vec![1.0; directions.len()];
    let problem = FixedDirections::new(&points, &directions, &weights).map_err(|error| error.to_string())?;
    if min_length_in_rationals(&problem).map(|optimum| optimum.value) != all {
        return Err(format!("the library's optimum of {points:?} along {directions:?} is not {all:?}"));
    }
    seen.problems += 1;
    seen.points += points.len();
    seen.extreme += extreme.len();
    seen.most_points = seen.most_points.max(points.len());
    seen.most_directions = seen.most_directions.max(directions.len());
    Ok(())
}
