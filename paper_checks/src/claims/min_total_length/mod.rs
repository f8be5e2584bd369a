//! Section 4.3: enclosing zonotopes of nearly least total length.

pub(crate) mod containment_chain;
pub(crate) mod direction_net;
pub(crate) mod theorem_4_7;
