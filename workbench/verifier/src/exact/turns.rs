//! Vectors of the plane in the order of their angles: what adds up along the way.

use std::cmp::Ordering;

use dashu_int::IBig;

use crate::exact::linear::{Vector, is_zero, product};

/// a × b in the plane.
pub(crate) fn turn(a: &Vector, b: &Vector) -> IBig {
    product(&a[0], &b[1]) - product(&a[1], &b[0])
}

/// The vectors of the plane that are not zero, turned into one half of it, in the order of their angles.
pub(crate) fn by_angle(vectors: Vec<Vector>) -> Vec<Vector> {
    let upward = |v: Vector| -> Vector {
        let down = v[1] < IBig::ZERO || v[1] == IBig::ZERO && v[0] < IBig::ZERO;
        if down { v.into_iter().map(|component| -component).collect() } else { v }
    };
    let with_image = |v: Vector| ([v[0].to_f64().value(), v[1].to_f64().value()], v);
    let mut sorted: Vec<([f64; 2], Vector)> =
        vectors.into_iter().filter(|v| !is_zero(v)).map(upward).map(with_image).collect();
    sorted.sort_by(|a, b| side(a, b).reverse());
    sorted.into_iter().map(|(_, v)| v).collect()
}

/// A relative bound of the error of a turn of rounded vectors: each product is rounded three times, the difference
/// once.
const TURN_ERROR: f64 = 8.0 * f64::EPSILON;

/// The side of a on which b lies: in floating point where its error leaves no doubt, else exactly.
fn side((a_image, a): &([f64; 2], Vector), (b_image, b): &([f64; 2], Vector)) -> Ordering {
    let (left, right) = (a_image[0] * b_image[1], a_image[1] * b_image[0]);
    let doubt = (left.abs() + right.abs()) * TURN_ERROR;
    // Nothing compares where a product leaves the range of doubles. Whole numbers have no small products but zero.
    match left - right {
        turn if turn > doubt => Ordering::Greater,
        turn if turn < -doubt => Ordering::Less,
        _ => turn(a, b).cmp(&IBig::ZERO),
    }
}

/// Σ |a × b| over all pairs of vectors of the plane.
pub(crate) fn turns(vectors: Vec<Vector>) -> IBig {
    let mut before = vec![IBig::ZERO; 2];
    by_angle(vectors).iter().map(|v| turn(&passed(&mut before, v), v)).sum()
}

/// The part before v, which is then counted as passed.
fn passed(before: &mut Vector, v: &Vector) -> Vector {
    let after = before.iter().zip(v).map(|(before, component)| before + component).collect();
    std::mem::replace(before, after)
}

/// For each vector of the plane that is not zero, a direction orthogonal to it and how far the zonotope of all of them
/// reaches along it.
pub(crate) fn edges(vectors: Vec<Vector>) -> Vec<(Vector, IBig)> {
    let sorted = by_angle(vectors);
    let mut rest = vec![IBig::ZERO; 2];
    sorted.iter().for_each(|v| drop(passed(&mut rest, v)));
    let mut before = vec![IBig::ZERO; 2];
    let edge = |v: Vector| {
        let before = passed(&mut before, &v);
        let after: Vector = rest.iter().zip(&before).map(|(rest, before)| rest - before).collect();
        let reach = turn(&before, &v) + turn(&v, &after);
        (vec![-&v[1], v[0].clone()], reach)
    };
    sorted.into_iter().map(edge).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::linear::dot;
    use dashu_int::ops::Abs;

    #[test]
    fn edges_reach_as_far_as_the_sums_say() {
        let vector = |x: i64, y: i64| -> Vector { vec![x.into(), y.into()] };
        let vectors = vec![vector(3, 1), vector(-2, 5), vector(0, 0), vector(-3, -1), vector(0, -4), vector(7, 0)];
        let edges = edges(vectors.clone());
        assert_eq!(edges.len(), 5);
        for (u, reach) in &edges {
            let sum: IBig = vectors.iter().map(|v| dot(u, v).abs()).sum();
            assert_eq!(*reach, sum);
        }
        let all: IBig = edges.iter().map(|(_, reach)| reach).sum();
        assert_eq!(all, turns(vectors) * 2);
    }

    /// Vectors beside each other by a unit, with more digits than a double.
    #[test]
    fn vectors_that_are_almost_parallel_are_in_the_order_of_their_angles() {
        let base = IBig::ONE << 62;
        let vectors: Vec<Vector> = (0..40)
            .map(|i: i64| {
                let v = vec![&base + IBig::from(i * 37 % 11), &base + IBig::from(i * 17 % 13)];
                if i % 3 == 0 { v.into_iter().map(|x| -x).collect() } else { v }
            })
            .chain([vec![-&base, IBig::ZERO], vec![base.clone(), -IBig::ONE], vec![IBig::ONE, IBig::ZERO]])
            .collect();
        let sorted = by_angle(vectors.clone());
        assert_eq!(sorted.len(), vectors.len());
        for (at, a) in sorted.iter().enumerate() {
            assert!(a[1] > IBig::ZERO || a[1] == IBig::ZERO && a[0] > IBig::ZERO, "they are turned upward");
            assert!(sorted[at + 1..].iter().all(|b| turn(a, b) >= IBig::ZERO), "{sorted:?}");
        }
        let pairs = vectors.iter().enumerate().flat_map(|(at, a)| vectors[at + 1..].iter().map(move |b| (a, b)));
        assert_eq!(turns(vectors.clone()), pairs.map(|(a, b)| turn(a, b).abs()).sum::<IBig>());
    }

    fn with_image(v: Vector) -> ([f64; 2], Vector) {
        ([v[0].to_f64().value(), v[1].to_f64().value()], v)
    }

    /// Pairs of vectors of about 100 bits, of which one is a multiple of the other but for some units: the products of
    /// the rounded components tell the side wrong at times.
    #[test]
    fn sides_of_long_vectors_are_exact() {
        let mut wrong = 0;
        for i in 1..200_u64 {
            let long = |seed: u64| IBig::from(seed.wrapping_mul(6_364_136_223_846_793_005) >> 1) * (IBig::ONE << 30);
            let [x, y] = [long(i), long(i + 1_000)].map(|number| number + IBig::from(i));
            for (dx, dy) in [(0, 0), (0, 1), (1, 0), (0, -1), (-1, 0), (1, 1)] {
                let a = with_image(vec![x.clone(), y.clone()]);
                let b = with_image(vec![&x * 3 + IBig::from(dx), &y * 3 + IBig::from(dy)]);
                let exact = turn(&a.1, &b.1).cmp(&IBig::ZERO);
                assert_eq!((side(&a, &b), side(&b, &a)), (exact, exact.reverse()), "{i} {dx} {dy}");
                let rounded = a.0[0] * b.0[1] - a.0[1] * b.0[0];
                wrong += usize::from(rounded.partial_cmp(&0.0) != Some(exact));
            }
        }
        assert!(wrong > 100, "{wrong}");
    }

    #[test]
    fn vectors_of_one_axis_lie_on_no_side_of_each_other() {
        for vectors in [[[1, 0], [2, 0]], [[0, 3], [0, 1]], [[5, 0], [-5, 0]], [[1, 2], [2, 4]]] {
            let [a, b] = vectors.map(|v: [i64; 2]| with_image(v.map(IBig::from).to_vec()));
            assert_eq!((side(&a, &b), side(&b, &a)), (Ordering::Equal, Ordering::Equal), "{vectors:?}");
        }
        let [a, b] = [[1, 0], [0, 1]].map(|v: [i64; 2]| with_image(v.map(IBig::from).to_vec()));
        assert_eq!((side(&a, &b), side(&b, &a)), (Ordering::Greater, Ordering::Less));
    }
}
