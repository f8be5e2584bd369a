//! Section 4.3, second paragraph.

use dashu_ratio::RBig;
use experiments::fit::{GrowthModel, fit_growth};
use rand::RngExt;
use rand_pcg::Pcg64Mcg;
use zonotope::enclosing::min_total_length::direction_net::cell_middles;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::enclosing::{Row, absolute, dot, exact_rows};
use crate::definitions::ratio::{fraction, integer};
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "direction-net",
    place: Place { section: "4.3", label: "second paragraph" },
    kind: ClaimKind::Statement,
    statement: "O(1 / eps^(d-1)) unit vectors suffice to have one within eps of every unit vector",
    code: &["zonotope::enclosing::min_total_length::direction_net"],
    figures: &["directions-needed"],
    check: Check::Run(check),
    tried: Tried::On(&["random directions of R^2 to R^4", "corners of cells of R^2 to R^4"]),
    ..Claim::LISTED
};

/// Nets of the cube's faces: the farthest directions of cells and random ones are near a vector, and the sizes grow as
/// they should.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 65);
    let found = covered::<2>(&mut random).and_then(|a| Ok(a + covered::<3>(&mut random)? + covered::<4>(&mut random)?));
    let tried = match found {
        Err(witness) => return Verdict::Refuted(witness),
        Ok(tried) => tried,
    };
    let exponents =
        [sizes::<2>(GrowthModel::Linear), sizes::<3>(GrowthModel::Quadratic), sizes::<4>(GrowthModel::Cubic)];
    let [Some(plane), Some(space), Some(four)] = exponents else {
        return Verdict::Inconclusive("the sizes of the nets do not grow like 1 / eps^(d-1)".to_owned());
    };
    Verdict::Holds(format!(
        "{tried} directions of R^2, R^3 and R^4, the corners of the nets' cells, which are farthest from their \
         middles, among them, are within eps of a vector of the net or its opposite; the sizes grow with 1 / eps to \
         the powers {plane:.2}, {space:.2}, {four:.2}"
    ))
}

/// sqrt(d - 1) / cells, squared: the square of the net's eps.
fn epsilon_squared(dimension: usize, cells: usize) -> RBig {
    fraction(dimension as i64 - 1, (cells * cells) as i64)
}

fn covered<const D: usize>(random: &mut Pcg64Mcg) -> Result<usize, String> {
    let mut tried = 0;
    for cells in [1, 2, 5] {
        let net = exact_rows(&cell_middles::<D>(cells));
        let square = epsilon_squared(D, cells);
        let grid = |random: &mut Pcg64Mcg| integer(2 * random.random_range(0..=cells as i64) - cells as i64);
        let anywhere = |random: &mut Pcg64Mcg| integer(random.random_range(-1000..=1000));
        for trial in 0..40 {
            let mut direction: Row =
                (0..D).map(|_| if trial % 2 == 0 { grid(random) } else { anywhere(random) }).collect();
            if trial % 2 == 0 {
                direction[trial / 2 % D] = integer(cells as i64);
            }
            if direction.iter().all(|c| *c == RBig::ZERO) {
                continue;
            }
            if !net.iter().any(|v| is_within(&direction, v, &square)) {
                return Err(format!("{direction:?} in R^{D} is farther than eps from all of {} vectors", net.len()));
            }
            tried += 1;
        }
    }
    Ok(tried)
}

/// Whether |u/|u| ∓ v/|v||² = 2 - 2 |u·v| / (|u| |v|) is at most `square` and a little for rounding.
pub(super) fn is_within(u: &[RBig], v: &[RBig], square: &RBig) -> bool {
    let cosine = RBig::ONE - square / integer(2) - fraction(1, 1_000_000_000_000);
    let along = absolute(dot(u, v));
    cosine <= RBig::ZERO || &along * &along >= &cosine * &cosine * dot(u, u) * dot(v, v)
}

/// The exponent of the net's size against 1 / eps, if it is the model's.
fn sizes<const D: usize>(model: GrowthModel) -> Option<f64> {
    let samples: Vec<(f64, f64)> = [4, 6, 8, 12, 16]
        .map(|cells| (cells as f64 / (D as f64 - 1.0).sqrt() * 2.0, cell_middles::<D>(cells).len() as f64))
        .to_vec();
    let growth = fit_growth(&samples, &[model]).ok()?;
    let fit = growth.model(model)?;
    (fit.verdict.keeps_bound() == Some(true)).then_some(growth.exponent.value)
}
