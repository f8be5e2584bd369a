//! Tests of nodes against the fit of the volumes, mesh by mesh.

use crate::axes::{Curve, Look, Naming, Plot, Scale};
use crate::figure::{Figure, FigureError, FigureInput};
use crate::style::method_color;
use experiments::definition::Quantity;
use experiments::definitions::mesh_node_tests::{BOXES, COUNTS};
use experiments::hierarchies::Asked;
use experiments::measured::{Measured, Series};

/// The costs.
pub const FIGURE: Figure = Figure {
    id: "mesh-cost-against-fit",
    title: "Tests of nodes against the fit of volumes",
    caption: "Pairs of nodes that are tested where copies of a mesh are one per cent of its diagonal apart, over those \
              of boxes that a search turns, against the expected overlaps of a node with its like, over those of the \
              same boxes: a point for each mesh and volume. The fit is what a volume is chosen for when a hierarchy \
              is built.",
    claims: &["question-hierarchies"],
    experiments: &[COUNTS.id],
    deterministic: true,
    draw,
};

/// The place of the distance of one per cent among the distances.
const ONE_PER_CENT: usize = 2;

/// The volumes, with their names in the legend.
const SHOWN: [(&str, &str); 5] = [
    ("aabb", "boxes along the axes"),
    ("dop_26", "polytopes of 26 normals"),
    ("zonotope_3", "zonotopes, K = 3"),
    ("zonotope_4", "zonotopes, K = 4"),
    ("zonotope_6", "zonotopes, K = 6"),
];

fn draw(input: &FigureInput<'_>) -> Result<String, FigureError> {
    let found = Measured::of(input.records.ok_or(FigureError::NoRecords(COUNTS.id))?);
    let tests = Quantity::Value(Asked::Apart(ONE_PER_CENT).name());
    let curve = |(sign, (volume, name)): (usize, (&str, &str))| {
        let ratios = found.ratios(COUNTS.id, [volume, BOXES], tests).into_iter();
        let points = ratios.filter_map(|(mesh, ratio)| Some([fit(&found, mesh, volume)?, ratio])).collect();
        let look = Look::new(method_color(volume), sign);
        Curve { name: name.to_owned(), notes: Vec::new(), points, fit: Vec::new(), look }
    };
    let curves: Vec<Curve> = SHOWN.into_iter().enumerate().map(curve).collect();
    if curves.iter().all(|curve| curve.points.is_empty()) {
        return Err(FigureError::NoRecords(COUNTS.id));
    }
    let plot = Plot {
        title: FIGURE.title.into(),
        description: FIGURE.caption.into(),
        x_name: "expected overlaps over those of boxes".into(),
        x_scale: Scale::Logarithmic,
        y_name: "tests of nodes over those of boxes".into(),
        curves,
        naming: Naming::Apart,
    };
    plot.draw()
}

/// The fit of a volume around the nodes of a mesh.
fn fit(found: &Measured<'_>, mesh: &str, volume: &str) -> Option<f64> {
    let series = Series { experiment: COUNTS.id, input: mesh, method: volume };
    Some(found.at_largest(series, Quantity::Value("fit"))?.1)
}
