//! Section 6, third paragraph.

use zonotope::motion::space_time::{Method, Sweep};
use zonotope::zonotope::Zonotope;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Correction, Place, Tried, Verdict};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "half-of-translation",
    place: Place { section: "6", label: "third paragraph" },
    kind: ClaimKind::Correction(Correction::Erratum),
    statement: "The translation vector v is added to the list of generators, and the result is anchored at the origin \
        of P translated by v/2",
    remedy: Some("in half-lengths, as the paper defines generators, the added generator is v/2"),
    code: &["zonotope::motion::space_time::by_farthest_vertex"],
    check: Check::Run(check),
    tried: Tried::Witness,
    ..Claim::LISTED
};

/// The volumes of the printed body and of the library's for a cube of side 2 that moves by 10.
fn check(_: &CheckContext) -> Verdict {
    match volumes() {
        Err(reason) => Verdict::Inconclusive(reason),
        Ok([swept, printed]) if swept == 48.0 && printed != swept => Verdict::Refuted(format!(
            "the cube of half-lengths 1 moved by (10, 0, 0) sweeps a box of volume {swept}; with v added, not v/2, the \
             volume is {printed}"
        )),
        Ok([swept, printed]) => Verdict::Inconclusive(format!("the volumes are {swept} and {printed}")),
    }
}

fn volumes() -> Result<[f64; 2], String> {
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let step = [10.0, 0.0, 0.0];
    let cube = Zonotope::new([0.0; 3], axes.to_vec()).map_err(|error| error.to_string())?;
    let sweep = Sweep::new([0.0; 3], [0.0, 0.0, 1.0], 0.0, step).map_err(|error| error.to_string())?;
    let swept = cube.swept_by(&sweep, Method::ByFarthestVertex).map_err(|error| error.to_string())?;
    let rows = [axes.to_vec(), vec![step]].concat();
    let printed = Zonotope::new([5.0, 0.0, 0.0], rows).map_err(|error| error.to_string())?;
    Ok([swept, printed].map(|body| body.exact_volume().to_f64()))
}
