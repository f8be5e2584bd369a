//! The point of the upper hull above or below a point p: the binary search over separators, and the facet that it ends
//! in.

use std::cmp::Ordering;

use rand_pcg::Pcg64Mcg;

use super::chain::{Chain, Crossing, Target};
use crate::arrangement::DualArrangement;
use crate::arrangement::dual::Upward;
use crate::arrangement::fraction::Fraction;
use crate::arrangement::slope_selection::randomized::select;
use crate::arrangement::slope_selection::slab::Slab;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, dot, exact};
use crate::tally::Tally;

/// The facet of the upper hull over p_0, or an edge or vertex of it.
#[derive(Debug)]
pub(super) struct Footing {
    /// The separators on both sides of the facet, and where they are at the height of p_0.
    pub(super) sides: [(Chain, Crossing); 2],
    /// A normal u of the facet, u_z > 0, exactly.
    pub(super) normal: ExactVector,
    /// h(u) − u · p: u_z times how far p is below the facet.
    pub(super) depth: Dyadic,
}

/// Where p_0 lies relative to the tiles at a vertical line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// Left of the chain just left of the line.
    Left,
    /// Between the chains just left and just right of the line: in a tile whose vertex is on it.
    Within,
    /// Right of the chain just right of the line.
    Right,
}

/// A vertical line of the search, as it is recorded.
pub(super) struct Probe<'a> {
    pub(super) x: &'a Fraction,
    pub(super) tiles_before: u64,
    pub(super) tiles_after: u64,
    pub(super) side: Side,
    /// The chains just left and just right of the line.
    pub(super) chains: [&'a Chain; 2],
}

impl Footing {
    /// Searches the facet over a point whose p_0 lies in Q; `record` sees every vertical line. O(n log² n).
    pub(super) fn search(
        target: &Target,
        dual: &DualArrangement,
        random: &mut Pcg64Mcg,
        tally: &mut impl Tally,
        record: &mut impl FnMut(&Probe<'_>),
    ) -> Self {
        let lines = dual.lines();
        let mut slab = Slab::whole(lines);
        loop {
            let tiles_before = slab.vertex_count();
            // without tiles all lines are parallel, Q is a segment, and every vertical line has all of it
            let x = match tiles_before.checked_sub(1) {
                Some(last) => lines.abscissa(select(lines, &slab, last / 2, random, tally)),
                None => Fraction::new(Dyadic::zero(), Dyadic::from_f64(1.0)),
            };
            let cut = slab.cut(lines, &x, tally);
            let chains = [
                Chain::new(cut.order.just_left(lines), cut.verticals[0]),
                Chain::new(cut.order.just_right(), cut.verticals[1]),
            ];
            let [left, right] = &chains;
            let [at_left, at_right] = [left, right]
                .map(|chain| chain.crossing(target, dual).expect("p_0 lies in Q, every chain spans its height"));
            let (side, half) = if at_left.lead.sign() == Ordering::Less {
                (Side::Left, slab.left_of(lines, &cut))
            } else if at_right.lead.sign() == Ordering::Greater {
                (Side::Right, slab.right_of(&cut))
            } else {
                (Side::Within, Slab::empty())
            };
            let tiles_after = half.vertex_count();
            record(&Probe { x: &x, tiles_before, tiles_after, side, chains: [left, right] });
            if side == Side::Within {
                let [left, right] = chains;
                return Self::new(target, dual, &x, [(left, at_left), (right, at_right)]);
            }
            assert!(tiles_after > 0, "the tiles between two chains with p_0 between them cover it");
            slab = half;
        }
    }

    fn new(target: &Target, dual: &DualArrangement, x: &Fraction, sides: [(Chain, Crossing); 2]) -> Self {
        let (chain, crossing) = &sides[0];
        let [a, b, c] = exact(dual.slanted[crossing.place as usize].vector);
        let Fraction { numerator, denominator } = x;
        // (x, y, 1) on the line of the edge, y = −(a x + c) / b
        let normal = [numerator * &b, -(&a * numerator + &c * denominator), denominator * &b];
        let corner = [0, 1, 2].map(|axis| chain.offset(crossing.edge, axis, target, dual));
        let depth = dot(&normal, &corner);
        Self { sides, normal, depth }
    }

    /// The four vertices of the facet around p_0: those of the edges of both chains at its height, upper ends first,
    /// each with its weight; the weighted sum, divided by the sum of the weights, has the projection p_0. Weights are
    /// not negative.
    pub(super) fn corners(&self, dual: &DualArrangement) -> [(&Chain, usize, Dyadic); 4] {
        let [(left, at_left), (right, at_right)] = &self.sides;
        let height = |at: &Crossing| Dyadic::from_f64(dual.slanted[at.place as usize].vector[1]);
        let (high, low) = (height(at_left), height(at_right));
        // p_0 is lead / height right of an edge: weights of the two edges, then of the ends of each
        let mut across = [-(&at_right.lead * &high), &at_left.lead * &low];
        if across.iter().all(Dyadic::is_zero) {
            across = [Dyadic::from_f64(1.0), Dyadic::zero()];
        }
        let ends = |at: &Crossing, own: &Dyadic, other: &Dyadic| {
            let (own, other) = (own.clone().scaled(1), other.clone());
            [(&own - &at.rise) * other.clone(), &at.rise * &other]
        };
        let [first, second] = ends(at_left, &high, &low).map(|weight| weight * across[0].clone());
        let [third, fourth] = ends(at_right, &low, &high).map(|weight| weight * across[1].clone());
        [
            (left, at_left.edge, first),
            (left, at_left.edge + 1, second),
            (right, at_right.edge, third),
            (right, at_right.edge + 1, fourth),
        ]
    }

    /// The generators of the facet: those orthogonal to the normal, along the left chain from top to bottom, and level
    /// ones.
    pub(super) fn facet<'d>(&self, dual: &'d DualArrangement) -> (usize, Vec<&'d Upward>) {
        let [(left, at), (right, _)] = &self.sides;
        let is_on = |place: &&u32| {
            let upward = &dual.slanted[**place as usize];
            dot(&exact(upward.vector), &self.normal).is_zero()
        };
        let (above, others) = left.places.split_at(at.edge);
        let first = at.edge - above.iter().rev().take_while(is_on).count();
        let last = at.edge + others.iter().take_while(is_on).count();
        let slanted = left.places[first..last].iter().map(|&place| &dual.slanted[place as usize]);
        (first, slanted.chain(&dual.level[left.passed..right.passed]).collect())
    }
}
