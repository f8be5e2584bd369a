//! Location and gauge of a displacement, from the explicit faces of the zonotope: the baseline with the size of the
//! output.
//!
//! # Statement
//! Input: a [`Query`] p and generators of R^D, D ≤ 3. Output: its [`Location`] relative to Z = { Σ δ_i g_i : |δ_i| ≤ 1
//! } with a proof, and the [`Gauge`]. Touching is [`Location::Boundary`], and so is every member of a flat Z. Zero,
//! parallel and coplanar generators and none at all are ordinary input.
//!
//! # Source
//! Section 5.1 sets out to avoid this: the n(n − 1) facets that Section 3 counts, one after the other.
//!
//! # Method
//! 1. Exact elimination finds the span of the generators; a p off it is separated. Axes that leave the span become
//!    generators, too, which changes neither gauge nor witness of a p in it and makes the body solid.
//! 2. The face lattice (`zonotope::faces`). A facet's normal u is the cross product of two generators, its support u ·
//!    v with any of its vertices; the gauge is the largest |u · p| / (u · v).
//! 3. Facets that floating point cannot tell from the largest are evaluated exactly, from the generators.
//! 4. The largest facet separates, or p is in that facet's multiple, where its coefficients are found as in
//!    [`brute_force`](super::brute_force).
//!
//! # Complexity
//! n generators, f = O(n²) facets: O(n² log n) time for the lattice and O(f) space; O(n) exact operations a facet that
//! is in doubt.
//!
//! # Shapes
//! generators: n × D, any order, duplicates allowed.
//!
//! # Numerics
//! Every decision is exact; the gauge is rounded within `error`.
//!
//! # Errors
//! [`FacesError::TooManyDirections`] ⇔ the lattice would not fit 32-bit indices.
//!
//! # Checked by
//! [`brute_force`](super::brute_force) on every family, the crate `verifier` for each proof.
//!
//! # Example
//! ```
//! use zonotope::collision::{Query, Status, by_explicit_faces};
//! let cube = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
//! let question = Query::new([0.0; 3], [2.0, 1.0, 0.0], &cube).unwrap();
//! let gauge = by_explicit_faces::gauge(&question, &mut ()).unwrap();
//! assert_eq!((gauge.value, gauge.location.status()), (2.0, Status::Outside));
//! ```

use super::proof::balance::solve::near_witness;
use super::proof::tightest_facet::{TightestFacet, Vector};
use super::proof::to_doubles::rounded_off_a_basis;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, Span, cross, dot, exact, rounded_direction};
use crate::numeric::scaling::{binary_exponent, largest_magnitude, scale_by_power_of_two};
use crate::numeric::tolerance::PRODUCT_OF_ROUNDED_VECTORS;
use crate::tally::{Operation, Tally};
use crate::zonotope::Zonotope;
use crate::zonotope::faces::{FaceLattice, Faces, FacesError, Facet, faces};
use crate::zonotope::location::{Gauge, Location, Separation, Witness};
use crate::zonotope::query::Query;

/// Where a displacement lies relative to the zonotope of its generators, with a proof.
///
/// # Errors
/// [`FacesError::TooManyDirections`].
pub fn locate<const D: usize>(question: &Query<'_, D>, tally: &mut impl Tally) -> Result<Location<D>, FacesError> {
    Ok(gauge(question, tally)?.location)
}

/// The gauge of a displacement and where it lies.
///
/// A line evaluation is counted for each facet, an exact fallback for each that is in doubt.
///
/// # Errors
/// [`FacesError::TooManyDirections`].
pub fn gauge<const D: usize>(question: &Query<'_, D>, tally: &mut impl Tally) -> Result<Gauge<D>, FacesError> {
    const { assert!(D <= 3, "the face lattice is that of a body in space") }
    let displacement = question.exact();
    let point = displacement.to_vec();
    let generators: Vec<Vector> = question.generators().map(|g| g.map(Dyadic::from_f64).to_vec()).collect();
    let span = Span::of(generators.iter().cloned(), D);
    if let Some(direction) = span.direction_to(&point) {
        let direction = std::array::from_fn(|k| direction[k].clone());
        let location = Location::Outside(Separation::near(question, &direction));
        return Ok(Gauge { value: f64::INFINITY, error: 0.0, location });
    }
    if point.iter().all(Dyadic::is_zero) {
        let witness = Witness { coefficients: vec![0.0; question.len()], basis: Vec::new() };
        let location = if span.rank() == D { Location::Inside(witness) } else { Location::Boundary(witness) };
        return Ok(Gauge { value: 0.0, error: 0.0, location });
    }
    let tightest = tightest(&solid(question, &span), &in_space(&displacement), tally)?;
    let facet = TightestFacet { normal: tightest.normal[..D].to_vec(), ..tightest };
    let location = if facet.along_point > facet.along_zonotope {
        let direction = std::array::from_fn(|k| facet.normal[k].clone());
        Location::Outside(Separation::near(question, &direction))
    } else {
        let coefficients = facet.coefficients(&point, &generators);
        let rounded = coefficients.iter().map(|c| c.to_f64().value().clamp(-1.0, 1.0)).collect();
        let witness = near_witness(question, &displacement, rounded).map(|(witness, _)| witness);
        let rational = |i: usize| generators[i].iter().map(Dyadic::to_rational).collect();
        let witness = witness.unwrap_or_else(|| rounded_off_a_basis(coefficients, rational));
        let is_inside = facet.along_point < facet.along_zonotope && span.rank() == D;
        if is_inside { Location::Inside(witness) } else { Location::Boundary(witness) }
    };
    let value = facet.along_point.rounded_ratio(&facet.along_zonotope);
    Ok(if value < f64::MAX {
        Gauge { value, error: value * f64::EPSILON + f64::from_bits(1), location }
    } else {
        Gauge { value: f64::MAX, error: f64::INFINITY, location }
    })
}

/// The generators in space, and an axis more for each direction that they leave out.
fn solid<const D: usize>(question: &Query<'_, D>, span: &Span) -> Vec<[f64; 3]> {
    let padded = |g: &[f64; D]| std::array::from_fn(|k| g.get(k).copied().unwrap_or(0.0));
    let mut generators: Vec<[f64; 3]> = question.generators().map(padded).collect();
    let largest = largest_magnitude(generators.as_flattened());
    let size = scale_by_power_of_two(1.0, binary_exponent(largest).map_or(0, i64::from));
    for axis in span.other_coordinates().chain(D..3) {
        generators.push(std::array::from_fn(|k| if k == axis { size } else { 0.0 }));
    }
    generators
}

fn in_space<const D: usize>(vector: &[Dyadic; D]) -> ExactVector {
    std::array::from_fn(|k| vector.get(k).cloned().unwrap_or(Dyadic::zero()))
}

/// The facet of a solid body whose multiple has the point on its boundary.
fn tightest(generators: &[[f64; 3]], point: &ExactVector, tally: &mut impl Tally) -> Result<TightestFacet, FacesError> {
    let body = Zonotope::new([0.0; 3], generators.to_vec()).expect("a displacement has finite generators");
    let Faces::Solid(lattice) = faces(&body, &mut ())? else {
        unreachable!("the axes off the span make the body solid")
    };
    let half = lattice.facet_count() as u32 / 2;
    tally.add(Operation::LineEvaluation, u64::from(half));
    let probe = Probe::new(&lattice, point);
    let bounds: Vec<[f64; 2]> = (0..half).map(|facet| probe.bounds(&lattice, Facet(facet))).collect();
    let greatest_lower_bound = bounds.iter().fold(0.0f64, |best, [low, _]| best.max(*low));
    let mut best: Option<TightestFacet> = None;
    for facet in (0..half).filter(|&facet| bounds[facet as usize][1] >= greatest_lower_bound).map(Facet) {
        tally.add(Operation::ExactFallback, 1);
        let normal = exact_normal(&lattice, facet);
        let along = dot(&normal, point);
        let turned = if along.sign().is_lt() { normal.map(|v| -v) } else { normal };
        let along_zonotope = generators.iter().fold(Dyadic::zero(), |sum, g| sum + dot(&turned, &exact(*g)).abs());
        let along_point = along.abs();
        if best.as_ref().is_none_or(|b| &along_point * &b.along_zonotope > &b.along_point * &along_zonotope) {
            best = Some(TightestFacet { normal: turned.to_vec(), along_point, along_zonotope });
        }
    }
    Ok(best.expect("a solid body has facets, and the one with the largest certain bound is among those tried"))
}

/// Two generators that span a facet.
fn edges(lattice: &FaceLattice, facet: Facet) -> [usize; 2] {
    let generator = |zone| lattice.zone_generators(zone).next().expect("a zone has a generator").generator;
    let mut zones = lattice.facet_zones(facet).map(generator);
    [(); 2].map(|()| zones.next().expect("two zones meet in a facet"))
}

fn exact_normal(lattice: &FaceLattice, facet: Facet) -> ExactVector {
    let [a, b] = edges(lattice, facet).map(|g| exact(lattice.body().generators()[g]));
    cross(&a, &b)
}

/// A point with what bounds its gauge by one facet.
struct Probe {
    /// A multiple of the point.
    direction: [f64; 3],
    /// The generators, scaled to magnitude at most 2.
    generators: Vec<[f64; 3]>,
    vertex_error: [f64; 3],
}

impl Probe {
    fn new(lattice: &FaceLattice, point: &ExactVector) -> Self {
        let generators = lattice.body().generators();
        let largest = largest_magnitude(generators.as_flattened());
        let scale = -binary_exponent(largest).map_or(0, i64::from);
        Self {
            direction: rounded_direction(point),
            generators: generators.iter().map(|g| g.map(|v| scale_by_power_of_two(v, scale))).collect(),
            vertex_error: lattice.coordinate_error(),
        }
    }

    /// Bounds of |u · direction| / (u · v) for a facet's normal u and vertex v.
    fn bounds(&self, lattice: &FaceLattice, facet: Facet) -> [f64; 2] {
        let [a, b] = edges(lattice, facet).map(|g| self.generators[g]);
        let minors: [[f64; 2]; 3] = [[1, 2], [2, 0], [0, 1]].map(|[i, j]| [a[i] * b[j], a[j] * b[i]]);
        let normal = minors.map(|[plus, minus]| plus - minus);
        // Three roundings, each at most half of this; and underflow.
        let normal_error =
            minors.map(|[plus, minus]| 2.0 * f64::EPSILON * (plus.abs() + minus.abs()) + f64::MIN_POSITIVE);
        let vertex = lattice.facet_vertices(facet).next().map_or([0.0; 3], |vertex| lattice.point(vertex));
        let product = |a: &[f64; 3]| {
            let terms: [f64; 3] = std::array::from_fn(|k| normal[k] * a[k]);
            let size: f64 = terms.iter().map(|t| t.abs()).sum();
            let from_normal: f64 = (0..3).map(|k| 1.01 * normal_error[k] * a[k].abs()).sum();
            let error = PRODUCT_OF_ROUNDED_VECTORS * size + from_normal + 4.0 * f64::MIN_POSITIVE;
            ((terms[0] + terms[1] + terms[2]).abs(), error)
        };
        let (along, error) = product(&self.direction);
        let (support, support_error) = product(&vertex);
        let from_vertex: f64 = (0..3).map(|k| 1.01 * (normal[k].abs() + normal_error[k]) * self.vertex_error[k]).sum();
        let (least, most) = (support - support_error - from_vertex, support + support_error + from_vertex);
        let low = ((along - error) / most * (1.0 - 4.0 * f64::EPSILON)).max(0.0);
        let high = if least > 0.0 { (along + error) / least * (1.0 + 4.0 * f64::EPSILON) } else { f64::INFINITY };
        // A NaN says nothing, and so does an infinite lower bound.
        [if low.is_finite() { low } else { 0.0 }, if high.is_nan() { f64::INFINITY } else { high }]
    }
}
