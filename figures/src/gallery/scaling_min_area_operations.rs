//! Operations of the whole of section 4.1 against the number of points.

use crate::figure::{Figure, FigureError, FigureInput};
use crate::growth_plot::GrowthPlot;
use experiments::definition::Quantity;
use experiments::definitions::min_area_scaling;

/// Operations of the whole of section 4.1.
pub const FIGURE: Figure = Figure {
    id: "scaling-min-area-operations",
    title: "Operations of the minimum-area enclosing zonogon",
    caption: "Operations of the whole of section 4.1, hull included, with each method of the kernel on random convex \
              polygons, where every point is on the hull, and with pruning on Gaussian points, where few are, with the \
              growth model that fits best (a power law where none does) and the exponent with its 95 % interval.",
    claims: &["theorem-4.5", "summary-min-area"],
    experiments: &[min_area_scaling::EXPERIMENT.id],
    deterministic: true,
    draw,
};

const PLOT: GrowthPlot = GrowthPlot {
    experiment: &min_area_scaling::EXPERIMENT,
    quantity: Quantity::AllCounts,
    families: &[("random_convex", Some("random convex polygons")), ("gaussian", Some("Gaussian points"))],
    shows: |variant, family| family == "random_convex" || variant == "by_pruning",
    x_name: "points n",
    y_name: "operations",
    y_unit: 1.0,
    compared_with: None,
};

fn draw(input: &FigureInput<'_>) -> Result<String, FigureError> {
    PLOT.draw(&FIGURE, input)
}
