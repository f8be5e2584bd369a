//! Lemma 5.6: walking from facet to facet.

use std::cmp::Ordering;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

use experiments::fit::GrowthModel;
use rand::RngExt;
use zonotope::arrangement::dynamic_hull::{
    Direction, DynamicChain, HullChain, PlanarPoint, Side, Site, SiteIndex, SortedSites, Towards,
};
use zonotope::arrangement::facet_walk::{FacetWalk, HullWalk};
use zonotope::numeric::dyadic::Dyadic;
use zonotope::numeric::orientation::Turn;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::space::Body;
use crate::growth;
use crate::instances::bodies::{bodies_in_general_position, degenerate_bodies, doubles};
use crate::instances::polygons::generator;
use crate::proofs::facets::{named_facet, neighbours_of};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "lemma-5.6",
    place: Place { section: "5.2", label: "Lemma 5.6" },
    kind: ClaimKind::Lemma,
    statement: "After O(n log n) preprocessing with O(n) space, a face-to-face walk on a zonotope of n generators \
        takes O(log^2 n) time a step",
    code: &["zonotope::arrangement::facet_walk", "zonotope::arrangement::dynamic_hull"],
    figures: &["facet-walk", "walk-steps"],
    check: Check::Run(check),
    tried: Tried::Growth(&["hulls of points in a parabola", "hulls of points in a square"]),
    ..Claim::LISTED
};

/// A step goes to the facet across the edge, by the definition; a step is one deletion, one insertion and at most eight
/// tangents of dynamic hulls, whose orientation tests are counted.
fn check(context: &CheckContext) -> Verdict {
    let verdict = growth::verdict(context, &CLAIM, step_evidence(context), growth_evidence, &["by_dynamic_hull"]);
    growth::but_for(verdict, "steps of which the hull is more than one chain of points")
}

fn step_evidence(context: &CheckContext) -> Result<String, String> {
    let mut random = generator(context.seed, 89);
    let mut instances = bodies_in_general_position(&mut random, 14);
    instances.extend(degenerate_bodies());
    let (mut steps, mut solid) = (0, 0);
    for instance in &instances {
        let rows: Vec<[f64; 3]> = instance.generators.iter().copied().map(doubles).collect();
        let Ok(mut walk) = HullWalk::new(&rows) else { continue };
        solid += 1;
        let body = Body::about_origin(&instance.generators);
        let facets = body.facets();
        for _ in 0..30 {
            let before =
                named_facet(&facets, &body, walk.facet()).ok_or_else(|| format!("{}: no facet", instance.name))?;
            let edge = random.random_range(0..walk.edges().len());
            walk.step(edge).map_err(|error| error.to_string())?;
            let after =
                named_facet(&facets, &body, walk.facet()).ok_or_else(|| format!("{}: no facet", instance.name))?;
            if !neighbours_of(&facets, before).iter().any(|facet| facet.normal == after.normal) {
                return Err(format!("{}: a step from {} to {}", instance.name, before.normal, after.normal));
            }
            steps += 1;
        }
    }
    Ok(format!("{steps} steps over {solid} bodies, parallel and coplanar generators among them, lead across an edge"))
}

/// A point that counts the tests that it is asked for.
#[derive(Debug, Clone, Copy)]
struct Counted<'a>(PlanarPoint, &'a AtomicU64);

impl Counted<'_> {
    fn count(&self) {
        self.1.fetch_add(1, Relaxed);
    }
}

impl Site for Counted<'_> {
    fn order(&self, other: &Self) -> Ordering {
        self.0.order(&other.0)
    }

    fn abscissa_order(&self, other: &Self) -> Ordering {
        self.0.abscissa_order(&other.0)
    }

    fn order_along(&self, other: &Self, direction: Direction) -> Ordering {
        self.count();
        self.0.order_along(&other.0, direction)
    }

    fn turn(a: &Self, b: &Self, c: &Self) -> Turn {
        a.count();
        Site::turn(&a.0, &b.0, &c.0)
    }

    fn crossing_order(first: [&Self; 2], second: [&Self; 2], at: &Self) -> Ordering {
        at.count();
        Site::crossing_order(first.map(|site| &site.0), second.map(|site| &site.0), &at.0)
    }

    fn homogeneous(&self) -> [Dyadic; 3] {
        self.0.homogeneous()
    }
}

/// Orientation tests of building a hull, over n log n, and of a deletion, an insertion and two tangents, over log² n. A
/// step takes one of each and up to eight tangents; the points lie on a parabola, all of them vertices, or in a square.
fn growth_evidence(context: &CheckContext) -> Result<String, String> {
    let mut random = generator(context.seed, 90);
    let mut evidence = Vec::new();
    for (name, is_parabola) in [("a parabola", true), ("a square", false)] {
        let (mut built, mut samples) = (Vec::new(), Vec::new());
        for exponent in [6, 8, 10, 12, 14] {
            let count = 1u32 << exponent;
            let points: Vec<[f64; 2]> = (0..count)
                .map(|k| match is_parabola {
                    true => [f64::from(k), f64::from(k) * f64::from(k)],
                    false => [random.random_range(-1.0..=1.0), random.random_range(-1.0..=1.0)],
                })
                .collect();
            let [building, step] = tests(&points, |limit| random.random_range(0..limit))?;
            built.push((f64::from(count), building));
            samples.push((f64::from(count), step));
        }
        let building = format!("orientation tests of building the hull of points in {name}");
        evidence.push(growth::evidence_on(&building, &built, GrowthModel::Linearithmic)?);
        let what = format!("orientation tests of a deletion, insertion and two tangents in hulls of points in {name}");
        evidence.push(growth::evidence_on(&what, &samples, GrowthModel::LogSquared)?);
    }
    evidence.push(growth::evidence_on("bytes of a walk on random bodies", &bytes(context)?, GrowthModel::Linear)?);
    Ok(evidence.join("; "))
}

/// The bytes that a walk holds, by the number of generators.
fn bytes(context: &CheckContext) -> Result<Vec<(f64, f64)>, String> {
    let mut random = generator(context.seed, 91);
    let sizes = [6, 7, 8, 9, 10].map(|exponent| 1u32 << exponent);
    let of = |count: u32| {
        let rows: Vec<[f64; 3]> = (0..count).map(|_| [0; 3].map(|_| random.random_range(-1.0..=1.0))).collect();
        let walk = HullWalk::new(&rows).map_err(|error| error.to_string())?;
        Ok((f64::from(count), walk.bytes() as f64))
    };
    sizes.into_iter().map(of).collect()
}

/// The number of tests for building the hull, and the mean number for deleting and inserting a point and for two
/// tangents, half of the points being vertices.
fn tests(points: &[[f64; 2]], mut draw: impl FnMut(u32) -> u32) -> Result<[f64; 2], String> {
    let tests = AtomicU64::new(0);
    let planar = PlanarPoint::list(points).map_err(|error| error.to_string())?;
    let sites: Vec<Counted> = planar.into_iter().map(|point| Counted(point, &tests)).collect();
    let sorted = Arc::new(SortedSites::new(&sites).map_err(|error| error.to_string())?);
    let count = sites.len() as u32;
    let mut chain =
        DynamicChain::new(sorted, Side::Lower, (0..count).map(SiteIndex)).map_err(|error| error.to_string())?;
    let vertices = chain.vertices();
    let building = tests.swap(0, Relaxed);
    let rounds = 500;
    for round in 0..rounds {
        let site = match round % 2 {
            0 => vertices[draw(vertices.len() as u32) as usize],
            _ => SiteIndex(draw(count)),
        };
        chain.delete(site).map_err(|error| error.to_string())?;
        for towards in [Towards::Left, Towards::Right] {
            chain.tangent(&sites[site.0 as usize], towards);
        }
        chain.insert(site).map_err(|error| error.to_string())?;
    }
    Ok([building as f64, tests.load(Relaxed) as f64 / f64::from(rounds)])
}
