//! The order of the tiles.

use dashu_ratio::RBig;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::plane::Point;
use crate::instances::bodies::tilings;
use crate::instances::polygons::generator;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "separator-order",
    place: Place { section: "5.1", label: "separators" },
    kind: ClaimKind::Statement,
    statement: "Numbering the tiles by the x order of the dual vertices is consistent with the right-to relation of \
        the tiling",
    remedy: Some(
        "the order of tiles of equal x is free, as none is to the right of another: but where a line is vertical, its \
            tiles go by y",
    ),
    code: &["zonotope::arrangement"],
    figures: &["paper-figure-1", "separators"],
    check: Check::Run(check),
    tried: Tried::Scope("bodies in general position"),
};

/// Of two tiles with a common edge that is not horizontal, the one on its right has the larger dual x.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 44);
    let mut edges = 0;
    let instances = tilings(&mut random, 35);
    for (instance, _, facets) in &instances {
        for right in facets {
            for (from, to) in rising_edges(&right.tile, -1) {
                let left =
                    facets.iter().find(|facet| rising_edges(&facet.tile, 1).contains(&(from.clone(), to.clone())));
                if let Some(left) = left {
                    if left.crossing.x >= right.crossing.x {
                        return Verdict::Refuted(format!(
                            "{}: tiles {:?} and {:?}",
                            instance.name, left.pair, right.pair
                        ));
                    }
                    edges += 1;
                }
            }
        }
    }
    Verdict::Holds(format!(
        "{} tilings: across each of {edges} edges that are not horizontal the tile on the right has the dual vertex \
         with the larger x, and so the order of x extends the right-to relation",
        instances.len()
    ))
}

/// The sides of a tile, lower end first, that have it on their left (`side` 1: counter-clockwise they rise) or right
/// (−1: they fall).
fn rising_edges(tile: &[Point], side: i64) -> Vec<(Point, Point)> {
    let edges = (0..tile.len()).map(|k| (tile[k].clone(), tile[(k + 1) % tile.len()].clone()));
    edges
        .filter_map(|(from, to)| {
            let rise = &to.y - &from.y;
            if rise == RBig::ZERO || (rise > RBig::ZERO) != (side > 0) {
                return None;
            }
            Some(if side > 0 { (from, to) } else { (to, from) })
        })
        .collect()
}
