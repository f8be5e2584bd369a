//! A body alone, as notebooks show it: a zonogon, or a zonohedron with hidden sides dotted.
//!
//! A body is moved to the origin and scaled by a power of two, so that its picture depends on its shape alone. A
//! [`group`] is several bodies, or bodies with points.

pub mod group;

use zonotope::numeric::scaling::{binary_exponent, scale_by_power_of_two};
use zonotope::zonotope::Zonotope;
use zonotope::zonotope::faces::{Faces, faces};

use crate::scene::page::{Frame, PageBox, PagePoint, WorldBox};
use crate::scene::text::{Anchor, TextStyle};
use crate::scene::{Panel, Scene};
use crate::solid::{self, Camera, Face, faces_of};
use crate::style::{ENCLOSING, GREY, INK, Paint, Stroke, text_size, weight};

/// The most facets that are drawn: more have no room.
const FACET_LIMIT: usize = 20_000;

const WINDOW: PageBox = PageBox::new(16.0, 16.0, 288.0, 240.0);

/// The picture of a body of the plane.
pub fn of_zonogon(body: &Zonotope<2>) -> Option<String> {
    let corners = unit_sized(body)?.vertices();
    let note = format!(
        "{}, {}",
        counted(body.generators().len(), "generator", "generators"),
        counted(corners.len(), "vertex", "vertices")
    );
    let mut scene = page("A zonogon", &note);
    let mut panel = Panel::new(&mut scene, Frame::fit(&WorldBox::around(&corners), WINDOW));
    match corners[..] {
        [one, other] => panel.segment(one, other, &Stroke::new(INK, weight::STRONG)),
        _ => panel.polygon(&corners, &Paint::fill(ENCLOSING, 0.4).with_outline(Stroke::new(INK, weight::MEDIUM))),
    }
    Some(scene.finish())
}

/// The picture of a body of space; none of a body with more facets than have room.
pub fn of_solid(body: &Zonotope<3>) -> Option<String> {
    let unit = unit_sized(body)?;
    let count = body.generators().len();
    if count * count.saturating_sub(1) > FACET_LIMIT {
        return None;
    }
    let camera = Camera::from_direction([2.0, -3.6, 1.7]);
    let (drawn, noun): (Vec<Face>, _) = match faces(&unit, &mut ()).ok()? {
        Faces::Solid(_) => (faces_of(&unit), "A zonohedron"),
        Faces::Flat(lattice) => {
            let side = lattice.facet_vertices(zonotope::zonotope::faces::Facet(0)).map(|vertex| lattice.point(vertex));
            let corners: Vec<[f64; 3]> = side.collect();
            let behind = corners.iter().rev().copied().collect();
            (vec![Face::of_polygon(corners), Face::of_polygon(behind)], "A zonogon in space")
        }
        Faces::Point(_) | Faces::Segment(_) => return None,
    };
    let note = format!("{}, {}", counted(count, "generator", "generators"), counted(drawn.len(), "facet", "facets"));
    let mut scene = page(noun, &note);
    let seen: Vec<[f64; 2]> =
        drawn.iter().flat_map(|face| &face.corners).map(|&corner| camera.project(corner)).collect();
    let mut panel = Panel::new(&mut scene, Frame::fit(&WorldBox::around(&seen), WINDOW));
    let paint = |face: &Face| Paint::fill(ENCLOSING, 0.75 - 0.4 * camera.squareness(face));
    let width = if drawn.len() > 400 { weight::FINE } else { weight::MEDIUM };
    solid::draw(&mut panel, &camera, &drawn, paint, |_| Stroke::new(INK, width));
    Some(scene.finish())
}

/// The body about the origin, its longest generator with a coordinate between 1/2 and 1; none of a point.
fn unit_sized<const D: usize>(body: &Zonotope<D>) -> Option<Zonotope<D>> {
    let largest = body.generators().iter().flatten().fold(0.0_f64, |most, c| most.max(c.abs()));
    let exponent = -i64::from(binary_exponent(largest)?);
    let scaled = |generator: &[f64; D]| generator.map(|c| scale_by_power_of_two(c, exponent));
    Zonotope::new([0.0; D], body.generators().iter().map(scaled).collect()).ok()
}

fn counted(count: usize, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}

fn page(noun: &str, note: &str) -> Scene {
    let mut scene = Scene::new(WINDOW.max.x + 16.0, WINDOW.max.y + 36.0, noun, &format!("{noun}: {note}."));
    let place = PagePoint::new(WINDOW.center().x, WINDOW.max.y + 24.0);
    scene.text(place, Anchor::Middle, &TextStyle::new(text_size::NOTE, GREY), note);
    scene
}

#[cfg(test)]
mod tests {
    use super::*;
    use families::bodies::named;

    #[test]
    fn a_picture_does_not_depend_on_place_and_unit() {
        let body = Zonotope::new([0.0; 3], named::truncated_octahedron()).expect("finite");
        let far = [1e10, 0.0, 3.0];
        for factor in [1.0, 2.0_f64.powi(-900), 2.0_f64.powi(900)] {
            let generators = body.generators().iter().map(|g| g.map(|c| c * factor)).collect();
            let scaled = Zonotope::new(far, generators).expect("finite");
            assert_eq!(of_solid(&scaled), of_solid(&body));
        }
        assert!(of_solid(&body).is_some_and(|svg| svg.contains("6 generators, 14 facets")));
    }

    #[test]
    fn flat_bodies_and_segments_of_the_plane_have_pictures_and_points_none() {
        let flat = Zonotope::new([0.0; 3], vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]).expect("finite");
        assert!(of_solid(&flat).is_some_and(|svg| svg.contains("A zonogon in space")));
        let segment = Zonotope::new([0.0; 2], vec![[1.0, 0.0]]).expect("finite");
        assert!(of_zonogon(&segment).is_some_and(|svg| svg.contains("1 generator, 2 vertices")));
        let point = Zonotope::new([1.0; 2], vec![[0.0; 2]]).expect("finite");
        assert_eq!(of_zonogon(&point), None);
    }
}
