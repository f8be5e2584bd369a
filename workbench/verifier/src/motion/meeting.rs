//! Two moving bodies at one time: a common point by its coefficients, or two points near each other.
//!
//! **Placements that are off.** Let C x = r be the system of three basis generators as they are placed, and (C + E) x'
//! = r + f that of the motion. With ε = |C⁻¹ E| < 1 and φ = |C⁻¹ f| in the norm of the largest component, C + E is
//! regular and |x' − x| ≤ (φ + ε |x|) / (1 − ε). The rows of C⁻¹ are cross products of the columns over the
//! determinant.

use dashu_int::IBig;
use dashu_int::ops::Abs;

use super::free::Pair;
use super::gap::displacement;
use super::path::Path;
use super::quaternion::{Matrix, Vector, cross, dot, image, mixed_rotation, multiple};
use super::root::{ROOT_PLACES, quotient_above, root_above};
use super::stretch::Stretch;
use super::turning::ANGLE_PLACES;
use crate::collision::displaced::Displaced;
use crate::collision::location::{LocationCertificate, certified_coefficients, proven};
use crate::exact::grid::Grid;
use crate::exact::proportion::Proportion;
use crate::reduction::nearest_point::{Reach, reach};
use crate::verdict::Stop;

/// The work on the nearest points of two bodies.
const MOST_WORK: u64 = 200_000;

/// The coefficient of a basis generator is written within this of the one that solves the system as the bodies are
/// placed, where placements are enclosed.
const WRITTEN_WITHIN: f64 = 1.0 / (1 << 20) as f64;

/// Both bodies at one time.
struct Placed {
    /// The vector from one centre to the other, and all generators, times `scale`.
    question: Displaced,
    /// A positive number of units of lengths.
    scale: IBig,
    /// For each body, a bound of the angle by which it is off, in units of 2^-160.
    angles_off: [IBig; 2],
    /// A bound of how far points of both together are off, in units of 2^-192 of those of lengths.
    off: IBig,
    /// The number of generators of the first body.
    first: usize,
}

/// The placements of both bodies at a time: more than one pair where a piece of a motion ends and another begins.
pub(super) fn stretches_at(paths: &[Path; 2], time: f64) -> Vec<[Stretch; 2]> {
    let exponent = paths.iter().flat_map(Path::breaks).chain([time, 1.0]);
    let exponent = Grid::of(exponent).exponent().min(0);
    let (time, places) = (Grid::at(exponent).units(time), exponent.unsigned_abs() as usize);
    let [a, b] = paths.each_ref().map(|path| path.stretches([&time, &time], places));
    a.iter().flat_map(|a| b.iter().map(|b| [a.clone(), b.clone()])).collect()
}

impl Pair {
    /// The bodies as they are placed at a time: more than once where a piece of a motion ends and another begins.
    fn placed_at(&self, time: f64) -> Vec<Placed> {
        stretches_at(&self.paths, time).iter().map(|stretches| self.placed(stretches.each_ref())).collect()
    }

    fn placed(&self, stretches: [&Stretch; 2]) -> Placed {
        let rotations: [Matrix; 2] = stretches.map(|stretch| mixed_rotation(&stretch.turns[0], &stretch.turns[0]));
        let scales = stretches.map(Stretch::scale);
        let place = |i: usize| {
            let solid = &self.solids[i];
            let center = multiple(&scales[1 - i], &stretches[i].image(&solid.center));
            let factor = &scales[1 - i] * &stretches[i].weight;
            let generators = solid.generators.iter().map(|g| multiple(&factor, &image(&rotations[i], g)).to_vec());
            (center.to_vec(), generators.collect::<Vec<_>>())
        };
        let ((from, a), (to, b)) = (place(0), place(1));
        Placed {
            question: Displaced::of_vectors(from, to, [a, b].concat(), self.exponent),
            scale: &scales[0] * &scales[1],
            angles_off: stretches.map(|stretch| stretch.angle_off()),
            off: displacement(self.solids.each_ref(), stretches),
            first: self.solids[0].generators.len(),
        }
    }

    /// Proves that the bodies have a common point at a time.
    pub(super) fn prove_contact(&self, time: f64, coefficients: &[f64], basis: &[usize]) -> Result<(), Stop> {
        let mut complaint = "a motion has no placement at the time of the contact".to_owned();
        for placed in self.placed_at(time) {
            match placed.prove_contact(coefficients, basis) {
                Ok(()) => return Ok(()),
                Err(reason) => complaint = reason,
            }
        }
        Err(complaint.into())
    }

    /// Proves that two points of the bodies are within a distance at a time.
    pub(super) fn prove_near(&self, time: f64, distance: f64) -> Result<(), Stop> {
        if distance == f64::INFINITY {
            return Ok(());
        }
        let mut is_open = false;
        for placed in self.placed_at(time) {
            match placed.reach(distance, self.exponent) {
                Reach::Near => return Ok(()),
                Reach::Open => is_open = true,
                Reach::Far => {}
            }
        }
        if is_open {
            return Err(too_much_for_points());
        }
        Err(format!("`distance_at_most` is {distance:?}, but no two points are so near at the time {time:?}").into())
    }
}

/// The note where the nearest points are not found, or placements are not enclosed narrowly enough.
fn too_much_for_points() -> Stop {
    let reason = "whether two points are within `distance_at_most` takes too much exact work, or lies within what \
                  encloses the placements";
    Stop::Unchecked(reason.to_owned())
}

impl Placed {
    fn is_exact(&self) -> bool {
        self.angles_off.iter().all(|off| *off == IBig::ZERO)
    }

    fn prove_contact(&self, coefficients: &[f64], basis: &[usize]) -> Result<(), String> {
        if self.is_exact() {
            let certificate =
                LocationCertificate::Witness { coefficients: coefficients.to_vec(), basis: basis.to_vec() };
            return proven(&self.question, &certificate).map(drop);
        }
        let certified = certified_coefficients(&self.question, coefficients, basis)?;
        let vector = |v: &[IBig]| <Vector>::try_from(v.to_vec()).map_err(|_| "a vector is not of space".to_owned());
        let &[i, j, k] = basis else {
            return Err(format!("certificate: a basis of {} generators, where a motion is enclosed", basis.len()));
        };
        let columns = [i, j, k].map(|index| vector(&self.question.generators[index]));
        let [Ok(a), Ok(b), Ok(c)] = columns else { return Err("a generator is not of space".to_owned()) };
        let rest = vector(&certified.rest)?;
        let rows = [cross(&b, &c), cross(&c, &a), cross(&a, &b)];
        let determinant = dot(&a, &rows[0]);
        let size = determinant.clone().abs();
        // |E| over all columns and |f|, rounded up to units of lengths times the scale.
        let turned = |(index, column): (usize, &Vector)| {
            let angle = &self.angles_off[usize::from(index >= self.first)];
            quotient_above(&(root_above(&dot(column, column)) * angle), &(IBig::ONE << (ROOT_PLACES + ANGLE_PLACES)))
        };
        let columns_off: IBig = [(i, &a), (j, &b), (k, &c)].into_iter().map(turned).sum();
        let rest_off = quotient_above(&(&self.off * &self.scale), &(IBig::ONE << (ROOT_PLACES + ANGLE_PLACES)));
        for (row, index) in rows.iter().zip([i, j, k]) {
            let length = quotient_above(&root_above(&dot(row, row)), &(IBig::ONE << ROOT_PLACES));
            let (epsilon, phi) = (&length * &columns_off, length * &rest_off);
            // Over the determinant, and the rest of the coefficients over `one`.
            let solved = dot(row, &rest);
            let left = &size - &epsilon;
            let is_within = left > IBig::ZERO
                && solved.clone().abs() * &left + (epsilon + phi) * &size * &certified.one
                    <= &left * &size * &certified.one;
            if !is_within || determinant == IBig::ZERO {
                return Err(format!(
                    "certificate: the coefficient of basis generator {index} is not strictly in [-1, 1], whatever the \
                     enclosed placements are"
                ));
            }
            let exact = Proportion::new(solved, &determinant * &certified.one, 0);
            let written = coefficients[index];
            let is_written = (-1.0..=1.0).contains(&written)
                && exact
                    .minus(&Proportion::of_double(written))
                    .magnitude()
                    .compare(&Proportion::of_double(WRITTEN_WITHIN))
                    .is_le();
            if !is_written {
                let nearest = exact.nearest();
                return Err(format!(
                    "certificate: coefficient {index}, of the basis, is {written:?}, but the others imply {nearest:?}"
                ));
            }
        }
        Ok(())
    }

    /// Whether two points are within a distance, as the motions put them: open where that depends on what encloses
    /// them.
    fn reach(&self, distance: f64, exponent: i32) -> Reach {
        let scaled = |length: &Proportion| length.times(&Proportion::whole(self.scale.clone(), 0));
        let unit = Proportion::of_double(1.0).over(&Proportion::whole(IBig::ONE, exponent));
        let (Some(unit), places) = (unit, (ROOT_PLACES + ANGLE_PLACES) as i32) else { return Reach::Open };
        let asked = Proportion::of_double(distance).times(&unit);
        let off = Proportion::whole(self.off.clone(), -places);
        let mut work = MOST_WORK;
        let nearest = asked.minus(&off);
        if !nearest.is_negative() {
            match reach(&self.question.p, &self.question.generators, &scaled(&nearest), &mut work) {
                Reach::Near => return Reach::Near,
                Reach::Open => return Reach::Open,
                Reach::Far if self.is_exact() => return Reach::Far,
                Reach::Far => {}
            }
        }
        match reach(&self.question.p, &self.question.generators, &scaled(&asked.plus(&off)), &mut work) {
            Reach::Far => Reach::Far,
            Reach::Near | Reach::Open => Reach::Open,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The generators of the first test have this length.
    const SIDE: i32 = 1 << 20;

    /// The angle 1 / `over` in units of 2^-160.
    fn angle(over: u32) -> IBig {
        (IBig::ONE << ANGLE_PLACES) / IBig::from(over)
    }

    /// The first body has generators along the first two axes, and the second along the third and the first one. The
    /// vector between the centres is a multiple of the first generator and a quarter of the last.
    fn four_generators(first: i32, angles_off: [IBig; 2], off: IBig) -> Placed {
        let along = |axis: usize| {
            let mut generator = vec![IBig::ZERO; 3];
            generator[axis] = IBig::from(SIDE);
            generator
        };
        let to = vec![IBig::from(first + SIDE / 4), IBig::ZERO, IBig::ZERO];
        let question = Displaced::of_vectors(vec![IBig::ZERO; 3], to, [0, 1, 2, 0].map(along).to_vec(), 0);
        Placed { question, scale: IBig::from(1 << 10), angles_off, off, first: 2 }
    }

    #[test]
    fn a_coefficient_leaves_room_for_all_that_the_placements_are_off() {
        // The number ε is 1/32 for either generator of the first body and 1/8 for that of the second; φ is 1/16.
        let off = IBig::from(SIDE / 16) << (ROOT_PLACES + ANGLE_PLACES - 10);
        let (epsilon, phi) = (2.0 / 32.0 + 1.0 / 8.0, 1.0 / 16.0);
        // The sum |x| (1 − ε) + ε + φ is at most 1 − ε.
        let limit = (1.0 - 2.0 * epsilon - phi) / (1.0 - epsilon);
        let told = |x: f64| {
            let first = (x * f64::from(SIDE)).round() as i32;
            let placed = four_generators(first, [angle(32), angle(8)], off.clone());
            placed.prove_contact(&[f64::from(first) / f64::from(SIDE), 0.0, 0.0, 0.25], &[0, 1, 2])
        };
        for sign in [1.0, -1.0] {
            assert_eq!(told(sign * (limit - 1e-4)), Ok(()));
            let refused = told(sign * (limit + 1e-4)).expect_err("no room is left");
            assert!(refused.contains("generator 0 is not strictly in [-1, 1]"), "{refused}");
        }
        assert!(told(0.0).is_ok());
    }

    #[test]
    fn a_coefficient_may_use_all_the_room_and_no_more() {
        // Generators (4, 0, 0), (0, 4, 0) and (0, 0, 4) of a body that is where it is, and one that is short along the
        // first axis, with the coefficient 1/16. The vector between the centres is (3, 0, 0), so that the first
        // coefficient is (48 - short) / 64. All points together are off by one unit, and the length 16 of a row of the
        // inverse is rounded up to 17: that leaves a coefficient of (64 - 17) / 64.
        let told = |short: i32| {
            let generators = [[4, 0, 0], [0, 4, 0], [0, 0, 4], [short, 0, 0]].map(|g| g.map(IBig::from).to_vec());
            let to = [3, 0, 0].map(IBig::from).to_vec();
            let question = Displaced::of_vectors(vec![IBig::ZERO; 3], to, generators.to_vec(), 0);
            let off = IBig::ONE << (ROOT_PLACES + ANGLE_PLACES);
            let placed = Placed { question, scale: IBig::ONE, angles_off: [IBig::ZERO, IBig::ONE], off, first: 4 };
            placed.prove_contact(&[f64::from(48 - short) / 64.0, 0.0, 0.0, 0.0625], &[0, 1, 2])
        };
        assert_eq!((told(1), told(2)), (Ok(()), Ok(())));
        assert!(told(0).is_err());
    }

    #[test]
    fn points_are_near_far_or_open_by_what_they_may_be_off() {
        // Two points at the distance 10 are off by 1 together, and are placed in thirds of the unit.
        let placed = |angles_off: [IBig; 2], off: u32| Placed {
            question: Displaced::of_vectors(vec![IBig::ZERO; 3], [30, 0, 0].map(IBig::from).to_vec(), Vec::new(), 0),
            scale: IBig::from(3),
            angles_off,
            off: IBig::from(off) << (ROOT_PLACES + ANGLE_PLACES),
            first: 0,
        };
        let turned = placed([IBig::ONE, IBig::ZERO], 1);
        for (distance, expected) in [
            (11.0, Reach::Near),
            (11.0_f64.next_down(), Reach::Open),
            (10.0, Reach::Open),
            (9.0, Reach::Open),
            (9.0_f64.next_down(), Reach::Far),
            (0.5, Reach::Far),
        ] {
            assert_eq!(turned.reach(distance, 0), expected, "{distance}");
        }
        let exact = placed([IBig::ZERO, IBig::ZERO], 0);
        assert_eq!(exact.reach(10.0, 0), Reach::Near);
        assert_eq!(exact.reach(10.0_f64.next_down(), 0), Reach::Far);
    }

    #[test]
    fn nearest_points_of_exact_placements_are_looked_for_once() {
        // One round of so many generators and bits is more than half of the work that may be done, and is enough.
        let bits = 40_000_usize;
        let to = vec![IBig::ONE << bits, IBig::ZERO, IBig::ZERO];
        let question = Displaced::of_vectors(vec![IBig::ZERO; 3], to, vec![vec![IBig::ZERO; 3]; 1_000], 0);
        let exact = [IBig::ZERO, IBig::ZERO];
        let placed = Placed { question, scale: IBig::ONE, angles_off: exact, off: IBig::ZERO, first: 0 };
        assert_eq!(placed.reach(1.0, 0), Reach::Far);
        let turned = Placed { angles_off: [IBig::ONE, IBig::ZERO], off: IBig::ONE, ..placed };
        assert_eq!(turned.reach(1.0, 0), Reach::Open);
    }
}
