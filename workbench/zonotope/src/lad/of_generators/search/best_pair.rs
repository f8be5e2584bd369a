//! A few generators: h(u) / |u · p| at the normals of their pairs, of which the least belongs to the optimum.
//!
//! With at most [`PAIRS_LIMIT`] generators that takes less than a search, which begins with a guess. Eight pairs are
//! taken at a time, from the list of generators, which is written down again and again until the room for it is full.
//! Of at most [`LANES`] generators all pairs are tried: each is i with i + d, round the list. Of more generators, those
//! are tried that lie on one line after the other: all vertices on the line of a generator, then all on the line of
//! the one that it meets at the best of them, until no line has a better one. By convexity that is the optimum where
//! no more than two lines meet.

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use crate::lad::of_generators::cells::nested::NestedCells;
use crate::lad::of_generators::cells::reduced::Reduced;
use crate::lad::of_generators::certify::rounded_optimum::RoundedOptimum;
use crate::lad::of_generators::problem::Problem;
use crate::lad::of_generators::search::Searched;
use crate::numeric::lanes::level::level;
use crate::numeric::lanes::number::{Number, product};
use crate::numeric::lanes::octet::{LANES, Octet, splat};
use crate::tally::{Operation, Tally};

/// At most this many generators are searched by the normals of their pairs.
pub(crate) const PAIRS_LIMIT: usize = 16;

/// The optimum of at least two generators, where it is certified and answers the question. O(n²) for each line.
pub(crate) fn best_pair(problem: &Problem<'_>, tally: &mut dyn Tally) -> Option<Searched> {
    let reduced = Reduced::whole(problem.query);
    if reduced.vectors.len() < 2 {
        return None;
    }
    let pair = problem.vertex.unwrap_or_else(|| {
        let p = [problem.p[0].value, problem.p[1].value, problem.p[2].value];
        let Found { pair, octets } = steepest(&reduced.vectors, &p);
        // each eight of pairs is tried with all generators
        tally.add(Operation::GeneratorRead, reduced.vectors.len() as u64 * octets as u64);
        pair
    });
    let optimum = RoundedOptimum::at(&[reduced], &problem.p, pair).ok()?;
    let is_answer = optimum.is_vertex() || problem.is_answered_by(&optimum);
    is_answer.then(|| Searched::Certified(optimum, NestedCells::default()))
}

/// The best pair that was found.
pub(crate) struct Found {
    pub(crate) pair: [usize; 2],
    /// The number of eights of pairs that were tried.
    pub(crate) octets: usize,
}

/// The pair at whose normal |u · p| / h(u) is largest, as far as doubles tell; a generator with itself where no pair
/// has a normal, which no certificate accepts.
pub(crate) fn steepest(vectors: &[[f64; 3]], p: &[f64; 3]) -> Found {
    let mut columns = [[0.0; PAIRS_LIMIT]; 3];
    for (place, v) in vectors.iter().cycle().take(PAIRS_LIMIT).enumerate() {
        for (column, c) in columns.iter_mut().zip(v) {
            column[place] = *c;
        }
    }
    if vectors.len() > LANES {
        return dispatch!(level(), simd => along_lines(simd, vectors, &columns, p));
    }
    let Best { lane, code, .. } = dispatch!(level(), simd => among_all(simd, vectors, &columns, p));
    let pair = [lane % vectors.len(), (lane + code) % vectors.len()];
    Found { pair, octets: vectors.len() / 2 }
}

/// The largest value of each lane.
struct Lanes<S: Simd> {
    value: f64x8<S>,
    /// The number that identifies the pair or the generator in a lane.
    code: f64x8<S>,
}

/// The largest value of all lanes.
struct Best {
    value: f64,
    lane: usize,
    code: usize,
}

impl<S: Simd> Lanes<S> {
    #[inline(always)]
    fn new(simd: S) -> Self {
        Self { value: f64x8::splat(simd, -1.0), code: f64x8::splat(simd, 0.0) }
    }

    /// Tries the normals of `K` eights of pairs in one pass over the generators, as one eight alone would wait for each
    /// addition to end.
    #[inline(always)]
    fn read<const K: usize>(
        &mut self,
        simd: S,
        vectors: &[[f64; 3]],
        a: &Octet<S>,
        others: [Octet<S>; K],
        p: &Octet<S>,
        codes: [usize; K],
    ) {
        let mut normals = others;
        for (normal, b) in normals.iter_mut().zip(&others) {
            *normal = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
        }
        let mut reaches = [f64x8::splat(simd, 0.0); K];
        for v in vectors {
            for (reach, normal) in reaches.iter_mut().zip(&normals) {
                *reach += (normal[0] * v[0] + normal[1] * v[1] + normal[2] * v[2]).magnitude();
            }
        }
        for ((normal, reach), code) in normals.iter().zip(reaches).zip(codes) {
            // not a number where the two are parallel: then it is no better
            self.raise(simd, product(normal, p).magnitude() / reach, code);
        }
    }

    /// Keeps the larger value of each lane.
    #[inline(always)]
    fn raise(&mut self, simd: S, value: f64x8<S>, code: usize) {
        self.code = self.value.if_less(value, f64x8::splat(simd, code as f64), self.code);
        self.value = self.value.if_less(value, value, self.value);
    }

    #[inline(always)]
    fn best(&self) -> Best {
        let mut lane = 0;
        for other in 1..LANES {
            if self.value[other] > self.value[lane] {
                lane = other;
            }
        }
        Best { value: self.value[lane], lane, code: self.code[lane] as usize }
    }
}

/// The best of all pairs of at most eight generators: the lane is the first one, the code is how far the second is from
/// it.
#[inline(always)]
fn among_all<S: Simd>(simd: S, vectors: &[[f64; 3]], columns: &[[f64; PAIRS_LIMIT]; 3], p: &[f64; 3]) -> Best {
    let (wide, first) = (splat(simd, p), stretch(simd, columns, 0));
    let mut lanes = Lanes::new(simd);
    for step in 1..=vectors.len() / 2 {
        lanes.read(simd, vectors, &first, [stretch(simd, columns, step)], &wide, [step]);
    }
    lanes.best()
}

/// The pair at which the walk along lines ends.
#[inline(always)]
fn along_lines<S: Simd>(simd: S, vectors: &[[f64; 3]], columns: &[[f64; PAIRS_LIMIT]; 3], p: &[f64; 3]) -> Found {
    let wide = splat(simd, p);
    let mut found = Found { pair: [0, 0], octets: 0 };
    let (mut line, mut gauge) = (least_steep(simd, vectors, columns, &wide), -1.0);
    // each line has a better vertex than the one before
    loop {
        let (own, mut lanes) = (splat(simd, &vectors[line]), Lanes::new(simd));
        let starts = [0, LANES];
        lanes.read(simd, vectors, &own, [stretch(simd, columns, 0), stretch(simd, columns, LANES)], &wide, starts);
        found.octets += starts.len();
        let best = lanes.best();
        if best.value.is_nan() || best.value <= gauge {
            return found;
        }
        let other = (best.code + best.lane) % vectors.len();
        (found.pair, gauge, line) = ([line, other], best.value, other);
    }
}

/// The generator that is most nearly orthogonal to p: its line is the nearest to the direction of p, around which the
/// optimum is.
#[inline(always)]
fn least_steep<S: Simd>(simd: S, vectors: &[[f64; 3]], columns: &[[f64; PAIRS_LIMIT]; 3], p: &Octet<S>) -> usize {
    let mut lanes = Lanes::new(simd);
    for start in (0..vectors.len()).step_by(LANES) {
        let v = stretch(simd, columns, start);
        let along = product(&v, p);
        lanes.raise(simd, product(&v, &v) / (along * along), start);
    }
    let best = lanes.best();
    (best.code + best.lane) % vectors.len()
}

/// Eight generators side by side, from a place on.
#[inline(always)]
fn stretch<S: Simd>(simd: S, columns: &[[f64; PAIRS_LIMIT]; 3], start: usize) -> Octet<S> {
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
                let found = at_each_level(|| steepest(&vectors, &p).pair);
                assert!(found.iter().all(|pair| *pair == found[0]));
                let [i, j] = found[0];
                assert!(i != j && gauge(i, j) >= largest * (1.0 - 1e-12), "{n}: {i} {j}");
            }
        }
    }

    #[test]
    fn parallel_generators_have_no_normal() {
        let vectors = [[1.0, 2.0, 0.0], [2.0, 4.0, 0.0], [0.0, 0.0, 1.0]];
        let [i, j] = steepest(&vectors, &[1.0, 0.0, 0.0]).pair;
        assert!(i.max(j) == 2);
        let [i, j] = steepest(&vectors[..2], &[1.0, 0.0, 0.0]).pair;
        assert_eq!(i, j);
        let query = Query::new([0.0; 3], [1.0, 0.0, 0.0], &vectors[..2]).expect("finite");
        assert!(best_pair(&Problem::new(&query, exact([1.0, 0.0, 0.0]), Goal::Gauge), &mut ()).is_none());
    }
}
