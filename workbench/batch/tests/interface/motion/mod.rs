//! Questions about bodies that move.

mod moving;
mod sweeps;
