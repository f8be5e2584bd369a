//! Zonotopes as bodies of their own: how far they reach, how many faces they have.

pub(crate) mod combinatorics;
pub(crate) mod support;
