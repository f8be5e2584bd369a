//! The truth about a placement: whether a volume holds it, by every direction that can be normal to a facet.
//!
//! # Statement
//! Input: a volume, a sweep, a body and two numbers. Output: whether the volume contains the body turned by the angle
//! of which half has the tangent t |axis|, and moved by s times the translation; the largest squared distance of a
//! vertex from the axis.
//!
//! # Source
//! Section 6, from the definitions.
//!
//! # Method
//! A convex body lies in the zonotope just when its support function is nowhere larger along cross products of two
//! generators; for flat ones also along those with coordinate axes and with a third factor. The farthest vertex is
//! found by all choices of signs.
//!
//! # Complexity
//! O(m² (m + n)) for m generators of the volume, O(2^n n) for the farthest vertex, in exact numbers.
//!
//! # Shapes
//! Input and output: centres and generators of space, generators in half-lengths; zero and parallel ones, none, and
//! bodies that the axis goes through are allowed.
//!
//! # Numerics
//! Everything is exact.
//!
//! # Panics
//! If a number is not finite.
//!
//! # Checked by
//! Points on a circle in the example, and every other method's tests.
//!
//! # Example
//! ```
//! use zonotope::Zonotope;
//! use zonotope::motion::space_time::{Sweep, by_farthest_vertex::volume};
//! use zonotope::motion::space_time::brute_force::holds_placement;
//! let point = Zonotope::new([1.0, 0.0, 0.0], vec![])?;
//! let sweep = Sweep::new([0.0; 3], [0.0, 0.0, 1.0], 0.5, [0.0; 3])?;
//! let volume = volume(&sweep, &point, &mut ())?;
//! assert!(holds_placement(&volume, &sweep, &point, 0.25, 0.0)); // 2 atan(0.25) = 0.49
//! assert!(!holds_placement(&volume, &sweep, &point, -1.0, 0.0));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use crate::motion::quaternion::{image, polar_rotation, transposed_image};
use crate::motion::sweep::Sweep;
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, cross, difference, dot, exact, is_zero, multiple, sum};
use crate::zonotope::Zonotope;

/// Whether a volume contains a placement of a body: turned by twice the angle whose tangent is t |axis|, then moved by
/// s times the translation.
///
/// # Panics
/// If a number is not finite.
pub fn holds_placement(volume: &Zonotope<3>, sweep: &Sweep, body: &Zonotope<3>, t: f64, s: f64) -> bool {
    let vector = multiple(&Dyadic::from_f64(t), &exact(sweep.axis));
    let [x, y, z] = vector.clone();
    let quaternion = [Dyadic::one(), x, y, z];
    let square = crate::numeric::linear::dot(&quaternion, &quaternion);
    let matrix = polar_rotation(&quaternion, &quaternion);
    let point = exact(sweep.axis_point);
    let base = sum(&point, &multiple(&Dyadic::from_f64(s), &exact(sweep.translation)));
    // the centre of the placement seen from that of the volume, times the square
    let arm = image(&matrix, &difference(&exact(body.center()), &point));
    let off = sum(&arm, &multiple(&square, &difference(&base, &exact(volume.center()))));
    let generators: Vec<ExactVector> = volume.generators().iter().map(|g| exact(*g)).collect();
    let own: Vec<ExactVector> = body.generators().iter().map(|g| exact(*g)).collect();
    normals(&generators).iter().all(|u| {
        let back = transposed_image(&matrix, u);
        let reach =
            |u: &ExactVector, list: &[ExactVector]| list.iter().fold(Dyadic::zero(), |sum, g| sum + dot(u, g).abs());
        dot(u, &off).abs() + reach(&back, &own) <= &square * &reach(u, &generators)
    })
}

/// Directions among which are those normal to the facets of a zonotope of any dimension, and those that show what lies
/// off its span.
fn normals(generators: &[ExactVector]) -> Vec<ExactVector> {
    let axes = [0, 1, 2].map(|k| [0, 1, 2].map(|i| if i == k { Dyadic::one() } else { Dyadic::zero() }));
    let factors: Vec<&ExactVector> = generators.iter().chain(&axes).collect();
    let mut normals = axes.to_vec();
    for (i, a) in factors.iter().enumerate() {
        for b in &factors[..i] {
            let normal = cross(a, b);
            if !is_zero(&normal) {
                normals.extend([cross(&normal, a), cross(&normal, b), normal]);
            }
        }
    }
    normals
}

/// The largest squared distance of a vertex of a body from the axis, by all choices of signs.
pub fn farthest_squared(sweep: &Sweep, body: &Zonotope<3>) -> Rational {
    let axis = exact(sweep.axis);
    let off_axis = |v: &ExactVector| cross(&axis, v);
    let start = vec![off_axis(&difference(&exact(body.center()), &exact(sweep.axis_point)))];
    let ends = body
        .generators()
        .iter()
        .map(|g| off_axis(&exact(*g)))
        .fold(start, |ends, g| ends.iter().flat_map(|end| [sum(end, &g), difference(end, &g)]).collect());
    let farthest = ends.iter().map(|end| dot(end, end)).max().unwrap_or_else(Dyadic::zero);
    farthest.to_rational() / dot(&axis, &axis).to_rational()
}
