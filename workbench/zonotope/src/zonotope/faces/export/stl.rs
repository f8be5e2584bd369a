//! Binary STL.

use crate::zonotope::faces::{FaceLattice, Facet};

impl FaceLattice {
    /// The body as binary STL: each facet cut into triangles from one vertex, counter-clockwise from outside, with its
    /// outward unit normal; coordinates rounded to single precision, infinite beyond its range.
    pub fn to_stl(&self) -> Vec<u8> {
        let facets = || (0..self.facet_count() as u32).map(Facet);
        let triangles: usize = facets().map(|facet| self.facet_vertices(facet).len() - 2).sum();
        let mut bytes = Vec::with_capacity(84 + 50 * triangles);
        let mut header = [b' '; 80];
        header[..15].copy_from_slice(b"zonotope facets");
        bytes.extend(header);
        bytes.extend((triangles as u32).to_le_bytes());
        for facet in facets() {
            let normal = self.normal(facet);
            let length = normal.iter().map(|c| c * c).sum::<f64>().sqrt();
            let points: Vec<[f64; 3]> = self.facet_vertices(facet).map(|vertex| self.point(vertex)).collect();
            for pair in points[1..].windows(2) {
                for vector in [normal.map(|c| c / length), points[0], pair[0], pair[1]] {
                    vector.iter().for_each(|&c| bytes.extend((c as f32).to_le_bytes()));
                }
                bytes.extend([0, 0]);
            }
        }
        bytes
    }
}
