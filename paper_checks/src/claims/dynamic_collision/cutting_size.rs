//! Section 5.2, the cutting of the proof of Lemma 5.3.

use std::num::NonZeroU32;

use families::bodies;
use zonotope::arrangement::DualArrangement;
use zonotope::arrangement::cutting::{TrapezoidIndex, cutting};

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "cutting-size",
    place: Place { section: "5.2", label: "proof of Lemma 5.3" },
    kind: ClaimKind::Statement,
    statement: "A (1/r)-cutting of the dual lines has O(r^2) interior disjoint trapezoids, each crossed by O(n/r) \
        lines",
    code: &["zonotope::arrangement::cutting"],
    check: Check::Run(check),
    tried: Tried::On(FAMILIES),
    ..Claim::LISTED
};

const FAMILIES: &[&str] = &["random_bodies", "heavy_tailed_bodies", "lattice_bodies"];

/// Generators of each body.
const GENERATORS: usize = 512;

/// Trapezoids over r² that no cutting may exceed: the library's have no proof, and this is beyond what was seen.
const MOST_A_SQUARE: f64 = 16.0;

/// Counts the trapezoids of the library's cuttings, and the lines that cross each.
fn check(context: &CheckContext) -> Verdict {
    let mut found = Vec::new();
    for family in FAMILIES {
        let Some(bodies) = bodies::find(family) else {
            return Verdict::Inconclusive(format!("no bodies are called {family}"));
        };
        let rows = bodies.generate(GENERATORS, context.seed);
        let Ok(dual) = DualArrangement::new(&rows) else {
            return Verdict::Inconclusive(format!("{family} have no dual arrangement"));
        };
        let mut most = 0.0f64;
        for r in [4u32, 8, 16, 32].map(|r| NonZeroU32::MIN.saturating_add(r - 1)) {
            let cut = cutting(dual.lines(), r, context.seed, &mut ());
            let count = cut.trapezoids().len();
            let crossed = (0..count as u32).map(|index| cut.crossing_lines(TrapezoidIndex(index)).len()).max();
            if crossed.is_none_or(|lines| lines > dual.lines().len().div_ceil(r.get() as usize)) {
                return Verdict::Refuted(format!("{family}, r = {r}: a trapezoid is crossed by {crossed:?} lines"));
            }
            most = most.max(count as f64 / f64::from(r.get()).powi(2));
        }
        if most > MOST_A_SQUARE {
            return Verdict::Inconclusive(format!("{family}: {most:.1} r^2 trapezoids"));
        }
        found.push(format!("{most:.1} r^2 of {family}"));
    }
    Verdict::Holds(format!(
        "for {GENERATORS} generators and r = 4 to 32 no trapezoid is crossed by more than n/r lines, and there are at \
         most {}",
        found.join(", ")
    ))
}
