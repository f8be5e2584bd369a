//! The bounding box, and whether all coordinates are finite, in one pass that the compiler can vectorise.

/// The smallest box that contains all points.
pub(super) struct Bounds {
    /// Smallest x and smallest y.
    pub(super) low: [f64; 2],
    /// Largest x and largest y.
    pub(super) high: [f64; 2],
}

/// Coordinates taken at a time, x and y in turn: two vector registers of the baseline for each of three values.
const LANES: usize = 8;

/// What is known of every eighth coordinate.
struct Lanes {
    low: [f64; LANES],
    high: [f64; LANES],
    /// 0 while all coordinates are finite, then NaN.
    multiples_of_zero: [f64; LANES],
}

impl Lanes {
    #[inline(always)]
    fn extend(&mut self, coordinates: &[f64]) {
        for (lane, &value) in coordinates.iter().enumerate() {
            self.low[lane] = if value < self.low[lane] { value } else { self.low[lane] };
            self.high[lane] = if value > self.high[lane] { value } else { self.high[lane] };
            self.multiples_of_zero[lane] += value * 0.0;
        }
    }
}

impl Bounds {
    /// The box of at least one point; `None` if a coordinate is not finite.
    pub(super) fn of(points: &[[f64; 2]]) -> Option<Self> {
        let mut lanes =
            Lanes { low: [f64::INFINITY; LANES], high: [f64::NEG_INFINITY; LANES], multiples_of_zero: [0.0; LANES] };
        let (blocks, rest) = points.as_flattened().as_chunks::<LANES>();
        for block in blocks {
            lanes.extend(block);
        }
        lanes.extend(rest);
        let of_axis = |lanes: &[f64; LANES], pick: fn(f64, f64) -> f64| {
            [0, 1].map(|axis| lanes.iter().skip(axis).step_by(2).copied().fold(lanes[axis], pick))
        };
        let bounds = Bounds { low: of_axis(&lanes.low, f64::min), high: of_axis(&lanes.high, f64::max) };
        lanes.multiples_of_zero.iter().all(|&sum| sum == 0.0).then_some(bounds)
    }
}
