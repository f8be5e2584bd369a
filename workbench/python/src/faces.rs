//! Vertices and facets as arrays.

use zonotope::Zonotope;
use zonotope::zonotope::faces::{Faces, FacesError, Facet, faces};

/// Vertices, and facets as lists of their indices.
pub(crate) struct Drawn<const D: usize> {
    /// Coordinates, rounded.
    pub(crate) vertices: Vec<[f64; D]>,
    /// The vertices of all facets, one facet after the other, each in order around it.
    pub(crate) corners: Vec<u32>,
    /// The places at which the corners of each facet begin, and that at which those of the last one end.
    pub(crate) starts: Vec<u32>,
}

impl<const D: usize> Drawn<D> {
    fn new(vertices: Vec<[f64; D]>) -> Self {
        Self { vertices, corners: Vec::new(), starts: vec![0] }
    }

    fn add(&mut self, facet: impl IntoIterator<Item = u32>) {
        self.corners.extend(facet);
        self.starts.push(self.corners.len() as u32);
    }
}

/// The ends of a segment, each a facet; a point has none.
pub(crate) fn of_segment(body: &Zonotope<1>) -> Drawn<1> {
    let [low, high] = [-1.0, 1.0].map(|sign| body.support([sign]).point());
    if low == high {
        return Drawn::new(vec![low]);
    }
    let mut drawn = Drawn::new(vec![low, high]);
    drawn.add([0]);
    drawn.add([1]);
    drawn
}

/// The corners of a zonogon, counter-clockwise, and its edges.
pub(crate) fn of_zonogon(body: &Zonotope<2>) -> Drawn<2> {
    let mut drawn = Drawn::new(body.vertices());
    let count = drawn.vertices.len() as u32;
    if count > 2 {
        (0..count).for_each(|i| drawn.add([i, (i + 1) % count]));
    }
    drawn
}

/// The vertices of a body of space, and its facets counter-clockwise from outside; a flat one has its two sides.
pub(crate) fn in_space(body: &Zonotope<3>) -> Result<Drawn<3>, FacesError> {
    Ok(match faces(body, &mut ())? {
        Faces::Point(point) => Drawn::new(vec![point]),
        Faces::Segment(ends) => Drawn::new(ends.to_vec()),
        Faces::Flat(lattice) | Faces::Solid(lattice) => {
            let mut drawn = Drawn::new(lattice.points().to_vec());
            (0..lattice.facet_count() as u32)
                .for_each(|facet| drawn.add(lattice.facet_vertices(Facet(facet)).map(|vertex| vertex.0)));
            drawn
        }
    })
}
