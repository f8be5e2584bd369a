//! Questions about bodies that move.

mod meshes;
mod moving;
mod sweeps;
