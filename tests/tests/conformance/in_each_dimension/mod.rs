//! The library's answers in each dimension that programs ask about, against twins and by their proofs.
//!
//! These tests need what is public alone. As unit tests they would bring what is generic over the dimension a second
//! time, programs in two kinds of arithmetic with all that they stand on; here it comes from the library as compiled.

mod bodies;
mod combinatorics;
mod fixed_directions;
mod min_total_length;
mod on_a_line;
mod proofs;
mod reduction;
