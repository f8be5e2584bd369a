//! The directions of generators: zero generators left out, parallel ones together, decided exactly. The folder has the
//! faces of a cube, which meet every line through the origin.

pub(crate) mod cube_faces;

use std::cmp::Ordering;

use crate::numeric::dyadic::Dyadic;
use crate::numeric::non_finite::NonFinite;
use crate::numeric::orientation::{Turn, cross_sign};

/// A generator in its class of parallel ones.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Member {
    /// Which generator, from 0.
    pub generator: usize,
    /// Whether it points against the representative of the class.
    pub reversed: bool,
}

/// The classes of parallel nonzero generators, sorted by direction: a body's shape depends on these and on the sum of
/// each class alone.
#[derive(Debug, Clone, PartialEq)]
pub struct Directions<const D: usize> {
    generators: Vec<[f64; D]>,
    members: Vec<Member>,
    starts: Vec<usize>,
}

impl<const D: usize> Directions<D> {
    /// The classes of some generators. O(n log n) exact comparisons.
    ///
    /// # Errors
    /// [`NonFinite`] names the first coordinate that is not finite.
    pub fn new(generators: &[[f64; D]]) -> Result<Self, NonFinite> {
        NonFinite::check_list("generator", generators)?;
        Ok(Self::of_finite(generators))
    }

    /// The classes of generators whose coordinates are known to be finite.
    pub(crate) fn of_finite(generators: &[[f64; D]]) -> Self {
        let upward = |g: &[f64; D]| g.iter().find(|&&c| c != 0.0).is_some_and(|&c| c > 0.0);
        let nonzero = generators.iter().enumerate().filter(|(_, g)| g.iter().any(|&c| c != 0.0));
        let mut turned: Vec<([f64; D], Member)> = nonzero
            .map(|(generator, g)| {
                let reversed = !upward(g);
                (if reversed { g.map(|c| -c) } else { *g }, Member { generator, reversed })
            })
            .collect();
        turned.sort_by(|a, b| compare_directions(&a.0, &b.0));
        let mut directions =
            Self { generators: Vec::new(), members: Vec::with_capacity(turned.len()), starts: vec![0] };
        for (vector, member) in turned {
            let same = directions.generators.last().is_some_and(|last| compare_directions(last, &vector).is_eq());
            if !same {
                directions.generators.push(vector);
                directions.starts.push(directions.members.len());
            }
            directions.members.push(member);
            *directions.starts.last_mut().expect("the first start is there") = directions.members.len();
        }
        directions
    }

    /// How many classes there are.
    pub fn len(&self) -> usize {
        self.generators.len()
    }

    /// Whether every generator is zero.
    pub fn is_empty(&self) -> bool {
        self.generators.is_empty()
    }

    /// For each class, its first generator, turned so that its first nonzero coordinate is positive.
    pub fn representatives(&self) -> &[[f64; D]] {
        &self.generators
    }

    /// The generators of a class.
    ///
    /// # Panics
    /// If there is no such class: the number is not below [`len`](Self::len).
    pub fn members(&self, class: usize) -> &[Member] {
        &self.members[self.starts[class]..self.starts[class + 1]]
    }

    /// The sum of a class, every member turned like the representative: half of the edges along this direction.
    /// `generators` are those that the classes were made of.
    ///
    /// # Panics
    /// If there is no such class, or the generators are others: too few, or not finite.
    pub fn exact_sum(&self, class: usize, generators: &[[f64; D]]) -> [Dyadic; D] {
        let mut sum = std::array::from_fn(|_| Dyadic::zero());
        for member in self.members(class) {
            for (total, &c) in sum.iter_mut().zip(&generators[member.generator]) {
                *total = &*total + &Dyadic::from_f64(if member.reversed { -c } else { c });
            }
        }
        sum
    }
}

/// The order of two directions whose first nonzero coordinates are positive: equal just when they are parallel.
fn compare_directions<const D: usize>(a: &[f64; D], b: &[f64; D]) -> Ordering {
    let first = |v: &[f64; D]| v.iter().position(|&c| c != 0.0).unwrap_or(D);
    let (i, j) = (first(a), first(b));
    if i != j {
        return i.cmp(&j);
    }
    let origin = [0.0, 0.0];
    // with positive leading coordinates, the sign of the cross product is that of the difference of the slopes
    let slope = |k: usize| Turn::sign(cross_sign(origin, [b[i], b[k]], origin, [a[i], a[k]]));
    (i + 1..D).map(slope).find(|order| order.is_ne()).unwrap_or(Ordering::Equal)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn parallel_generators_meet_in_one_class() {
        let generators = [[0.0, -2.0, 0.0], [1.0, 2.0, 3.0], [0.0, 0.0, 0.0], [-0.5, -1.0, -1.5], [0.0, 1e-300, 0.0]];
        let directions = Directions::of_finite(&generators);
        assert_eq!(directions.representatives(), [[1.0, 2.0, 3.0], [0.0, 2.0, 0.0]]);
        assert_eq!(
            directions.members(0),
            [Member { generator: 1, reversed: false }, Member { generator: 3, reversed: true }]
        );
        assert_eq!(directions.exact_sum(0, &generators).map(|c| c.to_f64()), [1.5, 3.0, 4.5]);
        assert_eq!(directions.members(1).len(), 2);
        assert!(Directions::of_finite(&[[0.0]; 3]).is_empty());
    }

    #[test]
    fn generators_that_are_not_finite_are_refused() {
        let refused = Directions::new(&[[0.0, 1.0], [1.0, f64::NAN]]).expect_err("NaN is no coordinate");
        assert_eq!(refused.to_string(), "generator 1, coordinate 1 is NaN, not a finite number");
        assert!(Directions::new(&[[f64::INFINITY]]).is_err());
    }

    properties! {
        #[test]
        fn classes_are_those_of_vanishing_minors(
            generators in proptest::collection::vec([-2i8..3, -2i8..3, -2i8..3, -2i8..3], 0..12),
            exponents in proptest::collection::vec(-1000i64..1000, 12),
        ) {
            let scaled: Vec<[f64; 4]> = generators.iter().zip(exponents)
                .map(|(g, e)| g.map(|c| crate::numeric::scaling::scale_by_power_of_two(f64::from(c), e))).collect();
            let directions = Directions::of_finite(&scaled);
            let mut class_of = vec![usize::MAX; generators.len()];
            for class in 0..directions.len() {
                for member in directions.members(class) {
                    class_of[member.generator] = class;
                }
            }
            for (i, a) in generators.iter().enumerate() {
                prop_assert_eq!(class_of[i] == usize::MAX, *a == [0; 4]);
                for (j, b) in generators.iter().enumerate() {
                    let minors = (0..4).all(|k| (0..k).all(|l| a[k] * b[l] == a[l] * b[k]));
                    let parallel = minors && *a != [0; 4] && *b != [0; 4];
                    prop_assert_eq!(parallel, class_of[i] == class_of[j] && class_of[i] != usize::MAX);
                }
            }
        }
    }
}
