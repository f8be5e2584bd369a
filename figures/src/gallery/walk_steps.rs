//! Times of steps from facet to facet.

use crate::figure::{Figure, FigureError, FigureInput};
use crate::growth_plot::GrowthPlot;
use experiments::definition::Quantity;
use experiments::definitions::walk_steps;

/// The times.
pub const FIGURE: Figure = Figure {
    id: "walk-steps",
    title: "Time of a step from facet to facet",
    caption: "Random bodies: the mean time of a step among a thousand, by dynamic hulls of the dual lines and by a \
              pass over all generators, eight at a time.",
    claims: &["lemma-5.6"],
    experiments: &[walk_steps::EXPERIMENT.id],
    deterministic: false,
    draw,
};

const PLOT: GrowthPlot = GrowthPlot {
    experiment: &walk_steps::EXPERIMENT,
    quantity: Quantity::Time("walk"),
    families: &[("random_bodies", None)],
    shows: |_variant, _family| true,
    x_name: "generators n",
    y_name: "microseconds a step",
    y_unit: 1e6,
    compared_with: Some("by_scan"),
};

fn draw(input: &FigureInput<'_>) -> Result<String, FigureError> {
    PLOT.draw(&FIGURE, input)
}
