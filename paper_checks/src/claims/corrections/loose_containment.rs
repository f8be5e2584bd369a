//! Section 4.3, third paragraph.

use dashu_ratio::RBig;
use families::clouds;
use rand::RngExt;
use rand_pcg::Pcg64Mcg;
use zonotope::enclosing::min_total_length::{Net, by_direction_net};

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::enclosing::{Row, dot, root_above};
use crate::definitions::ratio::{fraction, integer};
use crate::instances::polygons::generator;
use crate::proofs::lengths::check_shortest;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "size-of-direction-net",
    place: Place { section: "4.3", label: "third paragraph" },
    kind: ClaimKind::Note,
    statement: "Z' has the total length (1 + d eps) D, with O(1 / eps^(d-1)) directions and the d axes",
    remedy: Some(
        "the optimum over R is at most the optimum over the inradius of conv(R, -R): the error is O(eps^2) in the \
            mesh, eps^(-(d-1)/2) directions suffice, and the axes are not needed",
    ),
    code: &[
        "zonotope::enclosing::min_total_length::by_direction_net",
        "zonotope::enclosing::min_total_length::direction_net",
    ],
    figures: &["directions-needed", "length-ratio"],
    check: Check::Run(check),
    tried: Tried::Witness,
};

/// Unit vectors as combinations of the corners of their cell, and an answer along a net without the axes' help.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 67);
    let found = (|| {
        let worst = [overhead::<2>(&mut random)?, overhead::<3>(&mut random)?, overhead::<4>(&mut random)?];
        Ok::<_, String>((worst, with_fewer(context.seed)?))
    })();
    let (worst, (ratio, sizes)) = match found {
        Ok(found) => found,
        Err(reason) => return Verdict::Inconclusive(reason),
    };
    Verdict::Holds(format!(
        "a unit vector is a combination of the corners of its cell with lengths that exceed 1 by at most {:.2}, {:.2} \
         and {:.2} times the square of the cell's mesh in R^2, R^3 and R^4 (300 rational directions each), without any \
         axis; for 8 points on a sphere of R^3 and eps = 1/4 a net of {} directions has the proven ratio {ratio:.4}, \
         where the paper's has {}",
        worst[0], worst[1], worst[2], sizes[0], sizes[1]
    ))
}

/// The largest (Σ α_j - 1) / mesh² over random directions u = Σ α_j v_j, v_j the unit vectors at the corners of the
/// cell of u; an error where it is above the bound 1 / (1 - mesh²/2).
fn overhead<const D: usize>(random: &mut Pcg64Mcg) -> Result<f64, String> {
    let mut worst: f64 = 0.0;
    for trial in 0..300 {
        let cells = [3, 4, 8][trial % 3];
        // A direction with last coordinate 1; the others in units of a cell, from the corner of its cell.
        let places: Vec<(i64, RBig)> =
            (1..D).map(|_| (random.random_range(0..cells), fraction(random.random_range(0..=60), 60))).collect();
        let at = |index: i64, share: &RBig| (integer(index) + share) * fraction(2, cells) - RBig::ONE;
        let mut direction: Row = places.iter().map(|(index, share)| at(*index, share)).collect();
        direction.push(RBig::ONE);
        let mut length = RBig::ZERO;
        let mut sum = vec![RBig::ZERO; D];
        for corner in 0..1usize << (D - 1) {
            let mut weight = RBig::ONE;
            let mut vertex: Row = Vec::with_capacity(D);
            for (c, (index, share)) in places.iter().enumerate() {
                let upper = corner >> c & 1 == 1;
                weight *= if upper { share.clone() } else { RBig::ONE - share };
                vertex.push(at(*index, &integer(i64::from(upper))));
            }
            vertex.push(RBig::ONE);
            sum.iter_mut().zip(&vertex).for_each(|(sum, c)| *sum += &weight * c);
            length += &weight * root_above(&dot(&vertex, &vertex));
        }
        if sum != direction {
            return Err(format!("{direction:?} is no combination of the corners of its cell"));
        }
        let mesh_squared = fraction(4 * (D as i64 - 1), cells * cells);
        let square = dot(&direction, &direction);
        let limit = RBig::ONE / (RBig::ONE - &mesh_squared / integer(2)) + fraction(1, 1_000_000_000_000);
        // Σ α_j = length / |u|; from three cells on the mesh is below sqrt(2) and the limit positive.
        if &length * &length > &limit * &limit * &square {
            return Err(format!("{direction:?} with {cells} cells takes {length}"));
        }
        let excess = length.to_f64_fast() / square.to_f64_fast().sqrt() - 1.0;
        worst = worst.max(excess / mesh_squared.to_f64_fast());
    }
    Ok(worst)
}

/// The proven ratio along the smaller net, and how many directions both have.
fn with_fewer(seed: u64) -> Result<(f64, [usize; 2]), String> {
    let (points, epsilon) = (clouds::on_sphere::<3>(8, seed), 0.25);
    let answer = by_direction_net::min_length_by_net(&points, epsilon, Net::Cells, &mut ())
        .map_err(|error| error.to_string())?;
    check_shortest(&points, &answer)?;
    let sizes = [answer.effort.rows, Net::Paper.size(3, epsilon)];
    if answer.ratio() <= 1.0 + epsilon && sizes[0] < sizes[1] {
        Ok((answer.ratio(), sizes))
    } else {
        Err(format!("ratio {} with {sizes:?} directions", answer.ratio()))
    }
}
