//! The kernel in homogeneous form: the minimum of h(u) = Σ |v_i · u| over the plane of directions u with u · p = 1.

pub(crate) mod cells;
pub(crate) mod certify;
pub(crate) mod exact;
pub(crate) mod guess;
pub(crate) mod ladder;
pub(crate) mod plane;
pub(crate) mod span;
pub(crate) mod support;
