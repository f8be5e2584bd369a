//! The library and the batch as a module of Python: what the package `zonotope` beside it is written on.
//!
//! Bodies stay here as values of the library, whatever their dimension ([`body`]); arrays of points are answered by the
//! library itself, without the interpreter's lock and on several threads ([`many`]); a question whose answer carries a
//! proof is a line of the batch ([`line`]), so that the crate `verifier` checks what Python users get. No panic crosses
//! the border ([`border`]).

mod arrays;
mod body;
mod border;
mod faces;
mod line;
mod many;
mod picture;
mod prepared;
mod tracker;

use pyo3::prelude::*;

/// The extension module.
#[pymodule]
mod _zonotope {
    #[pymodule_export]
    use super::body::Body;
    #[pymodule_export]
    use super::border::provoke_panic;
    #[pymodule_export]
    use super::line::{solve, verify};
    #[pymodule_export]
    use super::picture::{svg, svg_around, svg_pair};
    #[pymodule_export]
    use super::prepared::Prepared;
    #[pymodule_export]
    use super::tracker::Tracker;
}
