//! Lemma 4.2: f restricted to a line in O(n log n).

use dashu_ratio::RBig;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::definitions::plane::{Bisector, Point, bisectors, zonogon_area};
use crate::definitions::ratio::integer;
use crate::instances::polygons::{generator, parabola_polygon, polygons, random_center, random_point};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "lemma-4.2",
    place: Place { section: "4.1", label: "Lemma 4.2" },
    kind: ClaimKind::Lemma,
    statement: "The restriction of f to any line can be computed in O(n log n) time: sort the crossings with the lines \
        l_t, then add one slope at each",
    code: &["zonotope::lad::of_lines::by_slope_selection", "zonotope::lad::of_lines::by_line_search"],
    check: Check::Run(check),
    tried: Tried::Growth(&["polygons with vertices in a parabola"]),
    ..Claim::LISTED
};

/// f along a line: its breaks in order, and its slope before the first and after each.
struct Restriction {
    breaks: Vec<RBig>,
    slopes: Vec<RBig>,
    comparisons: usize,
}

/// Builds restrictions as the lemma says, compares them with f, and counts comparisons against n log2 n.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 10);
    let mut breaks = 0;
    for instance in polygons(&mut random, 30) {
        let polygon = &instance.polygon;
        let lines = bisectors(polygon);
        let through = random_center(&mut random, polygon);
        let mut directions = vec![random_point(&mut random, 5), Point::at(0, 1), Point::at(1, 0)];
        directions.push(lines[0].edge.clone());
        for direction in directions.into_iter().filter(|direction| *direction != Point::at(0, 0)) {
            let restriction = restrict(&lines, &through, &direction);
            let f = |along: &RBig| zonogon_area(polygon, &through.plus(along, &direction));
            if let Some(place) = first_mismatch(&restriction, f) {
                return Verdict::Refuted(format!("{} at {place} along {direction} from {through}", instance.name));
            }
            breaks += restriction.breaks.len();
        }
    }
    let mut growth = Vec::new();
    for exponent in [4, 6, 8, 10] {
        let n = 1 << exponent;
        let polygon = parabola_polygon(&mut random, n);
        let restriction = restrict(&flat_bisectors(&polygon), &Point::at(1, 1), &Point::at(3, 7));
        if restriction.comparisons > n * exponent {
            return Verdict::Refuted(format!("{} comparisons for n = {n}", restriction.comparisons));
        }
        growth.push(format!("{} at n = {n}", restriction.comparisons));
    }
    Verdict::Holds(format!(
        "{breaks} breaks sorted and one slope added at each give f on random, vertical, horizontal and edge-parallel \
         lines; comparisons stay below n log2 n: {}",
        growth.join(", ")
    ))
}

/// Lines l_t of a polygon on a parabola closed by a chord, found by a walk: farthest vertices only move forward.
fn flat_bisectors(polygon: &[Point]) -> Vec<Bisector> {
    let n = polygon.len();
    let mut s = 1;
    (0..n)
        .map(|t| {
            let edge = polygon[t].to(&polygon[(t + 1) % n]);
            while edge.cross(&polygon[s % n].to(&polygon[(s + 1) % n])) > RBig::ZERO {
                s += 1;
            }
            Bisector { start: polygon[s % n].midpoint(&polygon[t]), edge }
        })
        .collect()
}

fn restrict(lines: &[Bisector], through: &Point, direction: &Point) -> Restriction {
    let mut slope = RBig::ZERO;
    let mut crossings = Vec::new();
    for line in lines {
        let rate = line.edge.cross(direction);
        let height = line.height(through);
        if rate == RBig::ZERO {
            continue;
        }
        if rate < RBig::ZERO {
            slope += integer(2) * &rate;
        }
        let jump = if rate < RBig::ZERO { -rate.clone() } else { rate.clone() };
        crossings.push((-height / rate, integer(2) * jump));
    }
    let mut comparisons = 0;
    let sorted = merge_sorted(crossings, &mut comparisons);
    let mut restriction = Restriction { breaks: Vec::new(), slopes: vec![slope.clone()], comparisons };
    for (place, jump) in sorted {
        slope += jump;
        restriction.breaks.push(place);
        restriction.slopes.push(slope.clone());
    }
    restriction
}

/// Merge sort by place, counting comparisons.
fn merge_sorted(mut items: Vec<(RBig, RBig)>, comparisons: &mut usize) -> Vec<(RBig, RBig)> {
    if items.len() <= 1 {
        return items;
    }
    let right = items.split_off(items.len() / 2);
    let mut left = merge_sorted(items, comparisons).into_iter().peekable();
    let mut right = merge_sorted(right, comparisons).into_iter().peekable();
    let mut merged = Vec::new();
    while let (Some(one), Some(other)) = (left.peek(), right.peek()) {
        *comparisons += 1;
        let next = if one.0 <= other.0 { left.next() } else { right.next() };
        merged.extend(next);
    }
    merged.extend(left);
    merged.extend(right);
    merged
}

/// The first break beyond which the slopes do not lead to the next value of f.
fn first_mismatch(restriction: &Restriction, f: impl Fn(&RBig) -> RBig) -> Option<RBig> {
    let (first, last) = (restriction.breaks.first()?, restriction.breaks.last()?);
    let mut places = vec![first - integer(3)];
    places.extend(restriction.breaks.iter().cloned());
    places.push(last + integer(5));
    places.windows(2).zip(&restriction.slopes).find_map(|(pair, slope)| {
        let half = (&pair[0] + &pair[1]) / integer(2);
        let start = f(&pair[0]);
        let fits = |end: &RBig| f(end) == &start + slope * (end - &pair[0]);
        (!fits(&half) || !fits(&pair[1])).then(|| pair[0].clone())
    })
}
