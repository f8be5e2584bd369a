//! The methods for separators by name.

use super::{Separator, SeparatorError, brute_force, by_slope_selection};
use crate::arrangement::DualArrangement;
use crate::tables::methods;

methods! {
    /// A method that finds a separator.
    pub enum Method;
    /// The cost for n generators.
    fn cost;

    /// [`by_slope_selection`], the paper's and the default.
    BySlopeSelection => "by_slope_selection", "The k-th vertex, then the lines in order", "O(n log n) expected";
    /// [`brute_force`].
    BruteForce => "brute_force", "All vertices, sorted in rationals", "O(n² log n) in rationals";
}

impl Method {
    /// The separator with k tiles on its left. `seed` decides the time, never the separator.
    ///
    /// # Errors
    /// [`SeparatorError`] when k is above the number of tiles or falls within a facet of coplanar generators.
    pub fn separator(self, dual: &DualArrangement, k: u64, seed: u64) -> Result<Separator, SeparatorError> {
        match self {
            Self::BySlopeSelection => by_slope_selection::separator(dual, k, seed, &mut ()),
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
