//! The finding on a claim for a reader of the paper.

use crate::claim::{Check, Claim, ClaimKind, Correction, Verdict};

/// The finding on a claim: the verdict of its check, a refutation told by what has to be corrected. Each claim is
/// counted under one of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Finding {
    /// The statement held on instances of several kinds, or of the kind that it is about.
    Holds,
    /// The statement held, and instances of one kind alone were tried.
    HoldsWhereTried,
    /// A part of the statement held, and the rest was not tried.
    HoldsInPart,
    /// The claim says what another one says, and is no further evidence.
    Restated,
    /// An open question of the paper has a part of its answer.
    AnsweredInPart,
    /// The printed text of the paper is false.
    Erratum,
    /// The printed text of the paper needs a condition or a step that it leaves out.
    MissingCondition,
    /// The statement of the paper is right, and a program has to know more.
    Note,
    /// A statement that was listed as the paper's, and not as one to be corrected, is false.
    Refuted,
    /// The check could not decide.
    Inconclusive,
    /// There is no check yet.
    NotYetImplemented,
}

impl Finding {
    /// All findings, in the order of tallies.
    pub const ALL: [Self; 11] = [
        Self::Holds,
        Self::HoldsWhereTried,
        Self::HoldsInPart,
        Self::Restated,
        Self::AnsweredInPart,
        Self::Erratum,
        Self::MissingCondition,
        Self::Note,
        Self::Refuted,
        Self::Inconclusive,
        Self::NotYetImplemented,
    ];

    /// The finding on a claim whose check returned this verdict, if it has a check.
    pub fn of(claim: &Claim, verdict: Option<&Verdict>) -> Self {
        let Some(verdict) = verdict else { return Self::NotYetImplemented };
        if let Check::Restates(_) = claim.check {
            return Self::Restated;
        }
        match (claim.kind, verdict) {
            (_, Verdict::Inconclusive(_)) => Self::Inconclusive,
            (ClaimKind::OpenQuestion, Verdict::Holds(_) | Verdict::HoldsWhereTried(_) | Verdict::InPart(_)) => {
                Self::AnsweredInPart
            }
            (ClaimKind::Note, Verdict::Holds(_) | Verdict::HoldsWhereTried(_)) => Self::Note,
            (ClaimKind::Correction(Correction::Erratum), Verdict::Refuted(_)) => Self::Erratum,
            (ClaimKind::Correction(Correction::MissingCondition), Verdict::Refuted(_)) => Self::MissingCondition,
            (_, Verdict::Refuted(_)) => Self::Refuted,
            (_, Verdict::Holds(_)) => Self::Holds,
            (_, Verdict::HoldsWhereTried(_)) => Self::HoldsWhereTried,
            (_, Verdict::InPart(_)) => Self::HoldsInPart,
        }
    }

    /// The finding in a few words.
    pub fn words(self) -> &'static str {
        match self {
            Self::Holds => "holds",
            Self::HoldsWhereTried => "holds where tried",
            Self::HoldsInPart => "holds in part",
            Self::Restated => "restated",
            Self::AnsweredInPart => "answered in part",
            Self::Erratum => "erratum",
            Self::MissingCondition => "condition missing",
            Self::Note => "note",
            Self::Refuted => "refuted",
            Self::Inconclusive => "inconclusive",
            Self::NotYetImplemented => "not yet implemented",
        }
    }

    /// The finding as the rest of a sentence about a claim.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Holds => "held on instances of several kinds, or of the one kind that it is about",
            Self::HoldsWhereTried => "held, and instances of one kind or of one dimension alone were tried",
            Self::HoldsInPart => "held as far as it was tried, and a part of it was not",
            Self::Restated => "says what another one says, and is counted there",
            Self::AnsweredInPart => "is a question of the paper, of which a part has an answer",
            Self::Erratum => "is false as the paper prints it",
            Self::MissingCondition => "is true once a condition or a step is added that the paper leaves out",
            Self::Note => "is right, or is an assumption that the paper states, and a program has to know more",
            Self::Refuted => "is false, and was not listed for correction",
            Self::Inconclusive => "was not decided by its check",
            Self::NotYetImplemented => "waits for its algorithm",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn claim(kind: ClaimKind) -> Claim {
        Claim { kind, ..Claim::LISTED }
    }

    #[test]
    fn only_a_refuted_correction_is_a_correction() {
        let erratum = claim(ClaimKind::Correction(Correction::Erratum));
        let (refuted, holds) = (Verdict::Refuted(String::new()), Verdict::Holds(String::new()));
        assert_eq!(Finding::of(&erratum, Some(&refuted)), Finding::Erratum);
        assert_eq!(Finding::of(&erratum, Some(&holds)), Finding::Holds);
        assert_eq!(Finding::of(&erratum, None), Finding::NotYetImplemented);
        assert_eq!(Finding::of(&claim(ClaimKind::Theorem), Some(&refuted)), Finding::Refuted);
        assert_eq!(Finding::of(&claim(ClaimKind::Note), Some(&refuted)), Finding::Refuted);
    }

    #[test]
    fn only_statements_hold() {
        let holds = Verdict::Holds(String::new());
        let restated = Claim { check: Check::Restates("another"), ..Claim::LISTED };
        assert_eq!(Finding::of(&restated, Some(&holds)), Finding::Restated);
        assert_eq!(Finding::of(&claim(ClaimKind::Note), Some(&holds)), Finding::Note);
        assert_eq!(Finding::of(&claim(ClaimKind::OpenQuestion), Some(&holds)), Finding::AnsweredInPart);
        assert_eq!(Finding::of(&Claim::LISTED, Some(&holds.clone().where_tried("cubes"))), Finding::HoldsWhereTried);
        assert_eq!(Finding::of(&Claim::LISTED, Some(&Verdict::InPart(String::new()))), Finding::HoldsInPart);
        assert_eq!(Finding::of(&Claim::LISTED, Some(&holds)), Finding::Holds);
    }
}
