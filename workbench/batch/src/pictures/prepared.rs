//! Pictures of what is prepared for many questions: a cutting with its image in the tiling, the tree over directions,
//! the hierarchy.

use std::num::NonZeroU32;

use serde_json::{Value, json};
use zonotope::DEFAULT_SEED;
use zonotope::arrangement::LineArrangement;
use zonotope::arrangement::cutting::{Cutting, cutting};
use zonotope::arrangement::tiling::by_face_lattice::{FacetTile, FacetTiling, facet_tiling};
use zonotope::collision::hierarchy::Hierarchy;
use zonotope::collision::prepared::DirectionTree;
use zonotope::zonotope::Zonotope;

use super::picture::{Picture, vectors};
use super::sheet::Sheet;
use super::space::refuse_many;
use crate::fields::Fields;
use crate::refusal::{Code, Refusal};

/// The part of the size of the arrangement that the window of a cutting leaves around the crossings.
const MARGIN: f64 = 0.15;

/// The distance from a crossing, as a part of the size of the arrangement, at which its faces are looked for.
const BESIDE: f64 = 1e-6;

pub(super) const CUTTING: Picture = Picture {
    name: "cutting",
    summary: "a (1/r)-cutting of the lines of generators, and the corners of tiles that each trapezoid holds",
    fields: &["generators", "r"],
    draw: cutting_and_image,
};

fn cutting_and_image(fields: &Fields<'_>) -> Result<Sheet, Refusal> {
    let body = Zonotope::new([0.0; 3], fields.vectors("generators")?).expect("the numbers of a question are finite");
    refuse_many(&body)?;
    let r = u32::try_from(fields.count("r")?).ok().and_then(NonZeroU32::new);
    let r = r.ok_or_else(|| Refusal::bad_input("r is not a whole number from 1 to 2^32"))?;
    let tiling = facet_tiling(&body).map_err(|error| Refusal::new(Code::TooLarge, error.to_string()))?;
    let rows: Vec<[f64; 3]> =
        tiling.classes.iter().filter(|class| !class.is_vertical).map(|class| class.line).collect();
    let lines = LineArrangement::from_rows(&rows).map_err(|error| Refusal::bad_input(error.to_string()))?;
    let cut = cutting(&lines, r, DEFAULT_SEED, &mut ());
    let (window, size) = window(&tiling);
    let outlines: Value =
        cut.trapezoids().iter().map(|trapezoid| vectors(&trapezoid.outline(&lines, window))).collect();
    let images: Vec<Vec<Option<u32>>> =
        tiling.tiles.iter().map(|tile| beside(tile, &tiling, &cut, BESIDE * size)).collect();
    let content = json!({
        "limit": cut.limit(),
        "window": vectors(&window),
        "trapezoids": outlines,
        "images": images,
    });
    Ok(content.into())
}

/// A box around all crossings, and its longer side.
fn window(tiling: &FacetTiling) -> ([[f64; 2]; 2], f64) {
    let duals = || tiling.tiles.iter().map(|tile| tile.dual);
    let least = duals().fold([f64::INFINITY; 2], |least, dual| [0, 1].map(|k| least[k].min(dual[k])));
    let most = duals().fold([f64::NEG_INFINITY; 2], |most, dual| [0, 1].map(|k| most[k].max(dual[k])));
    let size = (most[0] - least[0]).max(most[1] - least[1]);
    if !(size > 0.0 && size.is_finite()) {
        let [x, y] = if least[0].is_finite() { least } else { [0.0; 2] };
        return ([[x - 1.0, y - 1.0], [x + 1.0, y + 1.0]], 1.0);
    }
    let margin = MARGIN * size;
    ([least.map(|low| low - margin), most.map(|high| high + margin)], size)
}

/// The trapezoid that holds the face of each corner of a tile near its crossing; the corners in order around the tile.
fn beside(tile: &FacetTile, tiling: &FacetTiling, cut: &Cutting<'_>, distance: f64) -> Vec<Option<u32>> {
    let within = tile.right.iter().rev().skip(1).take(tile.right.len().saturating_sub(2));
    let around: Vec<[f64; 2]> = tile.left.iter().chain(within).map(|&place| flat(tiling.vertices[place])).collect();
    let count = around.len();
    let middle = [0, 1].map(|k| around.iter().map(|corner| corner[k]).sum::<f64>() / count as f64);
    let corner = |place: usize| {
        let normals = [(place + count - 1) % count, place].map(|edge| {
            let [from, to] = [around[edge], around[(edge + 1) % count]];
            let normal = unit([to[1] - from[1], from[0] - to[0]]);
            let out = normal[0] * (from[0] - middle[0]) + normal[1] * (from[1] - middle[1]);
            if out < 0.0 { normal.map(|c| -c) } else { normal }
        });
        let outward = unit([0, 1].map(|k| normals[0][k] + normals[1][k]));
        let place = [0, 1].map(|k| tile.dual[k] + distance * outward[k]);
        cut.locate(place).ok().map(|trapezoid| trapezoid.0)
    };
    (0..count).map(corner).collect()
}

fn flat([x, y, _]: [f64; 3]) -> [f64; 2] {
    [x, y]
}

fn unit(vector: [f64; 2]) -> [f64; 2] {
    let length = vector[0].hypot(vector[1]);
    vector.map(|c| c / length)
}

pub(super) const DIRECTION_TREE: Picture = Picture {
    name: "direction_tree",
    summary: "the generators of each leaf of the tree over directions, by their indices",
    fields: &["generators"],
    draw: |fields| {
        let body =
            Zonotope::new([0.0; 3], fields.vectors("generators")?).expect("the numbers of a question are finite");
        let tree = DirectionTree::new(&body);
        let leaves: Vec<&[u32]> = tree.leaves().collect();
        Ok(json!({"leaves": leaves}).into())
    },
};

pub(super) const HIERARCHY: Picture = Picture {
    name: "hierarchy",
    summary: "the levels of two bodies, the coarsest first, and how far down it is decided whether they meet",
    fields: &["a", "b"],
    draw: |fields| {
        let [a, b] = ["a", "b"].map(|name| {
            let body = fields.object(name, &["center", "generators"], &[])?.zonotope::<3>()?;
            refuse_many(&body)?;
            Ok(Hierarchy::new(body))
        });
        let (a, b) = (a?, b?);
        let descent = a.intersection(&b, &mut ());
        let levels = |hierarchy: &Hierarchy| -> Value {
            let bodies = (0..hierarchy.level_count()).map(|level| hierarchy.outer(level).body());
            bodies.map(|body| json!({"center": body.center(), "generators": vectors(body.generators())})).collect()
        };
        let content = json!({
            "a": levels(&a),
            "b": levels(&b),
            "status": descent.status().name(),
            "levels": descent.levels(),
            "visited": descent.visited(),
            "generators_read": descent.generators_read(),
        });
        Ok(content.into())
    },
};
