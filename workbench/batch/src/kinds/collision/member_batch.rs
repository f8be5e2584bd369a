//! `member_batch`: where many points lie relative to one zonotope.

use serde_json::{Value, json};
#[cfg(feature = "every-dimension")]
use zonotope::collision::by_lad_in_r4;
use zonotope::collision::prepared::by_cutting::PreparedByCutting;
use zonotope::collision::prepared::{DirectionTree, PreparedByFacets};
use zonotope::collision::{Gauge, Query, Status, by_lad};
use zonotope::tally::OperationCounts;
use zonotope::zonotope::Zonotope;

use super::posed::{Posed, Prism};
use super::proof;
use crate::claimed::{Placed, Traced, index, member, vectors};
use crate::dimension::refused;
use crate::fields::Fields;
use crate::json::to_json;
use crate::kinds::{Kind, Solution};
use crate::refusal::{Code, Refusal};

pub(in crate::kinds) const KIND: Kind = Kind {
    name: "member_batch",
    summary: "status and gauge of many points relative to one zonotope",
    fields: &["center", "generators", "points"],
    optional: &["pose"],
    methods: || vec![BY_LAD, BY_DIRECTION_TREE, BY_CUTTING, BY_FACETS],
    solve,
    check,
};

/// Nothing is prepared: each point is a question of its own.
const BY_LAD: &str = "by_lad";

/// Structures for bodies of space.
const BY_DIRECTION_TREE: &str = "by_direction_tree";
const BY_CUTTING: &str = "by_cutting";
const BY_FACETS: &str = "by_facets";

/// The most pairs of a point and a generator that are taken without a structure.
const PAIR_LIMIT: usize = 1_000_000_000;

/// The most generators of which a cutting is made.
const CUTTING_LIMIT: usize = 2_000;

/// The most generators of which all facets are listed, in time that grows with the third power.
const FACETS_LIMIT: usize = 200;

/// The answer on each point, and the operations that it took to prepare for the points and to answer.
struct Answers {
    found: Vec<(Status, f64)>,
    build: u64,
    query: u64,
}

fn solve(fields: &Fields<'_>, method: Option<&'static str>, seed: u64) -> Result<Solution, Refusal> {
    let dimension = fields.dimension("center")?;
    let method = method.unwrap_or(BY_LAD);
    let answers = match dimension {
        1..=4 if fields.has_pose() && method != BY_LAD => {
            let message = format!("`{method}` does not take a body under a pose; {BY_LAD} does");
            return Err(Refusal::new(Code::UnknownMethod, message));
        }
        #[cfg(feature = "every-dimension")]
        1 if fields.has_pose() => under_pose::<1>(fields)?,
        2 if fields.has_pose() => under_pose::<2>(fields)?,
        3 if fields.has_pose() => under_pose::<3>(fields)?,
        3 if method == BY_DIRECTION_TREE => by_direction_tree(fields)?,
        3 if method == BY_CUTTING => by_cutting(fields, seed)?,
        3 if method == BY_FACETS => by_facets(fields)?,
        1..=4 if method != BY_LAD => {
            let message = format!("`{method}` does not answer in {dimension} dimensions; {BY_LAD} would");
            return Err(Refusal::new(Code::UnknownMethod, message));
        }
        #[cfg(feature = "every-dimension")]
        1 => in_space::<1>(fields, |query, counts| by_lad::nearest_gauge(query, counts))?,
        2 => in_space::<2>(fields, |query, counts| by_lad::nearest_gauge(query, counts))?,
        3 => in_space::<3>(fields, |query, counts| by_lad::nearest_gauge(query, counts))?,
        #[cfg(feature = "every-dimension")]
        4 => in_space::<4>(fields, by_lad_in_r4::gauge)?,
        other => return Err(refused("center", other, 4)),
    };
    let statuses: Value = answers.found.iter().map(|(status, _)| status.name()).collect();
    let gauges: Value = answers.found.iter().map(|(_, gauge)| to_json(*gauge)).collect();
    let result = json!({"status": statuses, "gauge": gauges, "build": answers.build, "query": answers.query});
    Ok(Solution { method, result })
}

fn in_space<const D: usize>(
    fields: &Fields<'_>,
    gauge: impl Fn(&Query<'_, D>, &mut OperationCounts) -> Gauge<D>,
) -> Result<Answers, Refusal> {
    // Without a pose, the image is the body itself.
    let body = Posed::<D>::read(fields, "center")?.image()?;
    let points = fields.vectors::<D>("points")?;
    refuse_many_pairs(points.len(), body.generators().len())?;
    let mut counts = OperationCounts::default();
    let found = points.into_iter().map(|point| {
        let question = Query::of_point(point, &body).expect("the numbers of a question are finite");
        let gauge = gauge(&question, &mut counts);
        (gauge.location.status(), gauge.value)
    });
    Ok(Answers { found: found.collect(), build: 0, query: total(&counts) })
}

fn refuse_many_pairs(points: usize, generators: usize) -> Result<(), Refusal> {
    if points.saturating_mul(generators) <= PAIR_LIMIT {
        return Ok(());
    }
    let message =
        format!("{points} points and {generators} generators make more than the {PAIR_LIMIT} pairs that are taken");
    Err(Refusal::new(Code::TooLarge, message))
}

fn under_pose<const D: usize>(fields: &Fields<'_>) -> Result<Answers, Refusal> {
    let body = Posed::<D>::read(fields, "center")?;
    let points = fields.vectors::<D>("points")?;
    refuse_many_pairs(points.len(), body.body.generators().len())?;
    let prism = Prism::over(&body, &Posed::of_point([0.0; D]));
    let mut counts = OperationCounts::default();
    let found = points.into_iter().map(|point| {
        let gauge = by_lad::nearest_gauge(&prism.query_of(point), &mut counts);
        (gauge.location.status(), gauge.value)
    });
    Ok(Answers { found: found.collect(), build: 0, query: total(&counts) })
}

/// A tree reads each generator a few times when it is built, which counts as one operation.
fn by_direction_tree(fields: &Fields<'_>) -> Result<Answers, Refusal> {
    let (body, points) = space(fields)?;
    let tree = DirectionTree::new(&body);
    let mut counts = OperationCounts::default();
    let found = points.into_iter().map(|point| {
        let measured = tree.gauge(point, &mut counts).expect("the numbers of a question are finite");
        (measured.location.status(), measured.nearest_value().0)
    });
    Ok(Answers { found: found.collect(), build: body.generators().len() as u64, query: total(&counts) })
}

/// With n generators, in a space of about n √n.
fn by_cutting(fields: &Fields<'_>, seed: u64) -> Result<Answers, Refusal> {
    let (body, points) = space_of_few(fields, BY_CUTTING, CUTTING_LIMIT)?;
    let generators = body.generators().len();
    let (mut build, mut counts) = (OperationCounts::default(), OperationCounts::default());
    let space = generators * generators.isqrt();
    let prepared = PreparedByCutting::new(body, space as u64, seed, &mut build)
        .expect("the space is between the number of generators and its square");
    let found = points.into_iter().map(|point| {
        let facet = prepared.facet(point, &mut counts).expect("the numbers of a question are finite");
        (facet.status(), facet.value().0)
    });
    Ok(Answers { found: found.collect(), build: total(&build), query: total(&counts) })
}

/// Building looks at every generator along every facet's normal, a query at every facet.
fn by_facets(fields: &Fields<'_>) -> Result<Answers, Refusal> {
    let (body, points) = space_of_few(fields, BY_FACETS, FACETS_LIMIT)?;
    let generators = body.generators().len();
    let facets = PreparedByFacets::new(body);
    let query = facets.facet_count() * points.len();
    let found = points.into_iter().map(|point| {
        let known = facets.status(point).and_then(|status| Ok((status, facets.gauge(point)?.0)));
        known.expect("the numbers of a question are finite")
    });
    let build = facets.facet_count() * generators;
    Ok(Answers { found: found.collect(), build: build as u64, query: query as u64 })
}

fn space_of_few(fields: &Fields<'_>, method: &str, limit: usize) -> Result<(Zonotope<3>, Vec<[f64; 3]>), Refusal> {
    let (body, points) = space(fields)?;
    let generators = body.generators().len();
    if generators > limit {
        let message = format!("{generators} generators, at most {limit} are taken by `{method}`");
        return Err(Refusal::new(Code::TooLarge, message));
    }
    Ok((body, points))
}

fn space(fields: &Fields<'_>) -> Result<(Zonotope<3>, Vec<[f64; 3]>), Refusal> {
    Ok((fields.zonotope()?, fields.vectors("points")?))
}

fn total(counts: &OperationCounts) -> u64 {
    counts.iter().map(|(_, count)| count).sum()
}

/// The amount of work says nothing about the points, so no check repeats it; but some counts cannot be.
fn check(input: Traced<'_>, result: Traced<'_>, method: Option<&str>) -> Result<verifier::Verdict, String> {
    let body = Placed::read(input, "center")?;
    let points = vectors(member(input, "points")?, "points")?;
    let list = |name| member(result, name)?.tree.list().ok_or_else(|| format!("`{name}` is not a list"));
    let (statuses, gauges) = (list("status")?, list("gauge")?);
    let [build, _] = [index(result, "build")?, index(result, "query")?];
    let prepared = match method {
        Some(BY_LAD) => Some(0),
        Some(BY_DIRECTION_TREE) => Some(body.body().generators.len()),
        _ => None,
    };
    if prepared.is_some_and(|prepared| build != prepared) {
        return Err(format!("`build` is {build}, which the method does not spend before the points"));
    }
    if statuses.len() != gauges.len() {
        return Err("`status` and `gauge` have different lengths".to_owned());
    }
    let answers = statuses.iter().zip(gauges).map(|(name, gauge)| {
        let name = name.text().ok_or("`status` holds something else than names")?;
        Ok((proof::status(name)?, gauge.float().ok_or("`gauge` holds something else than numbers")?))
    });
    let answers: Vec<(verifier::Status, f64)> = answers.collect::<Result<_, String>>()?;
    Ok(match verifier::check_member_batch(&body.body(), &points, &answers).in_words() {
        verifier::Verdict::Right(proved) => {
            verifier::Verdict::Right(format!("{proved}; `build` and `query` claim nothing"))
        }
        other => other,
    })
}
