//! A mesh in its shortest zonohedra along more and more directions.

use crate::figure::{Figure, FigureError, FigureInput};
use crate::scene::page::{Frame, PageBox, PagePoint, WorldBox};
use crate::scene::text::{Anchor, TextStyle};
use crate::scene::{LegendEntry, Panel, Sample, Scene};
use crate::skin::{MESH, Skin, ZONOHEDRON, draw_inside};
use crate::solid::{Camera, faces_of};
use crate::style::{GREY, text_size};
use experiments::data::mesh;
use families::clouds::solid as platonic;
use zonotope::enclosing::fixed_directions::{Enclosure, FixedDirections, min_length_along};
use zonotope::enclosing::min_length;
use zonotope::hull::in_space::solid_hull;
use zonotope::zonotope::{Zonotope, combinatorics};

/// The zonohedra.
pub const FIGURE: Figure = Figure {
    id: "mesh-in-zonohedra",
    title: "A mesh in its shortest zonohedra",
    caption: "The Utah teapot in the zonohedron of least total length along k given directions: the axes, the \
              diagonals of an icosahedron, those of a dodecahedron with them, and the axes through the middles of \
              edges as well. Below each number the total length as a multiple of a lower bound for all directions, \
              proven by forces, and the volume as a multiple of that of the convex hull.",
    claims: &["theorem-4.6", "structure-from-directions", "question-approximation-quality"],
    experiments: &[],
    deterministic: true,
    draw,
};

const COLUMNS: usize = 2;
const CELL: [f64; 2] = [400.0, 350.0];

fn draw(_: &FigureInput<'_>) -> Result<String, FigureError> {
    let teapot = mesh("teapot").expect("the mesh is among the data");
    // Its lid is up along y; on the page z is up.
    let vertices: Vec<[f64; 3]> = teapot.vertices.iter().map(|&[x, y, z]| [x, -z, y]).collect();
    let hull = solid_hull(&vertices).expect("the coordinates are finite").expect("a teapot has a volume");
    let hull_volume = hull.volume(&vertices);
    let corners: Vec<[f64; 3]> = hull.vertices().into_iter().map(|vertex| vertices[vertex]).collect();
    let best = min_length(&corners, 0.01).expect("the mesh's coordinates are finite");
    let pictures = direction_sets().map(|directions| {
        let (zonohedron, length) = along(&corners, &directions);
        (format!("$k$ = {}", directions.len()), zonohedron, length)
    });

    let rows = pictures.len().div_ceil(COLUMNS);
    let (width, height) = (CELL[0] * COLUMNS as f64, CELL[1] * rows as f64);
    let mut scene = Scene::new(width, height + 34.0, FIGURE.title, FIGURE.caption);
    let camera = Camera::from_direction([1.4, -3.0, 1.6]);
    let skin = Skin::seen(&camera, &vertices, &teapot.triangles);
    for (number, (heading, zonohedron, length)) in pictures.iter().enumerate() {
        let (left, top) = (CELL[0] * (number % COLUMNS) as f64, CELL[1] * (number / COLUMNS) as f64);
        let middle = left + CELL[0] / 2.0;
        scene.heading(PagePoint::new(middle, top + 22.0), heading);
        let volume = combinatorics(zonohedron).measure.to_f64_fast() / hull_volume;
        let note = format!("length {:.3} × least, volume {volume:.2} × hull", length / best.lower_bound);
        scene.text(PagePoint::new(middle, top + 40.0), Anchor::Middle, &TextStyle::new(text_size::NOTE, GREY), &note);
        let window = PageBox::new(left + 16.0, top + 50.0, CELL[0] - 32.0, CELL[1] - 60.0);
        draw_body(&mut scene, window, &camera, zonohedron, &skin);
    }
    let entries = [
        LegendEntry::new(Sample::Area(MESH), "mesh"),
        LegendEntry::new(Sample::Area(ZONOHEDRON), "zonohedron of least total length"),
    ];
    scene.legend(PagePoint::new(0.0, height + 4.0), width, &entries);
    Ok(scene.finish())
}

/// One vector of each pair of opposite vertices of a solid, made a unit vector.
fn diagonals(name: &str) -> Vec<[f64; 3]> {
    let vertices = platonic(name).expect("the solid is among the families");
    let length = |v: &[f64; 3]| v.iter().map(|c| c * c).sum::<f64>().sqrt();
    vertices.iter().filter(|v| is_upper(v)).map(|v| v.map(|c| c / length(v))).collect()
}

/// The middles of a solid's edges, one of each opposite pair, made unit vectors: edges join the nearest vertices.
fn middles_of_edges(name: &str) -> Vec<[f64; 3]> {
    let vertices = platonic(name).expect("the solid is among the families");
    let square = |v: [f64; 3]| v.iter().map(|c| c * c).sum::<f64>();
    let pairs = || (0..vertices.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
    let apart = |(i, j): (usize, usize)| square(std::array::from_fn(|c| vertices[i][c] - vertices[j][c]));
    let edge = pairs().map(apart).fold(f64::INFINITY, f64::min);
    let edges = pairs().filter(|&pair| apart(pair) < 1.01 * edge);
    let middles = edges.map(|(i, j)| std::array::from_fn(|c| vertices[i][c] + vertices[j][c]));
    middles.filter(is_upper).map(|v| v.map(|c| c / square(v).sqrt())).collect()
}

/// Whether the last coordinate that is not zero, but for rounding, is positive.
fn is_upper(v: &[f64; 3]) -> bool {
    v.iter().rev().find(|c| c.abs() > 1e-9).is_some_and(|c| *c > 0.0)
}

fn direction_sets() -> [Vec<[f64; 3]>; 4] {
    let (axes, six) = (diagonals("octahedron"), diagonals("icosahedron"));
    let sixteen = [six.clone(), diagonals("dodecahedron")].concat();
    let all = [sixteen.clone(), middles_of_edges("icosahedron")].concat();
    [axes, six, sixteen, all]
}

fn along(points: &[[f64; 3]], directions: &[[f64; 3]]) -> (Zonotope<3>, f64) {
    let weights = vec![1.0; directions.len()];
    let problem = FixedDirections::new(points, directions, &weights).expect("the coordinates are finite");
    let Ok(Enclosure::Optimal(answer)) = min_length_along(&problem, &mut ()) else {
        unreachable!("three diagonals of a solid span space")
    };
    (answer.zonotope(&problem).expect("the mesh is far from the range's ends"), answer.value)
}

fn draw_body(scene: &mut Scene, window: PageBox, camera: &Camera, zonohedron: &Zonotope<3>, skin: &Skin) {
    let faces = faces_of(zonohedron);
    let outline: Vec<[f64; 2]> =
        faces.iter().flat_map(|face| &face.corners).map(|&corner| camera.project(corner)).collect();
    let mut panel = Panel::new(scene, Frame::fit(&WorldBox::around(&outline), window));
    draw_inside(&mut panel, camera, &faces, skin);
}
