//! Lines in floating point, with bounds on how far they may be off: stored as columns, or made as they are read.
//!
//! A pass over lines that are made as they are read needs no memory for them: each block is made, read and forgotten.

use std::borrow::Cow;
use std::fmt::Debug;

/// How far the floating-point lines may be from the exact ones, beside the floor for underflow.
///
/// Normals are within 2 · UNIT of their magnitude; offsets are within
/// `offset_relative` · |offset| + `offset_per_normal` · (|normal.x| + |normal.y|).
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct LineError {
    pub(crate) offset_relative: f64,
    pub(crate) offset_per_normal: f64,
}

impl LineError {
    /// The larger of two errors, part by part: it bounds both.
    pub(crate) fn or(self, other: Self) -> Self {
        Self {
            offset_relative: self.offset_relative.max(other.offset_relative),
            offset_per_normal: self.offset_per_normal.max(other.offset_per_normal),
        }
    }
}

/// Lines as three columns, in the scaled frame, with their weights multiplied in.
#[derive(Debug, Clone, Default)]
pub(crate) struct Columns {
    pub(crate) normal_x: Vec<f64>,
    pub(crate) normal_y: Vec<f64>,
    pub(crate) offset: Vec<f64>,
}

impl Columns {
    pub(crate) fn with_capacity(capacity: usize) -> Self {
        let column = || Vec::with_capacity(capacity);
        Self { normal_x: column(), normal_y: column(), offset: column() }
    }

    pub(crate) fn push(&mut self, [x, y, offset]: [f64; 3]) {
        self.normal_x.push(x);
        self.normal_y.push(y);
        self.offset.push(offset);
    }

    pub(crate) fn len(&self) -> usize {
        self.offset.len()
    }
}

/// Lines copied one by one, with a bound on the errors of all of them.
#[derive(Debug)]
pub(crate) struct GatheredLines {
    columns: Columns,
    error: LineError,
}

impl GatheredLines {
    pub(crate) fn with_capacity(capacity: usize) -> Self {
        Self { columns: Columns::with_capacity(capacity), error: LineError::default() }
    }

    pub(crate) fn push(&mut self, row: [f64; 3], error: LineError) {
        self.columns.push(row);
        self.error = self.error.or(error);
    }

    pub(crate) fn into_lines<'p>(self) -> RoundedLines<'p> {
        RoundedLines::Stored { columns: Cow::Owned(self.columns), error: self.error }
    }
}

/// The number of lines that are read at a time.
pub(crate) const BLOCK: usize = 256;

/// Up to this number, lines are made in a smaller room: to clear a large one costs more than a pass over few lines.
const SMALL_BLOCK: usize = 32;

/// A run of consecutive lines.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Block<'b> {
    pub(crate) normal_x: &'b [f64],
    pub(crate) normal_y: &'b [f64],
    pub(crate) offset: &'b [f64],
    pub(crate) error: LineError,
}

impl Block<'_> {
    pub(crate) fn len(&self) -> usize {
        self.offset.len()
    }

    /// The coefficients x, y and the offset of a line.
    #[inline(always)]
    pub(crate) fn row(&self, line: usize) -> [f64; 3] {
        [self.normal_x[line], self.normal_y[line], self.offset[line]]
    }
}

/// Lines that are made as they are read.
pub(crate) trait MadeLines: Debug + Sync {
    /// The number of lines.
    fn len(&self) -> usize;

    /// The coefficients x, y and the offset of a line, and the bounds on its error.
    fn row(&self, line: usize) -> ([f64; 3], LineError);

    /// Makes the lines from `start` on until the three columns, which are equally long, are full.
    fn make(&self, start: usize, columns: [&mut [f64]; 3]) -> LineError;
}

/// The lines of an instance in floating point.
#[derive(Debug)]
pub(crate) enum RoundedLines<'p> {
    Stored { columns: Cow<'p, Columns>, error: LineError },
    Made(&'p (dyn MadeLines + 'p)),
}

impl RoundedLines<'_> {
    pub(crate) fn len(&self) -> usize {
        match self {
            Self::Stored { columns, .. } => columns.len(),
            Self::Made(lines) => lines.len(),
        }
    }

    /// The coefficients x, y and the offset of a line, and the bounds on its error.
    pub(crate) fn row(&self, line: usize) -> ([f64; 3], LineError) {
        match self {
            Self::Stored { columns, error } => {
                ([columns.normal_x[line], columns.normal_y[line], columns.offset[line]], *error)
            }
            Self::Made(lines) => lines.row(line),
        }
    }

    /// Visits all lines, a block at a time, in their order.
    pub(crate) fn each_block(&self, mut visit: impl FnMut(usize, Block)) {
        let n = self.len();
        let ranges = (0..n).step_by(BLOCK).map(|start| start..n.min(start + BLOCK));
        match self {
            Self::Stored { columns, error } => {
                for range in ranges {
                    let Columns { normal_x, normal_y, offset } = &**columns;
                    let [normal_x, normal_y, offset] =
                        [normal_x, normal_y, offset].map(|column| &column[range.clone()]);
                    visit(range.start, Block { normal_x, normal_y, offset, error: *error });
                }
            }
            Self::Made(lines) => {
                let (mut small, mut large);
                let room: [&mut [f64]; 3] = if n <= SMALL_BLOCK {
                    small = [[0.0; SMALL_BLOCK]; 3];
                    small.each_mut().map(|column| &mut column[..])
                } else {
                    large = [[0.0; BLOCK]; 3];
                    large.each_mut().map(|column| &mut column[..])
                };
                let [x, y, b] = room;
                for range in ranges {
                    let columns = [&mut *x, &mut *y, &mut *b].map(|column| &mut column[..range.len()]);
                    let error = lines.make(range.start, columns);
                    let [normal_x, normal_y, offset] = [&*x, &*y, &*b].map(|column| &column[..range.len()]);
                    visit(range.start, Block { normal_x, normal_y, offset, error });
                }
            }
        }
    }
}
