//! Random motions of two copies of a mesh that pass each other at a clearance, or that come nearer by more than that.

use families::source::RandomSource;
use zonotope::Pose;
use zonotope::bvh::{Bvh, Mesh, OrientedBox};
use zonotope::motion::{KeyPose, Motion};

/// The wanted clearance in terms of the diagonal.
const CLEARANCE: f64 = 0.01;

/// By so much of the diagonal the other half of the motions comes nearer: the clearance, and the same again.
const NEARER: f64 = 0.02;

/// A clearance is reached when it is this share above the wanted one at most.
const SHARE: f64 = 0.1;

/// Steps of an approach.
const STEPS: usize = 40;

/// Times of a step at which an approach measures distances.
const SAMPLES: usize = 60;

/// A mesh about its middle, with the hierarchy that measures distances.
#[derive(Debug)]
pub struct MovedMesh {
    /// The mesh, the middle of its box at the origin.
    pub mesh: Mesh,
    /// Its hierarchy of searched boxes.
    pub boxes: Bvh<OrientedBox>,
    /// The diagonal of its box.
    pub diagonal: f64,
}

impl MovedMesh {
    /// A mesh, moved so that the middle of its box is at the origin.
    ///
    /// # Errors
    /// A sentence, if it leaves the range of doubles.
    pub fn of(mesh: &Mesh) -> Result<Self, String> {
        let bound = |choose: fn(f64, f64) -> f64, from: f64| {
            mesh.vertices().iter().fold([from; 3], |bound, v| [0, 1, 2].map(|k| choose(bound[k], v[k])))
        };
        let (low, high) = (bound(f64::min, f64::INFINITY), bound(f64::max, f64::NEG_INFINITY));
        let middle = [0, 1, 2].map(|k| 0.5 * (low[k] + high[k]));
        let vertices = mesh.vertices().iter().map(|v| plus(*v, -1.0, middle)).collect();
        let mesh = Mesh::new(vertices, mesh.triangles().to_vec()).map_err(|error| error.to_string())?;
        Ok(Self { boxes: Bvh::build(&mesh), mesh, diagonal: distance(low, high) })
    }

    /// The distance of two placed copies, from below.
    pub fn distance(&self, [a, b]: &[Pose; 2]) -> f64 {
        self.boxes.at(a).distance(self.boxes.at(b)).lower
    }

    /// The least distance at `samples` + 1 times of two motions, and its time.
    ///
    /// # Errors
    /// A sentence, if a pose leaves the range of doubles.
    pub fn nearest(&self, motions: &[Motion; 2], samples: usize) -> Result<(f64, f64), String> {
        let timed = |i: usize| {
            let time = i as f64 / samples as f64;
            let poses = poses_of(motions, time)?;
            Ok((middles_apart(&poses), time, poses))
        };
        let mut times = (0..=samples).map(timed).collect::<Result<Vec<_>, String>>()?;
        times.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut nearest = (f64::INFINITY, 0.0);
        for (apart, time, poses) in times {
            if apart - self.diagonal >= nearest.0 {
                break;
            }
            let distance = self.distance(&poses);
            if distance < nearest.0 {
                nearest = (distance, time);
            }
        }
        Ok(nearest)
    }

    /// Two courses that pass near each other, and two that come nearer.
    ///
    /// # Errors
    /// A sentence, if a pose leaves the range of doubles.
    pub fn courses(&self, source: &mut RandomSource, greatest_turn: f64) -> Result<[[Course; 2]; 2], String> {
        let size = self.diagonal;
        let way = unit(source);
        let aside = loop {
            let other = unit(source);
            let across = plus(other, -dot(other, way), way);
            if dot(across, across) > 0.1 {
                break across.map(|c| c / dot(across, across).sqrt());
            }
        };
        // both fly, the second one against the first
        let [near, far] = [0.5 * source.unit(), 0.5 + source.unit()].map(|c| c * size);
        let along = |length: f64| way.map(|c| c * length);
        let first = Course::random(source, greatest_turn, [along(-near), along(near)]);
        let second = Course::random(source, greatest_turn, [along(far), along(-far)]);
        let pair = |shift: f64| [first, second.moved(aside.map(|c| c * shift))];
        let wanted = CLEARANCE * size;
        let mut shift = 1.1 * size;
        for _ in 0..STEPS {
            let [a, b] = pair(shift);
            let (found, _) = self.nearest(&[a.rational()?, b.rational()?], SAMPLES)?;
            if found <= wanted * (1.0 + SHARE) {
                break;
            }
            shift -= found - wanted;
        }
        Ok([pair(shift), pair(shift - NEARER * size)])
    }
}

/// The motion of a mesh between two poses: a turn about its middle, which goes along a segment.
#[derive(Debug, Clone, Copy)]
pub struct Course {
    /// The quaternion of the first pose, the scalar first.
    pub first: [f64; 4],
    /// The axis of the turn, of unit length.
    pub axis: [f64; 3],
    /// The angle in radians.
    pub angle: f64,
    /// The place of the middle at the start.
    pub from: [f64; 3],
    /// The place of the middle at the end.
    pub to: [f64; 3],
}

impl Course {
    fn random(source: &mut RandomSource, greatest_turn: f64, [from, to]: [[f64; 3]; 2]) -> Self {
        let first = turn(unit(source), std::f64::consts::PI * source.signed_unit());
        Self { first, axis: unit(source), angle: greatest_turn * source.unit(), from, to }
    }

    fn moved(self, by: [f64; 3]) -> Self {
        let moved = |place| plus(place, 1.0, by);
        Self { from: moved(self.from), to: moved(self.to), ..self }
    }

    /// The rational motion.
    ///
    /// # Errors
    /// A sentence about numbers that are no motion.
    pub fn rational(&self) -> Result<Motion, String> {
        let key = |time, quaternion, translation| KeyPose { time, quaternion, translation };
        let last = product(turn(self.axis, self.angle), self.first);
        let keys = [key(0.0, self.first, self.from), key(1.0, last, self.to)];
        Motion::through(&keys).map_err(|error| error.to_string())
    }

    /// A bound above the speed of any point of the mesh that is not farther from the middle than `reach`, but for
    /// rounding: quaternions q, r of unit length with an angle of φ = `angle` / 2 turn at most by 2 sin φ / |s|² a unit
    /// of time, s = (q + r) / 2 the shortest one between them, |s| = cos(φ / 2).
    pub fn speed(&self, reach: f64) -> f64 {
        4.0 * libm::tan(self.angle / 4.0) * reach + distance(self.from, self.to)
    }
}

/// The poses of two motions at a time.
///
/// # Errors
/// A sentence, if one leaves the range of doubles.
pub fn poses_of(motions: &[Motion; 2], time: f64) -> Result<[Pose; 2], String> {
    let pose = |motion: &Motion| motion.pose_at(time).ok_or_else(|| format!("no pose in doubles at {time}"));
    Ok([pose(&motions[0])?, pose(&motions[1])?])
}

/// The distance of the middles of two placed meshes.
pub fn middles_apart([a, b]: &[Pose; 2]) -> f64 {
    distance(a.translation(), b.translation())
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|k| a[k] * b[k]).sum()
}

/// The vector a + t b.
fn plus(a: [f64; 3], t: f64, b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|k| a[k] + t * b[k])
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    let way = plus(a, -1.0, b);
    dot(way, way).sqrt()
}

fn unit(source: &mut RandomSource) -> [f64; 3] {
    loop {
        let v = [0; 3].map(|_| source.signed_unit());
        let square = dot(v, v);
        if (0.1..1.0).contains(&square) {
            return v.map(|c| c / square.sqrt());
        }
    }
}

/// The quaternion of a turn about an axis of unit length, the scalar first.
fn turn(axis: [f64; 3], angle: f64) -> [f64; 4] {
    let (sine, cosine) = libm::sincos(angle / 2.0);
    [cosine, sine * axis[0], sine * axis[1], sine * axis[2]]
}

/// The quaternion of the turn by `q` after the turn by `p`.
fn product(q: [f64; 4], p: [f64; 4]) -> [f64; 4] {
    let ([a, b, c, d], [e, f, g, h]) = (q, p);
    [
        a * e - b * f - c * g - d * h,
        a * f + b * e + c * h - d * g,
        a * g - b * h + c * e + d * f,
        a * h + b * g - c * f + d * e,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hierarchies::mesh;

    #[test]
    fn courses_pass_at_the_clearance_and_come_nearer() {
        let moved = MovedMesh::of(&mesh("torus").expect("it is a mesh")).expect("moved");
        let mut source = RandomSource::new(3);
        for _ in 0..3 {
            let found = moved.courses(&mut source, 1.0).expect("courses").map(|[a, b]| {
                let motions = [a.rational().expect("a motion"), b.rational().expect("a motion")];
                moved.nearest(&motions, SAMPLES).expect("poses").0 / moved.diagonal
            });
            assert!(found[0] <= CLEARANCE * (1.0 + SHARE) && found[1] < CLEARANCE, "{found:?}");
            assert!(found[0] > 0.0, "{found:?}");
        }
    }

    #[test]
    fn no_point_is_faster_than_the_bound() {
        let mut source = RandomSource::new(5);
        for greatest in [0.5, 3.1] {
            let course = Course::random(&mut source, greatest, [[0.0; 3], [1.0, 2.0, -2.0]]);
            let motion = course.rational().expect("a motion");
            let place = |time: f64, point: [f64; 3]| {
                let pose = motion.pose_at(time).expect("a pose");
                let (matrix, translation) = (pose.matrix(), pose.translation());
                [0, 1, 2].map(|i| dot(matrix[i], point) + translation[i])
            };
            let steps = 200;
            let mut fastest: f64 = 0.0;
            for point in [unit(&mut source), unit(&mut source), unit(&mut source)] {
                for step in 0..steps {
                    let [s, t] = [step, step + 1].map(|i| f64::from(i) / f64::from(steps));
                    fastest = fastest.max(distance(place(s, point), place(t, point)) * f64::from(steps));
                }
            }
            let bound = course.speed(1.0);
            assert!(fastest <= bound * (1.0 + 1e-9) && fastest > 0.3 * bound, "{fastest} of {bound}");
        }
    }
}
