//! The frame of the kernel: scales and a reference point in which doubles tell the lines of a hull apart.

use crate::hull::antipodal::FarthestVertex;
use crate::hull::{ConvexHull, VertexIndex};
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::scaling::{binary_exponent, scale_by_power_of_two};
use crate::numeric::tolerance::SMALLEST_SCALED_CENTER;

/// The axes of a hull whose extents differ by more than this power of two are scaled apart.
const THIN_EXPONENT: i64 = 10;

/// The number of lines, at most, over which the reference is a median.
const REFERENCE_SAMPLE: usize = 16;

/// The frame of the kernel, in which a coordinate of a point O of the plane is x = 2 · 2^−scale · O − reference. The
/// scales take the points of the hull to magnitude at most 1, and the reference is near twice their middle.
///
/// A hull that is thin along an axis has a scale of its own for that axis. A map of the axes keeps areas in proportion
/// and zonogons zonogons, and in the frame the hull is not thin: doubles tell its lines apart.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Frame {
    scales: [i64; 2],
    pub(crate) reference: [f64; 2],
    /// For each axis two powers of two with the product 2^−scale; the product itself may leave the range of doubles.
    factors: [[f64; 2]; 2],
}

/// The doubles nearest to an optimal centre.
#[derive(Debug)]
pub(crate) struct NearestCenter {
    /// The doubles.
    pub(crate) point: [f64; 2],
    /// Their kernel point, by pairs of doubles that are exact.
    pub(crate) kernel_point: [BoundedDoubleDouble; 2],
    /// Whether they are the optimal centre itself.
    pub(crate) is_optimal: bool,
}

impl Frame {
    /// The frame for a hull and the farthest vertices of its edges.
    pub(super) fn of(hull: &ConvexHull, farthest: &[FarthestVertex]) -> Self {
        let scales = largest_coordinates(hull.vertices())
            .map(|largest| binary_exponent(largest).map_or(0, |e| i64::from(e) + 1));
        let is_thin = (scales[0] - scales[1]).abs() > THIN_EXPONENT;
        let scales = if is_thin { scales } else { [scales[0].max(scales[1]); 2] };
        let factors = scales.map(|scale| [-(scale / 2), scale / 2 - scale].map(|e| scale_by_power_of_two(1.0, e)));
        let frame = Self { scales, reference: [0.0; 2], factors };
        // If the hull is nearly symmetric, the median over both ends of a few lines is near one end of every line, so
        // that offsets are small. Else any reference does.
        let step = farthest.len() / REFERENCE_SAMPLE + 1;
        let mut sums = [[0.0; 2 * REFERENCE_SAMPLE]; 2];
        let mut count = 0;
        for t in (0..farthest.len()).step_by(step) {
            let far = frame.scaled(hull.vertex(farthest[t].vertex()));
            for end in hull.edge(VertexIndex::new(t)).map(|end| frame.scaled(end)) {
                (sums[0][count], sums[1][count]) = (end[0] + far[0], end[1] + far[1]);
                count += 1;
            }
        }
        let reference = sums.map(|mut sums| {
            let sums = &mut sums[..count];
            sums.sort_unstable_by(f64::total_cmp);
            sums.get(count / 2).copied().unwrap_or(0.0)
        });
        Self { reference, ..frame }
    }

    /// A point in the units of the frame.
    #[inline(always)]
    pub(crate) fn scaled(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [[a, b], [c, d]] = self.factors;
        [x * a * b, y * c * d]
    }

    /// Whether a point is scaled without underflow.
    pub(super) fn scales_exactly(&self, point: [f64; 2]) -> bool {
        let scaled = self.scaled(point);
        let is_exact = |i: usize| {
            let [a, b] = self.factors[i];
            scaled[i].abs() >= f64::MIN_POSITIVE || scaled[i] / b / a == point[i]
        };
        is_exact(0) && is_exact(1)
    }

    /// The exponent of the power of two that takes a coordinate of the frame to the units of the input.
    pub(crate) fn scale(&self, axis: usize) -> i64 {
        self.scales[axis]
    }

    /// An area in the units of the input, given by a pair of doubles in the units of the frame.
    pub(crate) fn unscaled_pair(&self, area: BoundedDoubleDouble) -> BoundedDoubleDouble {
        area.scaled(self.scales[0] + self.scales[1])
    }

    /// An area in the units of the input, given that in the units of the frame.
    pub(crate) fn unscaled_area(&self, area: Dyadic) -> Dyadic {
        area.scaled(self.scales[0] + self.scales[1])
    }

    /// Whether sums of four coordinates of the input neither overflow nor come near underflow.
    pub(crate) fn sums_are_doubles(&self) -> bool {
        self.scales.iter().all(|scale| (-900..1000).contains(scale))
    }

    /// Whether sums of four coordinates of the input do not overflow, nor does a factor that takes them to the frame.
    /// Sums of doubles never underflow.
    pub(crate) fn sums_are_finite(&self) -> bool {
        self.scales.iter().all(|scale| (-1020..1000).contains(scale))
    }

    /// A point in the units of the frame, exactly.
    pub(crate) fn exact(&self, point: [f64; 2]) -> [Dyadic; 2] {
        [0, 1].map(|axis| Dyadic::from_f64(point[axis]).scaled(-self.scales[axis]))
    }

    /// Twice the point O of a kernel point, in the scale of the frame.
    pub(super) fn doubled_center(&self, place: &[BoundedDoubleDouble; 2]) -> [BoundedDoubleDouble; 2] {
        [0, 1].map(|axis| place[axis] + BoundedDoubleDouble::exact(self.reference[axis]))
    }

    /// The doubles nearest to a point O, given twice O in the scale of the frame; `None` unless pairs of doubles tell
    /// which doubles these are, and whether they are O itself.
    pub(super) fn nearest_center(&self, doubled: &[BoundedDoubleDouble; 2]) -> Option<NearestCenter> {
        let [x, y] = doubled.map(|sum| sum.nearest_double().filter(|v| v.abs() > SMALLEST_SCALED_CENTER));
        let nearest = [x?, y?];
        let is_optimal = doubled.iter().all(BoundedDoubleDouble::is_exactly_double);
        if !self.sums_are_doubles() || !(is_optimal || doubled.iter().any(BoundedDoubleDouble::is_no_double)) {
            return None;
        }
        let point = [0, 1].map(|axis| scale_by_power_of_two(nearest[axis], self.scales[axis] - 1));
        let kernel_point = [0, 1].map(|axis| BoundedDoubleDouble::of_parts(nearest[axis], -self.reference[axis], 0.0));
        Some(NearestCenter { point, kernel_point, is_optimal })
    }

    /// The point O of a kernel point, the inverse of [`Bisectors::kernel_point`], both in homogeneous coordinates.
    pub(crate) fn center_of(&self, [x, y, w]: &[Dyadic; 3]) -> [Dyadic; 3] {
        let [rx, ry] = self.reference.map(Dyadic::from_f64);
        let unscale = |v: Dyadic, axis: usize| v.scaled(self.scales[axis] - 1);
        [unscale(x + &(&rx * w), 0), unscale(y + &(&ry * w), 1), w.clone()]
    }
}

/// The largest magnitude of a coordinate along each axis, of four points at a time.
fn largest_coordinates(points: &[[f64; 2]]) -> [f64; 2] {
    const LANES: usize = 8;
    let mut largest = [0.0f64; LANES];
    let (chunks, rest) = points.as_flattened().as_chunks::<LANES>();
    for chunk in chunks {
        for (largest, value) in largest.iter_mut().zip(chunk) {
            *largest = if value.abs() > *largest { value.abs() } else { *largest };
        }
    }
    for (largest, value) in largest.iter_mut().zip(rest) {
        *largest = largest.max(value.abs());
    }
    [0, 1].map(|axis| largest.iter().skip(axis).step_by(2).copied().fold(0.0, f64::max))
}
