//! The input of the kernel in the plane: validated lines, as columns of doubles for passes and exactly for decisions.
//!
//! | file | what it holds |
//! |---|---|
//! | `weighted_line` | [`WeightedLine`]; lines given as doubles in a frame scaled by powers of two |
//! | `error` | [`LadError`]: what lines must satisfy |
//! | `rounded_lines` | the lines as columns of doubles, stored or made block by block, with error bounds |
//! | `exact_lines` | the trait of a source of exact lines |
//! | `problem` | [`LadProblem`], the lines in both forms with the linear term |

mod error;
pub(crate) mod exact_lines;
mod problem;
pub(crate) mod rounded_lines;
mod weighted_line;

pub use error::LadError;
pub use problem::LadProblem;
pub use weighted_line::WeightedLine;
