//! The volumes by name, for callers that choose one when they run.

use super::hierarchy::{Bvh, PlacedBvh};
use super::mesh::{Mesh, PlacedMesh};
use super::nearest::MeshDistance;
use super::{
    Aabb, BeyondDoubles, BoundingVolume, Dop18, Dop26, Enclosed, OrientedBox, Shaped, Sphere, Zonotope3, Zonotope4,
    Zonotope5, Zonotope6, Zonotope7, Zonotope8, ZonotopeByCost,
};
use crate::tables::methods;
use crate::tally::Tally;

methods! {
    /// The bounding volume of the nodes of two hierarchies. Answers are the same for all.
    pub enum Method;
    /// The directions that a test of two nodes tries.
    fn cost;

    /// [`Aabb`], the default for a single question: the quickest to build.
    Aabb => "aabb", "Boxes along the axes", "6 directions";
    /// [`Sphere`].
    Sphere => "sphere", "Spheres", "1 direction";
    /// [`OrientedBox`].
    OrientedBox => "obb", "Boxes that a search turns", "15 directions";
    /// [`Dop18`].
    Dop18 => "dop_18", "Polytopes of 18 normals", "18 directions";
    /// [`Dop26`].
    Dop26 => "dop_26", "Polytopes of 26 normals", "26 directions";
    /// [`Zonotope3`].
    Zonotope3 => "zonotope_3", "Parallelepipeds", "15 directions";
    /// [`Zonotope4`].
    Zonotope4 => "zonotope_4", "Zonotopes of at most four generators", "28 directions";
    /// [`Zonotope5`].
    Zonotope5 => "zonotope_5", "Zonotopes of at most five generators", "20 directions";
    /// [`Zonotope6`].
    Zonotope6 => "zonotope_6", "Zonotopes of at most six generators", "30 directions";
    /// [`Zonotope7`].
    Zonotope7 => "zonotope_7", "Zonotopes of at most seven generators", "42 directions";
    /// [`Zonotope8`].
    Zonotope8 => "zonotope_8", "Zonotopes of at most eight generators", "56 directions";
    /// [`ZonotopeByCost`].
    ZonotopeByCost => "zonotope_by_cost", "Zonotopes of three to six generators, by cost", "9 to 30 directions";
}

/// Calls a function with the type of a method's volume.
macro_rules! with_volume {
    ($method:expr, $function:ident($($argument:expr),*)) => {
        match $method {
            Method::Aabb => $function::<Aabb>($($argument),*),
            Method::Sphere => $function::<Sphere>($($argument),*),
            Method::OrientedBox => $function::<OrientedBox>($($argument),*),
            Method::Dop18 => $function::<Dop18>($($argument),*),
            Method::Dop26 => $function::<Dop26>($($argument),*),
            Method::Zonotope3 => $function::<Zonotope3>($($argument),*),
            Method::Zonotope4 => $function::<Zonotope4>($($argument),*),
            Method::Zonotope5 => $function::<Zonotope5>($($argument),*),
            Method::Zonotope6 => $function::<Zonotope6>($($argument),*),
            Method::Zonotope7 => $function::<Zonotope7>($($argument),*),
            Method::Zonotope8 => $function::<Zonotope8>($($argument),*),
            Method::ZonotopeByCost => $function::<ZonotopeByCost>($($argument),*),
        }
    };
}

/// The answer to a question about two meshes.
#[derive(Debug, Clone, PartialEq)]
pub enum Encounter {
    /// A pair of triangles that meet.
    Meeting([usize; 2]),
    /// They are disjoint and so far apart.
    Apart(MeshDistance),
}

impl Method {
    /// The volumes that are zonotopes of few generators: boxes in both ways and zonotopes.
    pub const SHAPED: [Self; 9] = [
        Self::Aabb,
        Self::OrientedBox,
        Self::Zonotope3,
        Self::Zonotope4,
        Self::Zonotope5,
        Self::Zonotope6,
        Self::Zonotope7,
        Self::Zonotope8,
        Self::ZonotopeByCost,
    ];

    /// The volumes of a level of a mesh's hierarchy, as [`Bvh::level`] has them; `None` of spheres and of polytopes of
    /// fixed normals, which are no zonotopes of few generators.
    ///
    /// # Errors
    /// [`BeyondDoubles`] for a mesh so large that a volume around it is no body of doubles.
    pub fn level(self, mesh: &Mesh, depth: usize) -> Option<Result<Vec<Enclosed>, BeyondDoubles>> {
        Some(match self {
            Self::Sphere | Self::Dop18 | Self::Dop26 => return None,
            Self::Aabb => level::<Aabb>(mesh, depth),
            Self::OrientedBox => level::<OrientedBox>(mesh, depth),
            Self::Zonotope3 => level::<Zonotope3>(mesh, depth),
            Self::Zonotope4 => level::<Zonotope4>(mesh, depth),
            Self::Zonotope5 => level::<Zonotope5>(mesh, depth),
            Self::Zonotope6 => level::<Zonotope6>(mesh, depth),
            Self::Zonotope7 => level::<Zonotope7>(mesh, depth),
            Self::Zonotope8 => level::<Zonotope8>(mesh, depth),
            Self::ZonotopeByCost => level::<ZonotopeByCost>(mesh, depth),
        })
    }

    /// A pair of triangles that meet, or how far apart the meshes are; builds both hierarchies.
    pub fn encounter(self, meshes: [PlacedMesh<'_>; 2], tally: &mut dyn Tally) -> Encounter {
        with_volume!(self, encounter(meshes, tally))
    }

    /// All pairs of triangles that meet, in increasing order, if they are at most `limit`; builds both hierarchies.
    pub fn pairs(self, meshes: [PlacedMesh<'_>; 2], limit: usize, tally: &mut dyn Tally) -> Option<Vec<[usize; 2]>> {
        with_volume!(self, pairs(meshes, limit, tally))
    }
}

fn level<V: Shaped>(mesh: &Mesh, depth: usize) -> Result<Vec<Enclosed>, BeyondDoubles> {
    Bvh::<V>::build(mesh).level(depth)
}

/// The hierarchies of two meshes; of a mesh and the same one again it is built once.
fn built<V: BoundingVolume>([a, b]: &[PlacedMesh<'_>; 2]) -> [Bvh<V>; 2] {
    let first = Bvh::build(a.mesh());
    let second = if std::ptr::eq(a.mesh(), b.mesh()) { first.clone() } else { Bvh::build(b.mesh()) };
    [first, second]
}

fn encounter<V: BoundingVolume>(meshes: [PlacedMesh<'_>; 2], tally: &mut dyn Tally) -> Encounter {
    let hierarchies = built::<V>(&meshes);
    let [a, b] = placed(&hierarchies, &meshes);
    a.witness(b, tally).map_or_else(|| Encounter::Apart(a.distance(b)), Encounter::Meeting)
}

fn pairs<V: BoundingVolume>(
    meshes: [PlacedMesh<'_>; 2],
    limit: usize,
    tally: &mut dyn Tally,
) -> Option<Vec<[usize; 2]>> {
    let hierarchies = built::<V>(&meshes);
    let [a, b] = placed(&hierarchies, &meshes);
    a.at_most_pairs(b, limit, tally)
}

fn placed<'a, V: BoundingVolume>([a, b]: &'a [Bvh<V>; 2], [of_a, of_b]: &[PlacedMesh<'_>; 2]) -> [PlacedBvh<'a, V>; 2] {
    [a.at(of_a.pose()), b.at(of_b.pose())]
}
