//! The descent that every method ends with: from vertex to vertex of the arrangement, each strictly lower than the one
//! before.
//!
//! | file | what it holds |
//! |---|---|
//! | `search_line` | [`SearchLine`]: a line of the plane, and the exact sign of the slope on it |
//! | `line_minimum` | [`LineMinimum`]: the exact minimum on a line, a weighted median proposed and then proved |
//! | `optimality` | [`decide`]: whether the minimum on a line is one in the plane |
//! | `tie_break` | [`TieBreak`]: the same where many lines meet |
//! | `face_dimension`, `cone` | the dimension of the set of minimisers |
//! | `vertex_descent` | [`descend`]: line by line to a minimiser |
//! | `rank_cases` | [`solve_with`]: subproblems in which no two lines cross |
//! | `solution` | [`Solution`]: what comes out |

mod cone;
mod face_dimension;
mod line_minimum;
mod optimality;
mod rank_cases;
mod search_line;
mod solution;
mod tie_break;
mod vertex_descent;

pub(crate) use line_minimum::LineMinimum;
pub(crate) use optimality::decide;
pub(crate) use rank_cases::solve_with;
pub(crate) use search_line::SearchLine;
pub(crate) use solution::{Decision, Near, Optimal, Solution};
pub(crate) use tie_break::TieBreak;
pub(crate) use vertex_descent::{at_vertex, descend, descend_from};
