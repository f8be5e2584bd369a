//! The face lattice of random generators against writing arrays of the same sizes, freshly allocated; counts without
//! the lattice.
//!
//! `cargo bench -p zonotope --bench faces`; a filter such as `-- 1000` selects sizes.

use std::hint::black_box;
use std::time::Duration;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use zonotope::zonotope::faces::{FaceLattice, Faces, faces};
use zonotope::zonotope::{Zonotope, combinatorics};

fn random_body(count: usize) -> Zonotope<3> {
    let mut random = Pcg64Mcg::seed_from_u64(1);
    let generators = (0..count).map(|_| [0, 1, 2].map(|_| random.random::<f64>() - 0.5)).collect();
    Zonotope::new([0.0; 3], generators).expect("random numbers are finite")
}

fn lattice(body: &Zonotope<3>) -> FaceLattice {
    match faces(body, &mut ()) {
        Ok(Faces::Solid(lattice)) => lattice,
        _ => unreachable!("random generators span space"),
    }
}

/// Arrays like those of the lattice, filled with numbers that cost nothing to compute.
fn write_arrays(vertices: usize, edges: usize, facets: usize) {
    let indices = |count: usize| (0..count as u32).collect::<Vec<u32>>();
    black_box((0..vertices).map(|i| [i as f64; 3]).collect::<Vec<_>>());
    black_box((0..edges as u32).map(|i| [i, i]).collect::<Vec<_>>());
    black_box([indices(edges), indices(edges), indices(facets + 1), indices(4 * facets), indices(4 * facets)]);
}

fn face_lattices(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("faces");
    for n in [10, 100, 1000] {
        let body = random_body(n);
        let found = lattice(&body);
        let [v, e, f] = [found.vertex_count(), found.edge_count(), found.facet_count()];
        drop(found);
        group.throughput(Throughput::Elements(f as u64));
        group.bench_with_input(BenchmarkId::new("by_sweep", n), &body, |bencher, body| {
            bencher.iter(|| lattice(black_box(body)));
        });
        group.bench_function(BenchmarkId::new("writing_arrays", n), |bencher| {
            bencher.iter(|| write_arrays(black_box(v), e, f));
        });
        group.bench_with_input(BenchmarkId::new("counts_and_volume", n), &body, |bencher, body| {
            bencher.iter(|| combinatorics(black_box(body)));
        });
    }
    group.finish();
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .sample_size(10)
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(1));
    targets = face_lattices
}
criterion_main!(benches);
