//! Operations of the kernel's methods against the number of lines.

use crate::figure::{Figure, FigureError, FigureInput};
use crate::growth_plot::GrowthPlot;
use experiments::definition::Quantity;
use experiments::definitions::lad_scaling;

/// Operations of the kernel's methods.
pub const FIGURE: Figure = Figure {
    id: "scaling-kernel-operations",
    title: "Operations of the kernel's methods",
    caption: "Operations of each method of the least absolute deviations kernel on random lines, with the growth model \
              that fits best (a power law where none does) and the exponent with its 95 % interval.",
    claims: &["theorem-4.5", "halving-search"],
    experiments: &[lad_scaling::EXPERIMENT.id],
    deterministic: true,
    draw,
};

const PLOT: GrowthPlot = GrowthPlot {
    experiment: &lad_scaling::EXPERIMENT,
    quantity: Quantity::AllCounts,
    families: &[("random_lines", None)],
    shows: |_variant, _family| true,
    x_name: "lines n",
    y_name: "operations",
    y_unit: 1.0,
    compared_with: None,
};

fn draw(input: &FigureInput<'_>) -> Result<String, FigureError> {
    PLOT.draw(&FIGURE, input)
}
