//! The ratio to which nets and directions found as needed come to the least total length.

use crate::axes::{Curve, Look, Naming, Plot, Scale};
use crate::figure::{Figure, FigureError, FigureInput};
use crate::style::{GREY, method_color};
use experiments::analysis;
use experiments::definition::Quantity;
use experiments::definitions::length_ratio::EXPERIMENT;

/// The ratios.
pub const FIGURE: Figure = Figure {
    id: "length-ratio",
    title: "Proven ratio against the precision asked for",
    caption: "For 24 points on a circle and on a sphere: by how much the length of the answer exceeds the lower bound \
              that it proves, relatively, against 1/ε, where 1 + ε is the ratio that was asked for. Below the line the \
              promise is kept. Directions found as needed stop as soon as the bounds are near enough.",
    claims: &["theorem-4.7", "size-of-direction-net"],
    experiments: &[EXPERIMENT.id],
    deterministic: true,
    draw,
};

/// The curves: variant, family, and the name of the family.
const SHOWN: [(&str, &str, &str); 5] = [
    ("papers_net", "sphere_2", "on a circle"),
    ("net_of_cells", "sphere_2", "on a circle"),
    ("net_of_cells", "sphere_3", "on a sphere"),
    ("by_column_generation", "sphere_2", "on a circle"),
    ("by_column_generation", "sphere_3", "on a sphere"),
];

fn draw(input: &FigureInput<'_>) -> Result<String, FigureError> {
    let records = input.records.ok_or(FigureError::NoRecords(EXPERIMENT.id))?;
    let mut curves = Vec::new();
    for (id, family, place) in SHOWN {
        let (samples, _) = analysis::samples(EXPERIMENT.id, family, id, Quantity::Value("excess"), records);
        // An answer that proves itself optimal to the last digit has no place on a logarithmic axis.
        let points: Vec<[f64; 2]> = samples.iter().filter(|(_, y)| *y > 0.0).map(|&(n, y)| [n, y]).collect();
        let Some(variant) = EXPERIMENT.variants.iter().find(|variant| variant.id == id) else { continue };
        if points.is_empty() {
            return Err(FigureError::NoRecords(EXPERIMENT.id));
        }
        // The colour is the method's, the sign tells the circle from the sphere.
        let shape = usize::from(family != SHOWN[0].1);
        let look = Look::new(method_color(id), shape);
        let notes = vec![place.into()];
        curves.push(Curve { name: variant.title.into(), notes, fit: points.clone(), points, look });
    }
    let precisions: Vec<f64> = curves.iter().flat_map(|curve| &curve.points).map(|point| point[0]).collect();
    let [low, high] =
        [precisions.iter().copied().fold(f64::INFINITY, f64::min), precisions.iter().copied().fold(0.0, f64::max)];
    let asked: Vec<[f64; 2]> = [low, high].map(|n| [n, 1.0 / n]).to_vec();
    curves.push(Curve {
        name: "what was asked for".into(),
        notes: vec!["ε".into()],
        points: asked.clone(),
        fit: asked,
        look: Look::new(GREY, 2),
    });
    let plot = Plot {
        title: FIGURE.title.into(),
        description: FIGURE.caption.into(),
        x_name: "1 / ε".into(),
        x_scale: Scale::Logarithmic,
        y_name: "proven ratio − 1".into(),
        curves,
        naming: Naming::Apart,
    };
    plot.draw()
}
