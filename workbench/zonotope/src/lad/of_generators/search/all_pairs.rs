//! A few generators: h(u) / |u · p| at the normal of every pair of them, of which the least belongs to the optimum.
//!
//! With at most [`PAIRS_LIMIT`] generators that takes less than a search, which begins with a guess and goes from
//! vertex to vertex. Eight pairs are taken at a time, and each is i with i + d, round the list of generators: so both
//! of the eight are stretches of the list, written down often enough.

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use crate::lad::of_generators::cells::nested::NestedCells;
use crate::lad::of_generators::cells::reduced::Reduced;
use crate::lad::of_generators::certify::rounded_optimum::RoundedOptimum;
use crate::lad::of_generators::problem::Problem;
use crate::lad::of_generators::search::Searched;
use crate::numeric::lanes::level::level;
use crate::numeric::lanes::number::{Number, product};
use crate::numeric::lanes::octet::{LANES, Octet, splat};

/// At most this many generators are taken pair by pair.
pub(crate) const PAIRS_LIMIT: usize = 16;

/// Room for all generators, half of them once more, and the lanes that stand over.
const ROOM: usize = PAIRS_LIMIT + PAIRS_LIMIT / 2 + LANES;

/// How many groups of eight pairs are tried for so many generators.
pub(crate) fn groups_of_pairs(count: usize) -> usize {
    count / 2 * count.div_ceil(LANES)
}

/// The optimum of at least two generators, where it is certified and answers the question. O(n³).
pub(crate) fn best_pair(problem: &Problem<'_>) -> Option<Searched> {
    let reduced = Reduced::whole(problem.query);
    if reduced.vectors.len() < 2 {
        return None;
    }
    let pair = steepest(&reduced.vectors, &problem.p.map(|c| c.value));
    let optimum = RoundedOptimum::at(&[reduced], &problem.p, pair).ok()?;
    let is_answer = optimum.is_vertex() || problem.is_answered_by(&optimum);
    is_answer.then(|| Searched::Certified(optimum, NestedCells::default()))
}

/// The pair at whose normal |u · p| / h(u) is largest, as far as doubles tell; a generator with itself where no pair
/// has a normal, which no certificate accepts.
fn steepest(vectors: &[[f64; 3]], p: &[f64; 3]) -> [usize; 2] {
    let mut columns = [[0.0; ROOM]; 3];
    for (place, v) in vectors.iter().cycle().take(ROOM).enumerate() {
        for (column, c) in columns.iter_mut().zip(v) {
            column[place] = *c;
        }
    }
    let [first, step] = dispatch!(level(), simd => steepest_of_all(simd, vectors, &columns, p));
    [first % vectors.len(), (first + step) % vectors.len()]
}

/// The first generator of the best pair, counted round the list, and how far the second is from it.
#[inline(always)]
fn steepest_of_all<S: Simd>(simd: S, vectors: &[[f64; 3]], columns: &[[f64; ROOM]; 3], p: &[f64; 3]) -> [usize; 2] {
    let wide = splat(simd, p);
    let (mut best, mut found) = (f64x8::splat(simd, -1.0), f64x8::splat(simd, 0.0));
    for start in (0..vectors.len()).step_by(LANES) {
        let a = stretch(simd, columns, start);
        for step in 1..=vectors.len() / 2 {
            let b = stretch(simd, columns, start + step);
            let normal = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
            let mut reach = f64x8::splat(simd, 0.0);
            for v in vectors {
                reach += (normal[0] * v[0] + normal[1] * v[1] + normal[2] * v[2]).magnitude();
            }
            // not a number where the two are parallel: then it is no better
            let gauge = product(&normal, &wide).magnitude() / reach;
            found = best.if_less(gauge, f64x8::splat(simd, (start * ROOM + step) as f64), found);
            best = best.if_less(gauge, gauge, best);
        }
    }
    let mut lane = 0;
    for other in 1..LANES {
        if best[other] > best[lane] {
            lane = other;
        }
    }
    let code = found[lane] as usize;
    [code / ROOM + lane, code % ROOM]
}

/// Eight generators side by side, from a place on.
#[inline(always)]
fn stretch<S: Simd>(simd: S, columns: &[[f64; ROOM]; 3], start: usize) -> Octet<S> {
    let [x, y, z] = columns;
    let end = start + LANES;
    [
        f64x8::from_slice(simd, &x[start..end]),
        f64x8::from_slice(simd, &y[start..end]),
        f64x8::from_slice(simd, &z[start..end]),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lad::of_generators::goal::Goal;
    use crate::numeric::bounded::exact;
    use crate::numeric::lanes::level::at_each_level;
    use crate::numeric::linear::{cross, dot};
    use crate::zonotope::query::Query;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    #[test]
    fn no_pair_is_better_than_the_one_that_is_found() {
        let random = &mut Pcg64Mcg::seed_from_u64(17);
        for n in 2..=PAIRS_LIMIT {
            for _ in 0..20 {
                let mut vector = || [0, 1, 2].map(|_| random.random_range(-1.0..1.0));
                let (p, vectors): ([f64; 3], Vec<[f64; 3]>) = (vector(), (0..n).map(|_| vector()).collect());
                let gauge = |i: usize, j: usize| {
                    let u = cross(&vectors[i], &vectors[j]);
                    dot(&u, &p).abs() / vectors.iter().map(|v| dot(v, &u).abs()).sum::<f64>()
                };
                let largest = (0..n).flat_map(|j| (0..j).map(move |i| gauge(i, j))).fold(0.0, f64::max);
                let found = at_each_level(|| steepest(&vectors, &p));
                assert!(found.iter().all(|pair| *pair == found[0]));
                let [i, j] = found[0];
                assert!(i != j && gauge(i, j) >= largest * (1.0 - 1e-12), "{n}: {i} {j}");
            }
        }
    }

    #[test]
    fn parallel_generators_have_no_normal() {
        let vectors = [[1.0, 2.0, 0.0], [2.0, 4.0, 0.0], [0.0, 0.0, 1.0]];
        let [i, j] = steepest(&vectors, &[1.0, 0.0, 0.0]);
        assert!(i.max(j) == 2);
        let [i, j] = steepest(&vectors[..2], &[1.0, 0.0, 0.0]);
        assert_eq!(i, j);
        let query = Query::new([0.0; 3], [1.0, 0.0, 0.0], &vectors[..2]).expect("finite");
        assert!(best_pair(&Problem::new(&query, exact([1.0, 0.0, 0.0]), Goal::Gauge)).is_none());
    }
}
