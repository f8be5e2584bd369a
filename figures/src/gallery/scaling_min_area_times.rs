//! Time of the whole of section 4.1 against the number of points.

use crate::figure::{Figure, FigureError, FigureInput};
use crate::growth_plot::GrowthPlot;
use experiments::definition::Quantity;
use experiments::definitions::min_area_scaling;

/// Times of the whole of section 4.1.
pub const FIGURE: Figure = Figure {
    id: "scaling-min-area-times",
    title: "Time of the minimum-area enclosing zonogon",
    caption: "Time of the whole of section 4.1, hull included, with each method of the kernel on random convex \
              polygons and with pruning on Gaussian points: medians of several runs on this machine, with the growth \
              model that fits best (a power law where none does) and the exponent with its 95 % interval.",
    claims: &["theorem-4.5", "summary-min-area"],
    experiments: &[min_area_scaling::EXPERIMENT.id],
    deterministic: false,
    draw,
};

const PLOT: GrowthPlot = GrowthPlot {
    experiment: &min_area_scaling::EXPERIMENT,
    quantity: Quantity::Time("total"),
    families: &[("random_convex", Some("random convex polygons")), ("gaussian", Some("Gaussian points"))],
    shows: |variant, family| family == "random_convex" || variant == "by_pruning",
    x_name: "points n",
    y_name: "time (s)",
    y_unit: 1e9,
    compared_with: None,
};

fn draw(input: &FigureInput<'_>) -> Result<String, FigureError> {
    PLOT.draw(&FIGURE, input)
}
