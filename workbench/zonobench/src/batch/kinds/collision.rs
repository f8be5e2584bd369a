//! What the kinds about a body and a displacement share: the choice of a method, zonotopes in the input, proofs in the answer.

use serde_json::{Value, json};
use zonotope::collision::{
    Gauge, Location, Query, Separation, Witness, brute_force, by_explicit_faces, by_lad, by_lad_in_r4,
    by_linear_program, by_slope_selection,
};
use zonotope::linear_program::Clarabel;

use crate::batch::refusal::{Code, Refusal};
use crate::json::vector_to_json;

/// The methods that locate a displacement.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Method {
    ByLad,
    BySlopeSelection,
    ByExplicitFaces,
    ByLinearProgram,
    BruteForce,
}

/// The methods of `member` and `intersect`, better ones first.
pub(super) const LOCATING: &[Method] =
    &[Method::ByLad, Method::BySlopeSelection, Method::ByExplicitFaces, Method::ByLinearProgram, Method::BruteForce];

/// The methods that also know the gauge, better ones first.
pub(super) const GAUGING: &[Method] = &[Method::ByLad, Method::ByExplicitFaces, Method::BruteForce];

/// The names of methods.
pub(super) fn names(methods: &[Method]) -> Vec<&'static str> {
    methods.iter().map(|method| method.name()).collect()
}

impl Method {
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::ByLad => "by_lad",
            Self::BySlopeSelection => "by_slope_selection",
            Self::ByExplicitFaces => "by_explicit_faces",
            Self::ByLinearProgram => "by_linear_program",
            Self::BruteForce => "brute_force",
        }
    }

    /// Whether it works in a dimension.
    fn works<const D: usize>(self) -> bool
    where
        Dimension: Methods<D>,
    {
        match self {
            Self::ByLad => Dimension::KERNEL.is_some(),
            Self::BySlopeSelection => Dimension::SEARCH.is_some(),
            Self::ByExplicitFaces => Dimension::EXPLICIT.is_some(),
            Self::ByLinearProgram | Self::BruteForce => true,
        }
    }

    /// The most generators that it takes in a dimension, where its cost is no small power of their number.
    fn most_generators(self, dimension: usize) -> Option<usize> {
        match self {
            Self::ByLad | Self::BySlopeSelection => None,
            Self::ByExplicitFaces => Some(2000),
            Self::ByLinearProgram => Some(100_000),
            Self::BruteForce => Some([2000, 400, 60, 26, 18, 14][dimension - 1]),
        }
    }

    /// The method that was asked for, or the best one of the dimension.
    pub(super) fn chosen<const D: usize>(
        methods: &[Self],
        asked: Option<&'static str>,
        generators: usize,
    ) -> Result<Self, Refusal>
    where
        Dimension: Methods<D>,
    {
        let mut working = methods.iter().copied().filter(|method| method.works::<D>());
        let chosen = match asked {
            Some(name) => methods.iter().copied().find(|method| method.name() == name),
            None => working.clone().next(),
        };
        let chosen = chosen.expect("brute force works in every dimension, and the kinds list these names");
        let name = chosen.name();
        if !working.any(|method| method == chosen) {
            let others: Vec<_> =
                methods.iter().filter(|method| method.works::<D>()).map(|method| method.name()).collect();
            let message = format!("`{name}` does not answer in {D} dimensions; {} would", others.join(", "));
            return Err(Refusal::new(Code::UnknownMethod, message));
        }
        chosen.refuse_many::<D>(generators)?;
        Ok(chosen)
    }

    fn refuse_many<const D: usize>(self, generators: usize) -> Result<(), Refusal> {
        match self.most_generators(D) {
            Some(most) if generators > most => {
                let name = self.name();
                let message =
                    format!("{generators} generators, at most {most} are taken by `{name}` in {D} dimensions");
                Err(Refusal::new(Code::TooLarge, message))
            }
            _ => Ok(()),
        }
    }

    /// Where the displacement lies, and the method that proved it: what a linear program leaves open is decided by another one.
    pub(super) fn locate<const D: usize>(
        self,
        question: &Query<'_, D>,
        seed: u64,
    ) -> Result<(Self, Location<D>), Refusal>
    where
        Dimension: Methods<D>,
    {
        let location = match self {
            Self::ByLad => Dimension::KERNEL.map(|kernel| (kernel.locate)(question)),
            Self::BySlopeSelection => Dimension::SEARCH.map(|search| search(question, seed)),
            Self::ByExplicitFaces => Dimension::EXPLICIT.map(|faces| faces(question).location),
            Self::ByLinearProgram => by_linear_program::locate(question, &Clarabel).location().cloned(),
            Self::BruteForce => Some(brute_force::locate(question)),
        };
        match location {
            Some(location) => Ok((self, location)),
            None => {
                let other = Self::chosen::<D>(&[Self::ByLad, Self::BruteForce], None, question.len())?;
                other.locate(question, seed)
            }
        }
    }

    pub(super) fn gauge<const D: usize>(self, question: &Query<'_, D>) -> Gauge<D>
    where
        Dimension: Methods<D>,
    {
        let gauge = match self {
            Self::ByLad => Dimension::KERNEL.map(|kernel| (kernel.gauge)(question)),
            Self::ByExplicitFaces => Dimension::EXPLICIT.map(|faces| faces(question)),
            Self::BySlopeSelection | Self::ByLinearProgram | Self::BruteForce => None,
        };
        gauge.unwrap_or_else(|| brute_force::gauge(question))
    }
}

/// The dimensions, as owners of the methods that do not work in all of them.
pub(super) struct Dimension;

pub(super) trait Methods<const D: usize> {
    const KERNEL: Option<Kernel<D>> = None;
    const SEARCH: Option<fn(&Query<'_, D>, u64) -> Location<D>> = None;
    const EXPLICIT: Option<fn(&Query<'_, D>) -> Gauge<D>> = None;
}

/// The two sides of the kernel.
pub(super) struct Kernel<const D: usize> {
    locate: fn(&Query<'_, D>) -> Location<D>,
    gauge: fn(&Query<'_, D>) -> Gauge<D>,
}

macro_rules! up_to_space {
    ($($dimension:literal),*) => {$(
        impl Methods<$dimension> for Dimension {
            const KERNEL: Option<Kernel<$dimension>> = Some(Kernel { locate: by_lad::locate, gauge: by_lad::gauge });
            const SEARCH: Option<fn(&Query<'_, $dimension>, u64) -> Location<$dimension>> =
                Some(by_slope_selection::locate);
            const EXPLICIT: Option<fn(&Query<'_, $dimension>) -> Gauge<$dimension>> = Some(|question| {
                by_explicit_faces::gauge(question).expect("the number of generators was checked")
            });
        }
    )*};
}
up_to_space!(1, 2, 3);
impl Methods<4> for Dimension {
    const KERNEL: Option<Kernel<4>> = Some(Kernel { locate: by_lad_in_r4::locate, gauge: by_lad_in_r4::gauge });
}
impl Methods<5> for Dimension {}
impl Methods<6> for Dimension {}

/// The status and the proof of a location.
pub(super) fn certificate<const D: usize>(question: &Query<'_, D>, location: &Location<D>) -> Value {
    match location {
        Location::Inside(witness) | Location::Boundary(witness) => {
            let Witness { coefficients, basis } = witness.clone().with_nearest_basis(question);
            json!({"coefficients": vector_to_json(&coefficients), "basis": basis})
        }
        Location::Outside(Separation::Rounded(direction)) => {
            json!({"separating_direction": vector_to_json(direction)})
        }
        Location::Outside(Separation::Exact(direction)) => {
            let exact: Vec<String> = direction.iter().map(ToString::to_string).collect();
            json!({"separating_direction": exact})
        }
    }
}
