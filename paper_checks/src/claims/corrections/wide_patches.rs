//! Section 5.2, proof of Lemma 5.5.

use dashu_ratio::RBig;
use zonotope::reduction::by_patches::patches_within;
use zonotope::reduction::contains;
use zonotope::zonotope::Zonotope;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Correction, Place, Tried, Verdict};
use crate::definitions::ratio::integer;
use crate::definitions::space::{Body, Vector};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "width-of-patches",
    place: Place { section: "5.2", label: "proof of Lemma 5.5" },
    kind: ClaimKind::Correction(Correction::MissingCondition),
    statement: "The hemisphere is subdivided into k patches so that the angle between two points of a patch is \
        O(1/sqrt(k)), and B contains A",
    remedy: Some(
        "patches must stay below 90 degrees so that every v_i . n_j >= 0: v = (10,0,1) and (-10,0,1) with n = (1,0,0) \
            lose (20,0,0)",
    ),
    code: &["zonotope::reduction::by_patches"],
    check: Check::Run(check),
    tried: Tried::Witness,
    ..Claim::LISTED
};

/// Sums up the projections of two generators of one patch as the proof does, and adds the box of what is left.
fn check(_context: &CheckContext) -> Verdict {
    let rows = [[10.0, 0.0, 1.0], [-10.0, 0.0, 1.0]];
    let generators: Vec<Vector> = rows.iter().map(|row| Vector::exactly(*row)).collect();
    let normal = Vector::at([1, 0, 0]);
    let projected = generators.iter().fold(RBig::ZERO, |sum, v| sum + v.dot(&normal));
    let origin = Vector::at([0; 3]);
    let magnitude = |x: &RBig| if *x < RBig::ZERO { -x.clone() } else { x.clone() };
    let rest = |axis: usize| {
        generators.iter().fold(RBig::ZERO, |sum, v| {
            let left = v.plus(&(integer(-1) * v.dot(&normal)), &normal);
            sum + magnitude(&left.0[axis])
        })
    };
    let axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(Vector::at);
    let bounding_box = (0..3).map(|axis| origin.plus(&rest(axis), &axes[axis]));
    let sum = [origin.plus(&projected, &normal)].into_iter().chain(bounding_box).collect();
    let [own, other] = [generators, sum].map(|generators| Body { center: origin.clone(), generators });
    let lost = Vector::at([20, 0, 0]);
    let body = Zonotope::new([0.0; 3], rows.to_vec()).expect("the coordinates are finite");
    let enclosing = patches_within(&body, 0.5, &mut ()).expect("the precision is between 0 and 1");
    let is_contained = contains(&enclosing.body, &body) == Some(true);
    if !own.holds(&lost) || other.holds(&lost) || !is_contained {
        return Verdict::Holds("the counterexample is none".to_owned());
    }
    Verdict::Refuted(format!(
        "of (10,0,1) and (-10,0,1) the projections on (1,0,0) cancel: the body holds {lost}, the sum of projections \
         and box does not; the library's patches of less than 90 degrees contain the body"
    ))
}
