//! Arrangements of lines given by three doubles each.

use thiserror::Error;

use super::line::ExactLine;
use super::lines::{LineArrangement, LineSource};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::non_finite::NonFinite;

/// Why a set of lines is refused.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum ArrangementError {
    /// A coefficient a, b or c of a line a x + b y + c = 0 is NaN or infinite.
    #[error(transparent)]
    NonFinite(#[from] NonFinite),
    /// There are more lines than a 32-bit index can name.
    #[error("{count} lines are more than the {} that an index can name", u32::MAX)]
    TooMany {
        /// How many lines there are.
        count: usize,
    },
}

#[derive(Debug)]
struct Rows(Vec<[f64; 3]>);

impl LineSource for Rows {
    fn len(&self) -> usize {
        self.0.len()
    }

    fn line(&self, index: u32) -> ExactLine {
        let [x, y, offset] = self.0[index as usize].map(Dyadic::from_f64);
        ExactLine { normal: [x, y], offset }
    }
}

impl LineArrangement<'static> {
    /// The lines a x + b y + c = 0, given as rows [a, b, c]; a row with a = b = 0 has no vertex. O(n log n).
    ///
    /// # Errors
    /// [`ArrangementError`] on the first coefficient that is not finite, or too many lines.
    pub fn from_rows(rows: &[[f64; 3]]) -> Result<Self, ArrangementError> {
        if u32::try_from(rows.len()).is_err() {
            return Err(ArrangementError::TooMany { count: rows.len() });
        }
        for (line, &[a, b, c]) in rows.iter().enumerate() {
            NonFinite::check_fields("line", line, &[("a", a), ("b", b), ("c", c)])?;
        }
        Ok(Self::new(Box::new(Rows(rows.to_vec())), &mut ()))
    }
}
