//! Plots of an experiment's growth: samples from the records, the best of the growth models through them.

use crate::axes::{Curve, Look, Naming, Plot, SHAPE_COUNT, Scale, power};
use crate::figure::{Figure, FigureError, FigureInput};
use crate::style::{SERIES, find_method_color, method_color};
use experiments::analysis;
use experiments::data::own_input;
use experiments::definition::{Experiment, FitPlan, Quantity, Variant};
use experiments::fit::{self, Estimate, FitError, Growth, GrowthModel, ModelVerdict};
use experiments::runner::Records;

/// A plot of an experiment: one quantity, for chosen variants and families.
#[derive(Clone, Copy, Debug)]
pub struct GrowthPlot {
    /// The experiment.
    pub experiment: &'static Experiment,
    /// The quantity that is plotted.
    pub quantity: Quantity,
    /// The families, each with its name in the legend (none if it goes without saying).
    pub families: &'static [(&'static str, Option<&'static str>)],
    /// Whether a variant is shown on a family.
    pub shows: fn(variant: &str, family: &str) -> bool,
    /// The name of the horizontal axis.
    pub x_name: &'static str,
    /// The name of the vertical axis.
    pub y_name: &'static str,
    /// One unit of the vertical axis in units of the quantity.
    pub y_unit: f64,
    /// The variant that the legend compares the others with, at the largest size that both have.
    pub compared_with: Option<&'static str>,
}

/// Half of the last digit of the exponents in legends: intervals are taken as they are read there.
const SHOWN_PRECISION: f64 = 0.005;

/// The number of points on a fitted curve.
const CURVE_POINTS: i32 = 48;

impl GrowthPlot {
    /// Draws the plot of a figure.
    pub fn draw(&self, figure: &Figure, input: &FigureInput<'_>) -> Result<String, FigureError> {
        let no_records = FigureError::NoRecords(self.experiment.id);
        let Some(records) = input.records else { return Err(no_records) };
        let mut curves = Vec::new();
        for variant in self.experiment.variants {
            for &(family, family_name) in self.families {
                if !(self.shows)(variant.id, family) {
                    continue;
                }
                let look = self.look(variant, family, curves.len());
                curves.extend(self.curve(variant, (family, family_name), look, records));
            }
        }
        if curves.is_empty() {
            return Err(no_records);
        }
        let plot = Plot {
            title: figure.title.into(),
            description: figure.caption.into(),
            x_name: self.x_name.into(),
            x_scale: Scale::Logarithmic,
            y_name: self.y_name.into(),
            curves,
            naming: Naming::Apart,
        };
        plot.draw()
    }

    /// The curves of every method on every input that has samples, method by method: the colour is the method's, the
    /// sign the input's, and own inputs are singled out. The notes are the input's name and, where sizes are enough for
    /// a law, the exponent.
    pub fn curves_of_every_input(&self, records: &Records) -> Vec<Curve> {
        let mut curves = Vec::new();
        for (method, variant) in self.experiment.variants.iter().enumerate() {
            for (input, &(family, _)) in self.families.iter().enumerate() {
                let samples = analysis::samples(self.experiment.id, family, variant.id, self.quantity, records).0;
                if samples.is_empty() {
                    continue;
                }
                let mut curve = self.unnamed_curve(variant, &samples, look_on_input(variant, method, family, input));
                curve.notes.push(family.replace('_', " "));
                if let Ok(growth) = self.fit(variant, family, &samples) {
                    curve.notes.push(self.exponents(&growth));
                    curve.fit = self.law(&growth, None).1;
                }
                curves.push(curve);
            }
        }
        curves
    }

    /// The curve of a variant on a family, if it has samples.
    fn curve(
        &self,
        variant: &Variant,
        (family, family_name): (&str, Option<&str>),
        look: Look,
        records: &Records,
    ) -> Option<Curve> {
        let (samples, _left_out) = analysis::samples(self.experiment.id, family, variant.id, self.quantity, records);
        if samples.is_empty() {
            return None;
        }
        let mut curve = self.unnamed_curve(variant, &samples, look);
        curve.notes.extend(family_name.map(|name| format!("on {name}")));
        if let Ok(growth) = self.fit(variant, family, &samples) {
            let floor = self.floor_that_shows(variant, family, &growth);
            let (law, points) = self.law(&growth, floor);
            let sizes = format!("{} = {} to {}", self.letter(), size_name(growth.smallest), size_name(growth.largest));
            curve.notes.extend([law, self.exponents(&growth), sizes]);
            curve.fit = points;
        }
        if let Some(other) = self.compared_with.filter(|other| *other != variant.id) {
            let (others, _) = analysis::samples(self.experiment.id, family, other, self.quantity, records);
            let title = self.experiment.variants.iter().find(|v| v.id == other).map_or(other, |v| v.title);
            let name = title.split(':').next().unwrap_or(title).to_lowercase();
            let factor = factor_at_largest(&samples, &others);
            let letter = self.letter();
            curve.notes.extend(
                factor.map(|(n, factor)| format!("{} × {name} at {letter} = {}", three_digits(factor), size_name(n))),
            );
        }
        Some(curve)
    }

    /// A curve without notes and without a law: points of several sizes are joined by the medians of the sizes, so that
    /// their course is seen.
    fn unnamed_curve(&self, variant: &Variant, samples: &[(f64, f64)], look: Look) -> Curve {
        let in_units = |(n, y): (f64, f64)| [n, y / self.y_unit];
        let medians: Vec<[f64; 2]> =
            samples.chunk_by(|a, b| a.0 == b.0).map(|same| in_units((same[0].0, middle(same)))).collect();
        Curve {
            name: variant.title.to_owned(),
            notes: Vec::new(),
            points: samples.iter().copied().map(in_units).collect(),
            fit: if medians.len() > 1 { medians } else { Vec::new() },
            look,
        }
    }

    /// The look of a variant on a family, which is the curve of this number. The colour is the method's. Where each
    /// method is shown on each of several families, the sign's shape is the family's, and every second method has
    /// hollow signs; else every curve has a shape of its own.
    fn look(&self, variant: &Variant, family: &str, number: usize) -> Look {
        let shown = || self.experiment.variants.iter().filter(|other| self.shows_anywhere(other));
        let is_full = shown().all(|other| self.families.iter().all(|(family, _)| (self.shows)(other.id, family)));
        let color = method_color(variant.id);
        if !is_full || self.families.len() == 1 {
            return Look::new(color, number);
        }
        let place = |found: Option<usize>| found.unwrap_or_default();
        let shape = place(self.families.iter().position(|(other, _)| *other == family));
        let is_hollow = place(shown().position(|other| other.id == variant.id)) % 2 == 1;
        Look { is_hollow, ..Look::new(color, shape) }
    }

    fn shows_anywhere(&self, variant: &Variant) -> bool {
        self.families.iter().any(|(family, _)| (self.shows)(variant.id, family))
    }

    /// The law that the experiment looks for, if there is one.
    fn plan(&self, variant: &Variant, family: &str) -> Option<&'static FitPlan> {
        let is_shown = |plan: &&FitPlan| {
            plan.quantity == self.quantity && plan.variant == variant.id && plan.families.contains(&family)
        };
        self.experiment.fits.iter().find(is_shown)
    }

    /// The growth models of the experiment's fit, if it has one.
    fn models(&self, variant: &Variant, family: &str) -> &'static [GrowthModel] {
        self.plan(variant, family).map_or(GrowthModel::RUNNING_TIMES, |plan| plan.models)
    }

    /// The name of what the quantity cannot grow slower than, where the samples seem to: lower-order terms show.
    fn floor_that_shows(&self, variant: &Variant, family: &str, growth: &Growth) -> Option<String> {
        let floor = self.plan(variant, family)?.floor?;
        let fit = growth.model(floor)?;
        (fit.verdict == ModelVerdict::Below).then(|| self.model_name(floor))
    }

    /// The growth over the last doublings, if there are sizes enough.
    fn fit(&self, variant: &Variant, family: &str, samples: &[(f64, f64)]) -> Result<Growth, FitError> {
        fit::fit_growth(fit::last_doublings(samples), self.models(variant, family))
    }

    /// The best model if its exponent lies in the interval of the samples', else the power law, which is the middle of
    /// that interval; in words and as points of its curve. A model that the interval excludes is named as a bound or
    /// as a neighbour alone, and where the interval lies on both sides of the slack the law is undecided. A quantity
    /// that has to read its input is not said to lie below it.
    fn law(&self, growth: &Growth, floor: Option<String>) -> (String, Vec<[f64; 2]>) {
        let is_open = |verdict| !matches!(verdict, ModelVerdict::Above | ModelVerdict::Below);
        let near = growth.best().filter(|best| is_open(best.verdict));
        let is_inside = |Estimate { low, high, .. }| (low - SHOWN_PRECISION..=high + SHOWN_PRECISION).contains(&0.0);
        let within = near.filter(|best| is_inside(best.excess_exponent));
        let exponent = growth.exponent;
        let value = |n: f64| match within {
            Some(best) => best.constant * best.model.value(n),
            None => growth.constant * libm::pow(n, exponent.value),
        };
        let range = growth.largest / growth.smallest;
        let points = (0..=CURVE_POINTS).map(|step| {
            let n = growth.smallest * libm::pow(range, f64::from(step) / f64::from(CURVE_POINTS));
            [n, value(n) / self.y_unit]
        });
        let law = match within {
            Some(best) if best.model == GrowthModel::Constant => three_digits(best.constant / self.y_unit),
            Some(best) => format!("{} {}", three_digits(best.constant / self.y_unit), self.model_name(best.model)),
            None => {
                let place = near.map(|near| match near.verdict {
                    ModelVerdict::Within if near.excess_exponent.high < 0.0 => {
                        format!("at most {}", self.model_name(near.model))
                    }
                    ModelVerdict::Within => format!("within the slack of {}", self.model_name(near.model)),
                    _ => "undecided".to_owned(),
                });
                let among = || place_among_models(growth, |model| self.model_name(model));
                let floor = floor.map(|floor| format!("{floor} and lower-order terms"));
                format!("power law, {}", floor.or(place).unwrap_or_else(among))
            }
        };
        (law, points.collect())
    }

    /// The exponent with its interval.
    fn exponents(&self, growth: &Growth) -> String {
        let Estimate { value, low, high } = growth.exponent;
        let [value, low, high] = [value, low, high].map(signed);
        format!("exponent {value} ({low} to {high})")
    }

    fn letter(&self) -> &'static str {
        size_letter(self.x_name)
    }

    fn model_name(&self, model: GrowthModel) -> String {
        model_name(model).replace('n', self.letter())
    }
}

/// The letter that the name of an axis gives to the size: the last one, since an article comes before its noun.
fn size_letter(axis_name: &str) -> &str {
    let is_letter = |word: &&str| word.len() == 1 && word.chars().all(char::is_alphabetic);
    axis_name.split(' ').rfind(is_letter).unwrap_or("n")
}

/// The largest size at which both have samples, and the ratio of their medians there.
fn factor_at_largest(samples: &[(f64, f64)], others: &[(f64, f64)]) -> Option<(f64, f64)> {
    let is_common = |n: &f64| others.iter().any(|(other, _)| other == n);
    let n = samples.iter().map(|(n, _)| *n).filter(is_common).max_by(f64::total_cmp)?;
    let at_largest = |of: &[(f64, f64)]| {
        let values: Vec<(f64, f64)> = of.iter().copied().filter(|(size, _)| *size == n).collect();
        median(&values)
    };
    Some((n, at_largest(samples) / at_largest(others)))
}

/// The values of some samples, the least first.
fn sorted_values(samples: &[(f64, f64)]) -> Vec<f64> {
    let mut values: Vec<f64> = samples.iter().map(|(_, y)| *y).collect();
    values.sort_by(f64::total_cmp);
    values
}

/// The upper median of the values of some samples, at least one.
fn median(samples: &[(f64, f64)]) -> f64 {
    sorted_values(samples)[samples.len() / 2]
}

/// The mean of both medians of the values of some samples, at least one.
fn middle(samples: &[(f64, f64)]) -> f64 {
    let values = sorted_values(samples);
    values[(values.len() - 1) / 2] / 2.0 + values[values.len() / 2] / 2.0
}

/// The look of the method of this number on the input of this number. Methods that have no colour of their own have
/// those of series, then the same with hollow signs; so have inputs when their shapes run out.
fn look_on_input(variant: &Variant, method: usize, family: &str, input: usize) -> Look {
    let color = find_method_color(variant.id);
    let turns = input / SHAPE_COUNT + if color.is_some() { 0 } else { method / SERIES.len() };
    Look {
        is_hollow: turns % 2 == 1,
        is_singled_out: own_input(family).is_some(),
        ..Look::new(color.unwrap_or(SERIES[method % SERIES.len()]), input % SHAPE_COUNT)
    }
}

/// Between which models the growth lies, when it is within none.
fn place_among_models(growth: &Growth, name: impl Fn(GrowthModel) -> String) -> String {
    let of = |verdict| growth.models.iter().filter(move |fit| fit.verdict == verdict).map(|fit| name(fit.model));
    match (of(ModelVerdict::Above).next_back(), of(ModelVerdict::Below).next()) {
        (None, Some(above)) => format!("below {above}"),
        (Some(below), None) => format!("above {below}"),
        (Some(below), Some(above)) => format!("between {below} and {above}"),
        (None, None) => "no model fits".into(),
    }
}

/// The name of a size: a power of two if it is one.
fn size_name(size: f64) -> String {
    let exponent = libm::round(libm::log2(size)) as i32;
    if libm::exp2(f64::from(exponent)) == size { power(2, exponent) } else { size.to_string() }
}

/// A number of two decimals with a minus sign.
pub(crate) fn signed(value: f64) -> String {
    format!("{value:.2}").replace('-', "−")
}

fn model_name(model: GrowthModel) -> String {
    model
        .to_string()
        .replace('-', "−")
        .replace("n^(1/2)", "√n")
        .replace("n^(3/2)", "n √n")
        .replace("^2", "²")
        .replace("^3", "³")
}

/// A value with three significant digits, and with a power of ten where that is shorter.
fn three_digits(value: f64) -> String {
    let magnitude = libm::floor(libm::log10(value.abs())) as i32;
    match magnitude {
        -2..=2 => format!("{value:.*}", (2 - magnitude).unsigned_abs() as usize),
        3..=5 => format!("{value:.0}"),
        _ => {
            let mantissa = value / libm::exp10(f64::from(magnitude));
            format!("{mantissa:.2} × {}", power(10, magnitude))
        }
    }
}

#[cfg(test)]
mod tests;
