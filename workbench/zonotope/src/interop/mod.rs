//! Zonotopes among the types of other libraries.
//!
//! | file | feature | what it does |
//! |---|---|---|
//! | `parry` | `parry` | a zonotope as a shape of the physics stack around parry3d: its support map |

#[cfg(feature = "parry")]
pub mod parry;
