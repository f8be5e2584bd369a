//! The methods of other libraries beside ours, on the same questions in one run: wrong answers are counted, times are
//! given in passes.
//!
//! A pass is one vectorised evaluation of the support function over the same generators: no method that reads its input
//! once can be faster. The truth about every question is known from its construction
//! ([`experiments::question`]), not from any of the methods.
//!
//! - `contenders`: the methods; `race`: the interleaved measurement; `line_fit`: the L1 line fit against the
//!   crate `palb`.
//! - [`experiments::peers`]: the record that a run writes, and the tables made from it.
//!
//! The crate is empty without its feature `others`, which brings the other libraries.
#![cfg(feature = "others")]

pub mod contenders;
pub mod line_fit;
pub mod race;

#[cfg(test)]
mod tests;
