//! The first contacts that this library finds, with tests of nodes beside those of one static question.

use std::hint::black_box;
use std::time::Instant;

use anyhow::{Error, bail};
use experiments::hierarchies::{MovedMesh, poses_of};
use zonotope::bvh::{BoundingVolume, Bvh};
use zonotope::motion::Motion;
use zonotope::motion::continuous::by_control_points::DEFAULT_RESOLUTION;
use zonotope::motion::continuous::of_meshes::{MeshContact, first_contact, first_contact_counted};
use zonotope::tally::{Operation, OperationCounts};

/// The least of so many rounds is the time of a motion, and of a static question.
const ROUNDS: [usize; 2] = [3, 5];

/// Distances by which the closest placement is found.
const SAMPLES: usize = 200;

/// The name, times and tests of a volume on many motions.
pub struct Tallied {
    pub name: String,
    /// Microseconds of motions without contact, with one, and with neither proved.
    pub times: [Vec<f64>; 3],
    /// Tests of nodes of motions without contact.
    pub nodes: Vec<f64>,
    /// Tests of nodes of the static question at the closest placement.
    pub static_nodes: Vec<f64>,
    /// Tests of nodes, and the time, in terms of those of the static question.
    pub ratios: [Vec<f64>; 2],
}

/// The least time in microseconds.
pub fn timed<T>(rounds: usize, ask: impl Fn() -> T) -> f64 {
    let round = |_| {
        let start = Instant::now();
        black_box(ask());
        start.elapsed().as_secs_f64() * 1e6
    };
    (0..rounds).map(round).fold(f64::INFINITY, f64::min)
}

/// The closest times of motions.
pub fn closest(body: &MovedMesh, motions: &[[Motion; 2]]) -> anyhow::Result<Vec<f64>> {
    motions.iter().map(|pair| Ok(body.nearest(pair, SAMPLES).map_err(Error::msg)?.1)).collect()
}

/// All motions by one volume; `closest` has their closest times.
pub fn race<V: BoundingVolume>(body: &MovedMesh, motions: &[[Motion; 2]], closest: &[f64]) -> anyhow::Result<Tallied> {
    let hierarchy = Bvh::<V>::build(&body.mesh);
    let both = [&hierarchy; 2];
    let mut tallied = Tallied {
        name: V::NAME.replace(',', ""),
        times: Default::default(),
        nodes: Vec::new(),
        static_nodes: Vec::new(),
        ratios: Default::default(),
    };
    for (pair, closest) in motions.iter().zip(closest) {
        let mut counts = OperationCounts::default();
        let answer = first_contact_counted(both, pair.each_ref(), DEFAULT_RESOLUTION, &mut counts)?;
        let time = timed(ROUNDS[0], || first_contact(both, pair.each_ref()));
        let case = match answer {
            MeshContact::Separate { .. } => 0,
            MeshContact::Contact { .. } => 1,
            MeshContact::Grazing { .. } => 2,
        };
        tallied.times[case].push(time);
        if case > 0 {
            continue;
        }
        let [a, b] = poses_of(pair, *closest).map_err(Error::msg)?;
        let mut of_static = OperationCounts::default();
        if hierarchy.at(&a).witness(hierarchy.at(&b), &mut of_static).is_some() {
            bail!("meshes that are proved apart meet at {closest}");
        }
        let static_time = timed(ROUNDS[1], || hierarchy.at(&a).witness(hierarchy.at(&b), &mut ()));
        let [nodes, static_nodes] = [&counts, &of_static].map(|counts| counts.get(Operation::NodeTest) as f64);
        tallied.nodes.push(nodes);
        tallied.static_nodes.push(static_nodes);
        tallied.ratios[0].push(nodes / static_nodes);
        tallied.ratios[1].push(time / static_time);
    }
    Ok(tallied)
}
