//! What the kinds about a body and a displacement share: the choice of a method, zonotopes in the input, proofs in the answer.

use std::ops::RangeInclusive;

use serde_json::{Value, json};
use zonotope::collision::{Displacement, Gauge, Location, Separation, brute_force, by_lad};

use crate::batch::MAX_DIMENSION;
use crate::batch::refusal::{Code, Refusal};
use crate::json::vector_to_json;

/// The methods that locate a displacement.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Method {
    ByLad,
    BruteForce,
}

impl Method {
    /// All of them, better ones first.
    const ALL: [Self; 2] = [Self::ByLad, Self::BruteForce];

    pub(super) fn name(self) -> &'static str {
        match self {
            Self::ByLad => "by_lad",
            Self::BruteForce => "brute_force",
        }
    }

    /// The names of all methods, better ones first.
    pub(super) fn names() -> Vec<&'static str> {
        Self::ALL.into_iter().map(Self::name).collect()
    }

    /// The dimensions in which it works.
    fn dimensions(self) -> RangeInclusive<usize> {
        match self {
            Self::ByLad => 1..=3,
            Self::BruteForce => 1..=MAX_DIMENSION,
        }
    }

    /// The most generators that it takes in a dimension, where its cost is no small power of their number.
    fn most_generators(self, dimension: usize) -> Option<usize> {
        match self {
            Self::ByLad => None,
            Self::BruteForce => Some([2000, 400, 60, 26, 18, 14][dimension - 1]),
        }
    }

    /// The method that was asked for, or the best one of the dimension.
    pub(super) fn chosen(asked: Option<&'static str>, dimension: usize, generators: usize) -> Result<Self, Refusal> {
        let fits = |method: &Self| method.dimensions().contains(&dimension);
        let chosen = match asked {
            Some(name) => Self::ALL.into_iter().find(|method| method.name() == name),
            None => Self::ALL.into_iter().find(fits),
        };
        let chosen = chosen.expect("brute force works in every dimension, and the kinds list these names");
        if !fits(&chosen) {
            let known: Vec<_> = Self::ALL.into_iter().filter(fits).map(Self::name).collect();
            let message =
                format!("`{}` does not answer in {dimension} dimensions; {} would", chosen.name(), known.join(", "));
            return Err(Refusal::new(Code::UnknownMethod, message));
        }
        match chosen.most_generators(dimension) {
            Some(most) if generators > most => {
                let name = chosen.name();
                let message =
                    format!("{generators} generators, at most {most} are taken by `{name}` in {dimension} dimensions");
                Err(Refusal::new(Code::TooLarge, message))
            }
            _ => Ok(chosen),
        }
    }

    pub(super) fn locate<const D: usize>(self, question: &Displacement<'_, D>) -> Location<D>
    where
        Dimension: Kernel<D>,
    {
        match self {
            Self::ByLad => Dimension::locate(question),
            Self::BruteForce => brute_force::locate(question),
        }
    }

    pub(super) fn gauge<const D: usize>(self, question: &Displacement<'_, D>) -> Gauge<D>
    where
        Dimension: Kernel<D>,
    {
        match self {
            Self::ByLad => Dimension::gauge(question),
            Self::BruteForce => brute_force::gauge(question),
        }
    }
}

/// The dimensions, as the owner of their methods.
pub(super) struct Dimension;

/// The kernel, or the truth where there is no kernel.
pub(super) trait Kernel<const D: usize> {
    fn locate(question: &Displacement<'_, D>) -> Location<D>;
    fn gauge(question: &Displacement<'_, D>) -> Gauge<D>;
}

macro_rules! kernel {
    ($method:ident: $($dimension:literal),*) => {$(
        impl Kernel<$dimension> for Dimension {
            fn locate(question: &Displacement<'_, $dimension>) -> Location<$dimension> {
                $method::locate(question)
            }

            fn gauge(question: &Displacement<'_, $dimension>) -> Gauge<$dimension> {
                $method::gauge(question)
            }
        }
    )*};
}
kernel!(by_lad: 1, 2, 3);
kernel!(brute_force: 4, 5, 6);

/// The status and the proof of a location.
pub(super) fn certificate<const D: usize>(location: &Location<D>) -> Value {
    match location {
        Location::Inside(witness) | Location::Boundary(witness) => json!({
            "coefficients": vector_to_json(&witness.coefficients),
            "basis": witness.basis,
        }),
        Location::Outside(Separation::Rounded(direction)) => {
            json!({"separating_direction": vector_to_json(direction)})
        }
        Location::Outside(Separation::Exact(direction)) => {
            let exact: Vec<String> = direction.iter().map(ToString::to_string).collect();
            json!({"separating_direction": exact})
        }
    }
}
