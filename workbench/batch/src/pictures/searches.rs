//! Pictures of searches, step by step.

use serde_json::{Value, json};
use zonotope::DEFAULT_SEED;
use zonotope::collision::Query;
use zonotope::collision::by_slope_selection::{self, Hull as SearchedHull, Side as ChainSide};
use zonotope::lad::by_slope_selection::Side;

use super::lines_of_hull::Hull;
use super::picture::{Picture, optional, vectors};
use super::sheet::Sheet;
use crate::fields::Fields;
use crate::json::{to_json, vector_to_json};
use crate::refusal::{Code, Refusal};

/// The most lines of which all vertices are listed.
const LISTED_LINE_LIMIT: usize = 100;

pub(super) const THEOREM_4_5: Picture = Picture {
    name: "search_of_theorem_4_5",
    summary: "the vertical lines that the search for the best centre draws, and the vertices that it searches",
    fields: &["points"],
    draw: least_area_search,
};

fn least_area_search(fields: &Fields<'_>) -> Result<Sheet, Refusal> {
    let hull = Hull::of(fields)?;
    let bisectors = hull.bisectors();
    let mut content = hull.to_json();
    if !hull.hull.has_area() {
        content["steps"] = json!([]);
        return Ok(content.into());
    }
    let steps = bisectors.search_by_slope_selection(DEFAULT_SEED);
    content["steps"] = steps
        .iter()
        .map(|step| {
            json!({
                "x": to_json(step.x),
                "candidates": step.vertices_before,
                "left": step.vertices_after,
                "minimum": optional(step.minimum, |point| vector_to_json(&point)),
                "side": match step.side {
                    Side::Left => "left",
                    Side::Optimal => "optimal",
                    Side::Right => "right",
                    Side::Unbounded => "unbounded",
                },
            })
        })
        .collect();
    if hull.hull.edge_count() <= LISTED_LINE_LIMIT {
        let points: Vec<[f64; 2]> = bisectors.candidates().iter().map(|candidate| candidate.point).collect();
        content["vertices"] = vectors(&points);
    }
    Ok(content.into())
}

pub(super) const PRUNING: Picture = Picture {
    name: "pruning",
    summary: "the cells of the search for the best centre by pruning, with the lines that may cross each",
    fields: &["points", "line_search_limit"],
    draw: pruning,
};

fn pruning(fields: &Fields<'_>) -> Result<Sheet, Refusal> {
    let hull = Hull::of(fields)?;
    let limit = fields.count("line_search_limit")?;
    let limit = usize::try_from(limit).map_err(|_| Refusal::new(Code::TooLarge, format!("{limit} lines")))?;
    let mut content = hull.to_json();
    let cells = if hull.hull.has_area() { hull.bisectors().search_by_pruning(limit, DEFAULT_SEED) } else { Vec::new() };
    content["cells"] = cells
        .iter()
        .map(|cell| json!({"lines": cell.lines, "crossing": cell.crossing, "corners": vectors(&cell.corners)}))
        .collect();
    Ok(content.into())
}

pub(super) const THEOREM_5_2: Picture = Picture {
    name: "search_of_theorem_5_2",
    summary: "the separators that the search for a point draws, and the tiles in which it ends",
    fields: &["point", "center", "generators"],
    draw: separator_search,
};

fn separator_search(fields: &Fields<'_>) -> Result<Sheet, Refusal> {
    let body = fields.zonotope::<3>()?;
    let query = Query::of_point(fields.vector("point")?, &body).expect("the numbers of a question are finite");
    let trace = by_slope_selection::trace(&query, DEFAULT_SEED);
    let hull = |hull: SearchedHull| match hull {
        SearchedHull::Upper => "upper",
        SearchedHull::Lower => "lower",
    };
    let steps = trace.steps.iter().map(|step| {
        json!({
            "hull": hull(step.hull),
            "x": to_json(step.x),
            "tiles": step.tiles_before,
            "left": step.tiles_after,
            "side": match step.side {
                ChainSide::Left => "left",
                ChainSide::Within => "within",
                ChainSide::Right => "right",
            },
            "chains": step.chains.each_ref().map(|chain| vectors(chain)),
        })
    });
    let found = trace.tiles.iter().map(|tile| {
        json!({
            "hull": hull(tile.hull),
            "generators": tile.generators,
            "corners": vectors(&tile.corners),
            "depth": to_json(tile.depth),
        })
    });
    let content = json!({
        "status": trace.location.status().name(),
        "swapped": trace.swapped,
        "steps": steps.collect::<Value>(),
        "found": found.collect::<Value>(),
    });
    Ok(content.into())
}
