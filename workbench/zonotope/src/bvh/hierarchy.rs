//! A hierarchy of bounding volumes over a mesh, as it stands or under a pose.

use super::build::{BuildOptions, Topology, topology};
use super::mesh::{Mesh, MeshError, PlacedMesh};
use super::refit::volumes;
use super::volume::BoundingVolume;
use crate::numeric::scaling::{binary_exponent, largest_magnitude, scale_by_power_of_two};
use crate::zonotope::pose::Pose;

/// A mesh with a bounding volume for each node of a tree over its triangles.
///
/// # Example
/// ```
/// use zonotope::Pose;
/// use zonotope::bvh::{Bvh, Mesh, Zonotope6};
/// let corners = vec![[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
/// let mesh = Mesh::new(corners, vec![[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]])?;
/// let tetrahedron = Bvh::<Zonotope6>::build(&mesh);
/// let moved = Pose::from_translation([2.0, 0.0, 0.0])?;
/// // edges that cross in the middle of a face of the cube around both
/// assert!(tetrahedron.intersects(tetrahedron.at(&moved)));
/// assert_eq!(tetrahedron.pairs(tetrahedron.at(&moved)), [[0, 1], [0, 3], [2, 1], [2, 3]]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Bvh<V> {
    pub(super) mesh: Mesh,
    /// Coordinates in `points` are in units of 2^exponent.
    pub(super) exponent: i64,
    /// The vertices in units in which coordinates have a magnitude of at most 1.
    pub(super) points: Vec<[f64; 3]>,
    /// An error of each coordinate of a point: 0 but where digits were lost to underflow.
    pub(super) rounding: f64,
    pub(super) topology: Topology,
    pub(super) volumes: Vec<V>,
    /// Half the diagonal of the box of each node: which of two nodes is opened first.
    pub(super) half_diagonals: Vec<f64>,
}

impl<V: BoundingVolume> Bvh<V> {
    /// A hierarchy over a mesh with the default options.
    pub fn build(mesh: &Mesh) -> Self {
        Self::build_with(mesh, &BuildOptions::default())
    }

    /// A hierarchy over a mesh. O(n log n) for n triangles, times the fit of a volume.
    pub fn build_with(mesh: &Mesh, options: &BuildOptions) -> Self {
        let exponent = exponent_of(mesh.vertices());
        let (points, rounding) = in_units(mesh.vertices(), exponent);
        let topology = topology(&points, mesh.triangles(), options.leaf_triangles);
        let fit = |points: &[[f64; 3]], _: usize| V::around(points, options.effort);
        let (volumes, half_diagonals) = volumes(&topology, &points, mesh.triangles(), fit);
        Self { mesh: mesh.clone(), exponent, points, rounding, topology, volumes, half_diagonals }
    }

    /// The mesh.
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// The tree over the triangles.
    pub fn topology(&self) -> &Topology {
        &self.topology
    }

    /// The volume of each node, in the units of [`unit`](Self::unit).
    pub fn volumes(&self) -> &[V] {
        &self.volumes
    }

    /// The number e such that volumes are in units of 2^e.
    pub fn unit(&self) -> i64 {
        self.exponent
    }

    /// Half the diagonal of the box of a node, in the same units.
    pub(crate) fn size(&self, node: usize) -> f64 {
        self.half_diagonals[node]
    }

    /// Whether vertices lost digits on their way into the units.
    pub(crate) fn is_rounded(&self) -> bool {
        self.rounding > 0.0
    }

    /// Moves the vertices and fits every volume anew, with the tree and the directions as they are. O(n log n).
    ///
    /// # Errors
    /// [`MeshError`] if a coordinate is not finite, or there are fewer vertices than the triangles name; the hierarchy
    /// stays as it is.
    pub fn refit(&mut self, vertices: Vec<[f64; 3]>) -> Result<(), MeshError> {
        let mesh = self.mesh.with_vertices(vertices)?;
        let exponent = exponent_of(mesh.vertices());
        let (points, rounding) = in_units(mesh.vertices(), exponent);
        *self = self.with_points(mesh, points, exponent, rounding);
        Ok(())
    }

    /// The hierarchy around other points.
    pub(super) fn with_points(&self, mesh: Mesh, points: Vec<[f64; 3]>, exponent: i64, rounding: f64) -> Self {
        let fit = |points: &[[f64; 3]], node: usize| self.volumes[node].refitted(points);
        let (volumes, half_diagonals) = volumes(&self.topology, &points, mesh.triangles(), fit);
        Self { mesh, exponent, points, rounding, topology: self.topology.clone(), volumes, half_diagonals }
    }

    /// The hierarchy where a pose puts it. O(1).
    pub fn at(&self, pose: &Pose) -> PlacedBvh<'_, V> {
        PlacedBvh { hierarchy: self, pose: *pose }
    }
}

/// A hierarchy where a pose puts it. Wherever one is expected, `&hierarchy` is the hierarchy as it stands.
#[derive(Debug)]
pub struct PlacedBvh<'a, V> {
    hierarchy: &'a Bvh<V>,
    pose: Pose,
}

// of references, whatever the volume is
impl<V> Clone for PlacedBvh<'_, V> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<V> Copy for PlacedBvh<'_, V> {}

impl<'a, V> From<&'a Bvh<V>> for PlacedBvh<'a, V> {
    fn from(hierarchy: &'a Bvh<V>) -> Self {
        Self { hierarchy, pose: Pose::IDENTITY }
    }
}

impl<'a, V: BoundingVolume> PlacedBvh<'a, V> {
    /// The hierarchy.
    pub fn hierarchy(&self) -> &'a Bvh<V> {
        self.hierarchy
    }

    /// The mesh where it stands.
    pub fn mesh(&self) -> PlacedMesh<'a> {
        self.hierarchy.mesh.at(&self.pose)
    }
}

/// The exponent of a unit in which the magnitudes of all coordinates are below 1.
fn exponent_of(vertices: &[[f64; 3]]) -> i64 {
    binary_exponent(largest_magnitude(vertices.as_flattened())).map_or(0, |exponent| i64::from(exponent) + 1)
}

/// Vertices in units of 2^exponent, and the error of a coordinate.
fn in_units(vertices: &[[f64; 3]], exponent: i64) -> (Vec<[f64; 3]>, f64) {
    let scaled = |c: f64| scale_by_power_of_two(c, -exponent);
    let points: Vec<[f64; 3]> = vertices.iter().map(|v| v.map(scaled)).collect();
    let is_back = |(v, p): (&f64, &f64)| scale_by_power_of_two(*p, exponent) == *v;
    let is_exact = vertices.as_flattened().iter().zip(points.as_flattened()).all(is_back);
    let rounding = if is_exact { 0.0 } else { crate::numeric::tolerance::UNDERFLOW };
    (points, rounding)
}
