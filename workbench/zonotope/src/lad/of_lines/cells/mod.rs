//! Cells: small parallelograms around a guess, which most lines miss.
//!
//! | file | what it holds |
//! |---|---|
//! | `frame` | [`Frame`]: coordinates in which the normals point about equally everywhere |
//! | `cell` | [`Cell`]: a square in such coordinates |
//! | `split` | [`Split`]: one pass that separates the lines that certainly miss a cell from the others |
//! | `quadratic_model` | the gradient and curvature of the crossing lines, and the smaller cell that they lead to |

mod cell;
mod frame;
mod quadratic_model;
mod split;

pub(crate) use cell::Cell;
pub(crate) use frame::Frame;
pub(crate) use split::Split;
