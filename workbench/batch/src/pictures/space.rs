//! Pictures of zonotopes in space: their faces, the tiling with its dual arrangement, the plane of directions.

use serde_json::{Value, json};
use zonotope::arrangement::tiling::by_face_lattice::{FacetTile, TileEdge, facet_tiling};
use zonotope::collision::Query;
use zonotope::collision::by_lad::direction_plane;
use zonotope::zonotope::Zonotope;
use zonotope::zonotope::faces::{Edge, FaceLattice, Faces, Facet, Zone, faces};

use super::picture::{Picture, optional, vectors};
use crate::json::{to_json, vector_to_json};
use crate::refusal::{Code, Refusal};

/// The most generators whose faces are listed.
const LISTED_GENERATOR_LIMIT: usize = 500;

pub(super) const FACES: Picture = Picture {
    name: "faces",
    summary: "the vertices, edges, facets and zones of a zonotope in space",
    fields: &["center", "generators"],
    draw: |fields| {
        let body = fields.zonotope::<3>()?;
        refuse_many(&body)?;
        let faces = faces(&body, &mut ()).map_err(|error| Refusal::new(Code::TooLarge, error.to_string()))?;
        Ok(match faces {
            Faces::Point(point) => no_facets(0, &[point], &[]),
            Faces::Segment(ends) => no_facets(1, &ends, &nonzero(&body)),
            Faces::Flat(lattice) => of_lattice(2, &lattice),
            Faces::Solid(lattice) => of_lattice(3, &lattice),
        })
    },
};

fn refuse_many(body: &Zonotope<3>) -> Result<(), Refusal> {
    let count = body.generators().len();
    if count <= LISTED_GENERATOR_LIMIT {
        return Ok(());
    }
    let message = format!("{count} generators, of at most {LISTED_GENERATOR_LIMIT} all faces are listed");
    Err(Refusal::new(Code::TooLarge, message))
}

fn nonzero(body: &Zonotope<3>) -> Vec<usize> {
    let generators = body.generators().iter().enumerate();
    generators.filter(|(_, generator)| **generator != [0.0; 3]).map(|(index, _)| index).collect()
}

/// A point, or a segment, which is an edge of one zone.
fn no_facets(dimension: u8, points: &[[f64; 3]], zone: &[usize]) -> Value {
    let edges = if zone.is_empty() { json!([]) } else { json!([{"ends": [0, 1], "zone": 0, "facets": [null, null]}]) };
    let zones = if zone.is_empty() { json!([]) } else { json!([zone]) };
    json!({
        "dimension": dimension,
        "vertices": vectors(points),
        "edges": edges,
        "facets": [],
        "facet_zones": [],
        "opposite_facets": [],
        "zones": zones,
    })
}

fn of_lattice(dimension: u8, lattice: &FaceLattice) -> Value {
    let facets = || (0..lattice.facet_count() as u32).map(Facet);
    let edges = (0..lattice.edge_count() as u32).map(Edge).map(|edge| {
        json!({
            "ends": lattice.edge_ends(edge).map(|vertex| vertex.0),
            "zone": lattice.edge_zone(edge).0,
            "facets": lattice.edge_facets(edge).map(|facet| facet.0),
        })
    });
    let loops: Vec<Vec<u32>> =
        facets().map(|facet| lattice.facet_vertices(facet).map(|vertex| vertex.0).collect()).collect();
    let facet_zones: Vec<Vec<u32>> =
        facets().map(|facet| lattice.facet_zones(facet).map(|zone| zone.0).collect()).collect();
    let zones: Vec<Vec<usize>> = (0..lattice.zone_count() as u32)
        .map(|zone| lattice.zone_generators(Zone(zone)).map(|member| member.generator).collect())
        .collect();
    json!({
        "dimension": dimension,
        "vertices": vectors(lattice.points()),
        "edges": edges.collect::<Value>(),
        "facets": loops,
        "facet_zones": facet_zones,
        "opposite_facets": facets().map(|facet| lattice.opposite_facet(facet).0).collect::<Vec<u32>>(),
        "zones": zones,
    })
}

pub(super) const TILING: Picture = Picture {
    name: "tiling",
    summary: "the tiling by the facets of the upper hull, with the dual arrangement, for generators in any position",
    fields: &["generators"],
    draw: |fields| {
        let body =
            Zonotope::new([0.0; 3], fields.vectors("generators")?).expect("the numbers of a question are finite");
        refuse_many(&body)?;
        let tiling = facet_tiling(&body).map_err(|error| Refusal::new(Code::TooLarge, error.to_string()))?;
        let nonzero = nonzero(&body);
        let zero: Vec<usize> = (0..body.generators().len()).filter(|index| !nonzero.contains(index)).collect();
        let classes = tiling.classes.iter().map(|class| {
            let line = if class.is_vertical { Value::Null } else { vector_to_json(&class.line) };
            json!({"generators": class.generators, "line": line})
        });
        let edge = |edge: &TileEdge| {
            let [ends, tiles] = [json!([edge.upper, edge.lower]), json!([edge.left, edge.right])];
            json!({"class": edge.class, "ends": ends, "tiles": tiles})
        };
        let tile = |tile: &FacetTile| {
            json!({
                "classes": tile.classes,
                "left": tile.left,
                "right": tile.right,
                "dual": vector_to_json(&tile.dual),
                "facet": tile.facet.0,
            })
        };
        Ok(json!({
            "classes": classes.collect::<Value>(),
            "zero": zero,
            "vertices": vectors(&tiling.vertices),
            "edges": tiling.edges.iter().map(edge).collect::<Value>(),
            "tiles": tiling.tiles.iter().map(tile).collect::<Value>(),
            "left_side": tiling.left_side,
            "vertical_facets": tiling.vertical_facets,
        }))
    },
};

pub(super) const PLANE_OF_DIRECTIONS: Picture = Picture {
    name: "plane_of_directions",
    summary: "the kernel's plane of directions: the line of each generator, and the optimum",
    fields: &["point", "center", "generators"],
    draw: |fields| {
        let body = fields.zonotope::<3>()?;
        let query = Query::of_point(fields.vector("point")?, &body).expect("the numbers of a question are finite");
        let Some(plane) = direction_plane(&query) else {
            let message = "the point is the centre, or farther from it than doubles reach: there is no plane";
            return Err(Refusal::bad_input(message));
        };
        Ok(json!({
            "displacement": vector_to_json(&plane.displacement),
            "origin": vector_to_json(&plane.origin),
            "axes": vectors(&plane.axes),
            "lines": vectors(&plane.lines),
            "optimum": optional(plane.optimum, |point| vector_to_json(&point)),
            "gauge": to_json(plane.gauge),
        }))
    },
};
