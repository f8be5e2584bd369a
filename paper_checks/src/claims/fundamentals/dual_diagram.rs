//! The duality of Figure 1.

use std::collections::{BTreeMap, BTreeSet};

use dashu_ratio::RBig;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::plane::Point;
use crate::definitions::ratio::integer;
use crate::definitions::space::Body;
use crate::definitions::upper_hull::{UpperFacet, line_value, project};
use crate::instances::bodies::tilings;
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "tiling-arrangement-duality",
    place: Place { section: "3", label: "second paragraph" },
    kind: ClaimKind::Statement,
    statement: "The dual diagram of the tiling is isomorphic to the arrangement of the lines P_i with z = 1: tiles to \
        vertices, tiling edges to edges, tiling vertices to faces",
    code: &["zonotope::arrangement"],
    figures: &["paper-figure-1", "duality-family"],
    check: Check::Run(check),
    tried: Tried::Scope("bodies in general position"),
    ..Claim::LISTED
};

/// Builds the arrangement from its lines and the tiling from the facets, and compares vertices, edges and faces.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 43);
    let (mut tiles, mut edges, mut faces) = (0, 0, 0);
    let instances = tilings(&mut random, 35);
    for (instance, body, facets) in &instances {
        let compared = vertices(body, facets)
            .and_then(|count| Ok((count, self::edges(body, facets)?)))
            .and_then(|(tiles, edges)| Ok((tiles, edges, self::faces(body, facets)?)));
        match compared {
            Err(reason) => return Verdict::Refuted(format!("{}: {reason}", instance.name)),
            Ok((more_tiles, more_edges, more_faces)) => {
                tiles += more_tiles;
                edges += more_edges;
                faces += more_faces;
            }
        }
    }
    Verdict::Holds(format!(
        "{} bodies in general position: {tiles} tiles are the crossings of their two lines and of no other, {edges} \
         edges between tiles are those between neighbours on a line and each line has two unbounded ones, and {faces} \
         tiling vertices have the signs of the faces",
        instances.len()
    ))
}

/// The normal of a tile's facet is where the lines of its two generators cross, and no other line passes there.
fn vertices(body: &Body, facets: &[UpperFacet]) -> Result<usize, String> {
    for facet in facets {
        for (index, generator) in body.generators.iter().enumerate() {
            let on_line = line_value(generator, &facet.crossing) == RBig::ZERO;
            if on_line != facet.pair.contains(&index) {
                return Err(format!("line {index} at the crossing {} of {:?}", facet.crossing, facet.pair));
            }
        }
    }
    Ok(facets.len())
}

/// Tiles share an edge along a generator just when their crossings are neighbours on its line.
fn edges(body: &Body, facets: &[UpperFacet]) -> Result<usize, String> {
    let mut count = 0;
    for (index, generator) in body.generators.iter().enumerate() {
        let on_line: Vec<&UpperFacet> = facets.iter().filter(|facet| facet.pair.contains(&index)).collect();
        let mut along = on_line.clone();
        let direction = Point::new(-&generator.0[1], generator.0[0].clone());
        let position = |facet: &UpperFacet| &direction.x * &facet.crossing.x + &direction.y * &facet.crossing.y;
        along.sort_by_key(|facet| position(facet));
        let neighbours: BTreeSet<[[usize; 2]; 2]> =
            along.windows(2).map(|pair| sorted([pair[0].pair, pair[1].pair])).collect();

        let step = project(generator);
        let mut at_edge: BTreeMap<[Point; 2], Vec<[usize; 2]>> = BTreeMap::new();
        for facet in &on_line {
            for k in 0..4 {
                let (from, to) = (&facet.tile[k], &facet.tile[(k + 1) % 4]);
                if from.to(to).cross(&step) == RBig::ZERO {
                    at_edge.entry(sorted([from.clone(), to.clone()])).or_default().push(facet.pair);
                }
            }
        }
        let mut shared = BTreeSet::new();
        let mut unbounded = 0;
        for tiles in at_edge.values() {
            match tiles[..] {
                [_] => unbounded += 1,
                [one, other] => {
                    shared.insert(sorted([one, other]));
                }
                _ => return Err(format!("an edge of {} tiles", tiles.len())),
            }
        }
        if shared != neighbours || unbounded != 2 {
            return Err(format!("line {index}: {shared:?} and {neighbours:?}, {unbounded} unbounded edges"));
        }
        count += shared.len();
    }
    Ok(count)
}

/// The signs of the lines on a face, as coefficients of the generators, give the tiling's vertices, each once.
fn faces(body: &Body, facets: &[UpperFacet]) -> Result<usize, String> {
    let n = body.generators.len();
    let mut signs = BTreeSet::new();
    for facet in facets {
        let around: Vec<i64> = body
            .generators
            .iter()
            .map(|generator| if line_value(generator, &facet.crossing) < RBig::ZERO { -1 } else { 1 })
            .collect();
        for both in [[1, 1], [1, -1], [-1, 1], [-1, -1]] {
            let mut face = around.clone();
            for (index, sign) in facet.pair.into_iter().zip(both) {
                face[index] = sign;
            }
            signs.insert(face);
        }
    }
    let vertex = |face: &Vec<i64>| {
        let start = project(&body.center);
        face.iter().zip(&body.generators).fold(start, |sum, (&sign, g)| sum.plus(&integer(sign), &project(g)))
    };
    let from_faces: BTreeSet<Point> = signs.iter().map(vertex).collect();
    let of_tiles: BTreeSet<Point> = facets.iter().flat_map(|facet| facet.tile.clone()).collect();
    let expected = 1 + n + n * (n - 1) / 2;
    if from_faces == of_tiles && signs.len() == expected && of_tiles.len() == expected {
        Ok(expected)
    } else {
        Err(format!("{} faces, {} vertices, expected {expected}", signs.len(), of_tiles.len()))
    }
}

fn sorted<T: Ord>(mut pair: [T; 2]) -> [T; 2] {
    pair.sort();
    pair
}
