//! Zonotopes among the types of other libraries.
//!
//! | file | feature | what it does |
//! |---|---|---|
//! | `parry` | `parry` | a zonotope as a shape of the physics stack around parry3d: its support map |
//! | `verifier` | `verifier` | questions and answers as the plain numbers that the crate `verifier` checks |

#[cfg(feature = "parry")]
pub mod parry;
#[cfg(any(test, feature = "verifier"))]
pub mod verifier;
