//! A proof of a location that a search found on its way to the optimum, which it made unnecessary.

use crate::zonotope::location::Separation;

/// A location that is proved without the optimum.
#[derive(Debug, Clone)]
pub(crate) enum Told {
    /// A direction that separates.
    Separated([f64; 3]),
    /// A direction that separates though rounding leaves no room for it in doubles: the exact normal of a facet that
    /// the displacement is beyond, or doubles near it.
    Beyond(Separation<3>),
    /// Coefficients in [−1, 1] that combine to the displacement, which is inside.
    Combined {
        /// One for each generator.
        coefficients: Vec<f64>,
        /// The three generators whose coefficients make up for all rounding.
        basis: Vec<usize>,
    },
    /// The same of a displacement on the boundary.
    Touching {
        /// One for each generator.
        coefficients: Vec<f64>,
        /// The three generators whose coefficients make up for all rounding.
        basis: Vec<usize>,
    },
}

impl Told {
    /// The proof of a displacement that is inside, with the basis in any order.
    pub(crate) fn combined(coefficients: Vec<f64>, basis: [usize; 3]) -> Self {
        Self::Combined { coefficients, basis: in_order(basis) }
    }

    /// The proof of a displacement on the boundary, with the basis in any order.
    pub(crate) fn touching(coefficients: Vec<f64>, basis: [usize; 3]) -> Self {
        Self::Touching { coefficients, basis: in_order(basis) }
    }
}

fn in_order(mut basis: [usize; 3]) -> Vec<usize> {
    basis.sort_unstable();
    basis.to_vec()
}
