//! The methods for separators by name.

use super::{Separator, SeparatorError, brute_force, by_slope_selection};
use crate::arrangement::DualArrangement;

/// A method that finds a separator.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
#[non_exhaustive]
pub enum Method {
    /// [`by_slope_selection`], the paper's and the default.
    #[default]
    BySlopeSelection,
    /// [`brute_force`].
    BruteForce,
}

impl Method {
    /// Every method, better ones first.
    pub const ALL: [Self; 2] = [Self::BySlopeSelection, Self::BruteForce];

    /// The name of the method's file.
    pub fn id(self) -> &'static str {
        match self {
            Self::BySlopeSelection => "by_slope_selection",
            Self::BruteForce => "brute_force",
        }
    }

    /// The method with a name.
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|method| method.id() == id)
    }

    /// The name for people.
    pub fn title(self) -> &'static str {
        match self {
            Self::BySlopeSelection => "The k-th vertex, then the lines in order",
            Self::BruteForce => "All vertices, sorted in rationals",
        }
    }

    /// The cost for n generators.
    pub fn cost(self) -> &'static str {
        match self {
            Self::BySlopeSelection => "O(n log n) expected",
            Self::BruteForce => "O(n² log n) in rationals",
        }
    }

    /// The separator with k tiles on its left. `seed` decides the time, never the separator.
    ///
    /// # Errors
    /// [`SeparatorError`] when k is above the number of tiles or falls within a facet of coplanar generators.
    pub fn separator(self, dual: &DualArrangement, k: u64, seed: u64) -> Result<Separator, SeparatorError> {
        match self {
            Self::BySlopeSelection => by_slope_selection::separator(dual, k, seed),
            Self::BruteForce => brute_force::separator(dual, k),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn methods_agree() {
        let generators = [[1.0, 0.0, 1.0], [0.0, 1.0, 2.0], [1.0, 1.0, -1.0], [2.0, -1.0, 0.5]];
        let dual = DualArrangement::new(&generators).expect("finite generators");
        for k in 0..8 {
            let [fast, slow] = Method::ALL.map(|method| method.separator(&dual, k, 3));
            assert_eq!((fast.is_ok(), &fast), (k <= 6, &slow), "{k}");
        }
        assert_eq!(Method::ALL.map(|method| Method::from_id(method.id())), Method::ALL.map(Some));
    }
}
