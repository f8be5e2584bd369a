//! Candidates in counter-clockwise order around the hull: a bucket sort, then Graham's scan in place.

use std::cmp::Ordering;

use super::bounds::Bounds;
use super::columns::Columns;
use crate::hull::polygon::{ConvexHull, PointIndex};
use crate::hull::sites::Site;
use crate::numeric::orientation::{Turn, orientation_counted};
use crate::tally::{Operation, Tally};

/// Points that may be vertices of the hull.
pub(super) struct Candidates<'a, F> {
    pub(super) points: &'a [[f64; 2]],
    /// How many positions there are.
    pub(super) count: usize,
    /// The positions of the candidates, increasing; those of all vertices are among them.
    pub(super) positions: F,
}

impl<I: Iterator<Item = u32>, F: Fn() -> I> Candidates<'_, F> {
    fn sites(&self) -> impl Iterator<Item = Site> {
        (self.positions)().map(|at| Site { point: self.points[at as usize], index: PointIndex::new(at as usize) })
    }

    /// The hull of the candidates.
    pub(super) fn hull(&self, bounds: &Bounds, columns: Columns, tally: &mut impl Tally) -> ConvexHull {
        tally.add(Operation::PointRead, 3 * self.count as u64);
        let [first, last] = self.ends(bounds);
        // the first point, the columns below from left to right, the last point, the columns above from right to left
        let turning = 1 + columns.count();
        let dropped = 2 * turning;
        let mut bounds_of_buckets = vec![0_u32; dropped + 1];
        let mut buckets = Vec::with_capacity(self.count);
        for site in self.sites() {
            let column = columns.of(site.point[0]);
            let turn = orientation_counted(first.point, last.point, site.point, tally);
            let mut bucket = if turn == Turn::Left { dropped - 1 - column } else { 1 + column };
            if turn == Turn::Straight {
                bucket = match site.index {
                    index if index == first.index => 0,
                    index if index == last.index => turning,
                    _ => dropped,
                };
            }
            bounds_of_buckets[bucket] += 1;
            buckets.push(bucket as u32);
        }
        let mut total = 0;
        for bound in &mut bounds_of_buckets {
            (*bound, total) = (total, total + *bound);
        }
        let mut ring = Ring { points: vec![[0.0; 2]; self.count], indices: vec![PointIndex::new(0); self.count] };
        for (site, bucket) in self.sites().zip(buckets) {
            let slot = &mut bounds_of_buckets[bucket as usize];
            ring.put(*slot as usize, site);
            *slot += 1;
        }
        // each bound was moved from the start of its bucket to its end
        let mut start = 0;
        for (bucket, &end) in bounds_of_buckets[..dropped].iter().enumerate() {
            if bucket < turning {
                ring.sort(start, end as usize, Site::precedes);
            } else {
                ring.sort(start, end as usize, Site::precedes_backwards);
            }
            start = end as usize;
        }
        ring.truncate(start);
        ring.into_hull(tally)
    }

    /// The first and the last candidate in lexicographic order, of equal ones the first in the input.
    fn ends(&self, bounds: &Bounds) -> [Site; 2] {
        let mut ends = [None; 2];
        for site in self.sites() {
            let [x, y] = site.point;
            if x == bounds.low[0] && ends[0].is_none_or(|first: Site| y < first.point[1]) {
                ends[0] = Some(site);
            }
            if x == bounds.high[0] && ends[1].is_none_or(|last: Site| last.point[1] < y) {
                ends[1] = Some(site);
            }
        }
        ends.map(|end| end.expect("because vertices of the hull lie on the left and on the right side of its box"))
    }
}

/// Points with their positions in the input, as two arrays that become the answer.
struct Ring {
    points: Vec<[f64; 2]>,
    /// As long as `points`.
    indices: Vec<PointIndex>,
}

/// Buckets up to this size are sorted in place.
const SMALL_BUCKET: usize = 24;

impl Ring {
    #[inline]
    fn site(&self, at: usize) -> Site {
        Site { point: self.points[at], index: self.indices[at] }
    }

    #[inline]
    fn put(&mut self, at: usize, site: Site) {
        self.points[at] = site.point;
        self.indices[at] = site.index;
    }

    #[inline]
    fn sort(&mut self, start: usize, end: usize, precedes: impl Fn(&Site, &Site) -> bool) {
        if end - start > SMALL_BUCKET {
            let mut sites: Vec<Site> = (start..end).map(|at| self.site(at)).collect();
            // indices differ, so no two sites are equal
            sites.sort_unstable_by(|a, b| if precedes(a, b) { Ordering::Less } else { Ordering::Greater });
            for (at, site) in (start..).zip(sites) {
                self.put(at, site);
            }
            return;
        }
        for next in start + 1..end {
            let site = self.site(next);
            let mut hole = next;
            while hole > start && precedes(&site, &self.site(hole - 1)) {
                self.put(hole, self.site(hole - 1));
                hole -= 1;
            }
            self.put(hole, site);
        }
    }

    fn truncate(&mut self, count: usize) {
        self.points.truncate(count);
        self.indices.truncate(count);
    }

    /// Graham's scan; the stack overwrites what was read. The last point in lexicographic order is never popped: it is
    /// a vertex, so the boundary turns left there.
    fn into_hull(mut self, tally: &mut impl Tally) -> ConvexHull {
        let first = self.points[0];
        let (mut before_top, mut top) = (first, first);
        let mut count = 1_usize;
        for next in 1..self.points.len() {
            let site = self.site(next);
            if site.point == top {
                continue;
            }
            while count > 1 && orientation_counted(before_top, top, site.point, tally) != Turn::Left {
                count -= 1;
                (before_top, top) = (self.points[count.saturating_sub(2)], before_top);
            }
            self.put(count, site);
            count += 1;
            (before_top, top) = (top, site.point);
        }
        while count > 2
            && orientation_counted(self.points[count - 2], self.points[count - 1], first, tally) != Turn::Left
        {
            count -= 1;
        }
        self.truncate(count);
        if count < self.points.capacity() / 2 {
            self.points.shrink_to_fit();
            self.indices.shrink_to_fit();
        }
        ConvexHull::from_parts(self.points, self.indices)
    }
}
