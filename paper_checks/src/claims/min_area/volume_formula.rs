//! The volume of a zonotope from its generators.

use dashu_ratio::RBig;
use rand::RngExt;
use rand_pcg::Pcg64Mcg;
use zonotope::zonotope::{Zonotope, combinatorics};

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::enclosing::{doubles, rows};
use crate::definitions::pyramids::{volume_by_pyramids, volume_of_parallelepipeds};
use crate::instances::bodies::degenerate_bodies;
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "volume-formula",
    place: Place { section: "4.1", label: "after Theorem 4.5" },
    kind: ClaimKind::Statement,
    statement: "The volume of a zonotope is the sum of the volumes of the parallelepipeds formed by all d-tuples of \
        generators",
    code: &["zonotope::zonotope::combinatorics"],
    check: Check::Run(check),
    tried: Tried::On(&["random bodies", "degenerate bodies"]),
    ..Claim::LISTED
};

/// The number of bodies that were compared.
#[derive(Default)]
struct Compared {
    full_dimensional: usize,
    flat: usize,
}

/// In dimensions 1 to 5, the sum over all d-tuples against pyramids over the facets and against the library's volume.
fn check(context: &CheckContext) -> Verdict {
    match compare_all(context) {
        Err(verdict) => verdict,
        Ok(compared) => Verdict::Holds(format!(
            "2^d times the sum of abs(det) over all d-tuples is the volume that pyramids over the facets add up to, \
             for {} bodies of full dimension and {} flat ones in R^1 to R^5; the library computes the same volume",
            compared.full_dimensional, compared.flat
        )),
    }
}

fn compare_all(context: &CheckContext) -> Result<Compared, Verdict> {
    let mut random = generator(context.seed, 69);
    let mut compared = Compared::default();
    for instance in degenerate_bodies() {
        compare(&instance.generators, &mut compared)?;
    }
    compare_random::<1>(&mut random, 30, &mut compared)?;
    compare_random::<2>(&mut random, 80, &mut compared)?;
    compare_random::<3>(&mut random, 80, &mut compared)?;
    compare_random::<4>(&mut random, 30, &mut compared)?;
    compare_random::<5>(&mut random, 12, &mut compared)?;
    Ok(compared)
}

/// Compares the volumes of `count` random bodies of D − 1 to D + 4 generators: one in three has a pair of parallel
/// generators, one in three has coplanar ones on a coarse lattice.
fn compare_random<const D: usize>(random: &mut Pcg64Mcg, count: usize, compared: &mut Compared) -> Result<(), Verdict> {
    for index in 0..count {
        let reach = [1, 4, 1000][index % 3];
        let number_of_generators = D - 1 + index % 6;
        let mut generators: Vec<[i64; D]> =
            (0..number_of_generators).map(|_| std::array::from_fn(|_| random.random_range(-reach..=reach))).collect();
        if index % 3 == 1 && generators.len() > 1 {
            generators[0] = generators[1].map(|c| -2 * c);
        }
        compare(&generators, compared)?;
    }
    Ok(())
}

/// Refutes the claim if the parallelepipeds do not add up to the volume of the faces, and leaves it open if the library
/// has another volume.
fn compare<const D: usize>(generators: &[[i64; D]], compared: &mut Compared) -> Result<(), Verdict> {
    let exact = rows(generators);
    let parallelepipeds = volume_of_parallelepipeds(&exact, D);
    let pyramids = volume_by_pyramids(&exact, D);
    if parallelepipeds != pyramids {
        return Err(Verdict::Refuted(format!("{generators:?}: parallelepipeds {parallelepipeds}, faces {pyramids}")));
    }
    let body = Zonotope::new([0.0; D], doubles(generators)).expect("because integers of this size are finite doubles");
    let library = combinatorics(&body).measure;
    if library != pyramids {
        return Err(Verdict::Inconclusive(format!(
            "{generators:?}: the library's volume is {library}, not {pyramids}"
        )));
    }
    if pyramids == RBig::ZERO {
        compared.flat += 1
    } else {
        compared.full_dimensional += 1
    }
    Ok(())
}
