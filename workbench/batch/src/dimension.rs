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

/// The kinds that are about one dimension alone, and what they take.
const OF_ONE_DIMENSION: [(&str, &str); 9] = [
    ("collide", "bodies and meshes of space"),
    ("sweep", "bodies of space"),
    ("mesh", "meshes of space"),
    ("mesh_level", "meshes of space"),
    ("separator", "generators of space"),
    ("upper_hull", "generators of space"),
    ("walk", "generators of space"),
    ("slope_selection", "generators of space"),
    ("min_area", "points of the plane"),
];

/// The refusal by a kind; one of a vector with coordinates too few or too many says what the kind takes, where that is
/// all of one dimension.
pub(super) fn explained(refusal: Refusal, kind: &str) -> Refusal {
    let of_one = OF_ONE_DIMENSION.iter().find(|(name, _)| *name == kind);
    match of_one.filter(|_| refusal.code == Code::DimensionMismatch && refusal.message.contains(" coordinate")) {
        Some((name, taken)) => Refusal::new(refusal.code, format!("{}: `{name}` takes {taken}", refusal.message)),
        None => refusal,
    }
}

/// The refusal of a vector that has too many coordinates, or none.
pub(super) fn refused(name: &str, dimension: usize, most: usize) -> Refusal {
    let (least, most) = if cfg!(feature = "every-dimension") { (1, most) } else { (2, most.min(3)) };
    let message = format!("{name} has {dimension} coordinates; {least} to {most} are taken");
    Refusal::new(Code::DimensionMismatch, message)
}
