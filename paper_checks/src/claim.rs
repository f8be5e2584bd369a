//! Claims of the paper: their parts, the input of their checks, and the verdicts that a check returns.

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
    /// The statement, in our own words; for a correction, the paper's statement as it stands.
    pub statement: &'static str,
    /// The statement that holds instead, or what to do, where the paper is wrong, silent or weaker than the truth.
    pub remedy: Option<&'static str>,
    /// The modules that implement the statement, as Rust paths.
    pub code: &'static [&'static str],
    /// Ids of the figures that show the statement.
    pub figures: &'static [&'static str],
    /// The check of the claim.
    pub check: Check,
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
    /// A place where the paper is wrong, silent or too weak: the claim is the paper's version, and refuting it says
    /// what of this sort has to be corrected.
    Correction(Correction),
}

/// What a reader of the paper has to correct at a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Correction {
    /// What is printed is false: a formula, a rule, or a step of an argument.
    Erratum,
    /// What is printed is true once a condition or a step is added that the paper leaves out.
    MissingCondition,
    /// What is printed is true in exact arithmetic and good enough for the paper's bound, and a program has to take
    /// care or can do better.
    ImplementationNote,
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
}

/// The finding of a check.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The statement held wherever it was tried; the text says where.
    Holds(String),
    /// The statement is false; the text is the witness.
    Refuted(String),
    /// The check could not decide; the text says why.
    Inconclusive(String),
}

impl Verdict {
    /// The evidence, witness or reason.
    pub fn evidence(&self) -> &str {
        match self {
            Verdict::Holds(text) | Verdict::Refuted(text) | Verdict::Inconclusive(text) => text,
        }
    }
}
