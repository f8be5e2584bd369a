//! Whether changed answers about bodies in motion are still true.

pub mod encounters;
pub mod meshes;
pub mod sweeps;
