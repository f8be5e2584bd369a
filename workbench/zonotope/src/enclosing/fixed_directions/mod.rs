//! Problem: the smallest zonotope along given directions around a set of points.
//!
//! Minimise Σ w_i c_i over centres p and coefficients c_i ≥ 0 such that { p + Σ δ_i c_i v_i : |δ_i| ≤ 1 } contains every point. With unit
//! vectors and unit weights that is the total length. A linear program; it has a solution just when no difference of two points leaves the
//! span of the directions.
//!
//! | method | time | notes |
//! |---|---|---|
//! | [`brute_force`] | rational pivots over C(k, d − 1) normals | the truth |
//! | [`by_row_generation`] | a few passes over the points, pivots of O((k + d)²) | normals as they are needed; the default |
//!
//! n points, k directions, d dimensions. Every answer but the truth's contains the points exactly and proves its lower bound;
//! [`verify`] checks both on its own.

mod answer;
pub mod brute_force;
pub mod by_row_generation;
mod center;
mod facet_descent;
mod generation;
mod lower_bound;
mod normal_program;
mod problem;
mod rational_simplex;
mod repair;
mod scaled;
mod solve;
mod span;
pub mod verify;

pub use answer::{DirectedZonotope, Effort, Enclosure, Force, OffSpan};
pub use by_row_generation::{least_enclosing, least_enclosing_counted};
pub use problem::{FixedDirections, FixedDirectionsError};

#[cfg(test)]
mod tests;
