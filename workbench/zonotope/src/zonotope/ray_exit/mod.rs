//! Problem: where a ray from the centre of a zonotope leaves it, in floating point.
//!
//! | file | what it holds |
//! |---|---|
//! | `descent` | one ray: from facet normal to facet normal while the support function falls |
//! | `facet_map` | many rays: the facets met so far with their neighbours |
//! | `chart` | one facet of that map |
//!
//! What they find is a guess. Every user proves or refutes it.

mod chart;
mod descent;
mod facet_map;

pub(crate) use descent::{Facet, FacetDescent};
pub(crate) use facet_map::{Exit, FacetMap};
