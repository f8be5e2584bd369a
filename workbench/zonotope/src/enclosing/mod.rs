//! Smallest zonotopes around a set of points.
//!
//! | problem | what it asks |
//! |---|---|
//! | [`centered_zonogon`] | the smallest zonogon with a given centre around points of the plane (4.1) |
//! | [`bisectors`] | the lines ℓ_t at which its combinatorial description changes (4.1) |
//! | [`area_function`] | the area of Z(O) along segments and by level sets, for pictures (4.1) |
//! | [`min_area_zonogon`] | the zonogon of least area around points of the plane (4.1) |
//! | [`fixed_directions`] | the smallest zonotope along given directions around points of any dimension (4.2) |
//! | [`min_total_length`] | the zonotope of least total length around points of any dimension (4.3) |
//! | [`oriented_box`] | a small box, which others are compared with |
//!
//! Three of them have a function each that asks the default method, and one shape of answer, [`Enclosing`]: a body,
//! the value that is minimised, a lower bound of it, what proves the bound, and the work done.
//!
//! | function | problem | proof |
//! |---|---|---|
//! | [`min_area`] | [`min_area_zonogon`] | [`AreaProof`](min_area_zonogon::AreaProof): hull, lines ℓ_t and coefficients |
//! | [`along_directions`] | [`fixed_directions`] | [`DirectionsProof`](fixed_directions::DirectionsProof): multipliers of points |
//! | [`min_length`] | [`min_total_length`] | [`LengthProof`](min_total_length::LengthProof): multipliers of points |
//! | [`min_length_of_few`] | the same with so many generators at most | the same |
//!
//! The shape has the type of the proof as a parameter, for a caller knows which problem he posed. Along given
//! directions there may be no zonotope around the points, which is an outcome and not an error:
//! [`Enclosure`](fixed_directions::Enclosure) is the zonotope or the proof that there is none.

mod answer;
pub mod area_function;
pub mod bisectors;
mod boundary_vertex;
pub mod centered_zonogon;
pub mod fixed_directions;
mod front;
mod half_turn;
pub mod min_area_zonogon;
pub mod min_total_length;
pub mod oriented_box;
mod outward;

pub use answer::{Effort, Enclosing};
pub use front::{along_directions, min_area, min_length, min_length_of_few};
