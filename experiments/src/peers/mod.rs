//! The results of the methods of other libraries beside ours: the record that the program of `experiments/peers`
//! writes, and its tables.
//!
//! The record is committed as `data/peers.json`, with the machine it was measured on; the tables of README and of the
//! report are made from it.

mod record;
mod tables;

pub use record::{Cell, Entry, LineFit, PeersRecord, committed, median};
pub use tables::{Table, tables, tables_of_readme};
