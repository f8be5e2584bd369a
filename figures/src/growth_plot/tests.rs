//! The words and numbers of a growth plot.

use super::*;

#[test]
fn numbers_have_three_digits() {
    assert_eq!(three_digits(4.3219), "4.32");
    assert_eq!(three_digits(0.0271), "0.0271");
    assert_eq!(three_digits(271.8), "272");
    assert_eq!(three_digits(4.2e-9), "4.20 × 10⁻⁹");
}

#[test]
fn the_letter_of_the_size_is_no_article_and_no_sign() {
    for (axis, letter) in [("frames a turn n", "n"), ("directions k", "k"), ("n = 1 / ε", "n"), ("rounds", "n")] {
        assert_eq!(size_letter(axis), letter, "{axis}");
    }
}

#[test]
fn sizes_that_are_powers_of_two_are_written_so() {
    assert_eq!(size_name(131072.0), "2¹⁷");
    assert_eq!(size_name(1000.0), "1000");
}

#[test]
fn growth_is_placed_among_the_models() {
    let growth = |y: fn(f64) -> f64| {
        let samples: Vec<(f64, f64)> = (6..16).map(|k| libm::exp2(f64::from(k))).map(|n| (n, y(n))).collect();
        fit::fit_growth(&samples, GrowthModel::RUNNING_TIMES).expect("ten sizes")
    };
    assert_eq!(place_among_models(&growth(f64::sqrt), model_name), "below n");
    assert_eq!(place_among_models(&growth(|n| n * n * n), model_name), "above n²");
}

#[test]
fn factors_are_those_of_the_largest_common_size() {
    let slow = [(1.0, 9.0), (2.0, 40.0), (2.0, 10.0), (2.0, 30.0)];
    let fast = [(2.0, 3.0), (1.0, 1.0), (4.0, 5.0)];
    assert_eq!(factor_at_largest(&slow, &fast), Some((2.0, 10.0)));
    assert_eq!(factor_at_largest(&slow, &[]), None);
}

/// One look for each method and input, however many there are, and the methods' own colours where they have any.
#[test]
fn every_method_on_every_input_has_a_look_of_its_own() {
    for experiment in experiments::catalog::EXPERIMENTS {
        let mut looks = Vec::new();
        for (method, variant) in experiment.variants.iter().enumerate() {
            for input in 0..SHAPE_COUNT {
                let look = look_on_input(variant, method, "circle", input);
                assert!(!looks.contains(&look), "{}: {} on input {input}", experiment.id, variant.id);
                assert!(find_method_color(variant.id).is_none_or(|color| color == look.color));
                looks.push(look);
            }
        }
    }
}

#[test]
fn points_without_a_law_are_joined_at_the_middle_of_each_size_and_one_size_has_no_line() {
    let experiment = experiments::catalog::find("hull-scaling").expect("it is in the catalog");
    let plot = GrowthPlot {
        experiment,
        quantity: Quantity::AllCounts,
        families: &[("disc", None)],
        shows: |_, _| true,
        x_name: "n",
        y_name: "operations",
        y_unit: 2.0,
        compared_with: None,
    };
    let curve = |samples: &[(f64, f64)]| plot.unnamed_curve(&experiment.variants[0], samples, Look::of_series(0));
    assert_eq!(curve(&[(8.0, 2.0), (8.0, 6.0), (16.0, 8.0)]).fit, [[8.0, 2.0], [16.0, 4.0]]);
    let single = curve(&[(8.0, 2.0), (8.0, 6.0)]);
    assert_eq!((single.points.len(), single.fit.len()), (2, 0));
}

#[test]
fn a_law_that_the_interval_excludes_is_named_as_a_bound_alone() {
    let experiment = experiments::catalog::find("hull-scaling").expect("it is in the catalog");
    let plot = GrowthPlot {
        experiment,
        quantity: Quantity::AllCounts,
        families: &[("disc", None)],
        shows: |_, _| true,
        x_name: "n",
        y_name: "operations",
        y_unit: 1.0,
        compared_with: None,
    };
    let law = |exponent: f64, spread: f64| {
        let value = |k: i32| libm::exp2(exponent * f64::from(k)) * (1.0 + spread * f64::from(k % 2));
        let samples: Vec<(f64, f64)> = (6..16).map(|k| (libm::exp2(f64::from(k)), value(k))).collect();
        plot.law(&fit::fit_growth(&samples, GrowthModel::RUNNING_TIMES).expect("ten sizes"), None).0
    };
    assert_eq!(law(1.0, 0.0), "1.00 n");
    assert_eq!(law(0.98, 0.0), "power law, at most n");
    assert_eq!(law(1.02, 0.0), "power law, within the slack of n");
    assert_eq!(law(0.5, 0.0), "power law, below n");
    assert!(law(1.0, 0.01).ends_with(" n"), "the interval has the law in it");
    assert_eq!(law(1.05, 0.12), "power law, undecided");
}

#[test]
fn models_are_written_with_raised_digits() {
    assert_eq!(model_name(GrowthModel::LinearLogSquared), "n log² n");
}
