//! Poses of a copy of a mesh at given distances from the mesh.

use families::source::RandomSource;
use zonotope::Pose;
use zonotope::bvh::{Bvh, OrientedBox};

/// Distances in terms of the diagonal of the box around the mesh, from far to near.
pub const DISTANCES: [f64; 4] = [0.3, 0.1, 0.01, 0.001];

/// The depth of overlapping copies along the direction of approach, in terms of the diagonal.
const OVERLAP: f64 = 0.01;

/// A distance is reached when it is this share above the wanted one at most.
const SHARE: f64 = 0.005;

/// A step of an approach is at least this part of the wanted distance.
const LEAST_STEP: f64 = 1e-3;

/// The poses of the second copy along one direction.
#[derive(Clone, Debug)]
pub struct Placed {
    /// At each of the distances.
    pub apart: [Pose; DISTANCES.len()],
    /// Beyond the first contact.
    pub overlapping: Pose,
}

/// Poses by random rotations and directions: a copy comes nearer along a direction, never by more than its distance,
/// until it is at the wanted one.
pub(super) fn poses(hierarchy: &Bvh<OrientedBox>, count: usize, seed: u64) -> Vec<Placed> {
    let (low, high) = hierarchy.mesh().vertices().iter().fold(([f64::MAX; 3], [f64::MIN; 3]), |(low, high), v| {
        (std::array::from_fn(|k| v[k].min(low[k])), std::array::from_fn(|k| v[k].max(high[k])))
    });
    let length = |v: [f64; 3]| v.iter().map(|c| c * c).sum::<f64>().sqrt();
    let size = length(std::array::from_fn(|k| high[k] - low[k]));
    let center: [f64; 3] = std::array::from_fn(|k| 0.5 * (low[k] + high[k]));
    let mut random = RandomSource::new(seed);
    let mut placed = Vec::new();
    while placed.len() < count {
        let (quaternion, direction) = ([0; 4].map(|_| random.signed_unit()), [0; 3].map(|_| random.signed_unit()));
        let [q, d] = [quaternion.iter().map(|c| c * c).sum::<f64>(), length(direction).powi(2)];
        if !(0.1..1.0).contains(&q) || !(0.1..1.0).contains(&d) {
            continue;
        }
        let matrix = Pose::from_quaternion(quaternion, [0.0; 3]).expect("not zero").matrix();
        let along = direction.map(|c| c / length(direction));
        // about the middle of the box, moved along the direction
        let turned: [f64; 3] = std::array::from_fn(|i| (0..3).map(|k| matrix[i][k] * center[k]).sum());
        let pose =
            |t: f64| Pose::new(matrix, std::array::from_fn(|k| center[k] - turned[k] + t * along[k])).expect("finite");
        let distance = |t: f64| hierarchy.distance(hierarchy.at(&pose(t))).lower;
        let mut t = 2.0 * size;
        let apart = DISTANCES.map(|wanted| {
            let wanted = wanted * size;
            loop {
                let found = distance(t);
                if found <= wanted * (1.0 + SHARE) {
                    return pose(t);
                }
                t -= (found - wanted).max(LEAST_STEP * wanted);
            }
        });
        // the nearest distance is as good as contact
        let overlapping = pose(t - (DISTANCES[DISTANCES.len() - 1] + OVERLAP) * size);
        if hierarchy.intersects(hierarchy.at(&overlapping)) {
            placed.push(Placed { apart, overlapping });
        }
    }
    placed
}
