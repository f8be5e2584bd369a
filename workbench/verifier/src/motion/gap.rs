//! The gap between two moving bodies along a direction, bounded from below by a polynomial in the time of a stretch.
//!
//! Let d = |q|² for each body, a polynomial that is positive: times d_a d_b and both weights, the gap
//! u · (c_b − c_a) − Σ |u · g| is a polynomial but for the magnitudes, and |Σ x_k B_k| ≤ Σ |x_k| B_k for Bernstein
//! polynomials B_k ≥ 0. Of a hull of corners c the farthest is taken for each k: max_c Σ x_k(c) B_k is at most
//! Σ max_c x_k(c) B_k, and both are equal at the ends of the stretch. With R = R_aᵀ R_b, which d_a d_b makes a
//! polynomial of degree four,
//!
//! | frame | u | u · R_a v | u · R_b v |
//! | --- | --- | --- | --- |
//! | space | u | v · R_aᵀ u | v · R_bᵀ u |
//! | a | R_a u | v · u | v · Rᵀ u |
//! | b | R_b u | v · R u | v · u |
//! | edges | R_a e × R_b f | v · (e × R f) | v · (Rᵀ e × f) |
//!
//! The placements of a stretch may be off the motion: no point by more than the angle times its distance from the axis,
//! and across the axis. Along a direction u that keeps its angle to the axis, a point is off by no more than that times
//! the length of the part of u across the axis. Bodies that have a larger gap as they are placed are disjoint,
//! therefore, where the motion puts them.

use dashu_int::IBig;
use dashu_int::ops::Abs;

use super::answer::MovingDirection;
use super::polynomial::{self, Polynomial, combined, product};
use super::quaternion::{
    Matrix, Quaternion, Vector, conjugate, cross, difference, dot, image, mixed_rotation, multiple, sum,
    transposed_image,
};
use super::root::{ROOT_PLACES, root_above};
use super::stretch::Stretch;
use super::turning::ANGLE_PLACES;
use crate::exact::grid::Grid;

/// A body in units of lengths: a centre, and from there a zonotope or the hull of corners.
#[derive(Debug, Clone)]
pub(super) struct Solid {
    pub(super) center: Vector,
    pub(super) generators: Vec<Vector>,
    pub(super) corners: Vec<Vector>,
    /// A bound of the distances of its points from the axis, in units of 2^-32.
    pub(super) reach: IBig,
}

impl Solid {
    /// The number of generators and corners.
    pub(super) fn size(&self) -> u64 {
        (self.generators.len() + self.corners.len()) as u64
    }

    /// The farthest that the body reaches from its centre along a direction.
    fn farthest(&self, u: &Vector) -> IBig {
        let of_generators: IBig = self.generators.iter().map(|g| dot(u, g).abs()).sum();
        of_generators + self.corners.iter().map(|corner| dot(u, corner)).max().unwrap_or(IBig::ZERO)
    }
}

/// A direction in whole numbers.
pub(super) enum Direction {
    Space(Vector),
    A(Vector),
    B(Vector),
    Edges(Vector, Vector),
}

impl Direction {
    pub(super) fn of(direction: &MovingDirection) -> Self {
        let whole = |v: &[f64; 3]| {
            let grid = Grid::of(*v);
            v.map(|c| grid.units(c))
        };
        match direction {
            MovingDirection::Space(u) => Self::Space(whole(u)),
            MovingDirection::A(u) => Self::A(whole(u)),
            MovingDirection::B(u) => Self::B(whole(u)),
            MovingDirection::Edges([e, f]) => Self::Edges(whole(e), whole(f)),
        }
    }

    /// A bound of its length, in units of 2^-64.
    fn length(&self) -> IBig {
        let length = |v: &Vector| root_above(&dot(v, v));
        match self {
            Self::Space(u) | Self::A(u) | Self::B(u) => length(u) << ROOT_PLACES,
            Self::Edges(e, f) => length(e) * length(f),
        }
    }

    /// The number of directions along which generators are measured.
    pub(super) fn cost(&self) -> u64 {
        if let Self::Space(_) = self { 6 } else { 10 }
    }
}

/// The gap along a direction during a stretch, times a positive polynomial.
pub(super) struct Gap {
    /// A bound from below as the bodies are placed; at the ends of the stretch it is the gap.
    placed: Polynomial,
    /// The positive polynomial.
    scale: Polynomial,
    /// The most that the gap may be less where the motion puts the bodies, in units of 2^-[`MARGIN_PLACES`].
    margin: IBig,
    /// The same at either end of the stretch, where it is less or more by no more than this.
    margins_at_the_ends: [IBig; 2],
}

/// The gap along a direction at the ends of a stretch.
pub(super) enum Ends {
    /// There is a gap at both ends.
    Open,
    /// There is none at one of them.
    Closed,
    /// At one of them the gap is less than the placements are off.
    InDoubt,
}

/// The places after the point of a margin: those of the angle, the reach and the length of the direction.
const MARGIN_PLACES: usize = ANGLE_PLACES + 3 * ROOT_PLACES;

impl Gap {
    /// Whether the bodies are shown to be disjoint during the stretch.
    pub(super) fn is_positive(&self) -> bool {
        if self.margin == IBig::ZERO {
            return polynomial::is_positive(&self.placed);
        }
        let fine: Polynomial = self.placed.iter().map(|c| c << MARGIN_PLACES).collect();
        let margin: Polynomial = self.scale.iter().map(|c| -(c * &self.margin)).collect();
        polynomial::is_positive(&polynomial::sum(&[fine, margin]))
    }

    /// The gap at the ends of the stretch, where the motion puts the bodies.
    pub(super) fn at_the_ends(&self) -> Ends {
        let mut ends = Ends::Open;
        let values = [(self.placed.first(), self.scale.first()), (self.placed.last(), self.scale.last())];
        for ((placed, scale), margin) in values.into_iter().zip(&self.margins_at_the_ends) {
            let (Some(placed), Some(scale)) = (placed, scale) else { return Ends::Closed };
            let (placed, margin) = (placed << MARGIN_PLACES, scale * margin);
            if placed <= -&margin {
                return Ends::Closed;
            }
            if placed <= margin {
                ends = Ends::InDoubt;
            }
        }
        ends
    }
}

/// Polynomials in which a body sees a direction, and by what they are multiplied.
struct Seen {
    directions: Vec<Vector>,
    cofactor: Polynomial,
}

impl Seen {
    /// The sum over the coefficients: `along` of each direction, times the cofactor.
    fn measured(&self, along: impl Fn(&Vector) -> IBig) -> Polynomial {
        let values: Polynomial = self.directions.iter().map(along).collect();
        product(&values, &self.cofactor)
    }
}

/// The bound from above of how far points of both bodies together are off their places, in units of 2^-192.
pub(super) fn displacement([first, second]: [&Solid; 2], [a, b]: [&Stretch; 2]) -> IBig {
    &first.reach * a.angle_off() + &second.reach * b.angle_off()
}

/// The bound from above of how much less the gap along a direction may be where the motion puts the bodies, in units of
/// 2^-[`MARGIN_PLACES`], where its stretches are off by angles. A direction turns as the stretch does here, so that the
/// points alone are off; the library lets it turn as the motion does (its `motion/continuous/parts/margin`).
fn margin(bodies: [&Solid; 2], stretches: [&Stretch; 2], direction: &Direction, angles: [IBig; 2]) -> IBig {
    let of_body = |i: usize| {
        let off = angles[i].clone();
        if off == IBig::ZERO {
            return off;
        }
        let along = match (&stretches[i].axis, direction, i) {
            (Some(axis), Direction::Space(u), _)
            | (Some(axis), Direction::A(u), 0)
            | (Some(axis), Direction::B(u), 1) => axis.across(u),
            _ => direction.length(),
        };
        &bodies[i].reach * off * along
    };
    of_body(0) + of_body(1)
}

/// The gap along a direction during a stretch; of one turn alone, at each of its angles.
pub(super) fn gap(bodies: [&Solid; 2], stretches: [&Stretch; 2], direction: &Direction, is_one_turn: bool) -> Gap {
    let [a, b] = stretches;
    let squares = stretches.map(|stretch| combined(&stretch.turns, &stretch.turns, IBig::ZERO, dot, |a, b| a + b));
    let both = product(&squares[0], &squares[1]);
    let [own, seen_by_a, seen_by_b] = seen(stretches, &squares, &both, direction);
    let path: Vec<Vector> = match (&a.base, &b.base) {
        ([p, _], [q, _]) if a.base[0] == a.base[1] && b.base[0] == b.base[1] => vec![(p, q)],
        ([p, r], [q, s]) => vec![(p, q), (r, s)],
    }
    .into_iter()
    .map(|(from, to)| difference(&multiple(&a.weight, to), &multiple(&b.weight, from)))
    .collect();
    let bases = product(&polynomial::dot(&own.directions, &path), &own.cofactor);
    let arms = [0, 1].map(|i| sum(&multiple(&stretches[i].weight, &bodies[i].center), &stretches[i].arm));
    let of_a = seen_by_a.measured(|u| -(&b.weight * (dot(u, &arms[0]) + &a.weight * bodies[0].farthest(u))));
    let of_b = seen_by_b.measured(|u| {
        let back = u.each_ref().map(|c| -c);
        &a.weight * (dot(u, &arms[1]) - &b.weight * bodies[1].farthest(&back))
    });
    let weight = &a.weight * &b.weight;
    let off_by = |angles: [IBig; 2]| margin(bodies, stretches, direction, angles);
    Gap {
        placed: polynomial::sum(&[bases, of_a, of_b]),
        scale: both.iter().map(|c| c * &weight).collect(),
        margin: off_by(stretches.map(if is_one_turn { Stretch::end_off } else { Stretch::angle_off })),
        margins_at_the_ends: [0, 1].map(|end| off_by(stretches.map(|stretch| stretch.ends_off[end].clone()))),
    }
}

/// The direction in space, and as each body sees it.
fn seen(stretches: [&Stretch; 2], squares: &[Polynomial; 2], both: &Polynomial, direction: &Direction) -> [Seen; 3] {
    let one = || vec![IBig::ONE];
    let with = |directions: Vec<Vector>, cofactor: Polynomial| Seen { directions, cofactor };
    let each = |matrices: &[Matrix], see: &dyn Fn(&Matrix) -> Vector| matrices.iter().map(see).collect::<Vec<_>>();
    let turned = |i: usize| rotations(&stretches[i].turns);
    match direction {
        Direction::Space(u) => {
            let [in_a, in_b] = [0, 1].map(|i| each(&turned(i), &|m| transposed_image(m, u)));
            [with(vec![u.clone()], both.clone()), with(in_a, squares[1].clone()), with(in_b, squares[0].clone())]
        }
        Direction::A(u) => {
            let in_b = each(&relative(stretches), &|m| transposed_image(m, u));
            let in_space = each(&turned(0), &|m| image(m, u));
            [with(in_space, squares[1].clone()), with(vec![u.clone()], both.clone()), with(in_b, one())]
        }
        Direction::B(u) => {
            let in_a = each(&relative(stretches), &|m| image(m, u));
            let in_space = each(&turned(1), &|m| image(m, u));
            [with(in_space, squares[0].clone()), with(in_a, one()), with(vec![u.clone()], both.clone())]
        }
        Direction::Edges(e, f) => {
            let relative = relative(stretches);
            let in_a = each(&relative, &|m| cross(e, &image(m, f)));
            let in_b = each(&relative, &|m| cross(&transposed_image(m, e), f));
            let edges = [each(&turned(0), &|m| image(m, e)), each(&turned(1), &|m| image(m, f))];
            let zero = [IBig::ZERO, IBig::ZERO, IBig::ZERO];
            let in_space = combined(&edges[0], &edges[1], zero, cross, sum);
            [with(in_space, one()), with(in_a, one()), with(in_b, one())]
        }
    }
}

/// |q|² R(q) of a quaternion whose coordinates are polynomials.
fn rotations(turns: &[Quaternion]) -> Vec<Matrix> {
    let zero: Matrix = std::array::from_fn(|_| std::array::from_fn(|_| IBig::ZERO));
    combined(turns, turns, zero, mixed_rotation, |a, b| std::array::from_fn(|i| sum(&a[i], &b[i])))
}

/// d_a d_b R_aᵀ R_b: the rotation of q̄_a q_b.
fn relative([a, b]: [&Stretch; 2]) -> Vec<Matrix> {
    let back: Vec<Quaternion> = a.turns.iter().map(conjugate).collect();
    let zero: Quaternion = std::array::from_fn(|_| IBig::ZERO);
    rotations(&combined(&back, &b.turns, zero, super::quaternion::product, sum))
}

#[cfg(test)]
mod tests {
    use super::super::quaternion::identity;
    use super::*;

    fn vector(v: [i32; 3]) -> Vector {
        v.map(IBig::from)
    }

    /// The stretch of a body that stays where it is, but for angles by which it is off at its ends and between them.
    fn staying(ends_off: [i32; 2], chord: i32) -> Stretch {
        Stretch {
            turns: vec![identity()],
            base: [vector([0; 3]), vector([0; 3])],
            arm: vector([0; 3]),
            weight: IBig::ONE,
            ends_off: ends_off.map(IBig::from),
            chord: IBig::from(chord),
            axis: None,
        }
    }

    /// The cube has the side 2, and its points have a bound of their distances from an axis.
    fn cube(center: [i32; 3], reach: i32) -> Solid {
        let generators = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(vector).to_vec();
        Solid { center: vector(center), generators, corners: Vec::new(), reach: IBig::from(reach) }
    }

    #[test]
    fn a_solid_is_as_large_as_its_generators_and_corners_are_many() {
        let solid = Solid { corners: vec![vector([1, 2, 3]); 4], ..cube([0; 3], 0) };
        assert_eq!((solid.size(), cube([0; 3], 0).size()), (7, 3));
    }

    #[test]
    fn directions_are_bounded_by_their_lengths_and_edges_by_the_product_of_theirs() {
        let (u, e, f) = (vector([3, 4, 0]), vector([0, -4, 3]), vector([0, 5, 12]));
        let of_edges = (Direction::Edges(e, f), 65);
        let of_vectors = [Direction::Space(u.clone()), Direction::A(u.clone()), Direction::B(u)].map(|u| (u, 5));
        for (direction, length) in of_vectors.into_iter().chain([of_edges]) {
            let (bound, exact) = (direction.length(), IBig::from(length) << 64_usize);
            assert!(bound >= exact && bound <= exact + (IBig::ONE << 40_usize), "{length}");
        }
    }

    #[test]
    fn an_end_is_in_doubt_where_its_gap_is_the_margin_exactly() {
        let at_the_ends = |first: i32, last: i32| {
            let scale = vec![IBig::ONE << MARGIN_PLACES];
            let gap = Gap {
                placed: [first, last].map(IBig::from).to_vec(),
                scale,
                margin: IBig::from(5),
                margins_at_the_ends: [IBig::from(5), IBig::from(2)],
            };
            gap.at_the_ends()
        };
        assert!(matches!(at_the_ends(6, 3), Ends::Open));
        assert!(matches!(at_the_ends(5, 3), Ends::InDoubt) && matches!(at_the_ends(6, 2), Ends::InDoubt));
        assert!(matches!(at_the_ends(-4, 3), Ends::InDoubt) && matches!(at_the_ends(6, -1), Ends::InDoubt));
        assert!(matches!(at_the_ends(-5, 3), Ends::Closed) && matches!(at_the_ends(6, -2), Ends::Closed));
    }

    #[test]
    fn points_are_off_by_the_angles_times_their_distances_from_the_axes() {
        // The first body is off by 2 and 3 more between the ends, at the distance 7; the second by 4 and 6, at 11.
        let stretches = [staying([1, 2], 3), staying([4, 0], 6)];
        let solids = [cube([0; 3], 7), cube([0; 3], 11)];
        assert_eq!(displacement(solids.each_ref(), stretches.each_ref()), IBig::from(5 * 7 + 10 * 11));
    }

    #[test]
    fn bodies_that_stay_have_a_gap_of_one_number() {
        let (stays, direction) = (staying([0; 2], 0), Direction::Space(vector([1, 0, 0])));
        let bodies = [cube([0; 3], 0), cube([5, 0, 0], 0)];
        let found = gap(bodies.each_ref(), [&stays; 2], &direction, false);
        assert_eq!((found.placed, found.scale), (vec![IBig::from(3)], vec![IBig::ONE]));
        // A body that goes away by 2 has one gap at the begin and another at the end.
        let goes = Stretch { base: [vector([0; 3]), vector([2, 0, 0])], ..stays.clone() };
        let found = gap(bodies.each_ref(), [&stays, &goes], &direction, false);
        assert_eq!(found.placed, [3, 5].map(IBig::from));
    }
}
