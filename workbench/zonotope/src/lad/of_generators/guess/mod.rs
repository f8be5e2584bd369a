//! Guesses: a point of the plane near the optimum, and how far around it the optimum is likely to be. Nothing rests
//! on them but speed.
//!
//! | file | what it guesses from |
//! |---|---|
//! | [`aim`] | the band and the size of the cell that a guess is to allow for |
//! | [`sample`] | a part of the generators that stands for all of them |
//! | [`huber_newton`] | Newton steps on the objective with rounded-off kinks, and the sums that these take |
//! | [`approach`] | a few such steps, without a bound of how near the end is |
//! | [`parallel_classes`] | the sums of the generators of each of few directions |
//! | [`vertex_descent`] | the vertex at which descent ends, along one line after the other, in doubles |
//! | [`near_lines`] | the lines near a point, with the gradient of all others: a descent among few of many lines |
//! | [`near_rows`] | the generators near a direction, with the sum of all others, in one pass |
//! | [`crossings`] | the weighted median of the places at which lines are crossed |
//! | [`facet_coefficients`] | the coefficients of many generators of one facet, by such a median |

pub(crate) mod aim;
pub(crate) mod approach;
pub(crate) mod crossings;
pub(crate) mod facet_coefficients;
pub(crate) mod huber_newton;
pub(crate) mod near_lines;
pub(crate) mod near_rows;
pub(crate) mod parallel_classes;
pub(crate) mod sample;
pub(crate) mod vertex_descent;
