//! Where a displacement lies relative to a zonotope: membership and intersection, the gauge, many points at once.

pub(crate) mod displaced;
pub(crate) mod gauge;
pub(crate) mod location;
pub(crate) mod member_batch;
