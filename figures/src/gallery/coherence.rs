//! The reads of a frame of a motion, against the speed of the motion.

use crate::figure::{Figure, FigureError, FigureInput};
use crate::growth_plot::GrowthPlot;
use experiments::definition::Quantity;
use experiments::definitions::coherence;

/// The reads.
pub const FIGURE: Figure = Figure {
    id: "coherence",
    title: "A frame of a motion: generators read",
    caption: "One random body of 1,024 generators goes around another one, a thousandth of the distance of touching \
              apart and then as deep in it: generators and lines read in a frame, against the number of frames in a \
              turn. The queries are fresh ones, fresh ones to trees over directions that are built once, and \
              those of the kernel that begins with the last frame's optimum.",
    claims: &["summary-repeated-tests", "local-walk"],
    experiments: &[coherence::EXPERIMENT.id],
    deterministic: true,
    draw,
};

const PLOT: GrowthPlot = GrowthPlot {
    experiment: &coherence::EXPERIMENT,
    quantity: Quantity::Value("reads"),
    families: &[("random_bodies", None)],
    shows: |_variant, _family| true,
    x_name: "frames a turn n",
    y_name: "reads a frame",
    y_unit: 1.0,
    compared_with: None,
};

fn draw(input: &FigureInput<'_>) -> Result<String, FigureError> {
    PLOT.draw(&FIGURE, input)
}
