//! The tables of the pages: growth laws, values and times of experiments, claims.

mod claims;
mod growth;
mod number;
mod totals;
mod values;
mod variant;

pub(super) use claims::{claim_table, finding_badge};
pub(super) use growth::{beyond, growth_summary, growth_table, measurements, method_title, quantity_name};
pub(super) use totals::overall_table;
pub(super) use values::{time_table, value_table, value_table_on};
