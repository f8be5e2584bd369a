//! The time of each question about bodies through the public methods, with the proof that it comes with, on bodies
//! that were prepared beforehand. `pass` is the support function in doubles, to measure the others by.
//!
//! `cargo bench -p zonotope --bench front_door`; a filter such as `-- gauge` or `-- /1024/` selects questions or sizes.

use std::hint::black_box;
use std::time::Duration;

use criterion::{Bencher, BenchmarkId, Criterion, criterion_group, criterion_main};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use zonotope::zonotope::{PreparedBody, Zonotope};

/// The generators of both bodies together.
const SIZES: [usize; 4] = [6, 64, 1024, 16384];

/// The gauge of the displacement: far inside, near contact on both sides, far outside.
const PLACES: [(&str, f64); 6] = [
    ("inside", 0.5),
    ("within_1e-3", 1.0 - 1e-3),
    ("within_1e-9", 1.0 - 1e-9),
    ("beyond_1e-9", 1.0 + 1e-9),
    ("beyond_1e-3", 1.0 + 1e-3),
    ("outside", 2.0),
];

/// Two bodies, the body of all their generators, and the displacement of the centres.
struct Scene {
    bodies: [PreparedBody; 2],
    sum: PreparedBody,
    displacement: [f64; 3],
}

impl Scene {
    fn new(count: usize, gauge: f64) -> Self {
        let mut random = Pcg64Mcg::seed_from_u64(1);
        let generators: Vec<[f64; 3]> = (0..count).map(|_| [0, 1, 2].map(|_| random.random::<f64>() - 0.5)).collect();
        let body = |center: [f64; 3], own: &[[f64; 3]]| {
            PreparedBody::new(Zonotope::new(center, own.to_vec()).expect("random numbers are finite"))
        };
        let (sum, direction) = (body([0.0; 3], &generators), [0, 1, 2].map(|_| random.random::<f64>() - 0.5));
        let unit = sum.gauge(direction).expect("the direction is finite").value;
        let displacement = direction.map(|c| c * gauge / unit);
        let (own, others) = generators.split_at(count / 2);
        Self { bodies: [body([0.0; 3], own), body(displacement, others)], sum, displacement }
    }
}

/// A question as a caller asks it.
type Call = fn(&mut Bencher<'_>, &Scene);

/// Asks a question again and again.
macro_rules! call {
    (|$scene:ident| $question:expr) => {
        |bencher, scene| {
            bencher.iter(|| {
                let $scene = black_box(scene);
                $question
            })
        }
    };
}

const CALLS: [(&str, Call); 11] = [
    ("pass", call!(|scene| scene.sum.absolute_sum(&scene.displacement))),
    ("contains", call!(|scene| scene.sum.contains(scene.displacement))),
    ("locate", call!(|scene| scene.sum.locate(scene.displacement))),
    ("locate_written", call!(|scene| scene.sum.locate(scene.displacement).map(|located| located.expand()))),
    ("gauge", call!(|scene| scene.sum.gauge(scene.displacement))),
    ("intersects", call!(|scene| scene.bodies[0].intersects(&scene.bodies[1]))),
    ("intersection", call!(|scene| scene.bodies[0].intersection(&scene.bodies[1]))),
    ("intersection_written", call!(|scene| scene.bodies[0].intersection(&scene.bodies[1]).expand())),
    ("distance", call!(|scene| scene.bodies[0].placed().distance(scene.bodies[1].placed()))),
    ("proximity", call!(|scene| scene.bodies[0].placed().proximity(scene.bodies[1].placed()))),
    ("penetration", call!(|scene| scene.bodies[0].placed().penetration(scene.bodies[1].placed()))),
];

fn front_door(criterion: &mut Criterion) {
    for (place, gauge) in PLACES {
        for count in SIZES {
            let scene = Scene::new(count, gauge);
            for (name, call) in CALLS {
                let id = BenchmarkId::new(format!("{name}/{count}"), place);
                criterion.bench_with_input(id, &scene, call);
            }
        }
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .sample_size(10)
        .warm_up_time(Duration::from_millis(20))
        .measurement_time(Duration::from_millis(100));
    targets = front_door
}
criterion_main!(benches);
