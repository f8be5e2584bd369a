//! An interval in which a direction separates two moving bodies at every time.

use dashu_int::IBig;
use dashu_int::ops::BitTest;

use super::answer::FreeInterval;
use super::gap::{Direction, Ends, Solid, gap};
use super::path::Path;
use crate::exact::grid::Grid;
use crate::verdict::Stop;

/// An interval is bisected so many times: to 2^-12 of its length.
const MOST_BISECTIONS: usize = 12;

/// The work on all intervals of an answer: a generator along a direction is one, and more where numbers are long.
pub(super) const MOST_WORK: u64 = 20_000_000;

/// The number of bits of a generator's product that make it take as long again.
const BITS_A_STEP: usize = 640;

/// The note where that work is used up.
const TOO_MUCH: &str = "the gaps of the intervals take too much exact work";

/// The note where a gap is narrower than sines and cosines are enclosed.
const TOO_FINE: &str = "a gap is narrower than the enclosures of the motion's sines and cosines show";

/// Two moving bodies.
pub(super) struct Pair {
    pub(super) solids: [Solid; 2],
    pub(super) paths: [Path; 2],
    /// The exponent of the unit of lengths.
    pub(super) exponent: i32,
}

/// The solids of two bodies and their motions.
pub(super) struct Moving<'a> {
    pub(super) solids: [&'a Solid; 2],
    pub(super) paths: &'a [Path; 2],
}

/// A part of an interval that is to be proved: two times in units of 2^-places.
struct Part {
    from: IBig,
    to: IBig,
    bisections: usize,
}

impl Moving<'_> {
    /// Proves that the bodies are disjoint in an interval. The work that is done is taken from `work`.
    pub(super) fn prove_free(&self, interval: &FreeInterval, work: &mut u64) -> Result<(), Stop> {
        let FreeInterval { from, to, .. } = *interval;
        let direction = Direction::of(&interval.direction);
        let breaks: Vec<f64> = self.paths.iter().flat_map(Path::breaks).collect();
        let times = || breaks.iter().copied().chain([from, to, 1.0]);
        let exponent = Grid::of(times()).exponent().min(0) - MOST_BISECTIONS as i32;
        let (grid, places) = (Grid::at(exponent), exponent.unsigned_abs() as usize);
        let mut ends: Vec<f64> = times().filter(|time| (from..=to).contains(time)).collect();
        ends.sort_by(f64::total_cmp);
        ends.dedup();
        let whole = |pair: &[f64]| Part { from: grid.units(pair[0]), to: grid.units(pair[1]), bisections: 0 };
        let mut open: Vec<Part> = ends.windows(2).map(whole).collect();
        while let Some(part) = open.pop() {
            if self.is_free([&part.from, &part.to], places, &direction, interval, work)? {
                continue;
            }
            if part.bisections == MOST_BISECTIONS {
                return Err(unproved(interval).into());
            }
            let (middle, bisections) = ((&part.from + &part.to) >> 1_usize, part.bisections + 1);
            open.push(Part { from: middle.clone(), to: part.to, bisections });
            open.push(Part { from: part.from, to: middle, bisections });
        }
        Ok(())
    }

    /// Whether nothing moves but one body about an axis.
    fn is_one_turn(&self) -> bool {
        let [a, b] = self.paths;
        (a.only_turns() && b.is_rest()) || (a.is_rest() && b.only_turns())
    }

    /// Whether a part is free by its coefficients; an error where there is no gap at one of its ends, or none is shown.
    fn is_free(
        &self,
        times: [&IBig; 2],
        places: usize,
        direction: &Direction,
        interval: &FreeInterval,
        work: &mut u64,
    ) -> Result<bool, Stop> {
        if self.paths.iter().any(|path| !path.is_one_stretch(times, places)) {
            return Ok(false);
        }
        let [a, b] = self.paths.each_ref().map(|path| path.stretches(times, places));
        let ([a], [b]) = (&a[..], &b[..]) else {
            return Err("an interval lies in no piece of a motion".into());
        };
        let bits = [a, b].map(|stretch| stretch.turns.iter().flatten().map(IBig::bit_len).max().unwrap_or(0));
        let generators = self.solids.iter().map(|solid| solid.size()).sum::<u64>();
        let step = 1 + (2 * (bits[0] + bits[1]) / BITS_A_STEP) as u64;
        let cost = (generators + 16) * direction.cost() * step * step;
        *work = work.checked_sub(cost).ok_or_else(|| Stop::Unchecked(TOO_MUCH.to_owned()))?;
        let gap = gap(self.solids, [a, b], direction, self.is_one_turn());
        match gap.at_the_ends() {
            Ends::Open => Ok(gap.is_positive()),
            Ends::Closed => Err(unproved(interval).into()),
            Ends::InDoubt => Err(Stop::Unchecked(TOO_FINE.to_owned())),
        }
    }
}

fn unproved(FreeInterval { from, to, .. }: &FreeInterval) -> String {
    format!("certificate: the direction does not separate the bodies at every time from {from:?} to {to:?}")
}

#[cfg(test)]
mod tests {
    use super::super::answer::MovingDirection;
    use super::super::path::{Motion, MotionPiece};
    use super::*;

    /// The work that one interval takes in which nothing moves. The first body has three generators, and the second,
    /// which is 100 away, two corners; both are turned by quaternions of so many bits.
    fn work_on_bodies_at_rest(bits: [i32; 2], direction: MovingDirection) -> u64 {
        let vector = |x: i32| [IBig::from(x), IBig::ZERO, IBig::ZERO];
        let (center, reach) = (vector(0), IBig::ZERO);
        let first = Solid { center, generators: vec![vector(1); 3], corners: Vec::new(), reach: reach.clone() };
        let second = Solid { center: vector(100), generators: Vec::new(), corners: vec![vector(1); 2], reach };
        let paths = bits.map(|bits| {
            let turn = [1.0, 0.0, 0.0, 2f64.powi(1 - bits)];
            let piece = MotionPiece { until: 1.0, from: turn, to: turn, axis_point: [0.0; 3], translation: [0.0; 3] };
            Path::of(&Motion::Pieces(vec![piece]), Grid::at(0)).expect("a motion")
        });
        let mut left = 1_000_000;
        let interval = FreeInterval { from: 0.0, to: 1.0, direction };
        let moving = Moving { solids: [&first, &second], paths: &paths };
        assert_eq!(moving.prove_free(&interval, &mut left), Ok(()));
        1_000_000 - left
    }

    #[test]
    fn the_work_grows_with_generators_corners_and_the_square_of_the_bits() {
        let space = MovingDirection::Space([1.0, 0.0, 0.0]);
        // Generators and corners are 5, the rest counts as 16 more, and all are measured along 6 directions.
        let short = (5 + 16) * 6;
        assert_eq!(work_on_bodies_at_rest([2, 2], space), short);
        // Twice the 482 bits of both make one step more, and twice the 642 bits make two.
        assert_eq!(work_on_bodies_at_rest([321, 161], space), short * 4);
        assert_eq!(work_on_bodies_at_rest([321, 321], space), short * 9);
        let along_edges = MovingDirection::Edges([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
        for direction in [MovingDirection::A([1.0, 0.0, 0.0]), MovingDirection::B([1.0, 0.0, 0.0]), along_edges] {
            assert_eq!(work_on_bodies_at_rest([2, 2], direction), (5 + 16) * 10, "{direction:?}");
        }
    }

    #[test]
    fn work_that_is_used_up_leaves_an_interval_unchecked() {
        let point = |x: i32| Solid {
            center: [IBig::from(x), IBig::ZERO, IBig::ZERO],
            generators: Vec::new(),
            corners: Vec::new(),
            reach: IBig::ZERO,
        };
        let solids = [point(0), point(1)];
        let paths = [&Motion::Rest; 2].map(|rest| Path::of(rest, Grid::at(0)).expect("a motion"));
        let interval = FreeInterval { from: 0.0, to: 1.0, direction: MovingDirection::Space([1.0, 0.0, 0.0]) };
        let proved =
            |mut work: u64| Moving { solids: solids.each_ref(), paths: &paths }.prove_free(&interval, &mut work);
        assert_eq!(proved(96), Ok(()));
        assert_eq!(proved(95), Err(Stop::Unchecked(TOO_MUCH.to_owned())));
    }
}
