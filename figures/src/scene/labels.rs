//! Label placement: every label takes the candidate place with the least overlap.
//!
//! Candidates lie on rings around the anchor, in sixteen directions; near the wished direction and near the anchor is
//! preferred. Overlap with other labels, marked points, drawn lines and the edge of the page costs. Labels are placed
//! in order, then moved once more each, knowing all others. Deterministic: ties keep the earlier candidate.

use super::page::{PageBox, PagePoint};
use super::text::{Anchor, Line, TextStyle};

/// A label waiting for its place.
#[derive(Clone, Debug)]
pub(super) struct Request {
    pub(super) line: Line,
    pub(super) style: TextStyle,
    pub(super) anchor: PagePoint,
    /// The place where it would like to stand, seen from the anchor; zero if it does not care.
    pub(super) wish: [f64; 2],
    /// Distance from the anchor to the nearest point of the letters.
    pub(super) gap: f64,
}

/// The parts that labels should not cover.
#[derive(Clone, Copy, Debug)]
pub(super) enum Obstacle {
    /// A drawn line.
    Segment(PagePoint, PagePoint),
    /// A marked point, as the box around it, or fixed text.
    Solid(PageBox),
}

const RINGS: [f64; 4] = [1.0, 1.8, 2.8, 4.2];
/// cos and sin of multiples of 22.5 degrees.
const DIRECTIONS: [[f64; 2]; 16] = {
    const A: f64 = 0.923_879_532_511_286_7;
    const B: f64 = std::f64::consts::FRAC_1_SQRT_2;
    const C: f64 = 0.382_683_432_365_089_8;
    [
        [1.0, 0.0],
        [A, -C],
        [B, -B],
        [C, -A],
        [0.0, -1.0],
        [-C, -A],
        [-B, -B],
        [-A, -C],
        [-1.0, 0.0],
        [-A, C],
        [-B, B],
        [-C, A],
        [0.0, 1.0],
        [C, A],
        [B, B],
        [A, C],
    ]
};

/// The base line's left end for each label, in order.
pub(super) fn place(requests: &[Request], obstacles: &[Obstacle], page: &PageBox) -> Vec<PagePoint> {
    let mut placed: Vec<Option<(PagePoint, PageBox)>> = vec![None; requests.len()];
    for _round in 0..2 {
        for index in 0..requests.len() {
            placed[index] = None;
            placed[index] = Some(best_candidate(&requests[index], obstacles, &placed, page));
        }
    }
    placed.into_iter().flatten().map(|(base, _)| base).collect()
}

fn best_candidate(
    request: &Request,
    obstacles: &[Obstacle],
    placed: &[Option<(PagePoint, PageBox)>],
    page: &PageBox,
) -> (PagePoint, PageBox) {
    let at_origin = request.line.extent(PagePoint::new(0.0, 0.0), Anchor::Start, &request.style);
    let wish_length = (request.wish[0] * request.wish[0] + request.wish[1] * request.wish[1]).sqrt();
    let mut best: Option<(f64, PagePoint, PageBox)> = None;
    for (ring, factor) in RINGS.into_iter().enumerate() {
        for direction in DIRECTIONS {
            let gap = request.gap * factor;
            // The box's centre, so that the box clears the anchor by `gap` in this direction.
            let center = request
                .anchor
                .moved(direction[0] * (gap + at_origin.width() / 2.0), direction[1] * (gap + at_origin.height() / 2.0));
            let base = PagePoint::new(
                center.x - at_origin.width() / 2.0 - at_origin.min.x,
                center.y - at_origin.height() / 2.0 - at_origin.min.y,
            );
            let taken = PageBox { min: at_origin.min.moved(base.x, base.y), max: at_origin.max.moved(base.x, base.y) };
            let turned_away = if wish_length > 0.0 {
                1.0 - (direction[0] * request.wish[0] + direction[1] * request.wish[1]) / wish_length
            } else {
                0.0
            };
            let cost = 6.0 * turned_away + 7.0 * ring as f64 + crowding(&taken, obstacles, placed, page);
            if best.as_ref().is_none_or(|(least, ..)| cost < *least) {
                best = Some((cost, base, taken));
            }
        }
    }
    let (_, base, taken) = best.expect("there are candidates because both tables are non-empty");
    (base, taken)
}

fn crowding(taken: &PageBox, obstacles: &[Obstacle], placed: &[Option<(PagePoint, PageBox)>], page: &PageBox) -> f64 {
    let around = taken.inset(-1.5);
    let from_obstacles: f64 = obstacles
        .iter()
        .map(|obstacle| match obstacle {
            Obstacle::Segment(from, to) => around.clip(*from, *to).map_or(0.0, |(a, b)| 4.0 + distance(a, b)),
            Obstacle::Solid(solid) => 2.0 * around.shared_area(solid),
        })
        .sum();
    let from_labels: f64 = placed.iter().flatten().map(|(_, other)| 4.0 * around.shared_area(other)).sum();
    from_obstacles + from_labels + 20.0 * taken.area_outside(page)
}

fn distance(a: PagePoint, b: PagePoint) -> f64 {
    let (dx, dy) = (b.x - a.x, b.y - a.y);
    (dx * dx + dy * dy).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::style::INK;

    fn request(x: f64, y: f64) -> Request {
        Request {
            line: Line::parse("$P_1$"),
            style: TextStyle::new(12.0, INK),
            anchor: PagePoint::new(x, y),
            wish: [0.0, 0.0],
            gap: 5.0,
        }
    }

    fn boxes(requests: &[Request], places: &[PagePoint]) -> Vec<PageBox> {
        requests
            .iter()
            .zip(places)
            .map(|(request, &place)| request.line.extent(place, Anchor::Start, &request.style))
            .collect()
    }

    #[test]
    fn labels_of_close_points_stay_apart_and_on_the_page() {
        let page = PageBox::new(0.0, 0.0, 100.0, 100.0);
        let requests: Vec<Request> = (0..6).map(|i| request(2.0 + 10.0 * f64::from(i), 3.0)).collect();
        let taken = boxes(&requests, &place(&requests, &[], &page));
        for (i, a) in taken.iter().enumerate() {
            assert_eq!(a.area_outside(&page), 0.0, "label {i} leaves the page");
            for b in &taken[i + 1..] {
                assert_eq!(a.shared_area(b), 0.0);
            }
        }
    }

    #[test]
    fn a_wish_is_followed_when_there_is_room() {
        let page = PageBox::new(0.0, 0.0, 100.0, 100.0);
        let mut above = request(50.0, 50.0);
        above.wish = [0.0, -1.0];
        let places = place(std::slice::from_ref(&above), &[], &page);
        let taken = boxes(&[above], &places)[0];
        assert!(taken.max.y <= 45.5, "{taken:?}");
    }

    #[test]
    fn a_line_is_avoided() {
        let page = PageBox::new(0.0, 0.0, 100.0, 100.0);
        let mut label = request(50.0, 50.0);
        label.wish = [1.0, 0.0];
        let wall = Obstacle::Segment(PagePoint::new(60.0, 0.0), PagePoint::new(60.0, 100.0));
        let places = place(std::slice::from_ref(&label), &[wall], &page);
        let taken = boxes(&[label], &places)[0];
        assert!(taken.max.x < 60.0 || taken.min.x > 60.0, "{taken:?}");
    }
}
