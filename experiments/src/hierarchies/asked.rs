//! The questions that hierarchies of all volumes are asked about the same poses.

use super::approach::{DISTANCES, Placed};
use zonotope::Pose;
use zonotope::bvh::{BoundingVolume, Bvh};
use zonotope::tally::{Operation, OperationCounts};

/// The questions about a pose.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Asked {
    /// Whether copies meet that are at one of the distances.
    Apart(usize),
    /// Whether copies meet that overlap.
    FirstContact,
    /// All pairs of triangles of copies that overlap.
    AllPairs,
}

/// Mean numbers of tests over poses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tests {
    /// Pairs of nodes.
    pub nodes: f64,
    /// Pairs of triangles.
    pub triangles: f64,
}

impl Asked {
    /// All questions.
    pub fn all() -> impl Iterator<Item = Self> {
        (0..DISTANCES.len()).map(Self::Apart).chain([Self::FirstContact, Self::AllPairs])
    }

    /// The name in records: the distance in per cent of the diagonal, `contact` or `all_pairs`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Apart(at) => ["at_30", "at_10", "at_1", "at_0.1"][at],
            Self::FirstContact => "contact",
            Self::AllPairs => "all_pairs",
        }
    }

    fn pose(self, placed: &Placed) -> &Pose {
        match self {
            Self::Apart(at) => &placed.apart[at],
            Self::FirstContact | Self::AllPairs => &placed.overlapping,
        }
    }

    /// Asks about a pose, and holds the answer to it: the number of pairs that were found.
    ///
    /// # Errors
    /// If copies that are apart are said to meet, or the other way round.
    pub fn ask<V: BoundingVolume>(
        self,
        hierarchy: &Bvh<V>,
        placed: &Placed,
        counts: &mut OperationCounts,
    ) -> Result<usize, String> {
        let (still, moved) = (hierarchy.at(&Pose::IDENTITY), hierarchy.at(self.pose(placed)));
        let pairs = match self {
            Self::Apart(_) | Self::FirstContact => usize::from(still.witness(moved, counts).is_some()),
            Self::AllPairs => still.at_most_pairs(moved, usize::MAX, counts).map_or(0, |pairs| pairs.len()),
        };
        match (pairs > 0) != matches!(self, Self::Apart(_)) {
            true => Ok(pairs),
            false => Err(format!("{}: {pairs} pairs of {}", V::NAME, self.name())),
        }
    }

    /// The tests over all poses, and the pairs that were found.
    ///
    /// # Errors
    /// If an answer is wrong.
    pub fn tests<V: BoundingVolume>(self, hierarchy: &Bvh<V>, placed: &[Placed]) -> Result<(Tests, usize), String> {
        let mut counts = OperationCounts::default();
        let found =
            placed.iter().map(|placed| self.ask(hierarchy, placed, &mut counts)).sum::<Result<usize, String>>()?;
        let mean = |operation| counts.get(operation) as f64 / placed.len() as f64;
        let tests = Tests { nodes: mean(Operation::NodeTest), triangles: mean(Operation::TriangleTest) };
        Ok((tests, found))
    }
}
