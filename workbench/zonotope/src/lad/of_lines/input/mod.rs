//! The input of the kernel: weighted lines, validated, with floating-point columns for passes and exact coefficients on demand.

pub(crate) mod exact_lines;
pub(crate) mod problem;
pub(crate) mod rounded_lines;
