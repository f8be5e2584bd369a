//! Random fast motions of bodies with an inside: collisions that are missed, by the first contact and by methods that
//! prove nothing. Two segments that cross meet at one moment alone, which is grazing.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use rivals::first_contact::by_hull_of_end_poses::first_meeting_stretch;
use rivals::first_contact::by_sampling::first_sampled_contact;
use zonotope::motion::continuous::{FirstContact, first_contact};
use zonotope::motion::{Motion, MotionPiece};
use zonotope::zonotope::Zonotope;

use crate::families::{random_body, turns};

/// Samples that look for a collision that the answer does not know.
const SAMPLES: u32 = 256;

/// Samples and stretches of the rivals.
const STEPS: u32 = 8;

fn vector(random: &mut Pcg64, size: f64) -> [f64; 3] {
    [0, 1, 2].map(|_| size * random.random_range(-1.0..1.0))
}

fn axis(random: &mut Pcg64) -> [f64; 3] {
    loop {
        let v = vector(random, 1.0);
        let square: f64 = v.iter().map(|c| c * c).sum();
        if (0.01..1.0).contains(&square) {
            return v.map(|c| c / square.sqrt());
        }
    }
}

fn motion(random: &mut Pcg64) -> Motion {
    let (point, about, gone) = (vector(random, 1.0), axis(random), vector(random, 4.0));
    match random.random_range(0..3) {
        0 => turns(point, about, random.random_range(-720.0..720.0), gone),
        1 => Motion::constant_rate(point, about, random.random_range(-14.0..14.0), gone).expect("an axis"),
        _ => {
            let to = [0, 1, 2, 3].map(|_| random.random_range(-1.0..1.0f64));
            let to = if to[0] < 0.0 { to.map(|c| -c) } else { to };
            let from = [1.0, 0.0, 0.0, 0.0];
            Motion::from_pieces(&[MotionPiece { until: 1.0, from, to, axis_point: point, translation: gone }])
                .expect("not more than half a turn")
        }
    }
}

/// Prints how many collisions of so many motions are missed.
pub fn count(motions: u64) {
    let random = &mut Pcg64::seed_from_u64(0);
    let [mut separate, mut contacts, mut grazing] = [0u64; 3];
    let [mut wrong, mut sampled, mut cast] = [0u64; 3];
    for _ in 0..motions {
        let sizes = [0, 1].map(|_| random.random_range(3..8));
        let center = axis(random).map(|c| 1.8 * c);
        let bodies: [Zonotope<3>; 2] = [random_body(random, sizes[0], [0.0; 3]), random_body(random, sizes[1], center)];
        let moved = [motion(random), motion(random)];
        let (bodies, moved) = (bodies.each_ref(), moved.each_ref());
        let found = first_contact(bodies, moved);
        let end = match &found {
            FirstContact::Separate { .. } => 2.0,
            FirstContact::Contact { time, .. } | FirstContact::Grazing { time, .. } => time[0],
        };
        wrong += u64::from(first_sampled_contact(bodies, moved, SAMPLES).is_some_and(|time| time < end));
        match found.name() {
            "separate" => separate += 1,
            "contact" => {
                contacts += 1;
                sampled += u64::from(first_sampled_contact(bodies, moved, STEPS).is_none());
                cast += u64::from(first_meeting_stretch(bodies, moved, STEPS).is_none());
            }
            _ => grazing += 1,
        }
    }
    println!("{motions} motions: {separate} separate, {contacts} contacts, {grazing} grazing");
    println!("missed by the first contact, as {SAMPLES} samples see it: {wrong}");
    println!("missed of the contacts with {STEPS} steps: by sampling {sampled}, by hulls of end poses {cast}");
}
