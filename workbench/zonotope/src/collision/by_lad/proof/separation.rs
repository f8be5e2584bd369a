//! Separating directions: that of a rounded optimum, where it leaves room for every rounding error, else doubles near
//! an exact direction.

use crate::collision::Separation;
use crate::lad::of_generators::certify::rounded_optimum::RoundedOptimum;
use crate::lad::of_generators::exact::direction_signs::DirectionSigns;
use crate::lad::of_generators::generators::KernelQuery;
use crate::numeric::bounded::{Bounded, BoundedVector};
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, cross, difference, dot, exact, multiple, negated, rounded_direction};
use crate::numeric::signed_sum::signed_sum;

/// Multiples of the direction that are rounded in turn: each multiple has its coordinates rounded differently.
const MULTIPLES: [f64; 8] = [1.0, 1.1, 1.3, 1.5, 1.7, 1.2, 1.4, 1.6];

/// The direction of the facet in doubles: rounding it by e takes at most e · (Σ |v|_1 + |p|_1) off the gap, |v|_1 < 2
/// |v|.
pub(super) fn in_doubles(optimum: &RoundedOptimum, p: &BoundedVector) -> Option<Separation<3>> {
    let error = optimum.direction.iter().fold(0.0f64, |m, c| m.max(c.error));
    let size: f64 = p.iter().map(|c| c.magnitude()).sum();
    let gap = optimum.along - optimum.support();
    let lost = Bounded::exact(error) * (Bounded::exact(4.0 * optimum.magnitude) + Bounded::exact(2.0 * size));
    let direction = optimum.direction.map(|c| c.value);
    (gap - lost).is_positive().then_some(Separation::Rounded(direction))
}

/// The proof from an exact direction u with u · p > h(u); `basis` has the generators to which u is known to be
/// orthogonal.
pub(crate) fn separation(
    query: &dyn KernelQuery,
    p: &ExactVector,
    direction: &ExactVector,
    basis: &[usize],
) -> Separation<3> {
    let normal = match *basis {
        [first, second] => {
            let [first, second] = [first, second].map(|b| query.exact_generator(b));
            let normal = cross(&first, &second);
            // the same direction in smaller numbers: of integers, perhaps, that are doubles
            if dot(&normal, p).sign().is_lt() { negated(normal) } else { normal }
        }
        _ => direction.clone(),
    };
    let longest = (0..3).max_by_key(|&axis| normal[axis].clone().abs()).expect("there are three axes");
    let [x, y, z] = [0, 1, 2].map(|i| normal[i].rounded_ratio(&normal[longest].clone().abs()));
    let pairs = p.each_ref().map(BoundedDoubleDouble::of);
    let candidates = MULTIPLES.iter().map(|&factor| rounded_direction(&multiple(&Dyadic::from_f64(factor), &normal)));
    candidates
        .chain([[x, y, z]])
        .chain(neighbours([x, y, z]))
        .find(|&u| seems_to_separate(query, &pairs, u).unwrap_or_else(|| separates(query, p, u)))
        .map_or_else(|| Separation::Exact(Box::new(direction.clone().map(|v| v.to_rational()))), Separation::Rounded)
}

/// The directions in which one or more coordinates are moved to a neighbouring double.
fn neighbours(u: [f64; 3]) -> impl Iterator<Item = [f64; 3]> {
    let step = |value: f64, step: i32| match step {
        0 => value,
        1 => value.next_up(),
        _ => value.next_down(),
    };
    (0..27).filter(|&code| code != 13).map(move |code| {
        let steps = [code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1];
        [0, 1, 2].map(|i| step(u[i], steps[i]))
    })
}

/// Whether u · p > h(u), where pairs of doubles tell. O(n).
fn seems_to_separate(query: &dyn KernelQuery, p: &[BoundedDoubleDouble; 3], u: [f64; 3]) -> Option<bool> {
    let query = query.as_query()?;
    let u = u.map(BoundedDoubleDouble::exact);
    let product = |v: [BoundedDoubleDouble; 3]| v[0] * u[0] + v[1] * u[1] + v[2] * u[2];
    let reaches = query.generators().map(|v| product(v.map(BoundedDoubleDouble::exact)).abs());
    let reach = reaches.fold(BoundedDoubleDouble::exact(0.0), |sum, term| sum + term);
    (product(*p) - reach).sign().map(|sign| sign > 0)
}

/// Whether u · p > h(u), exactly. O(n).
pub(crate) fn separates(query: &dyn KernelQuery, p: &ExactVector, u: [f64; 3]) -> bool {
    if !u.iter().all(|c| c.is_finite()) {
        return false;
    }
    let direction = exact(u);
    let Some(query) = query.as_query() else {
        let sum = query.signed_sum(&DirectionSigns::new(query, &direction).all(&direction));
        return dot(&difference(p, &sum), &direction).sign().is_gt();
    };
    let signed = query.generators().map(|&v| (v, side(v, u, &direction)));
    dot(&difference(p, &signed_sum(signed)), &direction).sign().is_gt()
}

/// The sign of v · u.
fn side(v: [f64; 3], u: [f64; 3], direction: &ExactVector) -> i8 {
    let [x, y, z] = [v[0] * u[0], v[1] * u[1], v[2] * u[2]];
    let (value, size) = (x + y + z, x.abs() + y.abs() + z.abs());
    // five roundings and, where a product is denormal, its absolute error
    if value.abs() > 8.0 * f64::EPSILON * size + f64::MIN_POSITIVE {
        return if value > 0.0 { 1 } else { -1 };
    }
    dot(&exact(v), direction).sign() as i8
}
