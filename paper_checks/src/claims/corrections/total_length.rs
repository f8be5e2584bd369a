//! Section 4.3, first paragraph.

use dashu_ratio::RBig;
use rand::RngExt;
use rand_pcg::Pcg64Mcg;
use zonotope::enclosing::min_length;
use zonotope::enclosing::min_total_length::in_the_plane;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::enclosing::{root_above, rows};
use crate::definitions::plane::{Point, zonogon_about};
use crate::definitions::ratio::{exactly, fraction, integer};
use crate::definitions::space::Body;
use crate::instances::bodies::generators_in_general_position;
use crate::instances::polygons::{generator, polygons};
use crate::proofs::lengths::{check_shortest, length};
use crate::proofs::library::doubles;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "meaning-of-total-length",
    place: Place { section: "4.3", label: "first paragraph" },
    kind: ClaimKind::Note,
    statement: "The sum of the total length of the generators is used as the measure of optimality",
    remedy: Some(
        "it is half the first intrinsic volume, so it grows under inclusion; the vertices of a zonotope have that \
            zonotope as optimum; in the plane the optimum is the least perimeter(Z(O)) / 4",
    ),
    code: &[
        "zonotope::enclosing::min_total_length::by_vertex_sets",
        "zonotope::enclosing::min_total_length::in_the_plane",
    ],
    check: Check::Run(check),
    tried: Tried::Witness,
    ..Claim::LISTED
};

/// Perimeters in the plane, zonotopes around the vertices of zonotopes in space.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 64);
    let found =
        (|| Ok::<_, String>((perimeters(&mut random)?, optima_in_the_plane(&mut random)?, own_optima(&mut random)?)))();
    match found {
        Err(defect) => Verdict::Inconclusive(defect),
        Ok((zonogons, (polygons, worst), bodies)) => Verdict::Holds(format!(
            "the paper minimises it without a reason; {zonogons} zonogons have a perimeter of four times their total \
             length, edge by edge; for {polygons} polygons the least perimeter of Z(O) over four is within {worst:.1e} \
             of a lower bound for all zonotopes, proven by forces; for the vertices of {bodies} zonohedra that bound \
             is within 1e-6 of their own length, so that nothing around them is shorter"
        )),
    }
}

/// The edges of a zonogon are twice its generators, each there twice.
fn perimeters(random: &mut Pcg64Mcg) -> Result<usize, String> {
    for _ in 0..30 {
        let mut generators: Vec<(i64, i64)> = Vec::new();
        while generators.len() < 5 {
            let (x, y) = (random.random_range(-20..=20_i64), random.random_range(0..=20_i64));
            let parallel = generators.iter().any(|(a, b)| a * y == b * x);
            if (x, y) != (0, 0) && !parallel {
                generators.push((x, y));
            }
        }
        let corners: Vec<Point> = (0..32)
            .map(|choice| {
                generators.iter().enumerate().fold(Point::at(0, 0), |sum, (i, &(x, y))| {
                    sum.plus(&integer(if choice >> i & 1 == 0 { 1 } else { -1 }), &Point::at(x, y))
                })
            })
            .collect();
        let hull = zonogon_about(&corners, &Point::at(0, 0));
        let next = hull.iter().cycle().skip(1);
        let mut squares: Vec<RBig> = hull.iter().zip(next).map(|(a, b)| square(&a.to(b))).collect();
        let mut expected: Vec<RBig> = generators
            .iter()
            .flat_map(|&(x, y)| [integer(4 * (x * x + y * y)), integer(4 * (x * x + y * y))])
            .collect();
        squares.sort();
        expected.sort();
        if squares != expected {
            return Err(format!("{generators:?}: the edges are not twice the generators"));
        }
    }
    Ok(30)
}

fn square(v: &Point) -> RBig {
    &v.x * &v.x + &v.y * &v.y
}

/// A quarter of the perimeter of Z(O), rounded up by less than 1e-14.
fn quarter_of_perimeter(polygon: &[Point], center: &Point) -> RBig {
    let hull = zonogon_about(polygon, center);
    let next = hull.iter().cycle().skip(1);
    let edges = hull.iter().zip(next).map(|(a, b)| root_above(&square(&a.to(b))));
    edges.fold(RBig::ZERO, |sum, edge| sum + edge) / integer(4)
}

/// Z(O) about the library's centre against the library's proven lower bound: how many polygons, and the largest excess.
fn optima_in_the_plane(random: &mut Pcg64Mcg) -> Result<(usize, f64), String> {
    let instances = polygons(random, 8);
    let mut worst: f64 = 0.0;
    for instance in &instances {
        let points = doubles(&instance.polygon);
        let answer = min_length(&points, 1e-9).map_err(|error| error.to_string())?;
        check_shortest(&points, &answer).map_err(|defect| format!("{}: {defect}", instance.name))?;
        let found = quarter_of_perimeter(&instance.polygon, &Point::exactly(answer.body.center()));
        let lower = exactly(answer.lower_bound);
        let excess = (&found / &lower - RBig::ONE).to_f64_fast();
        let search = in_the_plane::least_length(&points);
        let is_between = answer.lower_bound <= search * (1.0 + 1e-12) && search <= answer.value * (1.0 + 1e-12);
        if found < lower || excess > 1e-7 || !is_between {
            return Err(format!("{}: {search} by search, {} by forces", instance.name, answer.value));
        }
        worst = worst.max(excess);
    }
    Ok((instances.len(), worst))
}

/// The least total length around the vertices of a zonotope is its own.
fn own_optima(random: &mut Pcg64Mcg) -> Result<usize, String> {
    for count in [3, 3, 4, 4] {
        let generators = generators_in_general_position(random, count, 4);
        let body = Body::about_origin(&generators);
        let vertices: Vec<[f64; 3]> =
            body.vertices().iter().map(|vertex| vertex.0.each_ref().map(|c| c.to_f64_fast())).collect();
        let answer = min_length(&vertices, 1e-6).map_err(|error| error.to_string())?;
        check_shortest(&vertices, &answer).map_err(|defect| format!("{generators:?}: {defect}"))?;
        let (own, lower) = (length(&rows(&generators)), exactly(answer.lower_bound));
        let slack = RBig::ONE + fraction(1, 1_000_000);
        if lower > own || own > &lower * &slack {
            return Err(format!("{generators:?}: length {own}, at least {lower}"));
        }
    }
    Ok(4)
}
