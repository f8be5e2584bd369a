//! Pictures: what a drawing needs beside the answers of the kinds. Data that is computed by the library and drawn by
//! somebody else: faces, tilings, level sets, the steps of searches.
//!
//! A question for a picture is one of a batch, with the name of a picture as its kind. There is nothing in it to be
//! proved, and the numbers are rounded, so pictures are no kinds: `solve` does not take them. Indices count from 0.

mod directions;
mod lines_of_hull;
mod meshes;
mod picture;
mod plane;
mod prepared;
mod searches;
mod sheet;
mod space;

pub use picture::Picture;
pub(crate) use sheet::{Part, Sheet, Table, Width, index};

/// Every picture.
pub static PICTURES: &[Picture] = &[
    plane::ZONOGON,
    plane::CENTERED_ZONOGON,
    plane::LEVEL_SETS,
    plane::AREA_ALONG,
    searches::THEOREM_4_5,
    searches::PRUNING,
    space::FACES,
    space::TILING,
    directions::PLANE_OF_DIRECTIONS,
    searches::THEOREM_5_2,
    prepared::CUTTING,
    prepared::DIRECTION_TREE,
    prepared::HIERARCHY,
    meshes::MESH_TESTS,
];
