//! Answers to "how many times must Z = { Σ δ_i g_i : |δ_i| ≤ 1 } be taken to hold the vector p".
//!
//! The gauge is at least u · p / Σ |u · g_i| for every direction u. Where the certificate is tight it names the d − 1
//! generators that span a facet through which p leaves Z: the direction u orthogonal to them gives that bound, and
//! solving λ p = Σ ± g_i + Σ over the facet of x_j g_j with all |x_j| ≤ 1 shows that the gauge is at most 1/λ, the
//! same number. Else the facets of a small Z are gone through one by one, in the plane those of any; of a large one
//! only what the certificate says is known.

use std::cmp::Ordering;
use std::fmt::{self, Display};

use dashu_int::IBig;
use dashu_int::ops::Abs;

use super::displaced::Displaced;
use super::location::{Coefficients, Located, LocationCertificate, proven};
use crate::RELATIVE_ERROR;
use crate::exact::linear::{Echelon, Vector, dot, is_zero};
use crate::exact::proportion::{Proportion, check_figure};
use crate::exact::subsets::subsets;
use crate::faces::facets::{Facets, reach};
use crate::verdict::{Stop, Verdict};

/// An answer as it was written.
#[derive(Debug, Clone, PartialEq)]
pub struct GaugeAnswer {
    /// The claimed gauge.
    pub gauge: f64,
    /// Whether it is at most 1.
    pub at_most_one: bool,
    /// The proof that p lies in Z or does not.
    pub certificate: LocationCertificate,
}

/// The gauge that was proved, up to rounding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GaugeProof {
    /// The gauge as it was written.
    pub gauge: f64,
}

impl Display for GaugeProof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "gauge {:?} is the exact gauge, rounded", self.gauge)
    }
}

/// Proves the gauge, or says what fails. The value may err by the relative [`RELATIVE_ERROR`]; the largest double
/// stands for any finite gauge that is larger. Where the facet is not found, the value is held against what the
/// certificate bounds and left unchecked.
pub fn check_gauge(question: &Displaced, answer: &GaugeAnswer) -> Verdict<GaugeProof> {
    proved(question, answer).into()
}

fn proved(question: &Displaced, answer: &GaugeAnswer) -> Result<GaugeProof, Stop> {
    let right = GaugeProof { gauge: answer.gauge };
    let expect = |exact: f64, reason: &str| -> Result<GaugeProof, Stop> {
        if answer.gauge == exact {
            Ok(right)
        } else {
            Err(format!("gauge is {:?}, but it is {exact:?}: {reason}", answer.gauge).into())
        }
    };
    let found = proven(question, &answer.certificate)?;
    if answer.at_most_one != matches!(found, Located::Member(_)) {
        return Err("at_most_one is not what the certificate proves".into());
    }
    let span = Echelon::spanned(question.dimension(), &question.generators);
    if !span.contains(&question.p) {
        return expect(f64::INFINITY, "the vector leaves the span of the generators");
    }
    if is_zero(&question.p) {
        return expect(0.0, "the vector is zero");
    }
    // In coordinates that tell the vectors of the span apart, Z has an interior.
    let pivots = span.pivots();
    let projected = |v: &Vector| -> Vector { pivots.iter().map(|&axis| v[axis].clone()).collect() };
    let p = projected(&question.p);
    let generators: Vec<Vector> = question.generators.iter().map(projected).collect();

    let wanted = p.len() + 2;
    let few = match &found {
        Located::Member(coefficients) => freest(coefficients, wanted),
        Located::Outside(u) => flattest(&question.generators, u, wanted),
    };
    let named = independent(&generators, &few, p.len() - 1);
    let exact = named
        .iter()
        .find_map(|facet| tight_gauge(&p, &generators, facet, &found).or_else(|| facet_gauge(&p, &generators, facet)));
    let exact = exact.or_else(|| searched(&p, &generators));
    if let Some(exact) = exact {
        check_gauge_figure("gauge", answer.gauge, &exact)?;
        return Ok(right);
    }
    if !answer.gauge.is_finite() {
        return Err(format!("gauge is {}", answer.gauge).into());
    }
    let claimed = Proportion::of_double(answer.gauge);
    let slack = Proportion::of_double(1.0 + RELATIVE_ERROR);
    let in_bounds = match &found {
        Located::Member(coefficients) => {
            let bound = Proportion::new(largest(coefficients), coefficients.denominator.clone(), 0);
            claimed.compare(&bound.times(&slack)) != Ordering::Greater
        }
        Located::Outside(u) => {
            let bound = Proportion::new(dot(u, &question.p), question.support(u), 0);
            bound.compare(&claimed.times(&slack)) != Ordering::Greater
        }
    };
    if in_bounds {
        Err(Stop::Unchecked(format!(
            "gauge {:?} agrees with its certificate, which bounds the gauge on one side alone",
            answer.gauge
        )))
    } else {
        Err(format!("gauge is {:?}, against its own certificate", answer.gauge).into())
    }
}

/// Accepts the gauge of a vector in the span of the generators, but for rounding: it is finite, and the largest double
/// stands for whatever is larger.
pub(super) fn check_gauge_figure(name: &str, claimed: f64, exact: &Proportion) -> Result<(), String> {
    let is_beyond = exact.compare(&Proportion::of_double(f64::MAX)).is_gt();
    if claimed.is_finite() && !(claimed == f64::MAX && is_beyond) {
        let allowed = exact.times(&Proportion::of_double(RELATIVE_ERROR));
        return check_figure(name, claimed, exact, &allowed);
    }
    if claimed.is_finite() {
        return Ok(());
    }
    let truth =
        if is_beyond { "finite, but above the largest double".to_owned() } else { format!("{:?}", exact.nearest()) };
    Err(format!("{name} is {claimed:?}, exactly it is {truth}"))
}

/// The generators with the smallest coefficients, ascending.
fn freest(coefficients: &Coefficients, wanted: usize) -> Vec<usize> {
    let mut order: Vec<(IBig, usize)> =
        (0..).zip(&coefficients.numerators).map(|(index, numerator)| (numerator.clone().abs(), index)).collect();
    let few = wanted.min(order.len());
    if few < order.len() {
        order.select_nth_unstable(few);
        order.truncate(few);
    }
    order.sort_unstable();
    order.into_iter().map(|(_, index)| index).collect()
}

fn largest(coefficients: &Coefficients) -> IBig {
    coefficients.numerators.iter().map(|numerator| numerator.clone().abs()).max().unwrap_or_default()
}

/// The generators that a direction is most nearly orthogonal to.
fn flattest(generators: &[Vector], u: &[IBig], wanted: usize) -> Vec<usize> {
    let mut order: Vec<(Proportion, usize)> = (0..)
        .zip(generators)
        .filter(|(_, generator)| !is_zero(generator))
        .map(|(index, generator)| {
            let size: IBig = generator.iter().map(|component| component.clone().abs()).sum();
            (Proportion::new(dot(u, generator).abs(), size, 0), index)
        })
        .collect();
    let by_angle = |a: &(Proportion, usize), b: &(Proportion, usize)| a.0.compare(&b.0).then(a.1.cmp(&b.1));
    let few = wanted.min(order.len());
    if few < order.len() {
        order.select_nth_unstable_by(few, by_angle);
        order.truncate(few);
    }
    order.sort_by(by_angle);
    order.into_iter().map(|(_, index)| index).collect()
}

/// The subsets of a few generators that could span a facet.
fn independent(generators: &[Vector], few: &[usize], size: usize) -> Vec<Vec<usize>> {
    let candidates = subsets(few.len(), size).map(|subset| subset.into_iter().map(|index| few[index]).collect());
    candidates
        .filter(|subset: &Vec<usize>| {
            let mut span = Echelon::default();
            subset.iter().all(|&index| span.insert(&generators[index]))
        })
        .collect()
}

/// The largest coefficient of a member, if the facet's direction bounds the gauge by the same number from below.
fn tight_gauge(p: &Vector, generators: &[Vector], facet: &[usize], found: &Located) -> Option<Proportion> {
    let Located::Member(coefficients) = found else { return None };
    let above = Proportion::new(largest(coefficients), coefficients.denominator.clone(), 0);
    let u = normal(p, generators, facet)?;
    let below = Proportion::new(dot(&u, p), reach(generators, &u), 0);
    (above.compare(&below) == Ordering::Equal).then_some(above)
}

/// The gauge, if p leaves Z through the facet of these generators: through Σ ± g_i plus the zonotope of all that span
/// the facet.
fn facet_gauge(p: &Vector, generators: &[Vector], facet: &[usize]) -> Option<Proportion> {
    let u = normal(p, generators, facet)?;
    let mut corner = vec![IBig::ZERO; p.len()];
    let mut on_facet: Vec<Vector> = Vec::new();
    for generator in generators {
        match dot(&u, generator).cmp(&IBig::ZERO) {
            Ordering::Equal => on_facet.push(generator.clone()),
            Ordering::Less => corner.iter_mut().zip(generator).for_each(|(sum, component)| *sum -= component),
            Ordering::Greater => corner.iter_mut().zip(generator).for_each(|(sum, component)| *sum += component),
        }
    }
    // p / gauge = corner + rest / along.
    let (along, reach) = (dot(&u, p), dot(&u, &corner));
    let rest: Vector = p.iter().zip(&corner).map(|(p, corner)| p * &reach - corner * &along).collect();
    if !is_zero(&rest) {
        let pivots = Echelon::spanned(p.len(), &on_facet).pivots();
        let projected = |v: &Vector| -> Vector { pivots.iter().map(|&axis| v[axis].clone()).collect() };
        let beside = searched(&projected(&rest), &on_facet.iter().map(projected).collect::<Vec<_>>())?;
        if beside.compare(&Proportion::whole(along.clone(), 0)) == Ordering::Greater {
            return None;
        }
    }
    Some(Proportion::new(along, reach, 0))
}

/// The direction orthogonal to the facet's generators in which p lies, if it is one direction.
fn normal(p: &Vector, generators: &[Vector], facet: &[usize]) -> Option<Vector> {
    let span = Echelon::spanned(p.len(), facet.iter().map(|&index| &generators[index]));
    let [u] = <[Vector; 1]>::try_from(span.complement(p.len())).ok()?;
    let along = dot(&u, p);
    if along == IBig::ZERO {
        return None;
    }
    Some(if along < IBig::ZERO { u.into_iter().map(|component| -component).collect() } else { u })
}

/// The gauge as the largest of u · p / Σ |u · g_i| over all facets, if they are few enough.
fn searched(p: &Vector, generators: &[Vector]) -> Option<Proportion> {
    Some(Facets::of(p.len(), generators, std::slice::from_ref(p))?.gauge(0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::LocationCertificate;

    fn check(p: &[f64], generators: &[&[f64]], gauge: f64, certificate: LocationCertificate) -> Result<f64, String> {
        let generators: Vec<Vec<f64>> = generators.iter().map(|generator| generator.to_vec()).collect();
        let question = Displaced::new(&vec![0.0; p.len()], p, &generators).expect("one dimension");
        check_gauge(&question, &GaugeAnswer { gauge, at_most_one: gauge <= 1.0, certificate })
            .proof()
            .map(|proof| proof.gauge)
    }

    fn witness(coefficients: &[f64], basis: &[usize]) -> LocationCertificate {
        LocationCertificate::Witness { coefficients: coefficients.to_vec(), basis: basis.to_vec() }
    }

    fn separation(u: &[i64]) -> LocationCertificate {
        LocationCertificate::Separation(u.iter().copied().map(IBig::from).collect())
    }

    const SQUARE: [&[f64]; 2] = [&[1.0, 0.0], &[0.0, 1.0]];

    #[test]
    fn a_square_by_hand() {
        assert_eq!(check(&[0.5, 0.25], &SQUARE, 0.5, witness(&[0.5, 0.25], &[])), Ok(0.5));
        assert_eq!(check(&[3.0, 0.5], &SQUARE, 3.0, separation(&[5, 1])), Ok(3.0));
        assert_eq!(check(&[0.0, 0.0], &SQUARE, 0.0, witness(&[0.0, 0.0], &[])), Ok(0.0));
        assert_eq!(check(&[1.0, 1.0], &SQUARE, 1.0, witness(&[1.0, 1.0], &[])), Ok(1.0));
        assert!(check(&[3.0, 0.5], &SQUARE, 3.001, separation(&[5, 1])).is_err());
        assert!(check(&[0.5, 0.25], &SQUARE, 0.75, witness(&[0.5, 0.25], &[])).is_err());
        assert!(check(&[0.5, 0.25], &SQUARE, 0.25, witness(&[0.5, 0.25], &[])).is_err());
    }

    #[test]
    fn flat_bodies_have_a_gauge_in_their_span() {
        let segment: [&[f64]; 2] = [&[1.0, 1.0, 0.0], &[2.0, 2.0, 0.0]];
        assert_eq!(check(&[6.0, 6.0, 0.0], &segment, 2.0, separation(&[1, 1, 0])), Ok(2.0));
        assert_eq!(check(&[1.0, 1.0, 1.0], &segment, f64::INFINITY, separation(&[0, 0, 1])), Ok(f64::INFINITY));
        assert!(check(&[1.0, 1.0, 1.0], &segment, 5.0, separation(&[0, 0, 1])).is_err());
    }

    #[test]
    fn a_gauge_beyond_all_doubles_is_the_largest_one_and_not_infinite() {
        let segment: [&[f64]; 1] = [&[1e-300]];
        assert_eq!(check(&[1e300], &segment, f64::MAX, separation(&[1])), Ok(f64::MAX));
        assert!(check(&[1e300], &segment, f64::INFINITY, separation(&[1])).is_err());
        assert!(check(&[1e300], &segment, 1e300, separation(&[1])).is_err());
        assert!(check(&[1e-200], &segment, f64::MAX, separation(&[1])).is_err(), "it is 1e100");
    }

    fn vectors(rows: &[&[i64]]) -> Vec<Vector> {
        rows.iter().map(|row| row.iter().copied().map(IBig::from).collect()).collect()
    }

    /// A facet that the vector leaves through tells the gauge, and another one tells nothing: held to all facets.
    #[test]
    fn facets_that_are_named_tell_the_gauge_or_nothing() {
        let bodies = [
            vectors(&[&[5, 1, 2], &[-1, 4, 3], &[2, -3, 6], &[4, 4, -5], &[-6, 2, 1]]),
            // three in a plane, two in parallel
            vectors(&[&[2, 0, 0], &[0, 3, 0], &[1, 1, 0], &[0, 0, 4], &[0, 0, -8]]),
        ];
        let points = vectors(&[&[3, 2, 1], &[-7, 20, 4], &[1, 0, 9], &[0, 5, 0], &[40, -3, -2], &[3, 4, 12]]);
        for generators in &bodies {
            let pairs = independent(generators, &[4, 2, 0, 1, 3], 2);
            assert!(pairs.iter().all(|pair| pair.len() == 2) && pairs.len() >= 9, "{pairs:?}");
            for p in &points {
                let exact = searched(p, generators).expect("there are few facets");
                let told: Vec<Proportion> =
                    pairs.iter().filter_map(|facet| facet_gauge(p, generators, facet)).collect();
                assert!(!told.is_empty() && told.len() < pairs.len(), "{generators:?} {p:?}");
                assert!(told.iter().all(|gauge| gauge.compare(&exact).is_eq()), "{generators:?} {p:?}");
            }
        }
        let box_of_three = vectors(&[&[2, 0, 0], &[0, 3, 0], &[0, 0, 4]]);
        let member = |numerators: &[i64]| {
            let numerators = numerators.iter().copied().map(IBig::from).collect();
            Located::Member(Coefficients { numerators, denominator: IBig::from(8) })
        };
        let p = &vectors(&[&[1, 0, 2]])[0];
        let tight = |facet: &[usize], numerators| tight_gauge(p, &box_of_three, facet, &member(numerators));
        assert!(tight(&[1, 2], &[4, 0, 4]).is_some_and(|gauge| gauge.nearest() == 0.5));
        assert!(tight(&[1, 2], &[-5, 0, 4]).is_none(), "the coefficients bound the gauge by another number");
        assert!(tight(&[0, 2], &[4, 0, 4]).is_none(), "the vector lies along the facet");
    }

    #[test]
    fn generators_of_the_facet_are_sought_where_the_certificate_points() {
        let numerators = [5, -1, 0, 3, -4].map(IBig::from).to_vec();
        let coefficients = Coefficients { numerators, denominator: IBig::from(5) };
        assert_eq!((freest(&coefficients, 3), freest(&coefficients, 9)), (vec![2, 1, 3], vec![2, 1, 3, 4, 0]));
        assert_eq!(largest(&coefficients), IBig::from(5));
        let generators = vectors(&[&[4, 4], &[0, 0], &[-1, 5], &[3, 0], &[6, -7]]);
        let u = [1, 1].map(IBig::from);
        assert_eq!(flattest(&generators, &u, 2), [4, 2], "the quotients are 1, 4/6, 1 and 1/13");
        assert_eq!(flattest(&generators, &u, 9), [4, 2, 0, 3]);
        assert_eq!(independent(&vectors(&[&[1, 2], &[0, 0], &[2, 4]]), &[2, 1, 0], 1), [[2], [0]]);
    }

    /// A body in five dimensions with more facets than are gone through: half a vertex, and twice a vertex.
    #[test]
    fn figures_against_their_own_certificate_are_wrong_where_no_facet_is_found() {
        let generators: Vec<Vec<f64>> =
            (1..=44).map(|t: i64| (0..5).map(|power| (t.pow(power) % 97) as f64 + 1.0).collect()).collect();
        let sum: Vec<f64> = (0..5).map(|axis| generators.iter().map(|g| g[axis]).sum()).collect();
        let rows: Vec<&[f64]> = generators.iter().map(Vec::as_slice).collect();
        let half: Vec<f64> = sum.iter().map(|x| x / 2.0).collect();
        let member = |gauge| check(&half, &rows, gauge, witness(&[0.5; 44], &[]));
        let is_open = |answer: Result<f64, String>| answer.is_err_and(|reason| reason.contains("on one side alone"));
        assert!(is_open(member(0.5)) && is_open(member(0.25)));
        assert!(member(0.51).is_err_and(|reason| reason.contains("against its own certificate")));
        let twice: Vec<f64> = sum.iter().map(|x| x * 2.0).collect();
        let outside = |gauge| check(&twice, &rows, gauge, separation(&[1; 5]));
        assert!(is_open(outside(2.0)) && is_open(outside(3.0)));
        assert!(outside(1.99).is_err_and(|reason| reason.contains("against its own certificate")));
        assert!(outside(f64::INFINITY).is_err_and(|reason| !reason.contains("certificate")));
    }

    /// Forty segments along the first axis and one along each of four others have too many facets to go through, but
    /// the smallest coefficients name the one through which the vector leaves.
    #[test]
    fn a_named_facet_tells_the_gauge_of_a_body_with_too_many_facets() {
        let unit = |axis: usize| -> Vec<f64> { (0..5).map(|k| f64::from(u8::from(k == axis))).collect() };
        let generators: Vec<Vec<f64>> = [0; 40].into_iter().chain(1..5).map(unit).collect();
        let rows: Vec<&[f64]> = generators.iter().map(Vec::as_slice).collect();
        assert!(searched(&vectors(&[&[1; 5]])[0], &vectors(&[[1, 2, 3, 4, 5].as_slice(); 44])).is_none());
        let coefficients = [[0.5; 40].as_slice(), &[0.25; 4]].concat();
        let p = [20.0, 0.25, 0.25, 0.25, 0.25];
        assert_eq!(check(&p, &rows, 0.5, witness(&coefficients, &[])), Ok(0.5));
        assert!(check(&p, &rows, 0.25, witness(&coefficients, &[])).is_err());
    }
}
