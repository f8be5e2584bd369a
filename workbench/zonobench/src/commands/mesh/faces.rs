//! The triangles of a face with any number of corners.
//!
//! A face is cut from one corner to all others. That is right from each corner of a convex face, and from some corner
//! of many others: those from which all of the face is seen. The first such corner is taken. A corner is given up at
//! the first triangle that is turned against the face, so that only faces made for it take the square of their corners.

/// The part of two normals' lengths by which rounding may let them seem to point apart.
const ROUNDING: f64 = 1e-9;

/// The triangles of a face, from the first corner that sees all of it; else from its first corner, as none does.
///
/// # Errors
/// The triangles from the first corner, some of which overlap.
pub(super) fn triangles_of(face: &[usize], vertices: &[[f64; 3]]) -> Result<Vec<[usize; 3]>, Vec<[usize; 3]>> {
    let corners = &relative(face, vertices);
    let count = corners.len();
    let from = |first: usize| {
        let place = move |k: usize| if first + k < count { first + k } else { first + k - count };
        (2..count).map(move |k| [first, place(k - 1), place(k)])
    };
    let normal_of = |places: [usize; 3]| normal(places.map(|place| corners[place]));
    let whole = from(0).map(normal_of).fold([0.0; 3], |sum, n| [sum[0] + n[0], sum[1] + n[1], sum[2] + n[2]]);
    let length = |v: &[f64; 3]| dot(v, v).sqrt();
    let limit = -ROUNDING * length(&whole);
    let sees_all = |&first: &usize| from(first).map(normal_of).all(|n| dot(&n, &whole) >= limit * length(&n));
    let of_face = |first: usize| from(first).map(|places| places.map(|place| face[place])).collect();
    (0..count).find(sees_all).map(of_face).ok_or_else(|| of_face(0))
}

/// The corners of a face from its first one on, over its extent: products of such coordinates have room, whatever the
/// size of the face.
fn relative(face: &[usize], vertices: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let Some(&first) = face.first() else { return Vec::new() };
    // halves, since the difference of two doubles may be beyond the doubles
    let half = |corner: usize| vertices[corner].map(|c| 0.5 * c);
    let origin = half(first);
    let off = |&corner: &usize| [0, 1, 2].map(|k| half(corner)[k] - origin[k]);
    let corners: Vec<[f64; 3]> = face.iter().map(off).collect();
    let extent = corners.iter().flatten().fold(0.0f64, |extent, c| extent.max(c.abs()));
    if extent == 0.0 { corners } else { corners.iter().map(|corner| corner.map(|c| c / extent)).collect() }
}

/// Twice the area of a triangle along its normal.
fn normal([a, b, c]: [[f64; 3]; 3]) -> [f64; 3] {
    let [p, q] = [b, c].map(|end| [0, 1, 2].map(|k| end[k] - a[k]));
    [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
}

fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A kite with a dent at its third corner, which is seen from there and from the corner opposite to it.
    const DENTED: [[f64; 3]; 4] = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 4.0, 0.0]];

    #[test]
    fn a_face_is_cut_from_a_corner_that_sees_all_of_it() {
        assert_eq!(triangles_of(&[0, 1, 2, 3], &DENTED), Ok(vec![[0, 1, 2], [0, 2, 3]]));
        assert_eq!(triangles_of(&[1, 2, 3, 0], &DENTED), Ok(vec![[2, 3, 0], [2, 0, 1]]));
        assert_eq!(triangles_of(&[0, 1, 3], &DENTED), Ok(vec![[0, 1, 3]]));
        let square = [[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [1.0, 1.0, 1.0], [0.0, 1.0, 1.0]];
        assert_eq!(triangles_of(&[2, 3, 0, 1], &square), Ok(vec![[2, 3, 0], [2, 0, 1]]));
    }

    #[test]
    fn faces_of_any_size_are_cut_alike() {
        for size in [1e-320, 1e-100, 1e80, 1e160, 4.4e307] {
            let dented = DENTED.map(|corner| corner.map(|c| size * c - size));
            assert_eq!(triangles_of(&[1, 2, 3, 0], &dented), Ok(vec![[2, 3, 0], [2, 0, 1]]), "{size}");
        }
    }

    #[test]
    fn a_large_face_is_cut_in_time() {
        let count = 100_000;
        let turn = |k: usize| std::f64::consts::TAU * k as f64 / count as f64;
        let circle: Vec<[f64; 3]> = (0..count).map(|k| [libm::cos(turn(k)), libm::sin(turn(k)), 0.0]).collect();
        let face: Vec<usize> = (0..count).collect();
        assert!(triangles_of(&face, &circle).is_ok_and(|triangles| triangles.len() == count - 2));
    }

    #[test]
    fn a_face_of_which_no_corner_sees_all_is_told_apart() {
        // a comb with three teeth
        let comb: Vec<[f64; 3]> = [
            (0.0, 0.0),
            (8.0, 0.0),
            (8.0, 4.0),
            (7.0, 4.0),
            (7.0, 1.0),
            (4.5, 1.0),
            (4.5, 4.0),
            (3.5, 4.0),
            (3.5, 1.0),
            (1.0, 1.0),
            (1.0, 4.0),
            (0.0, 4.0),
        ]
        .map(|(x, y)| [x, y, 0.0])
        .into();
        let face: Vec<usize> = (0..comb.len()).collect();
        assert!(triangles_of(&face, &comb).is_err_and(|triangles| triangles.len() == 10));
    }
}
