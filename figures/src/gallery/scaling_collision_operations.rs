//! Operations of the collision methods against the number of generators.

use crate::figure::{Figure, FigureError, FigureInput};
use crate::growth_plot::GrowthPlot;
use experiments::definition::Quantity;
use experiments::definitions::collision_scaling;

/// Operations of the collision methods.
pub const FIGURE: Figure = Figure {
    id: "scaling-collision-operations",
    title: "Operations of the collision methods",
    caption: "Operations of each method for one question about a random body of n generators: just inside, with gaps \
              of 1e-3 to 1e-12. Our own GJK computes in floating point alone. The curves are the growth model that \
              fits best (a power law where none does); exponents have 95 % intervals.",
    claims: &["theorem-5.2"],
    experiments: &[collision_scaling::EXPERIMENT.id],
    deterministic: true,
    draw,
};

const PLOT: GrowthPlot = GrowthPlot {
    experiment: &collision_scaling::EXPERIMENT,
    quantity: Quantity::AllCounts,
    families: &[("random_bodies", None)],
    // The engines of linear programs count nothing.
    shows: |variant, _family| !["clarabel", "microlp"].contains(&variant),
    x_name: "generators n",
    y_name: "operations",
    y_unit: 1.0,
    compared_with: None,
};

fn draw(input: &FigureInput<'_>) -> Result<String, FigureError> {
    PLOT.draw(&FIGURE, input)
}
