//! The method against the definition, on every family.

mod levels;
mod nearest;
pub(in crate::collision) mod posed;
mod prepared;
mod rungs;

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::*;
use crate::collision::{Separation, Witness};
use crate::interop::verifier::check_location;
use crate::numeric::Rational;

type Vector = [Rational; 3];

fn rational<const D: usize>(v: &[f64; D]) -> Vector {
    std::array::from_fn(|i| v.get(i).map_or(Rational::ZERO, |&c| Rational::try_from(c).expect("finite")))
}

fn dot(a: &Vector, b: &Vector) -> Rational {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

fn cross(a: &Vector, b: &Vector) -> Vector {
    [&a[1] * &b[2] - &a[2] * &b[1], &a[2] * &b[0] - &a[0] * &b[2], &a[0] * &b[1] - &a[1] * &b[0]]
}

fn abs(v: Rational) -> Rational {
    if v < Rational::ZERO { -v } else { v }
}

fn exact_displacement<const D: usize>(query: &Query<'_, D>) -> Vector {
    let (from, to) = (rational(&query.from()), rational(&query.to()));
    [0, 1, 2].map(|i| &to[i] - &from[i])
}

/// The gauge (none where it is infinite) and the status, from the facets of Z ⊕ ε cube as ε → 0.
fn truth<const D: usize>(query: &Query<'_, D>) -> (Option<Rational>, &'static str) {
    let p = exact_displacement(query);
    let own: Vec<Vector> = query.generators().map(rational).collect();
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|axis: [f64; 3]| rational(&axis));
    let all: Vec<Vector> = own.iter().chain(&axes).cloned().collect();
    let mut gauge = Some(Rational::ZERO);
    let mut flat = false;
    for (i, a) in all.iter().enumerate() {
        for b in &all[..i] {
            let u = cross(a, b);
            if u.iter().all(|c| *c == Rational::ZERO) || u[D..].iter().any(|c| *c != Rational::ZERO) {
                continue;
            }
            let height = abs(dot(&u, &p));
            let reach = own.iter().fold(Rational::ZERO, |sum, v| sum + abs(dot(v, &u)));
            if reach == Rational::ZERO {
                flat = true;
                if height != Rational::ZERO {
                    gauge = None;
                }
            } else {
                gauge = gauge.map(|g| g.max(height / reach));
            }
        }
    }
    let status = match &gauge {
        Some(g) if *g < Rational::ONE && !flat => "inside",
        Some(g) if *g <= Rational::ONE => "boundary",
        _ => "outside",
    };
    (gauge, status)
}

fn check_proof<const D: usize>(query: &Query<'_, D>, location: &Location<D>) {
    let p = exact_displacement(query);
    let generators: Vec<Vector> = query.generators().map(rational).collect();
    match location {
        Location::Outside(separation) => {
            let u = match separation {
                Separation::Rounded(u) => rational(u),
                Separation::Exact(u) => std::array::from_fn(|i| u.get(i).cloned().unwrap_or(Rational::ZERO)),
            };
            let reach = generators.iter().fold(Rational::ZERO, |sum, v| sum + abs(dot(v, &u)));
            assert!(dot(&u, &p) > reach, "{query:?} {u:?} does not separate");
        }
        Location::Inside(witness) | Location::Boundary(witness) => {
            let Witness { coefficients, basis } = witness;
            assert_eq!(coefficients.len(), generators.len());
            assert!(basis.len() <= D && basis.is_sorted(), "{basis:?}");
            assert!(coefficients.iter().all(|c| c.abs() <= 1.0), "{coefficients:?}");
            let mut rest = p;
            for (i, v) in generators.iter().enumerate().filter(|(i, _)| !basis.contains(i)) {
                let c = Rational::try_from(coefficients[i]).expect("finite");
                rest = std::array::from_fn(|k| &rest[k] - &c * &v[k]);
            }
            let members: Vec<&Vector> = basis.iter().map(|&b| &generators[b]).collect();
            assert!(solves(&members, &rest), "{query:?} {witness:?}");
        }
    }
}

/// Whether independent vectors combine to `rest` with coefficients in [−1, 1].
fn solves(members: &[&Vector], rest: &Vector) -> bool {
    let one = |n: Rational, d: &Rational| abs(n) <= abs(d.clone());
    let is_zero = |v: &Vector| v.iter().all(|c| *c == Rational::ZERO);
    match members {
        [] => is_zero(rest),
        [a] => !is_zero(a) && is_zero(&cross(a, rest)) && one(dot(a, rest), &dot(a, a)),
        [a, b] => {
            let normal = cross(a, b);
            let square = dot(&normal, &normal);
            !is_zero(&normal)
                && dot(&normal, rest) == Rational::ZERO
                && one(dot(&cross(rest, b), &normal), &square)
                && one(dot(&cross(a, rest), &normal), &square)
        }
        [a, b, c] => {
            let determinant = dot(a, &cross(b, c));
            determinant != Rational::ZERO
                && one(dot(rest, &cross(b, c)), &determinant)
                && one(dot(a, &cross(rest, c)), &determinant)
                && one(dot(a, &cross(b, rest)), &determinant)
        }
        _ => false,
    }
}

/// Compares all answers with the definition.
fn check<const D: usize>(query: &Query<'_, D>) {
    let (truth, status) = truth(query);
    let located = locate(query, &mut ());
    assert_eq!(located.status().name(), status, "{query:?}");
    check_proof(query, &located);
    let Gauge { value, error, location } = gauge(query, &mut ());
    assert_eq!(location.status().name(), status, "{query:?}");
    check_proof(query, &location);
    match truth {
        None => assert_eq!((value, error), (f64::INFINITY, 0.0), "{query:?}"),
        Some(truth) if error.is_finite() => {
            let off = abs(Rational::try_from(value).expect("finite") - &truth);
            assert!(off <= Rational::try_from(error).expect("finite"), "{query:?}: {value} ± {error}, not {truth}");
            assert!(error <= 1e-9 * value + 1e-300, "{query:?}: {value} ± {error}");
        }
        Some(truth) => assert!(value == f64::MAX && truth > Rational::try_from(1e300).expect("finite")),
    }
}

/// A generator of a family, by its name.
fn family<const D: usize>(name: &str, n: usize, random: &mut Pcg64Mcg) -> Vec<[f64; D]> {
    let few: Vec<[f64; D]> = (0..3).map(|_| std::array::from_fn(|_| random.random_range(-1.0..1.0))).collect();
    (0..n)
        .map(|i| match name {
            "random" => std::array::from_fn(|_| random.random_range(-1.0..1.0)),
            "lattice" => std::array::from_fn(|_| f64::from(random.random_range(-2..=2))),
            "parallel" => few[i % 2].map(|c| c * f64::from(random.random_range(-3..=3))),
            "directions" => few[i % 3],
            "coplanar" => {
                let [a, b] = [0, 1].map(|_| f64::from(random.random_range(-3..=3)));
                let v: [f64; D] = std::array::from_fn(|k| if k == 0 { a } else { b * k as f64 });
                if i % 5 == 4 { std::array::from_fn(|_| random.random_range(-1.0..1.0)) } else { v }
            }
            "scales" => {
                let exponent = random.random_range(-300..=300);
                std::array::from_fn(|_| random.random_range(-1.0..1.0) * libm::exp10(f64::from(exponent)))
            }
            "coordinate scales" => std::array::from_fn(|_| {
                random.random_range(-1.0..1.0) * libm::exp10(f64::from(random.random_range(-160..=160)))
            }),
            "denormal" => std::array::from_fn(|_| f64::from(random.random_range(-3..=3)) * f64::from_bits(1)),
            "huge" => std::array::from_fn(|_| f64::from(random.random_range(-1..=1)) * f64::MAX),
            "ulp" => std::array::from_fn(|k| {
                let base = [1.0f64, 2.0, -1.0][(i + k) % 3];
                f64::from_bits(base.to_bits().wrapping_add(random.random_range(0..2)))
            }),
            "last digits" => {
                let base = [[1.0, 2.0, 3.0], [3.0, -1.0, 2.0], [0.5, 0.25, -1.0]][random.random_range(0..3)];
                std::array::from_fn(|k| base[k] * (1.0 + 1e-15 * f64::from(random.random_range(-3..=3))))
            }
            "thin" => {
                let v: [f64; D] = std::array::from_fn(|_| random.random_range(-1.0..1.0));
                std::array::from_fn(|k| if k + 1 == D { 1e-12 * v[k] } else { v[k] })
            }
            "classes" => few[i % 3].map(|c| c + 1e-9 * random.random_range(-1.0..1.0)),
            _ => unreachable!("no family {name}"),
        })
        .collect()
}

const FAMILIES: [&str; 13] = [
    "random",
    "lattice",
    "parallel",
    "directions",
    "coplanar",
    "scales",
    "coordinate scales",
    "denormal",
    "huge",
    "ulp",
    "last digits",
    "thin",
    "classes",
];

/// Points of every kind relative to a body: vertices, points of facets and edges, points near them, centre, off centre.
fn displacement<const D: usize>(generators: &[[f64; D]], random: &mut Pcg64Mcg) -> ([f64; D], [f64; D]) {
    let mut to = [0.0; D];
    let kind = random.random_range(0..8);
    let scale = [1.0, 1.0, 1.0, 0.5, 1.0 + 1e-9, 1.0 - f64::EPSILON, 2.0, random.random_range(0.0..1.5)][kind];
    let bits = if random.random_bool(0.5) { 2 } else { 3 };
    for v in generators {
        let sign = [1.0, -1.0, 0.5][random.random_range(0..bits)];
        for (sum, c) in to.iter_mut().zip(v) {
            *sum += sign * c;
        }
    }
    let mut to = to.map(|c| c * scale);
    if random.random_range(0..6) == 0 {
        to = std::array::from_fn(|_| random.random_range(-1.0..1.0));
    }
    let from = match random.random_range(0..4) {
        0 => to.map(|c| c / 3.0),
        1 => [1e16; D],
        _ => [0.0; D],
    };
    if from[0] == 1e16 {
        to = to.map(|c| c + 1e16);
    }
    let bounded = |v: [f64; D]| v.map(|c: f64| c.clamp(-f64::MAX, f64::MAX));
    (bounded(from), bounded(to))
}

fn cross_all<const D: usize>(seed: u64, rounds: usize) {
    let mut random = Pcg64Mcg::seed_from_u64(seed);
    for name in FAMILIES {
        for _ in 0..rounds {
            let n = random.random_range(0..9);
            let generators = family::<D>(name, n, &mut random);
            let (from, to) = displacement(&generators, &mut random);
            check(&Query::new(from, to, &generators).expect("finite"));
        }
    }
}

#[test]
fn agrees_with_the_definition_in_space() {
    cross_all::<3>(1, 60);
}

#[test]
fn agrees_with_the_definition_in_the_plane() {
    cross_all::<2>(2, 30);
}

/// Answers on many generators, which the definition would take too long for: every proof is checked, and that the
/// body times the gauge, a little smaller or larger, does not hold the point or holds it.
fn prove_all<const D: usize>(seed: u64, sizes: &[usize], rounds: usize) {
    let mut random = Pcg64Mcg::seed_from_u64(seed);
    for name in FAMILIES {
        for &n in sizes {
            let generators = family::<D>(name, n, &mut random);
            for _ in 0..rounds {
                let (from, to) = displacement(&generators, &mut random);
                prove(name, &Query::new(from, to, &generators).expect("finite"));
            }
        }
    }
}

fn prove<const D: usize>(name: &str, query: &Query<'_, D>) {
    let located = locate(query, &mut ());
    assert_eq!(check_location(query, &located).proof().map(drop), Ok(()), "{name} {}", query.len());
    let Gauge { value, error, location } = gauge(query, &mut ());
    assert_eq!(check_location(query, &location).proof().map(drop), Ok(()), "{name} {}", query.len());
    assert_eq!(location.status(), located.status(), "{name} {}", query.len());
    if error.is_finite() && value.is_finite() {
        assert!(error <= 1e-9 * value + 1e-300, "{name} {}: {value} ± {error}", query.len());
    }
    // where rounding a point moves it by little in terms of the body
    if ["random", "lattice", "classes"].contains(&name) && value > 0.0 && query.from() == [0.0; D] {
        let generators: Vec<[f64; D]> = query.generators().copied().collect();
        for (factor, is_member) in [(1.0 - 1e-9, true), (1.0 + 1e-9, false)] {
            let scaled = query.to().map(|c| c / value * factor);
            let moved = Query::new([0.0; D], scaled, &generators).expect("finite");
            let located = locate(&moved, &mut ());
            assert_eq!(located.is_member(), is_member, "{name} {}: {value} ± {error}", query.len());
            assert_eq!(check_location(&moved, &located).proof().map(drop), Ok(()), "{name} {}", query.len());
        }
    }
}

/// All generators on one side of a plane, and a point that is their sum but for rounding: more lines nearly meet
/// there than doubles tell apart.
#[test]
fn lines_that_meet_but_for_the_last_digits_are_told_apart() {
    let mut random = Pcg64Mcg::seed_from_u64(6);
    for name in ["last digits", "ulp", "classes", "scales"] {
        let generators = family::<3>(name, 30, &mut random);
        let mut sum = [0.0; 3];
        for v in &generators {
            sum = [0, 1, 2].map(|k| sum[k] + f64::copysign(1.0, v[0]) * v[k]);
        }
        for factor in [1.0, 0.3] {
            check(&Query::new([0.0; 3], sum.map(|c| factor * c), &generators).expect("finite"));
        }
    }
    for name in ["last digits", "thin", "scales", "coordinate scales"] {
        for n in [1000, 3000] {
            let generators = family::<3>(name, n, &mut random);
            let mut sum = [0.0; 3];
            for v in &generators {
                sum = [0, 1, 2].map(|k| sum[k] + f64::copysign(1.0, v[0]) * v[k]);
            }
            let direction = Query::new([0.0; 3], [1.0, 0.3, 0.1], &generators).expect("finite");
            let edge = [1.0, 0.3, 0.1].map(|c| c / gauge(&direction, &mut ()).value);
            for p in [sum, sum.map(|c| 0.3 * c), edge] {
                prove(name, &Query::new([0.0; 3], p, &generators).expect("finite"));
            }
        }
    }
}

#[test]
fn many_generators_are_answered_with_proofs() {
    prove_all::<3>(4, &[12, 17, 40, 129, 300, 1000], 3);
    prove_all::<2>(5, &[12, 40, 200], 2);
}

#[test]
fn the_centre_is_inside_or_on_the_boundary_of_a_flat_body() {
    let generators = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]];
    check(&Query::new([1e16; 3], [1e16; 3], &generators).expect("finite"));
    check(&Query::<3>::new([0.0; 3], [0.0; 3], &[]).expect("finite"));
    check(&Query::<3>::new([0.0; 3], [1.0, 0.0, 0.0], &[]).expect("finite"));
}
