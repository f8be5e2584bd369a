//! The gap between length and lower bound, round by round.

use crate::axes::{Curve, Look, Naming, Plot, Scale};
use crate::figure::{Figure, FigureError, FigureInput};
use crate::style::SERIES;
use experiments::analysis;
use experiments::definition::Quantity;
use experiments::definitions::gap_curve::{EXPERIMENT, REACHED};

/// The gaps.
pub const FIGURE: Figure = Figure {
    id: "gap-curve",
    title: "The gap of the shortest zonotope, round by round",
    caption: "Points on a circle and on a sphere: the relative gap between the length of the best zonotope so far and \
              the proven lower bound, against the first round in which it was reached, blue on the \
              circle and orange on the sphere. A round is eight centres in the plane, a Newton step with all that it \
              brings to light in space.",
    claims: &["theorem-4.7"],
    experiments: &[EXPERIMENT.id],
    deterministic: true,
    draw,
};

const SHOWN: [(&str, &str, f64); 2] = [("sphere_2", "on a circle", 1.0), ("sphere_3", "on a sphere", 0.3)];

fn draw(input: &FigureInput<'_>) -> Result<String, FigureError> {
    let records = input.records.ok_or(FigureError::NoRecords(EXPERIMENT.id))?;
    let variant = &EXPERIMENT.variants[0];
    let mut curves = Vec::new();
    for (place_number, (family, place, part)) in SHOWN.into_iter().enumerate() {
        let samples = |name| analysis::samples(EXPERIMENT.id, family, variant.id, Quantity::Value(name), records).0;
        let mut sizes: Vec<f64> = samples("rounds").iter().map(|(n, _)| *n).collect();
        sizes.dedup();
        for n in sizes {
            let first = |name| samples(name).iter().find(|(size, _)| *size == n).map(|(_, round)| *round);
            let points: Vec<[f64; 2]> = REACHED.iter().filter_map(|&(gap, name)| Some([first(name)?, gap])).collect();
            let name = format!("{:.0} points {place}", part * n);
            // The colour tells the circle from the sphere, the sign the number of points.
            let look = Look::new(SERIES[place_number], curves.len());
            curves.push(Curve { name, notes: Vec::new(), fit: points.clone(), points, look });
        }
    }
    if curves.is_empty() {
        return Err(FigureError::NoRecords(EXPERIMENT.id));
    }
    let plot = Plot {
        title: FIGURE.title.into(),
        description: FIGURE.caption.into(),
        x_name: "rounds".into(),
        x_scale: Scale::Linear,
        y_name: "relative gap".into(),
        curves,
        naming: Naming::Apart,
    };
    plot.draw()
}
