//! The slips in the text about separators.

use zonotope::arrangement::DualArrangement;
use zonotope::arrangement::separator::separator;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Correction, Place, Tried, Verdict};
use crate::definitions::plane::Point;
use crate::definitions::ratio::fraction;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "separator-steps",
    place: Place { section: "5.1", label: "separators" },
    kind: ClaimKind::Correction(Correction::Erratum),
    statement: "The vertical line L_k crosses the lines from left to right, and the chain starts at the top vertex of \
        Q and extends v' one by one",
    remedy: Some(
        "L_k meets them from top to bottom; a step is 2 v' in half-lengths, every v' turned to point up; v' = 0 has no \
            line, a horizontal v' is never crossed, equal x need a rule",
    ),
    code: &["zonotope::arrangement::separator"],
    figures: &["separators"],
    check: Check::Run(check),
    tried: Tried::Witness,
};

/// Two generators whose chain by steps of v' ends inside Q, and generators without a line or with a vertical one.
fn check(context: &CheckContext) -> Verdict {
    let chain = |rows: &[[f64; 3]], k: u64| -> Result<Vec<Point>, String> {
        let dual = DualArrangement::new(rows).map_err(|error| error.to_string())?;
        let found = separator(&dual, k, context.seed, &mut ()).map_err(|error| error.to_string())?;
        Ok(found.rational_points().into_iter().map(|[x, y]| Point::new(x, y)).collect())
    };
    let square = [[1.0, 1.0, 0.0], [-1.0, 1.0, 1.0]];
    let reversed = [[-1.0, -1.0, 0.0], [-1.0, 1.0, 1.0]];
    let with_vertical = [square[0], square[1], [0.0, 0.0, 3.0], [0.0; 3]];
    let with_horizontal = [square[0], [2.0, 0.0, 1.0]];
    let answers = [chain(&square, 0), chain(&reversed, 0), chain(&with_vertical, 0), chain(&with_horizontal, 1)];
    let [Ok(plain), Ok(turned), Ok(vertical), Ok(horizontal)] = answers else {
        return Verdict::Inconclusive("the library refuses one of the examples".to_owned());
    };
    let bottom = Point::at(0, -2);
    let first_step = plain[0].to(&plain[1]);
    let doubled = first_step == Point::at(2, -2) || first_step == Point::at(-2, -2);
    let halfway = Point::at(0, 2).plus(&fraction(1, 2), &Point::at(0, 2).to(&bottom));
    let at_ends = plain[0] == Point::at(0, 2) && plain[plain.len() - 1] == bottom;
    if !doubled || !at_ends || turned != plain || vertical != plain || horizontal.len() != 3 {
        return Verdict::Inconclusive(format!("chains {plain:?}, {turned:?}, {vertical:?}, {horizontal:?}"));
    }
    Verdict::Refuted(format!(
        "generators (1,1,0), (-1,1,1): Q reaches from (0,2) to {bottom}, so steps of v' stop half way at {halfway}, \
         steps of 2 v' end at the bottom vertex; with (1,1,0) negated, or with the vertical generator (0,0,3) and a \
         zero one added, the chain is the same; (2,0,1) with its horizontal projection still takes its step: {} points",
        horizontal.len()
    ))
}
