//! Rational numbers as a question or an answer writes them.

use dashu_int::IBig;

/// A numerator and a positive denominator.
pub type Fraction = (IBig, IBig);
