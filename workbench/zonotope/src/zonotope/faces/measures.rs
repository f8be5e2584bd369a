//! Volume, exactly, and surface area of a zonotope of space.

use super::circles::Circles;
use super::determinants::HalfEdges;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::linear::{cross, dot};
use crate::numeric::scaling::{binary_exponent, scale_by_power_of_two};
use crate::numeric::tolerance::UNIT;
use crate::zonotope::Zonotope;
use crate::zonotope::directions::Directions;

/// A rounded number and how far it may be off.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// The rounded number.
    pub value: f64,
    /// A bound for its distance from the exact one; infinite if it may not be a double.
    pub error: f64,
}

impl Zonotope<3> {
    /// The volume, exactly: 8 Σ |det(g_i, g_j, g_k)| over triples of generators; 0 if the body is flat.
    ///
    /// Around each circle the generators south of it follow one another with positive determinants, so that prefix sums
    /// add them up: O(n²) exact operations after O(n² log n) comparisons, O(n) space.
    pub fn exact_volume(&self) -> Dyadic {
        let directions = Directions::of_finite(self.generators());
        if directions.len() < 3 {
            return Dyadic::zero();
        }
        let circles = Circles::new(directions.representatives());
        let mut half_edges = HalfEdges::new(&circles, &directions, self.generators());
        let (mut keys, mut crossings) = (Vec::new(), Vec::new());
        let mut sum = Dyadic::zero();
        for rank in 0..circles.len() {
            circles.crossings(rank, &mut keys, &mut crossings, &mut ());
            sum = sum + half_edges.determinants_south_of(rank, &crossings);
        }
        sum.scaled(3)
    }

    /// The surface area: 8 Σ |g_i × g_j| over pairs of generators, both sides of a flat body. O(n²).
    ///
    /// With coordinates scaled below 2, a cross product is off by at most 5 u |g_i| |g_j|, u = 2^-53, its length by 4 u
    /// of itself more, and the sum, row by row, by n u for the rows and n u for their total; the products of lengths
    /// add up to less than half the square of Σ |g_i|.
    pub fn surface_area(&self) -> Estimate {
        let exponent = self.generators().as_flattened().iter().filter_map(|&c| binary_exponent(c)).max().unwrap_or(0);
        let shift = i64::from(exponent);
        let scaled: Vec<[f64; 3]> =
            self.generators().iter().map(|g| g.map(|c| scale_by_power_of_two(c, -shift))).collect();
        let row = |i: usize| scaled[..i].iter().map(|g| length(cross(&scaled[i], g))).sum::<f64>();
        let sum: f64 = (0..scaled.len()).map(row).sum();
        let total_length: f64 = scaled.iter().map(|&g| length(g)).sum();
        let count = scaled.len() as f64;
        let error = 1.01 * UNIT * (2.5 * total_length * total_length + (2.0 * count + 8.0) * sum)
            + count * count * f64::MIN_POSITIVE;
        let [value, error] = [sum, error].map(|v| scale_by_power_of_two(v, 2 * shift + 3));
        let error = if value.is_finite() { (error * (1.0 + 2.0 * UNIT)).next_up() } else { f64::INFINITY };
        Estimate { value, error }
    }
}

fn length(v: [f64; 3]) -> f64 {
    dot(&v, &v).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_box_and_its_scales() {
        for scale in [1.0, 1e-100, 1e100] {
            let edges = vec![[scale, 0.0, 0.0], [0.0, -2.0 * scale, 0.0], [0.0, 0.0, 3.0 * scale]];
            let brick = Zonotope::new([9.0; 3], edges).expect("finite");
            let [cube, square] =
                [3, 2].map(|power| (0..power).fold(Dyadic::from_f64(1.0), |p, _| p * Dyadic::from_f64(scale)));
            let volume = brick.exact_volume();
            let ratio = volume.ratio(&cube);
            assert!((ratio - 48.0).abs() < 1e-13);
            let area = brick.surface_area();
            assert!((area.value - 88.0 * square.to_f64()).abs() <= area.error + 1e-13 * area.value);
            assert!(area.error < 1e-13 * area.value);
        }
    }

    #[test]
    fn areas_out_of_range_are_infinite() {
        let flat = Zonotope::new([0.0; 3], vec![[f64::MAX, 0.0, 0.0], [0.0, f64::MAX, 0.0]]).expect("finite");
        assert!(flat.exact_volume().is_zero());
        assert_eq!(flat.surface_area(), Estimate { value: f64::INFINITY, error: f64::INFINITY });
        assert_eq!(Zonotope::<3>::new([0.0; 3], vec![]).expect("finite").surface_area().value, 0.0);
    }

    properties! {
        #[test]
        fn measures_are_sums_over_generators(
            generators in proptest::collection::vec([-3i8..4, -3i8..4, -3i8..4].prop_map(|v| v.map(f64::from)), 0..9),
        ) {
            let n = generators.len();
            let g = &generators;
            let (mut volume, mut area) = (0.0, 0.0);
            for i in 0..n {
                for j in 0..i {
                    area += 8.0 * length(cross(&g[i], &g[j]));
                    volume += (0..j).map(|k| 8.0 * dot(&g[k], &cross(&g[i], &g[j])).abs()).sum::<f64>();
                }
            }
            let body = Zonotope::new([0.5; 3], generators).expect("finite");
            prop_assert_eq!(body.exact_volume().to_f64(), volume);
            let estimate = body.surface_area();
            prop_assert!((estimate.value - area).abs() <= estimate.error + 1e-13 * area);
        }
    }
}
