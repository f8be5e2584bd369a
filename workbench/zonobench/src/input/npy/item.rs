//! A number of an array, by its type.

use crate::input::error::Problem;

/// The type of a number, with the order of its bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Item {
    kind: Kind,
    bytes: usize,
    is_big_endian: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Float,
    Signed,
    Unsigned,
}

impl Item {
    /// The type of a number, such as `<f8`.
    pub(super) fn parse(text: &str) -> Option<Self> {
        let mut letters = text.chars();
        let order = letters.next()?;
        let kind = match letters.next()? {
            'f' => Kind::Float,
            'i' => Kind::Signed,
            'u' => Kind::Unsigned,
            _ => return None,
        };
        let bytes = match (kind, letters.as_str()) {
            (_, "8") => 8,
            (_, "4") => 4,
            (_, "2") => 2,
            (Kind::Signed | Kind::Unsigned, "1") => 1,
            _ => return None,
        };
        let has_order = matches!(order, '<' | '>') || (order == '|' && bytes == 1);
        has_order.then_some(Self { kind, bytes, is_big_endian: order == '>' })
    }

    /// The number of its bytes.
    pub(super) fn bytes(self) -> usize {
        self.bytes
    }

    /// The number, which must be finite and a double.
    pub(super) fn read(self, bytes: &[u8]) -> Result<f64, Problem> {
        let mut wide = [0; 8];
        wide[..self.bytes].copy_from_slice(bytes);
        if self.is_big_endian {
            wide[..self.bytes].reverse();
        }
        let unused_bits = 64 - 8 * self.bytes as u32;
        let exact = |whole: i128| {
            let number = whole as f64;
            if number as i128 == whole { Ok(number) } else { Err(Problem::NotADouble(whole.to_string())) }
        };
        match self.kind {
            Kind::Signed => exact(i128::from((i64::from_le_bytes(wide) << unused_bits) >> unused_bits)),
            Kind::Unsigned => exact(i128::from(u64::from_le_bytes(wide))),
            Kind::Float => {
                let number = match self.bytes {
                    2 => from_half(u16::from_le_bytes([wide[0], wide[1]])),
                    4 => f64::from(f32::from_le_bytes([wide[0], wide[1], wide[2], wide[3]])),
                    _ => f64::from_le_bytes(wide),
                };
                if number.is_finite() { Ok(number) } else { Err(Problem::NotFinite(number.to_string())) }
            }
        }
    }
}

/// A number of half precision: a sign, five bits of exponent, ten of fraction. Each one is a double.
fn from_half(bits: u16) -> f64 {
    let sign = if bits >> 15 == 0 { 1.0 } else { -1.0 };
    let (exponent, fraction) = ((bits >> 10) & 31, f64::from(bits & 1023));
    let power = |exponent: i32| f64::from_bits(((exponent + 1023) as u64) << 52);
    sign * match exponent {
        0 => fraction * power(-24),
        31 if fraction == 0.0 => f64::INFINITY,
        31 => f64::NAN,
        _ => (1024.0 + fraction) * power(i32::from(exponent) - 25),
    }
}

/// The bytes of a value of any type that has a fixed length, such as `|S10`, `<U5`, `<M8[ns]` or `|V4`.
pub(super) fn bytes_of(kind: &str) -> Option<usize> {
    let rest = kind.strip_prefix(['<', '>', '|', '='])?;
    let mut letters = rest.chars();
    let letter = letters.next()?;
    let (length, _) = letters.as_str().split_once('[').unwrap_or((letters.as_str(), ""));
    let length: usize = length.parse().ok()?;
    match letter {
        'b' | 'i' | 'u' | 'f' | 'c' | 'S' | 'a' | 'V' | 'M' | 'm' => Some(length),
        'U' => length.checked_mul(4),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_precision_is_exact() {
        for (bits, expected) in [
            (0x3800, 0.5),
            (0xc000, -2.0),
            (0x7bff, 65504.0),
            (0x0001, f64::from_bits((1023 - 24) << 52)),
            (0x0400, f64::from_bits((1023 - 14) << 52)),
            (0x3555, 0.333_251_953_125),
        ] {
            assert_eq!(from_half(bits), expected, "{bits:x}");
        }
        assert!(from_half(0x7c00).is_infinite() && from_half(0x7e00).is_nan());
        assert!(from_half(0x8000).is_sign_negative());
    }

    #[test]
    fn lengths_of_other_types() {
        let known = [("|S10", 10), ("<U5", 20), ("|b1", 1), ("<c16", 16), ("<M8[ns]", 8), ("|V4", 4), ("<f16", 16)];
        for (kind, bytes) in known {
            assert_eq!(bytes_of(kind), Some(bytes), "{kind}");
        }
        assert_eq!((bytes_of("|O"), bytes_of("f8"), bytes_of("<U99999999999999999999")), (None, None, None));
    }
}
