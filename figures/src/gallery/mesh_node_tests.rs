//! Tests of nodes by distance and bounding volume, relative to those of searched boxes.

use crate::axes::{Curve, Look, Naming, Plot, Scale};
use crate::figure::{Figure, FigureError, FigureInput};
use crate::style::method_color;
use experiments::definition::Quantity;
use experiments::definitions::mesh_node_tests::{BOXES, COUNTS};
use experiments::hierarchies::{Asked, DISTANCES};
use experiments::measured::Measured;

/// The numbers of tests.
pub const FIGURE: Figure = Figure {
    id: "mesh-node-tests",
    title: "Tests of nodes against the distance of two meshes",
    caption: "Pairs of nodes that two hierarchies test until copies of a mesh are proved apart, over those of boxes \
              that a search turns: geometric means over all meshes, against the distance in per cent of the diagonal \
              of a mesh's box. Below 1 there are fewer tests; a test of a larger volume takes longer.",
    claims: &["question-hierarchies"],
    experiments: &[COUNTS.id],
    deterministic: true,
    draw,
};

/// The volumes, with their names in the legend.
const SHOWN: [(&str, &str); 8] = [
    ("aabb", "boxes along the axes"),
    ("dop_26", "polytopes of 26 normals"),
    ("zonotope_3", "zonotopes, K = 3"),
    ("zonotope_4", "zonotopes, K = 4"),
    ("zonotope_5", "zonotopes, K = 5"),
    ("zonotope_6", "zonotopes, K = 6"),
    ("zonotope_by_cost", "zonotopes, K by cost"),
    ("sphere", "spheres"),
];

fn draw(input: &FigureInput<'_>) -> Result<String, FigureError> {
    let found = Measured::of(input.records.ok_or(FigureError::NoRecords(COUNTS.id))?);
    let mut curves = Vec::new();
    for (sign, (volume, name)) in SHOWN.into_iter().enumerate() {
        let at = |(place, distance): (usize, f64)| {
            let quantity = Quantity::Value(Asked::Apart(place).name());
            Some([100.0 * distance, mean_ratio(&found, volume, quantity)?])
        };
        let points: Vec<[f64; 2]> = DISTANCES.into_iter().enumerate().filter_map(at).collect();
        let look = Look::new(method_color(volume), sign);
        curves.push(Curve { name: name.to_owned(), notes: Vec::new(), fit: points.clone(), points, look });
    }
    if curves.iter().all(|curve| curve.points.is_empty()) {
        return Err(FigureError::NoRecords(COUNTS.id));
    }
    let plot = Plot {
        title: FIGURE.title.into(),
        description: FIGURE.caption.into(),
        x_name: "distance, per cent of the diagonal".into(),
        x_scale: Scale::Logarithmic,
        y_name: "tests of nodes over those of boxes".into(),
        curves,
        naming: Naming::Apart,
    };
    plot.draw()
}

/// The geometric mean over meshes of a quantity of a volume over that of searched boxes.
fn mean_ratio(found: &Measured<'_>, volume: &str, quantity: Quantity) -> Option<f64> {
    let ratios = found.ratios(COUNTS.id, [volume, BOXES], quantity);
    let mean = ratios.iter().map(|(_, ratio)| libm::log(*ratio)).sum::<f64>() / ratios.len() as f64;
    mean.is_finite().then(|| libm::exp(mean))
}
