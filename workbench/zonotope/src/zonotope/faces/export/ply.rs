//! PLY, the polygon file format.

use std::fmt::Write;

use crate::zonotope::faces::{FaceLattice, Facet};

impl FaceLattice {
    /// The body as PLY in text form: vertices in the digits that read back to the same doubles, facets as polygons,
    /// counter-clockwise from outside.
    pub fn to_ply(&self) -> String {
        let mut text = format!(
            "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\n\
             element face {}\nproperty list uint uint vertex_indices\nend_header\n",
            self.vertex_count(),
            self.facet_count()
        );
        for [x, y, z] in self.points() {
            writeln!(text, "{x:?} {y:?} {z:?}").expect("a string takes any text");
        }
        for facet in (0..self.facet_count() as u32).map(Facet) {
            let vertices = self.facet_vertices(facet);
            write!(text, "{}", vertices.len()).expect("a string takes any text");
            for vertex in vertices {
                write!(text, " {}", vertex.0).expect("a string takes any text");
            }
            text.push('\n');
        }
        text
    }
}
