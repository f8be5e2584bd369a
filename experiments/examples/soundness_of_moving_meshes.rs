//! Two copies of a mesh that move fast: each answer is held to samples with a bound of how far the meshes move between
//! them. Beside it are the collisions that samples at equal steps miss on the same motions.
//!
//! `cargo run --release -p experiments --features studies --example soundness_of_moving_meshes -- 500 teapot torus`
//! asks about 500 motions that pass and 500 that come nearer, of each mesh that is named and each greatest turn. A
//! collision that is missed ends the program with an error.

use std::process::ExitCode;
use std::time::Instant;

use experiments::hierarchies::{MovedMesh, mesh};
use experiments::moving::meshes::TalliedMeshes;
use experiments::moving::soundness::RIVAL_STEPS;
use rayon::prelude::*;

/// The greatest turns of a mesh in a step, in degrees.
const TURNS: [u32; 2] = [60, 180];

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1);
    let count: u64 = arguments.next().and_then(|text| text.parse().ok()).expect("a number of motions, then meshes");
    let mut is_sound = true;
    for name in arguments {
        let moved = mesh(&name).and_then(|mesh| MovedMesh::of(&mesh)).expect("it is among the meshes");
        for turn in TURNS {
            let start = Instant::now();
            let tallied = (0..count)
                .into_par_iter()
                .map(|seed| {
                    let found = TalliedMeshes::of_motions(&moved, seed, f64::from(turn).to_radians());
                    let tallied = found.expect("motions near the mesh");
                    if tallied.contradicted > 0 {
                        println!("{name}, {turn} degrees, seed {seed}: {tallied:?}");
                    }
                    tallied
                })
                .reduce(TalliedMeshes::default, TalliedMeshes::plus);
            is_sound &= tallied.contradicted == 0;
            println!(
                "{name}, {turn} degrees, {:.0} s, {RIVAL_STEPS} steps: {tallied:?}",
                start.elapsed().as_secs_f64()
            );
        }
    }
    if is_sound { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
