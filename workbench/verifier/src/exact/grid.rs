//! Doubles as whole multiples of one power of two.

use dashu_int::IBig;

/// The unit 2^exponent of which every number of a check is a whole multiple.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Grid {
    exponent: i32,
}

impl Grid {
    /// The coarsest grid on which all the (finite) numbers lie.
    pub(crate) fn of(numbers: impl IntoIterator<Item = f64>) -> Self {
        let exponents = numbers.into_iter().filter(|&number| number != 0.0).map(|number| decode(number).1);
        Self { exponent: exponents.min().unwrap_or(0) }
    }

    /// The grid of the unit 2^exponent.
    pub(crate) fn at(exponent: i32) -> Self {
        Self { exponent }
    }

    /// The exponent of the unit.
    pub(crate) fn exponent(self) -> i32 {
        self.exponent
    }

    /// The number of units that the number is.
    pub(crate) fn units(self, number: f64) -> IBig {
        let (mantissa, exponent) = decode(number);
        if mantissa == 0 {
            return IBig::ZERO;
        }
        let shift = usize::try_from(exponent - self.exponent).expect("the grid was made for this number");
        IBig::from(mantissa) << shift
    }

    /// The number of units that a point's coordinates are.
    pub(crate) fn point(self, point: [f64; 2]) -> [IBig; 2] {
        point.map(|coordinate| self.units(coordinate))
    }
}

/// Refuses numbers that are not finite: nothing else lies on a grid.
pub(crate) fn check_finite<'a>(name: &str, numbers: impl IntoIterator<Item = &'a f64>) -> Result<(), String> {
    match numbers.into_iter().find(|number| !number.is_finite()) {
        Some(wrong) => Err(format!("{name} holds {wrong}, which is not finite")),
        None => Ok(()),
    }
}

/// The odd mantissa and the exponent of a finite double: number = mantissa · 2^exponent.
fn decode(number: f64) -> (i64, i32) {
    assert!(number.is_finite(), "only finite numbers are placed on a grid");
    let bits = number.to_bits();
    let fraction = (bits & ((1 << 52) - 1)) as i64;
    let biased = ((bits >> 52) & 0x7ff) as i32;
    let (magnitude, exponent) = if biased == 0 { (fraction, -1074) } else { (fraction | 1 << 52, biased - 1075) };
    if magnitude == 0 {
        return (0, 0);
    }
    let zeros = magnitude.trailing_zeros();
    let odd = magnitude >> zeros;
    let signed = if number.is_sign_negative() { -odd } else { odd };
    (signed, exponent + zeros as i32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn doubles_decode_to_odd_mantissas() {
        assert_eq!(decode(0.0), (0, 0));
        assert_eq!(decode(-12.0), (-3, 2));
        assert_eq!(decode(0.1), (3_602_879_701_896_397, -55));
        assert_eq!(decode(f64::from_bits(1)), (1, -1074));
        assert_eq!(decode(f64::MAX), ((1 << 53) - 1, 971));
        assert_eq!(decode(f64::MIN_POSITIVE), (1, -1022));
    }

    #[test]
    fn the_grid_is_as_fine_as_its_finest_number() {
        let grid = Grid::of([0.75, 6.0, 0.0]);
        assert_eq!(grid.exponent(), -2);
        assert_eq!(grid.units(0.75), IBig::from(3));
        assert_eq!(grid.units(-6.0), IBig::from(-24));
        assert_eq!(grid.units(0.0), IBig::ZERO);
        assert_eq!(Grid::of([]).exponent(), 0);
        let wide = Grid::of([f64::MAX, f64::from_bits(1)]);
        assert_eq!(wide.units(f64::MAX) >> 2045, IBig::from((1_u64 << 53) - 1));
    }
}
