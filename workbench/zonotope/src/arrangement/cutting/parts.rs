//! The parts of the plane while it was cut, and the steps of the search among the trapezoids: for structures that keep
//! something of their own at each of them.

use super::search::{Node, Step};
use super::subdivision::Cutting;
use super::trapezoid::{Boundary, TrapezoidIndex};

/// A part of the plane while it was cut.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Part {
    /// It was cut along a boundary, into the parts with these numbers: the one before it, the one beyond it.
    Cut(Boundary, [u32; 2]),
    /// It is a trapezoid.
    Trapezoid(TrapezoidIndex),
}

/// A step of the search among the trapezoids.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum SearchStep {
    /// What is searched lies in the part with the number `part`. If it is on these sides of these boundaries, it lies
    /// in a part of that part, and the search goes on with the step `within`, else with the step `outside`.
    Test {
        part: u32,
        /// At most four boundaries, and whether the inner part is beyond each.
        conditions: Vec<(Boundary, bool)>,
        within: u32,
        outside: u32,
    },
    /// It lies in this trapezoid.
    Found(TrapezoidIndex),
}

impl Cutting<'_> {
    /// How many parts there were while the plane was cut, the plane itself and the trapezoids included.
    pub(crate) fn part_count(&self) -> u32 {
        self.tree.len() as u32
    }

    /// The part with a number. The plane has the number 0, and the parts of a part have larger numbers than it has.
    pub(crate) fn part(&self, number: u32) -> Part {
        match self.tree[number as usize] {
            Node::Inner(cut, parts) => Part::Cut(self.boundary(cut), parts),
            Node::Leaf(trapezoid) => Part::Trapezoid(TrapezoidIndex(trapezoid)),
        }
    }

    /// How many steps the search has, the last ones included.
    pub(crate) fn step_count(&self) -> u32 {
        self.search.steps.len() as u32
    }

    /// A step of the search. It begins with the step 0, and there are at most as many tests as the logarithm of the
    /// number of trapezoids to the base 3/2.
    pub(crate) fn step(&self, number: u32) -> SearchStep {
        match &self.search.steps[number as usize] {
            Step::Found(trapezoid) => SearchStep::Found(TrapezoidIndex(*trapezoid)),
            Step::Test { node, conditions, within, outside } => {
                let conditions = &self.search.conditions[conditions.start as usize..conditions.end as usize];
                let conditions = conditions.iter().map(|own| (self.boundary(own.cut), own.is_beyond)).collect();
                SearchStep::Test { part: *node, conditions, within: *within, outside: *outside }
            }
        }
    }
}
