//! The growth laws that an experiment looks for: a quantity, the bound on it, and what it is fitted on.

use crate::fit::GrowthModel;
use std::fmt;

/// The number that a fit looks at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// The sum of all operation counts.
    AllCounts,
    /// The operation count of this name.
    Count(&'static str),
    /// The value of this name that the measurements record.
    Value(&'static str),
    /// The lap of this name, in nanoseconds: the median over the repetitions.
    Time(&'static str),
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::AllCounts => f.write_str("operations"),
            Self::Count(name) | Self::Value(name) => f.write_str(name),
            Self::Time(lap) => write!(f, "time of {lap} (ns)"),
        }
    }
}

/// Who gives a bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StatedBy {
    /// The paper, at this place.
    Paper(&'static str),
    /// The workbench, of a method or a quantity of its own.
    Workbench,
}

/// A bound from above on a quantity: on its growth, or a number that it does not exceed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bound {
    /// The quantity is O(model).
    pub model: GrowthModel,
    /// The number that no sample may exceed, where the bound has its constant with it. Each sample keeps such a bound
    /// or breaks it, so that no law has to be fitted for the verdict.
    pub most: Option<f64>,
    /// Who says that.
    pub stated_by: StatedBy,
}

impl Bound {
    /// A bound that the paper states, at a place such as "Theorem 4.5".
    pub const fn of_paper(model: GrowthModel, place: &'static str) -> Self {
        Self { model, most: None, stated_by: StatedBy::Paper(place) }
    }

    /// A number for the quantity that follows from the paper's bound with constants that are named with its place, such
    /// as "Lemma 5.5 with c = 24".
    pub const fn number_of_paper(most: f64, place: &'static str) -> Self {
        Self { model: GrowthModel::Constant, most: Some(most), stated_by: StatedBy::Paper(place) }
    }

    /// A bound on a method or a quantity of the workbench's own.
    pub const fn own(model: GrowthModel) -> Self {
        Self { model, most: None, stated_by: StatedBy::Workbench }
    }
}

/// A growth law that an experiment looks for: for every family one fit over all sizes, and one over the last doublings.
#[derive(Clone, Copy, Debug)]
pub struct FitPlan {
    /// The quantity that is fitted.
    pub quantity: Quantity,
    /// The variant whose samples are fitted.
    pub variant: &'static str,
    /// The families, each of which is fitted by itself.
    pub families: &'static [&'static str],
    /// The growth models that the samples are compared with.
    pub models: &'static [GrowthModel],
    /// The bound that the theory gives, when it gives one. Growth within the bound or below it supports it, growth
    /// above it contradicts it, and an interval that reaches beyond it leaves it undecided.
    pub bound: Option<Bound>,
    /// The growth that the quantity cannot stay below, as the method has to read its input: where it seems to,
    /// lower-order terms show.
    pub floor: Option<GrowthModel>,
    /// The smallest size that is fitted: where a method changes with the size, the law is that from the change on.
    pub smallest: usize,
}

impl FitPlan {
    /// A law of a quantity without a bound, over the whole range of sizes.
    pub const fn new(
        quantity: Quantity,
        variant: &'static str,
        families: &'static [&'static str],
        models: &'static [GrowthModel],
    ) -> Self {
        Self { quantity, variant, families, models, bound: None, floor: None, smallest: 0 }
    }

    /// The growth of a variant's operation counts, all together.
    pub const fn of_operations(variant: &'static str, families: &'static [&'static str]) -> Self {
        Self::new(Quantity::AllCounts, variant, families, GrowthModel::RUNNING_TIMES)
    }

    /// The same plan with a bound.
    #[must_use]
    pub const fn within(self, bound: Bound) -> Self {
        Self { bound: Some(bound), ..self }
    }

    /// The same plan for a quantity that grows at least like a model.
    #[must_use]
    pub const fn at_least(self, floor: GrowthModel) -> Self {
        Self { floor: Some(floor), ..self }
    }

    /// The same plan from a size on.
    #[must_use]
    pub const fn from(self, smallest: usize) -> Self {
        Self { smallest, ..self }
    }

    /// The same plan for another quantity.
    #[must_use]
    pub const fn of(self, quantity: Quantity) -> Self {
        Self { quantity, ..self }
    }
}
