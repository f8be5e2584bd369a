//! A zonotope of few generators around points, proven nearly as short as any, by merging and moving directions.
//!
//! # Statement
//! Input: points of R^D and an answer of one of the methods of [`min_total_length`](super): a zonotope around the
//! points and a lower bound of all total lengths, with its proof. Output: the same with a zonotope of few generators.
//! [`fewest`] looks for few generators and keeps the ratio of length and bound within 1 + ε, or no greater than the
//! answer's where that is above 1 + ε; [`shortest_of_few`] keeps the number of generators within a count and looks for
//! a small ratio, and merges nearby ones where that costs a tenth of ε at most; [`of_less_volume`] keeps neither and
//! looks for a small volume in space, a local minimum. The zonotope contains every point exactly, and the ratio is
//! proven as before, for the bound is the same. That no zonotope has fewer generators, or a smaller ratio with as many,
//! is not proven: it is the best that a local search found with its work. What cannot be made sparser is returned as it
//! was: one point, needles a hundred million times as long as wide, numbers near the ends of the range of doubles.
//!
//! # Source
//! The problem of Section 4.3, with a question that the paper does not ask. Section 4.2 is the tool: the shortest
//! zonotope along given directions is a linear program, and its basic solutions have few positive coefficients.
//!
//! # Method
//! 1. Merge the generators of the answer pair by pair (`merging`), the pair first whose sum is least shorter than both.
//! 2. Solve the linear program along the merged directions (`along`) and search for the least number of them that
//!    suffices (`search`). Nets of directions, three boxes, and the differences of few points are tried beside them.
//! 3. Merge generators of the sparsest zonotope further, and move the directions (`moving`) until it is short enough.
//! 4. Points on a line have the segment of doubles (`on_a_line`), and where the search fails, as for numbers of all
//!    sizes, there is a box (`sheared_box`).
//! 5. For the volume, let directions and lengths change by the linear program whose costs are what a generator adds to
//!    the volume (`volume`), from the answer and from three boxes.
//! 6. Round the generators to doubles, and prove that they contain every point (`exactly`). They are made longer by a
//!    few units in the last place for that, and no generators are added: a zonotope whose generators span the space
//!    makes up for rounding by itself. A plane of space that no doubles span takes one generator off the plane, as
//!    short as rounding.
//!
//! # Complexity
//! n points that may be on the boundary, k generators in the end. Some twenty to a hundred linear programs along at
//! most (2 D − 1) k directions, or 320 merged ones, each with some passes over the points; together about what the
//! answer took. Merging m generators takes O(m²) in most cases.
//!
//! # Shapes
//! `points`: n × D, any order, duplicates allowed; `generators`: half-lengths.
//!
//! # Numerics
//! The search is in floating point. Containment is exact, `value` is rounded up.
//!
//! # Errors
//! [`TooFewGenerators`](super::MinLengthError::TooFewGenerators) ⇔ the count is less than the dimension that the points
//! span exactly, or less than D and no doubles that span it are found;
//! [`OutOfRange`](super::MinLengthError::OutOfRange) ⇔ the length leaves the range of doubles: with D generators there
//! is the box along the axes around any points.
//!
//! # Checked by
//! The crate `verifier`, which proves ratio and containment anew; boxes and simplices, whose answers are known.
//!
//! # Example
//! ```
//! use zonotope::enclosing::min_total_length::{Method, few_generators};
//! let cube: Vec<[f64; 3]> = (0..8).map(|i| [i & 1, i >> 1 & 1, i >> 2].map(f64::from)).collect();
//! let answer = Method::default().solve(&cube, 1e-3, &mut ())?;
//! let sparse = few_generators::fewest(&cube, answer, 1e-3);
//! assert_eq!(sparse.body.generators().len(), 3);
//! assert!(sparse.value >= 1.5 && sparse.value < 1.5 + 1e-12); // three half-sides
//! # Ok::<(), zonotope::enclosing::min_total_length::MinLengthError>(())
//! ```

mod along;
mod boxes;
mod exactly;
mod merging;
mod moving;
mod search;
mod volume;

use super::answer::{MinLengthError, MinLengthZonotope, Outcome};
use super::by_vertex_sets::outer_points;
use super::frame::Frame;
use super::on_a_line::{differences, segment_around};
use super::sheared_box::shortest_box_around;
use crate::numeric::scaling::scale_by_power_of_two;
use along::{Along, Programs};
use exactly::exactly_around;

/// The share of ε within which the search keeps the ratio: what is left is for rounding.
const SHARE_OF_EPSILON: f64 = 0.999;

/// Where the number of generators is given, nearby ones are merged if the zonotope is longer by no more than this share
/// of ε then.
const NEARBY_SHARE_OF_EPSILON: f64 = 0.1;

/// The relative precision of the last linear program, along the directions that were found.
const LAST_PRECISION: f64 = 1e-14;

/// The relative precision of the linear programs of the search for a small volume.
const VOLUME_PRECISION: f64 = 1e-9;

/// Limit of the entries and products of points that the last linear program reads.
const LAST_WORK_LIMIT: u64 = 1 << 31;

/// Limit of the entries and products of points that the linear programs of the search for a small volume read.
const VOLUME_WORK_LIMIT: u64 = 1 << 30;

/// The descent does not begin at a zonotope of more generators: a step takes time as the cube of their number.
const VOLUME_GENERATORS: usize = 60;

/// The points that may be on the boundary, their frame, and in it the generators of an answer and the sides of boxes.
struct Search<const D: usize> {
    kept: Vec<[f64; D]>,
    frame: Frame<D>,
    dense: Vec<[f64; D]>,
    boxes: Vec<Vec<[f64; D]>>,
}

impl<const D: usize> Search<D> {
    fn new(points: &[[f64; D]], answer: &MinLengthZonotope<D>) -> Self {
        let kept: Vec<[f64; D]> = outer_points(points).into_iter().map(|j| points[j]).collect();
        let frame = Frame::new(&kept);
        let scaled = |g: &[f64; D]| frame.inside(&g.map(|c| scale_by_power_of_two(c, -frame.exponent)));
        let dense = answer.body.generators().iter().map(scaled).collect();
        let boxes = boxes::boxes(&kept, &frame);
        Self { kept, frame, dense, boxes }
    }

    /// The answer with the zonotope along the directions that were found, solved more precisely and made exact.
    fn concluded(&self, found: Along<D>, answer: &MinLengthZonotope<D>) -> Option<MinLengthZonotope<D>> {
        let programs = Programs::new(&self.frame, LAST_PRECISION, LAST_WORK_LIMIT);
        let used = found.used().0;
        // Along a thin side of the points the search may have left out all generators.
        let completed = || programs.along(&found.completed(&self.frame.long));
        let precise = programs.along(&used).or_else(completed).unwrap_or(found);
        let (body, value) = exactly_around(&self.kept, &self.frame, &precise)?;
        Some(MinLengthZonotope { body, value, ..answer.clone() })
    }
}

/// The answer with few generators, its ratio at most 1 + ε as before; the answer itself where none with fewer is found.
#[inline(never)]
pub fn fewest<const D: usize>(points: &[[f64; D]], answer: MinLengthZonotope<D>, epsilon: f64) -> MinLengthZonotope<D> {
    sparser(points, answer, epsilon, f64::INFINITY)
}

/// The answer with fewer generators, its ratio at most 1 + ε as before and longer by no more than `slack`; the answer
/// itself where none with fewer is found.
fn sparser<const D: usize>(
    points: &[[f64; D]],
    answer: MinLengthZonotope<D>,
    epsilon: f64,
    slack: f64,
) -> MinLengthZonotope<D> {
    if answer.value == 0.0 {
        return answer;
    }
    let search = Search::new(points, &answer);
    let within_ratio = (1.0 + SHARE_OF_EPSILON * epsilon) * answer.lower_bound;
    let limit = within_ratio.min(answer.value + slack).max(answer.value);
    let length = scale_by_power_of_two(limit, -search.frame.exponent);
    let sparse = search
        .fewest(length, epsilon)
        .and_then(|found| search.concluded(found, &answer))
        .filter(|sparse| sparse.ratio() <= answer.ratio().max(1.0 + epsilon));
    match sparse {
        Some(mut sparse) if is_sparser(&sparse, &answer) => {
            sparse.proof.outcome = outcome(&sparse, epsilon);
            sparse
        }
        _ => answer,
    }
}

/// Whether a zonotope has fewer generators than another one, or as many and is shorter.
fn is_sparser<const D: usize>(sparse: &MinLengthZonotope<D>, answer: &MinLengthZonotope<D>) -> bool {
    let key = |found: &MinLengthZonotope<D>| (found.body.generators().len(), found.value);
    key(sparse) < key(answer)
}

/// The shortest zonotope found with at most `count` generators; whether its ratio is at most 1 + ε, the outcome says.
///
/// # Errors
/// When the count is less than the dimension that the points span, or too small for the doubles around them.
#[inline(never)]
pub fn shortest_of_few<const D: usize>(
    points: &[[f64; D]],
    answer: MinLengthZonotope<D>,
    epsilon: f64,
    count: usize,
) -> Result<MinLengthZonotope<D>, MinLengthError> {
    let slack = NEARBY_SHARE_OF_EPSILON * epsilon * answer.lower_bound;
    if answer.body.generators().len() <= count {
        return Ok(sparser(points, answer, epsilon, slack));
    }
    let dimension = differences(points).rank();
    if count < dimension {
        return Err(MinLengthError::TooFewGenerators { count, needed: dimension });
    }
    let search = Search::new(points, &answer);
    let slack = scale_by_power_of_two(slack, -search.frame.exponent);
    // Generators that are needed off the frame: as many as the points span beyond it, or as the space does.
    let off = [dimension.saturating_sub(search.frame.rank()), D - search.frame.rank()];
    let with_off = |off: usize| {
        let found = search.shortest_of_few(count.checked_sub(off)?, slack)?;
        search.concluded(found, &answer).filter(|sparse| sparse.body.generators().len() <= count)
    };
    let replaced = |(body, value)| MinLengthZonotope { body, value, ..answer.clone() };
    let on_a_line = segment_around(points).map(replaced);
    let sparse = on_a_line.into_iter().chain(with_off(off[0]).or_else(|| with_off(off[1])));
    let sparse = sparse.min_by(|a, b| a.value.total_cmp(&b.value));
    // Around any points there is a box.
    let boxed = || if count < D { None } else { shortest_box_around(points).map(replaced) };
    let needed =
        if count < D { MinLengthError::TooFewGenerators { count, needed: D } } else { MinLengthError::OutOfRange };
    let mut sparse = sparse.or_else(boxed).ok_or(needed)?;
    sparse.proof.outcome = outcome(&sparse, epsilon);
    Ok(sparse)
}

/// A zonotope of space with the generators of an answer moved and changed until its volume is a local minimum; the
/// answer itself where none of less volume is found, or where points or generators do not span space. Its value is its
/// total length, whose ratio to the lower bound is proven as before, whatever it is.
pub fn of_less_volume(points: &[[f64; 3]], answer: MinLengthZonotope<3>, epsilon: f64) -> MinLengthZonotope<3> {
    let search = Search::new(points, &answer);
    if search.frame.rank() < 3 {
        return answer;
    }
    let own = Some(search.dense.clone()).filter(|dense| dense.len() <= VOLUME_GENERATORS);
    let starts = own.into_iter().chain(search.boxes.iter().cloned());
    let programs = Programs::new(&search.frame, VOLUME_PRECISION, VOLUME_WORK_LIMIT);
    let found = starts.filter_map(|start| programs.along(&start).map(|start| volume::of_less_volume(&programs, start)));
    let found = found.min_by(|a, b| volume::of(a).total_cmp(&volume::of(b)));
    let around = found.and_then(|found| exactly_around(&search.kept, &search.frame, &found));
    match around {
        Some((body, value)) if body.exact_volume() < answer.body.exact_volume() => {
            let mut smaller = MinLengthZonotope { body, value, ..answer };
            smaller.proof.outcome = outcome(&smaller, epsilon);
            smaller
        }
        _ => answer,
    }
}

/// Whether the ratio of an answer is at most 1 + ε.
fn outcome<const D: usize>(answer: &MinLengthZonotope<D>, epsilon: f64) -> Outcome {
    if answer.ratio() <= 1.0 + epsilon { Outcome::WithinEpsilon } else { Outcome::EndedBefore }
}

#[cfg(test)]
mod tests;
