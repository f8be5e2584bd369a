//! The library's answers: as the checks compare them, and their proofs checked from their definition.
//!
//! | file | what it holds |
//! |---|---|
//! | `facets` | facets by the names that the library gives them |
//! | `library` | points as the library takes them, and its answers |
//! | `locations` | the certificates of locations and gauges |
//! | `lengths` | the proofs of least total lengths, along given directions and over all |

pub(crate) mod facets;
pub(crate) mod lengths;
pub(crate) mod library;
pub(crate) mod locations;
