//! The ledger of the paper: every statement of "Zonotopes as Bounding Volumes" (Guibas, Nguyen, Zhang 2003), each with
//! the check that this workbench runs on it and the verdict that the check returns.
//!
//! A [`Claim`] is a static value in a file of its own under `claims/`, listed in [`catalog::CLAIMS`]. Its check works
//! in exact rational arithmetic on instances drawn from a fixed seed, and derives its own side of the comparison from
//! the definitions in [`plane`] and [`space`]; the library's answer is only ever the other side. Claims whose check has
//! not been written stand in the ledger all the same, as not yet implemented.
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

pub mod bodies;
pub mod catalog;
mod claim;
mod claims;
mod enclosing;
mod growth;
pub mod instances;
mod ledger;
mod length_proofs;
mod library;
mod linear_program;
pub mod plane;
mod proofs;
mod pyramids;
mod ratio;
mod runs;
pub mod space;
mod subdifferential;
mod upper_hull;

pub use claim::{Check, CheckContext, Claim, ClaimKind, Measurement, Place, Verdict};
pub use ledger::{ClaimResult, markdown, run, text, verdict};
