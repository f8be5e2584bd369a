//! Quaternions w + x i + y j + z k as [w, x, y, z], and the rotation of one as a quadratic form, over any numbers.
//!
//! A quaternion q of any length but 0 turns v to R(q) v = R̃(q, q) v / |q|², where R̃ is bilinear and symmetric.
//! Nothing is divided, so that rational quaternions have rational rotations without a root.

use crate::numeric::linear::{Ring, cross, dot};

/// A quaternion [w, x, y, z].
pub(super) type Quaternion<T> = [T; 4];

/// The quaternion that turns nothing.
pub(super) fn identity<T: Ring>() -> Quaternion<T> {
    [T::ONE, T::ZERO, T::ZERO, T::ZERO]
}

/// The conjugate: the turn back.
#[inline]
pub(super) fn conjugate<T: Ring>([w, x, y, z]: &Quaternion<T>) -> Quaternion<T> {
    let opposite = |c: &T| T::ZERO.minus(c);
    [w.clone(), opposite(x), opposite(y), opposite(z)]
}

/// The product p q: the turn of q, then that of p.
#[inline]
pub(super) fn composition<T: Ring>(p: &Quaternion<T>, q: &Quaternion<T>) -> Quaternion<T> {
    let ((w, a), (s, b)) = (parts(p), parts(q));
    let [x, y, z] = cross(&a, &b);
    let part = |k: usize, c: &T| w.times(&b[k]).plus(&s.times(&a[k])).plus(c);
    [w.times(&s).minus(&dot(&a, &b)), part(0, &x), part(1, &y), part(2, &z)]
}

/// The sum of two quaternions.
#[inline]
pub(super) fn sum<T: Ring>(p: &Quaternion<T>, q: &Quaternion<T>) -> Quaternion<T> {
    [0, 1, 2, 3].map(|k| p[k].plus(&q[k]))
}

/// The multiple of a quaternion.
#[inline]
pub(super) fn multiple<T: Ring>(factor: &T, q: &Quaternion<T>) -> Quaternion<T> {
    q.each_ref().map(|c| factor.times(c))
}

/// R̃(p, q) by rows: the polar form of q ↦ |q|² R(q), symmetric in both.
#[inline]
pub(super) fn polar_rotation<T: Ring>(p: &Quaternion<T>, q: &Quaternion<T>) -> [[T; 3]; 3] {
    let ((w, a), (s, b)) = (parts(p), parts(q));
    let along = w.times(&s).minus(&dot(&a, &b));
    // the cross product with this vector
    let [x, y, z] = [0, 1, 2].map(|k| w.times(&b[k]).plus(&s.times(&a[k])));
    let twice = |i: usize, j: usize| a[i].times(&b[j]).plus(&a[j].times(&b[i]));
    let [xy, xz, yz] = [twice(0, 1), twice(0, 2), twice(1, 2)];
    [
        [along.plus(&twice(0, 0)), xy.minus(&z), xz.plus(&y)],
        [xy.plus(&z), along.plus(&twice(1, 1)), yz.minus(&x)],
        [xz.minus(&y), yz.plus(&x), along.plus(&twice(2, 2))],
    ]
}

/// M v.
#[inline]
pub(super) fn image<T: Ring>(rows: &[[T; 3]; 3], v: &[T; 3]) -> [T; 3] {
    rows.each_ref().map(|row| dot(row, v))
}

/// Mᵀ u.
#[inline]
pub(super) fn transposed_image<T: Ring>(rows: &[[T; 3]; 3], u: &[T; 3]) -> [T; 3] {
    [0, 1, 2].map(|k| rows[0][k].times(&u[0]).plus(&rows[1][k].times(&u[1])).plus(&rows[2][k].times(&u[2])))
}

/// The real part and the vector.
#[inline]
fn parts<T: Ring>([w, x, y, z]: &Quaternion<T>) -> (T, [T; 3]) {
    (w.clone(), [x.clone(), y.clone(), z.clone()])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::dyadic::Dyadic;
    use proptest::prelude::*;

    #[test]
    fn a_quarter_turn_about_an_axis_of_any_length() {
        // 1 + k has length √2 and turns by 90° about z
        let q = [1.0, 0.0, 0.0, 1.0];
        assert_eq!(image(&polar_rotation(&q, &q), &[3.0, 0.0, 5.0]), [0.0, 6.0, 10.0]);
        assert_eq!(composition(&q, &q), [0.0, 0.0, 0.0, 2.0], "two of them are half a turn");
        assert_eq!(composition(&q, &conjugate(&q)), [2.0, 0.0, 0.0, 0.0]);
        assert_eq!(composition(&identity(), &q), q);
    }

    properties! {
        #[test]
        fn the_rotation_of_a_product_is_the_product_of_rotations(
            q in proptest::array::uniform4(-9i8..=9),
            r in proptest::array::uniform4(-9i8..=9),
            v in proptest::array::uniform3(-9i8..=9),
        ) {
            let number = |c: i8| Dyadic::from_f64(f64::from(c));
            let (q, r, v) = (q.map(number), r.map(number), v.map(number));
            let rotation = |q: &Quaternion<Dyadic>| polar_rotation(q, q);
            let both = composition(&q, &r);
            let image_of_both = image(&rotation(&both), &v);
            prop_assert_eq!(&image_of_both, &image(&rotation(&q), &image(&rotation(&r), &v)));
            let turned_back = transposed_image(&rotation(&both), &image_of_both);
            let square = dot(&both, &both);
            prop_assert_eq!(turned_back, v.map(|c| &(&c * &square) * &square));
            // bilinear: R̃(q + r) = R̃(q) + 2 R̃(q, r) + R̃(r)
            let [of_sum, of_q, of_r] = [rotation(&sum(&q, &r)), rotation(&q), rotation(&r)];
            let mixed = polar_rotation(&q, &r);
            for (i, k) in (0..3).flat_map(|i| (0..3).map(move |k| (i, k))) {
                prop_assert_eq!(&of_sum[i][k], &(&(&of_q[i][k] + &of_r[i][k]) + &(&mixed[i][k] + &mixed[i][k])));
            }
        }
    }
}
