//! Queries about a prepared body against the same queries without one, on all families of bodies: clear points, points
//! near the boundary and points on it, whose status is known from how they were made.
//!
//! Every proof is written out and checked by the verifier.

use experiments::question::{PLACEMENTS, Question};
use families::bodies::{BODY_FAMILIES, BodyFamily};
use tests::runner::cases;
use zonotope::collision::prepared::DirectionTree;
use zonotope::collision::{Gauge, Query, by_lad};
use zonotope::interop::verifier::check_location;
use zonotope::zonotope::Zonotope;

/// The number of generators, and how many bodies of it a long run asks of each family: with eleven placements for each
/// body of the eleven families some 12,000 questions in all.
const SIZES: [(usize, u32); 5] = [(20, 24), (150, 24), (700, 24), (1500, 16), (4096, 16)];

/// One body of a family under every placement that it has.
fn conforms(family: &BodyFamily<3>, n: usize, seed: u64) {
    let mut tree: Option<([f64; 3], DirectionTree)> = None;
    let generators = family.generate(n, seed);
    for placement in PLACEMENTS {
        let Some(asked) = Question::about(generators.clone(), placement, seed) else { continue };
        let name = format!("{} {n} {seed} {}", family.id, placement.id);
        // a touching point is a difference of doubles, from a centre of its own
        if tree.as_ref().is_none_or(|(center, _)| *center != asked.from) {
            let body = Zonotope::new(asked.from, asked.generators.clone()).expect("finite");
            tree = Some((asked.from, DirectionTree::new(&body)));
        }
        let (_, tree) = tree.as_ref().expect("it was just made");
        let query = Query::new(asked.from, asked.to, &asked.generators).expect("finite");
        let located = tree.locate(asked.to, &mut ()).expect("finite");
        assert_eq!(located.status().name(), asked.status, "{name}");
        let written = located.expand();
        assert_eq!(written.status(), located.status(), "{name}");
        assert_eq!(check_location(&query, &written).proof().map(drop), Ok(()), "{name}");
        let measured = tree.gauge(asked.to, &mut ()).expect("finite");
        assert_eq!(measured.location.status().name(), asked.status, "{name}");
        assert_eq!(check_location(&query, &measured.location.expand()).proof().map(drop), Ok(()), "{name}");
        let Gauge { value, error, .. } = by_lad::gauge(&query, &mut ());
        let is_same = value == measured.value || (value - measured.value).abs() <= error + measured.error;
        assert!(is_same, "{name}: {} ± {}, not {value} ± {error}", measured.value, measured.error);
        assert!(measured.error <= 1e-9 * measured.value || error == f64::INFINITY, "{name}: {}", measured.error);
        let support = tree.support(asked.to).expect("finite");
        assert_eq!(support, Zonotope::new(asked.from, generators.clone()).expect("finite").support(asked.to), "{name}");
    }
}

#[test]
fn a_tree_over_directions_answers_as_a_pass_does() {
    for family in BODY_FAMILIES {
        for (n, bodies) in SIZES {
            (0..u64::from(cases(bodies))).for_each(|seed| conforms(family, n, seed));
        }
    }
}
