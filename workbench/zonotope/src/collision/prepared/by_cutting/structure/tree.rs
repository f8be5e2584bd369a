//! The search tree with what a query needs at each of its steps: the structure of Lemma 5.3.
//!
//! A step asks on which sides of a few cuts a query's optimum lies, which is known to lie in a part of the dual plane.
//! To decide that, the lines that cross the part are kept in their order along each cut, with the sums of the signed
//! generators at every [`SUM_STEP`]-th place. A trapezoid keeps its lines in any order and the sum of all others.

use super::boundary::Boundary;
use super::sums::Sums;

/// The places from one kept sum to the next: a sum takes 48 bytes, a place 4.
pub(crate) const SUM_STEP: usize = 8;

/// A step of the search.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Step {
    /// If the optimum is on the sides of the cuts that the conditions name, go on with one step, else with the other.
    Test { conditions: [Option<Condition>; 4], within: u32, outside: u32 },
    /// The optimum is in a trapezoid.
    Trapezoid(Trapezoid),
}

/// A side of a cut.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Condition {
    /// The number of the cut.
    pub(crate) cut: u32,
    pub(crate) is_beyond: bool,
}

/// A cut of a part along a boundary.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Cut {
    pub(crate) boundary: Boundary,
    /// Where its generators begin in the list of all: those that turn along the boundary in their order, then those
    /// whose lines run along it.
    pub(crate) first_generator: usize,
    /// How many generators turn along the boundary.
    pub(crate) turning: u32,
    /// How many have lines along it.
    pub(crate) along: u32,
    /// The place of the sum of the generators whose lines do not cross the part, each with its sign there.
    pub(crate) others: usize,
    /// Where its gradients begin in the list of all sums: those at every [`SUM_STEP`]-th place of the upper half circle
    /// of directions.
    pub(crate) first_gradient: usize,
}

/// A trapezoid with the lines that cross it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Trapezoid {
    /// Where its generators begin in the list of all.
    pub(crate) first_generator: usize,
    /// How many lines cross it.
    pub(crate) crossing: u32,
    /// The place of the sum of all other generators, each with its sign in the trapezoid.
    pub(crate) others: usize,
}

/// A generator at a place: its index, and whether it is to be turned round.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Place(u32);

/// The most generators that a [`Place`] can name.
pub(crate) const GENERATOR_LIMIT: usize = 1 << 31;

impl Place {
    pub(crate) fn new(index: u32, is_reversed: bool) -> Self {
        Self(index << 1 | u32::from(is_reversed))
    }

    /// The generator's index.
    pub(crate) fn index(self) -> usize {
        (self.0 >> 1) as usize
    }

    /// The generator, turned round if that was noted.
    pub(crate) fn vector(self, generators: &[[f64; 3]]) -> [f64; 3] {
        let v = generators[self.index()];
        if self.0 & 1 == 1 { v.map(|c| -c) } else { v }
    }
}

/// The whole structure.
#[derive(Debug)]
pub(crate) struct Tree {
    /// The first cut is the horizon, with all generators other than zero.
    pub(crate) cuts: Vec<Cut>,
    /// The search begins with the first step.
    pub(crate) steps: Vec<Step>,
    pub(crate) places: Vec<Place>,
    pub(crate) sums: Sums,
}

impl Tree {
    /// How many bytes it holds.
    pub(crate) fn bytes(&self) -> u64 {
        let bytes = |count: usize, size: usize| count as u64 * size as u64;
        bytes(self.cuts.capacity(), size_of::<Cut>())
            + bytes(self.steps.capacity(), size_of::<Step>())
            + bytes(self.places.capacity(), size_of::<Place>())
            + self.sums.bytes()
    }

    /// How many trapezoids the cutting has.
    pub(crate) fn trapezoid_count(&self) -> usize {
        self.steps.iter().filter(|step| matches!(step, Step::Trapezoid(_))).count()
    }

    /// The places of a cut's generators: those that turn along it, those along it.
    pub(crate) fn places_of(&self, cut: &Cut) -> [&[Place]; 2] {
        let all = &self.places[cut.first_generator..];
        let (turning, others) = all.split_at(cut.turning as usize);
        [turning, &others[..cut.along as usize]]
    }
}
