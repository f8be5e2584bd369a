//! Time of the kernel's methods against the number of lines.

use crate::figure::{Figure, FigureError, FigureInput};
use crate::growth_plot::GrowthPlot;
use experiments::definition::Quantity;
use experiments::definitions::lad_scaling;

/// Times of the kernel's methods.
pub const FIGURE: Figure = Figure {
    id: "scaling-kernel-times",
    title: "Time of the kernel's methods",
    caption: "Time of each method of the least absolute deviations kernel on random lines: medians of several runs on \
              this machine, with the growth model that fits best (a power law where none does) and the exponent with \
              its 95 % interval.",
    claims: &["theorem-4.5", "halving-search"],
    experiments: &[lad_scaling::EXPERIMENT.id],
    deterministic: false,
    draw,
};

const PLOT: GrowthPlot = GrowthPlot {
    experiment: &lad_scaling::EXPERIMENT,
    quantity: Quantity::Time("total"),
    families: &[("random_lines", None)],
    shows: |_variant, _family| true,
    x_name: "lines n",
    y_name: "time (s)",
    y_unit: 1e9,
    compared_with: None,
};

fn draw(input: &FigureInput<'_>) -> Result<String, FigureError> {
    PLOT.draw(&FIGURE, input)
}
