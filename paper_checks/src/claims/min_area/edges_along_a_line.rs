//! Section 4.1: the edges of H on Z(O) as O moves along a line.

use dashu_ratio::RBig;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::plane::{Bisector, Point, bisectors, zonogon_about};
use crate::definitions::ratio::{fraction, integer};
use crate::instances::polygons::{generator, polygons, random_point};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "edges-along-a-line",
    place: Place { section: "4.1", label: "before Lemma 4.3" },
    kind: ClaimKind::Statement,
    statement: "From below along a vertical line in general position the edges of H on Z(O) are those of the upper \
        hull; where O crosses a line l_t upward, an edge of the upper hull disappears or one of the lower hull appears",
    code: &["zonotope::enclosing::bisectors"],
    check: Check::Run(check),
    tried: Tried::Scope("polygons and vertical lines in general position"),
    ..Claim::LISTED
};

/// Looks between any two crossings at the edges that Z(O) has by its definition.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 103);
    let (mut lines, mut crossed) = (0, 0);
    for instance in polygons(&mut random, 60) {
        let polygon = &instance.polygon;
        let all = bisectors(polygon);
        let is_general = all.iter().enumerate().all(|(index, line)| {
            line.edge.x != RBig::ZERO && all[..index].iter().all(|other| line.edge.cross(&other.edge) != RBig::ZERO)
        });
        if !is_general {
            continue;
        }
        let x = random_point(&mut random, 9).x + fraction(1, 1009);
        let mut events: Vec<(RBig, usize)> = (0..all.len()).map(|t| (height_at(&all[t], &x), t)).collect();
        events.sort();
        if events.windows(2).any(|pair| pair[0].0 == pair[1].0) {
            continue;
        }
        let mut on_zonogon: Vec<bool> = all.iter().map(|line| line.edge.x < RBig::ZERO).collect();
        for step in 0..=events.len() {
            if let Some((_, crossed)) = step.checked_sub(1).map(|last| &events[last]) {
                let is_upper = all[*crossed].edge.x < RBig::ZERO;
                if on_zonogon[*crossed] != is_upper {
                    return Verdict::Refuted(format!("{}: edge {crossed} at x = {x}", instance.name));
                }
                on_zonogon[*crossed] = !is_upper;
            }
            let center = Point::new(x.clone(), between(&events, step));
            if edges_of(polygon, &center) != on_zonogon {
                return Verdict::Refuted(format!("{}: the edges of Z(O) for O = {center}", instance.name));
            }
        }
        lines += 1;
        crossed += events.len();
    }
    Verdict::Holds(format!(
        "along {lines} vertical lines the edges of H on Z(O), by its definition, are those of the upper hull at first, \
         and change so at each of {crossed} crossings"
    ))
}

/// The ordinate at which a line that is not vertical meets the vertical line at x.
fn height_at(line: &Bisector, x: &RBig) -> RBig {
    &line.start.y + (x - &line.start.x) * &line.edge.y / &line.edge.x
}

/// An ordinate below all events, between two, or above all.
fn between(events: &[(RBig, usize)], step: usize) -> RBig {
    match (step.checked_sub(1).map(|last| &events[last].0), events.get(step).map(|event| &event.0)) {
        (Some(last), Some(next)) => (last + next) / integer(2),
        (Some(last), None) => last + integer(1),
        (None, Some(next)) => next - integer(1),
        (None, None) => integer(0),
    }
}

/// Of each edge of the polygon whether it is an edge of Z(O).
fn edges_of(polygon: &[Point], center: &Point) -> Vec<bool> {
    let zonogon = zonogon_about(polygon, center);
    let is_edge = |from: &Point, to: &Point| {
        (0..zonogon.len()).any(|k| zonogon[k] == *from && zonogon[(k + 1) % zonogon.len()] == *to)
    };
    (0..polygon.len()).map(|t| is_edge(&polygon[t], &polygon[(t + 1) % polygon.len()])).collect()
}
