//! Bodies that meet or not by their levels, against answers that are known before any method is asked, on all families;
//! every proof is verified, and levels are contained in each other exactly.

use experiments::question::{PLACEMENTS, Question};
use families::bodies::{BODY_FAMILIES, BodyFamily};
use families::drawn::bodies::families;
use tests::body_questions::asked;
use tests::runner::{cases, for_all};
use zonotope::collision::hierarchy::Hierarchy;
use zonotope::collision::{Query, by_lad};
use zonotope::interop::verifier::check_location;
use zonotope::reduction::contains;
use zonotope::{Location, Status, Zonotope};

/// The numbers of generators of both bodies together, and how many pairs a long run asks of each family: with eleven
/// placements for each of the eleven families some 11,000 questions in all.
const SIZES: [(usize, u32); 5] = [(20, 24), (60, 24), (300, 24), (1000, 16), (2000, 8)];

/// The questions of a long run for each of the fourteen families that reach the ends of the doubles.
const CASES: u32 = 200;

/// Bodies of at most so many generators are compared with their levels by all facet normals.
const CONTAINED_GENERATORS: usize = 60;

/// The status and its proof are right.
fn answers(bodies: &[Zonotope<3>; 2], status: &str, name: &str) {
    let [first, second] = bodies.each_ref().map(|body| Hierarchy::new(body.clone()));
    let query = Query::between(&bodies[0], &bodies[1]);
    let descent = first.intersection(&second, &mut ());
    assert_eq!(descent.status().name(), status, "{name}");
    assert_eq!(descent.separation().is_some(), descent.status() == Status::Outside, "{name}");
    assert_eq!(descent.level_witness().is_some(), descent.status() != Status::Outside, "{name}");
    let location = descent.location();
    assert_eq!(location.status(), descent.status(), "{name}");
    assert_eq!(check_location(&query, &location).proof().map(drop), Ok(()), "{name}");
    let levels = descent.levels();
    let is_last = levels == [first.level_count() - 1, second.level_count() - 1];
    if let (Some(witness), false) = (descent.level_witness(), is_last) {
        let inner = [first.inner(levels[0]), second.inner(levels[1])].map(|inner| inner.expect("it told").body());
        let query = Query::between(inner[0], inner[1]);
        let proof = check_location(&query, &Location::Inside(witness.clone()));
        assert_eq!(proof.proof().map(drop), Ok(()), "{name}");
    }
}

/// Two bodies of a family under every placement that they have.
fn conforms(family: &BodyFamily<3>, n: usize, seed: u64) {
    let generators = family.generate(n, seed);
    for placement in PLACEMENTS {
        let Some(asked) = Question::about(generators.clone(), placement, seed) else { continue };
        answers(&asked.bodies(), asked.status, &format!("{} {n} {seed} {}", family.id, placement.id));
    }
    if n <= CONTAINED_GENERATORS {
        let body = Zonotope::new([0.5, 0.0, -1.0], generators).expect("finite");
        let levels = Hierarchy::new(body);
        for level in 0..levels.level_count() - 1 {
            let [outer, finer] = [level, level + 1].map(|level| levels.outer(level).body());
            assert_eq!(contains(outer, finer), Some(true), "{} {n} {seed} {level}", family.id);
            let inner = levels.inner(level).map(|inner| contains(levels.body(), inner.body()));
            assert_ne!(inner, Some(Some(false)), "{} {n} {seed} {level}", family.id);
        }
    }
}

#[test]
fn levels_tell_what_the_bodies_do() {
    for family in BODY_FAMILIES {
        for (n, pairs) in SIZES {
            (0..u64::from(cases(pairs))).for_each(|seed| conforms(family, n, seed));
        }
    }
}

#[test]
fn levels_tell_what_the_bodies_do_over_the_range_of_doubles() {
    for (name, generators) in families::<3>(120) {
        for_all(&asked(generators), CASES, |asked| {
            let (first, second) = asked.generators.split_at(asked.generators.len() / 3);
            let body = |center, generators: &[[f64; 3]]| Zonotope::new(center, generators.to_vec()).expect("finite");
            let bodies = [body(asked.from, first), body(asked.to, second)];
            let status = by_lad::locate(&Query::between(&bodies[0], &bodies[1]), &mut ()).status();
            answers(&bodies, status.name(), name);
            Ok(())
        });
    }
}
