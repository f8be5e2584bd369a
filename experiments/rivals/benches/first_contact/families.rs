//! Nine families of motions whose bodies come as near as a given clearance and no nearer.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use zonotope::motion::{Motion, MotionPiece};
use zonotope::zonotope::Zonotope;

/// Two bodies and their motions.
pub struct Scene {
    pub bodies: [Zonotope<3>; 2],
    pub motions: [Motion; 2],
}

/// The names of the families.
pub const FAMILIES: [&str; 9] = [
    "links",
    "two_turning_links",
    "both_spinning",
    "swing_180",
    "swing_360",
    "thin_bars",
    "orbit",
    "ring",
    "spinning_prism",
];

fn number(random: &mut Pcg64, range: std::ops::Range<f64>) -> f64 {
    random.random_range(range)
}

fn unit(random: &mut Pcg64) -> [f64; 3] {
    loop {
        let v = [0, 1, 2].map(|_| number(random, -1.0..1.0));
        let square: f64 = v.iter().map(|c| c * c).sum();
        if (0.01..1.0).contains(&square) {
            return v.map(|c| c / square.sqrt());
        }
    }
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// A box with random axes.
fn turned_box(random: &mut Pcg64, center: [f64; 3], halves: [f64; 3]) -> Zonotope<3> {
    let x = unit(random);
    let other = cross(x, unit(random));
    let length = other.iter().map(|c| c * c).sum::<f64>().sqrt();
    let y = other.map(|c| c / length);
    let z = cross(x, y);
    let list = [(x, halves[0]), (y, halves[1]), (z, halves[2])].map(|(v, h)| v.map(|c| h * c)).to_vec();
    Zonotope::new(center, list).expect("finite")
}

fn straight_box(center: [f64; 3], [a, b, c]: [f64; 3]) -> Zonotope<3> {
    Zonotope::new(center, vec![[a, 0.0, 0.0], [0.0, b, 0.0], [0.0, 0.0, c]]).expect("finite")
}

/// A body of random generators, about 1 across.
pub fn random_body(random: &mut Pcg64, n: usize, center: [f64; 3]) -> Zonotope<3> {
    let list = (0..n).map(|_| unit(random).map(|c| c * 0.8 / n as f64)).collect();
    Zonotope::new(center, list).expect("finite")
}

/// A prism over a regular polygon of 2 (n − 1) corners with the z axis.
fn prism(n: usize, radius: f64) -> Zonotope<3> {
    let sides = n - 1;
    let side = |i: usize| {
        let angle = std::f64::consts::PI * i as f64 / sides as f64;
        // Σ |sin| over the directions is near 2 n / π
        let length = radius * std::f64::consts::FRAC_PI_2 / sides as f64;
        [length * libm::cos(angle), length * libm::sin(angle), 0.0]
    };
    let list = (0..sides).map(side).chain([[0.0, 0.0, 0.4]]).collect();
    Zonotope::new([0.0; 3], list).expect("finite")
}

/// A rational motion of equal parts about an axis through a point, together by an angle in degrees.
pub fn turns(point: [f64; 3], axis: [f64; 3], degrees: f64, translation: [f64; 3]) -> Motion {
    let parts = (degrees.abs() / 90.0).ceil().max(1.0);
    let half = (degrees / parts).to_radians() / 2.0;
    let to = [libm::cos(half), libm::sin(half) * axis[0], libm::sin(half) * axis[1], libm::sin(half) * axis[2]];
    let piece = |k: usize| {
        // the axis goes along with the translation
        let share = k as f64 / parts;
        MotionPiece {
            until: (k + 1) as f64 / parts,
            from: [1.0, 0.0, 0.0, 0.0],
            to,
            axis_point: [0, 1, 2].map(|i| point[i] + share * translation[i]),
            translation: translation.map(|c| c / parts),
        }
    };
    Motion::from_pieces(&(0..parts as usize).map(piece).collect::<Vec<_>>()).expect("quarter turns are a motion")
}

/// The least distance during the motions, by samples that are made denser near the least one.
fn least_distance(scene: &Scene, shift: [f64; 3]) -> f64 {
    let moved = scene.bodies[1].translated(shift).expect("finite");
    let at = |t: f64| {
        let [p, q] = scene.motions.each_ref().map(|motion| motion.pose_at(t).expect("finite"));
        scene.bodies[0].at(&p).distance(moved.at(&q))
    };
    let count = 160;
    let samples: Vec<f64> = (0..=count).map(|i| at(f64::from(i) / f64::from(count))).collect();
    let least = samples.iter().copied().fold(f64::INFINITY, f64::min);
    if least == 0.0 {
        return 0.0;
    }
    let mut best = least;
    let mut places: Vec<usize> = (0..samples.len()).collect();
    places.sort_by(|&i, &j| samples[i].total_cmp(&samples[j]));
    for &place in places.iter().take(6) {
        let (mut center, mut width) = (place as f64 / f64::from(count), 1.0 / f64::from(count));
        for _ in 0..14 {
            for t in [center - width / 2.0, center + width / 2.0] {
                let value = if (0.0..=1.0).contains(&t) { at(t) } else { f64::INFINITY };
                if value < best {
                    (best, center) = (value, t);
                }
            }
            width /= 2.0;
        }
    }
    best
}

/// Shifts the second body along a direction until the least distance is the clearance.
fn with_clearance(mut scene: Scene, along: [f64; 3], clearance: f64) -> Scene {
    let (mut low, mut high) = (0.0, 8.0);
    for _ in 0..34 {
        let middle = (low + high) / 2.0;
        if least_distance(&scene, along.map(|c| middle * c)) < clearance { low = middle } else { high = middle }
    }
    scene.bodies[1] = scene.bodies[1].translated(along.map(|c| high * c)).expect("finite");
    scene
}

/// A scene of a family.
pub fn scene(family: &str, seed: u64, clearance: f64) -> Scene {
    let random = &mut Pcg64::seed_from_u64(seed);
    let z = [0.0, 0.0, 1.0];
    let link = straight_box([0.6, 0.0, 0.0], [0.6, 0.08, 0.08]);
    let small = [0, 1, 2].map(|_| number(random, 0.1..0.4));
    let outward = |random: &mut Pcg64, degrees: f64| {
        let angle = number(random, 0.0..degrees.to_radians());
        [libm::cos(angle), libm::sin(angle), number(random, -0.3..0.3)]
    };
    let (bodies, motions, along) = match family {
        "links" => {
            let other = turned_box(random, [0.0; 3], small);
            let along = outward(random, 80.0);
            ([link, other], [turns([0.0; 3], z, 80.0, [0.0; 3]), Motion::rest()], along)
        }
        "two_turning_links" => {
            let degrees = [0, 1].map(|_| number(random, 30.0..80.0));
            let other = straight_box([-0.6, 0.0, 0.0], [0.6, 0.08, 0.08]);
            let axis = unit(random);
            let axis = if axis[2] < 0.0 { axis.map(|c| -c) } else { axis };
            // the axis of the second link is at its own end, and shifted with it
            let along = outward(random, degrees[0]);
            let far = along.map(|c| 1.3 * c);
            let other = other.translated(far).expect("finite");
            let motions = [turns([0.0; 3], z, degrees[0], [0.0; 3]), turns(far, axis, degrees[1], [0.0; 3])];
            ([link, other], motions, along)
        }
        "both_spinning" => {
            let sizes = [0, 1].map(|_| [0, 1, 2].map(|_| number(random, 0.2..0.6)));
            let bodies = sizes.map(|size| turned_box(random, [0.0; 3], size));
            let motions = [0, 1].map(|_| {
                let degrees = number(random, 40.0..90.0);
                let gone = unit(random).map(|c| 0.5 * c);
                turns([0.0; 3], unit(random), degrees, gone)
            });
            (bodies, motions, unit(random))
        }
        "swing_180" | "swing_360" => {
            let degrees = if family == "swing_180" { 180.0 } else { 360.0 };
            let arm = turned_box(random, [1.0, 0.0, 0.0], small);
            let other = turned_box(random, [0.0; 3], [0.3, 0.2, 0.25]);
            let along = outward(random, degrees);
            ([arm, other], [turns([0.0; 3], z, degrees, [0.0; 3]), Motion::rest()], along)
        }
        "thin_bars" => {
            let bodies = [0, 1].map(|_| turned_box(random, [0.0; 3], [1.0, 0.01, 0.01]));
            let motions = [0, 1].map(|_| {
                let degrees = number(random, 20.0..60.0);
                let gone = unit(random).map(|c| 0.3 * c);
                turns([0.0; 3], unit(random), degrees, gone)
            });
            (bodies, motions, unit(random))
        }
        "orbit" => {
            let angle = number(random, 0.0..0.3);
            // the box goes round the prism, which stands in the middle: the second body is the one that is shifted
            let core = prism(10, 0.7);
            let orbiting = turned_box(random, [0.0; 3], small);
            let along = [libm::cos(angle), libm::sin(angle), 0.0];
            ([core, orbiting], [Motion::rest(), turns([0.0; 3], z, 360.0, [0.0; 3])], along)
        }
        "ring" => {
            let core = random_body(random, 10, [0.0; 3]);
            let angle = number(random, 0.0..0.3);
            let bar = straight_box([0.0; 3], [0.06, 0.8, 0.06]);
            let along = [libm::cos(angle), libm::sin(angle), number(random, -0.1..0.1)];
            ([core, bar], [Motion::rest(), turns([0.0; 3], z, 360.0, [0.0; 3])], along)
        }
        "spinning_prism" => {
            let other = straight_box([0.0; 3], small);
            let angle = number(random, 0.0..0.2);
            let along = [libm::cos(angle), libm::sin(angle), 0.0];
            ([prism(10, 0.7), other], [turns([0.0; 3], z, 360.0, [0.0; 3]), Motion::rest()], along)
        }
        _ => unreachable!("{family} is no family"),
    };
    with_clearance(Scene { bodies, motions }, along, clearance)
}

/// Two random bodies of n generators together, one that turns and passes the other at the clearance.
pub fn passing(n: usize, seed: u64, clearance: f64) -> Scene {
    let random = &mut Pcg64::seed_from_u64(seed);
    let bodies = [0, 1].map(|_| random_body(random, n / 2, [0.0; 3]));
    let degrees = number(random, 30.0..80.0);
    let motions = [turns([0.0; 3], unit(random), degrees, unit(random).map(|c| 0.5 * c)), Motion::rest()];
    with_clearance(Scene { bodies, motions }, unit(random), clearance)
}

/// Two random bodies of n generators together that meet during the step.
pub fn meeting(n: usize, seed: u64) -> Scene {
    let random = &mut Pcg64::seed_from_u64(seed);
    let away = unit(random);
    let bodies = [[0.0; 3], away.map(|c| 2.5 * c)].map(|center| random_body(random, n / 2, center));
    let degrees = [0, 1].map(|_| number(random, 30.0..90.0));
    let [from, to] = [0, 1].map(|_| unit(random));
    let gone = [0, 1, 2].map(|k| 3.0 * away[k] + 0.2 * to[k]);
    let motions = [turns([0.0; 3], from, degrees[0], gone), turns(away.map(|c| 2.5 * c), to, degrees[1], [0.0; 3])];
    Scene { bodies, motions }
}
