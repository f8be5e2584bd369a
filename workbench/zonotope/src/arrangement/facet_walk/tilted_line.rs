//! The dual line of any nonzero generator, in a plane tilted by less than anything that doubles can tell apart.
//!
//! The generator (a, b, c) has the line a x + b y + c = 0, which has no slope if b = 0. The sheared generator
//!
//! ```text
//! (a + δ³ c, b + δ a + δ² c, c)
//! ```
//!
//! has a slope for every small δ > 0 unless it is zero, and a shear of determinant 1 changes no determinant of three
//! generators: faces are the same. So a walk runs on the lines of sheared generators, with a δ so small that no double
//! has a say against it; no coordinate is ever computed. With c = u × v the comparisons of two generators are those of
//! the first one that is not zero of
//!
//! - b, a, c of one generator: whether it points up, the sheared b > 0;
//! - −c_z, c_y, c_x: the order of the slopes, as c · (δ³, δ² − δ⁴, −1), the vertical direction of the sheared plane.
//!
//! Only parallel generators have one slope: no two of the lines are parallel, and none is vertical, not even the line
//! at infinity. The products of doubles of which the terms with one power of δ consist are multiples of 2^-5370 below
//! 2^5130, so δ = 2^-16384 is small enough: there the lines are ordinary ones with exact coefficients.

use std::cmp::Ordering;

use crate::arrangement::dynamic_hull::{Direction, Site};
use crate::numeric::bounded;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::exact;
use crate::numeric::linear::{Ring, cross, dot};
use crate::numeric::orientation::in_space::determinant_sign_of_rows;
use crate::numeric::orientation::{Turn, cross_sign};

/// The binary exponent of δ.
const TILT_EXPONENT: i64 = -16384;

/// The line of a generator, which is turned to point up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct TiltedLine {
    generator: [f64; 3],
}

/// Whether a generator points up in the sheared plane; `None` of a zero one.
pub(super) fn points_up(generator: [f64; 3]) -> Option<bool> {
    let [a, b, c] = generator;
    [b, a, c].into_iter().find(|&coordinate| coordinate != 0.0).map(|coordinate| coordinate > 0.0)
}

/// The first sign that is not zero.
fn leading(signs: impl IntoIterator<Item = Ordering>) -> Ordering {
    signs.into_iter().find(|sign| sign.is_ne()).unwrap_or(Ordering::Equal)
}

impl TiltedLine {
    /// The line of a generator; `None` of a zero one.
    pub(super) fn of(generator: [f64; 3]) -> Option<Self> {
        let is_up = points_up(generator)?;
        Some(Self { generator: if is_up { generator } else { generator.map(|c| -c) } })
    }

    /// The generator, turned to point up.
    #[inline]
    pub(super) fn upward(&self) -> &[f64; 3] {
        &self.generator
    }

    /// The sign of the coordinate k of the cross product of two generators.
    #[inline]
    fn cross_sign(&self, other: &Self, k: usize) -> Ordering {
        let part = |line: &Self| [(k + 1) % 3, (k + 2) % 3].map(|axis| line.generator[axis]);
        cross_sign([0.0; 2], part(self), [0.0; 2], part(other)).sign()
    }
}

impl Site for TiltedLine {
    #[inline]
    fn order(&self, other: &Self) -> Ordering {
        self.abscissa_order(other)
    }

    #[inline]
    fn abscissa_order(&self, other: &Self) -> Ordering {
        let by_slope = self.cross_sign(other, 2).reverse();
        by_slope.then_with(|| self.cross_sign(other, 1)).then_with(|| self.cross_sign(other, 0))
    }

    /// The dual point is (−a − δ³ c, −c, b + δ a + δ² c): c · (q, 0, −p), then −c · (0, δ q, 0), then what p adds.
    fn order_along(&self, other: &Self, direction: Direction) -> Ordering {
        let [p, q] = direction.vector();
        let plain = determinant_sign_of_rows(&self.generator, &other.generator, &[q, 0.0, -p]);
        let times_p = |sign: Ordering| match p {
            0.0 => Ordering::Equal,
            _ if p < 0.0 => sign.reverse(),
            _ => sign,
        };
        plain.then_with(|| self.cross_sign(other, 1).reverse()).then_with(|| times_p(self.cross_sign(other, 0)))
    }

    #[inline]
    fn turn(a: &Self, b: &Self, c: &Self) -> Turn {
        #[cfg(test)]
        super::tests::count_turn();
        Turn::from(determinant_sign_of_rows(&b.generator, &a.generator, &c.generator))
    }

    fn crossing_order(first: [&Self; 2], second: [&Self; 2], at: &Self) -> Ordering {
        #[cfg(test)]
        super::tests::count_turn();
        let rounded = |line: &Self| bounded::exact(line.generator);
        let (far, [_, _, slope]) = crossing(first.map(rounded), second.map(rounded), &rounded(at));
        match [far, slope].map(|value| value.sign()) {
            [Some(far), Some(slope)] => 0.cmp(&(far * slope)),
            _ => exact_crossing_order(first, second, at),
        }
    }

    fn homogeneous(&self) -> [Dyadic; 3] {
        let [a, b, c] = exact(self.generator);
        let tilted = |v: &Dyadic, power: i64| v.clone().scaled(power * TILT_EXPONENT);
        [-(&a + &tilted(&c, 3)), -c.clone(), b + tilted(&a, 1) + tilted(&c, 2)]
    }
}

#[cold]
#[inline(never)]
fn exact_crossing_order(first: [&TiltedLine; 2], second: [&TiltedLine; 2], at: &TiltedLine) -> Ordering {
    let exact = |line: &TiltedLine| exact(line.generator);
    let (far, order) = crossing(first.map(exact), second.map(exact), &exact(at));
    let [x, y, z] = order.map(|coordinate| coordinate.sign());
    let order = leading([z.reverse(), y, x]);
    if far.sign().is_lt() { order.reverse() } else { order }
}

/// A number with the sign of the third coordinate of the crossing of two lines, and the cross product of that crossing
/// with `at`, of which the order of the abscissas is the [leading] sign.
///
/// With d_k = det(p_1, p_2, q_k) the lines p_1 p_2 and q_1 q_2 of dual points meet in d_2 q_1 − d_1 q_2.
#[inline]
fn crossing<T: Ring>(first: [[T; 3]; 2], second: [[T; 3]; 2], at: &[T; 3]) -> (T, [T; 3]) {
    let line = cross(&first[0], &first[1]);
    let [near, far] = [0, 1].map(|k| dot(&line, &second[k]));
    let point = [0, 1, 2].map(|k| far.times(&second[0][k]).minus(&near.times(&second[1][k])));
    let order = cross(&point, at);
    (far, order)
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::arrangement::dynamic_hull::brute_force::BruteForce;
    use crate::arrangement::dynamic_hull::{DynamicChain, HullChain, Side, SiteIndex, SortedSites, Towards};
    use proptest::prelude::*;

    fn generator() -> impl Strategy<Value = [f64; 3]> {
        let coordinate = || prop_oneof![4 => (-1i32..2).prop_map(f64::from), 1 => -1.0..1.0f64, 1 => Just(1e-300)];
        [coordinate(), coordinate(), coordinate()].prop_filter("nonzero", |v| *v != [0.0; 3])
    }

    #[test]
    fn only_parallel_generators_have_one_line() {
        let rows = [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 1.0], [0.0, 1.0, 1.0]];
        let lines = rows.map(|row| TiltedLine::of(row).expect("not zero"));
        for (a, row) in lines.iter().zip(rows) {
            assert_eq!(TiltedLine::of(row.map(|c| -3.0 * c)).map(|line| line.order(a)), Some(Ordering::Equal));
            assert!(a.homogeneous()[2].sign().is_gt());
            assert_eq!(lines.iter().filter(|b| a.abscissa_order(b).is_eq()).count(), 1);
        }
        assert_eq!(TiltedLine::of([0.0; 3]), None);
    }

    properties! {
        #![proptest_config(crate::property_cases::config(24))]

        #[test]
        fn chains_are_those_of_the_exact_coordinates(
            rows in prop::collection::vec(generator(), 1..7),
            toggled in prop::collection::vec((0usize..7, (-2i32..3, 1i32..3)), 1..7),
        ) {
            let lines: Vec<TiltedLine> = rows.into_iter().filter_map(TiltedLine::of).collect();
            let sites = Arc::new(SortedSites::new(&lines).expect("few"));
            for side in [Side::Lower, Side::Upper] {
                let all = (0..lines.len() as u32).map(SiteIndex);
                let mut fast = DynamicChain::new(sites.clone(), side, all.clone()).expect("distinct");
                let mut truth = BruteForce::new(sites.clone(), side, all).expect("distinct");
                for &(k, (p, q)) in &toggled {
                    let site = SiteIndex((k % lines.len()) as u32);
                    let chains: [&mut dyn HullChain<TiltedLine>; 2] = [&mut fast, &mut truth];
                    for chain in chains {
                        let update = if chain.contains(site) { chain.delete(site) } else { chain.insert(site) };
                        update.expect("a site is toggled");
                    }
                    prop_assert_eq!(fast.vertices(), truth.vertices());
                    let direction = Direction::new([f64::from(p), f64::from(q)]).expect("upward");
                    prop_assert_eq!(fast.extreme(direction), truth.extreme(direction));
                    for towards in [Towards::Left, Towards::Right] {
                        let from = &lines[(k + 1) % lines.len()];
                        prop_assert_eq!(fast.tangent(from, towards), truth.tangent(from, towards));
                    }
                }
            }
        }
    }
}
