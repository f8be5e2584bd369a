//! Quantiles of Student's t distribution for two-sided 95 % intervals.

/// The 0.975 quantile for 1 .. 30 degrees of freedom, to four decimals (any table).
const TABLE: [f64; 30] = [
    12.7062, 4.3027, 3.1824, 2.7764, 2.5706, 2.4469, 2.3646, 2.3060, 2.2622, 2.2281, 2.2010, 2.1788, 2.1604, 2.1448,
    2.1314, 2.1199, 2.1098, 2.1009, 2.0930, 2.0860, 2.0796, 2.0739, 2.0687, 2.0639, 2.0595, 2.0555, 2.0518, 2.0484,
    2.0452, 2.0423,
];

/// The 0.975 quantile of the standard normal distribution.
const NORMAL: f64 = 1.959_963_985;

/// The 0.975 quantile of Student's t with `freedom` >= 1 degrees of freedom, to four decimals.
///
/// Above 30 it is the expansion in 1 / freedom around the normal quantile (Abramowitz and Stegun 26.7.5), three terms.
pub fn t_quantile_975(freedom: usize) -> f64 {
    if let Some(&quantile) = freedom.checked_sub(1).and_then(|row| TABLE.get(row)) {
        return quantile;
    }
    let (z, v) = (NORMAL, freedom as f64);
    let z2 = z * z;
    let first = z * (z2 + 1.0) / 4.0;
    let second = z * ((5.0 * z2 + 16.0) * z2 + 3.0) / 96.0;
    let third = z * (((3.0 * z2 + 19.0) * z2 + 17.0) * z2 - 15.0) / 384.0;
    z + first / v + second / (v * v) + third / (v * v * v)
}
