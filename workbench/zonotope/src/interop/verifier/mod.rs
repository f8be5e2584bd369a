//! Questions and answers of this library as the plain numbers that the crate `verifier` checks.
//!
//! That crate knows nothing of this one: it takes the numbers of a question and of an answer as anyone would write
//! them, and proves or refuses the answer in integers of its own. The functions here only write them, so that every
//! caller who has an answer in the library's types, unit tests and experiments alike, hands over the same numbers.
//!
//! | function | checks the answer of |
//! |---|---|
//! | [`check_location`] | [`collision`](crate::collision): inside, on the boundary or outside |
//! | [`check_distance`] | [`collision::distance`](crate::collision::distance): the distance of disjoint bodies |
//! | [`check_lad`] | [`lad`](crate::lad): least absolute deviations by lines in the plane |
//! | [`check_lad_of_forms`] | [`lad::of_forms`](crate::lad::of_forms): the same in three variables |
//! | [`check_convex_hull`] | [`hull`](crate::hull) |
//! | [`check_min_area`], [`check_exact_min_area`] | [`enclosing::min_area_zonogon`](crate::enclosing::min_area_zonogon) |
//! | [`check_min_length_dirs`] and two that check less | [`enclosing::fixed_directions`](crate::enclosing::fixed_directions) |
//! | [`check_min_length_all`] and one that checks less | [`enclosing::min_total_length`](crate::enclosing::min_total_length) |
//! | [`check_first_contact`] | [`motion::continuous`](crate::motion::continuous): the first contact of moving bodies |
//!
//! # Example
//!
//! ```
//! use zonotope::collision::{Query, brute_force};
//! use zonotope::interop::verifier::check_location;
//!
//! let square = [[1.0, 0.0], [0.0, 1.0]];
//! let query = Query::new([0.0, 0.0], [1.0, 0.5], &square)?;
//! assert!(check_location(&query, &brute_force::locate(&query)).is_right());
//! # Ok::<(), zonotope::NonFinite>(())
//! ```

mod collision;
mod fixed_directions;
mod hull;
mod lad;
mod min_area;
mod min_length;
mod motion;

pub use collision::{check_distance, check_location, displaced, distance_answer, location_answer};
pub use fixed_directions::{check_min_length_dirs, check_min_length_dirs_at_any_gap, check_min_length_dirs_bounds};
pub use hull::check_convex_hull;
pub use lad::{check_lad, check_lad_of_forms, lad_answer, lad_of_forms_answer};
pub use min_area::{check_exact_min_area, check_min_area};
pub use min_length::{check_min_length_all, check_min_length_all_at_any_ratio};
pub use motion::{check_first_contact, first_contact_answer};

use ::verifier::Fraction;

use crate::numeric::Rational;

/// A rational number as the verifier takes it.
fn fraction(number: &Rational) -> Fraction {
    Fraction::new(number.numerator().clone(), number.denominator().clone()).expect("a denominator is positive")
}
