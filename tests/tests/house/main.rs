//! The rules of the house, held by tests: code, documentation, ids, layout, manual.

mod code;
mod documentation;
mod ids;
mod layout;
mod manual;
