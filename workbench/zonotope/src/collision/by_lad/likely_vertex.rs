//! A vertex that is likely to be the optimum, found in doubles and certified by nobody: that is enough where a proof is
//! made from the vertex alone.
//!
//! | generators | how the vertex is found |
//! |---|---|
//! | at most [`PAIRS_LIMIT`] | the normals of pairs are tried |
//! | at most [`WHOLE_LIMIT`] | Newton steps on all lines, and a descent from there |
//! | at most [`LIKELY_LIMIT`] | Newton steps on a sample, then the same among the generators near the direction found |
//!
//! After the steps the optimum is nearer than all but some dozens of lines, and the descent goes on among these alone.

use crate::lad::of_generators::guess::approach::Approach;
use crate::lad::of_generators::guess::near_rows::NearRows;
use crate::lad::of_generators::guess::sample::Sample;
use crate::lad::of_generators::guess::vertex_descent::descend;
use crate::lad::of_generators::ladder::WHOLE_LIMIT;
use crate::lad::of_generators::plane::in_doubles::RoundedChart;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::lad::of_generators::search::best_pair::{Found, PAIRS_LIMIT, steepest};
use crate::numeric::bounded::BoundedVector;
use crate::numeric::reused::Reused;
use crate::tally::{Operation, Tally};

/// Of more generators no vertex is guessed: the bounds of a proof from a vertex alone grow with their number, so that
/// near the boundary it would seldom succeed.
pub(super) const LIKELY_LIMIT: usize = 1024;

/// With at least this many generators the descent of a guess goes on among near lines alone.
const NEAR_LINES_COUNT: usize = 160;

/// The distance of near generators from the direction that a sample leads to, in standard deviations.
const NEAR_DEVIATIONS: f64 = 5.0;

/// The distance of near lines, in terms of the band within which the optimum is likely to be.
const NEAR_BANDS: f64 = 2.0;

/// The generators of a vertex that is likely to be the optimum. `None` where doubles find no vertex, or a sample says
/// little as lengths are uneven. O(n) for each line that the descent takes, of which there are few.
pub(super) fn likely_vertex(query: &dyn KernelQuery, p: &BoundedVector, tally: &mut dyn Tally) -> Option<[usize; 2]> {
    let [first, second] = query.parts();
    let n = query.len();
    let p = [p[0].value, p[1].value, p[2].value];
    if n <= PAIRS_LIMIT {
        let mut vectors = [[0.0; 3]; PAIRS_LIMIT];
        let (own, others) = vectors[..n].split_at_mut(first.rows.len());
        first.write(own);
        second.write(others);
        let Found { pair, octets } = steepest(&vectors[..n], &p);
        // each eight of pairs is tried with all generators
        tally.add(Operation::GeneratorRead, n as u64 * octets as u64);
        return Some(pair);
    }
    if n > WHOLE_LIMIT {
        return by_sample(query, p, tally);
    }
    tally.add(Operation::GeneratorRead, n as u64);
    let mut vectors = Reused::with_capacity(n);
    first.copy(first.rows.list(), &mut vectors);
    second.copy(second.rows.list(), &mut vectors);
    let lines = RoundedChart::new(p).lines(&vectors);
    let Some(Approach { point, band, .. }) = lines.approach([0.0; 2], None) else {
        return descend(&lines, [0.0; 2], [0.0; 2]);
    };
    if n < NEAR_LINES_COUNT {
        descend(&lines, [0.0; 2], point)
    } else {
        lines.vertex_near([0.0; 2], point, NEAR_BANDS * band)
    }
}

/// The generators near the direction to which a sample leads are searched, the others summed up with their signs.
fn by_sample(query: &dyn KernelQuery, p: [f64; 3], tally: &mut dyn Tally) -> Option<[usize; 2]> {
    let sample = Sample::of(query, tally);
    if sample.longest < f64::INFINITY {
        return None;
    }
    let chart = RoundedChart::new(p);
    let Approach { point, deviation, .. } = chart.lines(&sample.vectors).approach([0.0; 2], None)?;
    let reach = NEAR_DEVIATIONS * deviation;
    let near = NearRows::of(query, &chart.point(point), reach);
    tally.add(Operation::GeneratorRead, query.len() as u64);
    let (lines, [x, y, _]) = (chart.lines(&near.vectors), chart.line(&near.sum));
    let Approach { point, band, .. } = lines.approach([x, y], Some((point, reach)))?;
    let vertex = lines.vertex_near([x, y], point, NEAR_BANDS * band)?;
    Some(vertex.map(|line| near.indices[line] as usize))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::by_lad;
    use crate::collision::proof::at_vertex::in_doubles::location_by_pair;
    use crate::zonotope::Zonotope;
    use crate::zonotope::pose::Pose;
    use crate::zonotope::prepared::PreparedBody;
    use crate::zonotope::query::Query;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    /// Just inside the boundary only the optimum proves a location.
    #[test]
    fn the_vertex_proves_nearly_every_location_at_rest_and_under_poses() {
        let random = &mut Pcg64Mcg::seed_from_u64(38);
        for n in [12, 40, 150, 300, 400, 1000] {
            let mut proved = [0; 3];
            for _ in 0..20 {
                let mut vector = || [0, 1, 2].map(|_| random.random_range(-1.0..1.0f64));
                let body = Zonotope::new([0.0; 3], (0..n).map(|_| vector()).collect()).expect("finite");
                let (ray, turn) = (vector(), Pose::from_axis_angle(vector(), 0.7, [0.0; 3]).expect("finite"));
                let at = |gauge: f64| ray.map(|c| (1.0 - 1e-7) * c / gauge);
                let prepared = PreparedBody::new(body.clone());
                let posed = Query::of_point_in(ray, body.at(&turn)).expect("finite");
                let inner = at(by_lad::gauge(&posed, &mut ()).value);
                let posed = Query::of_point_in(inner, body.at(&turn)).expect("finite");
                let inner = at(body.gauge(ray).expect("finite").value);
                let at_rest = Query::of_point(inner, &body).expect("finite");
                let in_blocks = Query::of_point_in(inner, prepared.placed()).expect("finite");
                for (query, proved) in [&at_rest as &dyn KernelQuery, &in_blocks, &posed].into_iter().zip(&mut proved) {
                    let p = query.rounded_displacement();
                    let vertex = likely_vertex(query, &p, &mut ());
                    *proved += u32::from(vertex.and_then(|pair| location_by_pair(query, &p, pair)).is_some());
                }
            }
            assert!(proved.iter().all(|&proved| proved >= 15), "{n}: {proved:?}");
        }
    }

    #[test]
    fn uneven_lengths_have_no_sample_to_begin_with() {
        let generators = (0..900u32).map(|i| {
            let size = if i % 300 == 0 { 1e6 } else { 1.0 };
            [i * i % 101, i * i % 83, i * 7 % 61].map(|c| size * (f64::from(c) / 60.0 - 0.6))
        });
        let body: Vec<[f64; 3]> = generators.collect();
        let query = Query::new([0.0; 3], [1e5, 2e5, 3e5], &body).expect("finite");
        assert_eq!(likely_vertex(&query, &query.rounded_displacement(), &mut ()), None);
    }
}
