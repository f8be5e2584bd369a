//! Files, facades and rooms that are in circles of imports still. The lists may only shrink: an entry that is in no
//! circle fails as well.

/// Files that import each other in circles without any facade.
pub const FILES_IN_CIRCLES: [&str; 6] = [
    "workbench/zonobench/src/commands/enclose",
    "workbench/zonobench/src/commands/enclose/by_length",
    "workbench/zonobench/src/commands/enclose/summary",
    "workbench/zonobench/src/commands/verify",
    "workbench/zonobench/src/commands/verify/bodies",
    "workbench/zonobench/src/commands/verify/data",
];

/// Facades with functions, in circles with files that import what the facade itself has.
pub const FACADES_IN_CIRCLES: [&str; 19] = [
    "experiments/src/findings",
    "experiments/src/fit",
    "experiments/src/peers",
    "experiments/src/runner",
    "figures/src/axes",
    "workbench/verifier/src/bodies/combinatorics",
    "workbench/zonobench/src/commands/distance",
    "workbench/zonobench/src/commands/inspect",
    "workbench/zonobench/src/commands/intersect",
    "workbench/zonobench/src/input",
    "workbench/zonobench/src/input/body",
    "workbench/zonobench/src/input/mesh",
    "workbench/zonobench/src/input/mesh/ply",
    "workbench/zonobench/src/input/npy",
    "workbench/zonobench/src/input/table",
    "workbench/zonobench/src/report",
    "workbench/zonotope/src/collision/by_lad/early",
    "workbench/zonotope/src/collision/prepared/by_direction_tree",
    "workbench/zonotope/src/collision/prepared/by_direction_tree/posed",
];

/// Files and folders side by side in a folder that import each other in circles.
pub const ROOMS_IN_CIRCLES: [&str; 7] = [
    "experiments/src/definition",
    "experiments/src/record",
    "experiments/src/runner",
    "paper_checks/src/definitions",
    "paper_checks/src/instances",
    "workbench/zonobench/src/commands/records",
    "workbench/zonobench/src/commands/reproduce",
];
