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
    proof(query, optimum, None, tally).counted(tally)
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
    let Proof { location, rung } = proof(&flat.prism.query(), &flat.optimum, ended_with, tally);
    let location = match flat.prism.lower(location) {
        Location::Inside(witness) | Location::Boundary(witness) => Location::Boundary(witness),
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
