//! Plots of experiments that a file has changed: a curve for each of their methods and inputs.

mod zeros;

use experiments::data::own_input;
use experiments::definition::{Experiment, Quantity};
use experiments::runner::Records;
use figures::axes::{Curve, Naming, Plot, Scale};
use figures::figure::{Figure, FigureError};
use figures::growth_plot::GrowthPlot;

use self::zeros::Placed;
use crate::report::DrawnFigure;

/// A plot for every quantity that an experiment records: what its fits look at, and all operations. Quantities that are
/// 0 in all runs have none, which the caption of the first plot says.
pub(super) fn of(experiment: &'static Experiment, records: &Records) -> Vec<DrawnFigure> {
    let mut quantities: Vec<Quantity> = vec![Quantity::AllCounts];
    for plan in experiment.fits {
        if !quantities.contains(&plan.quantity) {
            quantities.push(plan.quantity);
        }
    }
    let placed = |quantity| (quantity, Placed::of(plot(experiment, quantity).curves_of_every_input(records)));
    let (drawn, others): (Vec<_>, Vec<_>) =
        quantities.into_iter().map(placed).partition(|(_, placed)| !placed.curves.is_empty());
    let always_zero = others.iter().filter(|(_, placed)| !placed.left_out().is_empty());
    let mut without_plot: Vec<String> = always_zero.map(|(quantity, _)| quantity.to_string()).collect();
    let draw = |(quantity, placed): (Quantity, Placed)| {
        let mut caption = caption(&placed.curves) + &placed.left_out();
        if !without_plot.is_empty() {
            let names = std::mem::take(&mut without_plot).join(", ");
            caption.push_str(&format!(" Without a plot, as they are 0 in all runs: {names}."));
        }
        let figure = figure(experiment, quantity, caption);
        let plot = Plot {
            title: figure.title.into(),
            description: figure.caption.into(),
            x_name: "size n".into(),
            x_scale: Scale::Logarithmic,
            y_name: y_name(quantity),
            curves: placed.into_curves(),
            naming: Naming::Grouped,
        };
        let drawing = plot.draw().map_err(|error| error.to_string());
        DrawnFigure { figure: Box::leak(Box::new(figure)), drawing }
    };
    drawn.into_iter().map(draw).collect()
}

fn figure(experiment: &'static Experiment, quantity: Quantity, caption: String) -> Figure {
    let word: String = quantity
        .to_string()
        .chars()
        .filter_map(|c| if c == ' ' { Some('-') } else { c.is_alphanumeric().then_some(c) })
        .collect();
    Figure {
        id: format!("own-{}-{word}", experiment.id).leak(),
        title: format!("{}: {quantity}", experiment.title).leak(),
        caption: caption.leak(),
        claims: &[],
        experiments: Box::leak(Box::new([experiment.id])),
        deterministic: !matches!(quantity, Quantity::Time(_)),
        // The plot is drawn from its experiment; by its name alone it has no records.
        draw: |_| Err(FigureError::NoSeries),
    }
}

/// The name of the vertical axis: operations are counted together over all questions of an instance.
fn y_name(quantity: Quantity) -> String {
    match quantity {
        Quantity::AllCounts => "operations of an instance, of all its questions together".to_owned(),
        other => other.to_string(),
    }
}

/// The content of the curves, and no more.
fn caption(curves: &[Curve]) -> String {
    let has_law = |curve: &Curve| curve.notes.len() > 1;
    let mut text = "Every method of the experiment on every input that was run: the colour is the method's, the sign \
                    the input's."
        .to_owned();
    if curves.iter().any(|curve| curve.look.is_singled_out) {
        text.push_str(" Own files have large signs with a dark rim.");
    }
    if curves.iter().any(has_law) {
        text.push_str(
            " Where sizes are enough for it, the curve is the growth model that fits best, or a power law where none \
             does, and the legend has the exponent with its 95 % interval.",
        );
    }
    if curves.iter().any(|curve| !has_law(curve) && !curve.fit.is_empty()) {
        text.push_str(" Sizes that are too few for a law are joined at their medians.");
    }
    text
}

/// The plot of a quantity; own files come first, so that they have the plainest signs.
fn plot(experiment: &'static Experiment, quantity: Quantity) -> GrowthPlot {
    let inputs = || experiment.families.iter().chain(experiment.real_inputs);
    let (own, others): (Vec<_>, Vec<_>) = inputs().partition(|name| own_input(name).is_some());
    let inputs: Vec<(&'static str, Option<&'static str>)> = own.into_iter().chain(others).map(|&n| (n, None)).collect();
    GrowthPlot {
        experiment,
        quantity,
        families: inputs.leak(),
        shows: |_, _| true,
        x_name: "size n",
        y_name: y_name(quantity).leak(),
        y_unit: 1.0,
        compared_with: None,
    }
}
