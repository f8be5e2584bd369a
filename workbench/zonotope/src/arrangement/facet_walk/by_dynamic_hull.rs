//! A walk over the facets, by dynamic convex hulls of the dual lines.
//!
//! # Source
//! Lemma 5.6. Departures: the lines are those of a plane tilted by less than any number ([the module](super) says why),
//! so that none is vertical or parallel to another one; each of the two sets of lines, above and below, has both of its
//! chains, since a step past the silhouette exchanges the sets, and what was a lower chain is asked for as an upper one
//! then; a step goes to all lines through the next vertex, the paper knows one.
//!
//! # Method
//! 1. At a facet with normal u the generators that are not along it have a sign along u. The lines of those with one
//!    sign are above the dual vertex of the facet, those of the others below.
//! 2. Across an edge the normal turns about the direction of the edge: the vertex moves along that line, to the right
//!    or to the left. It comes to the first line at which a tangent from the point of the line touches the lower chain
//!    of the lines above or the upper chain of those below.
//! 3. Where there is no such line on either side, the vertex leaves at one end of the line and comes back at the other,
//!    at the antipodal facet of the one whose vertex it seems to be: lines above are below now. The tangents to the
//!    other two chains give the next line.
//! 4. The line is deleted from its set; further lines through the same vertex are found by the same tangents, and
//!    deleted. The lines that are left behind are inserted where they are now.
//!
//! # Complexity
//! n generators; a facet of k classes has 2 k edges: a step between facets of k and l classes O((k + l) log² n), so
//! O(log² n) in general position, at worst and past the silhouette as well, the paper's bound; preprocessing O(n log
//! n), space O(n). A neighbour costs as much as a step. `place_at` is O(n).
//!
//! # Numerics
//! All decisions are exact: signs of determinants of generators as they are given. Centres and vertices are exact.
//!
//! # Checked by
//! [`brute_force`](super::brute_force) and the face lattice on all families; [`by_scan`](super::by_scan) on long walks.
//!
//! # Example
//! ```
//! use zonotope::arrangement::facet_walk::{FacetName, FacetWalk, HullWalk, NormalSense::{Against, Along}};
//! let cube = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
//! let mut walk = HullWalk::new(&cube)?;
//! let top = FacetName::new(0, 1, Along);
//! walk.place_at(top)?;
//! // front, right, back, left, as seen by one who looks along the y axis
//! let sides = [(0, 2, Along), (1, 2, Along), (0, 2, Against), (1, 2, Against)];
//! assert_eq!(walk.neighbours(), sides.map(|(i, j, s)| FacetName::new(i, j, s)));
//! walk.step(1)?;
//! assert_eq!((walk.facet(), walk.walk_to([0.1, 0.2, 3.0])?, walk.facet()), (FacetName::new(1, 2, Along), 1, top));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use std::cmp::Ordering;

use smallvec::SmallVec;

use super::classes::{Class, Classes};
use super::edge_cycle::{Directed, EdgeCycle};
use super::error::WalkError;
use super::facet::{FacetEdge, FacetName, NormalSense};
use super::interface::FacetWalk;
use super::tilted_line::TiltedLine;
use super::to_ray::{LocatedWalk, edge_start, facet_center, next_center, walk_along, walk_to};
use crate::arrangement::dynamic_hull::{DynamicChain, HullChain, Side, Site, SiteIndex, Tangent, Towards};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::ExactVector;
use crate::numeric::orientation::Turn;

/// A walk that keeps the hulls of the lines above and below.
#[derive(Debug, Clone)]
pub struct HullWalk {
    classes: Classes,
    cycle: EdgeCycle,
    /// The classes whose upward direction points outward from the facet, and those whose direction points inward.
    sets: [LineSet; 2],
    /// The centre of the facet relative to that of the body, once it was asked for.
    center: Option<ExactVector>,
}

/// Lines on one side of the dual vertex.
#[derive(Debug, Clone)]
struct LineSet {
    lower: DynamicChain<TiltedLine>,
    upper: DynamicChain<TiltedLine>,
}

/// The lines of the next dual vertex, but for the one along which it was reached, with the sets they were in.
type Reached = SmallVec<[(Class, usize); 2]>;

impl LineSet {
    fn new(classes: &Classes, signs: &[Ordering], sign: Ordering) -> Self {
        let present = || classes.all().filter(|&class| signs[class as usize] == sign).map(SiteIndex);
        let chain = |side| {
            let chain = DynamicChain::new(classes.lines().clone(), side, present());
            chain.expect("each class is named once and has a site")
        };
        Self { lower: chain(Side::Lower), upper: chain(Side::Upper) }
    }

    fn insert(&mut self, class: Class) {
        for chain in [&mut self.lower, &mut self.upper] {
            chain.insert(SiteIndex(class)).expect("a line of the dual vertex is in neither set");
        }
    }

    fn delete(&mut self, class: Class) {
        for chain in [&mut self.lower, &mut self.upper] {
            chain.delete(SiteIndex(class)).expect("a line that a tangent touches is in the set");
        }
    }
}

/// The line at which a tangent touches.
fn touched(tangent: Tangent) -> Option<Class> {
    match tangent {
        Tangent::Touches(line) => Some(line.0),
        // the lines of a dual vertex are between the two envelopes there, so no tangent is hidden
        Tangent::Unbounded | Tangent::Hidden => None,
    }
}

impl HullWalk {
    /// A walk over the facets of the zonotope of some generators, which starts at the facet of the first two that are
    /// not parallel. O(n log n).
    ///
    /// # Errors
    /// [`WalkError`] if a coordinate is not finite, the generators do not span space, or there are too many.
    pub fn new(generators: &[[f64; 3]]) -> Result<Self, WalkError> {
        let classes = Classes::new(generators)?;
        let [first, second] = classes.first_two();
        let (cycle, signs) = EdgeCycle::named(&classes, FacetName::new(first, second, NormalSense::Along))?;
        let sets = Self::sets(&classes, &signs);
        Ok(Self { classes, cycle, sets, center: None })
    }

    fn sets(classes: &Classes, signs: &[Ordering]) -> [LineSet; 2] {
        [Ordering::Greater, Ordering::Less].map(|sign| LineSet::new(classes, signs, sign))
    }

    /// For each generator the coefficient that every point of the facet has: 1 (`Greater`), −1 (`Less`), or none
    /// (`Equal`) if it is along the facet or zero. O(n).
    pub fn signs(&self) -> Vec<Ordering> {
        let signs = self.cycle.signs(&self.classes);
        let sign = |generator: usize| {
            let sign = self.classes.class_of(generator).map_or(Ordering::Equal, |class| signs[class as usize]);
            if self.classes.points_up(generator) { sign } else { sign.reverse() }
        };
        (0..self.classes.generators().len()).map(sign).collect()
    }

    /// The generators along the facet, class by class.
    pub fn along(&self) -> impl Iterator<Item = usize> {
        self.cycle.half().iter().flat_map(|directed| self.classes.members(directed.class))
    }

    /// The centre of the facet relative to that of the body, exactly: the sum of the generators with the signs of the
    /// facet. O(n) when it is asked for first after [`place_at`](FacetWalk::place_at), then it goes along with the
    /// walk.
    pub fn center(&mut self) -> [Dyadic; 3] {
        self.located().clone()
    }

    /// The vertex at which an edge of the facet begins, relative to the centre of the body, exactly. O(n) or O(1) like
    /// [`center`](Self::center), beside the size of the facet.
    ///
    /// # Errors
    /// [`WalkError::UnknownEdge`] if the facet has no edge of this number.
    pub fn vertex(&mut self, edge: usize) -> Result<[Dyadic; 3], WalkError> {
        let center = self.located().clone();
        let count = self.cycle.len();
        edge_start(&self.classes, &self.cycle, &center, edge).ok_or(WalkError::UnknownEdge { edge, count })
    }

    /// [`walk_to`](FacetWalk::walk_to) along the ray to an exact point relative to the centre; for the centre itself
    /// the walk stays where it is.
    pub(crate) fn walk_along(&mut self, point: &ExactVector) -> u64 {
        walk_along(self, point).expect("the walk crosses edges of its own facet")
    }

    /// How many bytes are held, the digits of long numbers not.
    pub fn bytes(&self) -> usize {
        let chains = self.sets.iter().flat_map(|set| [set.lower.bytes(), set.upper.bytes()]);
        let own = chains.map(|bytes| bytes - self.classes.lines().bytes()).sum::<usize>();
        own + self.classes.bytes() + size_of::<Self>()
    }

    /// Deletes the lines of the next dual vertex along an edge from their sets.
    fn reach(&mut self, edge: Directed) -> Reached {
        let line = *self.classes.line(edge.class);
        // the vertex moves to the right along a line whose generator points up, whichever side is outward
        let is_rightward = !edge.is_reversed;
        let towards = if is_rightward { [Towards::Left, Towards::Right] } else { [Towards::Right, Towards::Left] };
        let tangent = |sets: &[LineSet; 2], above: usize, is_above: bool| {
            touched(match is_above {
                true => sets[above].lower.tangent(&line, towards[0]),
                false => sets[1 - above].upper.tangent(&line, towards[1]),
            })
        };
        // slopes that ascend counter-clockwise have the lines of positive sign below the vertex
        let mut above = usize::from(self.cycle.ascends);
        let mut next = [true, false].map(|is_above| tangent(&self.sets, above, is_above));
        if next == [None; 2] {
            above = 1 - above;
            next = [true, false].map(|is_above| tangent(&self.sets, above, is_above));
        }
        let mut reached = Reached::new();
        while let Some((class, is_above)) = self.nearest(&line, next, is_rightward) {
            let is_through = |&(other, _): &(Class, usize)| self.are_concurrent([edge.class, other, class]);
            if !reached.first().is_none_or(is_through) {
                break;
            }
            let set = if is_above { above } else { 1 - above };
            self.sets[set].delete(class);
            reached.push((class, set));
            next[usize::from(!is_above)] = tangent(&self.sets, above, is_above);
        }
        reached
    }

    /// Which of a line above and a line below comes first along a line, and whether it is the one above; of both at one
    /// point that above.
    fn nearest(
        &self,
        line: &TiltedLine,
        [above, below]: [Option<Class>; 2],
        is_rightward: bool,
    ) -> Option<(Class, bool)> {
        let (Some(high), Some(low)) = (above, below) else {
            return above.map(|class| (class, true)).or(below.map(|class| (class, false)));
        };
        let [left, right] = if is_rightward { [high, low] } else { [low, high] };
        let turn = Site::turn(self.classes.line(left), line, self.classes.line(right));
        Some(if turn == Turn::Left { (low, false) } else { (high, true) })
    }

    fn are_concurrent(&self, lines: [Class; 3]) -> bool {
        let [a, b, c] = lines.map(|class| self.classes.line(class));
        Site::turn(a, b, c) == Turn::Straight
    }

    /// The facet of an edge and the lines that were reached along it.
    fn cycle_beyond(&self, edge: Directed, reached: &Reached) -> EdgeCycle {
        let along = reached.iter().map(|(class, _)| *class).chain([edge.class]).collect();
        let (class, set) =
            *reached.first().expect("lines that span the plane meet on every line in two points or more");
        EdgeCycle::of_plane(&self.classes, along, [edge, Directed { class, is_reversed: set == 1 }])
    }
}

impl FacetWalk for HullWalk {
    fn facet(&self) -> FacetName {
        self.cycle.name(&self.classes)
    }

    fn edges(&self) -> Vec<FacetEdge> {
        self.cycle.edges(&self.classes)
    }

    fn step(&mut self, edge: usize) -> Result<(), WalkError> {
        let directed = self.cycle.edge(edge)?;
        let reached = self.reach(directed);
        let cycle = self.cycle_beyond(directed, &reached);
        for behind in self.cycle.beside(edge) {
            self.sets[usize::from(behind.is_reversed)].insert(behind.class);
        }
        if let Some(center) = self.center.take() {
            self.center = next_center(&self.classes, &center, [&self.cycle, &cycle], edge);
        }
        self.cycle = cycle;
        Ok(())
    }

    fn neighbour(&mut self, edge: usize) -> Result<FacetName, WalkError> {
        let directed = self.cycle.edge(edge)?;
        let reached = self.reach(directed);
        for &(class, set) in &reached {
            self.sets[set].insert(class);
        }
        Ok(self.cycle_beyond(directed, &reached).name(&self.classes))
    }

    fn place_at(&mut self, facet: FacetName) -> Result<(), WalkError> {
        let (cycle, signs) = EdgeCycle::named(&self.classes, facet)?;
        self.sets = Self::sets(&self.classes, &signs);
        self.cycle = cycle;
        self.center = None;
        Ok(())
    }

    fn walk_to(&mut self, direction: [f64; 3]) -> Result<u64, WalkError> {
        walk_to(self, direction)
    }
}

impl LocatedWalk for HullWalk {
    fn classes(&self) -> &Classes {
        &self.classes
    }

    fn cycle(&self) -> &EdgeCycle {
        &self.cycle
    }

    fn located(&mut self) -> &ExactVector {
        self.center.get_or_insert_with(|| facet_center(&self.classes, &self.cycle))
    }
}
