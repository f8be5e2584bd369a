//! Deformations: the tree stays, the volumes follow.

use super::meshes::{random_poses, round};
use super::*;

fn follow<V: BoundingVolume>(mesh: &Mesh, vertices: &[[f64; 3]]) {
    let mut hierarchy = Bvh::<V>::build(mesh);
    hierarchy.refit(vertices.to_vec()).expect("finite");
    assert_eq!(hierarchy.validate(), Ok(()), "{}", V::NAME);
    let fresh = Bvh::<V>::build(&mesh.with_vertices(vertices.to_vec()).expect("finite"));
    for pose in random_poses(10, 3.0, 31) {
        assert_eq!(hierarchy.pairs(hierarchy.at(&pose)), fresh.pairs(fresh.at(&pose)), "{}", V::NAME);
    }
    let before = hierarchy.clone();
    assert!(hierarchy.refit(vec![[f64::NAN; 3]; vertices.len()]).is_err());
    assert_eq!(hierarchy.mesh(), before.mesh());
}

#[test]
fn volumes_follow_a_deformation() {
    let mesh = round(7, 9, 1.5);
    let bent: Vec<[f64; 3]> = mesh.vertices().iter().map(|[x, y, z]| [3.0 * x, y + x * x, z - 0.5 * x * y]).collect();
    for_each_volume!(follow(&mesh, &bent));
    let flat: Vec<[f64; 3]> = mesh.vertices().iter().map(|[x, y, _]| [*x, *y, 1.0]).collect();
    for_each_volume!(follow(&mesh, &flat));
}

#[cfg(feature = "parallel")]
#[test]
fn volumes_do_not_depend_on_the_number_of_threads() {
    let mesh = round(12, 14, 1.5);
    let build = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads can be started");
        pool.install(|| Bvh::<Zonotope4>::build(&mesh))
    };
    let [one, four] = [1, 4].map(build);
    assert!(one.volumes == four.volumes && one.topology == four.topology && one.half_diagonals == four.half_diagonals);
}
