//! Wavefront OBJ.

use std::fmt::Write;

use crate::zonotope::faces::{FaceLattice, Facet};

impl FaceLattice {
    /// The body as Wavefront OBJ: vertices in the digits that read back to the same doubles, facets as polygons,
    /// counter-clockwise from outside.
    pub fn to_obj(&self) -> String {
        let mut text = String::with_capacity(64 * self.vertex_count() + 32 * self.facet_count());
        self.add_to_obj(&mut text, 0);
        text
    }

    /// Adds the mesh to a file that has so many vertices before it: several bodies go into one file one by one.
    pub fn add_to_obj(&self, text: &mut String, before: usize) {
        for [x, y, z] in self.points() {
            writeln!(text, "v {x:?} {y:?} {z:?}").expect("a string takes any text");
        }
        for facet in (0..self.facet_count() as u32).map(Facet) {
            text.push('f');
            for vertex in self.facet_vertices(facet) {
                write!(text, " {}", before + vertex.0 as usize + 1).expect("a string takes any text");
            }
            text.push('\n');
        }
    }
}
