//! Proptest strategies for questions of collision in any dimension, about generators of any family.
//!
//! A question is generators and the two ends of a displacement. Where the displacement ends is constructed from the
//! generators: on a vertex, an edge or a facet, a unit in the last place off it, well inside, well outside, in the
//! centre.

use proptest::collection::vec;
use proptest::prelude::*;
use zonotope::collision::Query;

use families::drawn::bodies::Generators;
use families::drawn::numbers::moved_by_ulps;

/// The ends of a displacement and the generators that it is relative to.
#[derive(Clone, Debug)]
pub struct Asked<const D: usize> {
    /// The start of the displacement.
    pub from: [f64; D],
    /// The end of the displacement.
    pub to: [f64; D],
    /// The generators.
    pub generators: Generators<D>,
}

impl<const D: usize> Asked<D> {
    /// The question as the library takes it.
    pub fn displacement(&self) -> Query<'_, D> {
        Query::new(self.from, self.to, &self.generators).expect("the families make finite numbers")
    }
}

/// Questions about generators of a family.
pub fn asked<const D: usize>(generators: BoxedStrategy<Generators<D>>) -> BoxedStrategy<Asked<D>> {
    let place = prop_oneof![
        3 => (0.0..3.0f64).prop_map(Place::Through),
        4 => Just(Place::Facet),
        2 => Just(Place::Edge),
        2 => Just(Place::Vertex),
        1 => Just(Place::Center),
        1 => Just(Place::Anywhere),
    ];
    let steps = prop_oneof![2 => Just(0i32).boxed(), 1 => (-2..=2i32).boxed()];
    let start = prop_oneof![3 => Just(Start::Origin), 2 => Just(Start::Tail), 1 => Just(Start::Far)];
    (
        generators,
        place,
        vec(-1.0..1.0f64, D),
        vec(0..5usize, D),
        vec(any::<prop::sample::Index>(), D),
        vec(steps, D),
        start,
    )
        .prop_map(|(generators, place, random, shares, chosen, steps, start)| {
            let exact = place.sums(&generators, &random, &shares, &chosen);
            let [sum, tail] = exact;
            let mut to: [f64; D] = std::array::from_fn(|k| moved_by_ulps(sum[k], steps[k]).clamp(-f64::MAX, f64::MAX));
            let from: [f64; D] = match start {
                Start::Origin => [0.0; D],
                Start::Tail => tail.map(|v| -v),
                Start::Far => {
                    to = std::array::from_fn(|k| (to[k] + 1e16).clamp(-f64::MAX, f64::MAX));
                    std::array::from_fn(|k| if shares[k] == 0 { -1.0 } else { 1e16 })
                }
            };
            Asked { from, to, generators }
        })
        .boxed()
}

#[derive(Clone, Copy, Debug)]
enum Start {
    /// The displacement starts at the origin, so that it is `to` itself.
    Origin,
    /// The displacement starts at what the rounding of `to` lost, so that the difference is exact.
    Tail,
    /// The displacement starts so far away that the difference of its ends loses digits.
    Far,
}

#[derive(Clone, Copy, Debug)]
enum Place {
    /// A multiple of a boundary point.
    Through(f64),
    Facet,
    Edge,
    Vertex,
    Center,
    Anywhere,
}

impl Place {
    /// The point as the sum of two vectors, exactly unless its digits do not fit.
    fn sums<const D: usize>(
        self,
        generators: &[[f64; D]],
        random: &[f64],
        shares: &[usize],
        chosen: &[prop::sample::Index],
    ) -> [[f64; D]; 2] {
        let on_face = match self {
            Self::Center => return [[0.0; D]; 2],
            Self::Anywhere => return [std::array::from_fn(|k| 2.0 * random[k]), [0.0; D]],
            Self::Facet | Self::Through(_) => D - 1,
            Self::Edge => 1,
            Self::Vertex => 0,
        };
        let count = on_face.min(generators.len());
        let face: Vec<usize> = (0..count).map(|k| chosen[k].index(generators.len())).collect();
        let normal = normal_of(generators, &face, random);
        let mut total = [[0.0; D]; 2];
        for (i, generator) in generators.iter().enumerate() {
            let along: f64 = generator.iter().zip(&normal).map(|(a, b)| a * b).sum();
            let coefficient = match face.iter().position(|&f| f == i) {
                Some(k) => [-1.0, -0.5, 0.0, 0.5, 1.0][shares[k]],
                None => along.signum(),
            };
            for k in 0..D {
                // The rounded sum and, in the second vector, what is lost.
                let [sum, lost] = [total[0][k], coefficient * generator[k]];
                let next = sum + lost;
                let back = next - sum;
                total[0][k] = next;
                total[1][k] += (sum - (next - back)) + (lost - back);
            }
        }
        let factor = if let Self::Through(factor) = self { factor } else { 1.0 };
        total.map(|part| part.map(|v| if v.is_nan() { 0.0 } else { (v * factor).clamp(-f64::MAX, f64::MAX) }))
    }
}

/// A direction near orthogonal to the generators of a face: a random one with their shares taken out.
fn normal_of<const D: usize>(generators: &[[f64; D]], face: &[usize], random: &[f64]) -> [f64; D] {
    let largest = generators.iter().flatten().fold(f64::MIN_POSITIVE, |m, v| m.max(v.abs()));
    let mut normal: [f64; D] = std::array::from_fn(|k| random[k]);
    let mut axes: Vec<[f64; D]> = Vec::new();
    let dot = |a: &[f64; D], b: &[f64; D]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    for &f in face {
        let mut axis = generators[f].map(|v| v / largest);
        for other in &axes {
            let along = dot(&axis, other);
            axis = std::array::from_fn(|k| axis[k] - along * other[k]);
        }
        let length = dot(&axis, &axis).sqrt();
        if length > 0.0 {
            axes.push(axis.map(|v| v / length));
        }
    }
    for _ in 0..2 {
        for axis in &axes {
            let along = dot(&normal, axis);
            normal = std::array::from_fn(|k| normal[k] - along * axis[k]);
        }
    }
    normal.map(|v| v / largest.sqrt())
}
