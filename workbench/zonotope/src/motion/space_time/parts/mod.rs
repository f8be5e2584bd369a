//! The parts of which swept volumes are made.
//!
//! | file | content |
//! |---|---|
//! | `angle` | bounds of sines, chords and products with them |
//! | `plane` | the axis and two directions orthogonal to it, exactly and rounded |
//! | `scaled_body` | a body seen from the axis, in numbers of ordinary size |
//! | `shadow` | its projection along the axis: the vertices, and the farthest of them |
//! | `arcs` | points of the plane around the arcs of all vertices |
//! | `volume` | a volume while it is put together |

pub(super) mod angle;
pub(super) mod arcs;
pub(super) mod plane;
pub(super) mod scaled_body;
pub(super) mod shadow;
pub(super) mod volume;
