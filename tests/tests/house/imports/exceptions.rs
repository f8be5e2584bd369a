//! Files, facades and rooms that are in circles of imports still. The lists may only shrink: an entry that is in no
//! circle fails as well.

/// Files that import each other in circles without any facade.
pub const FILES_IN_CIRCLES: [&str; 0] = [];

/// Facades with functions, in circles with files that import what the facade itself has. The drawing of axes and its
/// legend share the plot; the counts of faces share the reduction of directions with their callers; the early steps and
/// the trees hand their state to their parts.
pub const FACADES_IN_CIRCLES: [&str; 4] = [
    "figures/src/axes",
    "workbench/verifier/src/bodies/combinatorics",
    "workbench/zonotope/src/collision/by_lad/early",
    "workbench/zonotope/src/collision/prepared/by_direction_tree",
];

/// Files and folders side by side in a folder that import each other in circles.
pub const ROOMS_IN_CIRCLES: [&str; 0] = [];
