//! Plots of experiments that a file has changed: a curve for each of their methods and inputs.

use experiments::definition::{Experiment, Quantity};
use experiments::runner::Records;
use figures::figure::{Figure, FigureError, FigureInput};
use figures::growth_plot::GrowthPlot;

use crate::report::DrawnFigure;

/// A plot for every quantity that an experiment records at positive numbers: what its fits look at, and all operations.
pub(super) fn of(experiment: &'static Experiment, records: &Records) -> Vec<DrawnFigure> {
    let mut quantities: Vec<Quantity> = vec![Quantity::AllCounts];
    quantities.extend(experiment.fits.iter().map(|plan| plan.quantity));
    quantities.dedup();
    let mut plots: Vec<DrawnFigure> = Vec::new();
    for quantity in quantities {
        let figure = figure(experiment, quantity);
        if plots.iter().any(|plot| plot.figure.id == figure.id) {
            continue;
        }
        // What is zero or was not recorded has no place on logarithmic axes.
        if let Ok(svg) = plot(experiment, quantity).draw(&figure, &FigureInput { records: Some(records) }) {
            plots.push(DrawnFigure { figure: Box::leak(Box::new(figure)), drawing: Ok(svg) });
        }
    }
    plots
}

fn figure(experiment: &'static Experiment, quantity: Quantity) -> Figure {
    let word: String = quantity
        .to_string()
        .chars()
        .filter_map(|c| if c == ' ' { Some('-') } else { c.is_alphanumeric().then_some(c) })
        .collect();
    Figure {
        id: format!("own-{}-{word}", experiment.id).leak(),
        title: format!("{}: {quantity}", experiment.title).leak(),
        caption: "Every method of the experiment on every input that was run, with the growth model that fits best (a \
                  power law where none does) and the exponent with its 95 % interval, where sizes are enough for it.",
        claims: &[],
        experiments: Box::leak(Box::new([experiment.id])),
        deterministic: !matches!(quantity, Quantity::Time(_)),
        // The plot is drawn from its experiment; by its name alone it has no records.
        draw: |_| Err(FigureError::NoSeries),
    }
}

fn plot(experiment: &'static Experiment, quantity: Quantity) -> GrowthPlot {
    let inputs = experiment.families.iter().chain(experiment.real_inputs);
    let inputs: Vec<(&'static str, Option<&'static str>)> = inputs.map(|&name| (name, Some(name))).collect();
    GrowthPlot {
        experiment,
        quantity,
        families: inputs.leak(),
        shows: |_, _| true,
        x_name: "size n",
        y_name: quantity.to_string().leak(),
        y_unit: 1.0,
        compared_with: None,
    }
}
