//! The shortest zonogon around points of the plane, by cutting planes for its centre: generators, and multipliers for
//! the proof, without a linear program.
//!
//! With the centre O fixed the smallest zonogon is the convex hull of the points and their reflections in O, and its
//! half-edges are the generators. Let the unit tangent turn from t to t' at a vertex p_j of the hull; then (t − t') / 2
//! is the multiplier λ_j of the point. These multipliers have two properties:
//! - Σ |λ_j · v| ≤ 1 for every unit vector v. The sum is at most half the total variation of t · v, which is 2 while t
//!   turns by π, and each pair of opposite vertices is counted once.
//! - Σ λ_j · (p_j − x) is a lower bound of the length for every centre x, and it is the length for x = O. So −Σ λ_j is
//!   a subgradient of the length at O.
//!
//! The length is a convex function of O, so each gradient cuts off the half-plane where the length is greater. The next
//! centre is the centroid of what is left: each cut takes at least four ninths of that area, and the method needs no
//! step size. The multipliers of one centre do not add up to zero in general, but averages of several centres'
//! multipliers do, and these prove the lower bound.

use crate::enclosing::fixed_directions::balanced;
use crate::enclosing::min_total_length::frame::Frame;
use crate::enclosing::min_total_length::frame_zonotope::FrameZonotope;
use crate::enclosing::min_total_length::lower_bound::BestBound;
use crate::hull::convex_hull;
use crate::numeric::linear::dot;

/// An affine lower bound of the length as a function of the centre x, length(x) ≥ height + slope · x, with equality at
/// the centre whose zonogon it comes from; and the multipliers that prove it.
struct Cut<const D: usize> {
    slope: [f64; 2],
    height: f64,
    multipliers: Vec<(usize, [f64; D])>,
}

/// At most this many centres are tried: the part of the plane that is left is as small as rounding by then.
const CENTER_LIMIT: usize = 160;

/// The search for the centre begins with the points' bounding box, scaled by this factor about its middle.
const BOX_ENLARGEMENT: f64 = 1.125;

/// Multipliers are averaged over at most this many cuts, the last ones.
const AVERAGED_CUT_LIMIT: usize = 48;

/// A slope whose coordinates are all smaller than this counts as zero, and slopes count as parallel if the tangent of
/// their angle is no larger.
const NEGLIGIBLE_SLOPE: f64 = 1e-15;

/// The coefficients that place the vertices are kept as witnesses if there are at most this many.
const WITNESS_LIMIT: usize = 1 << 20;

/// The loss of lower bound that is assumed for each unit by which a sum of multipliers differs from zero: balancing
/// them puts the difference on one point of the frame.
const REMAINDER_COST: f64 = 4.0;

/// Multipliers are averaged in each round whose number is a multiple of this.
const ROUNDS_PER_AVERAGE: usize = 8;

/// The shortest zonogon found around the points of a frame of rank 2, and the least length and the greatest lower bound
/// each time that multipliers were averaged.
pub(in crate::enclosing::min_total_length) fn min_length_in_plane<const D: usize>(
    frame: &Frame<D>,
    epsilon: f64,
    best: &mut BestBound<D>,
) -> (FrameZonotope<D>, Vec<[f64; 2]>) {
    let points: Vec<[f64; 2]> = frame.points.iter().map(|p| [p[0], p[1]]).collect();
    let hull = hull_of(&points);
    let (low, high) = hull.iter().fold(([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]), |(low, high), &j| {
        let p = points[j];
        ([low[0].min(p[0]), low[1].min(p[1])], [high[0].max(p[0]), high[1].max(p[1])])
    });
    let mut target = [(low[0] + high[0]) / 2.0, (low[1] + high[1]) / 2.0];
    // The best centre may lie on the boundary of the bounding box, where the proof needs cuts from both sides; so the
    // first polygon is larger.
    let [x, y] = [0, 1].map(|c| BOX_ENLARGEMENT * (high[c] - low[c]) / 2.0);
    let corner = |a: f64, b: f64| [target[0] + a * x, target[1] + b * y];
    let mut region = vec![corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
    let mut cuts: Vec<Cut<D>> = Vec::new();
    let mut inner =
        FrameZonotope { upper: f64::INFINITY, center: [0.0; D], generators: Vec::new(), witnesses: Vec::new() };
    let mut shortest = None;
    let mut progress = Vec::new();
    for round in 1..=CENTER_LIMIT {
        let zonogon = Zonogon::around(&points, &hull, target);
        let cut = zonogon.cut(&points, &hull);
        let generators = zonogon.generators();
        let upper: f64 = generators.iter().map(|g| dot(g, g).sqrt()).sum();
        if upper < inner.upper {
            let center = in_space(&target, 1.0);
            inner = FrameZonotope { upper, center, generators, witnesses: Vec::new() };
            shortest = Some(zonogon);
        }
        region = part_below(&region, target, cut.slope);
        let is_flat = cut.slope == [0.0; 2];
        cuts.push(cut);
        let next = centroid(&region);
        if round % ROUNDS_PER_AVERAGE == 0 || is_flat || next.is_none() || round == CENTER_LIMIT {
            let last = &cuts[cuts.len().saturating_sub(AVERAGED_CUT_LIMIT)..];
            if let Some(unbalanced) = averaged(last) {
                best.improve(2, &frame.points, balanced(&unbalanced), f64::INFINITY);
            }
            progress.push([inner.upper, best.lower]);
            if inner.upper <= (1.0 + 0.5 * epsilon) * best.lower {
                break;
            }
        }
        match next {
            Some(next) if !is_flat => target = next,
            _ => break,
        }
    }
    inner.witnesses = shortest.map_or_else(Vec::new, |zonogon: Zonogon| zonogon.witnesses(&hull));
    (inner, progress)
}

/// The smallest zonogon around points with a given centre: the convex hull of the points and their reflections.
struct Zonogon {
    /// The vertices, counterclockwise. With h vertices of the points' hull, k < h is vertex k of that hull, and h + k
    /// is its reflection.
    boundary: Vec<usize>,
    /// Half of the edge that follows each vertex.
    edges: Vec<[f64; 2]>,
    /// The number h of vertices of the points' hull.
    own: usize,
    /// Whether the second half of the boundary is the reflection of the first. Rounding may drop a vertex and keep its
    /// reflection; then every edge of the whole boundary is taken with half its length.
    is_symmetric: bool,
}

impl Zonogon {
    /// The zonogon with a centre around points, given with the vertices of their hull.
    fn around(points: &[[f64; 2]], hull: &[usize], center: [f64; 2]) -> Self {
        let own = hull.iter().map(|&j| [points[j][0] - center[0], points[j][1] - center[1]]);
        let around: Vec<[f64; 2]> = own.clone().chain(own.map(|p| p.map(|c| -c))).collect();
        let boundary = hull_of(&around);
        let (count, own) = (boundary.len(), hull.len());
        let edges = (0..count)
            .map(|k| {
                let (a, b) = (around[boundary[k]], around[boundary[(k + 1) % count]]);
                [(b[0] - a[0]) / 2.0, (b[1] - a[1]) / 2.0]
            })
            .collect();
        let half = count / 2;
        let is_symmetric = count.is_multiple_of(2) && (0..half).all(|k| boundary[k] % own == boundary[k + half] % own);
        Self { boundary, edges, own, is_symmetric }
    }

    /// The cut at the zonogon's centre.
    fn cut<const D: usize>(&self, points: &[[f64; 2]], hull: &[usize]) -> Cut<D> {
        let count = self.edges.len();
        let unit = |e: &[f64; 2]| {
            let length = (e[0] * e[0] + e[1] * e[1]).sqrt();
            if length > 0.0 { e.map(|c| c / length) } else { [0.0; 2] }
        };
        let tangents: Vec<[f64; 2]> = self.edges.iter().map(unit).collect();
        let mut cut = Cut { slope: [0.0; 2], height: 0.0, multipliers: Vec::with_capacity(count) };
        for (k, &vertex) in self.boundary.iter().enumerate() {
            let (before, after) = (tangents[(k + count - 1) % count], tangents[k]);
            let point = hull[vertex % self.own];
            // A point and its reflection are both vertices, so each counts half: a quarter of the turn.
            let share = if vertex >= self.own { -0.25 } else { 0.25 };
            let multiplier = [share * (before[0] - after[0]), share * (before[1] - after[1])];
            cut.slope = [cut.slope[0] - multiplier[0], cut.slope[1] - multiplier[1]];
            cut.height += multiplier[0] * points[point][0] + multiplier[1] * points[point][1];
            cut.multipliers.push((point, in_space(&multiplier, 1.0)));
        }
        cut
    }

    /// The half-edges that are the generators, and the factor by which each is multiplied.
    fn used(&self) -> (&[[f64; 2]], f64) {
        if self.is_symmetric { (&self.edges[..self.edges.len() / 2], 1.0) } else { (&self.edges, 0.5) }
    }

    /// The generators, in the coordinates of the frame.
    fn generators<const D: usize>(&self) -> Vec<[f64; D]> {
        let (edges, factor) = self.used();
        edges.iter().filter(|e| **e != [0.0; 2]).map(|e| in_space(e, factor)).collect()
    }

    /// For each point that is a vertex, as is its reflection, the coefficients of the generators that place it: 1 for
    /// the edges from the reflection to the point, counterclockwise, and −1 for the others. Empty if they would be too
    /// many.
    fn witnesses(&self, hull: &[usize]) -> Vec<(usize, Vec<f64>)> {
        let (edges, _) = self.used();
        if edges.len().saturating_mul(self.own) > WITNESS_LIMIT {
            return Vec::new();
        }
        let mut places = vec![None; 2 * self.own];
        for (k, &vertex) in self.boundary.iter().enumerate() {
            places[vertex] = Some(k);
        }
        let of_point = |(point, (end, begin)): (&usize, (&Option<usize>, &Option<usize>))| {
            let (end, begin) = (end.as_ref()?, begin.as_ref()?);
            let is_before = |i: &usize| if begin < end { (begin..end).contains(&i) } else { i >= begin || i < end };
            let present = (0..edges.len()).filter(|&i| edges[i] != [0.0; 2]);
            Some((*point, present.map(|i| if is_before(&i) { 1.0 } else { -1.0 }).collect()))
        };
        let (own, reflected) = places.split_at(self.own);
        hull.iter().zip(own.iter().zip(reflected)).filter_map(of_point).collect()
    }
}

/// A multiple of a vector of the plane as a vector of the frame.
fn in_space<const D: usize>(v: &[f64; 2], factor: f64) -> [f64; D] {
    std::array::from_fn(|c| if c < 2 { factor * v[c] } else { 0.0 })
}

/// The weighted average of the multipliers of one, two or three cuts whose slopes cancel that proves the greatest lower
/// bound; `None` if no slopes cancel.
fn averaged<const D: usize>(cuts: &[Cut<D>]) -> Option<Vec<(usize, [f64; D])>> {
    let cross = |i: usize, j: usize| cuts[i].slope[0] * cuts[j].slope[1] - cuts[i].slope[1] * cuts[j].slope[0];
    let mut best: Option<(f64, [(usize, f64); 3])> = None;
    let mut offer = |shares: [(usize, f64); 3]| {
        let height = shares.iter().map(|&(i, share)| share * cuts[i].height).sum::<f64>();
        let left = |c: usize| shares.iter().map(|&(i, share)| share * cuts[i].slope[c]).sum::<f64>().abs();
        // Slopes that are nearly parallel cancel only up to rounding, which costs the bound.
        let worth = height - REMAINDER_COST * (left(0) + left(1));
        if worth.is_finite() && best.as_ref().is_none_or(|b| worth > b.0) {
            best = Some((worth, shares));
        }
    };
    for i in 0..cuts.len() {
        if cuts[i].slope.iter().all(|c| c.abs() < NEGLIGIBLE_SLOPE) {
            offer([(i, 1.0), (i, 0.0), (i, 0.0)]);
        }
        for j in 0..i {
            let along = cuts[i].slope[0] * cuts[j].slope[0] + cuts[i].slope[1] * cuts[j].slope[1];
            if cross(i, j).abs() <= NEGLIGIBLE_SLOPE * along.abs() && along < 0.0 {
                let [a, b] = [i, j].map(|i| cuts[i].slope.map(f64::abs).into_iter().fold(0.0, f64::max));
                offer([(i, b / (a + b)), (j, a / (a + b)), (j, 0.0)]);
            }
            for k in 0..j {
                let shares = [cross(j, k), cross(k, i), cross(i, j)];
                let sum: f64 = shares.iter().sum();
                if sum != 0.0 && shares.iter().all(|s| s / sum >= 0.0) {
                    offer([(i, shares[0] / sum), (j, shares[1] / sum), (k, shares[2] / sum)]);
                }
            }
        }
    }
    let (_, shares) = best?;
    let multipliers = shares.into_iter().flat_map(|(i, share)| {
        cuts[i].multipliers.iter().map(move |(point, multiplier)| (*point, multiplier.map(|c| c * share)))
    });
    Some(multipliers.collect())
}

/// The part of a convex polygon where slope · (x − at) ≤ 0.
fn part_below(polygon: &[[f64; 2]], at: [f64; 2], slope: [f64; 2]) -> Vec<[f64; 2]> {
    let height = |p: &[f64; 2]| slope[0] * (p[0] - at[0]) + slope[1] * (p[1] - at[1]);
    let mut part = Vec::with_capacity(polygon.len() + 1);
    for (a, b) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
        let (above_a, above_b) = (height(a), height(b));
        if above_a <= 0.0 {
            part.push(*a);
        }
        if above_a < 0.0 && above_b > 0.0 || above_a > 0.0 && above_b < 0.0 {
            let share = above_a / (above_a - above_b);
            part.push([a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])]);
        }
    }
    part
}

/// The centroid of a convex polygon; `None` if its area is not positive in floating point.
fn centroid(polygon: &[[f64; 2]]) -> Option<[f64; 2]> {
    let (first, rest) = polygon.split_first()?;
    let (mut area, mut moment) = (0.0, [0.0; 2]);
    for pair in rest.windows(2) {
        let [a, b] = [0, 1].map(|i| [pair[i][0] - first[0], pair[i][1] - first[1]]);
        let twice = a[0] * b[1] - a[1] * b[0];
        area += twice;
        moment = [0, 1].map(|c| moment[c] + twice * (a[c] + b[c]) / 3.0);
    }
    let next = [0, 1].map(|c| first[c] + moment[c] / area);
    (area > 0.0 && next.iter().all(|c| c.is_finite())).then_some(next)
}

/// The vertices of the convex hull, counterclockwise.
fn hull_of(points: &[[f64; 2]]) -> Vec<usize> {
    let hull = convex_hull(points, &mut ()).expect("a frame of rank 2 has points, and finite ones");
    hull.indices().iter().map(|index| index.get()).collect()
}
