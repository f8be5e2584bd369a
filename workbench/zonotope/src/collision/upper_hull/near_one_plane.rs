//! Heights over bodies whose generators lie in one plane but for rounding.
//!
//! The lines of such generators meet in one point but for their last digits, so that doubles tell nothing about their
//! order, and every line would need exact arithmetic. In coordinates around a point of doubles
//! near that one, the offset a x + b y + c of a line is tiny, and pairs of doubles know it to its last digits.

use crate::lad::kernel_input::{Columns, ExactLine, ExactLines, LineError};
use crate::lad::{LadOutcome, LadProblem, WeightedLine, minimize};
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::scaling::{binary_exponent, scale_by_power_of_two};
use crate::numeric::tolerance::{FIVE_ROUNDINGS, MODERATE_SIZES, UNIT};
use crate::seed::DEFAULT_SEED;
use crate::tally::Tally;

use super::Height;

/// Fewer generators are solved exactly in less time than this takes.
const LEAST_COUNT: usize = 256;

/// How many lines tell the point near which all may meet.
const SAMPLE: usize = 64;

/// Lines nearly meet in a point where no offset around it exceeds this part of the largest offset around the origin:
/// farther apart, doubles tell most of them from each other as they are.
const NEARLY_MEETING: f64 = 1e-9;

/// Lines in coordinates around a point, scaled by powers of two.
#[derive(Debug)]
struct LinesAround<'g> {
    generators: &'g [[f64; 3]],
    center: [Dyadic; 2],
    normal_scale: i64,
    offset_scale: i64,
}

impl ExactLines for LinesAround<'_> {
    fn line(&self, position: usize) -> ExactLine {
        let [a, b, c] = self.generators[position].map(Dyadic::from_f64);
        let [x, y] = &self.center;
        let offset = (&a * x + &b * y + c).scaled(-self.offset_scale);
        ExactLine { normal: [a, b].map(|v| v.scaled(-self.normal_scale)), offset }
    }
}

/// The height over p_0, if the lines of the generators nearly meet in one point.
pub(super) fn height(generators: &[[f64; 3]], p0: [f64; 2], tally: &mut impl Tally) -> Option<Height> {
    let center = common_point(generators)?;
    let [x, y] = center.map(BoundedDoubleDouble::exact);
    let of = BoundedDoubleDouble::exact;
    let offsets: Vec<BoundedDoubleDouble> = generators.iter().map(|&[a, b, c]| of(a) * x + of(b) * y + of(c)).collect();
    let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0f64, |m, v| m.max(v.abs()));
    let size = largest(&mut generators.iter().map(|v| v[2]));
    let rest = largest(&mut offsets.iter().map(|offset| offset.high));
    let normals = largest(&mut generators.iter().flat_map(|v| [v[0], v[1]]).chain(p0));
    let is_near = rest <= NEARLY_MEETING * size && [rest, normals].iter().all(|size| MODERATE_SIZES.contains(size));
    if !is_near {
        return None;
    }
    let scale = |size: f64| Some(i64::from(binary_exponent(size)?) + 1);
    let (normal_scale, offset_scale) = (scale(normals)?, scale(rest)?);
    let mut columns = Columns::with_capacity(generators.len());
    let mut per_normal = 0.0f64;
    for ([a, b, _], offset) in generators.iter().zip(&offsets) {
        let [a, b] = [a, b].map(|c| scale_by_power_of_two(*c, -normal_scale));
        let (pair, error) = offset.parts();
        columns.push([a, b, scale_by_power_of_two(pair.high, -offset_scale)]);
        // what the second double leaves is a part of the offset, unless the products with the centre cancelled
        let more = error - UNIT * pair.high.abs();
        if more > 0.0 {
            per_normal = per_normal.max(scale_by_power_of_two(more, -offset_scale) / (a.abs() + b.abs()));
        }
    }
    let error = LineError { offset_relative: 4.0 * UNIT, offset_per_normal: per_normal * FIVE_ROUNDINGS };
    if !per_normal.is_finite() {
        return None;
    }
    let center = center.map(Dyadic::from_f64);
    let linear = p0.map(|c| Dyadic::from_f64(-c));
    let shift = &linear[0] * &center[0] + &linear[1] * &center[1];
    let linear = linear.map(|c| c.scaled(-normal_scale));
    let exact = LinesAround { generators, center, normal_scale, offset_scale };
    let problem = LadProblem::from_exact_lines(columns, error, linear, Box::new(exact));
    Some(match minimize(&problem, DEFAULT_SEED, tally) {
        LadOutcome::Optimal(optimum) => {
            let value = optimum.exact_value(&problem).expect("the optimum is of this problem");
            let unit = Dyadic::new(1.into(), offset_scale).to_rational();
            Height::OverQ(value * unit + shift.to_rational())
        }
        LadOutcome::Unbounded { direction } => Height::BesideQ(direction.map(|c| c.to_rational())),
    })
}

/// The point of doubles that a few of the lines are nearest to.
fn common_point(generators: &[[f64; 3]]) -> Option<[f64; 2]> {
    if generators.len() < LEAST_COUNT {
        return None;
    }
    let sample = generators.iter().step_by(generators.len() / SAMPLE);
    let lines: Vec<WeightedLine> = sample.map(|&[a, b, c]| WeightedLine::unweighted([a, b], c)).collect();
    let problem = LadProblem::new(&lines, [0.0; 2]).ok()?;
    let point = minimize(&problem, DEFAULT_SEED, &mut ()).into_optimum()?.point(&problem)?;
    point.iter().all(|c| c.is_finite()).then_some(point)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::upper_hull::by_slope_selection;
    use proptest::prelude::*;

    properties! {
        #![proptest_config(crate::property_cases::config(24))]

        #[test]
        fn heights_are_those_of_slope_selection(
            rows in proptest::collection::vec([-1.0..1.0f64, -1.0..1.0], LEAST_COUNT..2 * LEAST_COUNT),
            slopes in [-2.0..2.0f64, -2.0..2.0],
            p0 in [-9.0..9.0f64, -9.0..9.0],
            noise in prop_oneof![Just(0.0), Just(1e-15), Just(1e-12)],
        ) {
            let generators: Vec<[f64; 3]> = rows
                .iter()
                .zip(0..)
                .map(|([a, b], i)| [*a, *b, slopes[0] * a + slopes[1] * b + noise * f64::from(i % 7 - 3)])
                .collect();
            for p0 in [p0, p0.map(|c| 1e3 * c)] {
                let found = height(&generators, p0, &mut ()).expect("the lines nearly meet");
                let truth = by_slope_selection::height(&generators, p0, 1, &mut ()).expect("finite");
                prop_assert_eq!(matches!(found, Height::OverQ(_)), matches!(truth, Height::OverQ(_)));
                if let (Height::OverQ(found), Height::OverQ(truth)) = (found, truth) {
                    prop_assert_eq!(found, truth);
                }
            }
        }
    }

    #[test]
    fn lines_that_do_not_meet_are_left_to_others() {
        let spread: Vec<[f64; 3]> = (0..400).map(|i| [f64::from(i % 20), 1.0, f64::from(i)]).collect();
        assert_eq!(height(&spread, [0.0; 2], &mut ()), None);
        // exactly one point, and no plane over the plane
        let meeting: Vec<[f64; 3]> = (0..400).map(|i| [1.0, f64::from(i), f64::from(i) + 2.0]).collect();
        assert_eq!(height(&meeting, [0.0; 2], &mut ()), None);
        let vertical: Vec<[f64; 3]> = (0..400).map(|i| [0.0, 0.0, f64::from(i)]).collect();
        assert_eq!(height(&vertical, [0.0; 2], &mut ()), None);
    }
}
