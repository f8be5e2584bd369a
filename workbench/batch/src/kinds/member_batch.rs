//! `member_batch`: where many points lie relative to one zonotope.

use serde_json::{Value, json};
use zonotope::collision::{Gauge, Query, by_lad, by_lad_in_r4};
use zonotope::tally::OperationCounts;

use super::{Kind, Solution};
use crate::dimension::refused;
use crate::fields::Fields;
use crate::json::to_json;
use crate::refusal::{Code, Refusal};

pub(super) const KIND: Kind = Kind {
    name: "member_batch",
    summary: "status and gauge of many points relative to one zonotope",
    fields: &["center", "generators", "points"],
    optional: &[],
    methods: || vec![BY_LAD],
    solve,
};

const BY_LAD: &str = "by_lad";

/// The most pairs of a point and a generator that are taken.
const PAIR_LIMIT: usize = 1_000_000_000;

fn solve(fields: &Fields<'_>, _method: Option<&'static str>, _seed: u64) -> Result<Solution, Refusal> {
    match fields.dimension("center")? {
        1 => in_space::<1>(fields, |query, counts| by_lad::gauge_counted(query, counts)),
        2 => in_space::<2>(fields, |query, counts| by_lad::gauge_counted(query, counts)),
        3 => in_space::<3>(fields, |query, counts| by_lad::gauge_counted(query, counts)),
        4 => in_space::<4>(fields, by_lad_in_r4::gauge_counted),
        other => Err(refused("center", other, 4)),
    }
}

fn in_space<const D: usize>(
    fields: &Fields<'_>,
    gauge: impl Fn(&Query<'_, D>, &mut OperationCounts) -> Gauge<D>,
) -> Result<Solution, Refusal> {
    let body = fields.zonotope::<D>()?;
    let points = fields.vectors::<D>("points")?;
    let generators = body.generators().len();
    if points.len().saturating_mul(generators) > PAIR_LIMIT {
        let message = format!(
            "{} points and {generators} generators make more than the {PAIR_LIMIT} pairs that are taken",
            points.len()
        );
        return Err(Refusal::new(Code::TooLarge, message));
    }
    let mut counts = OperationCounts::default();
    let (mut statuses, mut gauges): (Vec<Value>, Vec<Value>) = (Vec::new(), Vec::new());
    for point in points {
        let question = Query::of_point(point, &body).expect("the numbers of a question are finite");
        let found = gauge(&question, &mut counts);
        statuses.push(found.location.status().name().into());
        gauges.push(to_json(found.value));
    }
    let query: u64 = counts.iter().map(|(_, count)| count).sum();
    // Nothing is prepared: each point is a question of its own.
    Ok(Solution { method: BY_LAD, result: json!({"status": statuses, "gauge": gauges, "build": 0, "query": query}) })
}
