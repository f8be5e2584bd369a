//! Bodies in motion: placements of one or two bodies, and the directions that prove that two of them do not meet.
//!
//! | file | content |
//! |---|---|
//! | `first_contact` | two bodies at some times, and a bar of the time with the intervals that are proved |
//! | `swept` | the placements of one body, and the volume around them |
//! | `placed` | a body at a time, as it is seen |

mod first_contact;
mod placed;
mod swept;

pub use first_contact::first_contact;
pub use swept::swept;

#[cfg(test)]
mod tests;
