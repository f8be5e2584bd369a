//! Questions put in any of the dimensions that are answered.

use super::refusal::{Code, Refusal};

/// The largest number of coordinates that is taken with the feature `every-dimension`.
pub const MAX_DIMENSION: usize = 6;

/// Calls a function whose constant parameter is the dimension with a dimension that the question brings; refuses the
/// others.
macro_rules! in_dimension {
    ($dimension:expr, $name:literal, $function:ident($($argument:expr),*)) => {
        match $dimension {
            #[cfg(feature = "every-dimension")]
            1 => $function::<1>($($argument),*),
            2 => $function::<2>($($argument),*),
            3 => $function::<3>($($argument),*),
            #[cfg(feature = "every-dimension")]
            4 => $function::<4>($($argument),*),
            #[cfg(feature = "every-dimension")]
            5 => $function::<5>($($argument),*),
            #[cfg(feature = "every-dimension")]
            6 => $function::<6>($($argument),*),
            other => Err($crate::dimension::refused($name, other, $crate::MAX_DIMENSION)),
        }
    };
}
pub(super) use in_dimension;

/// The refusal of a vector that has too many coordinates, or none.
pub(super) fn refused(name: &str, dimension: usize, most: usize) -> Refusal {
    let (least, most) = if cfg!(feature = "every-dimension") { (1, most) } else { (2, most.min(3)) };
    let message = format!("{name} has {dimension} coordinates; {least} to {most} are taken");
    Refusal::new(Code::DimensionMismatch, message)
}
