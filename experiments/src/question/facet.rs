//! A point of a random facet, and certified bounds of the gauge near it.

use families::source::RandomSource;
use std::cmp::Ordering;
use zonotope::numeric::dyadic::Dyadic;
use zonotope::numeric::exact_sum::ExactSum;

type Exact = [Dyadic; 3];

/// The number of pairs of generators that are tried before a body is taken for a segment.
const PAIR_LIMIT: usize = 64;

/// A point of a facet of the body { Σ δ_i g_i : |δ_i| ≤ 1 }; of an edge, if the body is flat.
pub(super) struct Facet {
    /// The outward normal u, exactly.
    normal: Exact,
    /// A point of the facet: normal · point = h(normal), and its gauge is 1.
    pub point: Exact,
    /// Whether all generators lie in a plane.
    pub is_flat: bool,
}

impl Facet {
    /// A random point of a random facet; none if no two generators that span a plane were drawn.
    pub fn random(generators: &[[f64; 3]], source: &mut RandomSource) -> Option<Self> {
        if generators.len() < 2 {
            return None;
        }
        let [first, across] = (0..PAIR_LIMIT).find_map(|_| {
            let [v, w] = [0, 1].map(|_| generators[source.below(generators.len())].map(Dyadic::from_f64));
            let across = cross(&v, &w);
            (!is_zero(&across)).then_some([v, across])
        })?;
        let flip = source.bits() >> 63 == 1;
        let outward = |normal: Exact| if flip { normal.map(|c| -c) } else { normal };
        let normal = outward(across.clone());
        let signs = signs(generators, &normal);
        let is_flat = signs.iter().all(|sign| sign.is_eq());
        let (normal, signs) = if is_flat {
            let normal = outward(cross(&first, &across));
            let signs = self::signs(generators, &normal);
            (normal, signs)
        } else {
            (normal, signs)
        };
        let mut sums: [ExactSum; 3] = Default::default();
        for (generator, sign) in generators.iter().zip(signs) {
            let coefficient = match sign {
                Ordering::Greater => 1.0,
                Ordering::Less => -1.0,
                Ordering::Equal => source.below(5) as f64 / 2.0 - 1.0,
            };
            for (sum, c) in sums.iter_mut().zip(generator) {
                sum.add(coefficient * c);
            }
        }
        Some(Self { normal, point: sums.map(|sum| sum.value()), is_flat })
    }

    /// Certified bounds of the gauge of `asked`, less 1, where `asked` is `factor` times the facet's point up to
    /// rounding; none if the rounding error cannot be written in sums of generators.
    pub fn excess_of(&self, asked: &Exact, factor: &Dyadic, generators: &[[f64; 3]]) -> Option<[f64; 2]> {
        let one = Dyadic::from_f64(1.0);
        let support = dot(&self.normal, &self.point);
        let low = (dot(&self.normal, asked) - support.clone()).ratio(&support);
        let error: Exact = std::array::from_fn(|i| &asked[i] - &(&self.point[i] * factor));
        let high = (factor - &one).to_f64() + coefficient_bound(&error, generators, self.is_flat)?;
        Some([low, high])
    }
}

/// The signs of the products of the generators with a direction: by floats where they leave no doubt.
fn signs(generators: &[[f64; 3]], direction: &Exact) -> Vec<Ordering> {
    // Each coordinate of the direction is off by at most 2^-50 of itself, each of five roundings by 2^-53 of the sum of
    // magnitudes.
    const DOUBT: f64 = 1.0 / (1_u64 << 48) as f64;
    let rounded = direction.each_ref().map(Dyadic::to_f64);
    let sign = |generator: &[f64; 3]| {
        let terms: [f64; 3] = std::array::from_fn(|i| generator[i] * rounded[i]);
        let sum: f64 = terms.iter().sum();
        if sum.abs() > DOUBT * terms.iter().map(|t| t.abs()).sum::<f64>() {
            return sum.total_cmp(&0.0);
        }
        dot(&generator.map(Dyadic::from_f64), direction).sign()
    };
    generators.iter().map(sign).collect()
}

/// A bound for the gauge of a small vector: with the generators put into groups, one for each vector of a basis, and
/// turned to point along it, the largest coefficient of the vector in terms of the groups' sums. The groups are a
/// guess, the coefficients are exact.
fn coefficient_bound(vector: &Exact, generators: &[[f64; 3]], is_flat: bool) -> Option<f64> {
    if is_zero(vector) {
        return Some(0.0);
    }
    let duals = wide_basis(generators, is_flat);
    let mut sums: [[ExactSum; 3]; 3] = Default::default();
    for generator in generators {
        let along = duals.map(|dual| rounded_dot(&dual, generator));
        let group = (1..3).fold(0, |best, i| if along[i].abs() > along[best].abs() { i } else { best });
        let sign = along[group].signum();
        for (sum, c) in sums[group].iter_mut().zip(generator) {
            sum.add(sign * c);
        }
    }
    let [a, b, mut c] = sums.map(|group| group.map(|sum| sum.value()));
    if is_flat {
        c = cross(&a, &b);
    }
    let determinant = dot(&cross(&a, &b), &c);
    let coefficients = [cross(&b, &c), cross(&c, &a), cross(&a, &b)].map(|dual| dot(&dual, vector));
    if determinant.is_zero() || (is_flat && !coefficients[2].is_zero()) {
        return None;
    }
    let largest = coefficients.into_iter().map(Dyadic::abs).max()?;
    // The quotient is within a relative 2^-50.
    Some(largest.ratio(&determinant.abs()) * (1.0 + 1e-12))
}

/// The dual basis, rounded, of three generators that span much: the longest one, then the ones of the largest area and
/// volume.
fn wide_basis(generators: &[[f64; 3]], is_flat: bool) -> [[f64; 3]; 3] {
    let widest = |measure: &dyn Fn(&[f64; 3]) -> f64| {
        generators.iter().copied().max_by(|v, w| measure(v).total_cmp(&measure(w))).unwrap_or([0.0; 3])
    };
    let a = widest(&|v| rounded_dot(v, v));
    let b = widest(&|v| {
        let area = rounded_cross(&a, v);
        rounded_dot(&area, &area)
    });
    let normal = rounded_cross(&a, &b);
    let c = if is_flat { normal } else { widest(&|v| rounded_dot(&normal, v).abs()) };
    let volume = rounded_dot(&normal, &c);
    let scaled = |v: [f64; 3]| v.map(|x| x / volume);
    let third = if is_flat { [0.0; 3] } else { scaled(normal) };
    [scaled(rounded_cross(&b, &c)), scaled(rounded_cross(&c, &a)), third]
}

fn rounded_dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn rounded_cross(a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn is_zero(v: &Exact) -> bool {
    v.iter().all(Dyadic::is_zero)
}

fn dot(a: &Exact, b: &Exact) -> Dyadic {
    &(&a[0] * &b[0]) + &(&(&a[1] * &b[1]) + &(&a[2] * &b[2]))
}

fn cross(a: &Exact, b: &Exact) -> Exact {
    let minor = |i: usize, j: usize| &(&a[i] * &b[j]) - &(&a[j] * &b[i]);
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}
