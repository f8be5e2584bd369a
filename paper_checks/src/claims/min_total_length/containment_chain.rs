//! Section 4.3, third paragraph.

use dashu_ratio::RBig;
use rand::RngExt;
use rand_pcg::Pcg64Mcg;
use zonotope::enclosing::fixed_directions::{FixedDirections, min_length_along};

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::enclosing::{Row, absolute, dot, facet_normals};
use crate::definitions::ratio::{exactly, fraction, integer};
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "containment-chain",
    place: Place { section: "4.3", label: "third paragraph" },
    kind: ClaimKind::Statement,
    statement: "Moving every generator to the nearest net direction and adding eps D along each of the d axes gives a \
        zonotope Z' that contains Z and has total length (1 + d eps) D",
    remedy: Some(
        "with what the moved parts reach along each axis a factor sqrt(d) is enough in place of d; the printed sums \
            take the last axis d times, see the erratum",
    ),
    code: &["zonotope::enclosing::min_total_length::by_direction_net", "zonotope::enclosing::fixed_directions"],
    check: Check::Run(check),
    tried: Tried::On(&["random zonotopes of R^2 and R^3"]),
    ..Claim::LISTED
};

/// Rational unit vectors, in the plane and in space: Z' contains Z, has that length, and the library's best one is no
/// longer.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 66);
    let tried = (0..12)
        .try_for_each(|_| moved::<2>(&mut random, 5))
        .and_then(|()| (0..6).try_for_each(|_| moved::<3>(&mut random, 4)));
    match tried {
        Err(witness) => Verdict::Refuted(witness),
        Ok(()) => Verdict::Holds(
            "for 18 zonotopes of R^2 and R^3 with generators along rational unit vectors, each moved to another one \
             within eps, every facet normal of Z' says that Z is inside, and the lengths add up to (1 + d eps) D; \
             along each axis as much as the moved parts reach there is enough, sqrt(d) eps D in all; the library's \
             zonotope along the same directions around the vertices is no longer"
                .to_owned(),
        ),
    }
}

/// The unit vector with stereographic coordinates t.
fn unit(t: &[RBig]) -> Row {
    let square = dot(t, t);
    let scale = RBig::ONE + &square;
    let mut vector: Row = t.iter().map(|c| c * integer(2) / &scale).collect();
    vector.push((&square - RBig::ONE) / scale);
    vector
}

fn moved<const D: usize>(random: &mut Pcg64Mcg, count: usize) -> Result<(), String> {
    let mut epsilon = RBig::ZERO;
    let (mut parts, mut farthest) = (vec![RBig::ZERO; D], RBig::ZERO);
    let (mut generators, mut near, mut total) = (Vec::new(), Vec::new(), RBig::ZERO);
    for _ in 0..count {
        let t: Row = (1..D).map(|_| fraction(random.random_range(-12..=12), 8)).collect();
        let beside: Row = t.iter().map(|c| c + fraction(random.random_range(-2..=2), 40)).collect();
        let (u, v) = (unit(&t), unit(&beside));
        let length = integer(random.random_range(1..=9));
        let apart: Row = u.iter().zip(&v).map(|(a, b)| a - b).collect();
        // |u - v| ≤ Σ |u_i - v_i|, which is rational.
        let bound = apart.iter().fold(RBig::ZERO, |sum, c| sum + absolute(c.clone()));
        epsilon = epsilon.max(bound);
        farthest = farthest.max(dot(&apart, &apart));
        parts.iter_mut().zip(&apart).for_each(|(part, c)| *part += absolute(c.clone()) * &length);
        generators.push(u.iter().map(|c| c * &length).collect::<Row>());
        near.push((v, length.clone()));
        total += length;
    }
    let step = &epsilon * &total;
    let along_axes = |reaches: &[RBig]| -> Vec<Row> {
        let axis = |a: usize| (0..D).map(|c| if a == c { reaches[a].clone() } else { RBig::ZERO }).collect();
        near.iter().map(|(v, length)| v.iter().map(|c| c * length).collect()).chain((0..D).map(axis)).collect()
    };
    for around in [along_axes(&vec![step.clone(); D]), along_axes(&parts)] {
        for normal in facet_normals(&around, D) {
            let reach = |body: &[Row]| body.iter().fold(RBig::ZERO, |sum, g| sum + absolute(dot(&normal, g)));
            if reach(&generators) > reach(&around) {
                return Err(format!("{generators:?} moved to {near:?}: outside along {normal:?}"));
            }
        }
    }
    let reached = parts.iter().fold(RBig::ZERO, |sum, part| sum + part);
    if &reached * &reached > integer(D as i64) * farthest * &total * &total {
        return Err(format!("{generators:?} moved to {near:?}: {reached} along the axes"));
    }
    let length = near.iter().fold(RBig::ZERO, |sum, (_, length)| sum + length) + integer(D as i64) * &step;
    if length != (RBig::ONE + integer(D as i64) * &epsilon) * &total {
        return Err(format!("{near:?}: the length is {length}"));
    }
    best_is_no_longer::<D>(&generators, &near, &length)
}

/// The library's least zonotope along the directions of Z' around the vertices of Z.
fn best_is_no_longer<const D: usize>(generators: &[Row], near: &[(Row, RBig)], length: &RBig) -> Result<(), String> {
    let rounded = |row: &Row| -> [f64; D] { std::array::from_fn(|c| row[c].to_f64_fast()) };
    let vertices: Vec<[f64; D]> = (0..1usize << generators.len())
        .map(|choice| {
            let sum = generators.iter().enumerate().fold(vec![RBig::ZERO; D], |sum, (i, g)| {
                let sign = integer(if choice >> i & 1 == 0 { 1 } else { -1 });
                sum.iter().zip(g).map(|(sum, c)| sum + &sign * c).collect()
            });
            rounded(&sum)
        })
        .collect();
    let axes = (0..D).map(|a| std::array::from_fn(|c| f64::from(u8::from(a == c))));
    let directions: Vec<[f64; D]> = near.iter().map(|(v, _)| rounded(v)).chain(axes).collect();
    let weights = vec![1.0; directions.len()];
    let problem = FixedDirections::new(&vertices, &directions, &weights).map_err(|error| error.to_string())?;
    let answer = min_length_along(&problem, &mut ()).map_err(|error| error.to_string())?;
    let value = answer.optimal().ok_or("the axes span")?.value;
    let slack = RBig::ONE + fraction(1, 1_000_000_000);
    if exactly(value) > length * slack { Err(format!("{near:?}: {value} is above {length}")) } else { Ok(()) }
}
