use super::*;
use crate::families::source::RandomSource;

/// Sizes 2^6 .. 2^18, three samples each, of `growth` times a log-normal factor.
fn synthetic(growth: impl Fn(f64) -> f64, noise: f64) -> Vec<(f64, f64)> {
    let mut source = RandomSource::new(11);
    (6..=18)
        .flat_map(|log| [f64::from(1 << log); 3])
        .map(|n| (n, growth(n) * libm::exp(noise * source.normal_pair()[0])))
        .collect()
}

#[test]
fn a_regression_worked_out_by_hand() {
    // y = e^0, e^1, e^1, e^2 at n = e^1 .. e^4: slope 0.6, intercept -0.5, residuals -0.1, 0.3, -0.3, 0.1, RSS 0.2,
    // standard error sqrt(0.2 / 2 / 5) = 0.141421, t(2) = 4.3027.
    let samples: Vec<(f64, f64)> =
        [(1.0, 0.0), (2.0, 1.0), (3.0, 1.0), (4.0, 2.0)].map(|(x, y)| (libm::exp(x), libm::exp(y))).to_vec();
    let growth = fit_growth(&samples, &[]).expect("four sizes");
    assert!((growth.exponent.value - 0.6).abs() < 1e-12);
    assert!((growth.exponent.high - (0.6 + 4.3027 * 0.02_f64.sqrt())).abs() < 1e-12);
    assert!((growth.residual_squares - 0.2).abs() < 1e-12);
    assert!((growth.constant - libm::exp(-0.5)).abs() < 1e-12);
}

#[test]
fn each_model_is_recognised_and_its_neighbours_are_refused() {
    for noise in [0.0, 0.03] {
        for &truth in GrowthModel::ALL {
            let samples = synthetic(|n| 5.0 * truth.value(n), noise);
            let growth = fit_growth(&samples, GrowthModel::ALL).expect("enough samples");
            assert_eq!(growth.best().expect("models").model, truth);
            for fit in &growth.models {
                let expected = match fit.model.cmp(&truth) {
                    std::cmp::Ordering::Equal => ModelVerdict::Within,
                    std::cmp::Ordering::Less => ModelVerdict::Above,
                    std::cmp::Ordering::Greater => ModelVerdict::Below,
                };
                assert_eq!(fit.verdict, expected, "{} against {truth}, noise {noise}", fit.model);
            }
        }
    }
}

#[test]
fn a_small_lower_order_term_is_within_the_slack() {
    let samples = synthetic(|n| 3.0 * n + 5.0 * libm::log2(n), 0.0);
    let growth = fit_growth(&samples, GrowthModel::ALL).expect("enough samples");
    let linear = growth.model(GrowthModel::Linear).expect("asked for");
    assert_eq!(linear.verdict, ModelVerdict::Within);
    assert!(growth.model(GrowthModel::Linearithmic).expect("asked for").verdict == ModelVerdict::Below);
}

#[test]
fn the_interval_covers_the_true_exponent_about_nineteen_times_in_twenty() {
    let mut source = RandomSource::new(5);
    let trials = 2000;
    let covered = (0..trials)
        .filter(|_| {
            let samples: Vec<(f64, f64)> = (6..=14)
                .map(|log| f64::from(1 << log))
                .map(|n| (n, n * n.sqrt() * libm::exp(0.2 * source.normal_pair()[0])))
                .collect();
            let exponent = fit_growth(&samples, &[]).expect("enough samples").exponent;
            exponent.low <= 1.5 && 1.5 <= exponent.high
        })
        .count();
    // Standard deviation of the count: sqrt(2000 * 0.05 * 0.95) = 9.7; four of them.
    assert!(covered.abs_diff(1900) < 40, "{covered} of {trials}");
}

#[test]
fn quantiles_agree_with_tables_beyond_the_table() {
    for (freedom, quantile) in [(1, 12.7062), (30, 2.0423), (31, 2.0395), (40, 2.0211), (60, 2.0003), (120, 1.9799)] {
        assert!((t_quantile_975(freedom) - quantile).abs() < 1e-4, "{freedom}");
    }
}

#[test]
fn the_last_doublings_see_past_a_lower_order_term() {
    // n + n^(2/3) is n times 1.25 at 2^6, 1.04 at 2^14 and 1.02 at 2^18.
    let samples = synthetic(|n| n + libm::cbrt(n * n), 0.0);
    let last = last_doublings(&samples);
    assert_eq!((last.len(), last[0].0), (5 * 3, f64::from(1 << 14)));
    let excess = |samples| {
        let growth = fit_growth(samples, &[GrowthModel::Linear]).expect("enough samples");
        growth.models[0].excess_exponent.value
    };
    assert!(excess(&samples) < 2.0 * excess(last) && excess(last) < 0.0);
    assert!(last_doublings(&[]).is_empty());
}

#[test]
fn unusable_samples_are_refused() {
    assert_eq!(
        fit_growth(&[(4.0, 1.0), (4.0, 2.0), (8.0, 2.0), (8.0, 3.0)], &[]),
        Err(FitError::TooFew { samples: 4, sizes: 2 })
    );
    assert_eq!(fit_growth(&[], &[]), Err(FitError::TooFew { samples: 0, sizes: 0 }));
    let zero = [(4.0, 1.0), (8.0, 0.0), (16.0, 2.0), (32.0, 3.0)];
    assert_eq!(fit_growth(&zero, &[]), Err(FitError::OutOfRange { index: 1, n: 8.0, y: 0.0 }));
}

#[test]
fn what_rounds_to_zero_has_no_sign() {
    assert_eq!(in_decimals(-0.004, 2), "0.00");
    assert_eq!(in_decimals(-0.0, 0), "0");
    assert_eq!(in_decimals(-0.006, 2), "-0.01");
    assert_eq!(in_decimals(1.25, 1), "1.2");
}
