//! The numbers of a question and its answer, read for the check: plain numbers for the crate `verifier`, with
//! complaints that name the field, and a note of every field that was read.

mod placed;
mod reading;
mod traced;

pub(crate) use placed::{Placed, pose};
pub(crate) use reading::{
    boolean, direction, exact_numbers, float, fractions, index, indices, member, planar, point, text, vector, vectors,
};
pub(crate) use traced::{Reads, Traced};
