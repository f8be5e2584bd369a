//! The course of the search, for pictures: the separators tried and the tiles found.

use super::chain::Chain;
use super::footing::{Footing, Probe, Side};
use crate::arrangement::DualArrangement;
use crate::arrangement::dual::Upward;
use crate::collision::Location;
use crate::numeric::Rational;
use crate::numeric::exact_sum::ExactSum;

/// One of the two searches.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Hull {
    /// For the facet of the upper hull over p_0.
    Upper,
    /// For the facet of the lower hull: that of the upper hull over −p_0, by central symmetry.
    Lower,
}

/// A vertical line of the search, with the separators on both sides of it.
#[derive(Debug, Clone, PartialEq)]
pub struct SearchStep {
    /// Which search.
    pub hull: Hull,
    /// Where the vertical line is, within a relative 2^-50.
    pub x: f64,
    /// Where it is, exactly.
    pub exact_x: Rational,
    /// How many tiles were candidates before it was drawn.
    pub tiles_before: u64,
    /// How many are left.
    pub tiles_after: u64,
    /// Where p_0 was found.
    pub side: Side,
    /// The separators just left and just right of the line, from top to bottom, rounded; in the search for the lower
    /// hull they are those of −p_0. They differ in the tiles whose vertices lie on the line.
    pub chains: [Vec<[f64; 2]>; 2],
}

/// The tile over p_0.
#[derive(Debug, Clone, PartialEq)]
pub struct FoundTile {
    /// Which search found it.
    pub hull: Hull,
    /// Its generators: two, or more if they are coplanar, or one if p_0 was met on an edge between tiles.
    pub generators: Vec<usize>,
    /// Its corners counter-clockwise from the top, rounded; two for an edge.
    pub corners: Vec<[f64; 2]>,
    /// How far p is below the facet, vertically, rounded; negative when it is above.
    pub depth: f64,
}

/// A search with its answer.
#[derive(Debug, Clone, PartialEq)]
pub struct Trace {
    /// The answer.
    pub location: Location<3>,
    /// The vertical lines in the order in which they were drawn.
    pub steps: Vec<SearchStep>,
    /// The tiles found, at most one for each hull.
    pub tiles: Vec<FoundTile>,
    /// Whether the searches took y for x and x for y, because all projections are level.
    pub swapped: bool,
}

/// What the method tells of its course.
pub(super) trait Recorder {
    /// A vertical line was drawn.
    fn probe(&mut self, hull: Hull, probe: &Probe<'_>, dual: &DualArrangement);
    /// A facet was found.
    fn found(&mut self, hull: Hull, footing: &Footing, dual: &DualArrangement);
}

impl Recorder for () {
    fn probe(&mut self, _: Hull, _: &Probe<'_>, _: &DualArrangement) {}
    fn found(&mut self, _: Hull, _: &Footing, _: &DualArrangement) {}
}

/// The steps and tiles of a trace.
#[derive(Default)]
pub(super) struct Course {
    pub(super) steps: Vec<SearchStep>,
    pub(super) tiles: Vec<FoundTile>,
}

impl Recorder for Course {
    fn probe(&mut self, hull: Hull, probe: &Probe<'_>, dual: &DualArrangement) {
        self.steps.push(SearchStep {
            hull,
            x: probe.x.to_f64(),
            exact_x: probe.x.to_rational(),
            tiles_before: probe.tiles_before,
            tiles_after: probe.tiles_after,
            side: probe.side,
            chains: probe.chains.map(|chain| corners(chain, dual)),
        });
    }

    fn found(&mut self, hull: Hull, footing: &Footing, dual: &DualArrangement) {
        let (first, facet) = footing.facet(dual);
        let slanted = facet.iter().filter(|upward| upward.vector[1] != 0.0).count();
        let [left, right] = [0, 1].map(|side| corners(&footing.sides[side].0, dual)[first..=first + slanted].to_vec());
        let mut outline: Vec<[f64; 2]> = left.into_iter().chain(right.into_iter().rev()).collect();
        outline.dedup();
        if outline.len() > 1 && outline.first() == outline.last() {
            outline.pop();
        }
        if outline.len() == 3 && facet.len() == 1 {
            outline.pop();
        }
        let mut generators: Vec<usize> = facet.iter().map(|upward: &&Upward| upward.generator as usize).collect();
        generators.sort_unstable();
        let depth = footing.depth.ratio(&footing.normal[2]);
        self.tiles.push(FoundTile { hull, generators, corners: outline, depth });
    }
}

/// The corners of a chain, each rounded from the exact one but for the rounding of the steps.
fn corners(chain: &Chain, dual: &DualArrangement) -> Vec<[f64; 2]> {
    let mut sums = [ExactSum::default(), ExactSum::default()];
    for (upward, sign) in chain.signs(0, dual) {
        sums[0].add(f64::from(sign) * upward.vector[0]);
        sums[1].add(f64::from(sign) * upward.vector[1]);
    }
    let mut corners = vec![sums.each_ref().map(|sum| sum.value().to_f64())];
    for &place in &chain.places {
        let [x, y, _] = dual.slanted[place as usize].vector;
        for (sum, step) in sums.iter_mut().zip([x, y]) {
            sum.add(-step);
            sum.add(-step);
        }
        corners.push(sums.each_ref().map(|sum| sum.value().to_f64()));
    }
    corners
}
