//! Planar hulls against the crate `geo` on the same points, and farthest vertices of all edges.
//!
//! `cargo bench -p peers --features others`; a filter such as `-- circle` selects families.

use std::hint::black_box;
use std::time::Duration;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use geo::ConvexHull;
use zonotope::hull::{antipodal, by_monotone_chain, convex_hull};

const FAMILIES: [&str; 8] =
    ["disc", "gaussian", "clustered", "circle", "ellipse", "ellipse_thin", "random_convex", "regular_polygon"];
const SEED: u64 = 1;

fn points(family: &str, n: usize) -> Vec<[f64; 2]> {
    families::points::find(family).expect("the list above names families").generate(n, SEED)
}

fn hulls(criterion: &mut Criterion) {
    for family in FAMILIES {
        let mut group = criterion.benchmark_group(format!("hull/{family}"));
        for n in [10_000, 100_000, 1_000_000] {
            let points = points(family, n);
            let geo_points: geo::MultiPoint = points.iter().map(|&[x, y]| geo::Point::new(x, y)).collect();
            group.throughput(Throughput::Elements(n as u64));
            group.bench_with_input(BenchmarkId::new("by_discarding", n), &points, |bencher, points| {
                bencher.iter(|| convex_hull(black_box(points), &mut ()));
            });
            group.bench_with_input(BenchmarkId::new("geo", n), &geo_points, |bencher, points| {
                bencher.iter(|| black_box(points).convex_hull());
            });
            group.bench_with_input(BenchmarkId::new("by_monotone_chain", n), &points, |bencher, points| {
                bencher.iter(|| by_monotone_chain::convex_hull(black_box(points), &mut ()));
            });
        }
        group.finish();
    }
}

fn farthest_vertices(criterion: &mut Criterion) {
    for family in FAMILIES {
        let mut group = criterion.benchmark_group(format!("farthest_vertices/{family}"));
        for n in [10_000, 1_000_000] {
            let hull = convex_hull(&points(family, n), &mut ()).expect("the families are finite");
            group.throughput(Throughput::Elements(hull.edge_count() as u64));
            group.bench_with_input(BenchmarkId::new("by_rotating_calipers", n), &hull, |bencher, hull| {
                bencher.iter(|| antipodal::farthest_vertices(black_box(hull), &mut ()));
            });
        }
        group.finish();
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .sample_size(10)
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(1));
    targets = hulls, farthest_vertices
}
criterion_main!(benches);
