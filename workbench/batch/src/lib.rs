//! Questions and answers as lines of JSON: the interface of the workbench without its program.
//!
//! A question is `{"id": …, "kind": …, "input": {…}, "method": …}` (the method is optional). A kind is one row of
//! [`KINDS`]. [`answer`] makes the answer of a line, [`verify`] checks an answer against its question exactly;
//! [`answer_line`] and [`check`] do the same for a caller who numbers the lines of a batch, chooses a seed, or has
//! read the JSON already.
//!
//! [`picture`] makes data to draw, which is no claim and has no check: one row of [`PICTURES`] each.
//! [`picture_in_columns`] makes the same without writing numbers as text, and a [`HeldBody`] is read once and asked
//! about many points, for a host that draws while somebody drags.
//!
//! Reasons to refuse a question are looked for in this order: a line that is too long or is not JSON; a number that
//! is not finite, anywhere in the input; the fields of the question; its kind; its method; the fields and values of
//! the input.
//!
//! The crate reads no files and has no command line, so that a page or another program can ask, answer and verify.
//! Methods that need an engine for linear programs are there with the feature `linear-programming`; without the default
//! feature `every-dimension` all questions are of the plane and of space.
//!
//! ```
//! let question =
//!     r#"{"id":"q","kind":"support","input":{"direction":[1,2],"center":[5,5],"generators":[[1,0],[0,1]]}}"#;
//! let answer = batch::answer(question);
//! assert!(answer.contains(r#""result":{"value":18.0,"point":[6.0,6.0]}"#));
//! assert!(matches!(batch::verify(question, &answer), batch::Verdict::Right(_)));
//! assert!(matches!(batch::verify(question, &answer.replace("18.0", "18.5")), batch::Verdict::Wrong(_)));
//! ```

mod answering;
mod claimed;
mod columns;
mod dimension;
mod fields;
pub mod json;
mod kinds;
mod limits;
mod meshes;
pub mod names;
mod nearest;
mod pictures;
mod place;
pub mod placement;
mod question;
mod refusal;
mod transcript;

pub use answering::{Answer, Line, answer, answer_line, picture};
pub use columns::{hold, locate_in_columns, picture_in_columns};
pub use dimension::MAX_DIMENSION;
pub use fields::read_pose;
pub use kinds::{HeldBody, KINDS, Kind, min_area_result, read_motion};
pub use limits::{MAX_LINE_BYTES, MAX_VECTORS};
pub use nearest::{did_you_mean, nearest};
pub use pictures::{PICTURES, Picture};
pub use refusal::{Code, Refusal};
pub use transcript::{Verdict, check, check_unread, guarded, verify};
