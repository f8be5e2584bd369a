//! The coefficients of a point of a face, exactly: of a segment or a zonogon, of any number of generators.
//!
//! Of parallel generators all but one take 1 or −1. In a plane, let S_1, …, S_k be the sums of the classes of parallel
//! generators, turned into one half plane and sorted by angle, and P_j = S_1 + … + S_j. The zonogon is tiled by
//! parallelograms: that of the classes i < j has the coefficient 1 for the classes before i and after j and −1 for
//! those between. Leaving out the classes after j, which take 1, leaves a zonogon Z_j whose far side is the chain P_0,
//! …, P_j moved and stretched; these zonogons grow with j, so the least j with the point in Z_j is found by bisection,
//! and i is the edge of the chain that the line through the point along S_j meets. O(k log k) exact operations.

use std::cmp::Ordering;

use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, cross, determinant, is_zero};

/// The coefficient of a generator.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Share {
    /// 1 or −1.
    Whole(i8),
    /// A numerator and a positive denominator, their quotient in [−1, 1].
    Ratio(Dyadic, Dyadic),
}

type PlanarVector = [Dyadic; 2];

/// Parallel generators, turned into the half plane above the first axis.
struct Class {
    sum: PlanarVector,
    /// Each generator with its sign when turned and its length along the class, positive.
    members: Vec<(usize, i8, Dyadic)>,
}

/// Coefficients in [−1, 1] with Σ δ_i g_i = `end` / `scale` for a point of that zonotope, of rank at most 2, and a
/// positive scale. At most as many as the rank are no whole numbers, and these belong to independent generators.
pub(super) fn shares(end: &ExactVector, scale: &Dyadic, generators: &[ExactVector]) -> Vec<Share> {
    let mut shares = vec![Share::Whole(1); generators.len()];
    let axes = injective_axes(generators);
    let project = |v: &ExactVector| axes.map(|axis| v[axis].clone());
    let classes = parallel_classes(generators.iter().map(project));
    for (class, share) in classes.iter().zip(class_shares(&project(end), scale, &classes)) {
        class.distribute(&share, &mut shares);
    }
    shares
}

/// Two coordinates in which vectors of a plane, or of a line, have the same linear dependences as in all.
fn injective_axes(generators: &[ExactVector]) -> [usize; 2] {
    let Some(first) = generators.iter().find(|v| !is_zero(v)) else { return [0, 1] };
    let normals = generators.iter().map(|v| cross(first, v));
    let normal = normals.into_iter().find(|normal| !is_zero(normal));
    match normal.and_then(|normal| normal.iter().position(|c| !c.is_zero())) {
        Some(axis) => [(axis + 1) % 3, (axis + 2) % 3],
        None => {
            let axis = first.iter().position(|c| !c.is_zero()).expect("the vector is not zero");
            [axis, (axis + 1) % 3]
        }
    }
}

fn determinant_of(a: &PlanarVector, b: &PlanarVector) -> Dyadic {
    determinant(&[a, b])
}

fn combined(a: &PlanarVector, factor: &Dyadic, b: &PlanarVector) -> PlanarVector {
    [0, 1].map(|k| &a[k] + &(factor * &b[k]))
}

fn parallel_classes(vectors: impl Iterator<Item = PlanarVector>) -> Vec<Class> {
    let is_turned = |v: &PlanarVector| v[1].sign().then(v[0].sign()).is_lt();
    let turned = |v: PlanarVector| if is_turned(&v) { (v.map(|c| -c), -1) } else { (v, 1) };
    let mut turned: Vec<(usize, PlanarVector, i8)> = vectors
        .map(turned)
        .enumerate()
        .filter(|(_, (v, _))| v.iter().any(|c| !c.is_zero()))
        .map(|(index, (v, sign))| (index, v, sign))
        .collect();
    turned.sort_by(|(_, a, _), (_, b, _)| Dyadic::zero().cmp(&determinant_of(a, b)));
    let mut classes: Vec<Class> = Vec::new();
    for (index, vector, sign) in turned {
        // in the half plane above an axis, this is positive for all vectors but those along the axis
        let length = if vector[1].is_zero() { vector[0].clone() } else { vector[1].clone() };
        match classes.last_mut().filter(|class| determinant_of(&class.sum, &vector).is_zero()) {
            Some(class) => {
                class.sum = [0, 1].map(|k| &class.sum[k] + &vector[k]);
                class.members.push((index, sign, length));
            }
            None => classes.push(Class { sum: vector, members: vec![(index, sign, length)] }),
        }
    }
    classes
}

impl Class {
    /// Gives the members coefficients whose sum, weighted by their lengths, is the share of the whole class: from 1
    /// down to −1 one after the other, until the share is met.
    fn distribute(&self, share: &Share, shares: &mut [Share]) {
        let total = self.members.iter().fold(Dyadic::zero(), |sum, (_, _, length)| sum + length.clone());
        let (numerator, denominator) = match share {
            Share::Whole(sign) => (Dyadic::from_f64(f64::from(*sign)), Dyadic::one()),
            Share::Ratio(numerator, denominator) => (numerator.clone(), denominator.clone()),
        };
        // what the sum must lose, times the denominator
        let mut excess = &(&denominator - &numerator) * &total;
        for (index, sign, length) in &self.members {
            let own = length * &denominator;
            let twice = own.clone().scaled(1);
            shares[*index] = if excess.is_zero() {
                Share::Whole(*sign)
            } else if excess >= twice {
                excess = excess - twice;
                Share::Whole(-*sign)
            } else {
                let left = &own - &excess;
                excess = Dyadic::zero();
                Share::Ratio(if *sign < 0 { -left } else { left }, own)
            };
        }
    }
}

/// The coefficient of each class, for a point `end` / `scale` of the zonogon of their sums.
fn class_shares(end: &PlanarVector, scale: &Dyadic, classes: &[Class]) -> Vec<Share> {
    let origin = [Dyadic::zero(), Dyadic::zero()];
    let mut partial = vec![origin];
    for class in classes {
        let last = partial.last().expect("the first sum is there");
        partial.push(combined(last, &Dyadic::one(), &class.sum));
    }
    let count = classes.len();
    let twice = scale.clone().scaled(1);
    // the point, from the corner in which all classes but the first j have the coefficient 1, times twice the scale
    let point = |j: usize| combined(&combined(end, &-scale.clone(), &partial[count]), &twice, &partial[j]);
    let minus_twice = -twice.clone();
    let from_corner = |j: usize, corner: usize| combined(&point(j), &minus_twice, &partial[corner]);
    let holds = |j: usize| {
        let is_left = |i: usize| determinant_of(&classes[i].sum, &from_corner(j, i)).sign() != Ordering::Less;
        if j == 0 { point(0).iter().all(Dyadic::is_zero) } else { (0..j).all(is_left) }
    };
    // the least j with the point in Z_j
    let (mut low, mut high) = (0, count);
    while low < high {
        let middle = low.midpoint(high);
        if holds(middle) { high = middle } else { low = middle + 1 }
    }
    let mut shares = vec![Share::Whole(1); count];
    let Some(last) = high.checked_sub(1) else { return shares };
    let sum = &classes[last].sum;
    let is_passed = |i: &usize| determinant_of(sum, &from_corner(high, i + 1)).sign() != Ordering::Less;
    let Some(first) = (0..last).find(is_passed) else {
        // on the edge along the first class
        let axis = if sum[1].is_zero() { 0 } else { 1 };
        let whole = scale * &sum[axis];
        shares[last] = Share::Ratio(&point(high)[axis] - &whole, whole);
        return shares;
    };
    let (edge, off) = (&classes[first].sum, from_corner(high, first));
    let whole = scale * &determinant_of(edge, sum);
    shares[first] = Share::Ratio(determinant_of(&off, sum) - whole.clone(), whole.clone());
    shares[last] = Share::Ratio(determinant_of(edge, &off) - whole.clone(), whole);
    shares[first + 1..last].fill(Share::Whole(-1));
    shares
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Rational;
    use crate::numeric::exact_linear::exact;
    use proptest::prelude::*;

    fn value(share: &Share) -> Rational {
        match share {
            Share::Whole(sign) => Rational::from(*sign),
            Share::Ratio(numerator, denominator) => numerator.to_rational() / denominator.to_rational(),
        }
    }

    properties! {
        #![proptest_config(crate::property_cases::config(2000))]

        /// Points of zonogons and segments of small integers, many of them on edges and corners, with zero, parallel
        /// and repeated generators.
        #[test]
        fn a_point_of_a_face_is_the_sum_of_its_shares(
            plane in proptest::array::uniform2(proptest::array::uniform3(-2i32..3)),
            terms in proptest::collection::vec((-2i32..3, -2i32..3, -4i32..5), 0..9),
            scale in 1i32..4,
        ) {
            let at = |a: i32, b: i32| [0, 1, 2].map(|k| f64::from(a * plane[0][k] + b * plane[1][k]));
            let generators: Vec<ExactVector> = terms.iter().map(|&(a, b, _)| exact(at(a, b))).collect();
            // Σ (weight / 4) g, times the scale
            let end = terms.iter().fold([0.0; 3], |sum, &(a, b, weight)| {
                let v = at(a, b);
                [0, 1, 2].map(|k| sum[k] + f64::from(scale * weight) / 4.0 * v[k])
            });
            let shares = shares(&exact(end), &Dyadic::from_f64(f64::from(scale)), &generators);
            let mut sum = [0, 1, 2].map(|_| Rational::ZERO);
            for (share, generator) in shares.iter().zip(&generators) {
                let share = value(share);
                prop_assert!(share <= Rational::ONE && share >= Rational::NEG_ONE, "{:?}", shares);
                for (sum, c) in sum.iter_mut().zip(generator) {
                    *sum += &share * c.to_rational();
                }
            }
            let expected = end.map(|c| Dyadic::from_f64(c).to_rational() / Rational::from(scale));
            prop_assert_eq!(sum, expected, "{:?}", shares);
            let broken: Vec<&ExactVector> = generators.iter().zip(&shares)
                .filter(|(_, share)| matches!(share, Share::Ratio(..))).map(|(g, _)| g).collect();
            let is_independent = match broken[..] {
                [] => true,
                [v] => !is_zero(v),
                [v, w] => !is_zero(&cross(v, w)),
                _ => false,
            };
            prop_assert!(is_independent, "{:?}", shares);
        }
    }
}
