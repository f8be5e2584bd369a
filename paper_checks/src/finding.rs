//! What the check of a claim comes to for a reader of the paper.

use crate::claim::{ClaimKind, Correction, Verdict};

/// What is found of a claim: the verdict of its check, a refutation told by what has to be corrected.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Finding {
    /// The statement held wherever it was tried.
    Holds,
    /// What the paper prints is false.
    Erratum,
    /// What the paper prints needs a condition or a step that it leaves out.
    MissingCondition,
    /// What the paper prints is true, and a program has to take care or can do better.
    ImplementationNote,
    /// A statement that was listed as the paper's, and not as one to be corrected, is false.
    Refuted,
    /// The check could not decide.
    Inconclusive,
    /// There is no check yet.
    NotYetImplemented,
}

impl Finding {
    /// All findings, in the order of tallies.
    pub const ALL: [Self; 7] = [
        Self::Holds,
        Self::Erratum,
        Self::MissingCondition,
        Self::ImplementationNote,
        Self::Refuted,
        Self::Inconclusive,
        Self::NotYetImplemented,
    ];

    /// The finding on a claim of a kind whose check returned this verdict, if it has a check.
    pub fn of(kind: ClaimKind, verdict: Option<&Verdict>) -> Self {
        match (verdict, kind) {
            (None, _) => Self::NotYetImplemented,
            (Some(Verdict::Holds(_)), _) => Self::Holds,
            (Some(Verdict::Inconclusive(_)), _) => Self::Inconclusive,
            (Some(Verdict::Refuted(_)), ClaimKind::Correction(Correction::Erratum)) => Self::Erratum,
            (Some(Verdict::Refuted(_)), ClaimKind::Correction(Correction::MissingCondition)) => Self::MissingCondition,
            (Some(Verdict::Refuted(_)), ClaimKind::Correction(Correction::ImplementationNote)) => {
                Self::ImplementationNote
            }
            (Some(Verdict::Refuted(_)), _) => Self::Refuted,
        }
    }

    /// The finding in a few words.
    pub fn words(self) -> &'static str {
        match self {
            Self::Holds => "holds",
            Self::Erratum => "erratum",
            Self::MissingCondition => "condition missing",
            Self::ImplementationNote => "implementation note",
            Self::Refuted => "refuted",
            Self::Inconclusive => "inconclusive",
            Self::NotYetImplemented => "not yet implemented",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_refuted_correction_is_a_correction() {
        let erratum = ClaimKind::Correction(Correction::Erratum);
        let (refuted, holds) = (Verdict::Refuted(String::new()), Verdict::Holds(String::new()));
        assert_eq!(Finding::of(erratum, Some(&refuted)), Finding::Erratum);
        assert_eq!(Finding::of(erratum, Some(&holds)), Finding::Holds);
        assert_eq!(Finding::of(erratum, None), Finding::NotYetImplemented);
        assert_eq!(Finding::of(ClaimKind::Theorem, Some(&refuted)), Finding::Refuted);
    }
}
