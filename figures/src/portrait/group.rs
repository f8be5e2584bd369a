//! Bodies and points in one picture, as notebooks show a body around points and two bodies that may meet.
//!
//! All of them are moved and scaled together, by a power of two, so that the picture depends on their shapes and on
//! where they stand to each other alone.

use zonotope::numeric::scaling::{binary_exponent, scale_by_power_of_two};
use zonotope::zonotope::Zonotope;

use super::{FACET_LIMIT, WINDOW, page};
use crate::scene::Panel;
use crate::scene::page::{Frame, WorldBox};
use crate::solid::{self, Camera, Face, faces_of};
use crate::style::{Color, ENCLOSING, INK, INPUT, Marker, Paint, REFLECTED, Shape, Stroke, weight};

/// The most points that are drawn: of more, every second one, every third one, and on.
const POINT_LIMIT: usize = 2_000;

/// The colours of the bodies, in turn.
const COLORS: [Color; 2] = [ENCLOSING, REFLECTED];

/// The mark of a point: smaller than that of a figure, as a cloud has many.
const POINT: Marker = Marker::new(Shape::Disc, 1.4, INPUT);

/// The picture of bodies of the plane with points; none where there is nothing to see.
pub fn in_plane(title: &str, note: &str, bodies: &[Zonotope<2>], points: &[[f64; 2]]) -> Option<String> {
    let unit = Unit::around(bodies, points)?;
    let outlines: Vec<Vec<[f64; 2]>> =
        bodies.iter().map(|body| Some(unit.body(body)?.vertices())).collect::<Option<_>>()?;
    let marks: Vec<[f64; 2]> = thinned(points).map(|&point| unit.point(point)).collect();
    let mut scene = page(title, note);
    let seen = outlines.iter().flatten().chain(&marks);
    let mut panel = Panel::new(&mut scene, Frame::fit(&WorldBox::around(seen), WINDOW));
    for (outline, color) in outlines.iter().zip(COLORS.into_iter().cycle()) {
        draw_outline(&mut panel, outline, color, 0.35);
    }
    panel.markers(&marks, &POINT);
    Some(scene.finish())
}

/// The picture of bodies of space with points; none where there is nothing to see.
pub fn in_space(title: &str, note: &str, bodies: &[Zonotope<3>], points: &[[f64; 3]]) -> Option<String> {
    let unit = Unit::around(bodies, points)?;
    let camera = Camera::from_direction([2.0, -3.6, 1.7]);
    let mut solids: Vec<Solid> = bodies
        .iter()
        .zip(COLORS.into_iter().cycle())
        .map(|(body, color)| Some(Solid::of(unit.body(body)?, color, &camera)))
        .collect::<Option<_>>()?;
    let marks: Vec<[f64; 2]> = thinned(points).map(|&point| camera.project(unit.point(point))).collect();
    let mut scene = page(title, note);
    let seen = solids.iter().flat_map(|solid| &solid.outline).chain(&marks);
    let mut panel = Panel::new(&mut scene, Frame::fit(&WorldBox::around(seen), WINDOW));
    panel.markers(&marks, &POINT);
    // The body that is nearer to the eye comes over the other one.
    solids.sort_by(|a, b| a.nearness.total_cmp(&b.nearness));
    for solid in &solids {
        solid.draw(&mut panel, &camera);
    }
    Some(scene.finish())
}

/// A body of space as it is seen.
struct Solid {
    /// No faces where the body is flat or has too many.
    faces: Vec<Face>,
    outline: Vec<[f64; 2]>,
    nearness: f64,
    color: Color,
}

impl Solid {
    fn of(body: Zonotope<3>, color: Color, camera: &Camera) -> Self {
        let count = body.generators().len();
        let faces = if count * count.saturating_sub(1) > FACET_LIMIT { Vec::new() } else { faces_of(&body) };
        let shadow = body.generators().iter().map(|&generator| camera.project(generator)).collect();
        let shadow = Zonotope::new(camera.project(body.center()), shadow);
        let outline = shadow.map_or_else(|_| Vec::new(), |shadow| shadow.vertices());
        Self { faces, outline, nearness: camera.nearness(body.center()), color }
    }

    fn draw(&self, panel: &mut Panel<'_>, camera: &Camera) {
        if self.faces.is_empty() {
            return draw_outline(panel, &self.outline, self.color, 0.35);
        }
        let paint = |face: &Face| Paint::fill(self.color, 0.6 - 0.35 * camera.squareness(face));
        let width = if self.faces.len() > 400 { weight::FINE } else { weight::MEDIUM };
        solid::draw(panel, camera, &self.faces, paint, |_| Stroke::new(INK, width));
    }
}

fn draw_outline(panel: &mut Panel<'_>, corners: &[[f64; 2]], color: Color, opacity: f64) {
    match *corners {
        [] => {}
        [point] => panel.marker(point, &Marker::new(Shape::Disc, 2.4, color)),
        [from, to] => panel.segment(from, to, &Stroke::new(color, weight::STRONG)),
        _ => panel.polygon(corners, &Paint::fill(color, opacity).with_outline(Stroke::new(INK, weight::MEDIUM))),
    }
}

/// The points, or every k-th of them where they are too many.
fn thinned<const D: usize>(points: &[[f64; D]]) -> impl Iterator<Item = &[f64; D]> {
    points.iter().step_by(points.len().div_ceil(POINT_LIMIT).max(1))
}

/// The origin and the unit of length of a picture.
struct Unit<const D: usize> {
    origin: [f64; D],
    exponent: i64,
}

impl<const D: usize> Unit<D> {
    /// The first body's centre, and a power of two above all coordinates from there; none where all of them are zero.
    fn around(bodies: &[Zonotope<D>], points: &[[f64; D]]) -> Option<Self> {
        let origin = bodies.first()?.center();
        let centers = bodies.iter().map(Zonotope::center).chain(points.iter().copied());
        let halves = centers.flat_map(|point| half_difference(point, origin));
        let reaches = bodies.iter().flat_map(|body| body.generators().iter().flatten().map(|c| c / 2.0));
        let largest = halves.chain(reaches).fold(0.0_f64, |most, c| most.max(c.abs()));
        Some(Self { origin, exponent: -i64::from(binary_exponent(largest)?) })
    }

    fn point(&self, point: [f64; D]) -> [f64; D] {
        half_difference(point, self.origin).map(|c| scale_by_power_of_two(c, self.exponent))
    }

    fn body(&self, body: &Zonotope<D>) -> Option<Zonotope<D>> {
        let scaled = |generator: &[f64; D]| generator.map(|c| scale_by_power_of_two(c / 2.0, self.exponent));
        Zonotope::new(self.point(body.center()), body.generators().iter().map(scaled).collect()).ok()
    }
}

/// Half of a difference of points: it is a double where the whole one may be beyond them.
fn half_difference<const D: usize>(point: [f64; D], origin: [f64; D]) -> [f64; D] {
    std::array::from_fn(|i| point[i] / 2.0 - origin[i] / 2.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use families::bodies::named;

    fn moved(body: &Zonotope<3>, factor: f64, by: [f64; 3]) -> Zonotope<3> {
        let center = std::array::from_fn(|i| factor * (body.center()[i] + by[i]));
        Zonotope::new(center, body.generators().iter().map(|g| g.map(|c| c * factor)).collect()).expect("finite")
    }

    #[test]
    fn a_picture_does_not_depend_on_the_place_and_the_unit_of_all() {
        let body = Zonotope::new([0.0; 3], named::truncated_octahedron()).expect("finite");
        let picture = |factor: f64, by: [f64; 3]| {
            let pair = [moved(&body, factor, by), moved(&body, factor, [by[0] + 8.0, by[1], by[2]])];
            in_space("Two zonotopes", "apart", &pair, &[by.map(|c| factor * c)])
        };
        let expected = picture(1.0, [0.0; 3]);
        assert!(expected.as_ref().is_some_and(|svg| svg.contains("apart")));
        for factor in [1.0, 2.0_f64.powi(-900), 2.0_f64.powi(900)] {
            assert_eq!(picture(factor, [64.0, 0.0, -16.0]), expected);
        }
    }

    #[test]
    fn every_shape_is_drawn_and_points_alone_are_not() {
        let [flat, segment, point] = [vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], vec![[0.0, 1.0, 1.0]], vec![]]
            .map(|generators| Zonotope::new([0.0; 3], generators).expect("finite"));
        let count = |bodies: &[Zonotope<3>]| in_space("t", "n", bodies, &[]).map(|svg| svg.matches('<').count());
        assert!(count(&[flat.clone(), segment]) > count(&[flat]));
        assert_eq!(count(&[point]), None);
        let cloud: Vec<[f64; 2]> = (0..10_000).map(|i| [f64::from(i), f64::from(i % 7)]).collect();
        let extremes = Zonotope::new([f64::MAX, 0.0], vec![[f64::MAX, 1.0]]).expect("finite");
        let drawn = in_plane("t", "n", &[extremes], &cloud).expect("a segment");
        assert!(drawn.len() < 400_000 && !drawn.contains("NaN") && !drawn.contains("inf"), "{}", drawn.len());
    }
}
