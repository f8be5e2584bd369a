//! The Platonic solids.

/// A solid with its vertices.
#[derive(Clone, Copy, Debug)]
pub struct Solid {
    /// The stable name of the solid.
    pub name: &'static str,
    /// The vertices of the solid, centred at the origin.
    pub vertices: fn() -> Vec<[f64; 3]>,
}

/// The five of them, by the number of their vertices.
pub static SOLIDS: &[Solid] = &[
    Solid { name: "tetrahedron", vertices: tetrahedron },
    Solid { name: "octahedron", vertices: octahedron },
    Solid { name: "cube", vertices: cube },
    Solid { name: "icosahedron", vertices: icosahedron },
    Solid { name: "dodecahedron", vertices: dodecahedron },
];

fn tetrahedron() -> Vec<[f64; 3]> {
    vec![[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]]
}

fn octahedron() -> Vec<[f64; 3]> {
    cyclic(&[[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]])
}

fn cube() -> Vec<[f64; 3]> {
    let sign = |i: usize, c: usize| if i >> c & 1 == 0 { 1.0 } else { -1.0 };
    (0..8).map(|i| [sign(i, 0), sign(i, 1), sign(i, 2)]).collect()
}

fn icosahedron() -> Vec<[f64; 3]> {
    let golden = golden();
    cyclic(&[[0.0, 1.0, golden], [0.0, 1.0, -golden], [0.0, -1.0, golden], [0.0, -1.0, -golden]])
}

fn dodecahedron() -> Vec<[f64; 3]> {
    let (long, short) = (golden(), golden() - 1.0);
    let mut vertices = cube();
    vertices.extend(cyclic(&[[0.0, short, long], [0.0, short, -long], [0.0, -short, long], [0.0, -short, -long]]));
    vertices
}

fn golden() -> f64 {
    (1.0 + 5f64.sqrt()) / 2.0
}

/// The points with their coordinates in each of the three cyclic orders.
fn cyclic(points: &[[f64; 3]]) -> Vec<[f64; 3]> {
    (0..3).flat_map(|turn| points.iter().map(move |p| [p[turn % 3], p[(turn + 1) % 3], p[(turn + 2) % 3]])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each vertex has three, four or five nearest others, all at one distance.
    #[test]
    fn vertices_are_alike() {
        let expected = [
            ("tetrahedron", 4, 3),
            ("octahedron", 6, 4),
            ("cube", 8, 3),
            ("icosahedron", 12, 5),
            ("dodecahedron", 20, 3),
        ];
        for (solid, (name, count, neighbours)) in SOLIDS.iter().zip(expected) {
            let vertices = (solid.vertices)();
            assert_eq!((solid.name, vertices.len()), (name, count));
            for a in &vertices {
                let mut distances: Vec<f64> = vertices
                    .iter()
                    .filter(|b| *b != a)
                    .map(|b| a.iter().zip(b).map(|(x, y)| (x - y) * (x - y)).sum::<f64>())
                    .collect();
                distances.sort_by(f64::total_cmp);
                let near = distances.iter().filter(|d| **d < distances[0] * 1.001).count();
                assert_eq!(near, neighbours, "{name}");
            }
        }
    }
}
