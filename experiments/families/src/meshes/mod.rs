//! Surfaces of triangles, each of its own size, for hierarchies of bounding volumes.
//!
//! | mesh | what it is for |
//! | --- | --- |
//! | `torus`, `knot` | round tubes, closed |
//! | `bumps` | a body with volume and no flat part |
//! | `terrain` | a height field: flat at a large scale |
//! | `spring` | a long thin tube |
//! | `needles` | thin spikes in all directions |

use crate::source::RandomSource;
use std::f64::consts::{PI, TAU};

/// Vertices and triangles, which name vertices from 0.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// The vertices.
    pub vertices: Vec<[f64; 3]>,
    /// Three vertices a triangle.
    pub triangles: Vec<[u32; 3]>,
}

/// A surface with its name.
#[derive(Clone, Copy, Debug)]
pub struct MadeMesh {
    /// The stable name: part of every case id.
    pub id: &'static str,
    /// The surface, the same at every call.
    pub make: fn() -> Surface,
}

/// All surfaces.
pub static MADE_MESHES: &[MadeMesh] = &[
    MadeMesh { id: "torus", make: torus },
    MadeMesh { id: "knot", make: knot },
    MadeMesh { id: "bumps", make: bumps },
    MadeMesh { id: "terrain", make: terrain },
    MadeMesh { id: "spring", make: spring },
    MadeMesh { id: "needles", make: needles },
];

/// The surface called `id`, if there is one.
pub fn find(id: &str) -> Option<&'static MadeMesh> {
    MADE_MESHES.iter().find(|mesh| mesh.id == id)
}

/// Spikes of `needles`, and how thick one is for its length of about 1.
const SPIKES: u32 = 300;
const THICKNESS: f64 = 0.01;

/// A surface over a grid of parameters from 0 to 1, each of which may be closed to a circle.
fn grid([rows, columns]: [u32; 2], is_closed: [bool; 2], point: impl Fn(f64, f64) -> [f64; 3]) -> Surface {
    let nodes = |cells: u32, is_closed: bool| if is_closed { cells } else { cells + 1 };
    let [high, wide] = [nodes(rows, is_closed[0]), nodes(columns, is_closed[1])];
    let share = |i: u32, cells: u32| f64::from(i) / f64::from(cells);
    let vertices = (0..high).flat_map(|i| (0..wide).map(move |j| (i, j)));
    let vertices = vertices.map(|(i, j)| point(share(i, rows), share(j, columns))).collect();
    let at = |i: u32, j: u32| (i % high) * wide + j % wide;
    let square = |(i, j): (u32, u32)| {
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        [[a, b, c], [a, c, d]]
    };
    let triangles = (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))).flat_map(square).collect();
    Surface { vertices, triangles }
}

/// A round tube about a curve that is nowhere vertical.
fn tube(cells: [u32; 2], is_closed: bool, radius: f64, curve: impl Fn(f64) -> [f64; 3]) -> Surface {
    const STEP: f64 = 1e-4;
    grid(cells, [is_closed, true], |s, t| {
        let [before, here, after] = [s - STEP, s, s + STEP].map(&curve);
        let along: [f64; 3] = std::array::from_fn(|k| after[k] - before[k]);
        let level = libm::sqrt(along[0] * along[0] + along[1] * along[1]);
        let aside = [along[1] / level, -along[0] / level, 0.0];
        let length = libm::sqrt(level * level + along[2] * along[2]);
        let up = [-along[0] * along[2] / level, -along[1] * along[2] / level, level].map(|c| c / length);
        let (sin, cos) = libm::sincos(TAU * t);
        std::array::from_fn(|k| here[k] + radius * (cos * aside[k] + sin * up[k]))
    })
}

fn torus() -> Surface {
    tube([48, 20], true, 0.4, |s| {
        let (sin, cos) = libm::sincos(TAU * s);
        [cos, sin, 0.0]
    })
}

fn knot() -> Surface {
    tube([100, 10], true, 0.3, |s| {
        let turn = |times: f64| libm::sincos(TAU * s * times);
        let [(sin, cos), (sin_2, cos_2), (sin_3, _)] = [1.0, 2.0, 3.0].map(turn);
        [sin + 2.0 * sin_2, cos - 2.0 * cos_2, -sin_3]
    })
}

fn spring() -> Surface {
    tube([160, 6], false, 0.08, |s| {
        let (sin, cos) = libm::sincos(8.0 * TAU * s);
        [cos, sin, 4.0 * s]
    })
}

fn bumps() -> Surface {
    grid([24, 40], [false, true], |s, t| {
        let ((up, level), (sin, cos)) = (libm::sincos(PI * (s - 0.5)), libm::sincos(TAU * t));
        let radius = 1.0 + 0.15 * libm::sin(5.0 * TAU * t) * level * libm::cos(6.0 * PI * s);
        [radius * level * cos, radius * level * sin, radius * up]
    })
}

fn terrain() -> Surface {
    grid([32, 32], [false, false], |s, t| {
        let wave = |a: f64, b: f64, c: f64| libm::sin(TAU * (a * s + b * t + c));
        [4.0 * s, 4.0 * t, 0.25 * (wave(1.0, 0.6, 0.1) + 0.5 * wave(-1.3, 2.1, 0.4) + 0.25 * wave(4.1, 3.2, 0.7))]
    })
}

/// Thin tetrahedra, about as long as the cube of their middles is wide.
fn needles() -> Surface {
    let mut random = RandomSource::new(1);
    let mut signed = |size: f64| [0; 3].map(|_| size * random.signed_unit());
    let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
    for spike in 0..SPIKES {
        let (middle, half) = (signed(0.5), signed(0.5));
        for corner in [1.0, -1.0, -1.0, -1.0] {
            let off = signed(THICKNESS);
            vertices.push(std::array::from_fn(|k| middle[k] + corner * half[k] + off[k]));
        }
        triangles.extend([[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]].map(|t: [u32; 3]| t.map(|c| 4 * spike + c)));
    }
    Surface { vertices, triangles }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeMap;

    #[test]
    fn triangles_name_vertices_and_sizes_are_stated() {
        let sizes: Vec<_> = MADE_MESHES.iter().map(|mesh| (mesh.id, (mesh.make)())).collect();
        for (id, surface) in &sizes {
            assert!(surface.vertices.iter().flatten().all(|c| c.is_finite()), "{id}");
            assert!(surface.triangles.iter().flatten().all(|&v| (v as usize) < surface.vertices.len()), "{id}");
            assert_eq!((find(id).expect("listed").make)(), *surface, "{id}");
        }
        let triangles: Vec<usize> = sizes.iter().map(|(_, surface)| surface.triangles.len()).collect();
        assert_eq!(triangles, [1920, 2000, 1920, 2048, 1920, 1200]);
    }

    #[test]
    fn closed_surfaces_have_two_triangles_at_every_edge() {
        for id in ["torus", "knot", "needles"] {
            let mut edges: BTreeMap<[u32; 2], u32> = BTreeMap::new();
            for [a, b, c] in (find(id).expect("listed").make)().triangles {
                for [from, to] in [[a, b], [b, c], [c, a]] {
                    *edges.entry([from.min(to), from.max(to)]).or_default() += 1;
                }
            }
            assert!(edges.values().all(|count| *count == 2), "{id}");
        }
    }
}
