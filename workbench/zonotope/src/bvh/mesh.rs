//! Meshes: vertices and triangles, and meshes under poses, whose corners are exact numbers.

use thiserror::Error;

use crate::numeric::exact_linear::{ExactVector, exact};
use crate::numeric::non_finite::NonFinite;
use crate::zonotope::pose::Pose;

/// The largest number of vertices, and of triangles: positions are kept in 32 bits, those of nodes as well, of which
/// there are nearly twice as many as triangles.
const COUNT_LIMIT: usize = 1 << 31;

/// A surface of triangles. A value of this type is valid: it has a triangle, coordinates are finite, and triangles name
/// vertices that are there. Triangles may be flat to a segment or a point, repeated, and cross each other; vertices
/// need not be used.
///
/// A mesh is the union of its closed triangles: a body inside another one that does not touch its surface does not meet
/// it. Coordinates are best about the origin: the farthest vertex from it, used or not, gives the unit in which nodes
/// are tested, and where that is large beside the mesh, exact tests of triangles do the work of nodes.
///
/// # Example
/// ```
/// use zonotope::bvh::{Mesh, meet};
/// let triangle = |z: f64| Mesh::new(vec![[0.0, 0.0, z], [2.0, 0.0, z], [0.0, 2.0, z]], vec![[0, 1, 2]]);
/// let spike = Mesh::new(vec![[0.5, 0.5, 0.0], [0.5, 0.5, 5.0]], vec![[0, 1, 1]])?; // a segment
/// assert!(meet(&triangle(0.0)?, &spike) && !meet(&triangle(-0.25)?, &spike));
/// # Ok::<(), zonotope::bvh::MeshError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    vertices: Vec<[f64; 3]>,
    triangles: Vec<[u32; 3]>,
}

/// Why vertices and triangles are no mesh.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum MeshError {
    /// A coordinate of a vertex is NaN or infinite.
    #[error(transparent)]
    NonFinite(#[from] NonFinite),
    /// There is no triangle.
    #[error("there are no triangles")]
    Empty,
    /// A triangle names a vertex that is not there.
    #[error("triangle {triangle}, corner {corner} is vertex {vertex} of {vertices}")]
    NoSuchVertex {
        /// The triangle, from 0.
        triangle: usize,
        /// The corner, from 0.
        corner: usize,
        /// The position that it names, from 0.
        vertex: u32,
        /// The number of vertices.
        vertices: usize,
    },
    /// There are more vertices or triangles than are taken.
    #[error("{count} vertices or triangles, at most {COUNT_LIMIT} are taken")]
    TooLarge {
        /// The larger of both numbers.
        count: usize,
    },
}

impl Mesh {
    /// The mesh of vertices and triangles, which name vertices by their positions from 0. O(n).
    ///
    /// # Errors
    /// The first of these that is wrong: a coordinate is not finite, there is no triangle, a triangle names no vertex,
    /// there are more than 2^31 of either.
    pub fn new(vertices: Vec<[f64; 3]>, triangles: Vec<[u32; 3]>) -> Result<Self, MeshError> {
        NonFinite::check_list("vertex", &vertices)?;
        if triangles.is_empty() {
            return Err(MeshError::Empty);
        }
        let is_missing = |&vertex: &u32| vertex as usize >= vertices.len();
        if let Some(at) = triangles.as_flattened().iter().position(is_missing) {
            let (triangle, corner) = (at / 3, at % 3);
            let vertex = triangles[triangle][corner];
            return Err(MeshError::NoSuchVertex { triangle, corner, vertex, vertices: vertices.len() });
        }
        let count = vertices.len().max(triangles.len());
        if count > COUNT_LIMIT {
            return Err(MeshError::TooLarge { count });
        }
        Ok(Self { vertices, triangles })
    }

    /// The vertices.
    pub fn vertices(&self) -> &[[f64; 3]] {
        &self.vertices
    }

    /// The triangles, as positions of vertices from 0.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// The corners of a triangle.
    pub fn corners(&self, triangle: usize) -> [[f64; 3]; 3] {
        self.triangles[triangle].map(|vertex| self.vertices[vertex as usize])
    }

    /// The mesh with its vertices at other places: a deformation. O(n).
    ///
    /// # Errors
    /// [`MeshError`] if a coordinate is not finite, or there are fewer vertices than the triangles name.
    pub fn with_vertices(&self, vertices: Vec<[f64; 3]>) -> Result<Self, MeshError> {
        Self::new(vertices, self.triangles.clone())
    }

    /// The mesh where a pose puts it. O(1).
    pub fn at(&self, pose: &Pose) -> PlacedMesh<'_> {
        PlacedMesh { mesh: self, pose: *pose }
    }
}

/// A mesh where a pose puts it. Wherever one is expected, `&mesh` is the mesh as it stands.
#[derive(Debug, Clone, Copy)]
pub struct PlacedMesh<'a> {
    mesh: &'a Mesh,
    pose: Pose,
}

impl<'a> PlacedMesh<'a> {
    /// The mesh as it is stored.
    pub fn mesh(&self) -> &'a Mesh {
        self.mesh
    }

    /// The pose.
    pub fn pose(&self) -> &Pose {
        &self.pose
    }

    /// The corners of a triangle where the pose puts them, exactly.
    pub(crate) fn exact_corners(&self, triangle: usize) -> [ExactVector; 3] {
        let corners = self.mesh.corners(triangle);
        if self.pose == Pose::IDENTITY {
            corners.map(exact)
        } else {
            corners.map(|corner| self.pose.exact_point(corner))
        }
    }
}

impl<'a> From<&'a Mesh> for PlacedMesh<'a> {
    fn from(mesh: &'a Mesh) -> Self {
        mesh.at(&Pose::IDENTITY)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faults_of_a_mesh_are_named_by_their_place() {
        let message =
            |vertices: Vec<[f64; 3]>, triangles| Mesh::new(vertices, triangles).expect_err("a fault").to_string();
        let points = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let mut bad = points.clone();
        bad[1][2] = f64::NAN;
        assert_eq!(message(bad, vec![[0, 1, 2]]), "vertex 1, coordinate 2 is NaN, not a finite number");
        assert_eq!(message(points.clone(), vec![]), "there are no triangles");
        assert_eq!(message(points.clone(), vec![[0, 1, 2], [0, 3, 1]]), "triangle 1, corner 1 is vertex 3 of 3");
        assert_eq!(message(vec![], vec![[0, 0, 0]]), "triangle 0, corner 0 is vertex 0 of 0");
        let mesh = Mesh::new(points, vec![[2, 1, 0]]).expect("a mesh");
        assert_eq!(mesh.corners(0), [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0; 3]]);
        assert!(matches!(mesh.with_vertices(vec![[0.0; 3]]), Err(MeshError::NoSuchVertex { vertex: 2, .. })));
    }
}
