//! The edges of a facet in the order around it.

use std::cmp::Ordering;

use smallvec::SmallVec;

use super::classes::{Class, Classes};
use super::error::WalkError;
use super::facet::{FacetEdge, FacetName, NormalSense};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, negated, sum};
use crate::numeric::orientation::in_space::determinant_sign_of_rows;

/// A class of parallel generators with one of its two directions.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Directed {
    pub(super) class: Class,
    /// Whether the direction is the one that points down.
    pub(super) is_reversed: bool,
}

impl Directed {
    pub(super) fn reversed(self) -> Self {
        Self { is_reversed: !self.is_reversed, ..self }
    }

    /// The direction.
    #[inline]
    pub(super) fn vector(self, classes: &Classes) -> [f64; 3] {
        let upward = *classes.upward(self.class);
        if self.is_reversed { upward.map(|c| -c) } else { upward }
    }

    /// Half of an edge in this direction.
    pub(super) fn half_edge(self, classes: &Classes) -> ExactVector {
        let upward = classes.half_edge(self.class);
        if self.is_reversed { negated(upward) } else { upward }
    }
}

/// One half of the edges of a facet, counter-clockwise seen from outside; the others are their opposites.
///
/// Edge 0 has the direction of the generator with the least index along the facet. Each pair of edges w_j, w_k with j <
/// k has w_j × w_k along the outward normal.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct EdgeCycle {
    half: SmallVec<[Directed; 2]>,
    /// Whether the slopes of the classes ascend counter-clockwise.
    pub(super) ascends: bool,
}

impl EdgeCycle {
    /// The edges of the facet along some classes, in any order, of which two span a plane with the cross product
    /// outward.
    pub(super) fn of_plane(classes: &Classes, mut along: SmallVec<[Class; 2]>, [a, b]: [Directed; 2]) -> Self {
        let place = |class: Class| classes.place(class);
        let ascends = (place(a.class) < place(b.class)) == (a.is_reversed == b.is_reversed);
        along.sort_unstable_by_key(|&class| place(class));
        if !ascends {
            along.reverse();
        }
        let start = (0..along.len()).min_by_key(|&k| classes.first_member(along[k])).unwrap_or(0);
        let is_reversed = !classes.points_up(classes.first_member(along[start]));
        let half = (0..along.len()).map(|k| {
            let k = start + k;
            let is_beyond = k >= along.len();
            let class = along[if is_beyond { k - along.len() } else { k }];
            Directed { class, is_reversed: is_reversed != is_beyond }
        });
        Self { half: half.collect(), ascends }
    }

    /// The edges of a facet by its name, and for each class the sign of its upward direction along the outward normal.
    /// O(n) determinants.
    pub(super) fn named(classes: &Classes, name: FacetName) -> Result<(Self, Vec<Ordering>), WalkError> {
        let FacetName { first, second, normal } = name;
        let count = classes.generators().len();
        if let Some(generator) = [first, second].into_iter().find(|&generator| generator >= count) {
            return Err(WalkError::UnknownGenerator { generator, count });
        }
        if first >= second {
            return Err(WalkError::NotAscending { first, second });
        }
        let directed = |generator: usize| {
            let class = classes.class_of(generator)?;
            Some(Directed { class, is_reversed: !classes.points_up(generator) })
        };
        let spanning = directed(first).zip(directed(second)).filter(|(a, b)| a.class != b.class);
        let (a, b) = spanning.ok_or(WalkError::NoPlane { first, second })?;
        let spanning = match normal {
            NormalSense::Along => [a, b],
            NormalSense::Against => [b, a],
        };
        let signs = signs(classes, spanning);
        let along = classes.all().filter(|&class| signs[class as usize].is_eq()).collect();
        Ok((Self::of_plane(classes, along, spanning), signs))
    }

    /// How many edges there are.
    pub(super) fn len(&self) -> usize {
        2 * self.half.len()
    }

    /// The directions of one half of the edges.
    pub(super) fn half(&self) -> &[Directed] {
        &self.half
    }

    /// An edge, if there is one of this number.
    pub(super) fn edge(&self, edge: usize) -> Result<Directed, WalkError> {
        let count = self.half.len();
        let opposite = || self.half.get(edge.wrapping_sub(count)).map(|directed| directed.reversed());
        let found = self.half.get(edge).copied().or_else(opposite);
        found.ok_or(WalkError::UnknownEdge { edge, count: self.len() })
    }

    /// The classes along the facet but that of an edge, each with the direction in which the edge is off the centre:
    /// that which has a positive product with the normals of the facets next beyond the edge.
    pub(super) fn beside(&self, edge: usize) -> impl Iterator<Item = Directed> {
        let (count, is_opposite) = (self.half.len(), edge >= self.half.len());
        let own = if is_opposite { edge - count } else { edge };
        let others = self.half.iter().enumerate().filter(move |(k, _)| *k != own);
        others.map(move |(k, &directed)| if (k < own) == is_opposite { directed.reversed() } else { directed })
    }

    /// Two directions whose cross product points outward.
    pub(super) fn spanning(&self) -> [Directed; 2] {
        [self.half[0], self.half[1]]
    }

    /// For each class the sign of its upward direction along the outward normal. O(n) determinants.
    pub(super) fn signs(&self, classes: &Classes) -> Vec<Ordering> {
        signs(classes, self.spanning())
    }

    /// The name of the facet.
    pub(super) fn name(&self, classes: &Classes) -> FacetName {
        let rest = self.half[1..].iter();
        let second = rest.min_by_key(|directed| classes.first_member(directed.class));
        let second = second.expect("a facet has two directions");
        let [first, other] = [self.half[0], *second].map(|directed| classes.first_member(directed.class));
        let is_along = second.is_reversed != classes.points_up(other);
        FacetName::new(first, other, if is_along { NormalSense::Along } else { NormalSense::Against })
    }

    /// The edges, named.
    pub(super) fn edges(&self, classes: &Classes) -> Vec<FacetEdge> {
        let opposite = self.half.iter().map(|directed| directed.reversed());
        let named = |directed: Directed| {
            let generator = classes.first_member(directed.class);
            FacetEdge { generator, is_reversed: directed.is_reversed == classes.points_up(generator) }
        };
        self.half.iter().copied().chain(opposite).map(named).collect()
    }

    /// From the centre of the facet to the middle of an edge.
    pub(super) fn to_edge(&self, classes: &Classes, edge: usize) -> ExactVector {
        let zero = [0; 3].map(|_| Dyadic::zero());
        self.beside(edge).fold(zero, |total, directed| sum(&total, &directed.half_edge(classes)))
    }

    /// The number of the edge that, on the other side of it, is an edge of this direction.
    pub(super) fn edge_against(&self, edge: Directed) -> Option<usize> {
        let place = self.half.iter().position(|directed| directed.class == edge.class)?;
        Some(if self.half[place] == edge { place + self.half.len() } else { place })
    }
}

/// For each class the sign of its upward direction along the cross product of two directions.
fn signs(classes: &Classes, spanning: [Directed; 2]) -> Vec<Ordering> {
    let [a, b] = spanning.map(|directed| directed.vector(classes));
    classes.all().map(|class| determinant_sign_of_rows(&a, &b, classes.upward(class))).collect()
}
