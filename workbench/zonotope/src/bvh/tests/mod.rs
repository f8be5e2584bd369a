//! Hierarchies of every volume against the truth.

mod containment;
mod degenerate;
mod distances;
mod levels;
mod meshes;
mod pairs;
mod refits;

use super::*;

/// Calls a function with each type of volume: `for_each_volume!(name)` calls `name::<V>()`.
macro_rules! for_each_volume {
    ($function:ident($($argument:expr),*)) => {
        $function::<crate::bvh::Aabb>($($argument),*);
        $function::<crate::bvh::Sphere>($($argument),*);
        $function::<crate::bvh::OrientedBox>($($argument),*);
        $function::<crate::bvh::Dop18>($($argument),*);
        $function::<crate::bvh::Dop26>($($argument),*);
        $function::<crate::bvh::Zonotope3>($($argument),*);
        $function::<crate::bvh::Zonotope4>($($argument),*);
        $function::<crate::bvh::Zonotope5>($($argument),*);
        $function::<crate::bvh::Zonotope6>($($argument),*);
        $function::<crate::bvh::Zonotope7>($($argument),*);
        $function::<crate::bvh::Zonotope8>($($argument),*);
        $function::<crate::bvh::ZonotopeByCost>($($argument),*);
    };
}

use for_each_volume;
