//! Section 7, first question.

use dashu_ratio::RBig;
use families::clouds;
use rand::RngExt;
use rand_pcg::Pcg64Mcg;
use zonotope::enclosing::min_length;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::enclosing::absolute;
use crate::definitions::ratio::{fraction, integer};
use crate::definitions::space::{Body, Vector};
use crate::instances::bodies::random_vector;
use crate::instances::polygons::generator;
use crate::proofs::lengths::check_shortest;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "question-approximation-quality",
    place: Place { section: "7", label: "first question" },
    kind: ClaimKind::OpenQuestion,
    statement: "In R^3, how well can a zonotope approximate a given centrally symmetric convex polyhedron?",
    remedy: Some(
        "not arbitrarily well: between the octahedron and t times itself there is a zonotope just when t >= 3/2, \
            however many generators it has; by total length, every single input can be answered to any precision with \
            a proof",
    ),
    code: &["zonotope::enclosing::min_total_length::by_vertex_sets"],
    figures: &["mesh-in-zonohedra"],
    check: Check::Run(check),
    tried: Tried::On(&["solids"]),
};

/// The octahedron exactly; the other symmetric Platonic solids by total length.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 68);
    let found = octahedron(&mut random).and_then(|()| {
        ["octahedron", "icosahedron", "dodecahedron"]
            .into_iter()
            .map(by_length)
            .collect::<Result<Vec<String>, String>>()
    });
    match found {
        Err(reason) => Verdict::Inconclusive(reason),
        Ok(lengths) => Verdict::InPart(format!(
            "the octahedron conv(±e_i) lies in a truncated octahedron of 6 generators, which lies in 3/2 \
             times the octahedron, and no zonotope does better, for sum of h(±1,±1,±1) / 8 >= sum of h(e_i) / 2 \
             generator by generator; the least total lengths around solids, proven within 1 %: {}",
            lengths.join(", ")
        )),
    }
}

/// The truncated octahedron between the octahedron and 3/2 of it, and the inequality that forbids anything better.
///
/// A zonotope Z around the octahedron has h(e_i) ≥ 1; within t times it, h(±1, ±1, ±1) ≤ t. For a generator g the mean
/// of |s · g| over the eight sign vectors s is at least |g|_1 / 2: with a ≥ b ≥ c ≥ 0 it is (a+b+c + a+b−c + a−b+c +
/// |b+c−a|) / 4 ≥ (3a+b+c + b+c−a) / 4. And |g|_1 = Σ |e_i · g|, so t ≥ Σ h(e_i) / 2 ≥ 3/2.
fn octahedron(random: &mut Pcg64Mcg) -> Result<(), String> {
    let quarters = [[1, 1, 0], [1, -1, 0], [1, 0, 1], [1, 0, -1], [0, 1, 1], [0, 1, -1]];
    let quarter = |v: [i64; 3]| Vector(v.map(|c| fraction(c, 4)));
    let body = Body { center: Vector::at([0; 3]), generators: quarters.map(quarter).to_vec() };
    let corners = (0..3).flat_map(|axis| {
        [1, -1].map(|sign| Vector(std::array::from_fn(|i| integer(if i == axis { sign } else { 0 }))))
    });
    if let Some(outside) = corners.into_iter().find(|corner| !body.holds(corner)) {
        return Err(format!("{outside} is outside the truncated octahedron"));
    }
    let signs =
        || (0..8).map(|choice: usize| Vector::at(std::array::from_fn(|i| if choice >> i & 1 == 0 { 1 } else { -1 })));
    if signs().any(|sign| body.support(&sign) != fraction(3, 2)) {
        return Err("the truncated octahedron does not touch 3/2 times the octahedron".to_owned());
    }
    for _ in 0..300 {
        let reach = [2, 40, 1000][random.random_range(0..3)];
        let generator = Vector::at(random_vector(random, reach));
        let mean = signs().fold(RBig::ZERO, |sum, sign| sum + absolute(sign.dot(&generator))) / integer(8);
        let taxicab = generator.0.iter().fold(RBig::ZERO, |sum, c| sum + absolute(c.clone()));
        if mean * integer(2) < taxicab {
            return Err(format!("the generator {generator} is an exception"));
        }
    }
    Ok(())
}

/// The least total length around a solid, with its proof checked.
fn by_length(name: &str) -> Result<String, String> {
    let points = clouds::solid(name).ok_or_else(|| format!("no solid is called {name}"))?;
    let answer = min_length(&points, 0.01).map_err(|error| error.to_string())?;
    check_shortest(&points, &answer).map_err(|defect| format!("{name}: {defect}"))?;
    if answer.ratio() > 1.01 {
        return Err(format!("{name}: ratio {}", answer.ratio()));
    }
    Ok(format!("{name} {:.4} to {:.4}", answer.lower_bound, answer.value))
}
