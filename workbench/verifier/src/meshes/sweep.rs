//! Pairs of boxes that are near each other, by a sweep along the axis along which they spread most.

use dashu_int::IBig;

use super::triangles::{Point, Triangle};

/// A triangle with the ends of its box.
pub(super) struct Boxed {
    pub(super) triangle: Triangle,
    low: Point,
    high: Point,
}

impl Boxed {
    pub(super) fn new(triangle: Triangle) -> Self {
        let end = |axis: usize, is_high: bool| {
            let along = triangle.iter().map(|corner| &corner[axis]);
            let end = if is_high { along.max() } else { along.min() };
            end.cloned().unwrap_or(IBig::ZERO)
        };
        let (low, high) = ([0, 1, 2].map(|axis| end(axis, false)), [0, 1, 2].map(|axis| end(axis, true)));
        Self { triangle, low, high }
    }

    /// Whether the boxes are apart by more than a distance along no axis.
    fn is_near(&self, other: &Self, reach: &IBig) -> bool {
        (0..3).all(|k| self.low[k] <= &other.high[k] + reach && other.low[k] <= &self.high[k] + reach)
    }
}

/// Calls `visit` with the positions of every pair of boxes that are no farther apart than `reach` along any axis, until
/// it says that it is done.
pub(super) fn near_pairs<E>(
    a: &[Boxed],
    b: &[Boxed],
    reach: &IBig,
    mut visit: impl FnMut([usize; 2]) -> Result<(), E>,
) -> Result<(), E> {
    let axis = widest_axis(a, b);
    let order = |list: &[Boxed]| {
        let mut order: Vec<usize> = (0..list.len()).collect();
        order.sort_by(|&i, &j| list[i].low[axis].cmp(&list[j].low[axis]));
        order
    };
    let (of_a, of_b) = (order(a), order(b));
    let (mut next_a, mut next_b) = (0, 0);
    let mut open: [Vec<usize>; 2] = [Vec::new(), Vec::new()];
    while next_a < of_a.len() || next_b < of_b.len() {
        let is_first = match (of_a.get(next_a), of_b.get(next_b)) {
            (Some(&i), Some(&j)) => a[i].low[axis] <= b[j].low[axis],
            (first, _) => first.is_some(),
        };
        if is_first {
            let i = of_a[next_a];
            next_a += 1;
            open[1].retain(|&j| &b[j].high[axis] + reach >= a[i].low[axis]);
            open[1].iter().filter(|&&j| a[i].is_near(&b[j], reach)).try_for_each(|&j| visit([i, j]))?;
            open[0].push(i);
        } else {
            let j = of_b[next_b];
            next_b += 1;
            open[0].retain(|&i| &a[i].high[axis] + reach >= b[j].low[axis]);
            open[0].iter().filter(|&&i| a[i].is_near(&b[j], reach)).try_for_each(|&i| visit([i, j]))?;
            open[1].push(j);
        }
    }
    Ok(())
}

/// The axis along which the boxes spread most.
fn widest_axis(a: &[Boxed], b: &[Boxed]) -> usize {
    let spread = |axis: usize| {
        let all = || a.iter().chain(b);
        let low = all().map(|boxed| &boxed.low[axis]).min();
        all().map(|boxed| &boxed.high[axis]).max().zip(low).map(|(high, low)| high - low)
    };
    (0..3).max_by_key(|&axis| spread(axis)).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_pairs_are_those_of_all_pairs() {
        let corner =
            |seed: i32, k: i32| [0, 1, 2].map(|axis| IBig::from((seed * 7919 + k * 104_729 + axis * 1299) % 97));
        let boxes = |from: i32| -> Vec<Boxed> {
            let triangle = |seed: i32| [corner(seed, 0), corner(seed + 1, 0), corner(seed + 1, 1)];
            (from..from + 25).map(|seed| Boxed::new(triangle(seed))).collect()
        };
        let (a, b) = (boxes(0), boxes(40));
        for reach in [0, 3, 30] {
            let reach = IBig::from(reach);
            let mut found = Vec::new();
            let visited: Result<(), ()> = near_pairs(&a, &b, &reach, |pair| {
                found.push(pair);
                Ok(())
            });
            found.sort_unstable();
            let end = |boxed: &Boxed, axis: usize, is_high: bool| {
                let mut along = boxed.triangle.each_ref().map(|corner| corner[axis].clone());
                along.sort();
                along[if is_high { 2 } else { 0 }].clone()
            };
            let gap = |i: usize, j: usize, axis| {
                (end(&a[i], axis, false) - end(&b[j], axis, true)).max(end(&b[j], axis, false) - end(&a[i], axis, true))
            };
            let is_near = |&[i, j]: &[usize; 2]| (0..3).all(|axis| gap(i, j, axis) <= reach);
            let all: Vec<[usize; 2]> = (0..25).flat_map(|i| (0..25).map(move |j| [i, j])).filter(is_near).collect();
            assert_eq!((visited, found), (Ok(()), all));
        }
    }

    #[test]
    fn the_sweep_is_along_the_axis_of_the_widest_spread() {
        let at = |x: i32, y: i32, z: i32| Boxed::new([0, 1, 1].map(|step| [x + step, y, z].map(IBig::from)));
        assert_eq!(widest_axis(&[at(-5, 0, 0)], &[at(5, 3, 9)]), 0);
        assert_eq!(widest_axis(&[at(0, -7, 0), at(0, 4, 0)], &[at(5, 3, 9)]), 1);
        assert_eq!(widest_axis(&[at(90, 90, -6)], &[at(95, 93, 5)]), 2);
    }

    /// Boxes with small whole ends, so that many are just as far apart as the reach, held to a look at all pairs.
    #[test]
    fn near_pairs_of_small_boxes_are_those_of_all_pairs() {
        let mut state = 5_u64;
        let mut next = |range: u64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) % range
        };
        for round in 0..200 {
            let mut ends = |from: u64| -> Vec<[[i64; 3]; 2]> {
                let mut ends = || {
                    let low = [0; 3].map(|_| (from + next(8)) as i64);
                    [low, low.map(|low| low + next(4) as i64)]
                };
                (0..5).map(|_| ends()).collect()
            };
            // One of the lists begins farther along all axes every other time.
            let (a, b) = (ends([0, 4][round % 2]), ends([0, 4, 0][round % 3]));
            let boxes = |ends: &[[[i64; 3]; 2]]| -> Vec<Boxed> {
                let corner = |end: &[i64; 3]| end.map(IBig::from);
                ends.iter().map(|[low, high]| Boxed::new([corner(high), corner(low), corner(high)])).collect()
            };
            for reach in 0..4 {
                let mut found = Vec::new();
                let visited: Result<(), ()> = near_pairs(&boxes(&a), &boxes(&b), &IBig::from(reach), |pair| {
                    found.push(pair);
                    Ok(())
                });
                found.sort_unstable();
                let is_near = |&[i, j]: &[usize; 2]| {
                    (0..3).all(|k| a[i][0][k] - b[j][1][k] <= reach && b[j][0][k] - a[i][1][k] <= reach)
                };
                let all: Vec<[usize; 2]> = (0..5).flat_map(|i| (0..5).map(move |j| [i, j])).filter(is_near).collect();
                assert_eq!((visited, found), (Ok(()), all), "{a:?} {b:?} {reach}");
            }
        }
    }
}
