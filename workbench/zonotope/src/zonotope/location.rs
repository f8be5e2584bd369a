//! The answers to a [`Query`], each with its proof: a location, a gauge; and a location with the rung that proved it.

use std::array;
use std::fmt;

use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::tally::{Rung, Tally};
use crate::zonotope::pose::Standing;
use crate::zonotope::query::Query;

/// The place of a displacement p relative to the zonotope Z = { Σ δ_i g_i : |δ_i| ≤ 1 } of R^D, with the proof M of a
/// member.
#[derive(Debug, Clone, PartialEq)]
pub enum Location<const D: usize, M = Witness> {
    /// In the interior of Z (a flat Z has none): the interiors of two bodies meet.
    Inside(M),
    /// In Z, but not in its interior: two bodies only touch, or their sum is flat.
    Boundary(M),
    /// Not in Z: a point outside, two bodies that are disjoint.
    Outside(Separation<D>),
}

/// Where a point lies relative to a closed body: a [`Location`] without its proof.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Status {
    /// In the interior.
    Inside,
    /// In the body, but not in its interior.
    Boundary,
    /// Not in the body.
    Outside,
}

/// The proof of a displacement p that lies in Z: coefficients of the generators.
///
/// With the coefficients off the basis taken as they stand, those of the basis that solve Σ δ_i g_i = p exactly lie in
/// [−1, 1].
#[derive(Debug, Clone, PartialEq)]
pub struct Witness {
    /// A coefficient in [−1, 1] for each generator. Those of the basis are rounded: to doubles beside them in answers
    /// that bodies give ([`with_nearest_basis`](Self::with_nearest_basis)), to a few digits less in those of the
    /// methods.
    pub coefficients: Vec<f64>,
    /// Linearly independent generators, at most D of them, in increasing order.
    pub basis: Vec<usize>,
}

/// The coefficients of a displacement p that lies in Z by a rule of constant size, in space: f s_i with the sign s_i of
/// g_i · u, but for those of a basis, which make up for what is left of p.
#[derive(Debug, Clone, PartialEq)]
pub struct SignRule {
    /// The direction u, nearly orthogonal to the facet of Z that is nearest along the ray through p. Of a body under a
    /// pose g_i · u is the product with the direction that is carried back into the body.
    pub direction: [f64; 3],
    /// The factor f, from 0 to 1.
    pub factor: f64,
    /// Three linearly independent generators.
    pub basis: [usize; 3],
    /// The coefficients of the basis, to a few digits less than doubles have.
    pub(crate) own: [f64; 3],
}

/// The coefficients of a member as a method found them.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Coefficients {
    /// By a rule, for whoever does not read them.
    BySigns(SignRule),
    /// One for each generator.
    Written(Witness),
}

impl From<Witness> for Coefficients {
    fn from(witness: Witness) -> Self {
        Self::Written(witness)
    }
}

/// The proof of a displacement p that lies outside Z: a direction u with u · p > Σ |u · g_i|, exactly.
#[derive(Debug, Clone, PartialEq)]
pub enum Separation<const D: usize> {
    /// A direction of doubles.
    Rounded([f64; D]),
    /// A direction of rationals, for a gap so narrow that no direction of doubles near it was found to fit; in a box,
    /// as it is rare and would make every answer several times as large.
    Exact(Box<[Rational; D]>),
}

/// The gauge of a displacement p by a zonotope Z centred at the origin: min { t ≥ 0 : p ∈ t Z }, with the place of p.
///
/// Methods write the proof of that place as a [`Location`] at once; bodies answer with a
/// [`Located`](crate::collision::Located), whose proof is written when it is asked for.
#[derive(Debug, Clone, PartialEq)]
pub struct Gauge<const D: usize, L = Location<D>> {
    /// The gauge, within [`error`](Self::error); infinite where no multiple of Z holds p (a flat Z), then without
    /// error.
    pub value: f64,
    /// A bound for |`value` − gauge|.
    pub error: f64,
    /// The place of p relative to Z, decided exactly: the gauge is at most 1 just when p is a member. With its proof.
    pub location: L,
}

impl<const D: usize> Separation<D> {
    /// The separation of a body of R^E, from that of its prism in R^D, or for itself if D = E.
    #[inline]
    pub(crate) fn lowered<const E: usize>(self) -> Separation<E> {
        match self {
            Self::Rounded(u) => Separation::Rounded(array::from_fn(|i| u[i])),
            Self::Exact(u) => Separation::Exact(Box::new(array::from_fn(|i| u[i].clone()))),
        }
    }

    /// The separation by an exact direction that separates, in doubles if the rounded direction does, too. O(n).
    pub(crate) fn near<P: Standing>(question: &Query<'_, D, P>, direction: &[Dyadic; D]) -> Self {
        let largest = direction.iter().filter_map(Dyadic::binary_exponent).max().unwrap_or(0);
        let scaled = direction.clone().map(|v| v.scaled(-largest));
        let rounded = scaled.clone().map(|v| v.to_f64());
        let along =
            |v: &[Dyadic; D]| v.iter().zip(rounded).fold(Dyadic::zero(), |s, (a, b)| s + a * &Dyadic::from_f64(b));
        let reach = question.exact_generators().fold(Dyadic::zero(), |s, g| s + along(&g).abs());
        if along(&question.exact()) > reach {
            Self::Rounded(rounded)
        } else {
            Self::Exact(Box::new(scaled.map(|v| v.to_rational())))
        }
    }
}

impl Witness {
    /// The proof with coefficients of their own for a basis, which may be in any order.
    pub(crate) fn with_basis(mut coefficients: Vec<f64>, mut basis: [usize; 3], own: [f64; 3]) -> Self {
        for (index, value) in basis.into_iter().zip(own) {
            coefficients[index] = value;
        }
        basis.sort_unstable();
        Self { coefficients, basis: basis.to_vec() }
    }

    /// The proof for a body with `own` generators, from that for its prism.
    pub(crate) fn lowered(self, own: usize) -> Self {
        let Self { mut coefficients, mut basis } = self;
        coefficients.truncate(own);
        // the indices are in increasing order
        while basis.last().is_some_and(|&generator| generator >= own) {
            basis.pop();
        }
        Self { coefficients, basis }
    }
}

impl<const D: usize, M> Location<D, M> {
    /// Whether the displacement lies in the closed zonotope.
    pub fn is_member(&self) -> bool {
        !matches!(self, Self::Outside(_))
    }

    /// The case without its proof.
    pub fn status(&self) -> Status {
        match self {
            Self::Inside(_) => Status::Inside,
            Self::Boundary(_) => Status::Boundary,
            Self::Outside(_) => Status::Outside,
        }
    }

    /// The same case with another proof of a member.
    #[inline]
    pub(crate) fn map<N>(self, proof: impl FnOnce(M) -> N) -> Location<D, N> {
        match self {
            Self::Inside(member) => Location::Inside(proof(member)),
            Self::Boundary(member) => Location::Boundary(proof(member)),
            Self::Outside(separation) => Location::Outside(separation),
        }
    }
}

impl<const D: usize> Location<D> {
    /// The answer for a body of R^E with `own` generators, from that for its prism in R^D, or for itself if D = E.
    #[inline]
    pub(crate) fn lowered<const E: usize>(self, own: usize) -> Location<E> {
        match self {
            Self::Inside(proof) => Location::Inside(proof.lowered(own)),
            Self::Boundary(proof) => Location::Boundary(proof.lowered(own)),
            Self::Outside(separation) => Location::Outside(separation.lowered()),
        }
    }
}

impl<const D: usize, L> Gauge<D, L> {
    /// The same gauge with the place of the displacement in another form.
    pub(crate) fn map<const E: usize, M>(self, place: impl FnOnce(L) -> M) -> Gauge<E, M> {
        Gauge { value: self.value, error: self.error, location: place(self.location) }
    }
}

impl<const D: usize> Gauge<D> {
    /// The gauge for a body of R^E with `own` generators, from that for its prism in R^D, or for itself if D = E.
    pub(crate) fn lowered<const E: usize>(self, own: usize) -> Gauge<E> {
        self.map(|location| location.lowered(own))
    }
}

/// A location with its proof, and the rung by which the proof was found.
#[derive(Debug, Clone)]
pub(crate) struct Proof {
    pub(crate) location: Location<3, Coefficients>,
    pub(crate) rung: Rung,
}

impl Proof {
    /// The proof of a displacement in the interior.
    pub(crate) fn inside(member: impl Into<Coefficients>, rung: Rung) -> Self {
        Self { location: Location::Inside(member.into()), rung }
    }

    /// The proof of a member that is not in the interior.
    pub(crate) fn boundary(witness: Witness, rung: Rung) -> Self {
        Self { location: Location::Boundary(witness.into()), rung }
    }

    /// The proof by a direction of doubles that separates.
    pub(crate) fn outside(direction: [f64; 3], rung: Rung) -> Self {
        Self { location: Location::Outside(Separation::Rounded(direction)), rung }
    }

    /// The direction of doubles that separates, if that is the proof.
    pub(crate) fn direction(&self) -> Option<[f64; 3]> {
        match self.location {
            Location::Outside(Separation::Rounded(direction)) => Some(direction),
            _ => None,
        }
    }

    /// The location, its rung counted. The rung of a displacement of zero has been counted by the search that ended
    /// there.
    pub(crate) fn counted(self, tally: &mut dyn Tally) -> Location<3, Coefficients> {
        if self.rung != Rung::ZeroDisplacement {
            tally.answered_by(self.rung);
        }
        self.location
    }
}

impl Status {
    /// Every status, from the inside out.
    pub const ALL: [Self; 3] = [Self::Inside, Self::Boundary, Self::Outside];

    /// Whether the point lies in the closed body: inside or on the boundary.
    pub fn is_member(self) -> bool {
        self != Self::Outside
    }

    /// The name used in records: `inside`, `boundary` or `outside`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Inside => "inside",
            Self::Boundary => "boundary",
            Self::Outside => "outside",
        }
    }
}

impl fmt::Display for Status {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
