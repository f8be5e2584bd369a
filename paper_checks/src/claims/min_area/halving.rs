//! The search halves the candidate vertices.

use families::points::random_convex;
use zonotope::enclosing::bisectors::Bisectors;
use zonotope::hull::antipodal::farthest_vertices;
use zonotope::hull::convex_hull;
use zonotope::lad::by_slope_selection::{SearchStep, Side, trace};
use zonotope::lad::{LadProblem, WeightedLine};

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::plane::{Bisector, Point, bisectors, least_area};
use crate::growth;
use crate::instances::polygons::{generator, polygons};
use crate::proofs::library::double;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "halving-search",
    place: Place { section: "4.1", label: "before Theorem 4.5" },
    kind: ClaimKind::Statement,
    statement: "Each step of the search halves the candidate vertices by slope selection, in O(n log n) time, so O(log \
        n) steps find the minimum",
    code: &["zonotope::lad::of_lines::by_slope_selection", "zonotope::arrangement::slope_selection"],
    figures: &["scaling-kernel-operations", "scaling-kernel-times", "search-of-theorem-4-5"],
    check: Check::Run(check),
    tried: Tried::Growth(&["random convex polygons"]),
    ..Claim::LISTED
};

/// Follows the library's search: every vertical line halves the candidates, and goes to the side of the minimisers.
fn check(context: &CheckContext) -> Verdict {
    growth::verdict(context, &CLAIM, halved(context), vertical_lines, &["by_slope_selection"])
}

fn halved(context: &CheckContext) -> Result<String, String> {
    let mut random = generator(context.seed, 20);
    let (mut searches, mut sides) = (0, 0);
    for instance in polygons(&mut random, 60) {
        let lines = bisectors(&instance.polygon);
        let steps = search(&lines, context.seed);
        let (_, minimizers) = least_area(&instance.polygon);
        if let Some(step) = steps.iter().find(|step| !halves(step) || !finds_the_side(step, &minimizers)) {
            return Err(format!("{}: {step:?}", instance.name));
        }
        searches += 1;
        sides += steps.len();
    }
    Ok(format!(
        "{searches} searches drew {sides} vertical lines; each left at most half of the candidates, on the side of all \
         minimisers"
    ))
}

/// The number of vertical lines, which is held to the number of halvings.
fn vertical_lines(context: &CheckContext) -> Result<String, String> {
    let mut counts = Vec::new();
    for exponent in [5, 7, 9] {
        let n: usize = 1 << exponent;
        let points = random_convex::RANDOM_CONVEX.generate(n, context.seed);
        let hull = convex_hull(&points, &mut ()).expect("the family's points are finite");
        let farthest = farthest_vertices(&hull, &mut ());
        let (_, steps) = trace(&Bisectors::new(&hull, &farthest).kernel_problem(), context.seed);
        let halvings = (n * (n - 1) / 2).ilog2() as usize + 1;
        if steps.len() > halvings || !steps.iter().all(halves) {
            return Err(format!("{} vertical lines for n = {n}", steps.len()));
        }
        counts.push(format!("{} for n = {n} ({halvings} halvings)", steps.len()));
    }
    Ok(format!("vertical lines on random convex polygons: {}", counts.join(", ")))
}

/// The vertical lines of the library's search for the least hinge sum. The cross products are exact in doubles.
fn search(lines: &[Bisector], seed: u64) -> Vec<SearchStep> {
    let origin = Point::at(0, 0);
    let terms: Vec<WeightedLine> = lines
        .iter()
        .map(|line| {
            let [offset, _] = double(&Point::new(line.height(&origin), origin.x.clone()));
            WeightedLine::unweighted(double(&line.gradient()), offset)
        })
        .collect();
    let problem = LadProblem::new(&terms, [0.0, 0.0]).expect("the polygons are finite");
    trace(&problem, seed).1
}

fn halves(step: &SearchStep) -> bool {
    2 * step.vertices_after <= step.vertices_before
}

fn finds_the_side(step: &SearchStep, minimizers: &[Point]) -> bool {
    match step.side {
        Side::Left => minimizers.iter().all(|point| point.x < step.exact_x),
        Side::Right => minimizers.iter().all(|point| point.x > step.exact_x),
        Side::Optimal => {
            minimizers.iter().any(|point| point.x <= step.exact_x)
                && minimizers.iter().any(|point| point.x >= step.exact_x)
        }
        Side::Unbounded => false,
    }
}
