//! Structures for repeated queries against the same queries without them.

mod by_cutting;
mod by_direction_tree;
mod choice;
