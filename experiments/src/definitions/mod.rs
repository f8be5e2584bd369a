//! The experiments, one a file, and the families and sizes that several of them share.

pub mod hull_scaling;

use crate::definition::PerProfile;

/// Families of every hull size for the scaling experiments of 4.1.
pub const SCALING_FAMILIES: &[&str] =
    &["circle", "ellipse", "random_convex", "regular_polygon", "gaussian", "clustered"];

/// Powers of two from 2^6: to 2^14 in the quick profile, to 2^20 in the full one.
pub const SCALING_SIZES: PerProfile<&[usize]> = PerProfile {
    quick: &[1 << 6, 1 << 7, 1 << 8, 1 << 9, 1 << 10, 1 << 11, 1 << 12, 1 << 13, 1 << 14],
    full: &[
        1 << 6,
        1 << 7,
        1 << 8,
        1 << 9,
        1 << 10,
        1 << 11,
        1 << 12,
        1 << 13,
        1 << 14,
        1 << 15,
        1 << 16,
        1 << 17,
        1 << 18,
        1 << 19,
        1 << 20,
    ],
};
