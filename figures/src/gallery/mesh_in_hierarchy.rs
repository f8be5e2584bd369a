//! A mesh inside the levels of its hierarchies.

use crate::figure::{Figure, FigureError, FigureInput};
use crate::scene::page::{Frame, PageBox, PagePoint, WorldBox};
use crate::scene::{LegendEntry, Panel, Sample, Scene};
use crate::skin::{MESH, Skin, ZONOHEDRON, draw_inside};
use crate::solid::{Camera, Face, faces_of};
use experiments::data;
use zonotope::bvh::{Bvh, Mesh, OrientedBox, Shaped, Zonotope6};

/// The levels.
pub const FIGURE: Figure = Figure {
    id: "mesh-in-hierarchy",
    title: "A mesh inside the levels of its hierarchies",
    caption: "A spider in the bounding volumes of three levels of a tree over its triangles: above, boxes that a \
              search turns, below, zonotopes of at most six generators. Trees are the same; each volume contains the \
              triangles of its node, exactly.",
    claims: &["question-hierarchies"],
    experiments: &[],
    deterministic: true,
    draw,
};

/// The levels that are drawn, from the root.
const LEVELS: [usize; 3] = [0, 2, 4];
const CELL: [f64; 2] = [300.0, 230.0];
const LEGEND: f64 = 34.0;

fn draw(_: &FigureInput<'_>) -> Result<String, FigureError> {
    let spider = data::mesh("assimp_spider").expect("the mesh is among the data");
    // up is along y; on the page z is up
    let vertices: Vec<[f64; 3]> = spider.vertices.iter().map(|&[x, y, z]| [x, -z, y]).collect();
    let triangles = spider.triangles.iter().map(|t| t.map(|corner| corner as u32)).collect();
    let mesh = Mesh::new(vertices.clone(), triangles).expect("the mesh is one");
    let (boxes, zonotopes) = (Bvh::<OrientedBox>::build(&mesh), Bvh::<Zonotope6>::build(&mesh));
    let rows = [(["box", "boxes"], levels(&boxes)), (["zonotope", "zonotopes"], levels(&zonotopes))];

    let (width, height) = (CELL[0] * LEVELS.len() as f64, CELL[1] * rows.len() as f64);
    let mut scene = Scene::new(width, height + LEGEND, FIGURE.title, FIGURE.caption);
    let camera = Camera::from_direction([1.2, -3.0, 1.0]);
    let unit = libm::exp2(boxes.unit() as f64);
    let scaled: Vec<[f64; 3]> = vertices.iter().map(|v| v.map(|c| c / unit)).collect();
    let skin = Skin::seen(&camera, &scaled, &spider.triangles);
    // one frame for all, so that sizes compare
    let all = rows.iter().flat_map(|(_, levels)| levels.iter().flatten().flatten());
    let corners: Vec<[f64; 2]> = all.flat_map(|face| &face.corners).map(|&corner| camera.project(corner)).collect();
    let world = WorldBox::around(&corners);
    for (row, ([one, many], levels)) in rows.iter().enumerate() {
        for (column, bodies) in levels.iter().enumerate() {
            let (left, top) = (CELL[0] * column as f64, CELL[1] * row as f64);
            let heading = format!("{} {}", bodies.len(), if bodies.len() == 1 { one } else { many });
            scene.heading(PagePoint::new(left + CELL[0] / 2.0, top + 22.0), &heading);
            let window = PageBox::new(left + 12.0, top + 32.0, CELL[0] - 24.0, CELL[1] - 40.0);
            let mut panel = Panel::new(&mut scene, Frame::fit(&world, window));
            let faces: Vec<Face> = bodies.iter().flatten().cloned().collect();
            draw_inside(&mut panel, &camera, &faces, &skin);
        }
    }
    let entries = [
        LegendEntry::new(Sample::Area(MESH), "mesh"),
        LegendEntry::new(Sample::Area(ZONOHEDRON), "bounding volumes of a level"),
    ];
    scene.legend(PagePoint::new(0.0, height + 4.0), width, &entries);
    Ok(scene.finish())
}

/// The faces of each volume on each of the levels that are drawn.
fn levels<V: Shaped>(hierarchy: &Bvh<V>) -> Vec<Vec<Vec<Face>>> {
    let faces = |node: usize| faces_of(&hierarchy.volumes()[node].shape());
    LEVELS.iter().map(|&level| hierarchy.topology().level(level).into_iter().map(faces).collect()).collect()
}
