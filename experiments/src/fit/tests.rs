use super::*;
use families::source::RandomSource;

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

fn estimate(low: f64, high: f64) -> Estimate {
    Estimate { value: (low + high) / 2.0, low, high }
}

#[test]
fn an_interval_that_reaches_beyond_the_slack_is_undecided() {
    for (low, high) in [(-1.9, 1.5), (-0.04, 0.051), (0.05, 0.2), (-0.3, 0.2)] {
        assert_eq!(ModelVerdict::of(estimate(low, high)), ModelVerdict::Undecided, "[{low}, {high}]");
    }
    for (low, high) in [(-0.01, 0.01), (-1.9, 0.05), (0.03, 0.05), (-0.2, -0.05)] {
        assert_eq!(ModelVerdict::of(estimate(low, high)), ModelVerdict::Within, "[{low}, {high}]");
    }
    assert_eq!(ModelVerdict::of(estimate(-1.9, -0.06)), ModelVerdict::Below);
    assert_eq!(ModelVerdict::of(estimate(0.06, 1.9)), ModelVerdict::Above);
    let keeps = [Some(true), Some(true), Some(true), Some(false), None];
    assert_eq!(ModelVerdict::ALL.map(ModelVerdict::keeps_bound), keeps);
}

#[test]
fn few_noisy_samples_of_the_bound_itself_decide_nothing() {
    let samples = [(1024.0, 1900.0), (2048.0, 1100.0), (4096.0, 9000.0), (8192.0, 6000.0), (16384.0, 31000.0)];
    let growth = fit_growth(&samples, &[GrowthModel::Linear]).expect("five sizes");
    assert_eq!(growth.models[0].verdict, ModelVerdict::Undecided, "{:?}", growth.models[0].excess_exponent);
}

/// Twice the same number at every size is one sample a size: the interval is that of the sizes alone.
#[test]
fn equal_instances_of_a_size_are_one_sample() {
    let once: Vec<(f64, f64)> = [(64.0, 70.0), (128.0, 150.0), (256.0, 260.0), (512.0, 560.0)].to_vec();
    let thrice: Vec<(f64, f64)> = once.iter().flat_map(|&sample| [sample; 3]).collect();
    let [once, thrice] = [once, thrice].map(|samples| fit_growth(&samples, GrowthModel::ALL).expect("four sizes"));
    assert_eq!((once.samples, once.independent), (4, 4));
    assert_eq!((thrice.samples, thrice.independent), (12, 4));
    let near = |a: f64, b: f64| (a - b).abs() < 1e-12;
    let intervals = [once.exponent, thrice.exponent];
    assert!(near(intervals[0].low, intervals[1].low) && near(intervals[0].high, intervals[1].high), "{intervals:?}");
    for (a, b) in once.models.iter().zip(&thrice.models) {
        assert!(near(a.excess_exponent.high, b.excess_exponent.high) && near(a.aicc, b.aicc), "{}", a.model);
    }
    assert_eq!(thrice.lack_of_fit, LackOfFit::NoReplicates);
    let short = [(64.0, 1.0), (64.0, 1.0), (128.0, 2.0), (128.0, 2.0), (256.0, 3.0), (256.0, 3.0)];
    assert_eq!(fit_growth(&short, &[]), Err(FitError::TooFew { samples: 3, sizes: 3 }));
}

/// Two instances of a size that are equal are two draws where others differ: chance made them so.
#[test]
fn equal_draws_among_different_ones_count_each() {
    let samples: Vec<(f64, f64)> = [64.0, 128.0, 256.0, 512.0]
        .into_iter()
        .flat_map(|n| [(n, 1.0), (n, 1.0), (n, 2.0)])
        .chain([(1024.0, 1.0); 3])
        .collect();
    assert_eq!(fit_growth(&samples, &[]).expect("five sizes").independent, 4 * 3 + 1);
}

/// y = 1, 3 at x = 0; 4, 6 at x = 1; 3, 5 at x = 2: means 2, 5, 4 and slope 1, so the line is 8/3 + x; squares of the
/// means around it 2 (4/9 + 16/9 + 4/9) = 16/3 with one degree of freedom, of the samples around the means 6 with
/// three: F = 8/3, whose upper tail is 0.2010.
#[test]
fn a_lack_of_fit_worked_out_by_hand() {
    let samples: Vec<(f64, f64)> = [(1.0, 1.0), (1.0, 3.0), (2.0, 4.0), (2.0, 6.0), (3.0, 3.0), (3.0, 5.0)]
        .map(|(x, y)| (libm::exp(x), libm::exp(y)))
        .to_vec();
    let growth = fit_growth(&samples, &[]).expect("three sizes");
    let LackOfFit::Tested { ratio, freedom, probability } = growth.lack_of_fit else { panic!("there are replicates") };
    assert_eq!(freedom, [1, 3]);
    assert!((ratio - 8.0 / 3.0).abs() < 1e-12, "{ratio}");
    assert!((probability - 0.2010).abs() < 1e-4, "{probability}");
    assert!((growth.residual_squares - (16.0 / 3.0 + 6.0)).abs() < 1e-12);
    assert!((growth.exponent.value - 1.0).abs() < 1e-12);
}

/// A curve with little noise bends away from every power; then the means of the sizes are what is independent.
#[test]
fn a_bend_is_found_and_widens_the_interval() {
    let curve = synthetic(|n| n + 40.0 * n.sqrt(), 0.003);
    let growth = fit_growth(&curve, &[GrowthModel::Linear]).expect("enough samples");
    assert!(growth.lack_of_fit.is_detected(), "{:?}", growth.lack_of_fit);
    let means: Vec<(f64, f64)> = curve
        .chunk_by(|a, b| a.0 == b.0)
        .map(|group| (group[0].0, libm::exp(group.iter().map(|s| libm::log(s.1)).sum::<f64>() / group.len() as f64)))
        .collect();
    let of_means = fit_growth(&means, &[]).expect("thirteen sizes").exponent;
    assert!((growth.exponent.high - of_means.high).abs() < 1e-9 && (growth.exponent.low - of_means.low).abs() < 1e-9);

    let straight = synthetic(|n| 3.0 * n, 0.1);
    assert!(!fit_growth(&straight, &[]).expect("enough samples").lack_of_fit.is_detected());
}

/// Of laws that do not bend the test finds one in twenty to bend.
#[test]
fn the_test_of_the_bend_errs_about_once_in_twenty() {
    let mut source = RandomSource::new(8);
    let trials = 2000;
    let found = (0..trials)
        .filter(|_| {
            let samples: Vec<(f64, f64)> = (6..=10)
                .flat_map(|log| [f64::from(1 << log); 3])
                .map(|n| (n, n * libm::exp(0.2 * source.normal_pair()[0])))
                .collect();
            fit_growth(&samples, &[]).expect("enough samples").lack_of_fit.is_detected()
        })
        .count();
    // Standard deviation of the count: sqrt(2000 * 0.05 * 0.95) = 9.7; four of them.
    assert!(found.abs_diff(100) < 40, "{found} of {trials}");
}

/// Quantiles of any table of the F distribution.
#[test]
fn upper_tails_agree_with_tables() {
    for (ratio, freedom, probability) in [
        (10.128, [1, 3], 0.05),
        (3.7083, [3, 10], 0.05),
        (6.5523, [3, 10], 0.01),
        (2.7581, [3, 40], 0.0548),
        (161.45, [1, 1], 0.05),
        (1.0, [7, 7], 0.5),
        (0.0, [3, 10], 1.0),
    ] {
        let found = f_upper_tail(ratio, freedom);
        assert!((found - probability).abs() < 1e-4, "{ratio} {freedom:?}: {found}");
    }
    assert!(f_upper_tail(1e9, [3, 10]) < 1e-20 && f_upper_tail(1e-9, [3, 10]) > 0.999);
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
