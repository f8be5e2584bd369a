//! The farthest of many points along each of several normals, with the points read from memory once.

use crate::numeric::linear::dot;

/// The number of points that are looked at together: their coordinates stay in the cache while all normals pass over
/// them.
const BLOCK: usize = 256;

/// The number of heights that are compared side by side.
const LANES: usize = 8;

/// A point and its height along a normal.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Far {
    pub(crate) height: f64,
    pub(crate) point: usize,
}

/// For each normal the lowest and the highest of the points at some places; where several points are equally far, the
/// first of them. O(n) for each normal, in one pass over the points.
pub(crate) fn farthest<const D: usize>(
    points: &[[f64; D]],
    mut places: impl Iterator<Item = usize>,
    normals: &[[f64; D]],
) -> Vec<[Far; 2]> {
    let none = |height| Far { height, point: 0 };
    let mut found = vec![[none(f64::INFINITY), none(f64::NEG_INFINITY)]; normals.len()];
    let mut columns = [[0.0; BLOCK]; D];
    let mut block = Vec::with_capacity(BLOCK);
    loop {
        block.clear();
        block.extend(places.by_ref().take(BLOCK));
        let Some(&first) = block.first() else { return found };
        for i in 0..BLOCK {
            // Copies of its first point fill up the last block.
            let point = &points[block.get(i).copied().unwrap_or(first)];
            for (column, c) in columns.iter_mut().zip(point) {
                column[i] = *c;
            }
        }
        for (normal, [low, high]) in normals.iter().zip(&mut found) {
            let (least, most) = range(&columns, normal);
            let place = |height: f64| block.iter().copied().find(|&j| dot(normal, &points[j]) == height);
            if least < low.height {
                *low = Far { height: least, point: place(least).unwrap_or(first) };
            }
            if most > high.height {
                *high = Far { height: most, point: place(most).unwrap_or(first) };
            }
        }
    }
}

/// The least and the largest height of a block.
fn range<const D: usize>(columns: &[[f64; BLOCK]; D], normal: &[f64; D]) -> (f64, f64) {
    let (mut least, mut most) = ([f64::INFINITY; LANES], [f64::NEG_INFINITY; LANES]);
    for at in (0..BLOCK).step_by(LANES) {
        let mut heights = [0.0; LANES];
        for (column, n) in columns.iter().zip(normal) {
            for (height, c) in heights.iter_mut().zip(&column[at..at + LANES]) {
                *height += n * c;
            }
        }
        for lane in 0..LANES {
            least[lane] = if heights[lane] < least[lane] { heights[lane] } else { least[lane] };
            most[lane] = if heights[lane] > most[lane] { heights[lane] } else { most[lane] };
        }
    }
    (least.into_iter().fold(f64::INFINITY, f64::min), most.into_iter().fold(f64::NEG_INFINITY, f64::max))
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::{RngExt, SeedableRng};

    #[test]
    fn the_first_of_the_farthest() {
        let mut rng = rand_pcg::Pcg64::seed_from_u64(9);
        let points: Vec<[f64; 3]> =
            (0..3 * BLOCK + 17).map(|_| std::array::from_fn(|_| f64::from(rng.random_range(-9..10i32)))).collect();
        let normals = [[1.0, 0.0, 0.0], [1.0, -2.0, 0.5], [0.0, 0.0, 0.0]];
        let odd = (0..points.len()).filter(|j| j % 2 == 1);
        for (normal, [low, high]) in normals.iter().zip(farthest(&points, odd.clone(), &normals)) {
            let (mut least, mut most) = ((f64::INFINITY, 0), (f64::NEG_INFINITY, 0));
            for j in odd.clone() {
                let height = dot(normal, &points[j]);
                least = if height < least.0 { (height, j) } else { least };
                most = if height > most.0 { (height, j) } else { most };
            }
            assert_eq!((low.height, low.point, high.height, high.point), (least.0, least.1, most.0, most.1));
        }
    }
}
