//! The rules of the house, held by tests: code, columns, comments, documentation, ids, layout, manual.

mod benchmarks;
mod code;
mod columns;
mod comments;
mod documentation;
mod ground_floor;
mod ids;
mod imports;
mod layout;
mod manual;
mod sizes;
