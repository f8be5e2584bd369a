//! A cell that is likely to hold the optimum, from the sums of the nodes.
//!
//! The generators of a node that the line u · v = 0 cuts are spread over its box. So its |·| is rounded off over the
//! width of the box: Newton steps on the objective of nodes come nearer to the optimum than the nodes are wide. Then
//! only the nodes that cross a cell around the point are opened, and so on down to the leaves.

use std::borrow::Cow;

use smallvec::SmallVec;

use super::DirectionTree;
use super::part::TreePart;
use super::walk::{Nodes, Visitor, walk};
use crate::lad::of_generators::guess::huber_newton::{Moments, Others, Step, solve};
use crate::lad::of_generators::plane::in_doubles::{Guess, RoundedChart, RoundedLines};
use crate::lad::of_generators::seam::direction_cone::DirectionCone;
use crate::lad::of_generators::seam::frame::Frame;
use crate::numeric::linear::dot;
use crate::tally::{Operation, Tally};

/// The most Newton steps for one level.
const NEWTON_STEP_LIMIT: usize = 12;

/// The mean square of the change of the nodes' distances, in terms of their widths, at which Newton steps end.
const LAST_CHANGE: f64 = 1e-4;

/// By how much the widths are made larger where the nodes within theirs are all parallel.
const WIDENING_FACTOR: f64 = 8.0;

/// The number of times that the widths are made larger.
const WIDENING_LIMIT: usize = 8;

/// The standard deviations of the gradient that a cell allows for, if a node that is cut had all of its generators on
/// one side.
const DEVIATIONS: f64 = 0.65;

/// A minimum that is farther from the one of larger nodes than this, in terms of the sides of the cell, is not
/// believed: the signs of the nodes beside the cell are not those at the minimum.
const BELIEVED_DISTANCE: f64 = 4.0;

/// Memory for so many nodes is taken for those of a level that cross a cell; few cells are crossed by more.
const LIKELY_NODES: usize = 1024;

/// The number of levels of the tree that one search skips.
const LEVELS_AT_ONCE: usize = 2;

/// Nodes that cross a cell, and the sum of all others.
struct Reduced<'t> {
    /// The sums of the nodes under the matrices of their trees, tree by tree.
    sums: Cow<'t, [[f64; 3]]>,
    /// The widths of the nodes of each tree, before any matrix.
    widths: SmallVec<[Widths<'t>; 2]>,
    fixed: [f64; 3],
}

/// The widths of some nodes of a tree.
struct Widths<'t> {
    frame: Option<Frame<'t>>,
    of_nodes: Cow<'t, [[[f64; 3]; 2]]>,
}

/// The sums and widths of the nodes that a walk crosses.
struct Crossed<'t, 's> {
    tree: &'t DirectionTree,
    sums: &'s mut Vec<[f64; 3]>,
    widths: Vec<[[f64; 3]; 2]>,
}

impl Visitor for Crossed<'_, '_> {
    #[inline(always)]
    fn crossed(&mut self, Nodes { face, level, block, mut lanes }: Nodes) {
        let block = &self.tree.faces[face].levels[level][block];
        while lanes != 0 {
            let lane = lanes.trailing_zeros() as usize;
            self.sums.push(block.sum.vector(lane));
            self.widths.push(block.width(lane));
            lanes &= lanes - 1;
        }
    }
}

/// A cell that is likely to hold the direction u with u · p = 1 at which Σ |v · u| is least, over the generators of
/// one or two trees; none where Newton steps do not get there, or sums of nodes are of no use.
pub(super) fn cell_near_optimum(parts: &[TreePart<'_>], p: [f64; 3], tally: &mut dyn Tally) -> Option<DirectionCone> {
    if !parts.iter().all(|part| part.tree.is_moderate) {
        return None;
    }
    let chart = RoundedChart::new(p);
    let middle = of_middle_fronts(parts);
    let lines = chart.lines(&middle.sums);
    let (start, _) = lines.least_squares()?;
    tally.add(Operation::GeneratorRead, middle.sums.len() as u64);
    let mut guess = minimum(&middle, lines, &chart, start)?;
    let mut levels: SmallVec<[usize; 2]> = parts.iter().map(|part| part.tree.middle_level).collect();
    while levels.iter().any(|&level| level > 0) {
        levels.iter_mut().for_each(|level| *level = level.saturating_sub(LEVELS_AT_ONCE));
        let cell = chart.cell(&guess, 1.0);
        let nodes = reduced(parts, &levels, &cell, tally);
        let next = minimum(&nodes, chart.lines(&nodes.sums), &chart, guess.point)?;
        if !guess.is_near(next.point, BELIEVED_DISTANCE) {
            return None;
        }
        guess = next;
    }
    Some(chart.cell(&guess, 1.0))
}

/// The nodes of the middle fronts; those of one tree without a matrix are read where they are.
fn of_middle_fronts<'t>(parts: &[TreePart<'t>]) -> Reduced<'t> {
    let widths =
        |part: &TreePart<'t>| Widths { frame: part.frame, of_nodes: Cow::Borrowed(&part.tree.middle_front.widths) };
    let sums = match parts {
        [TreePart { tree, frame: None }] => Cow::Borrowed(&tree.middle_front.sums[..]),
        _ => parts.iter().flat_map(|part| part.tree.middle_front.sums.iter().map(|v| part.image(v))).collect(),
    };
    Reduced { sums, widths: parts.iter().map(widths).collect(), fixed: [0.0; 3] }
}

/// The nodes that cross a cell, of a level of each tree.
fn reduced<'t>(parts: &[TreePart<'t>], levels: &[usize], cell: &DirectionCone, tally: &mut dyn Tally) -> Reduced<'t> {
    let mut sums = Vec::with_capacity(LIKELY_NODES * parts.len());
    let mut widths = SmallVec::new();
    let mut fixed = [0.0; 3];
    for (part, &level) in parts.iter().zip(levels) {
        let TreePart { tree, frame } = *part;
        let first = sums.len();
        let mut crossed = Crossed { tree, sums: &mut sums, widths: Vec::with_capacity(LIKELY_NODES) };
        let pulled = frame.map_or(*cell, |frame| frame.pulled_cell(cell));
        let walked = walk(&tree.faces, &pulled, level, &mut crossed);
        tally.add(Operation::GeneratorRead, walked.read as u64);
        widths.push(Widths { frame, of_nodes: crossed.widths.into() });
        let own = part.image(&walked.sum);
        fixed = [0, 1, 2].map(|k| fixed[k] + own[k]);
        if frame.is_some() {
            sums[first..].iter_mut().for_each(|v| *v = part.image(v));
        }
    }
    Reduced { sums: sums.into(), widths, fixed }
}

/// The minimum of the objective of nodes, each rounded off over its width, with the cell that it is likely to be in.
fn minimum(nodes: &Reduced<'_>, lines: RoundedLines, chart: &RoundedChart, point: [f64; 2]) -> Option<Guess> {
    let u = chart.point(point);
    let [x, y, _] = chart.line(&nodes.fixed);
    let linear = [x, y];
    let mut widths = Vec::with_capacity(nodes.sums.len());
    for Widths { frame, of_nodes } in &nodes.widths {
        let u = frame.map_or(u, |frame| frame.pulled(&u));
        widths.extend(of_nodes.iter().map(|node| width(node, &u)));
    }
    let lines = lines.with_widths(&widths);
    let found = newton(&lines, linear, point).or_else(|| {
        // where nodes of little width nearly meet, no step of Newton's is of use before the vertex is known
        let vertex = lines.optimum(linear, point)?;
        newton(&lines, linear, vertex).or_else(|| at_vertex(&lines, vertex))
    });
    let Smooth { point, band, moments } = found?;
    let others = Others { before: None, share: 0.0, longest: f64::INFINITY };
    lines.guess_of(&moments, band, point, others, DEVIATIONS)
}

/// The standard deviation of v · u over a box: that of a sum of even spreads is that of one whose width is the root of
/// the squares' sum.
fn width([side, half]: &[[f64; 3]; 2], u: &[f64; 3]) -> f64 {
    let (along, [x, y, z]) = (dot(side, u), [0, 1, 2].map(|k| half[k] * u[k]));
    (along * along + x * x + y * y + z * z).sqrt().max(f64::MIN_POSITIVE)
}

/// A point with the moments of a band there.
struct Smooth {
    point: [f64; 2],
    band: f64,
    moments: Moments,
}

/// The minimum of the rounded-off objective, if a few steps lead there.
fn newton(lines: &RoundedLines, linear: [f64; 2], mut point: [f64; 2]) -> Option<Smooth> {
    let mut before: Option<Step> = None;
    for _ in 0..NEWTON_STEP_LIMIT {
        let moments = lines.moments(point, 1.0);
        let gradient = [moments.gradient[0] + linear[0], moments.gradient[1] + linear[1]];
        if let Some(shorter) = before.take().and_then(|step| step.shortened(gradient)) {
            point = shorter;
            continue;
        }
        let step = Step::new(point, solve(&moments.hessian, gradient)?, gradient);
        point = step.end();
        if step.change(&moments) < LAST_CHANGE {
            return Some(Smooth { point, band: 1.0, moments });
        }
        before = Some(step);
    }
    None
}

/// A vertex, with a band that holds lines of several slopes.
fn at_vertex(lines: &RoundedLines, point: [f64; 2]) -> Option<Smooth> {
    let bands = (0..WIDENING_LIMIT).scan(1.0, |band, _| Some(std::mem::replace(band, *band * WIDENING_FACTOR)));
    bands
        .map(|band| Smooth { point, band, moments: lines.moments(point, band) })
        .find(|found| solve(&found.moments.hessian, [0.0; 2]).is_some())
}
