//! The time of each problem of the library by its default method, on random input: what is prepared, reduced, enclosed,
//! fitted, moved, arranged and traversed. Questions about one body or two have the bench `front_door`, faces `faces`.
//! `preparing/pass` is the support function in doubles, to measure the others by.
//!
//! `cargo bench -p zonotope --bench problems`; a filter such as `-- enclosing` or `-- /10000` selects.

use std::hint::black_box;
use std::num::NonZeroU32;
use std::sync::Arc;
use std::time::Duration;

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, BenchmarkId, Criterion, criterion_group, criterion_main};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use zonotope::arrangement::cutting::cutting;
use zonotope::arrangement::dynamic_hull::{DynamicChain, HullChain, PlanarPoint, Side, SiteIndex, SortedSites};
use zonotope::arrangement::facet_walk;
use zonotope::arrangement::separator::separator;
use zonotope::arrangement::slope_selection::kth_leftmost_vertex;
use zonotope::arrangement::tiling::by_face_lattice::facet_tiling;
use zonotope::arrangement::{DualArrangement, LineArrangement};
use zonotope::bvh::{Bvh, Mesh, Zonotope6};
use zonotope::collision::hierarchy::Hierarchy;
use zonotope::collision::prepared::DirectionTree;
use zonotope::collision::prepared::by_cutting::PreparedByCutting;
use zonotope::collision::upper_hull;
use zonotope::enclosing::centered_zonogon::CenteredZonogon;
use zonotope::enclosing::{along_directions, min_area, min_length};
use zonotope::hull::antipodal::farthest_vertices;
use zonotope::hull::convex_hull;
use zonotope::hull::in_space::solid_hull;
use zonotope::lad::of_forms::{self, SpaceLadProblem, WeightedPlane};
use zonotope::line_fit;
use zonotope::motion::continuous::first_contact;
use zonotope::reduction::hausdorff::hausdorff;
use zonotope::reduction::{self, Problem};
use zonotope::seed::DEFAULT_SEED;
use zonotope::zonotope::{PreparedBody, combinatorics};
use zonotope::{Motion, Pose, Zonotope};

/// Random vectors with coordinates from −1 to 1.
fn vectors<const D: usize>(count: usize) -> Vec<[f64; D]> {
    let mut random = Pcg64Mcg::seed_from_u64(1);
    (0..count).map(|_| [(); D].map(|()| random.random_range(-1.0..1.0))).collect()
}

/// Random points of the unit sphere.
fn sphere(count: usize) -> Vec<[f64; 3]> {
    let round = |v: [f64; 3]| v.map(|c| c / (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt());
    vectors(count).into_iter().map(round).collect()
}

fn body<const D: usize>(center: [f64; D], count: usize) -> Zonotope<D> {
    Zonotope::new(center, vectors(count)).expect("random numbers are finite")
}

/// Times some work on an input of a size.
fn time<T>(group: &mut BenchmarkGroup<'_, WallTime>, name: &str, size: usize, mut work: impl FnMut() -> T) {
    group.bench_function(BenchmarkId::new(name, size), |bencher| bencher.iter(|| black_box(work())));
}

fn preparing(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("preparing");
    for n in [1 << 10, 1 << 14, 1 << 20] {
        let (body, rays) = (body([0.0; 3], n), vectors::<3>(1));
        let prepared = PreparedBody::new(body.clone());
        time(&mut group, "pass", n, || prepared.absolute_sum(black_box(&rays[0])));
        time(&mut group, "rows", n, || Zonotope::new(body.center(), body.generators().to_vec()));
        time(&mut group, "prepared", n, || PreparedBody::new(body.clone()));
        time(&mut group, "tree", n, || DirectionTree::new(&body));
        let tree = DirectionTree::new(&body);
        time(&mut group, "tree_gauge", n, || tree.gauge(black_box(rays[0]), &mut ()));
        let chosen = body.prepared_for(1_000_000);
        time(&mut group, "prepared_for_contains", n, || chosen.contains(black_box(rays[0])));
    }
    let body = body([0.0; 3], 200);
    let built = || PreparedByCutting::new(body.clone(), 1 << 14, DEFAULT_SEED, &mut ());
    time(&mut group, "cutting", 200, built);
    time(&mut group, "hierarchy", 200, || Hierarchy::new(body.clone()));
    let hierarchy = Hierarchy::new(body.clone());
    time(&mut group, "hierarchy_intersection", 200, || hierarchy.intersection(&hierarchy, &mut ()).visited());
}

fn reducing(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("reducing");
    let (large, small) = (body([0.0; 3], 1_000_000), body([0.0; 3], 200));
    let problem = |body, count| Problem::new(body, count).expect("three generators span a body");
    time(&mut group, "patches_to_64", 1_000_000, || reduction::Method::Patches.reduce(&problem(&large, 64)));
    for method in reduction::Method::ALL {
        time(&mut group, &format!("{}_to_20", method.id()), 200, || method.reduce(&problem(&small, 20)));
    }
    let reduced = reduction::Method::Clusters.reduce(&problem(&small, 20)).expect("numbers are in range").body;
    time(&mut group, "hausdorff", 200, || hausdorff(&small, &reduced, 0.1));
    time(&mut group, "contains", 200, || reduction::contains(&reduced, &small));
}

fn enclosing(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("enclosing");
    for n in [100, 10_000] {
        let (plane, space) = (vectors::<2>(n), vectors::<3>(n));
        time(&mut group, "hull", n, || convex_hull(&plane, &mut ()));
        time(&mut group, "hull_in_space", n, || solid_hull(&space));
        time(&mut group, "min_area", n, || min_area(&plane));
        let hull = convex_hull(&plane, &mut ()).expect("random numbers are finite");
        let farthest = farthest_vertices(&hull, &mut ());
        time(&mut group, "centered_zonogon", n, || {
            CenteredZonogon::new(&hull, &farthest, [0.0; 2], &mut ()).vertices()
        });
        for count in [4, 10] {
            let directions = vectors::<3>(count);
            time(&mut group, &format!("along_{count}_directions"), n, || along_directions(&space, &directions));
        }
        time(&mut group, "min_length_in_the_plane", n, || min_length(&plane, 0.01));
        time(&mut group, "min_length_in_space", n, || min_length(&space, 0.01));
    }
    let round = sphere(200);
    time(&mut group, "min_length_of_a_sphere", 200, || min_length(&round, 0.01));
}

fn fitting(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("fitting");
    for n in [1_000, 1_000_000] {
        let points = vectors::<3>(n);
        let weighted: Vec<_> = points.iter().map(|&[x, y, w]| [x, y, w.abs()]).collect();
        time(&mut group, "line_fit", n, || line_fit::fit(&weighted).map(|fit| fit.rounded()));
    }
    let planes = vectors::<4>(100)
        .into_iter()
        .map(|[x, y, z, offset]| WeightedPlane { normal: [x, y, z], offset, weight: 1.0 })
        .collect();
    let problem = SpaceLadProblem::new(planes, [0.0; 3]).expect("random numbers are finite");
    time(&mut group, "of_forms", 100, || of_forms::minimize(&problem, &mut ()));
}

fn arranging(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("arranging");
    let n = 1_000;
    let generators = vectors::<3>(n);
    let lines = LineArrangement::from_rows(&generators).expect("random numbers are finite");
    let middle = lines.vertex_count() / 2;
    time(&mut group, "slope_selection", n, || kth_leftmost_vertex(&lines, middle, DEFAULT_SEED, &mut ()));
    let dual = DualArrangement::new(&generators).expect("random numbers are finite");
    time(&mut group, "separator", n, || separator(&dual, n as u64 / 2, DEFAULT_SEED, &mut ()));
    time(&mut group, "upper_hull", n, || upper_hull::height(&generators, [0.1, 0.2], &mut ()));
    let tenths = NonZeroU32::new(10).expect("ten is not zero");
    time(&mut group, "cutting", n, || cutting(&lines, tenths, DEFAULT_SEED, &mut ()).trapezoids().len());
    let points: Vec<_> = vectors(n).into_iter().map(|p| PlanarPoint::new(p).expect("finite")).collect();
    let sites = Arc::new(SortedSites::new(&points).expect("few enough"));
    let mut chain = DynamicChain::new(sites, Side::Upper, (0..n as u32).map(SiteIndex)).expect("there are as many");
    time(&mut group, "dynamic_hull_update", n, || (chain.delete(SiteIndex(7)), chain.insert(SiteIndex(7))));
    let mut walk = facet_walk::Method::default().walk(&generators).expect("random generators span space");
    time(&mut group, "facet_walk_step", n, || walk.step(0));
    let few = body([0.0; 3], 40);
    time(&mut group, "tiling", 40, || facet_tiling(&few));
    time(&mut group, "combinatorics", 40, || combinatorics(&few));
    let zonogon = body([0.0; 2], n);
    time(&mut group, "zonogon_vertices", n, || zonogon.vertices());
    time(&mut group, "zonogon_area", n, || zonogon.exact_area());
}

/// Moving bodies that meet on the way, and two surfaces over a square that cross.
fn moving(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("moving");
    for n in [6, 64, 1_000] {
        let (still, moved) = (body([0.0; 3], n), body([2.0 * n as f64, 0.0, 0.0], n));
        let motion = Motion::constant_rate(moved.center(), [0.0, 0.0, 1.0], 1.0, [-2.0 * n as f64, 0.0, 0.0]);
        let motion = motion.expect("the axis is not zero");
        time(&mut group, "first_contact", n, || first_contact([&still, &moved], [&Motion::rest(), &motion]));
        time(&mut group, "swept", n, || moved.swept(&motion));
    }
    let side = 64;
    let heights = vectors::<1>((side * side) as usize);
    let place = |i: u32| [f64::from(i % side), f64::from(i / side), heights[i as usize][0]];
    let corners = (0..side * (side - 1)).filter(|i| i % side + 1 < side);
    let triangles = corners.flat_map(|i| [[i, i + 1, i + side], [i + 1, i + side + 1, i + side]]).collect();
    let mesh = Mesh::new((0..side * side).map(place).collect(), triangles).expect("the vertices are there");
    let (count, tree) = (mesh.triangles().len(), Bvh::<Zonotope6>::build(&mesh));
    time(&mut group, "mesh_build", count, || Bvh::<Zonotope6>::build(&mesh));
    let [near, above] =
        [0.5, 2.5].map(|z| Pose::from_axis_angle([1.0, 2.0, 3.0], 0.01, [0.3, 0.4, z]).expect("an axis"));
    time(&mut group, "mesh_intersects", count, || tree.intersects(tree.at(&near)));
    time(&mut group, "mesh_pairs", count, || tree.pairs(tree.at(&near)).len());
    time(&mut group, "mesh_distance", count, || tree.distance(tree.at(&above)));
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .sample_size(10)
        .warm_up_time(Duration::from_millis(20))
        .measurement_time(Duration::from_millis(200));
    targets = preparing, reducing, enclosing, fitting, arranging, moving
}
criterion_main!(benches);
