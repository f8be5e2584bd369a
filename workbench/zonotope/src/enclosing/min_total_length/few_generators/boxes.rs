//! Stage: boxes that the search begins with, by the directions of their sides.

use crate::enclosing::min_total_length::frame::Frame;
use crate::enclosing::oriented_box::{small_box, smallest_rectangle};

/// The directions of the sides of boxes, in the coordinates of the frame: along [`Frame::long`], and where the points
/// span the space along its axes and those of the smallest box that is known.
///
/// The zonotope along the sides of a box is that box, and the search only gets shorter or smaller from there. So what
/// it finds is no worse than any of these boxes.
pub(super) fn boxes<const D: usize>(points: &[[f64; D]], frame: &Frame<D>) -> Vec<Vec<[f64; D]>> {
    let mut boxes = vec![frame.long.clone()];
    if frame.rank() == D {
        let axis = |axis: usize| std::array::from_fn(|c| f64::from(u8::from(c == axis)));
        let spanning = [Some((0..D).map(axis).collect()), sides_of_smallest(points)];
        let inside = |sides: Vec<[f64; D]>| sides.iter().map(|v| frame.inside(v)).collect();
        boxes.extend(spanning.into_iter().flatten().map(inside));
    }
    boxes
}

/// The axes of the smallest rectangle of the plane, or of the smallest box of space that is found; none elsewhere.
fn sides_of_smallest<const D: usize>(points: &[[f64; D]]) -> Option<Vec<[f64; D]>> {
    fn embedded<const E: usize, const D: usize>(v: &[f64; E]) -> [f64; D] {
        std::array::from_fn(|c| v[c])
    }
    match D {
        2 => {
            let points: Vec<[f64; 2]> = points.iter().map(embedded).collect();
            Some(smallest_rectangle(&points)?.axes.iter().map(embedded).collect())
        }
        3 => {
            let points: Vec<[f64; 3]> = points.iter().map(embedded).collect();
            Some(small_box(&points)?.axes.iter().map(embedded).collect())
        }
        _ => None,
    }
}
