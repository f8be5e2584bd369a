//! The methods for the height of the upper hull by name.

use super::{Height, HeightError, brute_force, by_kernel, by_slope_selection};
use crate::tables::methods;

methods! {
    /// A method that finds the height of the upper hull over a point.
    pub enum Method;
    /// The cost for n generators.
    fn cost;

    /// [`by_kernel`], the default.
    ByKernel => "by_kernel", "Kernel", "O(n) expected";
    /// [`by_slope_selection`], the paper's search.
    BySlopeSelection => "by_slope_selection", "The paper's search for the tile", "O(n log² n) expected";
    /// [`brute_force`].
    BruteForce => "brute_force", "All vertices of the dual arrangement in rationals", "O(n³) in rationals";
}

impl Method {
    /// The height over p_0. `seed` decides the time, never the height.
    ///
    /// # Errors
    /// [`HeightError`] if a number is not finite or there are too many generators.
    pub fn height(self, generators: &[[f64; 3]], p0: [f64; 2], seed: u64) -> Result<Height, HeightError> {
        match self {
            Self::ByKernel => by_kernel::height(generators, p0, &mut ()),
            Self::BySlopeSelection => by_slope_selection::height(generators, p0, seed, &mut ()),
            Self::BruteForce => brute_force::height(generators, p0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Rational;

    /// The upper hull of the unit cube is at 1 over its square and nowhere beside it.
    #[test]
    fn methods_agree() {
        let cube = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        for method in Method::ALL {
            assert_eq!(method.height(&cube, [0.5, 1.0], 3), Ok(Height::OverQ(Rational::ONE)), "{method:?}");
            assert!(matches!(method.height(&cube, [0.5, 1.5], 3), Ok(Height::BesideQ(_))), "{method:?}");
            assert_eq!(Method::from_id(method.id()), Some(method));
        }
    }
}
