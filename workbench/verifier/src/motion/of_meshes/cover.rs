//! Whether boxes hold every point of a box.
//!
//! The box is cut in two at a bound of one of the boxes that meet it, until one of them holds all of what is left or
//! none meets it. The cut goes through as few boxes as can be, and leaves as many on either side. The boxes of a
//! hierarchy that was descended can be cut apart without going through any, so that their number does not grow.

use crate::verdict::Stop;

/// A box: each coordinate goes from the first number to below the second.
pub(super) type Cell = [[f64; 2]; 3];

/// The work on one box: a box that meets a part of it is one.
const MOST_WORK: usize = 20_000_000;

/// A cut across an axis, with the boxes that it goes through and those on the fuller side.
struct Cut {
    axis: usize,
    at: f64,
    cost: [usize; 2],
}

/// The first corner of a part of the box that none of the boxes meets, if there is one.
pub(super) fn left_out(whole: Cell, boxes: Vec<Cell>) -> Result<Option<[f64; 3]>, Stop> {
    let mut work = MOST_WORK;
    let mut open = vec![(whole, boxes)];
    while let Some((cell, mut near)) = open.pop() {
        let is_near = |other: &Cell| other.iter().zip(&cell).all(|(o, c)| o[0] < c[1] && c[0] < o[1]);
        let is_around = |other: &Cell| other.iter().zip(&cell).all(|(o, c)| o[0] <= c[0] && c[1] <= o[1]);
        near.retain(is_near);
        let too_much =
            || Stop::Unchecked("that the intervals hold all pairs of triangles takes too much work".to_owned());
        work = work.checked_sub(near.len() + 1).ok_or_else(too_much)?;
        if cell.iter().any(|[from, to]| from >= to) || near.iter().any(is_around) {
            continue;
        }
        let Some(Cut { axis, at, .. }) = best_cut(&cell, &near) else { return Ok(Some(cell.map(|[from, _]| from))) };
        let [mut before, mut after] = [cell; 2];
        (before[axis][1], after[axis][0]) = (at, at);
        open.push((after, near.clone()));
        open.push((before, near));
    }
    Ok(None)
}

fn best_cut(cell: &Cell, near: &[Cell]) -> Option<Cut> {
    let cuts = (0..cell.len()).flat_map(|axis| {
        let sorted = |end: usize| {
            let mut ends: Vec<f64> = near.iter().map(|other| other[axis][end]).collect();
            ends.sort_by(f64::total_cmp);
            ends
        };
        let [from, to] = [sorted(0), sorted(1)];
        let is_inside = |at: &f64| cell[axis][0] < *at && *at < cell[axis][1];
        let cut = |at: f64| {
            let before = from.partition_point(|begin| *begin < at);
            let after = to.len() - to.partition_point(|end| *end <= at);
            Cut { axis, at, cost: [before + after, before.max(after)] }
        };
        from.iter().chain(&to).copied().filter(is_inside).map(cut).min_by_key(|cut| cut.cost)
    });
    cuts.min_by_key(|cut| cut.cost)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::verdict::Stop;

    /// The boxes of a box that is cut some times, at places that a count makes.
    fn cut_apart(cell: Cell, cuts: u32, seed: u32, boxes: &mut Vec<Cell>) {
        let axis = (seed % 3) as usize;
        let [from, to] = cell[axis];
        let at = if axis == 2 { from + (to - from) / 2.0 } else { (from + (to - from) / 2.0).floor() };
        if cuts == 0 || at <= from {
            return boxes.push(cell);
        }
        for (end, next) in [(1, seed / 3 + 5), (0, seed / 2 + 11)] {
            let mut part = cell;
            part[axis][end] = at;
            cut_apart(part, cuts - 1, next, boxes);
        }
    }

    #[test]
    fn boxes_that_hold_a_box_do_so_no_longer_without_one_of_them() -> Result<(), Stop> {
        let whole = [[0.0, 40.0], [0.0, 9.0], [0.0, 1.0]];
        for seed in [7, 100, 4096] {
            let mut boxes = Vec::new();
            cut_apart(whole, 6, seed, &mut boxes);
            assert!(boxes.len() > 20);
            assert_eq!(left_out(whole, boxes.clone())?, None);
            for k in 0..boxes.len() {
                let mut fewer = boxes.clone();
                let without = fewer.swap_remove(k);
                assert_eq!(left_out(whole, fewer.clone())?, Some(without.map(|[from, _]| from)));
                // one that is narrower leaves the rest out
                let mut narrower = without;
                narrower[2][1] = without[2][1].next_down();
                fewer.push(narrower);
                let [a, b, _] = without.map(|[from, _]| from);
                assert_eq!(left_out(whole, fewer)?, Some([a, b, narrower[2][1]]));
            }
        }
        Ok(())
    }

    #[test]
    fn boxes_may_overlap_and_a_box_of_no_time_needs_none() -> Result<(), Stop> {
        let whole = [[0.0, 3.0], [0.0, 3.0], [0.0, 1.0]];
        let slab = |axis: usize, to: f64| {
            let mut slab = whole;
            slab[axis][1] = to;
            slab
        };
        assert_eq!(left_out(whole, vec![slab(0, 2.0), slab(1, 1.0)])?, Some([2.0, 1.0, 0.0]));
        let rest = [[1.0, 7.0], [0.0, 9.0], [-1.0, 2.0]];
        assert_eq!(left_out(whole, vec![slab(0, 2.0), slab(1, 1.0), rest])?, None);
        assert_eq!(left_out(slab(2, 0.0), Vec::new())?, None);
        Ok(())
    }

    #[test]
    fn a_cut_goes_through_few_boxes_and_leaves_as_many_on_either_side() {
        let cell = [[0.0, 8.0], [0.0, 1.0], [0.0, 1.0]];
        let cut = |ranges: &[[f64; 2]]| {
            let boxes: Vec<Cell> = ranges.iter().map(|&range| [range, cell[1], cell[2]]).collect();
            best_cut(&cell, &boxes).map(|Cut { axis, at, cost }| (axis, at, cost))
        };
        // Cuts at 1 and 2 go through no box; the one at 2 has two boxes on either side, and that at 1 three on one.
        assert_eq!(cut(&[[0.0, 1.0], [1.0, 2.0], [2.0, 4.0], [4.0, 8.0]]), Some((0, 2.0, [4, 2])));
        assert_eq!(cut(&[[0.0, 1.0], [1.0, 2.0], [2.0, 8.0]]), Some((0, 1.0, [3, 2])));
        // The cut at 1 has one box before and all four after it; at 5 all have begun, and two end after it.
        assert_eq!(cut(&[[0.0, 5.0], [1.0, 5.0], [2.0, 8.0], [3.0, 8.0]]), Some((0, 1.0, [5, 4])));
        // The box that goes beyond both ends is on either side of the cut.
        assert_eq!(cut(&[[-1.0, 9.0], [0.0, 3.0], [3.0, 8.0]]), Some((0, 3.0, [4, 2])));
        assert_eq!(cut(&[[-1.0, 9.0], [0.0, 8.0]]), None, "nothing ends inside");
    }

    #[test]
    fn boxes_that_only_touch_a_part_do_not_change_where_it_is_cut() -> Result<(), Stop> {
        let whole = [[0.0, 4.0], [0.0, 4.0], [0.0, 2.0]];
        // The cut at 3 of the first axis leaves the second box alone in the first part, and in the middle of it.
        let boxes = vec![[[3.0, 4.0], [2.0, 4.0], [0.0, 1.0]], [[0.0, 3.0], [0.0, 3.0], [0.0, 1.0]]];
        assert_eq!(left_out(whole, boxes)?, Some([0.0, 0.0, 1.0]));
        let boxes = vec![
            [[0.0, 4.0], [0.0, 1.0], [0.0, 2.0]],
            [[0.0, 3.0], [1.0, 4.0], [0.0, 1.0]],
            [[2.0, 4.0], [3.0, 4.0], [1.0, 2.0]],
        ];
        assert_eq!(left_out(whole, boxes)?, Some([3.0, 1.0, 0.0]));
        Ok(())
    }
}
