use super::question::{PLACEMENTS, Question};
use super::{BODY_FAMILIES, BodyFamily, PLANE_FAMILIES, SPACE_TIME_FAMILIES};
use std::collections::BTreeSet;
use zonotope::numeric::dyadic::Dyadic;

fn obeys<const D: usize>(family: &BodyFamily<D>) {
    for n in [0, 1, 2, 3, 6, 10, 257] {
        let generators = family.generate(n, 7);
        assert_eq!(generators.len(), n, "{}", family.id);
        assert!(generators.iter().flatten().all(|x| x.is_finite()), "{}", family.id);
        assert_eq!(generators, family.generate(n, 7), "{}", family.id);
        if n >= 10 {
            assert_eq!(generators != family.generate(n, 8), family.is_random, "{}", family.id);
        }
    }
}

#[test]
fn body_families_have_the_asked_size_and_depend_on_nothing_but_the_seed() {
    BODY_FAMILIES.iter().for_each(obeys);
    PLANE_FAMILIES.iter().for_each(obeys);
    SPACE_TIME_FAMILIES.iter().for_each(obeys);
}

#[test]
fn ids_are_distinct() {
    let ids = BODY_FAMILIES.iter().map(|f| f.id).chain(PLANE_FAMILIES.iter().map(|f| f.id));
    let ids: Vec<_> = ids.chain(SPACE_TIME_FAMILIES.iter().map(|f| f.id)).collect();
    assert_eq!(ids.iter().collect::<BTreeSet<_>>().len(), ids.len());
    assert!(ids.iter().all(|id| super::is_known(id)));
}

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
    let [a, b] = Question::about(super::find("box_sums").expect("listed").generate(6, 1), PLACEMENTS[0], 1)
        .expect("boxes have facets")
        .bodies();
    for body in [a, b] {
        let g = body.generators();
        let dot = |u: [f64; 3], v: [f64; 3]| u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
        assert!(dot(g[0], g[1]).abs() + dot(g[1], g[2]).abs() + dot(g[2], g[0]).abs() < 1e-14);
    }
}
