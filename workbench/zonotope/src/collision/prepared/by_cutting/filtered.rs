//! Vectors of which the signs of products are decided in one precision after another.

use std::cmp::Ordering;

use crate::numeric::bounded::wide::BoundedWide;
use crate::numeric::bounded::{Bounded, BoundedVector};
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::double_double::Precision;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::ExactVector;
use crate::numeric::linear::{cross, dot};

/// A vector, or a positive multiple of it, in the precisions that are tried.
pub(crate) trait Vector {
    /// The vector in one precision.
    fn over<N: Precision>(&self) -> [N; 3];

    /// The vector, exactly.
    fn exact(&self) -> ExactVector {
        self.over()
    }
}

impl Vector for [f64; 3] {
    fn over<N: Precision>(&self) -> [N; 3] {
        self.map(N::of_double)
    }
}

impl Vector for ExactVector {
    fn over<N: Precision>(&self) -> [N; 3] {
        self.each_ref().map(N::of)
    }
}

impl<V: Vector> Vector for &V {
    fn over<N: Precision>(&self) -> [N; 3] {
        (*self).over()
    }
}

/// A vector with its doubles, which are made once.
pub(crate) struct Filtered<V> {
    rounded: BoundedVector,
    vector: V,
}

impl<V: Vector> Filtered<V> {
    pub(crate) fn new(vector: V) -> Self {
        Self { rounded: vector.over(), vector }
    }

    /// The vector, exactly.
    pub(crate) fn exact(&self) -> ExactVector {
        self.vector.exact()
    }

    /// a · (b × c), a being this vector.
    fn determinant<N: Precision>(&self, b: &Filtered<impl Vector>, c: &Filtered<impl Vector>) -> N {
        dot(&b.product(c), &self.vector.over())
    }

    /// The cross product with another vector.
    fn product<N: Precision>(&self, other: &Filtered<impl Vector>) -> [N; 3] {
        cross(&self.vector.over(), &other.vector.over())
    }
}

/// A vector plus an exact one, or minus it.
pub(crate) struct Shifted<'a, V> {
    pub(crate) base: &'a Filtered<V>,
    pub(crate) by: &'a ExactVector,
    pub(crate) is_reversed: bool,
}

impl<V: Vector> Vector for Shifted<'_, V> {
    fn over<N: Precision>(&self) -> [N; 3] {
        let (base, by) = (self.base.vector.over::<N>(), self.by.over::<N>());
        [0, 1, 2].map(|k| if self.is_reversed { base[k].minus(&by[k]) } else { base[k].plus(&by[k]) })
    }
}

/// The sign of a · (b × c).
pub(crate) fn sign_of_determinant(
    a: &Filtered<impl Vector>,
    b: &Filtered<impl Vector>,
    c: &Filtered<impl Vector>,
) -> Ordering {
    let rounded = dot(&cross(&b.rounded, &c.rounded), &a.rounded).certain_sign();
    let wide = || a.determinant::<BoundedWide>(b, c).certain_sign();
    let in_pairs = || a.determinant::<BoundedDoubleDouble>(b, c).certain_sign();
    rounded.or_else(wide).or_else(in_pairs).unwrap_or_else(|| a.determinant::<Dyadic>(b, c).sign())
}

/// The sign of a · b.
pub(crate) fn sign_of_product(a: &Filtered<impl Vector>, b: &Filtered<impl Vector>) -> Ordering {
    fn along<N: Precision>(a: &Filtered<impl Vector>, b: &Filtered<impl Vector>) -> N {
        dot(&a.vector.over(), &b.vector.over())
    }
    let rounded = dot(&a.rounded, &b.rounded).certain_sign();
    let wide = || along::<BoundedWide>(a, b).certain_sign();
    let in_pairs = || along::<BoundedDoubleDouble>(a, b).certain_sign();
    rounded.or_else(wide).or_else(in_pairs).unwrap_or_else(|| along::<Dyadic>(a, b).sign())
}

/// Whether two vectors are parallel, or one of them is zero.
pub(crate) fn are_parallel(a: &Filtered<impl Vector>, b: &Filtered<impl Vector>) -> bool {
    fn is_certain<N: Precision>(product: [N; 3]) -> bool {
        product.iter().any(|c| c.certain_sign().is_some_and(Ordering::is_ne))
    }
    let is_certainly_not = is_certain::<Bounded>(cross(&a.rounded, &b.rounded))
        || is_certain::<BoundedWide>(a.product(b))
        || is_certain::<BoundedDoubleDouble>(a.product(b))
        || is_certain::<Dyadic>(a.product(b));
    !is_certainly_not
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::exact_linear::exact;

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
