//! The searches for the optimal centre, step by step, in the coordinates of the plane in which the points are given.
//!
//! The kernel searches in a frame of its own. Its steps are brought back exactly and rounded once.

use super::Bisectors;
use crate::arrangement::ExactLine;
use crate::lad::by_pruning;
use crate::lad::by_slope_selection::{self, SearchStep};
use crate::lad::kernel_input::ExactLines;
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::scaling::scale_by_power_of_two;

/// A vertex of the arrangement of the lines ℓ_t.
#[derive(Debug, Clone, PartialEq)]
pub struct Candidate {
    /// Two lines that meet there, by the edges of the hull, the lower one first.
    pub lines: [usize; 2],
    /// The place, each coordinate within a relative 2^-50.
    pub point: [f64; 2],
    homogeneous: [Dyadic; 3],
}

/// A cell of the search by pruning: every other line is on one side of it and is summed up.
#[derive(Debug, Clone, PartialEq)]
pub struct PruningCell {
    /// The lines that the search was left with, by the edges of the hull; a sample of them at first.
    pub lines: Vec<usize>,
    /// The lines among them that may cross the cell.
    pub crossing: Vec<usize>,
    /// The corners of the cell in cyclic order, rounded.
    pub corners: [[f64; 2]; 4],
}

impl Candidate {
    /// Its abscissa, exactly.
    pub fn exact_x(&self) -> Rational {
        self.homogeneous[0].to_rational() / self.homogeneous[2].to_rational()
    }
}

impl Bisectors<'_> {
    /// The vertices of the arrangement of the lines ℓ_t, once for each pair of lines that cross, in the order of the
    /// second line: the candidates of the search. O(h²) exact operations.
    pub fn candidates(&self) -> Vec<Candidate> {
        let lines = self.lines();
        let exact: Vec<ExactLine> = (0..lines.farthest.len()).map(|t| ExactLines::line(&lines, t)).collect();
        let pairs = (0..exact.len()).flat_map(|second| (0..second).map(move |first| [first, second]));
        let candidate = |lines: [usize; 2]| {
            let homogeneous = exact[lines[0]].meet(&exact[lines[1]]);
            (!homogeneous[2].is_zero()).then(|| {
                let homogeneous = self.frame.center_of(&homogeneous);
                let [x, y, w] = &homogeneous;
                Candidate { lines, point: [x.ratio(w), y.ratio(w)], homogeneous }
            })
        };
        pairs.filter_map(candidate).collect()
    }

    /// The vertical lines that the search of Theorem 4.5 draws; none where no two lines ℓ_t cross. `seed` decides the
    /// choices of slope selection, never the vertical lines.
    pub fn search_by_slope_selection(&self, seed: u64) -> Vec<SearchStep> {
        let (_, steps) = by_slope_selection::trace(&self.kernel_problem(), seed);
        steps.into_iter().map(|step| self.in_the_plane(step)).collect()
    }

    /// The cells of the search by pruning, where line searches alone are left to solve what has at most
    /// `line_search_limit` lines. `seed` decides the samples.
    pub fn search_by_pruning(&self, line_search_limit: usize, seed: u64) -> Vec<PruningCell> {
        let (_, cells) = by_pruning::trace(&self.kernel_problem(), line_search_limit, seed);
        let corner = |[x, y]: [f64; 2]| {
            let rounded = |value: f64, axis: usize| {
                scale_by_power_of_two(value + self.frame.reference[axis], self.frame.scale(axis) - 1)
            };
            [rounded(x, 0), rounded(y, 1)]
        };
        let cell = |cell: by_pruning::TracedCell| PruningCell {
            lines: cell.lines,
            crossing: cell.crossing,
            corners: cell.corners.map(corner),
        };
        cells.into_iter().map(cell).collect()
    }

    /// A step of the kernel's search, in the coordinates of the plane.
    fn in_the_plane(&self, step: SearchStep) -> SearchStep {
        let place = |value: &Rational, axis: usize| {
            let factor = Dyadic::one().scaled(self.frame.scale(axis) - 1).to_rational();
            (value + Dyadic::from_f64(self.frame.reference[axis]).to_rational()) * factor
        };
        let exact_x = place(&step.exact_x, 0);
        let exact_minimum = step.exact_minimum.as_ref().map(|[x, y]| [place(x, 0), place(y, 1)]);
        SearchStep::new(exact_x, exact_minimum, step)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::enclosing::min_area;
    use crate::hull::antipodal::farthest_vertices;
    use crate::hull::convex_hull;
    use crate::lad::by_slope_selection::Side;

    /// Points on an ellipse that is thin, far from the origin, or neither.
    fn points(count: u32, size: [f64; 2], middle: [f64; 2]) -> Vec<[f64; 2]> {
        let angle = |k: u32| f64::from(k * k % (7 * count)) * std::f64::consts::TAU / f64::from(7 * count);
        (0..count)
            .map(|k| [libm::cos(angle(k)), libm::sin(angle(k))])
            .map(|p| [middle[0] + size[0] * p[0], middle[1] + size[1] * p[1]])
            .collect()
    }

    #[test]
    fn the_vertical_lines_close_in_on_the_optimal_centre() {
        for (size, middle) in [([3.0, 2.0], [0.0, 0.0]), ([3.0, 2.0], [1e3, -1e4]), ([1e-200, 1e150], [0.0, 1e150])] {
            let points = points(23, size, middle);
            let best = min_area(&points).expect("the points are finite").proof;
            let (hull, farthest) = (best.hull(), best.farthest());
            let bisectors = Bisectors::new(hull, farthest);
            let candidates: Vec<Rational> = bisectors.candidates().iter().map(Candidate::exact_x).collect();
            let [center, _] = best.exact_center();
            let steps = bisectors.search_by_slope_selection(3);
            assert_eq!(steps[0].vertices_before, candidates.len() as u64);
            let mut strip = [None::<Rational>, None];
            for step in &steps {
                let holds = |x: &Rational| {
                    strip[0].as_ref().is_none_or(|left| left < x) && strip[1].as_ref().is_none_or(|right| x < right)
                };
                let left_in = candidates.iter().filter(|candidate| holds(candidate)).count();
                assert_eq!(step.vertices_before, left_in as u64, "{size:?} {middle:?}");
                assert!(candidates.contains(&step.exact_x));
                let minimum = step.exact_minimum.as_ref().expect("areas are bounded below");
                assert_eq!(minimum[0], step.exact_x);
                match step.side {
                    Side::Left => {
                        assert!(center < step.exact_x);
                        strip[1] = Some(step.exact_x.clone());
                    }
                    Side::Right => {
                        assert!(center > step.exact_x);
                        strip[0] = Some(step.exact_x.clone());
                    }
                    Side::Optimal | Side::Unbounded => {}
                }
            }
            assert_eq!(steps.last().map(|step| step.side), Some(Side::Optimal));
        }
    }

    #[test]
    fn the_last_cell_of_pruning_holds_the_optimal_centre_and_few_lines() {
        // An egg, none of whose lines nearly meet in one point.
        let angle = |k: u32| (f64::from(k) + f64::from(k * k % 7) / 20.0) * std::f64::consts::TAU / 400.0;
        let egg = |t: f64| [3.0 * libm::cos(t) + 0.4 * libm::cos(2.0 * t), 2.0 * libm::sin(t)];
        let points: Vec<[f64; 2]> = (0..400).map(|k| egg(angle(k))).collect();
        let best = min_area(&points).expect("the points are finite").proof;
        let (hull, farthest) = (convex_hull(&points, &mut ()).expect("finite"), best.farthest());
        assert_eq!(farthest_vertices(&hull, &mut ()), farthest);
        let bisectors = Bisectors::new(&hull, farthest);
        let cells = bisectors.search_by_pruning(12, 1);
        let mut of_all = cells.iter().filter(|cell| cell.lines.len() == hull.edge_count());
        let last = of_all.next_back().expect("so many lines are pruned");
        assert!(last.crossing.len() < hull.edge_count());
        assert!(last.crossing.iter().all(|line| last.lines.contains(line)));
        let center = best.exact_center().map(|c| c.to_f64().value());
        for side in 0..4 {
            let (from, to) = (last.corners[side], last.corners[(side + 1) % 4]);
            let turn = (to[0] - from[0]) * (center[1] - from[1]) - (to[1] - from[1]) * (center[0] - from[0]);
            assert!(turn > 0.0, "the centre is left of side {side}");
        }
        // Each line that crosses the cell has corners on both sides, or nearly.
        let [a, b] = bisectors.midpoints(last.crossing[0]);
        let sides = last.corners.map(|c| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
        assert!(sides.iter().any(|side| *side > -1e-9) && sides.iter().any(|side| *side < 1e-9));
    }
}
