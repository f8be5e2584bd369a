//! The rules by name.

use super::answer::{Problem, Reduced, ReductionError};
use super::by_clusters::clusters;
use super::by_patches::patches;
use super::hausdorff::Limit;
use super::keeping::by_adaptive::adaptive;
use super::keeping::by_combastel::combastel;
use super::keeping::by_girard::girard;
use super::keeping::by_pca::pca;
use super::keeping::by_scott::scott;
use crate::tables::methods;

methods! {
    /// A rule that reduces a zonotope to a number of generators.
    pub enum Method;
    /// The cost for n generators that become k.
    fn cost;

    /// [`by_clusters`](super::by_clusters), the default.
    Clusters => "cluster", "Cluster sums, fitted and scaled", "O(n k) a round, C(k, D − 1) passes for the proof";
    /// [`by_patches`](super::by_patches): Lemma 5.5.
    Patches => "lemma_5_5", "Patches of directions", "O(n log n)";
    /// [`by_girard`](super::keeping::by_girard).
    Girard => "girard", "Girard's rule", "O(n log n)";
    /// [`by_combastel`](super::keeping::by_combastel).
    Combastel => "combastel", "Combastel's rule", "O(n log n)";
    /// [`by_pca`](super::keeping::by_pca).
    Pca => "pca", "A box along principal axes", "O(n log n)";
    /// [`by_scott`](super::keeping::by_scott).
    Scott => "scott", "A growing parallelepiped", "O(n (n − k))";
    /// [`by_adaptive`](super::keeping::by_adaptive).
    Adaptive => "adaptive", "A box within an error", "O(n log n)";
    /// The answer of the rule whose Hausdorff distance has the least upper bound.
    Best => "best", "The best of the rules", "that of all rules and of their distances";
}

/// The bounds by which rules are compared differ by at most this part of them, where little work is enough for that.
const COMPARED_WIDTH: f64 = 0.02;

impl Method {
    /// A zonotope around the body with at most the given number of generators.
    ///
    /// # Errors
    /// [`ReductionError::OutOfRange`] if a generator leaves the range of doubles.
    #[inline(never)]
    pub fn reduce<const D: usize>(self, problem: &Problem<'_, D>) -> Result<Reduced<D>, ReductionError> {
        match self {
            Self::Clusters => clusters(problem),
            Self::Patches => patches(problem),
            Self::Girard => girard(problem),
            Self::Combastel => combastel(problem),
            Self::Pca => pca(problem),
            Self::Scott => scott(problem),
            Self::Adaptive => adaptive(problem),
            Self::Best => best(problem),
        }
    }
}

/// The answer of least distance; an error only if every rule has one.
fn best<const D: usize>(problem: &Problem<'_, D>) -> Result<Reduced<D>, ReductionError> {
    let others = Method::ALL.into_iter().filter(|method| *method != Method::Best);
    let answers: Vec<Result<Reduced<D>, ReductionError>> = others.map(|method| method.reduce(problem)).collect();
    let distance = |answer: &Result<Reduced<D>, ReductionError>| match answer {
        Ok(reduced) => reduced.distance_by(problem.body(), COMPARED_WIDTH, Limit::COMPARISON).upper,
        Err(_) => f64::INFINITY,
    };
    let distances: Vec<f64> = answers.iter().map(distance).collect();
    let least = (0..answers.len()).min_by(|&a, &b| distances[a].total_cmp(&distances[b])).unwrap_or(0);
    answers.into_iter().nth(least).unwrap_or_else(|| clusters(problem))
}
