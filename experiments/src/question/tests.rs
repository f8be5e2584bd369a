use super::{PLACEMENTS, Question};
use families::bodies::{BODY_FAMILIES, find};
use std::collections::BTreeSet;
use zonotope::numeric::dyadic::Dyadic;

/// A question's status against its own bounds, and its lower bound against the support function in many directions.
#[test]
fn questions_are_what_they_say() {
    let mut asked = BTreeSet::new();
    for family in BODY_FAMILIES {
        for (placement, n) in PLACEMENTS.iter().flat_map(|p| [(p, 6), (p, 40)]) {
            let Some(question) = Question::about(family.generate(n, 3), *placement, 5) else { continue };
            let [low, high] = question.excess;
            assert!(low <= high + 1e-15, "{} {} n={n}: {low} {high}", family.id, placement.id);
            assert_eq!(question.is_member(), low <= 0.0, "{} {}", family.id, placement.id);
            let [a, b] = question.bodies();
            assert_eq!(a.generators().len() + b.generators().len(), n);
            // No direction may prove more than the upper bound: u · (to − from) ≤ (1 + high) h(u).
            let displacement = question.displacement().exact();
            for u in question.generators.iter().take(8) {
                let along = (0..3).fold(Dyadic::zero(), |sum, i| sum + &Dyadic::from_f64(u[i]) * &displacement[i]);
                let body = zonotope::zonotope::Zonotope::new([0.0; 3], question.generators.clone()).expect("finite");
                let bound = body.support(*u).exact_value * (Dyadic::from_f64(1.0) + Dyadic::from_f64(high + 1e-15));
                assert!(along <= bound, "{} {}", family.id, placement.id);
            }
            asked.insert((family.id, placement.id));
        }
    }
    assert!(asked.len() * 10 > BODY_FAMILIES.len() * PLACEMENTS.len() * 9, "{} questions", asked.len());
}

#[test]
fn two_boxes_are_boxes() {
    let [a, b] = Question::about(find("box_sums").expect("listed").generate(6, 1), PLACEMENTS[0], 1)
        .expect("boxes have facets")
        .bodies();
    for body in [a, b] {
        let g = body.generators();
        let dot = |u: [f64; 3], v: [f64; 3]| u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
        assert!(dot(g[0], g[1]).abs() + dot(g[1], g[2]).abs() + dot(g[2], g[0]).abs() < 1e-14);
    }
}
