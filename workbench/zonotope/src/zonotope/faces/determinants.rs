//! Sums of determinants of generators around a great circle, exactly: what a volume is made of.
//!
//! The sums are as wide as the exponents of all generators together, and a generator changes them by a few words. So
//! they are kept in fixed point, coordinate by coordinate in units of their own.

use super::circles::{Circles, NEW_PLACE};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{BitRange, FixedPoint, exact, sum_of_products};
use crate::zonotope::directions::Directions;

/// The generators by the rank of their circle, turned to the hemisphere of the pole, and room for two sums of them.
#[derive(Debug)]
pub(super) struct HalfEdges {
    generators: Vec<[f64; 3]>,
    /// The index at which the generators of each rank begin, and at last the number of all.
    starts: Vec<usize>,
    before: [FixedPoint; 3],
    area: [FixedPoint; 3],
}

impl HalfEdges {
    /// The generators of all circles.
    pub(super) fn new(circles: &Circles, directions: &Directions<3>, generators: &[[f64; 3]]) -> Self {
        let (mut turned, mut starts) = (Vec::with_capacity(generators.len()), vec![0]);
        for &(class, is_reversed) in &circles.classes {
            turned.extend(directions.members(class as usize).iter().map(|member| {
                let generator = generators[member.generator];
                if member.reversed == is_reversed { generator } else { generator.map(|c| -c) }
            }));
            starts.push(turned.len());
        }
        let ranges = [0, 1, 2].map(|k| BitRange::of_sums(turned.iter().map(|g| g[k]), turned.len()));
        let before = ranges.map(FixedPoint::zero);
        let area = [0, 1, 2].map(|k| {
            let [a, b] = [(k + 1) % 3, (k + 2) % 3];
            FixedPoint::zero(ranges[a].of_products(ranges[b], 2 * turned.len()))
        });
        Self { generators: turned, starts, before, area }
    }

    /// The generators of a circle's direction.
    fn of_rank(&self, rank: usize) -> std::ops::Range<usize> {
        self.starts[rank]..self.starts[rank + 1]
    }

    /// Σ |det(w, w_a, w_b)| over the generators w of a circle, given its crossings, and pairs of generators of circles
    /// south of it. Parallel ones add nothing, whatever their order.
    pub(super) fn determinants_south_of(&mut self, rank: usize, crossings: &[u32]) -> Dyadic {
        self.before.iter_mut().chain(&mut self.area).for_each(FixedPoint::clear);
        for other in crossings.iter().map(|crossing| (crossing & !NEW_PLACE) as usize).filter(|&other| other > rank) {
            for index in self.of_rank(other) {
                let generator = self.generators[index];
                for (k, area) in self.area.iter_mut().enumerate() {
                    let [a, b] = [(k + 1) % 3, (k + 2) % 3];
                    area.add_multiple(generator[b], &self.before[a]);
                    area.add_multiple(-generator[a], &self.before[b]);
                }
                self.before.iter_mut().zip(generator).for_each(|(sum, c)| sum.add(c));
            }
        }
        let area = self.area.each_ref().map(FixedPoint::to_dyadic);
        let determinants = |index: usize| sum_of_products(&exact(self.generators[index]), &area);
        self.of_rank(rank).map(determinants).fold(Dyadic::zero(), |sum, term| sum + term)
    }
}
