//! The place of a displacement relative to a zonotope: membership and intersection, the gauge, the distance, many
//! points at once.

pub(crate) mod displaced;
pub(crate) mod distance;
pub(crate) mod gauge;
pub(crate) mod location;
pub(crate) mod member_batch;
pub(crate) mod penetration;
pub(crate) mod placed;
pub(crate) mod proximity;
