//! The program as people call it: what it prints, which files it writes, how it ends.

mod enclose;
mod lengths;
mod program;
mod solve;
mod usage;
mod zonotopes;
