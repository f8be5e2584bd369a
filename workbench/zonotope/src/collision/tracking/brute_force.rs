//! How two posed bodies meet in a frame, from every facet normal of their sum: the truth, in exact arithmetic, and
//! without a memory.
//!
//! # Statement
//! Input: a query about two bodies of space under poses. Output: the status, exactly for the poses as they are given. A
//! flat sum has no inside; an empty one is a point.
//!
//! # Source
//! None; Section 3 names the facets of a zonotope by pairs of generators.
//!
//! # Method
//! 1. The images of all generators, and the displacement of the images of the centres, exactly.
//! 2. If the displacement is off the span of the images, the bodies are disjoint; else the tightest of all facets
//!    tells.
//!
//! # Complexity
//! n generators: O(n³) exact operations for each frame.
//!
//! # Shapes
//! Generators in any order, zero and parallel ones allowed.
//!
//! # Numerics
//! Exact throughout.
//!
//! # Errors
//! None: the query was validated when it was made.
//!
//! # Panics
//! Never.
//!
//! # Checked by
//! Cubes by hand; [`locate_posed`](crate::collision::PosedZonotope), by way of the trackers.
//!
//! # Example
//! ```
//! use zonotope::collision::tracking::brute_force;
//! use zonotope::collision::{PosedQuery, Status};
//! use zonotope::Pose;
//! use zonotope::zonotope::Zonotope;
//! let cube = Zonotope::new([0.0; 3], vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]).unwrap();
//! let beside = Pose::from_translation([2.0, 0.5, 0.0]).unwrap();
//! let query = PosedQuery::between((&cube, &Pose::IDENTITY), (&cube, &beside));
//! assert_eq!(brute_force::status(&query), Status::Boundary);
//! ```

use std::cmp::Ordering;

use crate::collision::proof::tightest_facet::{TightestFacet, Vector};
use crate::collision::{PosedQuery, Status};
use crate::numeric::exact_linear::{Span, exact};

/// How the bodies of a query meet.
pub fn status(query: &PosedQuery<'_>) -> Status {
    let parts = query.runs().into_iter().zip(query.poses());
    let generators: Vec<Vector> =
        parts.flat_map(|(rows, pose)| rows.iter().map(move |v| pose.exact_image(&exact(*v)).to_vec())).collect();
    let point = query.displacement().to_vec();
    let span = Span::of(generators.iter().cloned(), 3);
    if span.direction_to(&point).is_some() {
        return Status::Outside;
    }
    let tightest = TightestFacet::within(&span, &point, &generators);
    match tightest.along_point.cmp(&tightest.along_zonotope) {
        Ordering::Greater => Status::Outside,
        Ordering::Less if span.rank() == 3 => Status::Inside,
        _ => Status::Boundary,
    }
}
