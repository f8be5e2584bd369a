//! Answers to "the zonogon of least area that contains the points".
//!
//! Let H be the convex hull of the points, e_t = P_{t+1} − P_t its edges in counter-clockwise order, P_s the vertex
//! farthest from e_t, and v_t(O) = e_t × (2 O − P_s − P_t). Every enclosing zonogon with centre O contains the hull of
//! H and its reflection 2 O − H, whose area is
//!
//! ```text
//! f(O) = constant + 1/2 Σ_t |v_t(O)|.
//! ```
//!
//! For any δ_t in [−1, 1] with Σ δ_t e_t = 0 the sum Σ δ_t v_t(O) does not depend on O, because v_t(O) − v_t(c) =
//! 2 e_t × (O − c). So for every O, with c the centre of the answer,
//!
//! ```text
//! f(O) ≥ constant + 1/2 Σ_t δ_t v_t(O) = f(c) − 1/2 Σ_t (|v_t(c)| − δ_t v_t(c)).
//! ```
//!
//! The right-hand side is what the certificate proves; f(c) is computed from its definition, as the area of a hull.

#[cfg(test)]
mod tests;

use std::cmp::Ordering;
use std::fmt::{self, Display};

use dashu_int::IBig;
use dashu_int::ops::Abs;

use crate::RELATIVE_ERROR;
use crate::exact::fraction::{Fraction, common_denominator};
use crate::exact::grid::{Grid, check_finite};
use crate::exact::polygon::{ConvexPolygon, Point, cross, vector};
use crate::exact::proportion::{Proportion, check_figure};
use crate::hull::check_hull;
use crate::verdict::{Proved, Verdict};

/// An answer as it was written.
#[derive(Debug, Clone, PartialEq)]
pub struct MinAreaAnswer {
    /// The claimed area of the zonogon.
    pub area: f64,
    /// Its centre.
    pub center: [f64; 2],
    /// Its generators.
    pub generators: Vec<[f64; 2]>,
    /// The claimed bound below the area of every enclosing zonogon.
    pub lower_bound: f64,
    /// The proof of the bound.
    pub certificate: Certificate,
}

/// The proof of a lower bound.
#[derive(Debug, Clone, PartialEq)]
pub struct Certificate {
    /// The vertices of the convex hull, counter-clockwise from the lexicographically smallest, as indices of points.
    pub hull: Vec<usize>,
    /// For each hull edge, the position in `hull` of a vertex farthest from it.
    pub farthest: Vec<usize>,
    /// For each hull edge its coefficient δ_t; those of the basis edges are solved for, and 0 stands in their places.
    pub coefficients: Vec<f64>,
    /// At most two hull edges whose coefficients are solved for.
    pub basis: Vec<usize>,
}

/// The proof of an answer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MinAreaProof {
    /// The answer's area, which agrees with the exact one.
    pub area: f64,
    /// The largest lower bound that the certificate proves, rounded.
    pub proven_bound: f64,
    /// The exact area above the proven bound, relative to the area; 0 when both are 0.
    pub gap: f64,
    /// The number of points that the zonogon contains.
    pub points: usize,
}

impl Display for MinAreaProof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { area, gap, points, proven_bound } = self;
        write!(f, "contains all {points} points; area {area:?} ")?;
        // an area that agrees with the exact one up to rounding may lie below the bound of it
        let of_exact = if area < proven_bound { "agrees with the exact one, which " } else { "" };
        write!(f, "{of_exact}is within {gap:.1e} of the proven bound")
    }
}

/// Proves that the zonogon contains every point, has the area it is said to have, and is the smallest up to rounding;
/// or says what fails.
///
/// `area` may differ from the exact area by the relative [`RELATIVE_ERROR`]; `lower_bound` may not exceed the proven
/// bound. The exact area may exceed that bound by the relative [`RELATIVE_ERROR`] and, since the centre and the
/// generators of thin bodies and of those far from the origin cannot be rounded any closer, by (2^-49 · largest x +
/// 2^-1068) · height + (2^-49 · largest y + 2^-1068) · width, unless one of the extents is zero; it may exceed
/// `lower_bound` by as much, but for values that leave the range of normal doubles.
pub fn check_min_area(points: &[[f64; 2]], answer: &MinAreaAnswer) -> Verdict<MinAreaProof> {
    proved(points, answer).into()
}

fn proved(points: &[[f64; 2]], answer: &MinAreaAnswer) -> Result<MinAreaProof, String> {
    if points.is_empty() {
        return Err("there is no point to enclose".to_owned());
    }
    check_finite("the question", points.as_flattened())?;
    check_finite("the zonogon", answer.generators.as_flattened().iter().chain(&answer.center))?;
    let coordinates = points.iter().chain(&answer.generators).chain([&answer.center]).flatten().copied();
    let grid = Grid::of(coordinates);
    let placed: Vec<Point> = points.iter().map(|&point| grid.point(point)).collect();
    let center = grid.point(answer.center);
    let generators: Vec<Point> = answer.generators.iter().map(|&generator| grid.point(generator)).collect();

    let zonogon = ConvexPolygon::zonogon(&center, &generators);
    check_hull(points, &answer.certificate.hull)?;
    if let Some(outside) = answer.certificate.hull.iter().find(|&&vertex| !zonogon.contains(&placed[vertex])) {
        return Err(format!("point {} lies outside the zonogon", outside + 1));
    }
    let area = Proportion::whole(zonogon.doubled_area(), 2 * grid.exponent() - 1);
    let allowed = area.times(&Proportion::of_double(RELATIVE_ERROR));
    check_figure("area", answer.area, &area, &allowed)?;

    let half_unit = Proportion::whole(IBig::ONE, 2 * grid.exponent() - 1);
    let bound = proven_bound(&placed, &center, &answer.certificate)?.times(&half_unit);
    if answer.lower_bound.is_nan() || answer.lower_bound == f64::INFINITY {
        return Err(format!("lower_bound is {}", answer.lower_bound));
    }
    if answer.lower_bound == f64::NEG_INFINITY {
        return Err("lower_bound says nothing".to_owned());
    }
    let claimed = Proportion::of_double(answer.lower_bound);
    if claimed.compare(&bound) == Ordering::Greater {
        return Err(format!(
            "lower_bound {:?} is above {:?}, all that the certificate proves",
            answer.lower_bound,
            bound.nearest()
        ));
    }
    let rounding = rounding_allowance(points);
    if area.minus(&bound).compare(&allowed.plus(&rounding)) == Ordering::Greater {
        return Err(format!(
            "the area {:?} is above the proven bound {:?} by more than rounding",
            area.nearest(),
            bound.nearest()
        ));
    }
    // The largest double is the most that can be claimed.
    let [smallest, largest] = [f64::MIN_POSITIVE, f64::MAX].map(Proportion::of_double);
    let most = if area.compare(&largest) == Ordering::Greater { &largest } else { &area };
    if most.minus(&claimed).compare(&allowed.plus(&rounding).plus(&smallest)) == Ordering::Greater {
        return Err(format!(
            "lower_bound {:?} says less than the certificate proves, {:?}",
            answer.lower_bound,
            bound.nearest()
        ));
    }
    Ok(MinAreaProof {
        area: answer.area,
        proven_bound: bound.nearest(),
        gap: area.minus(&bound).over(&area).map_or(0.0, |gap| gap.nearest()),
        points: points.len(),
    })
}

/// An optimum without any rounding.
#[derive(Debug, Clone, PartialEq)]
pub struct ExactMinArea {
    /// The area of the zonogon.
    pub area: Fraction,
    /// Its centre.
    pub center: [Fraction; 2],
    /// Its generators.
    pub generators: Vec<[Fraction; 2]>,
}

/// Proves that a zonogon contains every point, has exactly the area it is said to have, and that the certificate
/// proves exactly this area to be the least; or says what fails.
pub fn check_exact_min_area(points: &[[f64; 2]], certificate: &Certificate, exact: &ExactMinArea) -> Verdict<Proved> {
    proved_exactly(points, certificate, exact)
        .map(|()| Proved("the exact optimum is proved to be the least area"))
        .into()
}

fn proved_exactly(points: &[[f64; 2]], certificate: &Certificate, exact: &ExactMinArea) -> Result<(), String> {
    check_finite("the question", points.as_flattened())?;
    check_finite("certificate: `coefficients`", &certificate.coefficients)?;
    let exponent = Grid::of(points.iter().flatten().copied()).exponent().min(0);
    // Every coordinate is a whole number of units 2^exponent / common.
    let common = common_denominator(exact.generators.iter().chain([&exact.center]).flatten());
    let up = exponent.unsigned_abs() as usize;
    let of_double = |point: &[f64; 2]| Grid::at(exponent).point(*point).map(|units| units * &common);
    let of_fraction =
        |vector: &[Fraction; 2]| vector.each_ref().map(|x| (x.numerator() * (&common / x.denominator())) << up);
    let placed: Vec<Point> = points.iter().map(of_double).collect();
    let center = of_fraction(&exact.center);
    let generators: Vec<Point> = exact.generators.iter().map(of_fraction).collect();

    let zonogon = ConvexPolygon::zonogon(&center, &generators);
    check_hull(points, &certificate.hull)?;
    if let Some(outside) = certificate.hull.iter().find(|&&vertex| !zonogon.contains(&placed[vertex])) {
        return Err(format!("exact: point {} lies outside the zonogon", outside + 1));
    }
    let doubled = Proportion::whole(zonogon.doubled_area(), 0);
    let claimed = Proportion::of_fraction(&exact.area);
    let unit = Proportion::new(IBig::ONE, &common * &common, 2 * exponent - 1);
    if doubled.times(&unit).compare(&claimed) != Ordering::Equal {
        return Err("exact: `area` is not that of the zonogon".to_owned());
    }
    if proven_bound(&placed, &center, certificate)?.compare(&doubled) != Ordering::Equal {
        return Err("exact: the certificate does not prove that the area is the least".to_owned());
    }
    Ok(())
}

/// The amount that rounding the centre and the generators to doubles may cost an enclosing zonogon: along an axis they
/// are off by a few units in the last place of the largest coordinate there, which counts as often as the points extend
/// along the other axis. Along an axis on which all points agree nothing needs to be rounded.
fn rounding_allowance(points: &[[f64; 2]]) -> Proportion {
    let [units, floor] = [2.0_f64.powi(-49), 64.0 * f64::from_bits(1)].map(Proportion::of_double);
    let axis = |axis: usize| {
        let values = points.iter().map(|point| point[axis]);
        let low = values.clone().fold(f64::INFINITY, f64::min);
        let high = values.fold(f64::NEG_INFINITY, f64::max);
        let largest = Proportion::of_double(low.abs().max(high.abs()));
        (Proportion::of_double(high).minus(&Proportion::of_double(low)), largest.times(&units).plus(&floor))
    };
    let [(width, off_in_x), (height, off_in_y)] = [axis(0), axis(1)];
    if width.is_zero() || height.is_zero() {
        return Proportion::whole(IBig::ZERO, 0);
    }
    width.times(&off_in_y).plus(&height.times(&off_in_x))
}

/// Twice the bound that a certificate with the right hull proves for every zonogon around the points; 0 for points on a
/// line.
fn proven_bound(points: &[Point], center: &Point, certificate: &Certificate) -> Result<Proportion, String> {
    let vertices: &[Point] = &certificate.hull.iter().map(|&vertex| points[vertex].clone()).collect::<Vec<_>>();
    if vertices.len() < 3 {
        let Certificate { farthest, coefficients, basis, .. } = certificate;
        if !farthest.is_empty() || !coefficients.is_empty() || !basis.is_empty() {
            return Err("certificate: points on a line have no edges".to_owned());
        }
        return Ok(Proportion::whole(IBig::ZERO, 0));
    }
    let edges: Vec<Point> =
        (0..vertices.len()).map(|t| vector(&vertices[t], &vertices[(t + 1) % vertices.len()])).collect();
    check_farthest(vertices, &edges, &certificate.farthest)?;
    let offsets: Vec<IBig> = edges
        .iter()
        .zip(vertices)
        .zip(&certificate.farthest)
        .map(|((edge, start), &farthest)| {
            let [from_start, from_farthest] = [start, &vertices[farthest]].map(|vertex| vector(vertex, center));
            cross(edge, &from_start) + cross(edge, &from_farthest)
        })
        .collect();

    let reflected = vertices.iter().map(|[x, y]| [&center[0] * 2 - x, &center[1] * 2 - y]);
    let symmetric = ConvexPolygon::hull(vertices.iter().cloned().chain(reflected).collect());
    let loss = loss(&edges, &offsets, certificate)?;
    let at_center = Proportion::whole(symmetric.doubled_area(), 0);
    Ok(at_center.minus(&loss))
}

/// Each edge's named vertex must be as far from the edge as any: as far as its two neighbours suffices, by convexity.
fn check_farthest(vertices: &[Point], edges: &[Point], farthest: &[usize]) -> Result<(), String> {
    let count = vertices.len();
    if farthest.len() != count {
        return Err(format!("certificate: farthest has {} entries for {count} edges", farthest.len()));
    }
    for (t, (edge, &s)) in edges.iter().zip(farthest).enumerate() {
        if s >= count {
            return Err(format!("certificate: farthest names vertex {s}, which does not exist"));
        }
        let onward = cross(edge, &edges[s]);
        let back = cross(edge, &edges[(s + count - 1) % count]);
        if onward > IBig::ZERO || back < IBig::ZERO {
            return Err(format!("certificate: vertex {s} is not the farthest from edge {t}"));
        }
    }
    Ok(())
}

/// Σ_t (|v_t| − δ_t v_t), with the basis coefficients solved from Σ δ_t e_t = 0.
fn loss(edges: &[Point], offsets: &[IBig], certificate: &Certificate) -> Result<Proportion, String> {
    let Certificate { coefficients, basis, .. } = certificate;
    let count = edges.len();
    if coefficients.len() != count {
        return Err(format!("certificate: {} coefficients for {count} edges", coefficients.len()));
    }
    if let Some(wrong) = coefficients.iter().find(|delta| !(-1.0..=1.0).contains(*delta)) {
        return Err(format!("certificate: the coefficient {wrong} is outside [-1, 1]"));
    }
    if let Some(wrong) = basis.iter().find(|&&edge| edge >= count) {
        return Err(format!("certificate: basis names edge {wrong}, which does not exist"));
    }
    if let Some(wrong) = basis.iter().find(|&&edge| coefficients[edge] != 0.0) {
        return Err(format!(
            "certificate: the coefficient of basis edge {wrong} is solved for, but {} is given",
            coefficients[*wrong]
        ));
    }

    let fractions = Grid::of(coefficients.iter().copied());
    let one = fractions.exponent().min(0);
    let fractions_per_one = IBig::ONE << one.unsigned_abs() as usize;
    let mut rest = [IBig::ZERO, IBig::ZERO];
    let mut lost = IBig::ZERO;
    for (t, &delta) in coefficients.iter().enumerate().filter(|(t, _)| !basis.contains(t)) {
        let delta = Grid::at(one).units(delta);
        rest[0] += &delta * &edges[t][0];
        rest[1] += &delta * &edges[t][1];
        lost += offsets[t].clone().abs() * &fractions_per_one - delta * &offsets[t];
    }
    let mut total = Proportion::whole(lost, one);
    for (&edge, delta) in basis.iter().zip(solved(edges, basis, &rest)?) {
        let delta = Proportion::new(delta.0, delta.1, one);
        if delta.magnitude().compare(&Proportion::of_double(1.0)) == Ordering::Greater {
            return Err(format!("certificate: the coefficient of basis edge {edge} is {}", delta.nearest()));
        }
        let offset = Proportion::whole(offsets[edge].clone(), 0);
        total = total.plus(&offset.magnitude()).minus(&delta.times(&offset));
    }
    Ok(total)
}

/// The basis coefficients as fractions (numerator, denominator) with Σ over the basis of δ e = −rest.
fn solved(edges: &[Point], basis: &[usize], rest: &Point) -> Result<Vec<(IBig, IBig)>, String> {
    let unsolvable = || Err("certificate: the coefficients do not close the edges".to_owned());
    match *basis {
        [] if rest.iter().all(|component| *component == IBig::ZERO) => Ok(Vec::new()),
        [i] if cross(rest, &edges[i]) == IBig::ZERO => {
            let dot = |u: &Point, v: &Point| &u[0] * &v[0] + &u[1] * &v[1];
            Ok(vec![(-dot(rest, &edges[i]), dot(&edges[i], &edges[i]))])
        }
        [i, j] => {
            let determinant = cross(&edges[i], &edges[j]);
            if determinant == IBig::ZERO {
                return Err("certificate: the two basis edges are parallel".to_owned());
            }
            Ok(vec![(-cross(rest, &edges[j]), determinant.clone()), (-cross(&edges[i], rest), determinant)])
        }
        [] | [_] => unsolvable(),
        _ => Err(format!("certificate: {} basis edges, at most two are needed", basis.len())),
    }
}
