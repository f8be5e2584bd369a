//! Section 1, third bullet.

use rand::RngExt;
use zonotope::collision::hierarchy::Hierarchy;
use zonotope::reduction::{contains, hausdorff::excess};
use zonotope::zonotope::Zonotope;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "variable-complexity",
    place: Place { section: "1", label: "third bullet" },
    kind: ClaimKind::Statement,
    statement: "The number of generators can vary over a bounding volume hierarchy, with more of them where few nodes \
        would otherwise fit badly",
    code: &["zonotope::collision::hierarchy"],
    figures: &["nested-hierarchy"],
    check: Check::Run(check),
    tried: Tried::On(&["a random body"]),
    ..Claim::LISTED
};

/// Generators of the body.
const GENERATORS: usize = 2000;

/// The levels of a hierarchy have more and more generators, contain the body, and fit it better and better.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 93);
    let rows = (0..GENERATORS).map(|_| std::array::from_fn(|_| random.random_range(-1.0..=1.0))).collect();
    let (Ok(body), Ok(point)) = (Zonotope::new([0.0; 3], rows), Zonotope::new([0.0; 3], Vec::new())) else {
        return Verdict::Inconclusive("the body is not finite".to_owned());
    };
    let diameter = 2.0 * excess(&body, &point, 0.01).lower;
    let hierarchy = Hierarchy::new(body);
    let mut levels: Vec<(usize, f64)> = Vec::new();
    for level in 0..hierarchy.level_count() - 1 {
        let outer = hierarchy.outer(level).body();
        let count = outer.generators().len();
        if contains(outer, hierarchy.body()) == Some(false) {
            return Verdict::Refuted(format!("a level of {count} generators does not contain the body"));
        }
        levels.push((count, excess(outer, hierarchy.body(), 0.01).upper / diameter));
    }
    let is_finer = levels.windows(2).all(|pair| pair[0].0 < pair[1].0 && pair[0].1 > pair[1].1);
    if levels.len() < 2 || !is_finer {
        return Verdict::Inconclusive(format!("levels of {levels:?} generators and distances"));
    }
    let levels: Vec<String> = levels.iter().map(|(count, distance)| format!("{count} within {distance:.4}")).collect();
    Verdict::Holds(format!(
        "levels around a body of {GENERATORS} generators, with their Hausdorff distances in diameters: {}",
        levels.join(", ")
    ))
}
