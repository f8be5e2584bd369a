//! The crossings of the lines with their numbers: each in a sign of its own, or, where signs would lie upon each other,
//! as dots with the numbers of all of them beside.

use crate::scene::page::PagePoint;
use crate::scene::text::{Anchor, TextStyle};
use crate::scene::{Panel, Scene};
use crate::style::{Color, FOCUS, GREY, INK, Marker, PAPER, Shape, text_size};

const LEFT: Marker = Marker::new(Shape::Disc, 9.0, FOCUS.mixed(PAPER, 110));
const RIGHT: Marker = Marker::new(Shape::Ring, 9.0, GREY);

/// The radius of a dot.
const DOT: f64 = 3.0;

/// The colours of dots on the left and on the right.
const DOTS: [Color; 2] = [FOCUS, GREY];

/// The number of crossings up to which signs and numbers have their full size; beyond it, three quarters of that.
const FULL_SIZE_LIMIT: usize = 15;

/// Draws the crossings at these places, numbered in their order, the first of them as those on the left.
pub(super) fn draw(panel: &mut Panel, places: &[[f64; 2]], left: usize) {
    let size = if places.len() > FULL_SIZE_LIMIT { 0.75 } else { 1.0 };
    let on_page: Vec<PagePoint> = places.iter().map(|&place| panel.place(place)).collect();
    for cluster in clusters(&on_page, 2.0 * LEFT.radius * size) {
        if let [index] = cluster[..] {
            let marker = if index < left { LEFT } else { RIGHT };
            panel.marker(places[index], &Marker { radius: marker.radius * size, ..marker });
            write_number(panel.scene(), on_page[index], index, size);
        } else {
            for &index in &cluster {
                panel.marker(places[index], &Marker::new(Shape::Disc, DOT, DOTS[usize::from(index >= left)]));
            }
            name(panel.scene(), &on_page, &cluster);
        }
    }
}

/// Writes the number of a crossing, counted from 1.
pub(super) fn write_number(scene: &mut Scene, place: PagePoint, index: usize, size: f64) {
    let style = TextStyle::new((11.0 * size).max(text_size::LEAST), INK);
    scene.text(place.moved(0.0, 4.0 * size), Anchor::Middle, &style, &(index + 1).to_string());
}

/// Half the width and half the height of the number of a crossing.
pub(super) fn number_box(index: usize, size: f64) -> [f64; 2] {
    let (digits, height) = ((index + 1).to_string().len() as f64, (11.0 * size).max(text_size::LEAST));
    [0.32 * height * digits, 0.37 * height]
}

/// Writes the numbers of a cluster beside its middle.
fn name(scene: &mut Scene, places: &[PagePoint], cluster: &[usize]) {
    let middle = |coordinate: fn(&PagePoint) -> f64| {
        cluster.iter().map(|&index| coordinate(&places[index])).sum::<f64>() / cluster.len() as f64
    };
    let style = TextStyle::new(text_size::LEAST, INK);
    scene.label(PagePoint::new(middle(|p| p.x), middle(|p| p.y)), [1.0, 0.3], &style, &in_ranges(cluster));
}

/// The places of which each is nearer than the distance to another one of its cluster, in order.
fn clusters(places: &[PagePoint], distance: f64) -> Vec<Vec<usize>> {
    let mut cluster_of: Vec<usize> = (0..places.len()).collect();
    for (index, a) in places.iter().enumerate() {
        for (earlier, b) in places[..index].iter().enumerate() {
            let (x, y) = (a.x - b.x, a.y - b.y);
            if x * x + y * y < distance * distance {
                let (from, to) = (cluster_of[index], cluster_of[earlier]);
                let joined = from.min(to);
                cluster_of.iter_mut().filter(|cluster| [from, to].contains(cluster)).for_each(|c| *c = joined);
            }
        }
    }
    let members = |first: usize| (first..places.len()).filter(|&index| cluster_of[index] == first).collect::<Vec<_>>();
    (0..places.len()).map(members).filter(|cluster| !cluster.is_empty()).collect()
}

/// Numbers that count from 1, with runs of them as ranges: `1–4, 6`.
fn in_ranges(indices: &[usize]) -> String {
    let mut ranges: Vec<[usize; 2]> = Vec::new();
    for &index in indices {
        match ranges.last_mut() {
            Some([_, end]) if *end + 1 == index => *end = index,
            _ => ranges.push([index; 2]),
        }
    }
    let written: Vec<String> = ranges
        .iter()
        .map(|[from, to]| if from == to { format!("{}", from + 1) } else { format!("{}–{}", from + 1, to + 1) })
        .collect();
    written.join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_that_lie_close_are_one_cluster() {
        let places = [[0.0, 0.0], [5.0, 0.0], [30.0, 0.0], [9.0, 0.0], [31.0, 3.0], [99.0, 0.0]];
        let places = places.map(|[x, y]| PagePoint::new(x, y));
        assert_eq!(clusters(&places, 6.0), [vec![0, 1, 3], vec![2, 4], vec![5]]);
        assert_eq!(clusters(&places, 1.0).len(), 6);
    }

    #[test]
    fn runs_of_numbers_are_ranges() {
        assert_eq!(in_ranges(&[0, 1, 3]), "1–2, 4");
        assert_eq!(in_ranges(&[2, 3, 4, 5]), "3–6");
    }
}
