//! Time of the collision methods against the number of generators.

use crate::figure::{Figure, FigureError, FigureInput};
use crate::growth_plot::GrowthPlot;
use experiments::definition::Quantity;
use experiments::definitions::collision_scaling;

/// Times of the collision methods.
pub const FIGURE: Figure = Figure {
    id: "scaling-collision-times",
    title: "Time of the collision methods",
    caption: "Time of each method for one question about a random body of n generators: medians of several runs on \
              this machine. The legend says how many times the kernel's each takes at the largest size that was \
              measured for both; explicit faces and the search cross where their curves do. Our own GJK and the \
              feasibility programs compute in floating point.",
    claims: &["theorem-5.2"],
    experiments: &[collision_scaling::EXPERIMENT.id],
    deterministic: false,
    draw,
};

const PLOT: GrowthPlot = GrowthPlot {
    experiment: &collision_scaling::EXPERIMENT,
    quantity: Quantity::Time("total"),
    families: &[("random_bodies", None)],
    shows: |_variant, _family| true,
    x_name: "generators n",
    y_name: "time (s)",
    y_unit: 1e9,
    compared_with: Some("by_lad"),
};

fn draw(input: &FigureInput<'_>) -> Result<String, FigureError> {
    PLOT.draw(&FIGURE, input)
}
