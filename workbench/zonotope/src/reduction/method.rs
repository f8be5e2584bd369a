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

/// A rule that reduces a zonotope to a number of generators.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
#[non_exhaustive]
pub enum Method {
    /// [`by_clusters`](super::by_clusters), the default.
    #[default]
    Clusters,
    /// [`by_patches`](super::by_patches): Lemma 5.5.
    Patches,
    /// [`by_girard`](super::keeping::by_girard).
    Girard,
    /// [`by_combastel`](super::keeping::by_combastel).
    Combastel,
    /// [`by_pca`](super::keeping::by_pca).
    Pca,
    /// [`by_scott`](super::keeping::by_scott).
    Scott,
    /// [`by_adaptive`](super::keeping::by_adaptive).
    Adaptive,
    /// The answer of the rule whose Hausdorff distance has the least upper bound.
    Best,
}

/// The bounds by which rules are compared differ by at most this part of them, where little work is enough for that.
const COMPARED_WIDTH: f64 = 0.02;

impl Method {
    /// Every rule, the default first and the best of the others last.
    pub const ALL: [Self; 8] = [
        Self::Clusters,
        Self::Patches,
        Self::Girard,
        Self::Combastel,
        Self::Pca,
        Self::Scott,
        Self::Adaptive,
        Self::Best,
    ];

    /// The name of the rule where questions name one.
    pub const fn id(self) -> &'static str {
        match self {
            Self::Clusters => "cluster",
            Self::Patches => "lemma_5_5",
            Self::Girard => "girard",
            Self::Combastel => "combastel",
            Self::Pca => "pca",
            Self::Scott => "scott",
            Self::Adaptive => "adaptive",
            Self::Best => "best",
        }
    }

    /// The rule of an id.
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|method| method.id() == id)
    }

    /// The rule in a few words.
    pub const fn title(self) -> &'static str {
        match self {
            Self::Clusters => "Cluster sums, fitted and scaled",
            Self::Patches => "Patches of directions",
            Self::Girard => "Girard's rule",
            Self::Combastel => "Combastel's rule",
            Self::Pca => "A box along principal axes",
            Self::Scott => "A growing parallelepiped",
            Self::Adaptive => "A box within an error",
            Self::Best => "The best of the rules",
        }
    }

    /// The cost for n generators that become k.
    pub const fn cost(self) -> &'static str {
        match self {
            Self::Clusters => "O(n k) a round, C(k, D − 1) passes for the proof",
            Self::Patches | Self::Girard | Self::Combastel | Self::Pca | Self::Adaptive => "O(n log n)",
            Self::Scott => "O(n (n − k))",
            Self::Best => "that of all rules and of their distances",
        }
    }

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
