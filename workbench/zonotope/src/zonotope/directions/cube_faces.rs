//! The faces x_i = 1 of the cube [−1, 1]^D, which meet every line through the origin: the face and the place of a
//! vector's line, the cells of grids on the faces, and their middles and corners as directions of length 1.

/// The axis of the face that the line of a vector meets, the first of several; none for the zero vector.
#[inline]
pub(crate) fn face_of<const D: usize>(v: &[f64; D]) -> Option<usize> {
    let face = (1..D).fold(0, |face, k| if v[k].abs() > v[face].abs() { k } else { face });
    (D > 0 && v[face] != 0.0).then_some(face)
}

/// The two coordinates on a face at which the line of a vector of space meets it, in the cyclic order of the axes, each
/// off by half a unit in the last place.
pub(crate) fn place_on(face: usize, v: &[f64; 3]) -> [f64; 2] {
    [v[(face + 1) % 3] / v[face], v[(face + 2) % 3] / v[face]]
}

/// The cell of a coordinate on a face, where a side has so many.
pub(crate) fn cell_at(coordinate: f64, cells: u32) -> u32 {
    (((coordinate + 1.0) * 0.5 * f64::from(cells)) as u32).min(cells - 1)
}

/// The coordinate in the middle of a cell, where a side has so many.
pub(crate) fn middle_of(cell: u32, cells: u32) -> f64 {
    (2.0 * f64::from(cell) + 1.0) / f64::from(cells) - 1.0
}

/// The middles of the cells of grids with `cells` cells along a side, scaled to length 1: every unit vector or its
/// opposite is within sqrt(D − 1) / `cells` of one of them, but for rounding.
pub fn cell_middles<const D: usize>(cells: usize) -> Vec<[f64; D]> {
    on_faces(cells, |i| middle_of(i as u32, cells as u32))
}

/// The corners of the cells of grids with `cells` cells along a side, scaled to length 1, each direction once: every
/// unit vector or its opposite lies in the cone of a cell all of whose corners are within 2 sqrt(D − 1) / `cells` of
/// it.
pub fn cell_corners<const D: usize>(cells: usize) -> Vec<[f64; D]> {
    let corner = |i: usize| 2.0 * i as f64 / cells as f64 - 1.0;
    let mut corners: Vec<[f64; D]> = on_faces(cells + 1, corner);
    // A corner on an edge of the cube belongs to several faces, from which it may come with either sign.
    for u in &mut corners {
        if u.iter().find(|c| **c != 0.0).is_some_and(|c| *c < 0.0) {
            *u = u.map(|c| -c);
        }
    }
    corners.sort_by(|a, b| {
        a.iter().zip(b).map(|(x, y)| x.total_cmp(y)).find(|o| o.is_ne()).unwrap_or(std::cmp::Ordering::Equal)
    });
    corners.dedup_by(|a, b| a.iter().zip(b.iter()).all(|(x, y)| (*x - *y).abs() < 1e-12));
    corners
}

/// Points of grids on the D faces x_i = 1, `count` of them along a side at the coordinates that `place` gives, scaled
/// to length 1.
fn on_faces<const D: usize>(count: usize, place: impl Fn(usize) -> f64) -> Vec<[f64; D]> {
    let mut found = Vec::new();
    for face in 0..D {
        let others: Vec<usize> = (0..D).filter(|&c| c != face).collect();
        let mut index = vec![0; others.len()];
        loop {
            let mut u = [0.0; D];
            u[face] = 1.0;
            for (&c, &i) in others.iter().zip(&index) {
                u[c] = place(i);
            }
            let length = u.iter().map(|c| c * c).sum::<f64>().sqrt();
            found.push(u.map(|c| c / length));
            let Some(slot) = index.iter().position(|&i| i + 1 < count) else { break };
            index[..slot].fill(0);
            index[slot] += 1;
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::{RngExt, SeedableRng};

    fn distance<const D: usize>(u: &[f64; D], v: &[f64; D]) -> f64 {
        let along = |sign: f64| u.iter().zip(v).map(|(a, b)| (a - sign * b) * (a - sign * b)).sum::<f64>().sqrt();
        along(1.0).min(along(-1.0))
    }

    fn random_unit<const D: usize>(rng: &mut rand_pcg::Pcg64) -> [f64; D] {
        loop {
            let v: [f64; D] = std::array::from_fn(|_| rng.random_range(-1.0..1.0));
            let length = v.iter().map(|c| c * c).sum::<f64>().sqrt();
            if length > 0.1 && length <= 1.0 {
                return v.map(|c| c / length);
            }
        }
    }

    fn keeps_its_mesh<const D: usize>() {
        let mut rng = rand_pcg::Pcg64::seed_from_u64(3);
        for cells in [1, 2, 3, 6] {
            let (middles, corners) = (cell_middles::<D>(cells), cell_corners::<D>(cells));
            assert_eq!(middles.len(), D * cells.pow(D as u32 - 1));
            let mesh = (D as f64 - 1.0).sqrt() / cells as f64 + 1e-12;
            for _ in 0..300 {
                let u = random_unit::<D>(&mut rng);
                assert!(middles.iter().any(|v| distance(&u, v) <= mesh));
                // The 2^(D − 1) corners of the cell of u are within the bound, and they are at least D.
                assert!(corners.iter().filter(|v| distance(&u, v) <= 2.0 * mesh).count() >= D);
            }
        }
    }

    #[test]
    fn every_direction_is_near_one_of_the_net() {
        keeps_its_mesh::<2>();
        keeps_its_mesh::<3>();
        keeps_its_mesh::<4>();
    }

    #[test]
    fn nets_of_the_plane_by_hand() {
        let half = 0.5f64.sqrt();
        assert_eq!(cell_middles::<2>(1), [[1.0, 0.0], [0.0, 1.0]]);
        let corners = cell_corners::<2>(2);
        assert_eq!(corners.len(), 4);
        assert!(corners.iter().any(|u| (u[0] - half).abs() < 1e-15 && (u[1] + half).abs() < 1e-15));
    }
}
