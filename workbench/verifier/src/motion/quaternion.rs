//! Quaternions [w, x, y, z] of whole numbers. One of any length but 0 is a rotation: |q|² R(q) has whole entries.

use dashu_int::IBig;

pub(super) type Vector = [IBig; 3];
pub(super) type Quaternion = [IBig; 4];
pub(super) type Matrix = [Vector; 3];

/// The quaternion that turns nothing.
pub(super) fn identity() -> Quaternion {
    [IBig::ONE, IBig::ZERO, IBig::ZERO, IBig::ZERO]
}

pub(super) fn dot<const N: usize>(a: &[IBig; N], b: &[IBig; N]) -> IBig {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

pub(super) fn cross(a: &Vector, b: &Vector) -> Vector {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &a[i] * &b[j] - &a[j] * &b[i])
}

pub(super) fn sum<const N: usize>(a: &[IBig; N], b: &[IBig; N]) -> [IBig; N] {
    std::array::from_fn(|k| &a[k] + &b[k])
}

pub(super) fn difference<const N: usize>(a: &[IBig; N], b: &[IBig; N]) -> [IBig; N] {
    std::array::from_fn(|k| &a[k] - &b[k])
}

pub(super) fn multiple<const N: usize>(factor: &IBig, v: &[IBig; N]) -> [IBig; N] {
    v.each_ref().map(|c| factor * c)
}

pub(super) fn conjugate([w, x, y, z]: &Quaternion) -> Quaternion {
    [w.clone(), -x, -y, -z]
}

/// p q: the turn of q, then that of p.
pub(super) fn product(p: &Quaternion, q: &Quaternion) -> Quaternion {
    let [a, b, c, d] = p;
    let [w, x, y, z] = q;
    [
        a * w - b * x - c * y - d * z,
        a * x + b * w + c * z - d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
    ]
}

/// The symmetric bilinear form M with M(q, q) = |q|² R(q), by rows.
///
/// With q = (w, a), |q|² R(q) v = (w² − a · a) v + 2 (a · v) a + 2 w a × v: each square is split into its two factors.
pub(super) fn mixed_rotation(p: &Quaternion, q: &Quaternion) -> Matrix {
    let [w, a @ ..] = p;
    let [s, b @ ..] = q;
    let along = w * s - dot(a, b);
    let turn: Vector = std::array::from_fn(|k| w * &b[k] + s * &a[k]);
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let symmetric = &a[i] * &b[j] + &a[j] * &b[i];
            match (j + 3 - i) % 3 {
                0 => symmetric + &along,
                1 => symmetric - &turn[(j + 1) % 3],
                _ => symmetric + &turn[(i + 1) % 3],
            }
        })
    })
}

/// M v.
pub(super) fn image(rows: &Matrix, v: &Vector) -> Vector {
    rows.each_ref().map(|row| dot(row, v))
}

/// Mᵀ v.
pub(super) fn transposed_image(rows: &Matrix, v: &Vector) -> Vector {
    std::array::from_fn(|k| (0..3).map(|i| &rows[i][k] * &v[i]).sum())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of<const N: usize>(numbers: [i32; N]) -> [IBig; N] {
        numbers.map(IBig::from)
    }

    #[test]
    fn turns_by_hand() {
        // 1 + k turns by 90° about the third axis, and has the square 2.
        let quarter = of([1, 0, 0, 1]);
        assert_eq!(image(&mixed_rotation(&quarter, &quarter), &of([3, 0, 5])), of([0, 6, 10]));
        assert_eq!(product(&quarter, &quarter), of([0, 0, 0, 2]));
        let (p, q, v) = (of([1, 2, -3, 4]), of([5, -1, 2, 2]), of([7, -2, 3]));
        let rotation = |q: &Quaternion| mixed_rotation(q, q);
        let both = product(&p, &q);
        assert_eq!(image(&rotation(&both), &v), image(&rotation(&p), &image(&rotation(&q), &v)));
        let square = dot(&both, &both);
        let back = transposed_image(&rotation(&both), &image(&rotation(&both), &v));
        assert_eq!(back, v.map(|c| c * &square * &square));
        let of_sum = rotation(&sum(&p, &q));
        let mixed = mixed_rotation(&p, &q);
        for (i, j) in (0..3).flat_map(|i| (0..3).map(move |j| (i, j))) {
            let parts = &rotation(&p)[i][j] + &rotation(&q)[i][j] + IBig::from(2) * &mixed[i][j];
            assert_eq!(of_sum[i][j], parts);
        }
    }

    #[test]
    fn products_by_hand() {
        assert_eq!(product(&of([1, 2, 3, 4]), &of([5, 6, 7, 8])), of([-60, 12, 30, 24]));
        let [i, j, k] = [of([0, 1, 0, 0]), of([0, 0, 1, 0]), of([0, 0, 0, 1])];
        assert_eq!((product(&i, &j), product(&j, &k), product(&k, &i)), (k.clone(), i.clone(), j.clone()));
        assert_eq!(product(&j, &i), conjugate(&k));
    }
}
