//! Stage: points that span what all points span, up to four of them: two apart, three not on a line, four not in a
//! plane. Points far from each other are looked for in doubles; that they span is decided exactly.

use std::cmp::Ordering;

use crate::numeric::linear::{cross, dot};
use crate::numeric::orientation::in_space::side_of_plane;
use crate::numeric::orientation::{Turn, orientation};

/// The affine hull of some points, by as many of them as span it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Spanned {
    /// All points are equal to this one.
    Place(usize),
    /// All points lie on the line through these two.
    Line([usize; 2]),
    /// All points lie in the plane through these three.
    Plane([usize; 3]),
    /// The points span space; the last of these lies below the plane of the others, which are counter-clockwise.
    Space([usize; 4]),
}

/// The points that span the affine hull of all, of which there is at least one.
pub(super) fn spanned(points: &[[f64; 3]]) -> Spanned {
    let from = |a: usize, p: usize| -> [f64; 3] { std::array::from_fn(|c| points[p][c] - points[a][c]) };
    let square = |v: [f64; 3]| dot(&v, &v);
    let far = |height: &dyn Fn(usize) -> f64, spans: &dyn Fn(usize) -> bool| {
        let farthest = (0..points.len()).max_by(|&p, &q| height(p).total_cmp(&height(q)));
        farthest.filter(|&p| spans(p)).or_else(|| (0..points.len()).find(|&p| spans(p)))
    };
    let a = (0..points.len()).fold(0, |least, p| if points[p] < points[least] { p } else { least });
    let Some(b) = far(&|p| square(from(a, p)), &|p| points[p] != points[a]) else {
        return Spanned::Place(a);
    };
    let along = from(a, b);
    let is_off_line = |p: usize| plane_axes(&[a, b, p].map(|i| points[i])).is_some();
    let Some(c) = far(&|p| square(cross(&along, &from(a, p))), &is_off_line) else {
        return Spanned::Line([a, b]);
    };
    let normal = cross(&along, &from(a, c));
    let side = |p: usize| side_of_plane(&points[a], &points[b], &points[c], &points[p]);
    let Some(d) = far(&|p| dot(&normal, &from(a, p)).abs(), &|p| side(p) != Ordering::Equal) else {
        return Spanned::Plane([a, b, c]);
    };
    Spanned::Space(if side(d) == Ordering::Less { [a, b, c, d] } else { [a, c, b, d] })
}

/// Two axes along which three points that are not on a line still are not; `None` for points on a line.
pub(super) fn plane_axes([a, b, c]: &[[f64; 3]; 3]) -> Option<[usize; 2]> {
    [[0, 1], [1, 2], [2, 0]].into_iter().find(|&[i, j]| {
        let shadow = |p: &[f64; 3]| [p[i], p[j]];
        orientation(shadow(a), shadow(b), shadow(c)) != Turn::Straight
    })
}
