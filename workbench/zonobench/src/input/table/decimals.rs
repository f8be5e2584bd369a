//! The numbers of a table: whether their commas are decimal ones, which all of them must agree on.

use crate::input::error::{Place, Problem};
use crate::input::number::{has_plain_decimal_comma, number, with_decimal_point};

/// The decimal marks of the numbers that were read so far.
#[derive(Default)]
pub(super) struct Decimals {
    /// The first number with a comma.
    first: Option<(String, Place)>,
    /// Whether the comma of some number cannot separate thousands.
    is_plain: bool,
    has_points: bool,
}

impl Decimals {
    /// The number in a cell between such separators.
    pub(super) fn read(&mut self, cell: &[u8], separator: u8, place: impl Fn() -> Place) -> Result<f64, Problem> {
        match number(cell) {
            Ok(number) => {
                self.has_points |= cell.contains(&b'.');
                Ok(number)
            }
            Err(Problem::DecimalComma(word)) if separator == b' ' => Err(Problem::CommaBesideSpaces(word)),
            Err(Problem::DecimalComma(word)) => {
                let pointed = with_decimal_point(&word).and_then(|word| word.parse().ok());
                self.is_plain |= has_plain_decimal_comma(&word);
                match pointed {
                    Some(number) => {
                        self.first.get_or_insert_with(|| (word, place()));
                        Ok(number)
                    }
                    None => Err(Problem::NotANumber(word)),
                }
            }
            Err(problem) => Err(problem),
        }
    }

    /// The remark on decimal commas, unless they leave a doubt.
    pub(super) fn finish(self) -> Result<Option<String>, (Problem, Place)> {
        match self.first {
            None => Ok(None),
            Some((word, place)) if self.has_points => Err((Problem::CommasAndPoints(word), place)),
            Some((word, place)) if !self.is_plain => Err((Problem::AmbiguousComma(word), place)),
            Some(_) => Ok(Some("commas are read as decimal points".to_owned())),
        }
    }
}
