//! Points as lines of the dual plane, made as a pass reads them: x' s + t − y' = 0 with the weight of the point.

use std::cmp::Ordering;

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use super::point_frame::PointFrame;
use crate::lad::kernel_input::{ExactLine, ExactLines, LineError, MadeLines};
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_product::exact_product;
use crate::numeric::lanes::level::level;
use crate::numeric::lanes::octet::{LANES, reordered, store_first};
use crate::numeric::lanes::rows::Rows;
use crate::numeric::short_dyadic::ShortDyadic;
use crate::numeric::signed_sum::signed_sum;
use crate::numeric::tolerance::{PAIRABLE_SIZES, UNIT};

/// An offset in the frame is a difference and a product, each rounded once.
const ERROR: LineError = LineError { offset_relative: 4.0 * UNIT, offset_per_normal: 0.0 };

/// The lines of points in their frame.
#[derive(Debug, Clone, Copy)]
pub(super) struct PointLines<'p> {
    pub(super) points: &'p [[f64; 3]],
    pub(super) frame: PointFrame,
}

impl MadeLines for PointLines<'_> {
    fn len(&self) -> usize {
        self.points.len()
    }

    fn row(&self, line: usize) -> ([f64; 3], LineError) {
        (self.frame.row(&self.points[line]), ERROR)
    }

    fn make(&self, start: usize, columns: [&mut [f64]; 3]) -> LineError {
        let rows = Rows::new(&self.points[start..start + columns[0].len()]);
        dispatch!(level(), simd => make_at(simd, &self.frame, rows, columns));
        ERROR
    }
}

#[inline(always)]
fn make_at<S: Simd>(simd: S, frame: &PointFrame, rows: Rows<'_>, [x, y, offset]: [&mut [f64]; 3]) {
    let octets = rows.octets();
    let ((xs, last_x), (ys, last_y)) = (x.as_chunks_mut::<LANES>(), y.as_chunks_mut::<LANES>());
    let (offsets, last_offset) = offset.as_chunks_mut::<LANES>();
    for (k, ((x, y), offset)) in xs.iter_mut().zip(ys).zip(offsets).enumerate() {
        let [a, b, c] = frame.rows(&octets.load(simd, k));
        reordered(simd, a).store_slice(x);
        reordered(simd, b).store_slice(y);
        reordered(simd, c).store_slice(offset);
    }
    if !last_x.is_empty() {
        let [a, b, c]: [f64x8<S>; 3] = frame.rows(&octets.load(simd, octets.len() - 1));
        store_first(reordered(simd, a), last_x);
        store_first(reordered(simd, b), last_y);
        store_first(reordered(simd, c), last_offset);
    }
}

impl ExactLines for PointLines<'_> {
    fn line(&self, position: usize) -> ExactLine {
        let [x, y, w] = self.points[position];
        let weight = self.frame.exact_weight(w);
        let [x, y] = [self.frame.x.exact(x), self.frame.y.exact(y)];
        ExactLine { normal: [&x * &weight, weight.clone()], offset: -(y * weight) }
    }

    /// The sign of x' X + Y − y' W for points of positive weight: in short exact numbers where the coordinates are
    /// short, else in pairs of doubles.
    fn certain_signs(&self, [x, y, w]: &[Dyadic; 3]) -> Box<dyn Fn(usize) -> Option<i8> + '_> {
        let short = ShortDyadic::of(x).zip(ShortDyadic::of(y)).zip(ShortDyadic::of(w));
        // a power of two brings the coordinates into the range of doubles
        let scale = [x, y, w].iter().filter_map(|c| c.binary_exponent()).max().unwrap_or(0);
        let [px, py, pw] = [x, y, w].map(|c| BoundedDoubleDouble::of(&c.clone().scaled(-scale)));
        Box::new(move |position| {
            let [x, y, weight] = self.points[position];
            if weight == 0.0 {
                return Some(0);
            }
            let in_short = || {
                let ((sx, sy), sw) = short?;
                let rise = self.frame.x.short(x)?.times(sx)?.plus(sy)?;
                Some(rise.plus(self.frame.y.short(y)?.times(sw)?.negated())?.sign())
            };
            in_short().or_else(|| {
                let [x, y] = [self.frame.x.pair(x)?, self.frame.y.pair(y)?];
                (x * px + py - y * pw).sign()
            })
        })
    }

    /// The product of the weights times the difference of the abscissas.
    fn certain_cross_sign(&self, first: usize, second: usize) -> Option<Ordering> {
        let ([x, _, w], [other, _, other_w]) = (self.points[first], self.points[second]);
        if w == 0.0 || other_w == 0.0 { Some(Ordering::Equal) } else { x.partial_cmp(&other) }
    }

    /// The sums of x w and of w, each product as two doubles, moved and scaled when they are known.
    fn signed_normal_sum(&self, terms: &mut dyn Iterator<Item = (usize, i8)>) -> [Dyadic; 2] {
        let mut others = [Dyadic::zero(), Dyadic::zero()];
        let products = terms.filter_map(|(position, sign)| {
            let [x, _, w] = self.points[position];
            if [x, w].iter().all(|v| *v == 0.0 || PAIRABLE_SIZES.contains(&v.abs())) {
                let (high, low) = exact_product(x, w);
                return Some(([high, low, w], sign));
            }
            let (weight, sign) = (Dyadic::from_f64(w), Dyadic::from_f64(f64::from(sign)));
            others[0] = &others[0] + &(&(&Dyadic::from_f64(x) * &weight) * &sign);
            others[1] = &others[1] + &(&weight * &sign);
            None
        });
        let [high, low, weight] = signed_sum(products);
        let [x, w] = others;
        self.frame.moved_sum(high + low + x, weight + w)
    }
}

#[cfg(test)]
mod tests {
    use super::super::point_frame::Bounds;
    use super::*;
    use crate::numeric::lanes::level::at_each_level;
    use crate::numeric::tolerance::UNDERFLOW;
    use proptest::prelude::*;

    fn coordinate() -> impl Strategy<Value = f64> {
        prop_oneof![
            4 => (-9i32..9).prop_map(f64::from),
            2 => -1.0..1.0f64,
            1 => (-9i32..9).prop_map(|i| 1e8 + f64::from(i)),
            1 => any::<f64>().prop_filter("finite", |v| v.is_finite()),
        ]
    }

    fn points() -> impl Strategy<Value = Vec<[f64; 3]>> {
        let weight = prop_oneof![4 => Just(1.0), 1 => Just(0.0), 2 => 0.0..9.0f64, 1 => Just(1e-310), 1 => Just(1e300)];
        proptest::collection::vec((coordinate(), coordinate(), weight).prop_map(Into::into), 2..40)
    }

    properties! {
        #![proptest_config(crate::property_cases::config(1000))]

        #[test]
        fn rounded_lines_and_quick_signs_are_those_of_the_exact_lines(points in points(), sign in -1i8..2) {
            let bounds = Bounds::of(&points).expect("finite, of weights that are not negative");
            let lines = PointLines { points: &points, frame: PointFrame::new(&points, &bounds) };
            let made = at_each_level(|| {
                let mut columns = [0; 3].map(|_| vec![0.0; points.len()]);
                lines.make(0, columns.each_mut().map(|column| &mut column[..]));
                columns
            });
            let exact: Vec<ExactLine> = (0..points.len()).map(|i| lines.line(i)).collect();
            let parallel = |a: &ExactLine, b: &ExactLine| {
                let ([x, y], [u, v]) = (&a.normal, &b.normal);
                (x * v).cmp(&(y * u))
            };
            let vertex = exact.iter().find(|line| parallel(&exact[0], line).is_ne()).map(|line| exact[0].meet(line));
            for (i, line) in exact.iter().enumerate() {
                let (row, _) = lines.row(i);
                prop_assert!(made.iter().all(|columns| columns.each_ref().map(|column| column[i]) == row));
                for (rounded, value) in row.iter().zip([&line.normal[0], &line.normal[1], &line.offset]) {
                    prop_assert!(rounded.abs() <= 2.0);
                    let error = (Dyadic::from_f64(*rounded) - value.clone()).abs();
                    let bound = Dyadic::from_f64(2.0 * UNIT * (1.0 + 4.0 * UNIT)) * value.clone().abs();
                    prop_assert!(error <= bound + Dyadic::from_f64(UNDERFLOW));
                }
                prop_assert_eq!(lines.certain_cross_sign(0, i), Some(parallel(&exact[0], line)));
                for place in vertex.iter().chain([&[Dyadic::from_f64(3.0), Dyadic::from_f64(-0.5), Dyadic::zero()]]) {
                    let known = lines.certain_signs(place)(i);
                    prop_assert!(known.is_none_or(|sign| sign == line.evaluate(place).sign() as i8));
                }
            }
            let signs = |i: usize| if i.is_multiple_of(3) { -sign } else { sign };
            let sum = exact.iter().enumerate().fold([Dyadic::zero(), Dyadic::zero()], |[x, y], (i, line)| {
                let factor = Dyadic::from_f64(f64::from(signs(i)));
                [x + &factor * &line.normal[0], y + &factor * &line.normal[1]]
            });
            prop_assert_eq!(lines.signed_normal_sum(&mut (0..points.len()).map(|i| (i, signs(i)))), sum);
        }
    }

    #[test]
    fn bounds_refuse_what_is_no_point() {
        let refused = |row| Bounds::of(&[[[1.0; 3]; 9], [row; 9]].concat()).is_none();
        assert!(!refused([2.0, -3.0, 0.0]));
        for row in [[f64::NAN, 0.0, 1.0], [0.0, f64::INFINITY, 1.0], [0.0, 0.0, -1.0], [0.0, 0.0, f64::NAN]] {
            assert!(refused(row) && Bounds::of(&[[1.0; 3], row]).is_none());
        }
        assert!(Bounds::of(&[]).is_none());
    }
}
