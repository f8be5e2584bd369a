//! Random motions of two copies of a mesh that pass each other about one per cent of the diagonal apart, or that come
//! nearer by more than that.

use anyhow::Context;
use families::source::RandomSource;
use parry3d_f64::glamx::{DQuat, DVec3};
use parry3d_f64::math::{Pose as ParryPose, Vector};
use parry3d_f64::query::NonlinearRigidMotion;
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
pub struct Body {
    pub mesh: Mesh,
    pub boxes: Bvh<OrientedBox>,
    pub diagonal: f64,
}

impl Body {
    pub fn of(mesh: &Mesh) -> anyhow::Result<Self> {
        let bound = |choose: fn(f64, f64) -> f64, from: f64| {
            mesh.vertices().iter().fold([from; 3], |bound, v| [0, 1, 2].map(|k| choose(bound[k], v[k])))
        };
        let (low, high) = (bound(f64::min, f64::INFINITY), bound(f64::max, f64::NEG_INFINITY));
        let middle = [0, 1, 2].map(|k| 0.5 * (low[k] + high[k]));
        let vertices = mesh.vertices().iter().map(|v| [0, 1, 2].map(|k| v[k] - middle[k])).collect();
        let mesh = Mesh::new(vertices, mesh.triangles().to_vec())?;
        let diagonal = DVec3::from_array(high).distance(DVec3::from_array(low));
        Ok(Self { boxes: Bvh::build(&mesh), mesh, diagonal })
    }

    /// The least distance at `samples` + 1 times of two motions, and its time.
    pub fn nearest(&self, samples: usize, poses: impl Fn(f64) -> Option<[Pose; 2]>) -> anyhow::Result<(f64, f64)> {
        let mut nearest = (f64::INFINITY, 0.0);
        for (_, time) in self.by_middles(samples, &poses)? {
            let [a, b] = poses(time).context("a pose leaves the range of doubles")?;
            if middles_apart(&[a, b]) - self.diagonal >= nearest.0 {
                break;
            }
            let distance = self.boxes.at(&a).distance(self.boxes.at(&b)).lower;
            if distance < nearest.0 {
                nearest = (distance, time);
            }
        }
        Ok(nearest)
    }

    /// Times with the distances of the middles there, the nearest first.
    pub fn by_middles(
        &self,
        samples: usize,
        poses: &impl Fn(f64) -> Option<[Pose; 2]>,
    ) -> anyhow::Result<Vec<(f64, f64)>> {
        let time = |i: usize| i as f64 / samples as f64;
        let apart = |i: usize| Some((middles_apart(&poses(time(i))?), time(i)));
        let times = (0..=samples).map(apart).collect::<Option<Vec<_>>>();
        let mut times = times.context("a pose leaves the range of doubles")?;
        times.sort_by(|a, b| a.0.total_cmp(&b.0));
        Ok(times)
    }
}

/// The distance of the middles of two placed bodies.
pub fn middles_apart([a, b]: &[Pose; 2]) -> f64 {
    DVec3::from_array(a.translation()).distance(DVec3::from_array(b.translation()))
}

/// The motion of a body between two poses: a turn about its middle, which goes along a segment.
#[derive(Clone, Copy)]
pub struct Course {
    first: DQuat,
    axis: DVec3,
    angle: f64,
    from: DVec3,
    to: DVec3,
}

impl Course {
    fn random(source: &mut RandomSource, greatest_turn: f64, [from, to]: [DVec3; 2]) -> Self {
        let first = DQuat::from_axis_angle(unit(source), std::f64::consts::PI * source.signed_unit());
        Self { first, axis: unit(source), angle: greatest_turn * source.unit(), from, to }
    }

    fn moved(self, by: DVec3) -> Self {
        Self { from: self.from + by, to: self.to + by, ..self }
    }

    /// The rational motion.
    pub fn rational(&self) -> anyhow::Result<Motion> {
        let key = |time: f64, q: DQuat, at: DVec3| KeyPose {
            time,
            quaternion: [q.w, q.x, q.y, q.z],
            translation: at.to_array(),
        };
        let last = DQuat::from_axis_angle(self.axis, self.angle) * self.first;
        Ok(Motion::through(&[key(0.0, self.first, self.from), key(1.0, last, self.to)])?)
    }

    /// The motion at constant rate between the same poses.
    pub fn at_constant_rate(&self) -> NonlinearRigidMotion {
        let start = ParryPose::from_parts(self.from, self.first);
        NonlinearRigidMotion::new(start, Vector::ZERO, self.to - self.from, self.axis * self.angle)
    }
}

/// The poses of two rational motions at a time.
pub fn poses_of(motions: &[Motion; 2], time: f64) -> Option<[Pose; 2]> {
    Some([motions[0].pose_at(time)?, motions[1].pose_at(time)?])
}

/// Two courses that pass near each other, and two that come nearer.
pub fn courses(body: &Body, source: &mut RandomSource, greatest_turn: f64) -> anyhow::Result<[[Course; 2]; 2]> {
    let size = body.diagonal;
    let way = unit(source);
    let aside = way.any_orthonormal_pair();
    let (sine, cosine) = libm::sincos(std::f64::consts::PI * source.signed_unit());
    let aside = aside.0 * cosine + aside.1 * sine;
    // both fly, the second one against the first
    let lengths = [0.5 * source.unit(), 0.5 + source.unit()].map(|c| c * size);
    let first = Course::random(source, greatest_turn, [-way * lengths[0], way * lengths[0]]);
    let second = Course::random(source, greatest_turn, [way * lengths[1], -way * lengths[1]]);
    let pair = |shift: f64| [first, second.moved(aside * shift)];
    let wanted = CLEARANCE * size;
    let mut shift = 1.1 * size;
    for _ in 0..STEPS {
        let [a, b] = pair(shift);
        let motions = [a.rational()?, b.rational()?];
        let (found, _) = body.nearest(SAMPLES, |time| poses_of(&motions, time))?;
        if found <= wanted * (1.0 + SHARE) {
            break;
        }
        shift -= found - wanted;
    }
    Ok([pair(shift), pair(shift - NEARER * size)])
}

fn unit(source: &mut RandomSource) -> DVec3 {
    loop {
        let v = DVec3::from_array([0; 3].map(|_| source.signed_unit()));
        if (0.1..1.0).contains(&v.length_squared()) {
            return v.normalize();
        }
    }
}
