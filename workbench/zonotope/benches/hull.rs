//! Planar hulls against the crate `geo` on the same points, and farthest vertices of all edges.
//!
//! `cargo bench -p zonotope --bench hull`; a filter such as `-- circle` selects families.

use std::f64::consts::TAU;
use std::hint::black_box;
use std::time::Duration;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use geo::ConvexHull;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use zonotope::hull::{antipodal, by_monotone_chain, convex_hull};

type Family = (&'static str, fn(usize, &mut Pcg64Mcg) -> Vec<[f64; 2]>);

const FAMILIES: [Family; 7] = [
    ("disc", |n, random| many(n, || disc_point(random))),
    ("gaussian", |n, random| many(n, || normal_point(random))),
    ("clustered", clustered),
    ("circle", |n, random| many(n, || circle_point(random.random()))),
    ("regular_polygon", |n, _| (0..n).map(|k| circle_point(k as f64 / n as f64)).collect()),
    ("random_convex", random_convex),
    ("ellipse", |n, random| many(n, || circle_point(random.random())).into_iter().map(|[x, y]| [1e3 * x, y]).collect()),
];

fn many(n: usize, point: impl FnMut() -> [f64; 2]) -> Vec<[f64; 2]> {
    std::iter::repeat_with(point).take(n).collect()
}

fn circle_point(turn: f64) -> [f64; 2] {
    [libm::cos(TAU * turn), libm::sin(TAU * turn)]
}

fn disc_point(random: &mut Pcg64Mcg) -> [f64; 2] {
    let radius = random.random::<f64>().sqrt();
    circle_point(random.random()).map(|value| value * radius)
}

fn normal_point(random: &mut Pcg64Mcg) -> [f64; 2] {
    let radius = (-2.0 * libm::log(1.0 - random.random::<f64>())).sqrt();
    circle_point(random.random()).map(|value| value * radius)
}

fn clustered(n: usize, random: &mut Pcg64Mcg) -> Vec<[f64; 2]> {
    let centers = many(20, || disc_point(random));
    many(n, || {
        let [x, y] = centers[random.random_range(0..centers.len())];
        let [dx, dy] = normal_point(random);
        [x + 0.05 * dx, y + 0.05 * dy]
    })
}

/// Random vectors that sum to zero, put end to end in the order of their angles; the vertices in random order.
fn random_convex(n: usize, random: &mut Pcg64Mcg) -> Vec<[f64; 2]> {
    let mut edges = many(n, || normal_point(random));
    let sum = edges.iter().fold([0.0; 2], |sum, edge| [sum[0] + edge[0], sum[1] + edge[1]]);
    for edge in &mut edges {
        *edge = [edge[0] - sum[0] / n as f64, edge[1] - sum[1] / n as f64];
    }
    edges.sort_by(|a, b| libm::atan2(a[1], a[0]).total_cmp(&libm::atan2(b[1], b[0])));
    let mut end = [0.0; 2];
    let mut vertices = Vec::with_capacity(n);
    for edge in edges {
        end = [end[0] + edge[0], end[1] + edge[1]];
        vertices.push(end);
    }
    for last in (1..n).rev() {
        vertices.swap(last, random.random_range(0..=last));
    }
    vertices
}

fn hulls(criterion: &mut Criterion) {
    for (name, generate) in FAMILIES {
        let mut group = criterion.benchmark_group(format!("hull/{name}"));
        for n in [10_000, 100_000, 1_000_000] {
            let points = generate(n, &mut Pcg64Mcg::seed_from_u64(1));
            let geo_points: geo::MultiPoint = points.iter().map(|&[x, y]| geo::Point::new(x, y)).collect();
            group.throughput(Throughput::Elements(n as u64));
            group.bench_with_input(BenchmarkId::new("by_discarding", n), &points, |bencher, points| {
                bencher.iter(|| convex_hull(black_box(points)));
            });
            group.bench_with_input(BenchmarkId::new("geo", n), &geo_points, |bencher, points| {
                bencher.iter(|| black_box(points).convex_hull());
            });
            group.bench_with_input(BenchmarkId::new("by_monotone_chain", n), &points, |bencher, points| {
                bencher.iter(|| by_monotone_chain::convex_hull(black_box(points)));
            });
        }
        group.finish();
    }
}

fn farthest_vertices(criterion: &mut Criterion) {
    for (name, generate) in FAMILIES {
        let mut group = criterion.benchmark_group(format!("farthest_vertices/{name}"));
        for n in [10_000, 1_000_000] {
            let points = generate(n, &mut Pcg64Mcg::seed_from_u64(1));
            let hull = convex_hull(&points).expect("the generators make finite points");
            group.throughput(Throughput::Elements(hull.edge_count() as u64));
            group.bench_with_input(BenchmarkId::new("by_rotating_calipers", n), &hull, |bencher, hull| {
                bencher.iter(|| antipodal::farthest_vertices(black_box(hull)));
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
