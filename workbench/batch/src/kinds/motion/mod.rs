//! Kinds about bodies in motion, and how a question states a motion.

mod claimed_contact;
mod claimed_mesh_contact;
pub(super) mod collide;
mod of_meshes;
mod stated;
pub(super) mod sweep;
mod written;

pub use stated::read_motion;
