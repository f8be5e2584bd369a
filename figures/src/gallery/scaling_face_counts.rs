//! The number of facets against the number of generators.

use crate::figure::{Figure, FigureError, FigureInput};
use crate::growth_plot::GrowthPlot;
use experiments::definition::Quantity;
use experiments::definitions::faces_scaling;

/// The number of facets.
pub const FIGURE: Figure = Figure {
    id: "scaling-face-counts",
    title: "Facets of a zonohedron",
    caption: "How many facets a body of n generators has: n(n − 1) in general position, fewer with more sides where \
              many generators are coplanar, as on a lattice.",
    claims: &["face-count"],
    experiments: &[faces_scaling::EXPERIMENT.id],
    deterministic: true,
    draw,
};

const PLOT: GrowthPlot = GrowthPlot {
    experiment: &faces_scaling::EXPERIMENT,
    quantity: Quantity::Value("facets"),
    families: &[("random_bodies", Some("random bodies")), ("lattice_bodies", Some("lattice bodies"))],
    shows: |_variant, _family| true,
    x_name: "generators n",
    y_name: "facets",
    y_unit: 1.0,
    compared_with: None,
};

fn draw(input: &FigureInput<'_>) -> Result<String, FigureError> {
    PLOT.draw(&FIGURE, input)
}
