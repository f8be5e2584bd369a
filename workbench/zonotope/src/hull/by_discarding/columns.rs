//! Columns of equal width: a look-up that never puts a point into a column before that of a point to its left.

use super::bounds::Bounds;

/// A bounding box cut into columns; their number is a power of two.
#[derive(Clone, Copy)]
pub(super) struct Columns {
    /// The left side of the box.
    origin: f64,
    /// Columns per unit of length, a normal number.
    per_unit: f64,
    /// The number of columns less one.
    mask: u32,
}

impl Columns {
    /// Cuts the box into `count` columns, a power of two below 2^32; `None` if their width cannot be handled in
    /// doubles.
    pub(super) fn new(bounds: &Bounds, count: usize) -> Option<Self> {
        let mask = count as u32 - 1;
        let per_unit = f64::from(mask) / (bounds.high[0] - bounds.low[0]);
        per_unit.is_normal().then_some(Columns { origin: bounds.low[0], per_unit, mask })
    }

    /// The number of columns.
    pub(super) fn count(&self) -> usize {
        self.mask as usize + 1
    }

    /// The column of an abscissa within the box: monotone, because each rounding is.
    #[inline(always)]
    pub(super) fn of(&self, x: f64) -> usize {
        // a double in [2^52, 2^53) has the unit as its last place: adding 2^52 rounds to an integer, found in the low
        // bits
        const UNIT_IN_LAST_PLACE: f64 = (1_u64 << 52) as f64;
        let rounded = (x - self.origin) * self.per_unit + UNIT_IN_LAST_PLACE;
        (rounded.to_bits() as u32 & self.mask) as usize
    }

    /// About the middle of a column.
    pub(super) fn middle(&self, column: usize) -> f64 {
        self.origin + column as f64 / self.per_unit
    }
}
