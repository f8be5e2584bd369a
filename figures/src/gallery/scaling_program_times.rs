//! Time of the linear programs of 4.2 against the number of directions.

use crate::figure::{Figure, FigureError, FigureInput};
use crate::growth_plot::GrowthPlot;
use experiments::definition::Quantity;
use experiments::definitions::directions_scaling;

/// The times.
pub const FIGURE: Figure = Figure {
    id: "scaling-program-times",
    title: "Time of the linear programs along k directions",
    caption: "400 points on a sphere of space and of the plane, everything included: the paper's program and the one \
              with an inequality for every facet normal, both by an interior point method, and the one that finds \
              normals as they are needed. Medians of several runs on this machine, with the growth model that fits \
              best.",
    claims: &["theorem-4.6", "linear-program"],
    experiments: &[directions_scaling::EXPERIMENT.id],
    deterministic: false,
    draw,
};

const PLOT: GrowthPlot = GrowthPlot {
    experiment: &directions_scaling::EXPERIMENT,
    quantity: Quantity::Time("total"),
    families: &[("sphere_2", Some("a circle")), ("sphere_3", Some("a sphere"))],
    shows: |variant, family| family == "sphere_3" || variant == "by_row_generation",
    x_name: "directions k",
    y_name: "time (s)",
    y_unit: 1e9,
    compared_with: None,
};

fn draw(input: &FigureInput<'_>) -> Result<String, FigureError> {
    PLOT.draw(&FIGURE, input)
}
