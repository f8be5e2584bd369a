//! The kernel's instances and methods by name, for every experiment on it.

use crate::definition::{Case, Variant};
use crate::seed::Digest;
use families::lines;
use zonotope::enclosing::bisectors::Bisectors;
use zonotope::hull::antipodal::{FarthestVertex, farthest_vertices};
use zonotope::hull::{ConvexHull, convex_hull};
use zonotope::lad::{LadOutcome, LadProblem, Method, WeightedLine};

/// The kernel's methods, each at all sizes.
pub(super) const VARIANTS: &[Variant] = &[
    Variant::at_all_sizes("by_slope_selection", "Slope selection (the paper's search)"),
    Variant::at_all_sizes("by_line_search", "Line searches"),
    Variant::at_all_sizes("by_pruning", "Pruning"),
];

/// The lines of a case.
pub(super) enum KernelInput {
    /// Those of a line family, unweighted, without a linear term.
    Family(LadProblem<'static>),
    /// The lines of 4.1 of a point family's hull: one for each of its edges, weighted by the edge's length.
    Hull(ConvexHull, Vec<FarthestVertex>),
}

impl KernelInput {
    /// The lines of a line family, or those of 4.1 for a point family.
    pub fn of(case: &Case) -> Result<Self, String> {
        if lines::find(case.family).is_some() {
            let lines: Vec<WeightedLine> =
                case.lines()?.into_iter().map(|(normal, offset)| WeightedLine::unweighted(normal, offset)).collect();
            return LadProblem::new(&lines, [0.0, 0.0]).map(Self::Family).map_err(|error| error.to_string());
        }
        let hull = convex_hull(&case.points()?, &mut ()).map_err(|error| error.to_string())?;
        if !hull.has_area() {
            return Err("the hull has no area, so there are no lines".to_owned());
        }
        let farthest = farthest_vertices(&hull, &mut ());
        Ok(Self::Hull(hull, farthest))
    }

    /// Hands the kernel's problem to `work`.
    pub fn with_problem<T>(&self, work: impl FnOnce(&LadProblem) -> T) -> T {
        match self {
            Self::Family(problem) => work(problem),
            Self::Hull(hull, farthest) => work(&Bisectors::new(hull, farthest).kernel_problem()),
        }
    }
}

/// The method that the case's variant names.
pub(super) fn method(case: &Case) -> Result<Method, String> {
    Method::from_id(case.variant).ok_or_else(|| format!("no method of the kernel is called {}", case.variant))
}

/// A hash of the minimiser, rounded, and of the dimension of the set of minimisers.
pub(super) fn digest(problem: &LadProblem, outcome: &LadOutcome) -> u64 {
    match outcome {
        LadOutcome::Optimal(optimum) => Digest::default()
            .floats(&optimum.point(problem).expect("the optimum is of this problem"))
            .word(u64::from(optimum.face_dimension))
            .finish(),
        LadOutcome::Unbounded { direction } => {
            Digest::default().bytes(b"unbounded").floats(&[direction[0].to_f64(), direction[1].to_f64()]).finish()
        }
    }
}
