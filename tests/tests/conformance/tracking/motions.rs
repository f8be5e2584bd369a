//! Motions of two bodies, frame by frame, that lead through contact: where the bodies are is chosen by where they
//! touch.

use experiments::question::{Placement, Question};
use families::source::RandomSource;
use zonotope::Pose;
use zonotope::collision::{Query, by_lad};
use zonotope::zonotope::Zonotope;

/// The poses of both bodies in a frame.
pub type Frame = [Pose; 2];

/// A kind of motion, and its frames for two bodies whose centres are at the origin.
#[derive(Clone, Copy)]
pub struct Motion {
    pub id: &'static str,
    pub only_translates: bool,
    pub frames: fn(&[Zonotope<3>; 2], &mut RandomSource, usize) -> Vec<Frame>,
}

/// All kinds of motion.
pub const MOTIONS: [Motion; 7] = [
    Motion { id: "pass", only_translates: true, frames: pass },
    Motion { id: "graze", only_translates: true, frames: graze },
    Motion { id: "touch", only_translates: true, frames: touch },
    Motion { id: "jump", only_translates: true, frames: jump },
    Motion { id: "spin", only_translates: false, frames: spin },
    Motion { id: "turn", only_translates: false, frames: turn },
    Motion { id: "distort", only_translates: false, frames: distort },
];

/// The distance that a motion goes in a frame, in terms of the size of the bodies or of a radian.
const SPEEDS: [f64; 5] = [1e-9, 1e-6, 1e-4, 1e-2, 0.3];

/// The distance from contact that a motion keeps, in terms of the size of the bodies.
const GAPS: [f64; 6] = [0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-2];

fn vector(source: &mut RandomSource) -> [f64; 3] {
    [0, 1, 2].map(|_| source.signed_unit())
}

fn one_of<const N: usize>(source: &mut RandomSource, values: [f64; N]) -> f64 {
    values[source.below(N)]
}

fn translation(t: [f64; 3]) -> Pose {
    Pose::from_translation(t.map(|c| c.clamp(-f64::MAX, f64::MAX))).expect("the coordinates are finite")
}

fn plus(a: [f64; 3], factor: f64, b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|k| a[k] + factor * b[k])
}

/// A multiple of a displacement at which bodies under poses touch, nearly; 1 if there is none.
fn at_contact(bodies: &[Zonotope<3>; 2], [from, to]: &Frame, displacement: [f64; 3]) -> f64 {
    let to = Pose::new(to.matrix(), displacement).expect("finite");
    let gauge = by_lad::gauge(&Query::of_placed(bodies[0].at(from), bodies[1].at(&to)), &mut ()).value;
    if gauge.is_normal() && (1.0 / gauge).is_normal() { 1.0 / gauge } else { 1.0 }
}

const STILL: Frame = [Pose::IDENTITY; 2];

/// The second body passes by or through the first one on a line.
fn pass(bodies: &[Zonotope<3>; 2], source: &mut RandomSource, count: usize) -> Vec<Frame> {
    let direction = vector(source);
    let size = at_contact(bodies, &STILL, direction);
    let way = vector(source);
    let speed = one_of(source, SPEEDS) * size;
    let start = plus(direction.map(|c| c * size), -speed * count as f64 / 2.0, way);
    (0..count).map(|i| [Pose::IDENTITY, translation(plus(start, speed * i as f64, way))]).collect()
}

/// The second body slides around the first one, a little away from it, a little into it, or in contact but for
/// rounding.
fn graze(bodies: &[Zonotope<3>; 2], source: &mut RandomSource, count: usize) -> Vec<Frame> {
    let (mut direction, way, speed) = (vector(source), vector(source), one_of(source, SPEEDS));
    let gap = one_of(source, GAPS);
    let frame = |i: usize| {
        direction = plus(direction, speed, way);
        let side = if i % 8 < 4 { 1.0 } else { -1.0 };
        let factor = at_contact(bodies, &STILL, direction) * (1.0 + side * gap);
        [Pose::IDENTITY, translation(direction.map(|c| c * factor))]
    };
    (0..count).map(frame).collect()
}

/// The bodies touch, exactly, leave by a unit in the last place, and come back.
fn touch(bodies: &[Zonotope<3>; 2], source: &mut RandomSource, count: usize) -> Vec<Frame> {
    let generators = [bodies[0].generators(), bodies[1].generators()].concat();
    let touching = Placement::find("touching").expect("there is one");
    let Some(Question { from, to, .. }) = Question::about(generators, touching, source.bits()) else {
        return graze(bodies, source, count);
    };
    let step = |c: f64, way: usize| match way {
        0 => c.next_up(),
        1 => c.next_down(),
        _ => c,
    };
    let frame = |i: usize| {
        let to = if i.is_multiple_of(2) { to } else { to.map(|c| step(c, source.below(4))) };
        [translation(from), translation(to)]
    };
    (0..count).map(frame).collect()
}

/// Every frame is elsewhere.
fn jump(bodies: &[Zonotope<3>; 2], source: &mut RandomSource, count: usize) -> Vec<Frame> {
    let frame = |_| {
        let direction = vector(source);
        let factor = at_contact(bodies, &STILL, direction) * one_of(source, [0.0, 0.3, 0.999, 1.0, 1.001, 3.0]);
        let offset = vector(source);
        [translation(offset), translation(plus(offset, factor, direction))]
    };
    (0..count).map(frame).collect()
}

/// Both bodies spin, in contact but for a gap.
fn spin(bodies: &[Zonotope<3>; 2], source: &mut RandomSource, count: usize) -> Vec<Frame> {
    let speeds = [0, 1].map(|_| if source.below(3) == 0 { 0.0 } else { one_of(source, SPEEDS) });
    let axes = [vector(source), vector(source)];
    let (direction, gap) = (vector(source), one_of(source, GAPS));
    let frame = |i: usize| {
        let turned = [0, 1].map(|k| {
            let angle = speeds[k] * i as f64;
            Pose::from_axis_angle(axes[k], angle, [0.0; 3]).expect("a random vector is not zero")
        });
        let side = if i % 8 < 4 { 1.0 } else { -1.0 };
        let factor = at_contact(bodies, &turned, direction) * (1.0 + side * gap);
        [turned[0], Pose::new(turned[1].matrix(), direction.map(|c| c * factor)).expect("finite")]
    };
    (0..count).map(frame).collect()
}

/// Both bodies turn in place, near each other: into contact and out of it.
fn turn(bodies: &[Zonotope<3>; 2], source: &mut RandomSource, count: usize) -> Vec<Frame> {
    let (axes, speed) = ([vector(source), vector(source)], one_of(source, SPEEDS));
    let direction = vector(source);
    let factor = at_contact(bodies, &STILL, direction) * one_of(source, [0.7, 0.9, 0.99, 1.01, 1.1]);
    let frame = |i: usize| {
        let turned = [0, 1].map(|k| {
            let way = direction.map(|c| c * factor * k as f64);
            Pose::from_axis_angle(axes[k], speed * i as f64, way).expect("a random vector is not zero")
        });
        [turned[0], turned[1]]
    };
    (0..count).map(frame).collect()
}

/// Matrices that scale, mirror and flatten as well, and change slowly or at once.
fn distort(bodies: &[Zonotope<3>; 2], source: &mut RandomSource, count: usize) -> Vec<Frame> {
    let speed = one_of(source, SPEEDS);
    let mut matrices = [0, 1].map(|_| [vector(source), vector(source), vector(source)]);
    let direction = vector(source);
    let frame = |i: usize| {
        for matrix in &mut matrices {
            let other = [vector(source), vector(source), vector(source)];
            *matrix = match i % 16 {
                13 => [[1.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, -1.0]],
                14 => other,
                _ => [0, 1, 2].map(|k| plus(matrix[k], speed, other[k])),
            };
        }
        let posed = matrices.map(|matrix| Pose::new(matrix, [0.0; 3]).expect("finite"));
        let factor = at_contact(bodies, &posed, direction) * one_of(source, [0.5, 1.0, 1.0 + 1e-9, 1.5]);
        [posed[0], Pose::new(posed[1].matrix(), direction.map(|c| c * factor)).expect("finite")]
    };
    (0..count).map(frame).collect()
}
