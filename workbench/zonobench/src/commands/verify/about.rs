//! An answer about files: the question that it answers as far as anyone knows, and what can be said of it.
//!
//! The question is the one that the answer records. An answer that is wrong for the question at hand may be right for
//! its own, where it records none or was computed from other data: it is left unchecked. An answer that is right for
//! the question at hand is right, wherever it comes from.

use std::path::Path;

use batch::json::Tree;
use batch::{Verdict, check};

use crate::commands::Ending;
use crate::input::PointSource;

/// The note on an answer to another question than the one at hand, as far as anyone knows.
pub(super) const NO_RECORD: &str =
    "the answer does not record what was asked, and as an answer to these options it fails";
pub(super) const OTHER_DATA: &str = "the data are not those that the answer was computed from, and for these it fails";

/// The note on an answer that is right, but records other files than those at hand, or the same in another order.
const OF_OTHER_FILES: &str = "right for these files, but the answer was computed from others, as its request says";

/// The reason why no question can be asked of files, with the SHA-256 that the answer has of each. Where a file is not
/// the one that the answer is about, this comes first: the complaint may be about nothing else.
pub(super) fn cannot_be_asked<'a>(
    files: impl IntoIterator<Item = (&'a Path, Option<&'a str>)>,
    of_what: &str,
    complaint: &anyhow::Error,
) -> String {
    let is_other = |(file, recorded): &(&Path, Option<&str>)| {
        let found = PointSource::file_sha256(file);
        recorded.is_some_and(|recorded| found.is_some_and(|found| found != recorded))
    };
    let other = files.into_iter().find(is_other).map_or_else(String::new, |(file, _)| {
        format!("{} is not the file that the answer is about (its SHA-256 differs), and ", file.display())
    });
    format!("{other}the question that the answer records cannot be asked{of_what}: {complaint:#}")
}

/// A question about files.
pub(super) struct AboutData {
    pub(super) question: Result<Tree, String>,
    /// Why an answer that fails the check may be right for another question, or for other data.
    pub(super) doubt: Option<&'static str>,
    /// A field of the answer's request that says nothing to this program.
    pub(super) unknown: Option<String>,
}

impl AboutData {
    /// Nothing can be judged, for the given reason.
    pub(super) fn without_question(reason: String) -> Self {
        Self { question: Err(reason), doubt: None, unknown: None }
    }

    /// The question, if it can be asked.
    pub(super) fn question(&self) -> Option<&Tree> {
        self.question.as_ref().ok()
    }

    /// The words on an answer, and whether the command has done what it was asked to: it has not where
    /// nothing could be judged.
    pub(super) fn judge(&self, answer: &Tree) -> (Verdict, Ending) {
        let question = match &self.question {
            Ok(question) => question,
            Err(reason) => return (Verdict::Unchecked(reason.clone()), Ending::Bad),
        };
        match (check(&named_after(question, answer), answer), &self.doubt) {
            (Verdict::Wrong(complaint), Some(doubt)) => {
                (Verdict::Unchecked(format!("{doubt}: {complaint}")), Ending::Bad)
            }
            (verdict @ Verdict::Wrong(_), None) => (verdict, Ending::Bad),
            (Verdict::Right(proved), Some(doubt)) if *doubt != NO_RECORD => {
                (self.beside_what_is_unknown(format!("{proved}; {OF_OTHER_FILES}")), Ending::Good)
            }
            (Verdict::Right(proved), _) => (self.beside_what_is_unknown(proved), Ending::Good),
            (verdict @ Verdict::Unchecked(_), _) => (verdict, Ending::Good),
        }
    }

    /// The note on an answer for which something has been proved.
    fn beside_what_is_unknown(&self, proved: String) -> Verdict {
        match &self.unknown {
            None => Verdict::Right(proved),
            Some(name) => Verdict::Unchecked(format!("the field `request, {name}` is not checked; the rest: {proved}")),
        }
    }
}

/// The question under the name that the answer has: data are asked about under whatever name.
fn named_after(question: &Tree, answer: &Tree) -> Tree {
    let mut question = question.clone();
    if let (Tree::Object(fields), Some(id)) = (&mut question, answer.field("id")) {
        fields.iter_mut().filter(|(name, _)| name == "id").for_each(|(_, own)| *own = id.clone());
    }
    question
}
