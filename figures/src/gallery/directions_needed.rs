//! The number of directions that a promised ratio takes.

use crate::figure::{Figure, FigureError, FigureInput};
use crate::growth_plot::GrowthPlot;
use experiments::definition::Quantity;
use experiments::definitions::length_ratio;

/// The sizes of the nets.
pub const FIGURE: Figure = Figure {
    id: "directions-needed",
    title: "Directions needed for a promised ratio",
    caption: "How many directions a net needs so that the shortest zonotope along them is within 1 + ε of the shortest \
              of all: of order ε to the power −(d − 1) in the paper's net, which lets the axes carry what a generator \
              is off its direction; −(d − 1)/2 when generators are combinations of the corners of their cell. The \
              colour tells the net, the shape of the mark the dimension.",
    claims: &["theorem-4.7", "direction-net", "size-of-direction-net"],
    experiments: &[length_ratio::EXPERIMENT.id],
    deterministic: true,
    draw,
};

const PLOT: GrowthPlot = GrowthPlot {
    experiment: &length_ratio::EXPERIMENT,
    quantity: Quantity::Value("net_size"),
    families: &[("sphere_2", Some("R²")), ("sphere_3", Some("R³")), ("sphere_4", Some("R⁴"))],
    shows: |variant, _family| variant != "by_column_generation",
    x_name: "n = 1 / ε",
    y_name: "directions",
    y_unit: 1.0,
    compared_with: None,
};

fn draw(input: &FigureInput<'_>) -> Result<String, FigureError> {
    PLOT.draw(&FIGURE, input)
}
