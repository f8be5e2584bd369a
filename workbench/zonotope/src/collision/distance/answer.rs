//! How near two bodies are: the answer to a question of distance, with its proof.

use crate::collision::{Status, Witness};
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::linear::dot;
use crate::numeric::scaling::scale_by_power_of_two;
use crate::zonotope::pose::Standing;
use crate::zonotope::query::Query;

/// How near two closed bodies are, or a point and a body.
#[derive(Debug, Clone, PartialEq)]
pub enum Proximity<const D: usize> {
    /// The bodies have no point in common; in a box, as the other cases are much smaller.
    Disjoint(Box<Gap<D>>),
    /// The bodies have a point in common, but their interiors have none, or their sum is flat. The witness is that of
    /// [`Location::Boundary`](crate::collision::Location::Boundary).
    Touching(Witness),
    /// The interiors have a point in common. The witness is that of
    /// [`Location::Inside`](crate::collision::Location::Inside).
    Overlapping(Witness),
}

/// What lies between two disjoint bodies A and B: the shortest vector from one to the other, where it begins and ends.
///
/// Let p be the displacement from the centre of A to that of B, and x the point of the zonotope Z of the generators of
/// both that is nearest to p. Then p − x is the shortest vector from A to B. It is a positive multiple of the
/// [`direction`](Self::direction) u, in which x is extreme: u · x = h_Z(u).
#[derive(Debug, Clone, PartialEq)]
pub struct Gap<const D: usize> {
    /// u, exactly, of any length but 0.
    pub(super) direction: [Dyadic; D],
    /// u · (p − x), positive: the distance times |u|.
    pub(super) along: Dyadic,
    /// Coefficients of x: with those off the basis taken as they stand, those of the basis for which Σ δ_i g_i is
    /// nearest to p lie in [−1, 1], and they are rounded to nearest. A coefficient off the basis is 1 or −1, the sign
    /// of u · g_i where that is not 0. The generators are those of A, then those of B.
    ///
    /// That proves the distance: the residual r = p − Σ δ_i g_i has r · g_i ≥ 0 where δ_i = 1, r · g_i ≤ 0 where δ_i =
    /// −1 and r · g_i = 0 on the basis, so that no other point of Z is nearer.
    pub nearest: Witness,
    /// A point of A and a point of B at that distance, each coordinate the nearest double or the one beside it;
    /// infinite where a body leaves the range of doubles.
    pub points: [[f64; D]; 2],
    /// The face of A whose outer normal is u, and that of B whose outer normal is −u: all pairs of nearest points lie
    /// on these.
    pub features: [Feature; 2],
}

impl<const D: usize> Proximity<D> {
    /// The same answer, the proof of bodies that meet as [`Witness::with_nearest_basis`] has it.
    pub fn with_nearest_basis<P: Standing>(self, query: &Query<'_, D, P>) -> Self {
        match self {
            Self::Touching(witness) => Self::Touching(witness.with_nearest_basis(query)),
            Self::Overlapping(witness) => Self::Overlapping(witness.with_nearest_basis(query)),
            disjoint @ Self::Disjoint(_) => disjoint,
        }
    }
}

/// A face of a body: that in which a direction is largest.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Feature {
    /// What kind of face it is.
    pub kind: FeatureKind,
    /// The generators that span it: those orthogonal to the direction, but for zero vectors, in increasing order.
    pub generators: Vec<usize>,
}

/// Faces by their dimension.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum FeatureKind {
    /// A point: no generator is orthogonal to the direction.
    Vertex,
    /// A segment.
    Edge,
    /// A zonogon; of a flat body, perhaps the whole body.
    Facet,
}

impl FeatureKind {
    /// The kind of a face of dimension 0, 1 or 2.
    pub(super) fn of_dimension(dimension: usize) -> Self {
        match dimension {
            0 => Self::Vertex,
            1 => Self::Edge,
            _ => Self::Facet,
        }
    }

    /// The name used in records: `vertex`, `edge` or `facet`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Vertex => "vertex",
            Self::Edge => "edge",
            Self::Facet => "facet",
        }
    }
}

impl<const D: usize> Proximity<D> {
    /// The Euclidean distance: 0 for bodies that meet, else as [`Gap::distance`] has it.
    pub fn distance(&self) -> f64 {
        self.gap().map_or(0.0, Gap::distance)
    }

    /// Where the displacement of the centres lies relative to the sum of both bodies, without the proof.
    pub fn status(&self) -> Status {
        match self {
            Self::Disjoint(_) => Status::Outside,
            Self::Touching(_) => Status::Boundary,
            Self::Overlapping(_) => Status::Inside,
        }
    }

    /// What lies between bodies that are disjoint.
    pub fn gap(&self) -> Option<&Gap<D>> {
        match self {
            Self::Disjoint(gap) => Some(gap),
            Self::Touching(_) | Self::Overlapping(_) => None,
        }
    }

    /// The square of the distance, exactly: it is rational.
    pub fn exact_squared_distance(&self) -> Rational {
        self.gap().map_or(Rational::ZERO, Gap::exact_squared_distance)
    }
}

impl<const D: usize> Gap<D> {
    /// The distance, positive and within two units in the last place; infinite where it leaves the range of doubles.
    pub fn distance(&self) -> f64 {
        rounded_length(&self.along, &dot(&self.direction, &self.direction))
    }

    /// The square of the distance, within a unit in the last place; 0 or infinite where it leaves the range of doubles,
    /// although the distance may be in it.
    pub fn squared_distance(&self) -> f64 {
        let (numerator, denominator) = self.squared_ratio();
        numerator.rounded_ratio(&denominator)
    }

    /// The square of the distance, exactly: (u · (p − x))² / u · u.
    pub fn exact_squared_distance(&self) -> Rational {
        let (numerator, denominator) = self.squared_ratio();
        numerator.to_rational() / denominator.to_rational()
    }

    fn squared_ratio(&self) -> (Dyadic, Dyadic) {
        (&self.along * &self.along, dot(&self.direction, &self.direction))
    }

    /// The direction of the shortest vector from A to B, scaled such that its largest coordinate is in [1, 2], each
    /// coordinate within a relative 2^-50.
    pub fn direction(&self) -> [f64; D] {
        let exponent = self.direction.iter().filter_map(Dyadic::binary_exponent).max().unwrap_or(0);
        self.direction.each_ref().map(|c| c.clone().scaled(-exponent).to_f64())
    }

    /// The direction of the shortest vector from A to B, exactly, of any length.
    pub fn exact_direction(&self) -> &[Dyadic; D] {
        &self.direction
    }
}

/// along / √square for positive numbers, within two units in the last place: the length that a vector of the square
/// length `square` has the product `along` with. Infinite where it leaves the range of doubles.
///
/// The quotient is rounded to little more than half a unit in its last place, which the root halves, and the root is
/// rounded itself. What is left is a power of two, whose product is rounded only where it is subnormal; what would be
/// rounded to 0 there is the smallest double, so that a positive length stays positive.
pub(super) fn rounded_length(along: &Dyadic, square: &Dyadic) -> f64 {
    let numerator = along * along;
    let size = |number: &Dyadic| number.binary_exponent().expect("the numbers are not zero");
    // half of this is the exponent of the root
    let exponent = (size(&numerator) - size(square)).div_euclid(2) * 2;
    let quotient = numerator.scaled(-exponent).rounded_ratio(square);
    scale_by_power_of_two(quotient.sqrt(), exponent / 2).max(f64::from_bits(1))
}
