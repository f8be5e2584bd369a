//! Pictures of zonotopes in space: their faces, the tiling with its dual arrangement.

use serde_json::{Value, json};
use zonotope::arrangement::tiling::by_face_lattice::{FacetTile, facet_tiling};
use zonotope::zonotope::Zonotope;
use zonotope::zonotope::faces::{Edge, FaceLattice, Faces, Facet, Zone, faces};

use super::picture::{Picture, vectors};
use super::sheet::{Part, Sheet, Table, index};
use crate::json::vector_to_json;
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

pub(super) fn refuse_many(body: &Zonotope<3>) -> Result<(), Refusal> {
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
fn no_facets(dimension: u8, points: &[[f64; 3]], zone: &[usize]) -> Sheet {
    let edges = if zone.is_empty() { json!([]) } else { json!([{"ends": [0, 1], "zone": 0, "facets": [null, null]}]) };
    let zones = if zone.is_empty() { json!([]) } else { json!([zone]) };
    let content = json!({
        "dimension": dimension,
        "vertices": vectors(points),
        "edges": edges,
        "facets": [],
        "facet_zones": [],
        "opposite_facets": [],
        "zones": zones,
    });
    content.into()
}

fn of_lattice(dimension: u8, lattice: &FaceLattice) -> Sheet {
    let facets = || (0..lattice.facet_count() as u32).map(Facet);
    let edges = || (0..lattice.edge_count() as u32).map(Edge);
    let zones: Vec<Vec<usize>> = (0..lattice.zone_count() as u32)
        .map(|zone| lattice.zone_generators(Zone(zone)).map(|member| member.generator).collect())
        .collect();
    Sheet::new([
        ("dimension", Part::Plain(dimension.into())),
        ("vertices", Part::Table(Table::vectors(lattice.points()))),
        (
            "edges",
            Part::Records(vec![
                ("ends", Table::pairs(edges().map(|edge| lattice.edge_ends(edge).map(|vertex| vertex.0)))),
                ("zone", Table::indices(edges().map(|edge| lattice.edge_zone(edge).0))),
                ("facets", Table::pairs(edges().map(|edge| lattice.edge_facets(edge).map(|facet| facet.0)))),
            ]),
        ),
        ("facets", Part::Table(Table::rows(facets().map(|f| lattice.facet_vertices(f).map(|vertex| vertex.0))))),
        ("facet_zones", Part::Table(Table::rows(facets().map(|f| lattice.facet_zones(f).map(|zone| zone.0))))),
        ("opposite_facets", Part::Table(Table::indices(facets().map(|facet| lattice.opposite_facet(facet).0)))),
        ("zones", Part::Plain(json!(zones))),
    ])
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
        let place = |place: Option<usize>| place.map(index);
        let edges = || tiling.edges.iter();
        let tiles = || tiling.tiles.iter();
        let rows =
            |row: fn(&FacetTile) -> &[usize]| Table::rows(tiles().map(|tile| row(tile).iter().copied().map(index)));
        Ok(Sheet::new([
            ("classes", Part::Plain(classes.collect())),
            ("zero", Part::Plain(json!(zero))),
            ("vertices", Part::Table(Table::vectors(&tiling.vertices))),
            (
                "edges",
                Part::Records(vec![
                    ("class", Table::indices(edges().map(|edge| index(edge.class)))),
                    ("ends", Table::pairs(edges().map(|edge| [edge.upper, edge.lower].map(index)))),
                    ("tiles", Table::pairs(edges().map(|edge| [edge.left, edge.right].map(place)))),
                ]),
            ),
            (
                "tiles",
                Part::Records(vec![
                    ("classes", rows(|tile| &tile.classes)),
                    ("left", rows(|tile| &tile.left)),
                    ("right", rows(|tile| &tile.right)),
                    ("dual", Table::vectors(tiles().map(|tile| &tile.dual))),
                    ("facet", Table::indices(tiles().map(|tile| tile.facet.0))),
                ]),
            ),
            ("left_side", Part::Plain(json!(tiling.left_side))),
            ("vertical_facets", Part::Plain(json!(tiling.vertical_facets))),
        ]))
    },
};
