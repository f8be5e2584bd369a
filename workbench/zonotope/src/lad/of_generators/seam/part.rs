//! One run of generators: rows, and the matrix that they are to be taken under.

use std::borrow::Cow;
use std::ops::Range;

use super::direction_cone::DirectionCone;
use super::frame::Frame;
use super::sign_pass::{FixedSum, Places};
use crate::numeric::bounded::Bounded;
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::exact_linear::{self, ExactVector, exact};
use crate::numeric::lanes::rows::{Rows, Runs};
use crate::numeric::lanes::{Extents, bounded_sum, bounded_sum_near, extreme_sum_of, signed_factors};
use crate::numeric::linear::sum_norm;

/// Results of a pass over the rows of one part that can become results for their images.
pub(crate) trait Carried {
    /// The result for the images of the rows, if the pass had its directions pulled back.
    fn carried(self, frame: &Frame<'_>) -> Self;

    /// The result for two parts together.
    fn joined(self, other: Self) -> Self;
}

/// Rows, and the matrix that they are to be taken under.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Part<'a> {
    pub(crate) rows: Rows<'a>,
    pub(crate) frame: Option<Frame<'a>>,
}

/// The value that a function has for the part and the row of a generator, for callers that read many and ask for the
/// parts once.
#[inline(always)]
pub(crate) fn of_row<'p, 'a, T>(
    [first, second]: &'p [Part<'a>; 2],
    index: usize,
    value: impl FnOnce(&'p Part<'a>, &'a [f64; 3]) -> T,
) -> T {
    match index.checked_sub(first.rows.len()) {
        None => value(first, &first.rows.list()[index]),
        Some(index) => value(second, &second.rows.list()[index]),
    }
}

impl<'a> Part<'a> {
    /// The generators in doubles.
    #[inline]
    pub(crate) fn images(self) -> impl Iterator<Item = [f64; 3]> + 'a {
        self.rows.list().iter().map(move |v| self.image(v))
    }

    /// Adds a number for each generator in doubles to the end of a list.
    #[inline]
    pub(crate) fn map_into<T>(&self, list: &mut impl Extend<T>, of: impl Fn(&[f64; 3]) -> T) {
        match self.frame {
            None => list.extend(self.rows.list().iter().map(of)),
            Some(frame) => list.extend(self.rows.list().iter().map(|v| of(&frame.image(v)))),
        }
    }

    /// Adds a factor for each generator to the end of a list, with the sign of its product with the centre of a cell.
    pub(crate) fn signed_factors(&self, cell: &DirectionCone, factor: f64, list: &mut Vec<f64>) {
        match self.frame {
            None => signed_factors(self.rows, &cell.center, factor, list),
            Some(_) => self.map_into(list, |v| factor.copysign(cell.value(v))),
        }
    }

    #[inline]
    pub(crate) fn image(&self, v: &[f64; 3]) -> [f64; 3] {
        self.frame.map_or(*v, |frame| frame.image(v))
    }

    /// The image in doubles with a bound for its length |v|_1, of which the image is off by at most 4 u.
    #[inline(always)]
    pub(super) fn image_with_length(&self, v: &[f64; 3]) -> ([f64; 3], f64) {
        self.frame.map_or_else(|| (*v, sum_norm(v)), |frame| frame.image_with_length(v))
    }

    /// Writes the generators to places of their own.
    pub(crate) fn write(&self, places: &mut [[f64; 3]]) {
        places.copy_from_slice(self.rows.list());
        if let Some(frame) = self.frame {
            places.iter_mut().for_each(|v| *v = frame.image(v));
        }
    }

    /// Adds the images of some rows to a list.
    pub(crate) fn copy(&self, rows: &[[f64; 3]], list: &mut Vec<[f64; 3]>) {
        match self.frame {
            None => list.extend_from_slice(rows),
            Some(frame) => list.extend(rows.iter().map(|v| frame.image(v))),
        }
    }

    /// At least |M| x for magnitudes x.
    #[inline(always)]
    pub(crate) fn image_of_sizes(&self, x: &[f64; 3]) -> [f64; 3] {
        self.frame.map_or(*x, |frame| frame.image_of_sizes(x))
    }

    /// Σ |v|_1, or a little more; of bodies that were not prepared one pass.
    pub(crate) fn magnitude(&self) -> f64 {
        let sizes =
            self.rows.sums().map_or_else(|| Extents::new(self.rows.list()).sums(), |sums| [sums.magnitude() / 3.0; 3]);
        sum_norm(&self.image_of_sizes(&sizes))
    }

    /// A pass over the rows, its result carried over to their images.
    #[inline(always)]
    pub(super) fn passed<const K: usize, T: Carried>(
        &self,
        range: Range<usize>,
        directions: [&[f64; 3]; K],
        pass: &mut impl FnMut(Runs<'_>, Range<usize>, [[f64; 3]; K]) -> T,
    ) -> T {
        let runs = [self.rows, Rows::NONE];
        match self.frame {
            None => pass(runs, range, directions.map(|u| *u)),
            Some(frame) => pass(runs, range, directions.map(|u| frame.pulled(u))).carried(&frame),
        }
    }

    /// The images, if doubles hold them.
    pub(super) fn exact_images(&self) -> Option<Cow<'a, [[f64; 3]]>> {
        if self.frame.is_none() {
            return Some(self.rows.list().into());
        }
        self.rows
            .list()
            .iter()
            .map(|v| exact_linear::doubles(&self.exact_image(v)))
            .collect::<Option<Vec<_>>>()
            .map(Cow::Owned)
    }

    pub(super) fn exact_image(&self, v: &[f64; 3]) -> ExactVector {
        let v = exact(*v);
        self.frame.map_or_else(|| v.clone(), |frame| frame.exact_image(&v))
    }

    /// The image of a row to twice the digits of a double.
    #[inline]
    pub(crate) fn image_in_pairs(&self, v: &[f64; 3]) -> [BoundedDoubleDouble; 3] {
        self.pair_image(&v.map(BoundedDoubleDouble::exact))
    }

    /// The image of a vector that is known to twice the digits of a double.
    pub(crate) fn pair_image(&self, v: &[BoundedDoubleDouble; 3]) -> [BoundedDoubleDouble; 3] {
        self.frame.map_or(*v, |frame| frame.pair_image(v))
    }

    /// Mᵀ u to twice the digits of a double.
    pub(crate) fn pair_pulled(&self, u: &[BoundedDoubleDouble; 3]) -> [BoundedDoubleDouble; 3] {
        self.frame.map_or(*u, |frame| frame.pair_pulled(u))
    }

    /// Mᵀ u, exactly: its products with the rows are those of u with the images of the rows.
    pub(crate) fn exact_pulled(&self, u: &ExactVector) -> ExactVector {
        self.frame.map_or_else(|| u.clone(), |frame| frame.exact_pulled(u))
    }

    /// The sum of the generators whose sign is fixed in a cell; the others are added to a list, and their places, from
    /// an offset on, to a second one. One pass.
    pub(crate) fn split(
        &self,
        cell: &DirectionCone,
        offset: usize,
        crossing: &mut Vec<[f64; 3]>,
        indices: &mut Places,
    ) -> FixedSum {
        let first = indices.len();
        let fixed = match self.frame {
            None => cell.split(self.rows, indices),
            Some(frame) => frame.pushed_sum(&frame.pulled_cell(cell).split(self.rows, indices)),
        };
        self.gather(first, offset, crossing, indices);
        fixed
    }

    /// Adds the generators whose places are the last ones of a list to another list, and moves these places by an
    /// offset.
    pub(crate) fn gather(&self, first: usize, offset: usize, crossing: &mut Vec<[f64; 3]>, indices: &mut Places) {
        let old = crossing.len();
        self.rows.copy_some(&indices[first..], crossing);
        if let Some(frame) = self.frame {
            crossing[old..].iter_mut().for_each(|v| *v = frame.image(v));
        }
        if offset > 0 {
            indices[first..].iter_mut().for_each(|index| *index += offset as u32);
        }
    }

    /// Σ ± v with the signs of the products with a direction, in doubles. One pass.
    pub(crate) fn extreme_sum(&self, u: &[f64; 3]) -> [f64; 3] {
        let pulled = self.frame.map_or(*u, |frame| frame.pulled(u));
        self.image(&extreme_sum_of(&self.rows.octets(), &pulled))
    }

    /// Σ |v · u| with a bound of its error. One pass.
    pub(crate) fn support(&self, u: &[f64; 3]) -> Bounded {
        match self.frame {
            None => bounded_sum(self.rows, u),
            Some(frame) => bounded_sum_near(self.rows, &frame.pulled(u), frame.pulled_size(u)),
        }
    }
}
