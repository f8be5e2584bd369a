//! An experiment: a static value with plain fields and functions. Definitions live one a file in
//! [`definitions`](crate::definitions) and are listed in [`catalog`](crate::catalog).

mod plan;

pub use plan::{Bound, FitPlan, Quantity, StatedBy};

use crate::stopwatch::Stopwatch;
use crate::{data, seed};
use families::clouds::Cloud;
use std::collections::BTreeMap;
use std::fmt;
use zonotope::tally::OperationCounts;

/// The size of a run: which sizes, how many instances and how many repetitions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Profile {
    /// The sizes that are finished in about a minute.
    Quick,
    /// All sizes.
    Full,
}

impl fmt::Display for Profile {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Quick => "quick",
            Self::Full => "full",
        })
    }
}

/// A value that depends on the profile.
#[derive(Clone, Copy, Debug)]
pub struct PerProfile<T> {
    /// The value of the quick profile.
    pub quick: T,
    /// The value of the full profile.
    pub full: T,
}

impl<T: Copy> PerProfile<T> {
    /// The same value for both profiles.
    pub const fn both(value: T) -> Self {
        Self { quick: value, full: value }
    }

    /// The value of `profile`.
    pub fn get(&self, profile: Profile) -> T {
        match profile {
            Profile::Quick => self.quick,
            Profile::Full => self.full,
        }
    }
}

/// One of the things an experiment compares, usually a method.
#[derive(Clone, Copy, Debug)]
pub struct Variant {
    /// Stable name: part of every case id.
    pub id: &'static str,
    /// The name that reports show.
    pub title: &'static str,
    /// Sizes above are left out for this variant.
    pub largest: PerProfile<usize>,
}

impl Variant {
    /// A variant that is run at every size.
    pub const fn at_all_sizes(id: &'static str, title: &'static str) -> Self {
        Self { id, title, largest: PerProfile::both(usize::MAX) }
    }
}

/// The timed part of an experiment, which follows the counting: its sizes, its repetitions and the timed work.
#[derive(Clone, Copy, Debug)]
pub struct Timing {
    /// The sizes that are timed, among the experiment's sizes.
    pub sizes: PerProfile<&'static [usize]>,
    /// Timed repetitions of every case, after one that is not recorded.
    pub repetitions: PerProfile<u32>,
    /// Makes the input and returns the work; only what the work passes to the stopwatch is timed.
    pub prepare: fn(&Case) -> Result<TimedWork, String>,
}

/// Work that can be repeated: laps go to the stopwatch, and the digest of the answer comes back (it must be that of the
/// counted run).
pub type TimedWork = Box<dyn FnMut(&mut Stopwatch) -> Result<u64, String>>;

/// The way in which the values of an experiment's cases are put together in the report's table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tabulated {
    /// The median over the instances of the largest size: for sizes, ratios and other properties of one instance.
    MedianAtLargest,
    /// The sum over all sizes and instances: for counts of rare events, whose median is zero however many there are.
    Total,
}

/// An experiment.
#[derive(Clone, Copy, Debug)]
pub struct Experiment {
    /// The stable name of the experiment.
    pub id: &'static str,
    /// The name that reports show.
    pub title: &'static str,
    /// The question that the result answers, with the words that define its quantities.
    pub question: &'static str,
    /// Ids of the claims of the paper for which the experiment is evidence.
    pub claims: &'static [&'static str],
    /// Families (of points, of clouds, of lines, of bodies or of motions) that give instances of every size.
    pub families: &'static [&'static str],
    /// Families that the quick profile leaves out: those whose inputs take longest.
    pub only_full: &'static [&'static str],
    /// Real inputs (`airports`, `iris`, the name of an outline or of a mesh) and solids, which give one instance each,
    /// of their own size.
    pub real_inputs: &'static [&'static str],
    /// The reason why points of a reader's file are no input of the experiment; none if they are one.
    pub refuses: fn(&Cloud) -> Option<&'static str>,
    /// Sizes of the instances.
    pub sizes: PerProfile<&'static [usize]>,
    /// Instances of every family and size, with different seeds.
    pub instances: PerProfile<u32>,
    /// The variants that are compared.
    pub variants: &'static [Variant],
    /// Runs a case with counting on, and checks the answer.
    pub measure: fn(&Case) -> Result<Measurement, String>,
    /// The way in which the values are put together in the report's table.
    pub table: Tabulated,
    /// The timed part, if the experiment has one.
    pub timing: Option<Timing>,
    /// The growth laws that are fitted.
    pub fits: &'static [FitPlan],
}

impl Experiment {
    /// The base of an experiment that counts on families, with medians in its table, and neither times nor fits.
    pub const COUNTED: Self = Self {
        id: "",
        title: "",
        question: "",
        claims: &[],
        families: &[],
        only_full: &[],
        real_inputs: &[],
        refuses: |_| None,
        sizes: PerProfile::both(&[]),
        instances: PerProfile::both(1),
        variants: &[],
        measure: |_| Err("nothing is measured".to_owned()),
        table: Tabulated::MedianAtLargest,
        timing: None,
        fits: &[],
    };
}

/// One run of one variant on one instance.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Case {
    /// The experiment's id.
    pub experiment: &'static str,
    /// The family, or the real input.
    pub family: &'static str,
    /// The variant's id.
    pub variant: &'static str,
    /// The size of the instance.
    pub n: usize,
    /// The number of the instance among those of its family and size, from 0.
    pub instance: u32,
    /// The seed of the instance, which is the same for all variants and experiments.
    pub instance_seed: u64,
    /// The seed of the method's own random choices.
    pub seed: u64,
}

impl Case {
    /// The case with its seeds derived from the master seed.
    pub fn new(
        master_seed: u64,
        experiment: &'static str,
        family: &'static str,
        variant: &'static str,
        n: usize,
        instance: u32,
    ) -> Self {
        let mut case = Self { experiment, family, variant, n, instance, instance_seed: 0, seed: 0 };
        case.instance_seed = seed::seed_of(master_seed, &format!("{family}/n={n}/{instance}"));
        case.seed = seed::seed_of(master_seed, &case.id());
        case
    }

    /// `experiment/family/variant/n=…/instance`: unique in a run.
    pub fn id(&self) -> String {
        let Self { experiment, family, variant, n, instance, .. } = self;
        format!("{experiment}/{family}/{variant}/n={n}/{instance}")
    }

    /// The instance, when the family is one of points or a real input.
    pub fn points(&self) -> Result<Vec<[f64; 2]>, String> {
        if let Some(family) = families::points::find(self.family) {
            return Ok(family.generate(self.n, self.instance_seed));
        }
        data::points(self.family).map(<[_]>::to_vec).ok_or_else(|| format!("no points are called {}", self.family))
    }

    /// The instance, when the family is one of point clouds, a solid or a real input in any dimension.
    pub fn cloud(&self) -> Result<Cloud, String> {
        if let Some(family) = families::clouds::find(self.family) {
            return Ok((family.generate)(self.n, self.instance_seed));
        }
        if let Some(own) = data::own_input(self.family) {
            return Ok(own.clone());
        }
        if self.family == "iris" {
            return Ok(Cloud::Four(data::iris().to_vec()));
        }
        let mesh = data::mesh(self.family).map(|mesh| mesh.vertices.clone());
        match mesh.or_else(|| families::clouds::solid(self.family)) {
            Some(vertices) => Ok(Cloud::Space(vertices)),
            None => self.points().map(Cloud::Plane),
        }
    }

    /// The family, when it is one of bodies in space.
    pub fn body_family(&self) -> Result<&'static families::bodies::BodyFamily<3>, String> {
        families::bodies::find(self.family).ok_or_else(|| format!("no bodies are called {}", self.family))
    }

    /// The generators of the instance, when the family is one of bodies in space.
    pub fn body(&self) -> Result<Vec<[f64; 3]>, String> {
        Ok(self.body_family()?.generate(self.n, self.instance_seed))
    }

    /// The family, when it is one of moving bodies.
    pub fn motion_family(&self) -> Result<&'static families::motions::MotionFamily, String> {
        families::motions::find(self.family).ok_or_else(|| format!("no motions are called {}", self.family))
    }

    /// The instance, when the family is one of lines.
    pub fn lines(&self) -> Result<Vec<families::lines::LineRow>, String> {
        families::lines::find(self.family)
            .map(|family| family.generate(self.n, self.instance_seed))
            .ok_or_else(|| format!("no lines are called {}", self.family))
    }
}

/// Whether an answer is right.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// The answer passed the check of this name.
    Correct(String),
    /// The answer failed a check, for this reason, and its times are void.
    Wrong(String),
    /// No check was made, for this reason.
    Unchecked(String),
}

/// The result of one counted case, the same on every run and machine.
#[derive(Clone, Debug, PartialEq)]
pub struct Measurement {
    /// Operation counts by name.
    pub counts: BTreeMap<String, u64>,
    /// Other numbers by name: sizes of results, ratios, areas.
    pub values: BTreeMap<String, f64>,
    /// Hash of the answer; timed runs must reproduce it.
    pub digest: u64,
    /// Whether the answer is right.
    pub verdict: Verdict,
}

impl Verdict {
    /// The verdict on two answers: the worse one, the first of two that are as bad.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        let badness = |verdict: &Self| match verdict {
            Self::Correct(_) => 0,
            Self::Unchecked(_) => 1,
            Self::Wrong(_) => 2,
        };
        if badness(&other) > badness(&self) { other } else { self }
    }

    /// The outcome of the check called `check`: right, or wrong with the defect that it found.
    pub fn of_check(check: &str, result: Result<(), impl fmt::Display>) -> Self {
        match result {
            Ok(()) => Self::Correct(check.to_owned()),
            Err(defect) => Self::Wrong(format!("{check}: {defect}")),
        }
    }

    /// The verdict of the verifier's check called `check`. An answer that it could not prove is not right.
    pub fn of_verifier<P>(check: &str, verdict: verifier::Verdict<P>) -> Self {
        match verdict {
            verifier::Verdict::Right(_) => Self::Correct(check.to_owned()),
            verifier::Verdict::Wrong(reason) => Self::Wrong(format!("{check}: {reason}")),
            verifier::Verdict::Unchecked(reason) => Self::Unchecked(format!("{check}: {reason}")),
        }
    }
}

impl Measurement {
    /// A measurement without values. Operations that did not occur are recorded as 0.
    pub fn new(counts: &OperationCounts, digest: u64, verdict: Verdict) -> Self {
        let counts = counts.iter().map(|(operation, count)| (operation.name().to_owned(), count)).collect();
        Self { counts, values: BTreeMap::new(), digest, verdict }
    }

    /// The measurement with one more value.
    #[must_use]
    pub fn with_value(mut self, name: &str, value: f64) -> Self {
        self.values.insert(name.to_owned(), value);
        self
    }
}
