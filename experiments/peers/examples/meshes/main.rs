//! Hierarchies over meshes beside those of other libraries: two copies that stand still.
//!
//! `cargo run --release -p peers --features others --example meshes -- 40` sets the poses of each mesh. What is printed
//! are comma-separated values under a line of settings.

mod contender;
mod obb;
mod parry;
mod still;
mod trees;
mod triangles;

/// Poses of each mesh, if no number is given.
const POSES: usize = 40;

fn main() -> anyhow::Result<()> {
    still::race(std::env::args().nth(1).map_or(Ok(POSES), |count| count.parse())?)
}
