//! Lemma 5.6: a walk from vertex to vertex of an arrangement, each step one deletion and one insertion.

use proptest::prelude::*;

use super::super::*;
use super::sorted;
use crate::numeric::Rational;
use crate::numeric::orientation::Turn;

/// At the vertex of two lines, with all lines above it and all below it.
struct Walker<'a> {
    lines: &'a [SlopedLine],
    above: DynamicChain<SlopedLine>,
    below: DynamicChain<SlopedLine>,
    at: [SiteIndex; 2],
}

impl Walker<'_> {
    /// Walks along one of the lines of the vertex to the next one; `None` if that part of the line is unbounded.
    fn step(&mut self, along: usize, is_rightward: bool) -> Option<[SiteIndex; 2]> {
        let [line, left_behind] = [self.at[along], self.at[1 - along]];
        let point = &self.lines[line.position()];
        let [smaller, larger] = [Towards::Left, Towards::Right];
        let towards = if is_rightward { [smaller, larger] } else { [larger, smaller] };
        let [above, below] = [self.above.tangent(point, towards[0]), self.below.tangent(point, towards[1])];
        let next = match [above, below] {
            [Tangent::Touches(above), Tangent::Touches(below)] => {
                let [left, right] = if is_rightward { [above, below] } else { [below, above] };
                match Site::turn(&self.lines[left.position()], point, &self.lines[right.position()]) {
                    Turn::Right => above,
                    _ => below,
                }
            }
            [Tangent::Touches(next), Tangent::Unbounded] | [Tangent::Unbounded, Tangent::Touches(next)] => next,
            ends => {
                assert_eq!(ends, [Tangent::Unbounded; 2], "the line is between the two envelopes");
                return None;
            }
        };
        let own = if self.above.contains(next) { &mut self.above } else { &mut self.below };
        own.delete(next).expect("it touched the tangent");
        let rises = self.lines[left_behind.position()].abscissa_order(point).is_gt();
        let other = if rises == is_rightward { &mut self.above } else { &mut self.below };
        other.insert(left_behind).expect("the lines of the vertex are in neither");
        self.at = [line, next];
        Some(self.at)
    }
}

/// Slope and height at x = 0.
fn coefficients(line: &SlopedLine) -> [Rational; 2] {
    let [x, y, w] = line.homogeneous().map(|c| c.to_rational());
    [x / w.clone(), y / w]
}

/// Where two lines meet; `None` if they are parallel.
fn crossing(lines: &[SlopedLine], [a, b]: [SiteIndex; 2]) -> Option<Rational> {
    let [[m, q], [n, r]] = [a, b].map(|index| coefficients(&lines[index.position()]));
    (m != n).then(|| (r - q) / (m - n))
}

fn check(rows: &[[f64; 3]], choices: &[(bool, bool)]) -> Result<(), TestCaseError> {
    let lines: Vec<SlopedLine> = rows.iter().filter_map(|&row| SlopedLine::new(row).ok()).collect();
    let at = [SiteIndex(0), SiteIndex(1)];
    let Some(x) = (lines.len() > 1).then(|| crossing(&lines, at)).flatten() else { return Ok(()) };
    let height = |index: u32| {
        let [slope, intercept] = coefficients(&lines[index as usize]);
        slope * &x + intercept
    };
    let others = |is_above: bool| {
        let all = 2..lines.len() as u32;
        all.filter(|&k| (height(k) > height(0)) == is_above).map(SiteIndex).collect::<Vec<_>>()
    };
    let chain = |side, present| DynamicChain::new(sorted(&lines), side, present).expect("distinct indices");
    let (above, below) = (chain(Side::Lower, others(true)), chain(Side::Upper, others(false)));
    let mut walker = Walker { lines: &lines, above, below, at };
    for &(along, is_rightward) in choices {
        let at = walker.at;
        let line = at[usize::from(along)];
        let x = crossing(&lines, at).expect("the walker is at a vertex");
        let meets = (0..lines.len() as u32).map(SiteIndex).filter_map(|k| Some((crossing(&lines, [line, k])?, k)));
        let truth = if is_rightward {
            meets.filter(|(other, _)| *other > x).min()
        } else {
            meets.filter(|(other, _)| *other < x).max()
        };
        prop_assert_eq!(walker.step(usize::from(along), is_rightward), truth.map(|(_, k)| [line, k]));
    }
    Ok(())
}

properties! {
    #![proptest_config(crate::property_cases::config(100))]

    #[test]
    fn a_walk_meets_every_vertex_in_order(
        rows in prop::collection::vec([-1.0..1.0f64, -1.0..1.0f64, -1.0..1.0f64], 2..30),
        choices in prop::collection::vec(any::<(bool, bool)>(), 1..60),
    ) {
        check(&rows, &choices)?;
    }
}
