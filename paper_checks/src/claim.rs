//! Claims of the paper: their parts, the input of their checks, and the verdicts that a check returns.

use std::collections::BTreeSet;

use experiments::catalog::EXPERIMENTS;

/// One statement of the paper, or one correction to it.
#[derive(Debug)]
pub struct Claim {
    /// The name by which experiments, figures and reports refer to the claim, such as `lemma-4.3`.
    pub id: &'static str,
    /// The place of the statement in the paper.
    pub place: Place,
    /// The sort of the statement.
    pub kind: ClaimKind,
    /// The statement, in our own words; for a correction or a note, what the paper says at the place.
    pub statement: &'static str,
    /// The statement that holds instead, or what to do, where the paper is wrong, silent or weaker than the truth; for
    /// a note, the note.
    pub remedy: Option<&'static str>,
    /// The modules that implement the statement, as Rust paths.
    pub code: &'static [&'static str],
    /// Ids of the figures that show the statement.
    pub figures: &'static [&'static str],
    /// The check of the claim.
    pub check: Check,
    /// The instances on which the check tries the statement.
    pub tried: Tried,
}

impl Claim {
    /// The base of a claim that is listed but neither implemented nor checked.
    pub const LISTED: Claim = Claim {
        id: "",
        place: Place { section: "", label: "" },
        kind: ClaimKind::Statement,
        statement: "",
        remedy: None,
        code: &[],
        figures: &[],
        check: Check::NotYetImplemented,
        tried: Tried::Nothing,
    };

    /// Ids of the experiments that measure the claim: those that name it.
    pub fn experiments(&self) -> Vec<&'static str> {
        let naming = EXPERIMENTS.iter().filter(|experiment| experiment.claims.contains(&self.id));
        naming.map(|experiment| experiment.id).collect()
    }
}

/// A place in the paper.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    /// The section's number, such as `4.1`.
    pub section: &'static str,
    /// The label or a few words that find the place within the section.
    pub label: &'static str,
}

/// The sort of a statement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ClaimKind {
    /// A statement in running text.
    Statement,
    /// A numbered lemma.
    Lemma,
    /// A numbered corollary.
    Corollary,
    /// A numbered theorem.
    Theorem,
    /// A figure.
    Figure,
    /// An open question of the conclusions.
    OpenQuestion,
    /// A place where the paper is wrong or leaves out a condition: the statement is the paper's, and its refutation
    /// says what of this sort has to be corrected.
    Correction(Correction),
    /// A place where what the paper says, or an assumption that it states, is right and a program has to know more. The
    /// check is one of the remark.
    Note,
}

/// The correction that a reader of the paper has to make at a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Correction {
    /// The printed text is false: a formula, a rule, or a step of an argument.
    Erratum,
    /// The printed text is true once a condition or a step is added that the paper leaves out and does not assume.
    MissingCondition,
}

/// The instances on which a check tries a statement: they say how far its "holds" reaches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tried {
    /// None: the claim has no check, or has that of another claim.
    Nothing,
    /// One instance decides: the statement is that there is one, or it is about one object, or an instance refutes it.
    Witness,
    /// Instances of the one kind that the statement is about.
    Scope(&'static str),
    /// Instances of these kinds.
    On(&'static [&'static str]),
    /// The result is tried on several kinds, the growth of its cost on these. Experiments that measured the growth on
    /// families of their own add to them.
    Growth(&'static [&'static str]),
}

impl Tried {
    /// The kind of instances that a statement on more than that was tried on alone, beside those that experiments
    /// measured.
    pub fn alone(self, measured: &BTreeSet<&'static str>) -> Option<&'static str> {
        match self {
            Self::On([kind]) => Some(kind),
            Self::Growth([kind]) if measured.len() < 2 => Some(kind),
            _ => None,
        }
    }
}

/// The check of a claim.
#[derive(Clone, Copy, Debug)]
pub enum Check {
    /// No check has been written yet.
    NotYetImplemented,
    /// The claim says what the claim of this id says, and has the same verdict.
    Restates(&'static str),
    /// This function checks the claim.
    Run(fn(&CheckContext) -> Verdict),
}

/// The input of a check: a seed, and what experiments have measured.
#[derive(Clone, Debug)]
pub struct CheckContext {
    /// The seed of every random instance.
    pub seed: u64,
    /// The measurements of finished experiments; empty when none was run.
    pub measurements: Vec<Measurement>,
}

impl Default for CheckContext {
    /// The context of the committed ledger: seed 2003, no experiments.
    fn default() -> Self {
        CheckContext { seed: 2003, measurements: Vec::new() }
    }
}

impl CheckContext {
    /// The measurements of the experiments that name a claim.
    pub fn measurements_for(&self, claim: &Claim) -> Vec<&Measurement> {
        let experiments = claim.experiments();
        self.measurements.iter().filter(|measurement| experiments.contains(&measurement.experiment.as_str())).collect()
    }

    /// The families on which measurements agree with a claim.
    pub fn families_for(&self, claim: &Claim) -> BTreeSet<&'static str> {
        let agreeing = self.measurements_for(claim).into_iter().filter(|measurement| measurement.agrees);
        agreeing.flat_map(Measurement::families).collect()
    }
}

/// A sentence that an experiment contributes to a claim.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Measurement {
    /// The experiment's id.
    pub experiment: String,
    /// The id of the method that was measured.
    pub method: String,
    /// The result of the measurement in words, with its numbers.
    pub summary: String,
    /// Whether the measurement shows that the bound is kept; it does not where it leaves that undecided.
    pub agrees: bool,
    /// Whether the bound is the paper's: one of our own decides no statement of the paper.
    pub is_of_paper: bool,
}

impl Measurement {
    /// The families whose growth the experiment compares with a bound for this method.
    fn families(&self) -> impl Iterator<Item = &'static str> {
        let experiment = EXPERIMENTS.iter().find(|experiment| experiment.id == self.experiment);
        let plans = experiment.into_iter().flat_map(|experiment| experiment.fits);
        let own = plans.filter(|plan| plan.variant == self.method && plan.bound.is_some());
        own.flat_map(|plan| plan.families).copied()
    }
}

/// The finding of a check.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The statement held wherever it was tried; the text says where.
    Holds(String),
    /// The statement held, and instances of one kind alone were tried; the text says which.
    HoldsWhereTried(String),
    /// A part of the statement held, or a part of the question is answered; the text says which, and what is left.
    InPart(String),
    /// The statement is false; the text is the witness.
    Refuted(String),
    /// The check could not decide; the text says why.
    Inconclusive(String),
}

impl Verdict {
    /// The evidence, witness or reason.
    pub fn evidence(&self) -> &str {
        match self {
            Verdict::Holds(text)
            | Verdict::HoldsWhereTried(text)
            | Verdict::InPart(text)
            | Verdict::Refuted(text)
            | Verdict::Inconclusive(text) => text,
        }
    }

    /// The verdict as far as instances of one kind bear it.
    #[must_use]
    pub(crate) fn where_tried(self, kind: &str) -> Self {
        match self {
            Verdict::Holds(text) => Verdict::HoldsWhereTried(format!("{text}; tried on {kind} alone")),
            other => other,
        }
    }
}
