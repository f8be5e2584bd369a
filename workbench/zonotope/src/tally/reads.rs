//! How many generators a part of a computation reads, beside what another tally counts.

use super::{Operation, Rung, Tally};

/// A tally that hands everything on to another one and keeps the number of generators read itself.
pub(crate) struct Reads<'t> {
    pub(crate) tally: &'t mut dyn Tally,
    pub(crate) generators: u64,
}

impl Tally for Reads<'_> {
    fn add(&mut self, operation: Operation, count: u64) {
        if operation == Operation::GeneratorRead {
            self.generators += count;
        }
        self.tally.add(operation, count);
    }

    fn answered_by(&mut self, rung: Rung) {
        self.tally.answered_by(rung);
    }
}
