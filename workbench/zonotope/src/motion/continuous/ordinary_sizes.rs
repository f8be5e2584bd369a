//! Bodies and motions of very large or very small numbers, times a power of two: guesses in doubles then neither
//! overflow nor vanish, and the proofs are the same.

use super::FirstContact;
use super::scene::Scene;
use crate::motion::Motion;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::scaling::{power_of_two, scaled_exactly};
use crate::zonotope::Zonotope;

/// Binary exponents of the largest coordinate between which nothing is scaled: products of a handful of them stay in
/// the range of doubles.
const ORDINARY_EXPONENTS: std::ops::Range<i64> = -60..60;

/// The largest change of an exponent, for which a power of two is a normal double.
const LARGEST_CHANGE: i64 = 1000;

/// An answer about bodies and motions, by an answer about a scene of ordinary sizes.
pub(super) fn first_contact(
    bodies: [&Zonotope<3>; 2],
    motions: [&Motion; 2],
    answer: impl FnOnce(Scene<'_>) -> FirstContact,
) -> FirstContact {
    let Some((scaled, moved, exponent)) = scaled(bodies, motions) else {
        return answered(Scene::new(bodies, motions), answer);
    };
    let mut found = answered(Scene::new(scaled.each_ref(), moved.each_ref()), answer);
    if let FirstContact::Grazing { distance_at_most, .. } = &mut found {
        // one that underflows is rounded up as well
        *distance_at_most = (*distance_at_most * power_of_two(-exponent as i32)).next_up();
    }
    found
}

/// An answer about a scene; the coefficients of a contact's basis are those of the exact placements, rounded.
fn answered(scene: Scene<'_>, answer: impl FnOnce(Scene<'_>) -> FirstContact) -> FirstContact {
    match answer(scene) {
        FirstContact::Contact { free, time, witness } => {
            FirstContact::Contact { free, time, witness: scene.with_nearest_basis(time[1], witness) }
        }
        found => found,
    }
}

/// The exponent of the power of two by which numbers become ordinary, by the binary exponent of the largest; `None`
/// where they are.
pub(super) fn change(largest: i64) -> Option<i64> {
    (!ORDINARY_EXPONENTS.contains(&largest)).then(|| (-largest).clamp(-LARGEST_CHANGE, LARGEST_CHANGE))
}

/// Both times a power of two, exactly, and its exponent; `None` where sizes are ordinary, or where the range of doubles
/// is too narrow for the least of the numbers.
fn scaled(bodies: [&Zonotope<3>; 2], motions: [&Motion; 2]) -> Option<([Zonotope<3>; 2], [Motion; 2], i64)> {
    let of_bodies = bodies.iter().flat_map(|body| {
        let largest = body.generators().iter().flatten().fold(0.0f64, |m, c| m.max(c.abs()));
        let largest = body.center().iter().fold(largest, |m, c| m.max(c.abs()));
        Dyadic::from_f64(largest).binary_exponent()
    });
    let of_motions = motions.iter().flat_map(|motion| motion.size_exponent());
    let exponent = change(of_bodies.chain(of_motions).max()?)?;
    let body = |body: &Zonotope<3>| {
        let generators = body.generators().iter().map(|g| scaled_exactly(g, exponent)).collect::<Option<Vec<_>>>()?;
        Zonotope::new(scaled_exactly(&body.center(), exponent)?, generators).ok()
    };
    let [a, b] = bodies;
    let [p, q] = motions;
    Some(([body(a)?, body(b)?], [p.scaled(exponent)?, q.scaled(exponent)?], exponent))
}
