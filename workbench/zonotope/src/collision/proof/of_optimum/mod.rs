//! Proofs of a location from an optimum of the kernel: a direction that separates, or coefficients that combine to
//! the displacement.
//!
//! | rung | what it proves | without room for rounding |
//! |---|---|---|
//! | `RoundedDirection` | outside: the facet's direction in doubles, with room for every rounding error | the exact optimum |
//! | `RoundedCoefficients` | a member: one factor for all generators but three, the two of the facet and a third ([`in_doubles`]) | `WellSpreadBasis` |
//! | `WellSpreadBasis` | a member: one factor for all generators but three others, where those of the facet are nearly parallel | the exact optimum |
//! | `DirectionOfDoubles` | outside, exactly: a direction of doubles near the exact one ([`separation`]) | `RationalDirection` |
//! | `RationalDirection` | outside, exactly: the direction itself | |
//! | `ScaledSigns` | a member, exactly: one factor for all generators off a basis ([`exactly`]) | `PivotedCoefficients` |
//! | `PivotedCoefficients` | a member, exactly: group after group of coefficients is rounded ([`pivot`]) | |

pub(crate) mod exactly;
mod in_doubles;
pub(crate) mod pivot;
pub(crate) mod separation;

use std::cmp::Ordering;

use self::exactly::Combination;
use self::in_doubles::witness;
use self::pivot::walk;
use super::at_vertex::in_doubles::location_by_pair;
use super::balance::basis::Basis;
use crate::collision::{Location, Separation, Witness};
use crate::lad::of_generators::certify::gauge_interval::DecidedOptimum;
use crate::lad::of_generators::exact::solve::ExactOptimum;
use crate::lad::of_generators::ladder;
use crate::lad::of_generators::optimum::{FlatOptimum, Optimum};
use crate::lad::of_generators::seam::generators::KernelQuery;
use crate::lad::of_generators::told::Told;
use crate::numeric::Rational;
use crate::numeric::exact_linear::ExactVector;
use crate::tally::{Rung, Tally};

/// Where the displacement of a query lies, with its proof, from the query's optimum.
pub(in crate::collision) fn location(query: &dyn KernelQuery, optimum: &Optimum, tally: &mut dyn Tally) -> Location<3> {
    match optimum {
        Optimum::Centre => of_center(query),
        Optimum::Told(told) => of_told(told.clone(), tally),
        Optimum::Rounded(decided) => of_decided(query, decided, tally),
        Optimum::Exact(exact) => of_exact(query, exact, &query.exact(), tally),
        Optimum::Flat(flat) => of_flat(flat, tally),
    }
}

/// The location that was proved without an optimum.
pub(crate) fn of_told(told: Told, tally: &mut dyn Tally) -> Location<3> {
    match told {
        Told::Separated(direction) => {
            tally.answered_by(Rung::RoundedDirection);
            Location::Outside(Separation::Rounded(direction))
        }
        Told::Beyond(separation) => {
            tally.answered_by(exact_rung(&separation));
            Location::Outside(separation)
        }
        Told::Combined { coefficients, basis } => {
            tally.answered_by(Rung::RoundedCoefficients);
            Location::Inside(Witness { coefficients, basis })
        }
        Told::Touching { coefficients, basis } => {
            tally.answered_by(Rung::ScaledSigns);
            Location::Boundary(Witness { coefficients, basis })
        }
    }
}

/// The rung of a direction that is proved without rounding.
fn exact_rung(separation: &Separation<3>) -> Rung {
    match separation {
        Separation::Rounded(_) => Rung::DirectionOfDoubles,
        Separation::Exact(_) => Rung::RationalDirection,
    }
}

/// The centre is a member with all coefficients 0, inside just when the generators span space.
fn of_center(query: &dyn KernelQuery) -> Location<3> {
    let witness = Witness { coefficients: vec![0.0; query.len()], basis: Vec::new() };
    if Basis::spanning(query, Basis::new(Vec::new())).0.rank() == 3 {
        Location::Inside(witness)
    } else {
        Location::Boundary(witness)
    }
}

/// The proof in doubles or in pairs of them, or that of the exact optimum where rounding leaves no room for either.
fn of_decided(query: &dyn KernelQuery, decided: &DecidedOptimum, tally: &mut dyn Tally) -> Location<3> {
    let p = query.rounded_displacement();
    let found = match decided.order {
        Ordering::Greater => separation::in_doubles(&decided.optimum, &p)
            .map(|direction| (Location::Outside(direction), Rung::RoundedDirection)),
        _ => witness(query, &decided.optimum, &decided.cells, &p)
            .map(|(witness, rung)| (Location::Inside(witness), rung)),
    };
    if let Some((location, rung)) = found {
        tally.answered_by(rung);
        return location;
    }
    // the facet may leave room in pairs of doubles
    let of_pair = |query| location_by_pair(&query, &p, decided.optimum.basis);
    if let Some(told) = query.as_query().and_then(of_pair) {
        return of_told(told, tally);
    }
    let exact = query.exact();
    let optimum = ladder::exact_of(query, &exact, decided, tally);
    of_exact(query, &optimum, &exact, tally)
}

/// The exact proof. O(n).
fn of_exact(query: &dyn KernelQuery, optimum: &ExactOptimum, p: &ExactVector, tally: &mut dyn Tally) -> Location<3> {
    match optimum.along.cmp(&optimum.reach) {
        Ordering::Greater => {
            let separation = separation::separation(query, p, &optimum.direction, &optimum.basis, &optimum.sum);
            tally.answered_by(exact_rung(&separation));
            Location::Outside(separation)
        }
        order => {
            let combination = Combination::new(query, optimum, p);
            let interior = order == Ordering::Less && combination.spans_space();
            let scaled = combination.witness();
            tally.answered_by(if scaled.is_some() { Rung::ScaledSigns } else { Rung::PivotedCoefficients });
            let witness = scaled.unwrap_or_else(|| walk(&combination, combination.factor()));
            if interior { Location::Inside(witness) } else { Location::Boundary(witness) }
        }
    }
}

/// The proof for a flat body from that for its prism: a flat body has no inside.
fn of_flat(flat: &FlatOptimum, tally: &mut dyn Tally) -> Location<3> {
    match flat.prism.lower(location(&flat.prism.query(), &flat.optimum, tally)) {
        Location::Inside(witness) | Location::Boundary(witness) => Location::Boundary(witness),
        Location::Outside(Separation::Rounded(mut u)) => {
            u[flat.axis] = 0.0;
            Location::Outside(Separation::Rounded(u))
        }
        Location::Outside(Separation::Exact(mut u)) => {
            u[flat.axis] = Rational::ZERO;
            Location::Outside(Separation::Exact(u))
        }
    }
}
