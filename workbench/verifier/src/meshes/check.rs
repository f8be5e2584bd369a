//! Answers about two meshes under poses, checked without a certificate: every pair of triangles that may matter.

use dashu_int::IBig;

use super::sweep::{Boxed, near_pairs};
use super::triangles::{Triangle, is_below, meet, squared_distance};
use crate::collision::placed::{Body, Frame, Pose};
use crate::exact::linear::Vector;
use crate::exact::proportion::Proportion;
use crate::verdict::{Proved, Stop, Verdict};

/// The most pairs of triangles that are looked at; a check with more is left open.
const PAIR_LIMIT: usize = 2_000_000;

/// The bounds of a distance may differ by this part of the upper one.
const DISTANCE_SHARE: f64 = 1e-3;

/// Bounds of a distance that are this many of the smallest doubles apart are as near as they can be.
const COARSENESS: f64 = f64::from_bits(2);

/// A mesh of a question: vertices, triangles by the positions of their corners, and its pose.
#[derive(Debug, Clone, Copy)]
pub struct Surface<'a> {
    /// The vertices before they are placed.
    pub vertices: &'a [Vec<f64>],
    /// The triangles: three positions of vertices from 0 each.
    pub triangles: &'a [Vec<usize>],
    /// The placement.
    pub pose: Option<&'a Pose>,
}

/// The answer to a question about two meshes.
#[derive(Debug, Clone, PartialEq)]
pub enum MeshAnswer {
    /// They meet in a pair of triangles.
    Meeting {
        /// The pair.
        witness: [usize; 2],
        /// All such pairs in increasing order, if they were asked for.
        pairs: Option<Vec<[usize; 2]>>,
    },
    /// They do not meet.
    Apart {
        /// A lower and an upper bound of their distance; infinite above the largest double. None where pairs were asked
        /// for.
        distance: Option<[f64; 2]>,
    },
}

/// Checks where two meshes meet, or how far apart they are.
pub fn check_meshes(a: &Surface<'_>, b: &Surface<'_>, answer: &MeshAnswer) -> Verdict<Proved> {
    check(a, b, answer).into()
}

fn check(a: &Surface<'_>, b: &Surface<'_>, answer: &MeshAnswer) -> Result<Proved, Stop> {
    let bodies = [a, b].map(|surface| Body { center: &[0.0; 3], generators: surface.vertices, pose: surface.pose });
    bodies.iter().try_for_each(|body| body.check_dimension(3))?;
    let frame = Frame::of(&[&bodies[0], &bodies[1]], &[])?;
    let [a, b] = [boxed(a, &bodies[0], &frame)?, boxed(b, &bodies[1], &frame)?];
    match answer {
        MeshAnswer::Meeting { witness, pairs } => {
            let [Some(first), Some(second)] = [a.get(witness[0]), b.get(witness[1])] else {
                return Err(format!("there is no pair of triangles {witness:?}").into());
            };
            if !meet(&first.triangle, &second.triangle) {
                return Err(format!("the triangles {witness:?} do not meet").into());
            }
            let Some(pairs) = pairs else { return Ok(Proved("the pair of triangles has a point in common")) };
            if meeting_pairs(&a, &b)? != *pairs {
                return Err("the pairs are not all pairs of triangles that meet, in order".into());
            }
            Ok(Proved("the pairs are all that meet"))
        }
        MeshAnswer::Apart { distance } => {
            if let Some([i, j]) = meeting_pairs(&a, &b)?.first() {
                return Err(format!("the triangles {i} and {j} meet").into());
            }
            let Some(bounds) = distance else { return Ok(Proved("no pair of triangles meets")) };
            check_distance(&a, &b, *bounds, frame.exponent())?;
            Ok(Proved("no pair of triangles meets, and none is nearer or farther than the bounds"))
        }
    }
}

/// The triangles of a surface where its pose puts them.
fn boxed(surface: &Surface<'_>, body: &Body<'_, Vec<f64>>, frame: &Frame) -> Result<Vec<Boxed>, Stop> {
    let shift = frame.center(body);
    let place = |v: &Vector| [0, 1, 2].map(|k| &v[k] + &shift[k]);
    let places: Vec<[IBig; 3]> = frame.generators(body).iter().map(place).collect();
    let triangle = |corners: &Vec<usize>| -> Option<Triangle> {
        let [p, q, r]: [usize; 3] = corners.as_slice().try_into().ok()?;
        Some([places.get(p)?.clone(), places.get(q)?.clone(), places.get(r)?.clone()])
    };
    let triangles = surface.triangles.iter().map(|corners| triangle(corners).map(Boxed::new));
    let broken = || Stop::from("answered a question with a triangle whose corners are not there");
    let boxed: Vec<Boxed> = triangles.collect::<Option<_>>().ok_or_else(broken)?;
    if boxed.is_empty() { Err("answered a question about a mesh without triangles".into()) } else { Ok(boxed) }
}

/// All pairs that meet, in increasing order.
fn meeting_pairs(a: &[Boxed], b: &[Boxed]) -> Result<Vec<[usize; 2]>, Stop> {
    let mut found = Vec::new();
    let mut looked_at = 0;
    near_pairs(a, b, &IBig::ZERO, |[i, j]| {
        limited(&mut looked_at)?;
        if meet(&a[i].triangle, &b[j].triangle) {
            found.push([i, j]);
        }
        Ok::<(), Stop>(())
    })?;
    found.sort_unstable();
    Ok(found)
}

fn limited(looked_at: &mut usize) -> Result<(), Stop> {
    *looked_at += 1;
    match *looked_at > PAIR_LIMIT {
        true => Err(Stop::Unchecked(format!("more than {PAIR_LIMIT} pairs of triangles are near each other"))),
        false => Ok(()),
    }
}

/// Checks bounds of the distance of meshes that do not meet.
fn check_distance(a: &[Boxed], b: &[Boxed], [lower, upper]: [f64; 2], exponent: i32) -> Result<(), Stop> {
    if lower.is_nan() || upper.is_nan() || !lower.is_finite() || lower < 0.0 || upper < lower {
        return Err("the bounds of the distance are no bounds".into());
    }
    let reach = if upper.is_finite() { upper } else { f64::MAX };
    if reach - lower > DISTANCE_SHARE * reach && reach - lower > COARSENESS {
        return Err("the bounds of the distance are too far from each other".into());
    }
    // what is farther than the upper bound along an axis is farther than it; rounded up to a whole unit
    let units = Proportion::of_double(reach).floor_at(exponent) + IBig::ONE;
    let mut least: Option<[IBig; 2]> = None;
    let mut looked_at = 0;
    near_pairs(a, b, &units, |[i, j]| {
        limited(&mut looked_at)?;
        let square = squared_distance(&a[i].triangle, &b[j].triangle);
        if least.as_ref().is_none_or(|least| is_below(&square, least)) {
            least = Some(square);
        }
        Ok::<(), Stop>(())
    })?;
    let square = |bound: f64| {
        let bound = Proportion::of_double(bound);
        bound.times(&bound)
    };
    let Some([numerator, denominator]) = least else {
        return if upper.is_finite() { Err("no two triangles are as near as the upper bound".into()) } else { Ok(()) };
    };
    let exact = Proportion::new(numerator, denominator, 2 * exponent);
    if exact.compare(&square(lower)).is_lt() {
        return Err("two triangles are nearer than the lower bound".into());
    }
    if upper.is_finite() && exact.compare(&square(upper)).is_gt() {
        return Err("no two triangles are as near as the upper bound".into());
    }
    if !upper.is_finite() && exact.compare(&square(f64::MAX)).is_le() {
        return Err("two triangles are nearer than the largest double".into());
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: [[f64; 3]; 3] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

    fn judged(shift: f64, answer: MeshAnswer) -> Verdict<Proved> {
        let vertices: Vec<Vec<f64>> = UNIT.iter().map(|v| v.to_vec()).collect();
        let matrix = (0..3).map(|i| (0..3).map(|k| f64::from(u8::from(i == k))).collect()).collect();
        let pose = Pose { matrix, translation: vec![0.0, 0.0, shift] };
        let triangles = vec![vec![0, 1, 2], vec![2, 1, 0]];
        let a = Surface { vertices: &vertices, triangles: &triangles, pose: None };
        check_meshes(&a, &Surface { pose: Some(&pose), ..a }, &answer)
    }

    #[test]
    fn meeting_meshes_have_the_pairs_that_meet() {
        let meeting = |witness, pairs| MeshAnswer::Meeting { witness, pairs };
        let all = vec![[0, 0], [0, 1], [1, 0], [1, 1]];
        assert!(judged(0.0, meeting([1, 0], None)).is_right());
        assert!(judged(0.0, meeting([1, 0], Some(all.clone()))).is_right());
        assert!(judged(0.0, meeting([1, 0], Some(all[1..].to_vec()))).is_wrong());
        assert!(judged(0.0, meeting([1, 2], None)).is_wrong());
        assert!(judged(f64::from_bits(1), meeting([1, 0], None)).is_wrong());
        assert!(judged(0.0, MeshAnswer::Apart { distance: None }).is_wrong());
    }

    #[test]
    fn distances_are_between_their_bounds() {
        let apart = |lower, upper| MeshAnswer::Apart { distance: Some([lower, upper]) };
        assert!(judged(2.0, apart(1.999, 2.0)).is_right());
        assert!(judged(2.0, apart(2.0, 2.001)).is_right());
        assert!(judged(2.0, apart(1.99, 2.0)).is_wrong(), "too far from each other");
        assert!(judged(2.0, apart(2f64.next_up(), 2.001)).is_wrong());
        assert!(judged(2.0, apart(1.999, 2f64.next_down())).is_wrong());
        assert!(judged(2.0, apart(f64::NAN, 2.0)).is_wrong());
        let least = f64::from_bits(1);
        assert!(judged(least, apart(0.0, least)).is_right());
        assert!(judged(1e300, apart(1e300, f64::INFINITY)).is_wrong());
    }

    #[test]
    fn bounds_that_are_none_are_refused() {
        let (nan, inf) = (f64::NAN, f64::INFINITY);
        for [lower, upper] in [[nan, 2.0], [2.0, nan], [nan, nan], [inf, inf], [-1.0, 2.0], [2.0, 1.0], [-inf, 2.0]] {
            let answer = MeshAnswer::Apart { distance: Some([lower, upper]) };
            assert!(judged(2.0, answer).is_wrong(), "{lower} {upper}");
        }
        let share = |part: f64| MeshAnswer::Apart { distance: Some([2.0 - 2.0 * part, 2.0]) };
        assert!(judged(2.0, share(DISTANCE_SHARE / 2.0)).is_right());
        assert!(judged(2.0, share(DISTANCE_SHARE * 2.0)).is_wrong());
        assert!(judged(2.0, MeshAnswer::Apart { distance: Some([2.0, 2.0]) }).is_right());
    }

    #[test]
    fn pairs_are_counted_up_to_their_limit() {
        let mut looked_at = PAIR_LIMIT - 1;
        assert!(limited(&mut looked_at).is_ok() && limited(&mut looked_at).is_err());
        assert_eq!(looked_at, PAIR_LIMIT + 1);
    }

    #[test]
    fn a_pose_moves_a_mesh_by_its_translation_and_not_against_it() {
        let [here, away] = [0.0, 5.0].map(|x| UNIT.map(|v| vec![v[0] + x, v[1], v[2]]));
        let matrix = (0..3).map(|i| (0..3).map(|k| f64::from(u8::from(i == k))).collect()).collect();
        let back = Pose { matrix, translation: vec![-5.0, 0.0, 0.0] };
        let triangles = vec![vec![0, 1, 2]];
        let a = Surface { vertices: &here, triangles: &triangles, pose: None };
        let b = Surface { vertices: &away, triangles: &triangles, pose: Some(&back) };
        let meeting = MeshAnswer::Meeting { witness: [0, 0], pairs: None };
        assert!(check_meshes(&a, &b, &meeting).is_right());
        assert!(check_meshes(&a, &Surface { pose: None, ..b }, &meeting).is_wrong());
    }

    #[test]
    fn bounds_may_differ_by_their_share_and_by_two_of_the_smallest_doubles() {
        let apart = |lower, upper| MeshAnswer::Apart { distance: Some([lower, upper]) };
        assert!(judged(1000.0, apart(999.0, 1000.0)).is_right());
        assert!(judged(1000.0, apart(999.0_f64.next_down(), 1000.0)).is_wrong());
        let smallest = |count: u64| f64::from_bits(count);
        assert!(judged(smallest(4), apart(smallest(3), smallest(5))).is_right());
        assert!(judged(smallest(4), apart(smallest(3), smallest(6))).is_wrong());
    }

    #[test]
    fn beyond_the_largest_double_the_upper_bound_is_infinite_and_a_number() {
        let vertices = [-f64::MAX, f64::MAX].map(|z| UNIT.map(|v| vec![v[0], v[1], z]));
        let triangles = vec![vec![0, 1, 2]];
        let [a, b] = vertices.each_ref().map(|vertices| Surface { vertices, triangles: &triangles, pose: None });
        let judged = |upper| check_meshes(&a, &b, &MeshAnswer::Apart { distance: Some([f64::MAX, upper]) });
        assert!(judged(f64::INFINITY).is_right());
        assert!(judged(f64::NAN).is_wrong() && judged(f64::MAX).is_wrong());
    }
}
