//! The whole of Section 4.1 against its hull alone, and the kernel's methods against each other, on the point families.
//!
//! `cargo bench -p experiments`; a filter such as `-- whole/circle` selects. The hull against the crate `geo` is the
//! bench `hull` of `experiments/peers`.

use std::hint::black_box;
use std::time::Duration;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use zonotope::enclosing::bisectors::Bisectors;
use zonotope::enclosing::min_area;
use zonotope::hull::antipodal::farthest_vertices;
use zonotope::hull::convex_hull;
use zonotope::lad::Method;

const FAMILIES: [&str; 8] =
    ["disc", "gaussian", "clustered", "circle", "ellipse", "ellipse_thin", "random_convex", "regular_polygon"];
const SIZES: [usize; 3] = [10_000, 100_000, 1_000_000];
const SEED: u64 = 1;

fn points(family: &str, n: usize) -> Vec<[f64; 2]> {
    families::points::find(family).expect("the list above names families").generate(n, SEED)
}

fn whole(criterion: &mut Criterion) {
    for family in FAMILIES {
        let mut group = criterion.benchmark_group(format!("whole/{family}"));
        group.sample_size(10).warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_secs(1));
        for n in SIZES {
            let points = points(family, n);
            group.throughput(Throughput::Elements(n as u64));
            group.bench_with_input(BenchmarkId::new("hull", n), &points, |bench, points| {
                bench.iter(|| black_box(convex_hull(points, &mut ())));
            });
            group.bench_with_input(BenchmarkId::new("min_area", n), &points, |bench, points| {
                bench.iter(|| black_box(min_area(points)));
            });
        }
    }
}

fn kernel(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("kernel/circle");
    group.sample_size(10).warm_up_time(Duration::from_millis(100)).measurement_time(Duration::from_secs(1));
    for n in SIZES {
        let hull = convex_hull(&points("circle", n), &mut ()).expect("the family makes finite points");
        let farthest = farthest_vertices(&hull, &mut ());
        let problem = Bisectors::new(&hull, &farthest).kernel_problem();
        for method in Method::FAST {
            group.bench_with_input(BenchmarkId::new(method.id(), n), &problem, |bench, problem| {
                bench.iter(|| black_box(method.minimize(problem, SEED, &mut ())));
            });
        }
    }
}

criterion_group!(benches, whole, kernel);
criterion_main!(benches);
