//! Order reduction, by Scott's rule: generators are put one by one into a parallelepiped along some of them, each time
//! the one that makes it grow least.
//!
//! # Source
//! Not in the paper: J. K. Scott, D. M. Raimondo, G. R. Marseglia and R. D. Braatz, Constrained zonotopes, 2016, where
//! it reduces zonotopes without constraints.
//!
//! # Method
//! 1. Choose D generators as a frame by elimination with full pivoting: each time the longest coordinate that is left.
//! 2. Write the others in this frame. To put v = Σ r_l f_l into the parallelepiped, lengthen each f_l by 1 + |r_l|; its
//!    volume grows by the factor Π (1 + |r_l|), of which the new segment accounts for 1 + Σ |r_l|.
//! 3. Put in the generator with the least Π (1 + |r_l|) − 1 − Σ |r_l|, divide the coordinates of all others by
//!    1 + |r_l|, and repeat until k generators are left, the frame's included.
//!
//! # Complexity
//! O(n (n − k) D) and O(n) space.
//!
//! # Numerics
//! The choices are made in floating point. The frame's directions and half-lengths are rounded as for
//! [`by_pca`](super::by_pca), and containment is exact. A body without an interior has no such frame: it gets a box.
//!
//! # Example
//! ```
//! use zonotope::{Zonotope, reduction::{Problem, keeping::by_scott::scott}};
//! let body = Zonotope::new([0.0, 0.0], vec![[4.0, 0.0], [0.0, 4.0], [1.0, 0.0], [1.0, 1.0]])?;
//! let reduced = scott(&Problem::new(&body, 3)?)?;
//! // (1, 0) is parallel to the frame, and costs nothing
//! assert_eq!(reduced.body.generators(), [[1.0, 1.0], [5.0, 0.0], [0.0, 4.0]]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::super::answer::{Problem, Reduced, ReductionError};
use super::super::frame_cover::Frame;
use super::order::{by_falling_score, distance_from_axes, scaled, with_kept};
use crate::numeric::linear::{add_multiple, dot, inverse};

/// The reduction by Scott's rule.
///
/// # Errors
/// [`ReductionError::OutOfRange`] if a generator leaves the range of doubles.
pub fn scott<const D: usize>(problem: &Problem<'_, D>) -> Result<Reduced<D>, ReductionError> {
    if let Some(same) = problem.unreduced() {
        return Ok(same);
    }
    let vectors = scaled(problem.body().generators());
    let chosen = independent_generators(&vectors);
    let by_rows: [[f64; D]; D] = std::array::from_fn(|k| std::array::from_fn(|l| vectors[chosen[l]][k]));
    let Some(to_frame) = inverse(D, &by_rows) else {
        let scores: Vec<f64> = vectors.iter().map(distance_from_axes).collect();
        return with_kept(problem, &by_falling_score(&scores)[..problem.count() - D], Frame::Axes);
    };
    let mut others: Vec<(usize, [f64; D])> = (0..vectors.len())
        .filter(|index| !chosen.contains(index))
        .map(|index| (index, to_frame.map(|row| dot(&row, &vectors[index]).abs())))
        .collect();
    while others.len() + D > problem.count() {
        let growth = |r: &[f64; D]| r.iter().map(|c| 1.0 + c).product::<f64>() - 1.0 - r.iter().sum::<f64>();
        let best = (0..others.len()).min_by(|&a, &b| growth(&others[a].1).total_cmp(&growth(&others[b].1)));
        let Some((_, taken)) = best.map(|at| others.remove(at)) else { break };
        for (_, coordinates) in &mut others {
            coordinates.iter_mut().zip(taken).for_each(|(c, r)| *c /= 1.0 + r);
        }
    }
    let kept: Vec<usize> = others.iter().map(|(index, _)| *index).collect();
    with_kept(problem, &kept, Frame::Along(chosen.map(|index| vectors[index])))
}

/// D generators by elimination with full pivoting: each has the largest coordinate that the ones before it leave. Where
/// nothing is left, an index repeats.
fn independent_generators<const D: usize>(vectors: &[[f64; D]]) -> [usize; D] {
    let mut left = vectors.to_vec();
    std::array::from_fn(|_| {
        let coordinates = left.as_flattened();
        let mut at = 0;
        for (place, c) in coordinates.iter().enumerate() {
            if c.abs() > coordinates[at].abs() {
                at = place;
            }
        }
        let (index, axis) = (at / D, at % D);
        let pivot = left[index];
        if pivot[axis] != 0.0 {
            for v in &mut left {
                let factor = v[axis] / pivot[axis];
                add_multiple(v, -factor, &pivot);
                v[axis] = 0.0;
            }
        }
        index
    })
}
