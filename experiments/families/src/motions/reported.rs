//! Motions of public reports on collisions that a library missed, by the numbers of the reports.

use super::family::{BodyRow, Course, MotionFamily, MovingPair};
use super::shapes::upright_box;

/// parry, issue 317: a nonlinear cast of a cuboid that turns and goes into a resting one finds nothing.
pub(super) const PARRY_317: MotionFamily = MotionFamily {
    id: "parry_317",
    title: "parry 317",
    description: "a cuboid that turns by about 100 degrees while it goes into a resting one",
    generate: |_| {
        let moving = ([6458.7905, -209.1331, 1014.52124], [-0.542044, 5.3359954e-20, 9.459897e-20, -0.84035015]);
        let resting = ([6079.4917, -849.3108, 853.8756], [0.99999607, 0.002524775, -0.00026210435, -0.0012064485]);
        let arm = turned(&moving.1, [99.97085, -2.2888184e-5, -35.0]);
        let course = Course {
            axis_point: [0, 1, 2].map(|k| moving.0[k] + arm[k]),
            axis: [0.0, 0.0, -1.0],
            angle: 1.770823,
            translation: [588.2583, -553.06335, 471.54688],
        };
        MovingPair {
            bodies: [placed_box(moving, [235.0, 105.0, 110.0]), placed_box(resting, [650.0, 330.0, 275.0])],
            courses: [course, Course::REST],
            aside: [0.0, 0.0, -1.0],
        }
    },
};

/// rapier.js, issue 258: casts past a thin rectangle; of the cast shape the middle, for which the report casts a ray.
pub(super) const RAPIER_JS_258: MotionFamily = MotionFamily {
    id: "rapier_js_258",
    title: "rapier.js 258",
    description: "a point that goes through a thin rectangle, in one of two ways",
    generate: |seed| {
        let [halves, center, from, to] = match seed % 2 {
            0 => [[244.5, 0.5], [884.5, 188.5], [380.0, 241.0], [1004.0, 137.0]],
            _ => [[335.0, 0.5], [408.0, 286.5], [894.0, 328.0], [385.0, 217.0]],
        };
        let mut rectangle = upright_box([center[0], center[1], 0.0], [halves[0], halves[1], 0.0]);
        rectangle.generators.truncate(2);
        let translation = [to[0] - from[0], to[1] - from[1], 0.0];
        MovingPair {
            bodies: [BodyRow { center: [from[0], from[1], 0.0], generators: Vec::new() }, rectangle],
            courses: [Course { translation, ..Course::REST }, Course::REST],
            aside: [0.0, 1.0, 0.0],
        }
    },
};

/// A box with these half sides, placed by a translation and a quaternion [w, x, y, z] of about unit length.
fn placed_box((center, quaternion): ([f64; 3], [f64; 4]), [x, y, z]: [f64; 3]) -> BodyRow {
    let sides = [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]];
    BodyRow { center, generators: sides.map(|side| turned(&quaternion, side)).to_vec() }
}

/// v + 2 w (q × v) + 2 q × (q × v), over the squared length of the quaternion (w, q).
fn turned(&[w, x, y, z]: &[f64; 4], v: [f64; 3]) -> [f64; 3] {
    let cross = |u: [f64; 3]| [y * u[2] - z * u[1], z * u[0] - x * u[2], x * u[1] - y * u[0]];
    let (once, square) = (cross(v), w * w + x * x + y * y + z * z);
    let twice = cross(once);
    [0, 1, 2].map(|k| v[k] + 2.0 * (w * once[k] + twice[k]) / square)
}
