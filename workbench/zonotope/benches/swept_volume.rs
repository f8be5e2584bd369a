//! The volume of Theorem 6.1 against projecting the generators along the axis and sorting them by angle.
//!
//! `cargo bench -p zonotope --bench swept_volume`; a filter such as `-- 100000` selects sizes.

use std::hint::black_box;
use std::time::Duration;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use zonotope::motion::space_time::{Sweep, by_farthest_vertex};
use zonotope::zonotope::Zonotope;

/// The axis, and two vectors that are orthogonal to it and to each other.
const AXIS: [f64; 3] = [1.0, 2.0, 2.0];
const ACROSS: [[f64; 3]; 2] = [[2.0, 1.0, -2.0], [2.0, -2.0, 1.0]];

fn random_body(count: usize) -> Zonotope<3> {
    let mut random = Pcg64Mcg::seed_from_u64(1);
    let generators = (0..count).map(|_| [0, 1, 2].map(|_| random.random::<f64>() - 0.5)).collect();
    Zonotope::new([1.0, 0.0, 0.0], generators).expect("random numbers are finite")
}

/// The projected generators, turned to the right and sorted by angle.
fn projected_and_sorted(generators: &[[f64; 3]]) -> Vec<[f64; 2]> {
    let along = |g: &[f64; 3], u: &[f64; 3]| g[0] * u[0] + g[1] * u[1] + g[2] * u[2];
    let mut shadow: Vec<[f64; 2]> = generators
        .iter()
        .map(|g| {
            let [x, y] = ACROSS.each_ref().map(|u| along(g, u) / 3.0);
            if x < 0.0 { [-x, -y] } else { [x, y] }
        })
        .collect();
    shadow.sort_unstable_by(|a, b| (a[1] * b[0]).total_cmp(&(b[1] * a[0])));
    shadow
}

fn volumes(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("swept_volume");
    let sweep = Sweep::new([0.0; 3], AXIS, 0.5, [3.0, 0.0, 0.0]).expect("an axis");
    for n in [1_000, 10_000, 100_000] {
        let body = random_body(n);
        group.throughput(Throughput::Elements(n as u64));
        group.bench_with_input(BenchmarkId::new("projecting_and_sorting", n), &body, |bencher, body| {
            bencher.iter(|| projected_and_sorted(black_box(body.generators())));
        });
        group.bench_with_input(BenchmarkId::new("by_farthest_vertex", n), &body, |bencher, body| {
            bencher.iter(|| by_farthest_vertex::volume(&sweep, black_box(body), &mut ()));
        });
    }
    group.finish();
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .sample_size(10)
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(3));
    targets = volumes
}
criterion_main!(benches);
