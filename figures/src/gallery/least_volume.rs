//! The smallest zonotope that is found around points against its number of generators.

use crate::axes::{Curve, Look, Naming, Plot, Scale};
use crate::figure::{Figure, FigureError, FigureInput};
use crate::style::SERIES;
use experiments::definition::Quantity;
use experiments::definitions::few_generators::most_generators;
use experiments::definitions::least_volume::{EXPERIMENT, INPUTS};
use experiments::measured::{Measured, Series};

/// The volumes.
pub const FIGURE: Figure = Figure {
    id: "least-volume",
    title: "Volume of a zonotope around points against its number of generators",
    caption: "The smallest zonotope that is found with at most K generators, from many random starts, over the hull of \
              the points, which no zonotope around them undercuts. A point is the best of all starts, and that none is \
              smaller is not proved.",
    claims: &["question-optimal-volume", "question-generator-count"],
    experiments: &[EXPERIMENT.id],
    deterministic: true,
    draw,
};

fn draw(input: &FigureInput<'_>) -> Result<String, FigureError> {
    let found = Measured::of(input.records.ok_or(FigureError::NoRecords(EXPERIMENT.id))?);
    let mut curves = Vec::new();
    for name in INPUTS {
        let point = |variant: &str| {
            let series = Series { experiment: EXPERIMENT.id, input: name, method: variant };
            Some([most_generators(variant)? as f64, found.at_largest(series, Quantity::Value("volume_ratio"))?.1])
        };
        let points: Vec<[f64; 2]> = EXPERIMENT.variants.iter().filter_map(|variant| point(variant.id)).collect();
        if !points.is_empty() {
            let look = Look::new(SERIES[curves.len() % SERIES.len()], curves.len());
            let name = name.rsplit('_').next().unwrap_or(name).to_owned();
            curves.push(Curve { name, notes: Vec::new(), fit: points.clone(), points, look });
        }
    }
    if curves.is_empty() {
        return Err(FigureError::NoRecords(EXPERIMENT.id));
    }
    let plot = Plot {
        title: FIGURE.title.into(),
        description: FIGURE.caption.into(),
        x_name: "generators K".into(),
        x_scale: Scale::Logarithmic,
        y_name: "volume over that of the hull".into(),
        curves,
        naming: Naming::Apart,
    };
    plot.draw()
}
