//! The committed meshes, read from their files.

use zonotope::bvh::Mesh;

const NAMES: [&str; 5] = ["assimp_spider", "assimp_wuson", "cgal_cow", "cgal_fandisk", "teapot"];

/// The meshes with their names.
pub fn all() -> impl Iterator<Item = (&'static str, Mesh)> {
    NAMES.into_iter().map(|name| (name, read(name)))
}

fn read(name: &str) -> Mesh {
    let path = format!("{}/../../experiments/data/{name}.obj", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).expect("the mesh is committed");
    let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
    for line in text.lines() {
        let mut words = line.split_whitespace();
        match words.next() {
            Some("v") => {
                let mut coordinate = || words.next().and_then(|word| word.parse().ok()).expect("a number");
                vertices.push([coordinate(), coordinate(), coordinate()]);
            }
            Some("f") => {
                let corner = |word: &str| word.split('/').next().and_then(|at| at.parse::<u32>().ok());
                let corners: Vec<u32> = words.map(|word| corner(word).expect("a position from 1") - 1).collect();
                triangles.extend((2..corners.len()).map(|k| [corners[0], corners[k - 1], corners[k]]));
            }
            _ => {}
        }
    }
    Mesh::new(vertices, triangles).expect("the corners are there")
}
