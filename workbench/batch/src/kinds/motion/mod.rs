//! Kinds about bodies in motion, and how a question states a motion.

pub(super) mod collide;
mod stated;
