//! The answer of the kernel: the facet in which the ray along the displacement leaves the body, in the form in which
//! the facet was proved.

use super::certify::rounded_optimum::DecidedOptimum;
use super::exact::solve::ExactOptimum;
use super::span::prism::Prism;

/// The optimum of a query, or what made it unnecessary.
#[derive(Debug)]
pub(crate) enum Optimum {
    /// The displacement is zero.
    Center,
    /// The location was all that was asked, and a direction u with u · p > h(u) was found before the optimum.
    Separated([f64; 3]),
    /// The caller ended the search at a vertex.
    Ended,
    /// An optimum that is proved in doubles.
    Rounded(DecidedOptimum),
    /// An optimum that was solved for in exact arithmetic.
    Exact(Box<ExactOptimum>),
    /// The optimum of the prism over a flat body from which a coordinate was dropped.
    Flat(Box<FlatOptimum>),
}

/// The optimum for a body in a plane, by way of a prism.
#[derive(Debug)]
pub(crate) struct FlatOptimum {
    /// The coordinate that was dropped.
    pub(crate) axis: usize,
    pub(crate) prism: Prism,
    pub(crate) optimum: Optimum,
}

impl Optimum {
    /// The gauge with a bound for its error; infinite where no multiple of the body holds the displacement. O(1).
    pub(crate) fn gauge(&self) -> (f64, f64) {
        match self {
            Self::Center => (0.0, 0.0),
            Self::Separated(_) | Self::Ended => (f64::INFINITY, f64::INFINITY),
            Self::Rounded(decided) => decided.gauge(),
            Self::Exact(exact) => exact.gauge(),
            Self::Flat(flat) => flat.optimum.gauge(),
        }
    }

    /// The generators, at most two, that span the facet in which the ray leaves the body; where the ray leaves near
    /// an edge, perhaps those of the facet beside it. O(1).
    pub(crate) fn basis(&self) -> &[usize] {
        match self {
            Self::Center | Self::Separated(_) | Self::Ended => &[],
            Self::Rounded(decided) => &decided.optimum.basis,
            Self::Exact(exact) => &exact.basis,
            Self::Flat(flat) => flat.basis(),
        }
    }

    /// Whether [`basis`](Self::basis) is that of the facet for sure, not only nearly. O(1).
    pub(crate) fn is_sharp(&self) -> bool {
        match self {
            Self::Center | Self::Separated(_) | Self::Ended => false,
            Self::Rounded(decided) => decided.optimum.is_vertex(),
            Self::Exact(_) => true,
            Self::Flat(flat) => flat.optimum.is_sharp(),
        }
    }

    /// Whether the displacement is certainly in the closed body. O(1).
    pub(crate) fn is_member(&self) -> bool {
        match self {
            Self::Center => true,
            Self::Separated(_) | Self::Ended => false,
            Self::Rounded(decided) => decided.order.is_le(),
            Self::Exact(exact) => exact.along <= exact.reach,
            Self::Flat(flat) => flat.optimum.is_member(),
        }
    }
}

impl FlatOptimum {
    /// The basis without the generator that only the prism has.
    fn basis(&self) -> &[usize] {
        match self.optimum.basis() {
            [rest @ .., new] | [new, rest @ ..] if self.prism.is_new(*new) => rest,
            all => all,
        }
    }
}
