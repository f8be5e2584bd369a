//! Point location among nested cells: a binary search in the tree of cuts, whatever its depth.
//!
//! The tree of cuts may be deep where cuts are unequal, so it is not descended from its root. A cell of the tree that
//! holds between a third and two thirds of the trapezoids is tested first; the search goes on among those within it or
//! among those outside of it, and the tree is cut there for good. A cell lies within a larger one between at most two
//! walls and two lines, so a test takes at most four comparisons.

use std::ops::Range;

/// What a cell is cut along, by the number of a wall or the place of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Cut {
    Wall(u32),
    Line(u32),
}

/// A node of the tree of cuts.
#[derive(Debug, Clone, Copy)]
pub(super) enum Node {
    /// A cell that was cut; first the part before the cut, then the part beyond it.
    Inner(Cut, [u32; 2]),
    /// The trapezoid with a number.
    Leaf(u32),
}

/// A condition on a point: on which side of a cut it lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Condition {
    pub(super) cut: Cut,
    pub(super) is_beyond: bool,
}

/// A decision of the search.
#[derive(Debug, Clone)]
pub(super) enum Step {
    /// The point, which lies in the cell of a node, lies in a cell within it if it fulfils the conditions in a range of
    /// the list; then, or else, go on with these.
    Test { node: u32, conditions: Range<u32>, within: u32, outside: u32 },
    /// The trapezoid with a number.
    Found(u32),
}

/// The search tree.
#[derive(Debug)]
pub(super) struct Search {
    pub(super) steps: Vec<Step>,
    pub(super) conditions: Vec<Condition>,
}

/// A part of the tree of cuts: the nodes below a root that were not cut off.
struct Part {
    root: u32,
    /// The number of the step that searches it.
    step: usize,
}

/// The tree of cuts while it is taken apart.
struct Tree<'a> {
    nodes: &'a [Node],
    /// How many trapezoids each node holds in its part.
    leaves: Vec<u32>,
    /// The nodes that were cut off from their parents.
    is_cut_off: Vec<bool>,
}

impl Search {
    /// The search in a tree whose root is the first node and in which children stand behind their parents. O(N log N)
    /// for N trapezoids.
    pub(super) fn new(nodes: &[Node]) -> Self {
        let mut tree = Tree::new(nodes);
        let mut search = Self { steps: vec![Step::Found(0)], conditions: Vec::new() };
        let mut parts = vec![Part { root: 0, step: 0 }];
        while let Some(Part { root, step }) = parts.pop() {
            let path = tree.path_to_centroid(root);
            let (&centroid, above) = path.split_last().expect("a path has its root");
            if let Node::Leaf(trapezoid) = nodes[centroid as usize]
                && tree.leaves[root as usize] == 1
            {
                search.steps[step] = Step::Found(trapezoid);
                continue;
            }
            let start = search.conditions.len() as u32;
            search.conditions.extend(tree.binding_conditions(&path));
            let conditions = start..search.conditions.len() as u32;
            tree.cut_off(centroid, above);
            let next = search.steps.len();
            search.steps.extend([Step::Found(0), Step::Found(0)]);
            let [within, outside] = [next, next + 1].map(|step| step as u32);
            search.steps[step] = Step::Test { node: root, conditions, within, outside };
            parts.extend([Part { root: centroid, step: next }, Part { root, step: next + 1 }]);
        }
        search
    }

    /// The trapezoid on whose side of every cut a point lies, by asking whether the point is beyond a cut.
    pub(super) fn find(&self, mut is_beyond: impl FnMut(Cut) -> bool) -> u32 {
        let mut step = 0;
        loop {
            match &self.steps[step] {
                Step::Found(trapezoid) => return *trapezoid,
                Step::Test { conditions, within, outside, .. } => {
                    let conditions = &self.conditions[conditions.start as usize..conditions.end as usize];
                    let is_within = conditions.iter().all(|condition| is_beyond(condition.cut) == condition.is_beyond);
                    step = if is_within { *within } else { *outside } as usize;
                }
            }
        }
    }
}

impl<'a> Tree<'a> {
    fn new(nodes: &'a [Node]) -> Self {
        let mut leaves = vec![1; nodes.len()];
        for (i, node) in nodes.iter().enumerate().rev() {
            if let Node::Inner(_, children) = node {
                leaves[i] = children.iter().map(|&child| leaves[child as usize]).sum();
            }
        }
        Self { nodes, leaves, is_cut_off: vec![false; nodes.len()] }
    }

    /// The nodes from the root of a part down to one that holds at most two thirds of its trapezoids, and at least a
    /// third; down to the leaf if there is only one.
    fn path_to_centroid(&self, root: u32) -> Vec<u32> {
        let total = u64::from(self.leaves[root as usize]);
        let mut path = vec![root];
        let mut node = root;
        while let Node::Inner(_, children) = self.nodes[node as usize] {
            if 3 * u64::from(self.leaves[node as usize]) <= 2 * total {
                break;
            }
            let count = |child: u32| if self.is_cut_off[child as usize] { 0 } else { self.leaves[child as usize] };
            let [before, beyond] = children;
            node = if count(beyond) > count(before) { beyond } else { before };
            path.push(node);
        }
        path
    }

    /// The conditions by which the points of the last node of a path are told among those of the first one: of nested
    /// walls on one side, or lines on one side, the last.
    fn binding_conditions(&self, path: &[u32]) -> impl Iterator<Item = Condition> + use<> {
        let mut binding = [None; 4];
        for pair in path.windows(2) {
            if let Node::Inner(cut, [_, beyond]) = self.nodes[pair[0] as usize] {
                let is_beyond = beyond == pair[1];
                let kind = 2 * usize::from(matches!(cut, Cut::Line(_))) + usize::from(is_beyond);
                binding[kind] = Some(Condition { cut, is_beyond });
            }
        }
        binding.into_iter().flatten()
    }

    /// Takes a node out of the part to which the nodes above it belong.
    fn cut_off(&mut self, node: u32, above: &[u32]) {
        self.is_cut_off[node as usize] = true;
        for &ancestor in above {
            self.leaves[ancestor as usize] -= self.leaves[node as usize];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Walls 0 … n − 1 from left to right, each cut from what is right of the one before: a path.
    fn path(walls: u32) -> Vec<Node> {
        let pairs = (0..walls).flat_map(|wall| {
            let first = 2 * wall + 1;
            [Node::Inner(Cut::Wall(wall), [first, first + 1]), Node::Leaf(wall)]
        });
        pairs.chain([Node::Leaf(walls)]).collect()
    }

    #[test]
    fn a_path_is_searched_in_logarithmic_time() {
        for walls in [0, 1, 2, 3, 10, 100, 5000] {
            // inner nodes stand in the even places, each with its leaf behind it
            let search = Search::new(&path(walls));
            for slab in 0..=walls {
                let mut comparisons = 0;
                let found = search.find(|cut| {
                    comparisons += 1;
                    matches!(cut, Cut::Wall(wall) if wall < slab)
                });
                assert_eq!(found, slab, "{walls} walls");
                let thirds = libm::log2(f64::from(walls + 1)) / libm::log2(1.5);
                assert!(f64::from(comparisons) <= 2.0 * thirds.ceil(), "{walls} walls: {comparisons} comparisons");
            }
        }
    }
}
