//! Stage: normals, a centre and coefficients in doubles, by adding the normals of facets beyond which points lie.
//!
//! | file or folder | what it holds |
//! |---|---|
//! | [`generation`] | the loop: solve, look for points outside, add the normals of their facets |
//! | [`normal_simplex`] | the linear program over the normals so far, by a revised simplex method that keeps its basis |

pub(crate) mod generation;
pub(crate) mod normal_simplex;
