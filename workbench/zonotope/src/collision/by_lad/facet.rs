//! The answer in constant size: the facet in which the ray along the displacement leaves the body.

use std::cmp::Ordering;

use crate::collision::by_lad::proof::basis::Basis;
use crate::collision::by_lad::proof::member_in_doubles::witness;
use crate::collision::{Gauge, Location, Query, Separation, Witness};
use crate::lad::of_generators::cells::nested::Trail;
use crate::lad::of_generators::certify::rounded_optimum::Certain;
use crate::lad::of_generators::certify::unit_gauge_bound::thickness;
use crate::lad::of_generators::exact::solve::Exit;
use crate::lad::of_generators::ladder::{Found, rounded_displacement, search};
use crate::lad::of_generators::span::flat::spare_axis;
use crate::lad::of_generators::span::prism::Prism;
use crate::numeric::Rational;
use crate::numeric::bounded::{Bounded, BoundedVector};
use crate::tally::Tally;

/// Where the ray along a displacement leaves the zonotope: the gauge and the status at once, the full proof on demand.
#[derive(Debug)]
pub struct Facet<'q> {
    query: &'q Query<'q, 3>,
    kind: Kind,
}

#[derive(Debug)]
enum Kind {
    /// The displacement is zero.
    Center,
    /// A direction that separates, found before the facet.
    Separated([f64; 3]),
    /// Proved in doubles, the status included.
    Certain(Proof),
    /// Solved exactly.
    Exact(Box<Exit>),
    /// Of the prism over a flat body without a coordinate.
    Flat(Box<Flat>),
}

/// A flat body's prism, and the answer for it.
#[derive(Debug)]
struct Flat {
    /// The coordinate that was dropped.
    axis: usize,
    prism: Prism,
    kind: Kind,
}

/// The thickness of a part of the body, one generator in so many, is tried before that of all of it.
const PARTS: [usize; 2] = [16, 1];

/// What doubles prove of the optimum.
#[derive(Debug)]
struct Proof {
    certain: Box<Certain>,
    /// Where the signs of the generators come from.
    trail: Trail,
    /// What the gauge times λ exceeds 1 by at most.
    slack: f64,
    order: Ordering,
}

impl Proof {
    /// Whether the gauge is less or greater than 1; none if that is not certain, or if the gauge is to be known and is not sharp.
    fn new(
        query: &Query<'_, 3>,
        certain: Box<Certain>,
        trail: Trail,
        sharp: bool,
    ) -> Result<Self, (Box<Certain>, Trail)> {
        match verdict(query, &certain, sharp) {
            Some((order, slack)) => Ok(Self { certain, trail, slack, order }),
            None => Err((certain, trail)),
        }
    }

    fn value(&self) -> (f64, f64) {
        gauge(&self.certain, self.slack)
    }
}

/// How the gauge compares to 1, and what the gauge times λ exceeds 1 by at most.
fn verdict(query: &Query<'_, 3>, certain: &Certain, sharp: bool) -> Option<(Ordering, f64)> {
    let mut slack = certain.slack(f64::INFINITY);
    let mut judged = judge(certain, slack, sharp);
    for share in PARTS {
        if judged.is_none() && slack > 0.0 {
            slack = certain.slack(thickness(query, share));
            judged = judge(certain, slack, sharp);
        }
    }
    judged.map(|order| (order, slack))
}

fn judge(certain: &Certain, slack: f64, sharp: bool) -> Option<Ordering> {
    let (value, error) = gauge(certain, slack);
    let inside = certain.along * (Bounded::exact(1.0) + Bounded::exact(slack));
    let order = if (certain.along - certain.support()).is_positive() {
        Ordering::Greater
    } else if (certain.reach - inside).is_positive() {
        Ordering::Less
    } else {
        return None;
    };
    (!sharp || error <= value * SHARP).then_some(order)
}

/// `along` / `reach` with a bound for its distance from the gauge.
fn gauge(certain: &Certain, slack: f64) -> (f64, f64) {
    let (value, error) = quotient(certain.along, certain.support());
    (value, error + (value + error) * slack * (1.0 + 4.0 * f64::EPSILON))
}

impl<'q> Facet<'q> {
    /// Finds the facet, or, `until_separated`, a separating direction if that is found first.
    pub(super) fn find(query: &'q Query<'q, 3>, until_separated: bool, tally: &mut impl Tally) -> Self {
        Self { query, kind: Kind::find(query, until_separated, tally) }
    }

    /// The gauge within a bound of its error; infinite where no multiple of the body holds the displacement. O(1).
    pub fn value(&self) -> (f64, f64) {
        self.kind.value()
    }

    /// The generators, at most two, that span the facet where the ray leaves; near an edge of it, perhaps the neighbour. O(1).
    pub fn basis(&self) -> &[usize] {
        self.kind.basis()
    }

    /// Whether [`basis`](Self::basis) is that of the facet for sure, not only nearly. O(1).
    pub fn is_sharp(&self) -> bool {
        self.kind.is_sharp()
    }

    /// Whether the displacement is in the closed body. O(1).
    pub fn is_member(&self) -> bool {
        self.kind.is_member()
    }

    /// The gauge with where the displacement lies. O(n).
    pub fn gauge(&self) -> Gauge<3> {
        let (value, error) = self.value();
        Gauge { value, error, location: self.location() }
    }

    /// Where the displacement lies, with its proof. O(n) for a member, else O(1) nearly always.
    pub fn location(&self) -> Location<3> {
        self.kind.location(self.query)
    }
}

impl Kind {
    fn find(query: &Query<'_, 3>, until_separated: bool, tally: &mut impl Tally) -> Self {
        let p = rounded_displacement(query);
        if p.iter().all(|c| c.value == 0.0) {
            return Self::Center;
        }
        let is_enough = |certain: &Certain| verdict(query, certain, !until_separated).is_some();
        match search(query, &p, until_separated, &is_enough, tally) {
            Found::Separated(direction) => Self::Separated(direction),
            Found::Certain(certain, trail) => match Proof::new(query, certain, trail, !until_separated) {
                Ok(proof) => Self::Certain(proof),
                Err((certain, trail)) => Self::Exact(Box::new(if certain.is_vertex() {
                    Exit::of_certain(query, &query.exact(), &certain, &trail)
                } else {
                    Exit::near(query, &query.exact(), &trail, tally)
                })),
            },
            Found::Narrowed(trail) => {
                let p = query.exact();
                if let Some(axis) = spare_axis(query, &p) {
                    return Self::Flat(Box::new(Flat::find(axis, query, until_separated, tally)));
                }
                Self::Exact(Box::new(Exit::near(query, &p, &trail, tally)))
            }
        }
    }

    fn value(&self) -> (f64, f64) {
        match self {
            Self::Center => (0.0, 0.0),
            Self::Separated(_) => (f64::INFINITY, f64::INFINITY),
            Self::Certain(proof) => proof.value(),
            Self::Exact(exit) => exit.value(),
            Self::Flat(flat) => flat.kind.value(),
        }
    }

    fn basis(&self) -> &[usize] {
        match self {
            Self::Center | Self::Separated(_) => &[],
            Self::Certain(proof) => &proof.certain.basis,
            Self::Exact(exit) => &exit.basis,
            Self::Flat(flat) => flat.basis(),
        }
    }

    fn is_sharp(&self) -> bool {
        match self {
            Self::Center | Self::Separated(_) => false,
            Self::Certain(proof) => proof.certain.is_vertex(),
            Self::Exact(_) => true,
            Self::Flat(flat) => flat.kind.is_sharp(),
        }
    }

    fn is_member(&self) -> bool {
        match self {
            Self::Center => true,
            Self::Separated(_) => false,
            Self::Certain(proof) => proof.order.is_le(),
            Self::Exact(exit) => exit.along <= exit.reach,
            Self::Flat(flat) => flat.kind.is_member(),
        }
    }

    fn location(&self, query: &Query<'_, 3>) -> Location<3> {
        match self {
            Self::Center => center(query),
            Self::Separated(direction) => Location::Outside(Separation::Rounded(*direction)),
            Self::Exact(exit) => exit.location(query, &query.exact()),
            Self::Flat(flat) => flat.location(),
            Self::Certain(proof) => {
                let p = rounded_displacement(query);
                let location = match proof.order {
                    Ordering::Greater => separation(&proof.certain, &p).map(Location::Outside),
                    _ => witness(query, &proof.certain, &proof.trail, &p).map(Location::Inside),
                };
                location.unwrap_or_else(|| {
                    let exact = query.exact();
                    let exit = if proof.certain.is_vertex() {
                        Exit::of_certain(query, &exact, &proof.certain, &proof.trail)
                    } else {
                        Exit::near(query, &exact, &proof.trail, &mut ())
                    };
                    exit.location(query, &exact)
                })
            }
        }
    }
}

impl Flat {
    fn find(axis: usize, query: &Query<'_, 3>, until_separated: bool, tally: &mut impl Tally) -> Self {
        let prism = Prism::without(axis, query);
        let kind = Kind::find(&prism.query(), until_separated, tally);
        Self { axis, prism, kind }
    }

    /// Without the generator that is the prism's.
    fn basis(&self) -> &[usize] {
        match self.kind.basis() {
            [rest @ .., new] | [new, rest @ ..] if self.prism.is_new(*new) => rest,
            all => all,
        }
    }

    /// A flat body has no inside.
    fn location(&self) -> Location<3> {
        match self.prism.lower(self.kind.location(&self.prism.query())) {
            Location::Inside(witness) | Location::Boundary(witness) => Location::Boundary(witness),
            Location::Outside(Separation::Rounded(mut u)) => {
                u[self.axis] = 0.0;
                Location::Outside(Separation::Rounded(u))
            }
            Location::Outside(Separation::Exact(mut u)) => {
                u[self.axis] = Rational::ZERO;
                Location::Outside(Separation::Exact(u))
            }
        }
    }
}

/// The centre is a member with all coefficients 0, inside just when the generators span space.
fn center(query: &Query<'_, 3>) -> Location<3> {
    let witness = Witness { coefficients: vec![0.0; query.len()], basis: Vec::new() };
    if Basis::spanning(query, Basis::new(Vec::new())).0.rank() == 3 {
        Location::Inside(witness)
    } else {
        Location::Boundary(witness)
    }
}

/// The direction of the facet in doubles: rounding it by e takes at most e · (Σ |v|_1 + |p|_1) off the gap, |v|_1 < 2 |v|.
fn separation(certain: &Certain, p: &BoundedVector) -> Option<Separation<3>> {
    let error = certain.direction.iter().fold(0.0f64, |m, c| m.max(c.error));
    let size: f64 = p.iter().map(|c| c.magnitude()).sum();
    let gap = certain.along - certain.support();
    let lost = Bounded::exact(error) * (Bounded::exact(4.0 * certain.magnitude) + Bounded::exact(2.0 * size));
    let direction = certain.direction.map(|c| c.value);
    (gap - lost).is_positive().then_some(Separation::Rounded(direction))
}

/// The gauge is known to one part in 2^36; where terms of the reach cancel, the exact one is taken instead.
const SHARP: f64 = 65536.0 * f64::EPSILON;

/// a / b for a and b positive, with a bound for its error; infinite where b may be zero.
fn quotient(a: Bounded, b: Bounded) -> (f64, f64) {
    let value = a.value / b.value;
    let least = b.value - b.error;
    if least.is_nan() || least <= 0.0 {
        return (value, f64::INFINITY);
    }
    let error = (a.error + value * b.error) / least + value * f64::EPSILON;
    (value, error * (1.0 + 8.0 * f64::EPSILON) + f64::MIN_POSITIVE)
}
