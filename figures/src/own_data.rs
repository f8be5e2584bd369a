//! Pictures of a reader's own data, by the drawing code of the gallery.
//!
//! Generators of space are placed so that their lines cross at different abscissas, if need be by a turn about the
//! vertical axis; points of the plane are moved to the origin and scaled by a power of two. So a picture has the shape
//! of the data, and no numbers of theirs.

use thiserror::Error;
use zonotope::hull::HullError;
use zonotope::numeric::scaling::{binary_exponent, scale_by_power_of_two};

pub use crate::duality::PositionError;

use crate::duality::{Placed, Separator, draw_arrangement, draw_tiling, generator_stroke, in_general_position};
use crate::gallery::search_of_theorem_5_2::Asked;
use crate::gallery::{arrangement_and_level_sets, search_of_theorem_4_5, search_of_theorem_5_2, separators};
use crate::min_area::Polygon;
use crate::scene::page::{PageBox, PagePoint};
use crate::scene::{LegendEntry, Sample, Scene};
use crate::style::{FOCUS, INK, Paint, Stroke, weight};

/// The most generators whose lines and tiles are drawn: more tiles than theirs have no room for their numbers.
const GENERATOR_LIMIT: usize = 16;

/// The most generators of which every separator has a panel.
const SWEEP_LIMIT: usize = 7;

/// The most vertices of a hull whose lines are drawn.
const HULL_LIMIT: usize = 64;

/// Coordinates beyond these, and bodies that are smaller, have no picture: products of theirs leave the range of
/// doubles.
const SIZES: std::ops::Range<f64> = 1e-60..1e60;

const WINDOW: PageBox = PageBox::new(40.0, 66.0, 600.0, 480.0);

/// Why data have no picture.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum OwnDataError {
    /// The generators have no position in which their lines can be drawn.
    #[error(transparent)]
    Position(#[from] PositionError),
    /// The points have no hull.
    #[error(transparent)]
    Hull(#[from] HullError),
    /// The points lie on a line.
    #[error("the points lie on a line, so that there is nothing to search for")]
    NoArea,
    /// There are more of something than have room.
    #[error("{count} {what}, at most {most} have room in this picture")]
    TooMany {
        /// The thing that there is too much of.
        what: &'static str,
        /// The number of them.
        count: usize,
        /// The most that are drawn.
        most: usize,
    },
    /// A separator is asked for that does not exist.
    #[error("there is no separator {k}; they are 0 to {last}")]
    NoSeparator {
        /// The separator that was asked for.
        k: usize,
        /// The last one.
        last: usize,
    },
    /// Numbers are too large or too small to be drawn.
    #[error("the coordinates are beyond 1e60 or all below 1e-60, which is not drawn")]
    OutOfRange,
}

/// The lines of generators with their crossings, and the separator with so many crossings on its left, if one is
/// wanted.
///
/// # Errors
/// If the data have no picture.
pub fn arrangement(name: &str, generators: &[[f64; 3]], k: Option<usize>) -> Result<String, OwnDataError> {
    let placed = placed(generators, GENERATOR_LIMIT)?;
    let separator = separator(&placed, k)?;
    let title = format!("Line arrangement of {name}");
    let mut scene = page(&title, &placed);
    draw_arrangement(&mut scene, WINDOW, &placed.pair, separator);
    Ok(finished(scene, "line of a generator", "crossings on the left, by their numbers", separator))
}

/// The upper hull of a body of space seen from above, a tile for each crossing, and the chain with so many tiles on its
/// left, if one is wanted.
///
/// # Errors
/// If the data have no picture.
pub fn tiling(name: &str, generators: &[[f64; 3]], k: Option<usize>) -> Result<String, OwnDataError> {
    let placed = placed(generators, GENERATOR_LIMIT)?;
    let separator = separator(&placed, k)?;
    let title = format!("Tiling of the upper hull of {name}");
    let mut scene = page(&title, &placed);
    draw_tiling(&mut scene, WINDOW, &placed.pair, separator);
    Ok(finished(scene, "edges along a generator", "tiles on the left, by their numbers", separator))
}

/// All separators of the tiling, a panel each.
///
/// # Errors
/// If the data have no picture.
pub fn separator_sweep(name: &str, generators: &[[f64; 3]]) -> Result<String, OwnDataError> {
    let placed = placed(generators, SWEEP_LIMIT)?;
    let title = format!("The separators of {name}");
    Ok(separators::sweep(&placed.pair, &title, &described(&placed)))
}

/// The search of Theorem 5.2 for a point, in a body of space with the origin as its centre.
///
/// # Errors
/// If the data have no picture.
pub fn search_for_point(name: &str, generators: &[[f64; 3]], point: [f64; 3]) -> Result<String, OwnDataError> {
    let placed = placed(generators, GENERATOR_LIMIT)?;
    if !point.iter().all(|c| c.abs() < SIZES.end) {
        return Err(OwnDataError::OutOfRange);
    }
    let title = format!("The search of Theorem 5.2 in {name}");
    let description = described(&placed);
    let point = placed.turned(point);
    let Placed { pair, upright, .. } = placed;
    Ok(search_of_theorem_5_2::search(&Asked { pair, upright, point }, &title, &description))
}

/// The search of Theorem 4.5 for the centre of the smallest zonogon around points of the plane.
///
/// # Errors
/// If the data have no picture.
pub fn search_for_center(name: &str, points: &[[f64; 2]]) -> Result<String, OwnDataError> {
    let polygon = polygon(points)?;
    let title = format!("The search of Theorem 4.5 around {name}");
    Ok(search_of_theorem_4_5::search(&polygon, &title, &described_hull(&polygon)))
}

/// The lines ℓ_t of the hull of points of the plane, level sets of the area of Z(O), and the centre of the smallest
/// one.
///
/// # Errors
/// If the data have no picture.
pub fn zonogon(name: &str, points: &[[f64; 2]]) -> Result<String, OwnDataError> {
    let polygon = polygon(points)?;
    let title = format!("The area of zonogons around {name}, over their centres");
    Ok(arrangement_and_level_sets::picture(&polygon, &title, &described_hull(&polygon)))
}

/// The generators in a position in which they can be drawn, if there are not too many.
fn placed(generators: &[[f64; 3]], most: usize) -> Result<Placed, OwnDataError> {
    let count = generators.len();
    if count > most {
        return Err(OwnDataError::TooMany { what: "generators", count, most });
    }
    check_size(generators.as_flattened())?;
    Ok(in_general_position(generators)?)
}

/// The hull of points in coordinates of ordinary size.
fn polygon(points: &[[f64; 2]]) -> Result<Polygon, OwnDataError> {
    let hull = Polygon::of(points)?;
    let [first, ..] = hull.vertices() else { return Err(OwnDataError::NoArea) };
    let moved: Vec<[f64; 2]> = hull.vertices().iter().map(|p| [p[0] - first[0], p[1] - first[1]]).collect();
    let count = moved.len();
    if count > HULL_LIMIT {
        return Err(OwnDataError::TooMany { what: "vertices of the hull", count, most: HULL_LIMIT });
    }
    check_size(moved.as_flattened())?;
    let largest = moved.iter().flatten().fold(0.0f64, |largest, c| largest.max(c.abs()));
    let shrink = 6 - i64::from(binary_exponent(largest).unwrap_or(0));
    let small: Vec<[f64; 2]> = moved.iter().map(|p| p.map(|c| scale_by_power_of_two(c, shrink))).collect();
    let polygon = Polygon::of(&small)?;
    if polygon.vertices().len() < 3 { Err(OwnDataError::NoArea) } else { Ok(polygon) }
}

pub(crate) fn check_size(coordinates: &[f64]) -> Result<(), OwnDataError> {
    let largest = coordinates.iter().fold(0.0f64, |largest, c| largest.max(c.abs()));
    if largest == 0.0 || SIZES.contains(&largest) { Ok(()) } else { Err(OwnDataError::OutOfRange) }
}

fn separator(placed: &Placed, k: Option<usize>) -> Result<Option<Separator>, OwnDataError> {
    let last = placed.pair.crossings.len();
    match k {
        Some(k) if k > last => Err(OwnDataError::NoSeparator { k, last }),
        k => Ok(k.map(|k| Separator { k, named: true })),
    }
}

fn described(placed: &Placed) -> String {
    let [generators, crossings] = [placed.pair.generators.len(), placed.pair.crossings.len()];
    let turned = if placed.is_turned() { ", turned about the vertical axis" } else { "" };
    let upright = match placed.upright.len() {
        0 => String::new(),
        count => format!(" {count} more point straight up and have no line."),
    };
    format!(
        "The lines of {generators} generators{turned}, numbered in their order, with {crossings} crossings.{upright}"
    )
}

fn described_hull(polygon: &Polygon) -> String {
    format!("The convex hull of the points has {} vertices.", polygon.vertices().len())
}

fn page(title: &str, placed: &Placed) -> Scene {
    let mut scene = Scene::new(WINDOW.max.x + 40.0, WINDOW.max.y + 64.0, title, &described(placed));
    scene.heading(PagePoint::new(WINDOW.center().x, 26.0), title);
    scene
}

fn finished(mut scene: Scene, line: &str, left: &str, separator: Option<Separator>) -> String {
    let mut entries = vec![LegendEntry::new(Sample::Line(generator_stroke(0)), line)];
    if separator.is_some() {
        entries.push(LegendEntry::new(Sample::Area(Paint::fill(FOCUS, 0.3)), left));
        entries.push(LegendEntry::new(Sample::Line(Stroke::new(INK, weight::STRONG)), "separator"));
    }
    scene.legend(PagePoint::new(WINDOW.min.x, WINDOW.max.y + 28.0), WINDOW.width(), &entries);
    scene.finish()
}

#[cfg(test)]
mod tests {
    use super::*;

    const GENERATORS: [[f64; 3]; 4] = [[7.0, 2.0, 12.0], [4.0, 6.0, 5.0], [-3.0, 8.0, 0.0], [-8.0, 5.0, 2.0]];
    const POINTS: [[f64; 2]; 5] = [[0.0, 32.0], [8.0, 10.0], [66.0, 2.0], [86.0, 40.0], [38.0, 66.0]];

    /// Every crossing has its number in the picture of the lines and in that of the tiles.
    #[test]
    fn crossings_and_tiles_have_the_same_numbers() {
        for drawn in [arrangement("a", &GENERATORS, Some(2)), tiling("a", &GENERATORS, Some(2))] {
            let svg = drawn.expect("four generators have room");
            assert!((1..=6).all(|number| svg.contains(&format!(">{number}</"))), "{svg}");
        }
        assert_eq!(separator_sweep("a", &GENERATORS).expect("few").matches(">k<").count(), 7);
    }

    #[test]
    fn searches_do_not_depend_on_the_unit() {
        let scaled: Vec<[f64; 2]> = POINTS.iter().map(|p| p.map(|c| 1024.0 * c + 4096.0)).collect();
        assert_eq!(search_for_center("p", &POINTS), search_for_center("p", &scaled));
        assert_eq!(zonogon("p", &POINTS), zonogon("p", &scaled));
        let inside = search_for_point("a", &GENERATORS, [1.0, 2.0, 3.0]).expect("four generators have room");
        assert!(inside.contains("The tile of generators"), "{inside}");
        let beside = search_for_point("a", &GENERATORS, [100.0, 2.0, 3.0]).expect("four generators have room");
        assert!(beside.contains("No tile") && !beside.contains("The tile of generators"));
    }

    #[test]
    fn data_without_a_picture_say_why() {
        let complaint = |drawn: Result<String, OwnDataError>| drawn.expect_err("no picture").to_string();
        let many: Vec<[f64; 3]> = (0..9).map(|i| [f64::from(i), 1.0, f64::from(i * i)]).collect();
        assert_eq!(complaint(separator_sweep("a", &many)), "9 generators, at most 7 have room in this picture");
        assert_eq!(complaint(tiling("a", &GENERATORS, Some(7))), "there is no separator 7; they are 0 to 6");
        assert!(complaint(tiling("a", &[], None)).starts_with("no two generators have lines that cross"));
        assert!(complaint(zonogon("p", &POINTS[..2])).starts_with("the points lie on a line"));
        assert!(complaint(zonogon("p", &[])).starts_with("there are no points"));
        let huge = [[1e200, 0.0, 1.0], [0.0, 1e200, 1.0]];
        assert!(complaint(tiling("a", &huge, None)).contains("which is not drawn"));
    }
}
