//! Hierarchies over meshes beside those of other libraries: two copies that stand still, and two that move.
//!
//! `cargo run --release -p peers --features trees --example meshes -- 40 40` sets the poses of each mesh and the
//! motions of each small mesh and greatest turn; 0 leaves a part out. What is printed are comma-separated values under
//! a line of settings.

mod contender;
mod moving;
mod obb;
mod our_motions;
mod parry;
mod still;
mod trees;
mod triangles;

/// Poses of each mesh, and motions of each small mesh and greatest turn, if no numbers are given.
const COUNTS: [usize; 2] = [40, 40];

fn main() -> anyhow::Result<()> {
    let mut counts = COUNTS;
    for (count, given) in counts.iter_mut().zip(std::env::args().skip(1)) {
        *count = given.parse()?;
    }
    let [poses, motions] = counts;
    if poses > 0 {
        still::race(poses)?;
    }
    if motions > 0 {
        moving::race(motions)?;
    }
    Ok(())
}
