//! Whether a zonotope contains another one, from the definition in rationals: the truth the reductions are held to.
//!
//! # Statement
//! Input: two zonotopes in R^D, any centres. Output: whether every point of the inner one lies in the outer one. Flat
//! bodies, bodies without generators, zero and parallel generators are ordinary input; touching is containment.
//!
//! # Source
//! A zonotope that spans its space is the intersection of the half-spaces of its facets, and each facet normal is
//! orthogonal to D − 1 independent generators.
//!
//! # Method
//! 1. The difference of the centres and every inner generator must lie in the span of the outer generators.
//! 2. In coordinates of that span, r of them, for each r − 1 independent outer generators with normal u:
//!    |u · c| + Σ |u · v| ≤ Σ |u · b|.
//!
//! # Complexity
//! O(C(k, r − 1) (n + k) D) rational operations for k outer and n inner generators.
//!
//! # Shapes
//! `generators`: half-segments, any order; k up to about 20, n up to about 100.
//!
//! # Numerics
//! Everything is exact.
//!
//! # Checked by
//! Hand-worked examples; its simplicity.
//!
//! # Example
//! ```
//! use zonotope::{Zonotope, reduction::brute_force::contains};
//! let square = Zonotope::new([0.0, 0.0], vec![[1.0, 0.0], [0.0, 1.0]])?;
//! let diamond = Zonotope::new([0.0, 0.0], vec![[0.5, 0.5], [0.5, -0.5]])?;
//! assert!(contains(&square, &diamond) && !contains(&diamond, &square));
//! # Ok::<(), zonotope::ZonotopeError>(())
//! ```

use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{Span, exact, hyperplane_normal, sum_of_products};
use crate::numeric::subsets::for_each_subset;
use crate::zonotope::Zonotope;

/// Whether the outer zonotope contains the inner one.
pub fn contains<const D: usize>(outer: &Zonotope<D>, inner: &Zonotope<D>) -> bool {
    let [from, to] = [inner.center(), outer.center()].map(exact);
    let displacement: Vec<Dyadic> = from.iter().zip(&to).map(|(a, b)| a - b).collect();
    let span = Span::of_doubles(outer.generators());
    let own = inner.generators().iter().map(|v| exact(*v).to_vec()).chain([displacement]);
    let own: Vec<Vec<Dyadic>> = own.filter(|v| v.iter().any(|c| !c.is_zero())).collect();
    if own.iter().any(|v| span.direction_to(v).is_some()) {
        return false;
    }
    let projected = |v: &Vec<Dyadic>| -> Vec<Rational> { span.project(v).iter().map(Dyadic::to_rational).collect() };
    let own: Vec<Vec<Rational>> = own.iter().map(projected).collect();
    let others: Vec<Vec<Rational>> = outer.generators().iter().map(|v| projected(&exact(*v).to_vec())).collect();
    if span.rank() == 0 {
        return true;
    }
    let reach = |vectors: &[Vec<Rational>], normal: &[Rational]| {
        let products = vectors.iter().map(|v| sum_of_products(v, normal));
        products.fold(Rational::ZERO, |sum, p| if p < Rational::ZERO { sum - p } else { sum + p })
    };
    let mut holds = true;
    for_each_subset(others.len(), span.rank() - 1, |chosen| {
        if holds {
            let rows: Vec<&Vec<Rational>> = chosen.iter().map(|&index| &others[index]).collect();
            let normal = hyperplane_normal(&rows);
            holds = reach(&own, &normal) <= reach(&others, &normal);
        }
    });
    holds
}

#[cfg(test)]
mod tests {
    use super::*;

    fn body<const D: usize>(center: [f64; D], generators: &[[f64; D]]) -> Zonotope<D> {
        Zonotope::new(center, generators.to_vec()).unwrap()
    }

    #[test]
    fn flat_and_displaced_bodies() {
        let segment = body([0.0; 2], &[[2.0, 2.0], [1.0, 1.0]]);
        assert!(contains(&segment, &body([1.0, 1.0], &[[2.0, 2.0]])));
        assert!(!contains(&segment, &body([1.0, 1.0], &[[2.5, 2.5]])));
        assert!(!contains(&segment, &body([0.0; 2], &[[0.5, 0.5f64.next_up()]])));
        let point = body([1.0, 2.0], &[[0.0; 2]]);
        assert!(contains(&point, &point) && !contains(&point, &segment) && !contains(&segment, &point));
        assert!(contains(&body([0.0], &[[2.0], [-1.0]]), &body([1.0], &[[2.0]])));
        assert!(!contains(&body([0.0], &[[2.0], [-1.0]]), &body([1.0], &[[2f64.next_up()]])));
    }

    #[test]
    fn touching_is_containment() {
        let cube = body([0.0; 3], &[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
        let inner = [[0.5, 0.5, 0.5], [0.5, -0.5, 0.0], [0.0, 0.0, 0.5]];
        assert!(contains(&cube, &body([0.0; 3], &inner)));
        let mut longer = inner;
        longer[2][2] = 0.5f64.next_up();
        assert!(!contains(&cube, &body([0.0; 3], &longer)));
    }
}
