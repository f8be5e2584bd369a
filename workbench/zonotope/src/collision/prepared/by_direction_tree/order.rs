//! The order of generators in which those of neighbouring directions are neighbours: that of a k-d tree over the
//! directions.
//!
//! A generator v ≠ 0 with its largest coordinate along the axis k, turned such that v_k > 0, has its direction on the
//! face u_k = 1 of the cube, at the two other coordinates of v / v_k. On each face the generators are halved by a line
//! across the longer side of the box of their places, and the halves again, until a leaf is full. All halves but the
//! last one are full powers of two, so that the nodes of the tree are the runs of equal length of the list: no node
//! needs a pointer.

use std::ops::Range;

use crate::zonotope::directions::cube_faces::{face_of, place_on};

/// Generators of a leaf.
pub(super) const LEAF: usize = 64;

/// Generators in the order of the tree.
#[derive(Debug)]
pub(super) struct Ordered {
    /// The generators, each turned such that its largest coordinate is positive.
    pub(super) rows: Vec<[f64; 3]>,
    /// The index of each in the list that was ordered.
    pub(super) places: Vec<u32>,
    /// Whether it was turned.
    pub(super) is_turned: Vec<bool>,
    /// The rows of each face; the zero vectors are after those of the last.
    pub(super) faces: [Range<usize>; 3],
}

/// The place of a generator on its face, and its index.
#[derive(Debug, Clone, Copy)]
struct Place {
    on_face: [f64; 2],
    index: u32,
}

impl Ordered {
    /// Orders generators by their directions. O(n log n).
    pub(super) fn new(generators: &[[f64; 3]]) -> Self {
        let mut own: [Vec<Place>; 3] = Default::default();
        let mut zeros = Vec::new();
        for (v, index) in generators.iter().zip(0..) {
            match face_of(v) {
                Some(face) => own[face].push(Place { on_face: place_on(face, v), index }),
                None => zeros.push(index),
            }
        }
        let mut places = Vec::with_capacity(generators.len());
        let faces = own.map(|mut own| {
            let capacity = (LEAF * own.len().div_ceil(LEAF).max(1)).next_power_of_two();
            halve(&mut own, capacity);
            let start = places.len();
            places.extend(own.iter().map(|place| place.index));
            start..places.len()
        });
        places.extend(zeros);
        let turned = |&index: &u32| {
            let v = generators[index as usize];
            face_of(&v).is_some_and(|face| v[face] < 0.0)
        };
        let is_turned: Vec<bool> = places.iter().map(turned).collect();
        let row = |(&index, &turn): (&u32, &bool)| generators[index as usize].map(|c| if turn { -c } else { c });
        Self { rows: places.iter().zip(&is_turned).map(row).collect(), places, is_turned, faces }
    }
}

/// Brings the places of a node into the order of its leaves; `capacity` is LEAF times a power of two and at least their
/// number.
fn halve(places: &mut [Place], capacity: usize) {
    if places.len() <= LEAF {
        return;
    }
    let half = capacity / 2;
    if places.len() <= half {
        return halve(places, half);
    }
    let Some(axis) = longer_side(places) else { return };
    places.select_nth_unstable_by(half, |a, b| a.on_face[axis].total_cmp(&b.on_face[axis]));
    let (first, second) = places.split_at_mut(half);
    halve(first, half);
    halve(second, half);
}

/// The longer side of the box of some places; none where all are one.
fn longer_side(places: &[Place]) -> Option<usize> {
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for place in places {
        for k in 0..2 {
            low[k] = low[k].min(place.on_face[k]);
            high[k] = high[k].max(place.on_face[k]);
        }
    }
    let sides = [high[0] - low[0], high[1] - low[1]];
    let longer = usize::from(sides[1] > sides[0]);
    (sides[longer] > 0.0).then_some(longer)
}
