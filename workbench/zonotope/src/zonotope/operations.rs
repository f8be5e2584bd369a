//! Operations under which zonotopes are closed: sums, reflections, linear maps, projections; and the box around one.
//!
//! An operation whose exact result doubles can hold gives it. Otherwise the result encloses the exact one: centre and
//! generators are rounded, and along each coordinate axis one more generator, as long as all that was lost to rounding
//! there, makes up for it.

mod cleanup;

use super::{Zonotope, ZonotopeError};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_sum::ExactSum;
use crate::numeric::linear::dot;
use crate::numeric::outward::{Loss, at_least, at_most};

/// The points with low ≤ x ≤ high in every coordinate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoundingBox<const D: usize> {
    /// The least coordinates.
    pub low: [f64; D],
    /// The greatest coordinates.
    pub high: [f64; D],
}

impl<const D: usize> Zonotope<D> {
    /// The Minkowski sum { a + b }: the sum of the centres and all generators. Encloses it; equal if the sum of the
    /// centres is one of doubles. O(n).
    ///
    /// # Errors
    /// [`ZonotopeError::NonFinite`] if the centre leaves the range of doubles.
    pub fn minkowski_sum(&self, other: &Self) -> Result<Self, ZonotopeError> {
        self.sum_of([self.center(), other.center()], other)
    }

    /// The Minkowski sum with the reflection in the origin, Z1 ⊕ (−Z2) = { a − b }: it holds the origin just when the
    /// bodies meet. The paper calls it Minkowski difference. It is not the erosion Z1 ⊖ Z2 = { x : x + Z2 ⊂ Z1 }, which
    /// need not be a zonotope. Encloses it; equal if the difference of the centres is one of doubles. O(n).
    ///
    /// To decide whether bodies meet use [`Query::between`](crate::collision::Query::between), which rounds nothing.
    ///
    /// # Errors
    /// [`ZonotopeError::NonFinite`] if the centre leaves the range of doubles.
    pub fn minkowski_sum_with_reflection(&self, other: &Self) -> Result<Self, ZonotopeError> {
        self.sum_of([self.center(), other.center().map(|c| -c)], other)
    }

    fn sum_of(&self, centers: [[f64; D]; 2], other: &Self) -> Result<Self, ZonotopeError> {
        let generators = [self.generators(), other.generators()].concat();
        let mut loss = Loss::none();
        let center = loss.round(&exact_sum(centers));
        Self::enclosing_rounded(center, generators, &loss)
    }

    /// The reflection { −x } in the origin, exactly: the generators stay. O(n).
    pub fn reflected(&self) -> Self {
        Self { center: self.center.map(|c| -c), generators: self.generators.clone() }
    }

    /// The body moved by a vector. Encloses it; equal if the moved centre is one of doubles. O(n).
    ///
    /// # Errors
    /// [`ZonotopeError::NonFinite`] if the centre is not finite afterwards.
    pub fn translated(&self, by: [f64; D]) -> Result<Self, ZonotopeError> {
        let finite = |center| Self::new(center, Vec::new()).map(|_| ());
        finite(by)?;
        let mut loss = Loss::none();
        let center = loss.round(&exact_sum([self.center, by]));
        Self::enclosing_rounded(center, self.generators.clone(), &loss)
    }

    /// The image under a linear map, given by its rows: { M x }. Encloses it; equal if all products M c and M g are
    /// vectors of doubles, as for permutations, sign changes, powers of two. O(n) exact products.
    ///
    /// # Errors
    /// [`ZonotopeError`] if an entry of the map is not finite or a coordinate of the result leaves the range of
    /// doubles.
    pub fn linear_image<const E: usize>(&self, rows: &[[f64; D]; E]) -> Result<Zonotope<E>, ZonotopeError> {
        Zonotope::<D>::new([0.0; D], rows.to_vec())?;
        let rows = rows.map(|row| row.map(Dyadic::from_f64));
        let mut loss = Loss::none();
        let mut image = |v: &[f64; D]| {
            let v = v.map(Dyadic::from_f64);
            loss.round(&rows.each_ref().map(|row| dot(row, &v)))
        };
        let center = image(&self.center);
        let generators = self.generators.iter().map(image).collect();
        Zonotope::enclosing_rounded(center, generators, &loss)
    }

    /// The projection to some coordinates, in the order given, exactly; `None` if there is no such coordinate. O(n).
    pub fn projection<const E: usize>(&self, coordinates: [usize; E]) -> Option<Zonotope<E>> {
        let chosen = |v: &[f64; D]| coordinates.map(|c| v[c]);
        coordinates.iter().all(|&c| c < D).then(|| Zonotope {
            center: chosen(&self.center),
            generators: self.generators.iter().map(chosen).collect(),
        })
    }

    /// The smallest box of doubles that holds the body; infinite sides where it leaves the range of doubles. O(n).
    pub fn bounding_box(&self) -> BoundingBox<D> {
        let reach: [Dyadic; D] = std::array::from_fn(|k| {
            let mut sum = ExactSum::default();
            self.generators.iter().for_each(|g| sum.add(g[k].abs()));
            sum.value()
        });
        let center = self.center.map(Dyadic::from_f64);
        BoundingBox {
            low: std::array::from_fn(|k| at_most(&(&center[k] - &reach[k]))),
            high: std::array::from_fn(|k| at_least(&(&reach[k] + &center[k]))),
        }
    }
}

fn exact_sum<const D: usize>([a, b]: [[f64; D]; 2]) -> [Dyadic; D] {
    std::array::from_fn(|k| Dyadic::from_f64(a[k]) + Dyadic::from_f64(b[k]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn body() -> impl Strategy<Value = Zonotope<3>> {
        let coordinate =
            || prop_oneof![-1.0..1.0f64, (-3i8..4).prop_map(f64::from), -1e16..1e16f64, -1e-300..1e-300f64];
        let vector = move || [coordinate(), coordinate(), coordinate()];
        (vector(), proptest::collection::vec(vector(), 0..5))
            .prop_map(|(center, generators)| Zonotope::new(center, generators).expect("finite"))
    }

    fn direction() -> impl Strategy<Value = [f64; 3]> {
        [-2i8..3, -2i8..3, -2i8..3].prop_map(|u| u.map(f64::from))
    }

    fn height<const D: usize>(body: &Zonotope<D>, u: [f64; D]) -> Dyadic {
        body.support(u).exact_value
    }

    #[test]
    fn results_that_fit_are_exact() {
        let a = Zonotope::new([1.0, 2.0], vec![[1.0, 0.0]]).expect("finite");
        let b = Zonotope::new([5.0, -2.0], vec![[0.0, 3.0]]).expect("finite");
        let sum = Zonotope::new([6.0, 0.0], vec![[1.0, 0.0], [0.0, 3.0]]).expect("finite");
        assert_eq!(a.minkowski_sum(&b), Ok(sum));
        assert_eq!(a.minkowski_sum_with_reflection(&b).expect("finite").center(), [-4.0, 4.0]);
        assert_eq!(a.translated([0.5, 0.5]).expect("finite").generators(), a.generators());
        let turned = a.linear_image(&[[0.0, -1.0], [1.0, 0.0], [2.0, 2.0]]).expect("finite");
        assert_eq!((turned.center(), turned.generators()), ([-2.0, 1.0, 6.0], &[[0.0, 1.0, 2.0]][..]));
        assert_eq!(turned.projection([2, 0]).map(|p| p.center()), Some([6.0, -2.0]));
        assert_eq!(turned.projection([3]), None);
        assert_eq!(a.bounding_box(), BoundingBox { low: [0.0, 2.0], high: [2.0, 2.0] });
    }

    #[test]
    fn what_leaves_the_range_is_refused_or_infinite() {
        let huge = Zonotope::new([f64::MAX], vec![[f64::MAX]]).expect("finite");
        assert!(huge.minkowski_sum(&huge).is_err() && huge.translated([f64::NAN]).is_err());
        assert!(huge.linear_image(&[[f64::INFINITY]]).is_err() && huge.linear_image(&[[2.0]]).is_err());
        assert_eq!(huge.bounding_box(), BoundingBox { low: [0.0], high: [f64::INFINITY] });
    }

    properties! {
        #[test]
        fn results_enclose_the_exact_ones(a in body(), b in body(), u in direction(), by in direction()) {
            let minus = u.map(|c| -c);
            prop_assert!(height(&a.minkowski_sum(&b).expect("finite"), u) >= height(&a, u) + height(&b, u));
            let difference = a.minkowski_sum_with_reflection(&b).expect("finite");
            prop_assert!(height(&difference, u) >= height(&a, u) + height(&b, minus));
            prop_assert_eq!(height(&a.reflected(), u), height(&a, minus));
            let shift = by.iter().zip(u).fold(Dyadic::zero(), |s, (a, b)| s + Dyadic::from_f64(a * b));
            prop_assert!(height(&a.translated(by).expect("finite"), u) >= height(&a, u) + shift);
            let rows = [[0.1, 0.2, -0.3], [1.0, 3.0, 0.0], [0.7, 0.0, 1e-3]];
            // h of M Z in direction u is h of Z in direction Mᵀ u, computed here without rounding
            let back: [Dyadic; 3] = std::array::from_fn(|k| {
                (0..3).fold(Dyadic::zero(), |s, i| s + Dyadic::from_f64(rows[i][k]) * Dyadic::from_f64(u[i]))
            });
            let along =
                |v: &[f64; 3]| v.iter().zip(&back).fold(Dyadic::zero(), |s, (c, b)| s + &Dyadic::from_f64(*c) * b);
            let exact = a.generators().iter().fold(along(&a.center()), |s, g| s + along(g).abs());
            let image = a.linear_image(&rows).expect("finite");
            prop_assert!(height(&image, u) >= exact);
            prop_assert!(image.generators().len() <= a.generators().len() + 3);
        }

        #[test]
        fn boxes_are_the_tightest_of_doubles(a in body()) {
            let BoundingBox { low, high } = a.bounding_box();
            for k in 0..3 {
                let mut axis = [0.0; 3];
                axis[k] = 1.0;
                let top = height(&a, axis);
                prop_assert!(Dyadic::from_f64(high[k]) >= top && Dyadic::from_f64(high[k].next_down()) < top);
                let bottom = -height(&a.reflected(), axis);
                prop_assert!(Dyadic::from_f64(low[k]) <= bottom && Dyadic::from_f64(low[k].next_up()) > bottom);
            }
        }
    }
}
