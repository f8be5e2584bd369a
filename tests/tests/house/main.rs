//! The rules of the house, held by tests: code, columns, documentation, ids, layout, manual.

mod code;
mod columns;
mod documentation;
mod ground_floor;
mod ids;
mod imports;
mod layout;
mod manual;
mod sizes;
