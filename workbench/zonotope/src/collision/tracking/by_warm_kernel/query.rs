//! Bodies under poses with the sums near their last optimum, as an implementor of the kernel's seam: a pass over the
//! generators becomes one over those that cross a cell.
//!
//! Support values and the sums over a cell of directions come from [`LocalSums`] where a cell of these holds the
//! directions, pulled back into the frame of each body; else from all generators. The first cell of a search is the one
//! that the tracker predicts. All rows are there for the rungs that read them one by one.

use super::local_sums::LocalSums;
use crate::lad::of_generators::cells::reduced::Reduced;
use crate::lad::of_generators::seam::direction_cone::DirectionCone;
use crate::lad::of_generators::seam::frame::Frame;
use crate::lad::of_generators::seam::generators::Generators;
use crate::lad::of_generators::seam::kernel_query::{InDoubles, KernelQuery};
use crate::lad::of_generators::seam::part::Part;
use crate::lad::of_generators::seam::sign_pass::{FixedSum, Places, USUAL_CROSSING};
use crate::numeric::bounded::{self, Bounded, BoundedVector};
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::exact_linear::ExactVector;
use crate::numeric::lanes::rows::Rows;
use crate::numeric::lanes::{bounded_sum, bounded_sum_near};
use crate::numeric::linear::dot;
use crate::tally::Tally;
use crate::zonotope::pose::Pose;
use crate::zonotope::query::Query;

/// Memory for so many generators is taken for those that cross a cell; few cells are crossed by more.
const LIKELY_CROSSING: usize = 256;

/// A query about posed bodies, the sums near a direction in the frame of each, and a cell that is likely to hold the
/// optimum.
#[derive(Debug)]
pub(super) struct WarmQuery<'a> {
    pub(super) query: &'a Query<'a, 3, Pose>,
    pub(super) sums: [LocalSums; 2],
    pub(super) cell: Option<DirectionCone>,
    /// s such that the gauge of any x is at most s |x|_1, if that is known.
    pub(super) gauge_bound: Option<f64>,
}

impl WarmQuery<'_> {
    /// Σ |v · u|, if that is known from the sums of both bodies.
    pub(super) fn local_support(&self, u: &[f64; 3]) -> Option<Bounded> {
        let cell = DirectionCone { center: *u, axes: None, ball: 0.0 };
        let [first, second] = Generators::parts(self.query);
        let [own, others] = &self.sums;
        Some(local_support(&first, own, &cell)? + local_support(&second, others, &cell)?)
    }
}

impl Generators for WarmQuery<'_> {
    fn parts(&self) -> [Part<'_>; 2] {
        Generators::parts(self.query)
    }

    fn expected_crossing(&self) -> usize {
        LIKELY_CROSSING
    }

    fn support(&self, u: &[f64; 3]) -> Bounded {
        self.local_support(u).unwrap_or_else(|| self.query.support(u))
    }

    fn split(&self, cell: &DirectionCone, crossing: &mut Vec<[f64; 3]>, indices: &mut Places) -> FixedSum {
        let mut fixed = FixedSum::default();
        let mut offset = 0;
        for (part, sums) in Generators::parts(self.query).iter().zip(&self.sums) {
            let first = indices.len();
            fixed = fixed.plus(&match part.frame {
                None => sums.split(part.rows, cell, indices),
                Some(frame) => frame.pushed_sum(&sums.split(part.rows, &frame.pulled_cell(cell), indices)),
            });
            let places = &mut indices[first..];
            crossing.extend(places.iter().map(|&place| part.image(&part.rows.row(place as usize))));
            places.iter_mut().for_each(|place| *place += offset);
            offset += part.rows.len() as u32;
        }
        fixed
    }
}

/// Σ |v · u| over the images of one body's generators, if its sums near a direction hold the only direction u of a
/// cell.
fn local_support(part: &Part<'_>, sums: &LocalSums, cell: &DirectionCone) -> Option<Bounded> {
    if part.rows.is_empty() {
        return Some(Bounded::exact(0.0));
    }
    let own = part.frame.map_or(*cell, |frame| frame.pulled_cell(cell));
    let level = sums.around(&own)?;
    let u = &cell.center;
    let (fixed, near) = split_in(level, &own);
    let near = Rows::new(&near);
    let (fixed, near) = match part.frame {
        None => (fixed, bounded_sum(near, u)),
        Some(frame) => (frame.pushed_sum(&fixed), near_support(&frame, near, u)),
    };
    Some(dot(&fixed.bounded(), &bounded::exact(*u)) + near)
}

fn near_support(frame: &Frame<'_>, near: Rows<'_>, u: &[f64; 3]) -> Bounded {
    bounded_sum_near(near, &frame.pulled(u), frame.pulled_size(u))
}

/// The sum over all generators whose sign is fixed in a cell within that of a level, and the other generators.
fn split_in(level: &Reduced, cell: &DirectionCone) -> (FixedSum, Vec<[f64; 3]>) {
    let mut places = Places::with_capacity(USUAL_CROSSING);
    let fixed = level.plus_fixed_in(cell, &mut places);
    (fixed, places.iter().map(|&place| level.vectors[place as usize]).collect())
}

impl KernelQuery for WarmQuery<'_> {
    fn exact(&self) -> ExactVector {
        self.query.exact()
    }

    fn rounded_displacement(&self) -> BoundedVector {
        self.query.rounded_displacement()
    }

    fn displacement_pairs(&self) -> [BoundedDoubleDouble; 3] {
        self.query.displacement_pairs()
    }

    fn in_doubles(&self) -> Option<InDoubles<'_>> {
        self.query.in_doubles()
    }

    fn likely_cell(&self, _: &mut dyn Tally) -> Option<DirectionCone> {
        self.cell
    }

    fn known_gauge_bound(&self) -> Option<f64> {
        self.gauge_bound
    }
}
