//! Tests of nodes by two hierarchies over copies of a mesh, by bounding volume and distance; and their times.

use crate::definition::{Case, Experiment, Measurement, PerProfile, TimedWork, Timing, Variant, Verdict};
use crate::hierarchies::{Asked, MESHES, Scene, scene};
use crate::seed::Digest;
use std::sync::Arc;
use zonotope::bvh::{
    Aabb, BoundingVolume, Bvh, Dop18, Dop26, Method, OrientedBox, Sphere, Zonotope3, Zonotope4, Zonotope5, Zonotope6,
    ZonotopeByCost,
};
use zonotope::tally::OperationCounts;

/// Nodes of fewer triangles than this do not count for the fit: the least zonotope of a triangle is a box.
const FEWEST_TRIANGLES: usize = 8;

/// The meshes whose hierarchies are timed.
const TIMED: [&str; 3] = ["teapot", "bumps", "needles"];

/// The meshes that the quick profile leaves out.
const LARGE: [&str; 1] = ["cgal_fandisk"];

/// The volume that the others are compared with.
pub const BOXES: &str = "obb";

const VARIANTS: &[Variant] = &[
    Variant::at_all_sizes(BOXES, "Boxes that a search turns"),
    Variant::at_all_sizes("aabb", "Boxes along the axes"),
    Variant::at_all_sizes("sphere", "Spheres"),
    Variant::at_all_sizes("dop_18", "Polytopes of 18 normals"),
    Variant::at_all_sizes("dop_26", "Polytopes of 26 normals"),
    Variant::at_all_sizes("zonotope_3", "Zonotopes, K = 3"),
    Variant::at_all_sizes("zonotope_4", "Zonotopes, K = 4"),
    Variant::at_all_sizes("zonotope_5", "Zonotopes, K = 5"),
    Variant::at_all_sizes("zonotope_6", "Zonotopes, K = 6"),
    Variant::at_all_sizes("zonotope_by_cost", "Zonotopes, K = 3 to 6 by cost"),
];

/// The numbers of tests.
pub const COUNTS: Experiment = Experiment {
    id: "mesh-node-tests",
    title: "Meshes: tests of nodes by bounding volume and distance",
    question: "How many pairs of nodes do two hierarchies over copies of a mesh test, by bounding volume? n random \
               poses of the second copy; `at_30` to `at_0.1` are the mean numbers of pairs of nodes where the copies \
               are so many per cent of the diagonal of the mesh's box apart, `contact` until the first pair of \
               triangles of copies that overlap by one per cent, `all_pairs` until all of them. `fit` is the geometric \
               mean over nodes of eight triangles and more of the expected overlaps over those of a searched box. \
               Tree, leaves and tests of triangles are the same for all volumes, and each answer is compared with the \
               pose.",
    claims: &["question-hierarchies"],
    families: &MESHES,
    only_full: &LARGE,
    sizes: PerProfile { quick: &[4], full: &[200] },
    variants: VARIANTS,
    measure,
    ..Experiment::COUNTED
};

/// The times of the same.
pub const TIMES: Experiment = Experiment {
    id: "mesh-times",
    title: "Meshes: times by bounding volume and distance",
    question: "How long do two hierarchies over copies of a mesh take, by bounding volume? The same questions as those \
               of the numbers of tests, on some of the meshes; each time is that of all n poses, and `build` that of \
               one hierarchy. The turning of a question is part of its time.",
    claims: &["question-hierarchies"],
    families: &TIMED,
    timing: Some(Timing {
        sizes: PerProfile { quick: &[4], full: &[200] },
        repetitions: PerProfile { quick: 3, full: 5 },
        prepare,
    }),
    ..COUNTS
};

/// The measurements of the hierarchies of one volume.
struct Measures {
    counted: fn(&Scene) -> Result<Measurement, String>,
    timed: fn(Arc<Scene>) -> TimedWork,
}

impl Measures {
    const fn of<V: BoundingVolume>() -> Self {
        Self { counted: counted::<V>, timed: timed::<V> }
    }
}

fn of_volume(id: &str) -> Result<Measures, String> {
    Ok(match Method::from_id(id) {
        Some(Method::Aabb) => Measures::of::<Aabb>(),
        Some(Method::Sphere) => Measures::of::<Sphere>(),
        Some(Method::OrientedBox) => Measures::of::<OrientedBox>(),
        Some(Method::Dop18) => Measures::of::<Dop18>(),
        Some(Method::Dop26) => Measures::of::<Dop26>(),
        Some(Method::Zonotope3) => Measures::of::<Zonotope3>(),
        Some(Method::Zonotope4) => Measures::of::<Zonotope4>(),
        Some(Method::Zonotope5) => Measures::of::<Zonotope5>(),
        Some(Method::Zonotope6) => Measures::of::<Zonotope6>(),
        Some(Method::ZonotopeByCost) => Measures::of::<ZonotopeByCost>(),
        _ => return Err(format!("no volume is called {id}")),
    })
}

fn measure(case: &Case) -> Result<Measurement, String> {
    (of_volume(case.variant)?.counted)(&*scene(case.family, case.n, case.instance_seed)?)
}

fn prepare(case: &Case) -> Result<TimedWork, String> {
    Ok((of_volume(case.variant)?.timed)(scene(case.family, case.n, case.instance_seed)?))
}

fn counted<V: BoundingVolume>(scene: &Scene) -> Result<Measurement, String> {
    let hierarchy = Bvh::<V>::build(&scene.mesh);
    let mut digest = Digest::default();
    let mut numbers = vec![("fit", fit(&scene.boxes, &hierarchy))];
    for asked in Asked::all() {
        let (tests, pairs) = asked.tests(&hierarchy, &scene.placed)?;
        digest = digest.word(pairs as u64);
        numbers.push((asked.name(), tests.nodes));
    }
    let verdict = Verdict::Correct("distance of the poses".to_owned());
    let measurement = Measurement::new(&OperationCounts::default(), digest.finish(), verdict);
    Ok(numbers.into_iter().fold(measurement, |measurement, (name, number)| measurement.with_value(name, number)))
}

fn timed<V: BoundingVolume>(scene: Arc<Scene>) -> TimedWork {
    Box::new(move |stopwatch| {
        let hierarchy = stopwatch.lap("build", || Bvh::<V>::build(&scene.mesh));
        let mut digest = Digest::default();
        for asked in Asked::all() {
            let (_, pairs) = stopwatch.lap(asked.name(), || asked.tests(&hierarchy, &scene.placed))?;
            digest = digest.word(pairs as u64);
        }
        Ok(digest.finish())
    })
}

/// The geometric mean over the larger nodes of the expected overlaps over those of searched boxes.
fn fit<V: BoundingVolume>(boxes: &Bvh<OrientedBox>, hierarchy: &Bvh<V>) -> f64 {
    let nodes = hierarchy.topology().nodes().iter().zip(hierarchy.volumes().iter().zip(boxes.volumes()));
    let larger = nodes.filter(|(node, _)| node.range().len() >= FEWEST_TRIANGLES);
    let ratios = larger.map(|(_, (volume, of_box))| volume.expected_overlaps() / of_box.expected_overlaps());
    let logarithms: Vec<f64> = ratios.map(libm::log).filter(|ratio| ratio.is_finite()).collect();
    libm::exp(logarithms.iter().sum::<f64>() / logarithms.len() as f64)
}
