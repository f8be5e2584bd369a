//! The ledger of the paper: every statement of "Zonotopes as Bounding Volumes" (Guibas, Nguyen, Zhang 2003), each with
//! the check that this workbench runs on it and the verdict that the check returns.
//!
//! A [`Claim`] is a static value in a file of its own under `claims/`, listed in [`catalog::CLAIMS`]. Its check works
//! in exact rational arithmetic on [`instances`] drawn from a fixed seed, and derives its own side of the comparison
//! from the [`definitions`]; the library's answer is only ever the other side. Claims whose check has not been written
//! stand in the ledger all the same, as not yet implemented.
//!
//! [`run`] checks everything, [`markdown`] writes the ledger; the committed `CLAIMS.md` is that text, and a test
//! compares the two (`ZONOTOPE_BLESS=1` rewrites the file).
//!
//! ```
//! use paper_checks::{CheckContext, Verdict, catalog, verdict};
//!
//! let claim = catalog::find("lemma-4.3").expect("the lemma is listed");
//! let verdict = verdict(claim, &CheckContext::default()).expect("the lemma has a check");
//! assert!(matches!(verdict, Verdict::Holds(_)));
//! ```

pub mod catalog;
mod claim;
mod claims;
pub mod definitions;
mod finding;
mod growth;
pub mod instances;
mod ledger;
mod proofs;

pub use claim::{Check, CheckContext, Claim, ClaimKind, Correction, Measurement, Place, Tried, Verdict};
pub use finding::Finding;
pub use ledger::{COMMITTED, ClaimResult, OF_A_RUN, markdown, run, text, verdict};
