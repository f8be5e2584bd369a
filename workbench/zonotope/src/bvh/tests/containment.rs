//! Every volume of every node holds its triangles, exactly.

use super::meshes::round;
use super::*;

/// The committed meshes by their files.
const FILES: [&str; 2] = ["teapot.obj", "assimp_spider.obj"];

fn read(file: &str) -> Mesh {
    let path = format!("{}/../../experiments/data/{file}", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).expect("the mesh is committed");
    let mut vertices = Vec::new();
    let mut triangles = Vec::new();
    for line in text.lines() {
        let mut words = line.split_whitespace();
        match words.next() {
            Some("v") => {
                let mut coordinate = || words.next().and_then(|word| word.parse().ok()).expect("a number");
                vertices.push([coordinate(), coordinate(), coordinate()]);
            }
            Some("f") => {
                let place =
                    |word: &str| -> u32 { word.split('/').next().and_then(|at| at.parse().ok()).expect("a place") };
                let corners: Vec<u32> = words.map(|word| place(word) - 1).collect();
                triangles.extend((2..corners.len()).map(|k| [corners[0], corners[k - 1], corners[k]]));
            }
            _ => {}
        }
    }
    Mesh::new(vertices, triangles).expect("a mesh")
}

fn validate<V: BoundingVolume>(mesh: &Mesh, effort: usize) {
    let options = BuildOptions { effort, ..BuildOptions::default() };
    let hierarchy = Bvh::<V>::build_with(mesh, &options);
    assert_eq!(hierarchy.validate(), Ok(()), "{}", V::NAME);
    for (node, volume) in hierarchy.topology.nodes.iter().zip(&hierarchy.volumes) {
        let body = volume.as_zonotope();
        for &triangle in &hierarchy.topology.order[node.range()] {
            for vertex in mesh.triangles()[triangle as usize] {
                assert_eq!(body.contains(hierarchy.points[vertex as usize]), Ok(true), "{}", V::NAME);
            }
        }
    }
}

#[test]
fn volumes_of_committed_meshes_contain_their_triangles() {
    for file in FILES {
        let mesh = read(file);
        for_each_volume!(validate(&mesh, 0));
    }
}

#[test]
fn volumes_that_were_searched_for_contain_their_triangles() {
    let mesh = round(9, 12, 1.5);
    for_each_volume!(validate(&mesh, 3));
}

#[test]
fn a_volume_that_misses_a_triangle_is_a_fault() {
    let mesh = round(5, 6, 1.5);
    let mut hierarchy = Bvh::<OrientedBox>::build(&mesh);
    let other = hierarchy.volumes.len() - 1;
    hierarchy.volumes.swap(1, other);
    assert!(matches!(hierarchy.validate(), Err(Fault::Outside { .. })));
    hierarchy.volumes.swap(1, other);
    hierarchy.topology.order[0] = hierarchy.topology.order[1];
    assert!(hierarchy.validate().is_err());
}
