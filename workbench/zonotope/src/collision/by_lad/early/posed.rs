//! Passes over the generators of bodies under poses.

use std::ops::Range;

use crate::collision::by_lad::early::passes::{Carried, EarlyQuery, Passes, Runs};
use crate::collision::{PosedQuery, Query};
use crate::lad::of_generators::seam::linear_map::LinearMap;
use crate::numeric::bounded::{Bounded, BoundedVector};
use crate::numeric::lanes::bounded_sum_near;
use crate::numeric::lanes::rows::Rows;

/// A query about posed bodies whose matrices have entries of moderate size.
#[derive(Debug)]
pub(crate) struct PosedRows<'a> {
    p: BoundedVector,
    runs: Runs<'a>,
    maps: [LinearMap<'a>; 2],
}

impl<'a> PosedRows<'a> {
    /// The query with its matrices; `None` if an entry of one is too large, or all are too small or zero.
    #[inline]
    pub(crate) fn new(query: &'a PosedQuery<'_>) -> Option<Self> {
        let [from, to] = query.own_poses();
        let maps = [LinearMap::of(from), LinearMap::of(to)];
        let is_moderate = maps[0].is_moderate() && maps[1].is_moderate();
        is_moderate.then(|| Self { p: query.displacement_estimate(), runs: query.rows(), maps })
    }
}

impl Passes for PosedRows<'_> {
    #[inline(always)]
    fn rows(&self) -> Runs<'_> {
        self.runs
    }

    #[inline(always)]
    fn over<const K: usize, T: Carried>(
        &self,
        directions: [&[f64; 3]; K],
        mut pass: impl FnMut(Runs<'_>, Range<usize>, [[f64; 3]; K]) -> T,
    ) -> T {
        let [own, other] = &self.maps;
        let places = self.runs[0].len();
        let first = pass([self.runs[0], Rows::NONE], 0..places, directions.map(|u| own.pulled(u))).carried(own);
        if self.runs[1].is_empty() {
            return first;
        }
        let second = pass([self.runs[1], Rows::NONE], places..self.count(), directions.map(|u| other.pulled(u)));
        first.joined(second.carried(other))
    }
}

impl EarlyQuery for PosedRows<'_> {
    fn displacement_in_doubles(&self) -> BoundedVector {
        self.p
    }

    #[inline]
    fn vector(&self, index: usize) -> BoundedVector {
        let (map, v) = match index.checked_sub(self.runs[0].len()) {
            None => (&self.maps[0], &self.runs[0].list()[index]),
            Some(index) => (&self.maps[1], &self.runs[1].list()[index]),
        };
        map.bounded_image(v)
    }

    fn reach(&self, u: &[f64; 3]) -> Bounded {
        let of = |i: usize| {
            let map = &self.maps[i];
            bounded_sum_near(self.runs[i], &map.pulled(u), map.pulled_size(u))
        };
        if self.runs[1].is_empty() { of(0) } else { of(0) + of(1) }
    }

    fn picked(&self, capacity: usize, pick: impl Fn(&[[f64; 3]], &mut Vec<[f64; 3]>)) -> Vec<[f64; 3]> {
        let mut picked = Vec::with_capacity(capacity);
        for (run, map) in self.runs.iter().zip(&self.maps) {
            let start = picked.len();
            pick(run.list(), &mut picked);
            picked[start..].iter_mut().for_each(|v| *v = map.image(v));
        }
        picked
    }

    fn as_rows(&self) -> Option<Query<'_, 3>> {
        None
    }
}
