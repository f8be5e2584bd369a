//! Intersection in R^4.

use std::cmp::Ordering;

use rand::RngExt;
use rand_pcg::Pcg64Mcg;
use zonotope::collision::{Query, by_lad_in_r4};

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "question-4d-intersection",
    place: Place { section: "7", label: "fourth question" },
    kind: ClaimKind::OpenQuestion,
    statement: "How are 4-D space-time zonotopes intersected efficiently?",
    remedy: Some(
        "as in space, by the direction in which the zonotope reaches least far: the kernel in three variables, by \
            exact descent along edges",
    ),
    code: &["zonotope::collision::by_lad_in_r4"],
    figures: &["control-zonotopes"],
    check: Check::Run(check),
    tried: Tried::On(&["random bodies", "degenerate bodies"]),
};

/// Integer generators and targets: the library's decision against the normals of all triples.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 49);
    let mut counts = [0; 3];
    for index in 0..150 {
        let reach = [1, 3, 50][index % 3];
        let mut vector = || -> [i64; 4] { std::array::from_fn(|_| random.random_range(-reach..=reach)) };
        let mut generators: Vec<[i64; 4]> = (0..index % 8).map(|_| vector()).collect();
        if index % 5 == 0 && generators.len() > 1 {
            generators[0] = generators[1].map(|c| -2 * c);
        }
        let target = target(&mut random, &generators, index);
        let truth = position(&generators, target);
        let rows: Vec<[f64; 4]> = generators.iter().map(|g| g.map(|c| c as f64)).collect();
        let question = Query::new([0.0; 4], target.map(|c| c as f64), &rows).expect("integers are finite");
        let status = by_lad_in_r4::locate(&question, &mut ()).status().name();
        if status != ["inside", "boundary", "outside"][truth] {
            return Verdict::Inconclusive(format!("{generators:?} and {target:?}: {status}, case {truth}"));
        }
        counts[truth] += 1;
    }
    let [inside, boundary, outside] = counts;
    Verdict::InPart(format!(
        "the kernel in three variables decides {inside} points inside, {boundary} on the boundary and {outside} \
         outside of zonotopes of R^4 as the normals of all triples of generators do, flat, parallel and empty \
         generators among them"
    ))
}

/// A vertex, a point near one, or a random point.
fn target(random: &mut Pcg64Mcg, generators: &[[i64; 4]], index: usize) -> [i64; 4] {
    let mut point = [0; 4];
    for generator in generators {
        let sign = if index % 4 == 3 { random.random_range(-1..=1) } else { 2 * random.random_range(0..=1) - 1 };
        point = std::array::from_fn(|i| point[i] + sign * generator[i]);
    }
    if index % 4 == 1 {
        point[index % 3] += 1;
    }
    point
}

/// The position of the target, 0 inside, 1 on the boundary or 2 outside, by the normals of all triples of generators
/// and axes; the axes decide for flat bodies.
fn position(generators: &[[i64; 4]], target: [i64; 4]) -> usize {
    let mut spanning = generators.to_vec();
    spanning.extend((0..4).map(|axis| std::array::from_fn(|i| i64::from(i == axis))));
    let mut position = 0;
    for i in 0..spanning.len() {
        for j in 0..i {
            for k in 0..j {
                let normal = normal([spanning[i], spanning[j], spanning[k]]);
                if normal == [0; 4] {
                    continue;
                }
                let along = |v: &[i64; 4]| v.iter().zip(normal).map(|(&c, n)| i128::from(c) * n).sum::<i128>();
                let reach: i128 = generators.iter().map(|g| along(g).abs()).sum();
                position = position.max(match along(&target).abs().cmp(&reach) {
                    Ordering::Less => 0,
                    Ordering::Equal => 1,
                    Ordering::Greater => 2,
                });
            }
        }
    }
    position
}

/// The vector orthogonal to three vectors, by minors.
fn normal(rows: [[i64; 4]; 3]) -> [i128; 4] {
    std::array::from_fn(|skipped| {
        let columns: Vec<usize> = (0..4).filter(|&column| column != skipped).collect();
        let [a, b, c] = rows.map(|row| [0, 1, 2].map(|i| i128::from(row[columns[i]])));
        let minor = a[0] * (b[1] * c[2] - b[2] * c[1])
            + a[1] * (b[2] * c[0] - b[0] * c[2])
            + a[2] * (b[0] * c[1] - b[1] * c[0]);
        if skipped % 2 == 0 { minor } else { -minor }
    })
}
