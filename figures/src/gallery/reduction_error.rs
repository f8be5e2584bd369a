//! The error of the rules of order reduction against the number of generators.

use crate::figure::{Figure, FigureError, FigureInput};
use crate::growth_plot::GrowthPlot;
use experiments::definition::Quantity;
use experiments::definitions::reduction_error;

/// The errors.
pub const FIGURE: Figure = Figure {
    id: "reduction-error",
    title: "Error of a reduction to k generators",
    caption: "A random body of 1,000 generators: the proven upper bound of the Hausdorff distance, in diameters of \
              the body, after each rule has reduced it to k generators. Rules whose reductions are alike lie on one \
              line.",
    claims: &["lemma-5.5", "zonoid-approximation"],
    experiments: &[reduction_error::EXPERIMENT.id],
    deterministic: true,
    draw,
};

const PLOT: GrowthPlot = GrowthPlot {
    experiment: &reduction_error::EXPERIMENT,
    quantity: Quantity::Value("error"),
    families: &[("random_bodies", None)],
    shows: |_variant, _family| true,
    x_name: "generators k",
    y_name: "Hausdorff distance / diameter",
    y_unit: 1.0,
    compared_with: None,
};

fn draw(input: &FigureInput<'_>) -> Result<String, FigureError> {
    PLOT.draw(&FIGURE, input)
}
