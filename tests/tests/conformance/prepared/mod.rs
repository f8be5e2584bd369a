//! Bodies that are prepared for many queries.

mod by_cutting;
