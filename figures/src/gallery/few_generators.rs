//! The ratio of the shortest zonotope around a mesh against its number of generators.

use crate::axes::{Curve, Look, Naming, Plot, Scale};
use crate::figure::{Figure, FigureError, FigureInput};
use crate::style::SERIES;
use experiments::analysis;
use experiments::definition::Quantity;
use experiments::definitions::few_generators::{EXPERIMENT, MESHES, most_generators};
use experiments::fit::{Growth, fit_growth, in_decimals};

/// The ratios.
pub const FIGURE: Figure = Figure {
    id: "few-generators",
    title: "Length of a zonotope around a mesh against its number of generators",
    caption: "By how much the shortest zonotope that is found around each mesh with at most K generators is longer, \
              relatively, than a proven lower bound for zonotopes of any number of generators, with the power law that \
              fits best and its exponent with the 95 % interval. The bound may be 0.1 % below the least length, so \
              that values near 0.001 say little.",
    claims: &["question-generator-count"],
    experiments: &[EXPERIMENT.id],
    deterministic: true,
    draw,
};

fn draw(input: &FigureInput<'_>) -> Result<String, FigureError> {
    let records = input.records.ok_or(FigureError::NoRecords(EXPERIMENT.id))?;
    let mut curves = Vec::new();
    for (series, mesh) in MESHES.into_iter().enumerate() {
        let excess = |variant: &str| {
            let (samples, _) = analysis::samples(EXPERIMENT.id, mesh, variant, Quantity::Value("excess"), records);
            samples.first().map(|(_, excess)| *excess).filter(|excess| *excess > 0.0)
        };
        let mut samples: Vec<(f64, f64)> = EXPERIMENT
            .variants
            .iter()
            .filter_map(|variant| Some((most_generators(variant.id)? as f64, excess(variant.id)?)))
            .collect();
        samples.sort_by(|a, b| a.0.total_cmp(&b.0));
        if samples.is_empty() {
            continue;
        }
        let mut curve = Curve {
            name: mesh.rsplit('_').next().unwrap_or(mesh).to_owned(),
            notes: Vec::new(),
            points: samples.iter().map(|&(most, excess)| [most, excess]).collect(),
            fit: Vec::new(),
            look: Look::new(SERIES[series % SERIES.len()], series),
        };
        if let Ok(growth) = fit_growth(&samples, &[]) {
            add_fit(&mut curve, &growth);
        }
        curves.push(curve);
    }
    if curves.is_empty() {
        return Err(FigureError::NoRecords(EXPERIMENT.id));
    }
    let plot = Plot {
        title: FIGURE.title.into(),
        description: FIGURE.caption.into(),
        x_name: "generators K".into(),
        x_scale: Scale::Logarithmic,
        y_name: "proven ratio − 1".into(),
        curves,
        naming: Naming::Apart,
    };
    plot.draw()
}

fn add_fit(curve: &mut Curve, growth: &Growth) {
    let exponent = growth.exponent;
    let at = |most: f64| [most, growth.constant * libm::pow(most, exponent.value)];
    curve.fit = vec![at(growth.smallest), at(growth.largest)];
    let numbers = [exponent.value, exponent.low, exponent.high].map(|number| in_decimals(number, 2).replace('-', "−"));
    curve.notes.push(format!("exponent {} ({} to {})", numbers[0], numbers[1], numbers[2]));
    curve.notes.push(format!("K = {} to {}", growth.smallest, growth.largest));
}
