//! Pictures of zonogons, and of the area f(O) of Z(O).

use serde_json::{Value, json};
use zonotope::enclosing::area_function::{AreaFunction, Bend};
use zonotope::enclosing::centered_zonogon::CenteredZonogon;

use super::lines_of_hull::Hull;
use super::picture::{Picture, vectors};
use super::sheet::Sheet;
use crate::fields::Fields;
use crate::json::{to_json, vector_to_json};
use crate::refusal::Refusal;

pub(super) const ZONOGON: Picture = Picture {
    name: "zonogon",
    summary: "the vertices of a zonotope of the plane",
    fields: &["center", "generators"],
    draw: |fields| Ok(json!({"vertices": vectors(&fields.zonotope::<2>()?.vertices())}).into()),
};

pub(super) const CENTERED_ZONOGON: Picture = Picture {
    name: "centered_zonogon",
    summary: "the smallest zonogon with a given centre around points, with the lines at which it changes",
    fields: &["points", "center"],
    draw: centered_zonogon,
};

fn centered_zonogon(fields: &Fields<'_>) -> Result<Sheet, Refusal> {
    let hull = Hull::of(fields)?;
    let zonogon = CenteredZonogon::new(&hull.hull, &hull.farthest, fields.vector::<2>("center")?, &mut ());
    let places = zonogon.boundary().zip(zonogon.vertices());
    let boundary = places.map(|(vertex, point)| {
        json!({
            "point": vector_to_json(&point),
            "source": hull.hull.indices()[vertex.vertex.get()].get(),
            "reflected": vertex.reflected,
        })
    });
    let mut content = hull.to_json();
    content["area"] = to_json(zonogon.exact_area().to_f64());
    content["boundary"] = boundary.collect();
    Ok(content.into())
}

pub(super) const LEVEL_SETS: Picture = Picture {
    name: "level_sets",
    summary: "the polygons of the centres for which the smallest zonogon has at most given areas",
    fields: &["points", "levels"],
    draw: |fields| {
        let hull = Hull::of(fields)?;
        let sets = AreaFunction::new(&hull.hull, &hull.farthest).level_sets(&fields.numbers("levels")?);
        let polygons: Vec<Value> = sets.iter().map(|polygon| vectors(polygon)).collect();
        Ok(json!({"polygons": polygons}).into())
    },
};

pub(super) const AREA_ALONG: Picture = Picture {
    name: "area_along",
    summary: "the area of the smallest zonogon while its centre goes from one point to another, at its bends",
    fields: &["points", "from", "to"],
    draw: |fields| {
        let hull = Hull::of(fields)?;
        let bends = AreaFunction::new(&hull.hull, &hull.farthest).along(fields.vector("from")?, fields.vector("to")?);
        let list = |number: fn(&Bend) -> f64| -> Value { bends.iter().map(|bend| to_json(number(bend))).collect() };
        Ok(json!({"at": list(|bend| bend.at), "area": list(|bend| bend.area)}).into())
    },
};
