//! A chain as the list of its vertices, searched by halving.

use std::ops::Range;

use super::chain::{LocationTangent, PresentSites};
use super::descent::{Step, extreme_step, tangent_step, tangent_to_site};
use super::interface::Towards;
use super::sites::{Direction, Site};

/// The vertices of a chain from left to right, no three on a line.
#[derive(Debug, Clone, Default)]
pub(super) struct SortedChain {
    vertices: Vec<u32>,
}

impl SortedChain {
    /// The chain of locations that ascend: Andrew's scan. O(n).
    pub(super) fn of_ascending<S: Site>(sites: &PresentSites<S>, locations: impl Iterator<Item = u32>) -> Self {
        let inward = sites.side.outward().reverse();
        let mut vertices: Vec<u32> = Vec::new();
        for location in locations {
            while let [.., before, last] = vertices[..] {
                // the last vertex stays where the next one is on the inner side of the edge that ends in it
                if S::turn(sites.point(before), sites.point(last), sites.point(location)) == inward {
                    break;
                }
                vertices.pop();
            }
            vertices.push(location);
        }
        Self { vertices }
    }

    /// The vertices.
    pub(super) fn vertices(&self) -> &[u32] {
        &self.vertices
    }

    /// The position of a vertex, or the position that a location would have.
    pub(super) fn position(&self, location: u32) -> Result<usize, usize> {
        self.vertices.binary_search(&location)
    }

    /// Whether a location that is no vertex would become one.
    pub(super) fn is_outside<S: Site>(&self, sites: &PresentSites<S>, location: u32) -> bool {
        match self.position(location) {
            Ok(_) => false,
            Err(0) => true,
            Err(position) if position == self.vertices.len() => true,
            Err(position) => {
                let [before, after] = [position - 1, position].map(|at| sites.point(self.vertices[at]));
                S::turn(before, after, sites.point(location)) == sites.side.outward()
            }
        }
    }

    /// Puts other vertices in the place of some.
    pub(super) fn replace(&mut self, range: Range<usize>, vertices: &[u32]) {
        self.vertices.splice(range, vertices.iter().copied());
    }

    /// The vertex that is extreme in a direction. O(log h).
    pub(super) fn extreme<S: Site>(&self, sites: &PresentSites<S>, direction: Direction) -> Option<u32> {
        self.search(sites, |edge| extreme_step(sites.side, edge, direction))?
    }

    /// Where the tangent from a point touches. O(log h).
    pub(super) fn tangent<S: Site>(&self, sites: &PresentSites<S>, from: &S, towards: Towards) -> LocationTangent {
        match self.search(sites, |edge| tangent_step(sites.side, edge, from, towards)) {
            None => LocationTangent::Unbounded,
            Some(None) => LocationTangent::Hidden,
            Some(Some(vertex)) => tangent_to_site(sites.side, vertex, sites.point(vertex), from, towards),
        }
    }

    /// The vertex to which the steps lead; `None` if there is no vertex, `Some(None)` if a step leads nowhere.
    fn search<S: Site>(&self, sites: &PresentSites<S>, step: impl Fn([&S; 2]) -> Step) -> Option<Option<u32>> {
        let (mut first, mut last) = (0, self.vertices.len().checked_sub(1)?);
        while first < last {
            let middle = first + (last - first) / 2;
            let edge = [middle, middle + 1].map(|at| sites.point(self.vertices[at]));
            match step(edge) {
                Step::Left => last = middle,
                Step::Right => first = middle + 1,
                Step::Hidden => return Some(None),
            }
        }
        Some(Some(self.vertices[first]))
    }

    /// How many bytes are held.
    pub(super) fn bytes(&self) -> usize {
        self.vertices.capacity() * size_of::<u32>()
    }
}
