//! Vectors of which the signs of products are decided in doubles with bounds, in doubles with an exponent of their own,
//! in pairs of doubles, in exact numbers, each where the ones before leave a doubt.

use std::cmp::Ordering;

use crate::numeric::bounded::wide::BoundedWide;
use crate::numeric::bounded::{self, BoundedVector};
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::exact_linear::{ExactVector, exact, negated, sum};
use crate::numeric::linear::{cross, dot};

/// A vector, or a positive multiple of it, in the precisions that are tried.
pub(crate) trait Vector {
    /// In doubles with bounds.
    fn rounded(&self) -> BoundedVector;
    /// In doubles with bounds and an exponent of their own.
    fn wide(&self) -> [BoundedWide; 3];
    /// In pairs of doubles with bounds.
    fn in_pairs(&self) -> [BoundedDoubleDouble; 3];
    /// Exactly.
    fn exact(&self) -> ExactVector;
}

impl Vector for [f64; 3] {
    fn rounded(&self) -> BoundedVector {
        bounded::exact(*self)
    }

    fn wide(&self) -> [BoundedWide; 3] {
        self.map(BoundedWide::exact)
    }

    fn in_pairs(&self) -> [BoundedDoubleDouble; 3] {
        self.map(BoundedDoubleDouble::exact)
    }

    fn exact(&self) -> ExactVector {
        exact(*self)
    }
}

impl Vector for ExactVector {
    fn rounded(&self) -> BoundedVector {
        self.in_pairs().map(|c| c.rounded())
    }

    fn wide(&self) -> [BoundedWide; 3] {
        self.each_ref().map(BoundedWide::of)
    }

    fn in_pairs(&self) -> [BoundedDoubleDouble; 3] {
        self.each_ref().map(BoundedDoubleDouble::of)
    }

    fn exact(&self) -> ExactVector {
        self.clone()
    }
}

/// A vector with its doubles, which are made once.
pub(crate) struct Filtered<V> {
    rounded: BoundedVector,
    vector: V,
}

impl<V: Vector> Filtered<V> {
    pub(crate) fn new(vector: V) -> Self {
        Self { rounded: vector.rounded(), vector }
    }

    /// The vector, exactly.
    pub(crate) fn exact(&self) -> ExactVector {
        self.vector.exact()
    }
}

impl<V: Vector> Vector for &V {
    fn rounded(&self) -> BoundedVector {
        (*self).rounded()
    }

    fn wide(&self) -> [BoundedWide; 3] {
        (*self).wide()
    }

    fn in_pairs(&self) -> [BoundedDoubleDouble; 3] {
        (*self).in_pairs()
    }

    fn exact(&self) -> ExactVector {
        (*self).exact()
    }
}

/// A vector plus an exact one, or minus it.
pub(crate) struct Shifted<'a, V> {
    pub(crate) base: &'a Filtered<V>,
    pub(crate) by: &'a ExactVector,
    pub(crate) is_reversed: bool,
}

impl<V: Vector> Vector for Shifted<'_, V> {
    fn rounded(&self) -> BoundedVector {
        let (base, by) = (self.base.rounded, self.by.rounded());
        [0, 1, 2].map(|k| if self.is_reversed { base[k] - by[k] } else { base[k] + by[k] })
    }

    fn wide(&self) -> [BoundedWide; 3] {
        let (base, by) = (self.base.vector.wide(), self.by.wide());
        [0, 1, 2].map(|k| if self.is_reversed { base[k] - by[k] } else { base[k] + by[k] })
    }

    fn in_pairs(&self) -> [BoundedDoubleDouble; 3] {
        let (base, by) = (self.base.vector.in_pairs(), self.by.in_pairs());
        [0, 1, 2].map(|k| if self.is_reversed { base[k] - by[k] } else { base[k] + by[k] })
    }

    fn exact(&self) -> ExactVector {
        let by = self.by.clone();
        sum(&self.base.vector.exact(), &if self.is_reversed { negated(by) } else { by })
    }
}

/// The sign of a · (b × c).
pub(crate) fn sign_of_determinant(
    a: &Filtered<impl Vector>,
    b: &Filtered<impl Vector>,
    c: &Filtered<impl Vector>,
) -> Ordering {
    let rounded = dot(&cross(&b.rounded, &c.rounded), &a.rounded).sign();
    let wide = || dot(&cross(&b.vector.wide(), &c.vector.wide()), &a.vector.wide()).sign();
    let in_pairs = || dot(&cross(&b.vector.in_pairs(), &c.vector.in_pairs()), &a.vector.in_pairs()).sign();
    let exactly = || dot(&cross(&b.vector.exact(), &c.vector.exact()), &a.vector.exact()).sign();
    rounded.or_else(wide).or_else(in_pairs).map_or_else(exactly, |sign| sign.cmp(&0))
}

/// The sign of a · b.
pub(crate) fn sign_of_product(a: &Filtered<impl Vector>, b: &Filtered<impl Vector>) -> Ordering {
    let rounded = dot(&a.rounded, &b.rounded).sign();
    let wide = || dot(&a.vector.wide(), &b.vector.wide()).sign();
    let in_pairs = || dot(&a.vector.in_pairs(), &b.vector.in_pairs()).sign();
    let exactly = || dot(&a.vector.exact(), &b.vector.exact()).sign();
    rounded.or_else(wide).or_else(in_pairs).map_or_else(exactly, |sign| sign.cmp(&0))
}

/// Whether two vectors are parallel, or one of them is zero.
pub(crate) fn are_parallel(a: &Filtered<impl Vector>, b: &Filtered<impl Vector>) -> bool {
    let is_certainly_not = cross(&a.rounded, &b.rounded).iter().any(|c| c.sign().is_some())
        || cross(&a.vector.wide(), &b.vector.wide()).iter().any(|c| c.sign().is_some())
        || cross(&a.vector.in_pairs(), &b.vector.in_pairs()).iter().any(|c| c.sign().is_some());
    !is_certainly_not && cross(&a.vector.exact(), &b.vector.exact()).iter().all(|c| c.is_zero())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::dyadic::Dyadic;

    #[test]
    fn signs_are_those_of_exact_products() {
        let tiny = f64::from_bits(1);
        let of = |v: [f64; 3]| Filtered::new(v);
        for size in [1.0, 1e200, tiny] {
            let [a, b] = [[size, 0.0, 0.0], [0.0, size, 0.0]].map(of);
            for (z, order) in [(tiny, Ordering::Greater), (0.0, Ordering::Equal), (-tiny, Ordering::Less)] {
                let c = of([3.0, -7.0, z]);
                assert_eq!(sign_of_determinant(&a, &b, &c), order);
                assert_eq!(sign_of_product(&of([1.0, 0.1, -0.1]), &of([z, 0.3, 0.3])), order);
                let by = exact([0.0, 0.0, -z]);
                let [more, less] =
                    [false, true].map(|is_reversed| Filtered::new(Shifted { base: &c, by: &by, is_reversed }));
                assert_eq!(sign_of_determinant(&a, &b, &more), Ordering::Equal);
                assert_eq!(sign_of_determinant(&a, &b, &less), order);
            }
            assert!(are_parallel(&a, &of([-1e9, 0.0, 0.0])) && !are_parallel(&a, &b));
            assert!(!are_parallel(&a, &of([1e300, tiny, 0.0])));
        }
        let long = Filtered::new([1.0, 1e-40, 1e-80].map(Dyadic::from_f64));
        assert_eq!(sign_of_determinant(&long, &long, &of([0.0, 0.0, 1.0])), Ordering::Equal);
    }
}
