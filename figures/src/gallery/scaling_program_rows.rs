//! Rows of the linear programs of 4.2 against the number of directions.

use crate::figure::{Figure, FigureError, FigureInput};
use crate::growth_plot::GrowthPlot;
use experiments::definition::Quantity;
use experiments::definitions::directions_scaling;

/// The rows.
pub const FIGURE: Figure = Figure {
    id: "scaling-program-rows",
    title: "Rows of the linear programs along k directions",
    caption: "400 points on a sphere of space: rows of the paper's program, of the one with an inequality for every \
              facet normal, and of the one that finds normals as they are needed.",
    claims: &["theorem-4.6", "linear-program"],
    experiments: &[directions_scaling::EXPERIMENT.id],
    deterministic: true,
    draw,
};

const PLOT: GrowthPlot = GrowthPlot {
    experiment: &directions_scaling::EXPERIMENT,
    quantity: Quantity::Value("rows"),
    families: &[("sphere_3", None)],
    shows: |_variant, _family| true,
    x_name: "directions k",
    y_name: "rows",
    y_unit: 1.0,
    compared_with: None,
};

fn draw(input: &FigureInput<'_>) -> Result<String, FigureError> {
    PLOT.draw(&FIGURE, input)
}
