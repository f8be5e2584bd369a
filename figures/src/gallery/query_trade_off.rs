//! The cost of a query against the space of the structure of Lemma 5.3.

use crate::axes::{Curve, Look, Naming, Plot, Scale};
use crate::figure::{Figure, FigureError, FigureInput};
use crate::growth_plot::signed;
use experiments::analysis;
use experiments::definition::Quantity;
use experiments::definitions::query_trade_off::EXPERIMENT;
use experiments::fit;

/// The costs.
pub const FIGURE: Figure = Figure {
    id: "query-trade-off",
    title: "A query against the space that is spent on it",
    caption: "Bodies of 1,024 generators in structures of space m: operations of a query, as a whole, to find the \
              trapezoid, and within it.",
    claims: &["lemma-5.3", "corollary-5.4"],
    experiments: &[EXPERIMENT.id],
    deterministic: true,
    draw,
};

const SHOWN: [(&str, &str); 3] =
    [("operations", "Query as a whole"), ("to_find_it", "To find the trapezoid"), ("in_trapezoid", "In the trapezoid")];

const FAMILY: &str = "random_bodies";

fn draw(input: &FigureInput<'_>) -> Result<String, FigureError> {
    let records = input.records.ok_or(FigureError::NoRecords(EXPERIMENT.id))?;
    let variant = EXPERIMENT.variants[0].id;
    let curves: Vec<Curve> = SHOWN
        .into_iter()
        .enumerate()
        .map(|(number, (value, name))| {
            let (samples, _) = analysis::samples(EXPERIMENT.id, FAMILY, variant, Quantity::Value(value), records);
            let exponent = fit::fit_growth(&samples, &[]).map(|growth| growth.exponent);
            let note = exponent.map(|exponent| {
                let [value, low, high] = [exponent.value, exponent.low, exponent.high].map(signed);
                format!("exponent {value} ({low} to {high})")
            });
            let points: Vec<[f64; 2]> =
                samples.iter().map(|&(space, cost)| [space, cost]).filter(|[_, cost]| *cost > 0.0).collect();
            let notes = note.into_iter().collect();
            Curve { name: name.into(), notes, fit: Vec::new(), points, look: Look::of_series(number) }
        })
        .filter(|curve: &Curve| !curve.points.is_empty())
        .collect();
    if curves.is_empty() {
        return Err(FigureError::NoRecords(EXPERIMENT.id));
    }
    let plot = Plot {
        title: FIGURE.title.into(),
        description: FIGURE.caption.into(),
        x_name: "space m".into(),
        x_scale: Scale::Logarithmic,
        y_name: "operations a query".into(),
        curves,
        naming: Naming::Apart,
    };
    plot.draw()
}
