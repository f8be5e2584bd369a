//! Bodies that do not span space: as prisms over what they span.
//!
//! | file | what it has |
//! |---|---|
//! | [`flat`] | the plane of a flat body, found exactly |
//! | [`prism`] | the prism over a body of the line or the plane, and proofs for the body from proofs for the prism |

pub(crate) mod flat;
pub(crate) mod prism;
