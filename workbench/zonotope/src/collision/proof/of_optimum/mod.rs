//! Proofs of a location from an optimum of the kernel: a direction that separates, or coefficients that combine to
//! the displacement.
//!
//! | rung | proves | without room for rounding |
//! |---|---|---|
//! | `RoundedDirection` | outside: the facet's direction in doubles | the exact optimum |
//! | `RoundedCoefficients` | a member: one factor but for the two of the facet and a third ([`in_doubles`]) | the next one |
//! | `WellSpreadBasis` | a member: one factor but for three others, the two nearly parallel | the exact optimum |
//! | `DirectionOfDoubles` | outside, exactly: doubles near the exact direction ([`separation`]) | the next one |
//! | `RationalDirection` | outside, exactly: the direction itself | |
//! | `ScaledSigns` | a member, exactly: one factor for all generators off a basis ([`exactly`]) | the next one |
//! | `PivotedCoefficients` | a member, exactly: group after group of coefficients is rounded ([`pivot`]) | |

pub(crate) mod exactly;
mod in_doubles;
pub(crate) mod pivot;

use std::cmp::Ordering;

use self::exactly::Combination;
use self::in_doubles::witness;
use self::pivot::walk;
use super::at_vertex::in_doubles::location_by_pair;
use super::balance::basis::Basis;
use super::separation::{self, exact_rung};
use crate::collision::{Location, Separation, Witness};
use crate::lad::of_generators::certify::rounded_optimum::DecidedOptimum;
use crate::lad::of_generators::exact::solve::ExactOptimum;
use crate::lad::of_generators::ladder;
use crate::lad::of_generators::optimum::{FlatOptimum, Optimum};
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::Rational;
use crate::numeric::exact_linear::ExactVector;
use crate::tally::{Rung, Tally};
use crate::zonotope::location::Proof;

/// The location of the displacement of a query, with its proof, from an optimum for which no search was ended.
pub(in crate::collision) fn location(query: &dyn KernelQuery, optimum: &Optimum, tally: &mut dyn Tally) -> Location<3> {
    proof(query, optimum, None, tally).counted(tally).written(query)
}

/// The proof from an optimum, or the one with which the search was ended.
pub(in crate::collision) fn proof(
    query: &dyn KernelQuery,
    optimum: &Optimum,
    ended_with: Option<Proof>,
    tally: &mut dyn Tally,
) -> Proof {
    match optimum {
        Optimum::Center => of_center(query),
        Optimum::Separated(direction) => Proof::outside(*direction, Rung::RoundedDirection),
        Optimum::Ended => ended_with.expect("a search is ended where a proof was found"),
        Optimum::Rounded(decided) => of_decided(query, decided, tally),
        Optimum::Exact(exact) => of_exact(query, exact, &query.exact()),
        Optimum::Flat(flat) => of_flat(flat, ended_with, tally),
    }
}

/// The centre is a member with all coefficients 0, inside just when the generators span space.
fn of_center(query: &dyn KernelQuery) -> Proof {
    let witness = Witness { coefficients: vec![0.0; query.len()], basis: Vec::new() };
    if Basis::spanning(query, Basis::new(Vec::new())).0.rank() == 3 {
        Proof::inside(witness, Rung::ZeroDisplacement)
    } else {
        Proof::boundary(witness, Rung::ZeroDisplacement)
    }
}

/// The proof in doubles or in pairs of them, or that of the exact optimum where rounding leaves no room for either.
fn of_decided(query: &dyn KernelQuery, decided: &DecidedOptimum, tally: &mut dyn Tally) -> Proof {
    let p = query.rounded_displacement();
    let in_doubles = match decided.order {
        Ordering::Greater => separation::in_doubles(&decided.optimum, &p),
        _ => witness(query, &decided.optimum, &decided.cells, &p).map(|(witness, rung)| Proof::inside(witness, rung)),
    };
    // the facet may leave room in pairs of doubles
    in_doubles.or_else(|| location_by_pair(query, &p, decided.optimum.basis)).unwrap_or_else(|| {
        let exact = query.exact();
        of_exact(query, &ladder::exact_of(query, &exact, decided, tally), &exact)
    })
}

/// The exact proof. O(n).
fn of_exact(query: &dyn KernelQuery, optimum: &ExactOptimum, p: &ExactVector) -> Proof {
    match optimum.along.cmp(&optimum.reach) {
        Ordering::Greater => {
            let separation = separation::separation(query, p, &optimum.direction, &optimum.basis, &optimum.sum);
            Proof { rung: exact_rung(&separation), location: Location::Outside(separation) }
        }
        order => {
            let combination = Combination::new(query, optimum, p);
            let is_inner = order == Ordering::Less && combination.spans_space();
            let scaled = combination.witness();
            let rung = if scaled.is_some() { Rung::ScaledSigns } else { Rung::PivotedCoefficients };
            let witness = scaled.unwrap_or_else(|| walk(&combination, combination.factor()));
            if is_inner { Proof::inside(witness, rung) } else { Proof::boundary(witness, rung) }
        }
    }
}

/// The proof for a flat body from that for its prism: a flat body has no inside.
fn of_flat(flat: &FlatOptimum, ended_with: Option<Proof>, tally: &mut dyn Tally) -> Proof {
    let query = flat.prism.query();
    let Proof { location, rung } = proof(&query, &flat.optimum, ended_with, tally);
    let location = match flat.prism.lower(location.written(&query)) {
        Location::Inside(witness) | Location::Boundary(witness) => Location::Boundary(witness.into()),
        Location::Outside(Separation::Rounded(mut u)) => {
            u[flat.axis] = 0.0;
            Location::Outside(Separation::Rounded(u))
        }
        Location::Outside(Separation::Exact(mut u)) => {
            u[flat.axis] = Rational::ZERO;
            Location::Outside(Separation::Exact(u))
        }
    };
    Proof { location, rung }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::Status;
    use crate::collision::brute_force;
    use crate::interop::verifier::check_location;
    use crate::zonotope::query::Query;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    /// A lattice body, of space or flat, with a point of it, on it or beyond it.
    fn lattice(random: &mut Pcg64Mcg, round: usize) -> (Vec<[f64; 3]>, [f64; 3]) {
        let n = 3 + round % 6;
        let is_flat = round.is_multiple_of(7);
        let mut vector =
            || [0, 1, 2].map(|k| if is_flat && k == 2 { 0.0 } else { f64::from(random.random_range(-3..4)) });
        let body: Vec<[f64; 3]> = (0..n).map(|_| vector()).collect();
        let u = vector();
        let mut share = |v: &[f64; 3]| {
            let along = v[0] * u[0] + v[1] * u[1] + v[2] * u[2];
            if along == 0.0 { f64::from(random.random_range(-4..5)) / 4.0 } else { along.signum() }
        };
        let factor = [1.0, 0.75, 1.0 - 2f64.powi(-30), 1.0 + 2f64.powi(-30), 1.25, 1.0][round % 6];
        let mut p = [0.0; 3];
        for v in &body {
            let own = share(v);
            p = [0, 1, 2].map(|k| p[k] + factor * own * v[k]);
        }
        (body, p)
    }

    /// Whether the coefficients of a witness's basis are near those that the others imply.
    fn is_near(query: &Query<'_, 3>, witness: &Witness) -> bool {
        let exact = witness.clone().with_nearest_basis(query);
        exact.coefficients.iter().zip(&witness.coefficients).all(|(exact, own)| (exact - own).abs() < 1e-9)
    }

    fn optimum_of(query: &Query<'_, 3>) -> (ExactVector, ExactOptimum) {
        let p = query.exact();
        let optimum = ExactOptimum::of_whole(query, &p, None, &mut ());
        (p, optimum)
    }

    #[test]
    fn exact_optima_prove_where_points_of_lattices_are() {
        let random = &mut Pcg64Mcg::seed_from_u64(131);
        let mut counts = [0; 3];
        for round in 0..400 {
            let (body, p) = lattice(random, round);
            if p == [0.0; 3] {
                continue;
            }
            let query = Query::new([0.0; 3], p, &body).expect("finite");
            let (exact, optimum) = optimum_of(&query);
            let proof = of_exact(&query, &optimum, &exact);
            let status = brute_force::locate(&query).status();
            assert_eq!(proof.location.status(), status, "{body:?} {p:?}");
            let written = proof.location.written(&query);
            assert_eq!(check_location(&query, &written).proof().map(drop), Ok(()), "{body:?} {p:?}");
            counts[Status::ALL.iter().position(|own| *own == status).expect("one of three")] += 1;
            if status == Status::Boundary && optimum.reach == optimum.along {
                assert_eq!(proof.rung, Rung::ScaledSigns, "{body:?} {p:?}");
            }
        }
        assert!(counts.iter().all(|count| *count > 40), "{counts:?}");
    }

    #[test]
    fn one_factor_is_enough_for_nearly_all_inner_points_of_space() {
        let random = &mut Pcg64Mcg::seed_from_u64(132);
        let mut scaled = 0;
        for _ in 0..60 {
            let body: Vec<[f64; 3]> = (0..6).map(|_| [0, 1, 2].map(|_| random.random_range(-1.0..1.0f64))).collect();
            let direction = [0, 1, 2].map(|_| random.random_range(-1.0..1.0f64));
            let gauge = brute_force::gauge(&Query::new([0.0; 3], direction, &body).expect("finite")).value;
            let p = direction.map(|c| 0.8 * c / gauge);
            let query = Query::new([0.0; 3], p, &body).expect("finite");
            let (exact, optimum) = optimum_of(&query);
            let combination = Combination::new(&query, &optimum, &exact);
            assert!(combination.spans_space() && (combination.factor() - 0.8).abs() < 1e-12);
            let Some(witness) = combination.witness() else { continue };
            let magnitude = |i: usize| witness.coefficients[i].abs();
            let off: Vec<f64> = (0..6).filter(|i| !witness.basis.contains(i)).map(magnitude).collect();
            assert!(off.iter().all(|c| *c == off[0] && (*c - 0.8).abs() < 1e-12 || *c == 1.0), "{witness:?}");
            assert!(is_near(&query, &witness), "{witness:?}");
            assert!(check_location(&query, &Location::Inside(witness)).is_right());
            scaled += 1;
        }
        assert!(scaled >= 55, "{scaled}");
    }

    #[test]
    fn the_centre_is_inside_just_when_the_generators_span_space() {
        let body = [[1.0, 2.0, 2.0], [2.0, 1.0, -2.0], [3.0, 3.0, 0.0], [0.0, 0.0, 1.0]];
        for (n, status) in [(0, Status::Boundary), (1, Status::Boundary), (3, Status::Boundary), (4, Status::Inside)] {
            let query = Query::new([0.5; 3], [0.5; 3], &body[..n]).expect("finite");
            let proof = of_center(&query);
            assert_eq!((proof.location.status(), proof.rung), (status, Rung::ZeroDisplacement), "{n}");
            assert!(check_location(&query, &proof.location.written(&query)).is_right(), "{n}");
        }
    }

    /// The walk ends with a proof whatever the factor that it gives to nearly all generators.
    #[test]
    fn walks_end_with_a_proof() {
        let random = &mut Pcg64Mcg::seed_from_u64(133);
        let mut walked = 0;
        for round in 0..600 {
            let (body, p) = lattice(random, round);
            if p == [0.0; 3] {
                continue;
            }
            let query = Query::new([0.0; 3], p, &body).expect("finite");
            let (exact, optimum) = optimum_of(&query);
            if optimum.along > optimum.reach {
                continue;
            }
            let combination = Combination::new(&query, &optimum, &exact);
            let is_inner = optimum.along < optimum.reach && combination.spans_space();
            for factor in [combination.factor(), 1.0, 0.5] {
                let witness = walk(&combination, factor);
                assert!(is_near(&query, &witness), "{body:?} {p:?} {witness:?}");
                let location = if is_inner { Location::Inside(witness) } else { Location::Boundary(witness) };
                let checked = check_location(&query, &location).proof().map(drop);
                assert_eq!(checked, Ok(()), "{body:?} {p:?} {factor} {location:?}");
                walked += 1;
            }
        }
        assert!(walked > 300, "{walked}");
    }

    #[test]
    fn walks_keep_the_factor_where_the_basis_has_room() {
        let body =
            [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.25, 0.0, 0.5], [0.0, -0.25, 0.5], [0.0, 0.0, 0.25]];
        let p = [0.1, -0.1, 1.0];
        let query = Query::new([0.0; 3], p, &body).expect("finite");
        let (exact, optimum) = optimum_of(&query);
        let combination = Combination::new(&query, &optimum, &exact);
        for factor in [0.5, combination.factor(), 0.375] {
            let witness = walk(&combination, factor);
            let off: Vec<usize> = (0..6).filter(|i| !witness.basis.contains(i)).collect();
            assert_eq!(off.len(), 3, "{witness:?}");
            assert!(off.iter().all(|&i| witness.coefficients[i] == factor), "{witness:?} {factor}");
            assert!(check_location(&query, &Location::Inside(witness)).is_right());
        }
    }
}
