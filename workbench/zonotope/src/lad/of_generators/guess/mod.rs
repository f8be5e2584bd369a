//! Where the optimum is likely to be.

pub(crate) mod corrected_sample;
pub(crate) mod crossings;
pub(crate) mod huber_newton;
pub(crate) mod parallel_classes;
pub(crate) mod sample;
pub(crate) mod vertex_descent;
