//! Two copies of a mesh at many poses: the pairs of triangles that each bounding volume finds, held to a look at every
//! pair.
//!
//! `cargo run --release -p experiments --features studies --example soundness_of_mesh_pairs -- 40 teapot torus` asks
//! about 40 copies of each mesh that is named, at four distances and overlapping, and about 100 that touch it exactly
//! and 100 that are one double away from that. Without names all meshes are asked about. A pair that is missed or
//! invented ends the program with an error.

use std::process::ExitCode;
use std::time::Instant;

use experiments::hierarchies::{MESHES, TouchingPoses, pairs_by_every_pair, scene};
use rayon::prelude::*;
use zonotope::Pose;
use zonotope::bvh::{
    Aabb, BoundingVolume, Bvh, Dop18, Dop26, Mesh, OrientedBox, Sphere, Zonotope3, Zonotope4, Zonotope5, Zonotope6,
    Zonotope7, Zonotope8, ZonotopeByCost,
};

/// The vertices of a mesh at which copies touch it.
const TOUCHED_VERTICES: usize = 100;

/// The poses of a mesh, each with the pairs of triangles that meet.
struct Truth {
    mesh: Mesh,
    poses: Vec<(Pose, Vec<[usize; 2]>)>,
}

impl Truth {
    /// The poses of a mesh for which a volume finds other pairs, or no pair where there is one, or the other way round.
    fn wrong<V: BoundingVolume>(&self) -> usize {
        let hierarchy = Bvh::<V>::build(&self.mesh);
        let is_wrong = |(pose, pairs): &&(Pose, Vec<[usize; 2]>)| {
            let (still, moved) = (hierarchy.at(&Pose::IDENTITY), hierarchy.at(pose));
            let witness = still.witness(moved, &mut ());
            let is_right = match witness {
                Some(pair) => pairs.binary_search(&pair).is_ok(),
                None => pairs.is_empty(),
            };
            !is_right || still.pairs(moved) != *pairs
        };
        self.poses.par_iter().filter(is_wrong).count()
    }
}

/// The answers of a mesh that are wrong, after a line about it.
fn wrong(name: &str, count: usize) -> Result<usize, String> {
    let start = Instant::now();
    let scene = scene(name, count, 1)?;
    let drawn = scene.placed.iter().flat_map(|placed| placed.apart.iter().chain([&placed.overlapping]));
    let touching = TouchingPoses::of(&scene.mesh, TOUCHED_VERTICES, 1);
    let touching: Vec<Pose> = touching.iter().flat_map(|poses| [poses.at_contact, poses.one_step_apart]).collect();
    let poses: Vec<Pose> = drawn.copied().chain(touching).collect();
    let poses = poses
        .into_par_iter()
        .map(|pose| Ok((pose, pairs_by_every_pair(&scene.mesh, &pose)?)))
        .collect::<Result<Vec<_>, String>>()?;
    let truth = Truth { mesh: scene.mesh.clone(), poses };
    let wrong = truth.wrong::<Aabb>()
        + truth.wrong::<Sphere>()
        + truth.wrong::<OrientedBox>()
        + truth.wrong::<Dop18>()
        + truth.wrong::<Dop26>()
        + truth.wrong::<Zonotope3>()
        + truth.wrong::<Zonotope4>()
        + truth.wrong::<Zonotope5>()
        + truth.wrong::<Zonotope6>()
        + truth.wrong::<Zonotope7>()
        + truth.wrong::<Zonotope8>()
        + truth.wrong::<ZonotopeByCost>();
    let meeting = truth.poses.iter().filter(|(_, pairs)| !pairs.is_empty()).count();
    let pairs: usize = truth.poses.iter().map(|(_, pairs)| pairs.len()).sum();
    println!(
        "{name}, {} triangles, {:.0} s: {} poses, {meeting} of them meet, in {pairs} pairs; {wrong} wrong answers",
        truth.mesh.triangles().len(),
        start.elapsed().as_secs_f64(),
        truth.poses.len()
    );
    Ok(wrong)
}

fn main() -> Result<ExitCode, String> {
    let mut arguments = std::env::args().skip(1);
    let count = arguments.next().and_then(|text| text.parse().ok()).ok_or("a number of copies, then meshes")?;
    let mut names: Vec<String> = arguments.collect();
    if names.is_empty() {
        names = MESHES.map(str::to_owned).to_vec();
    }
    let wrong = names.iter().map(|name| wrong(name, count)).sum::<Result<usize, String>>()?;
    Ok(if wrong == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
