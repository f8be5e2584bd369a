//! The upper tail of the F distribution.

/// Terms of the continued fraction: a few dozen are enough for any degrees of freedom that occur.
const MOST_TERMS: u32 = 500;

/// The probability that a variable with the F distribution with these degrees of freedom, both at least 1, is at least
/// `ratio`.
///
/// It is the regularised incomplete beta function I_x(b, a) with a and b half the degrees of freedom and
/// x = 2b / (2b + 2a · ratio), by its continued fraction (Abramowitz and Stegun 26.5.8 and 26.6.2).
pub fn f_upper_tail(ratio: f64, [between, within]: [usize; 2]) -> f64 {
    let (a, b) = (between as f64 / 2.0, within as f64 / 2.0);
    if ratio <= 0.0 {
        return 1.0;
    }
    let x = b / (b + a * ratio);
    if x < (b + 1.0) / (a + b + 2.0) { beta_part(x, b, a) } else { 1.0 - beta_part(1.0 - x, a, b) }
}

/// I_x(a, b) for x below its mean, where the fraction converges quickly.
fn beta_part(x: f64, a: f64, b: f64) -> f64 {
    if x <= 0.0 {
        return 0.0;
    }
    let ln_front = libm::lgamma(a + b) - libm::lgamma(a) - libm::lgamma(b) + a * libm::log(x) + b * libm::log1p(-x);
    libm::exp(ln_front) / (a * fraction(x, a, b))
}

/// 1 + d_1 / (1 + d_2 / (1 + …)), evaluated from the front.
fn fraction(x: f64, a: f64, b: f64) -> f64 {
    let away_from_zero = |value: f64| if value.abs() < f64::MIN_POSITIVE { f64::MIN_POSITIVE } else { value };
    let (mut value, mut numerator, mut denominator) = (1.0, 1.0, 0.0);
    for term in 1..=MOST_TERMS {
        let m = f64::from(term / 2);
        let d = if term % 2 == 0 {
            m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m))
        } else {
            -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0))
        };
        denominator = 1.0 / away_from_zero(1.0 + d * denominator);
        numerator = away_from_zero(1.0 + d / numerator);
        let factor = numerator * denominator;
        value *= factor;
        if (factor - 1.0).abs() < 1e-15 {
            break;
        }
    }
    value
}
