//! Lower bounds of how far a zonotope reaches along the normals of its facets, in floating point.
//!
//! The normals that are orthogonal to d − 2 generators lie in a plane; when a normal turns around in it, one generator
//! after another changes the side. So with the generators in that order, the sums over both sides are running sums.
//! Whatever the order and the signs, |u · Σ δ_k g_k| with all |δ_k| ≤ 1 is never more than the reach: rounding spoils
//! the bound, not its truth.

use crate::faces::normals::{Image, MOST_COORDINATES, UNDERFLOW, image_dot, image_size};

/// The error of each component of a computed normal, relative to the product of its vectors' sums of absolute
/// components: a component is a sum of at most six products of three images, each within 2^-52.
const NORMAL_ERROR: f64 = 1.0 / (1_u64 << 47) as f64;

/// Generators and points, as images in a space of `rank` dimensions.
pub(crate) struct Pencils<'a> {
    rank: usize,
    generators: &'a [Image],
    points: &'a [Image],
    /// Σ |g_k| and max |p|, component by component.
    extent: Image,
    farthest: Image,
}

impl<'a> Pencils<'a> {
    pub(crate) fn new(rank: usize, generators: &'a [Image], points: &'a [Image]) -> Self {
        let mut extent = [0.0; MOST_COORDINATES];
        let mut farthest = extent;
        for axis in 0..MOST_COORDINATES {
            extent[axis] = generators.iter().map(|g| g[axis].abs()).sum();
            farthest[axis] = points.iter().fold(0.0, |most: f64, p| most.max(p[axis].abs()));
        }
        Self { rank, generators, points, extent, farthest }
    }

    /// The generators after the last of `fixed`, rank − 2 of them, whose facets with these may have a point outside;
    /// the others' have none for sure.
    pub(crate) fn open(&self, fixed: &[usize]) -> Vec<usize> {
        let first = fixed.last().map_or(0, |last| last + 1);
        let mut turned = self.turned(fixed);
        turned.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let mut rest = [0.0; MOST_COORDINATES];
        for &(_, k, sign) in &turned {
            add(&mut rest, &self.generators[k], sign);
        }
        let mut open = Vec::new();
        let mut before = [0.0; MOST_COORDINATES];
        for &(_, k, sign) in &turned {
            add(&mut rest, &self.generators[k], -sign);
            let sum = std::array::from_fn(|axis| rest[axis] - before[axis]);
            if k >= first && (sign == 0.0 || !self.is_clear(fixed, k, &sum)) {
                open.push(k);
            }
            add(&mut before, &self.generators[k], sign);
        }
        open
    }

    /// The generators but the fixed ones as they are met by a turning normal: an increasing key, the index, and the
    /// sign that turns them into one half; 0 where rounding leaves nothing of one.
    fn turned(&self, fixed: &[usize]) -> Vec<(f64, usize, f64)> {
        let mut removed: Vec<(usize, Image)> = Vec::with_capacity(fixed.len());
        for &index in fixed {
            let rest = without(self.generators[index], &removed);
            let largest = (0..self.rank).max_by(|&a, &b| rest[a].abs().total_cmp(&rest[b].abs()));
            removed.extend(largest.map(|axis| (axis, rest)));
        }
        let mut axes = (0..self.rank).filter(|axis| removed.iter().all(|(other, _)| other != axis));
        let [first, second] = std::array::from_fn(|_| axes.next().unwrap_or(0));
        let key = |k: usize| {
            let seen = without(self.generators[k], &removed);
            let (x, y) = (seen[first], seen[second]);
            let sign = if y < 0.0 || y == 0.0 && x < 0.0 { -1.0 } else { 1.0 };
            let key: f64 = -sign * x / (x.abs() + y.abs());
            if key.is_finite() { (key, k, sign) } else { (0.0, k, 0.0) }
        };
        (0..self.generators.len()).filter(|k| !fixed.contains(k)).map(key).collect()
    }

    /// Whether every point is on the inner side of both facets with this normal, for sure.
    fn is_clear(&self, fixed: &[usize], k: usize, sum: &Image) -> bool {
        let rows = || fixed.iter().chain([&k]).map(|&index| &self.generators[index]);
        let u = orthogonal(self.rank, rows());
        let off = NORMAL_ERROR * rows().map(|g| g.iter().map(|x| x.abs()).sum::<f64>()).product::<f64>();
        let count = (self.generators.len() + 16) as f64;
        let size = image_size(&u, &self.extent) + image_size(&u, &self.farthest);
        let around: f64 = self.extent.iter().chain(&self.farthest).sum();
        let doubt = 2.0 * (off * around + count * f64::EPSILON * size + count * UNDERFLOW);
        let certain = image_dot(&u, sum).abs() - doubt;
        self.points.iter().all(|p| image_dot(&u, p).abs() < certain)
    }
}

fn add(sum: &mut Image, image: &Image, factor: f64) {
    for (sum, x) in sum.iter_mut().zip(image) {
        *sum += factor * x;
    }
}

/// A vector with multiples of the removed ones taken away, so that it vanishes along their axes.
fn without(mut v: Image, removed: &[(usize, Image)]) -> Image {
    for (axis, taken) in removed {
        let factor = v[*axis] / taken[*axis];
        add(&mut v, taken, -factor);
        v[*axis] = 0.0;
    }
    v
}

/// The signed minors of rank − 1 rows.
fn orthogonal<'a>(rank: usize, mut rows: impl Iterator<Item = &'a Image>) -> Image {
    let zero = [0.0; MOST_COORDINATES];
    let [a, b, c] = std::array::from_fn(|_| rows.next().unwrap_or(&zero));
    match rank {
        2 => [-a[1], a[0], 0.0, 0.0],
        3 => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0], 0.0],
        _ => {
            let minor = |x: usize, y: usize, z: usize| {
                a[x] * (b[y] * c[z] - b[z] * c[y]) - a[y] * (b[x] * c[z] - b[z] * c[x])
                    + a[z] * (b[x] * c[y] - b[y] * c[x])
            };
            [minor(1, 2, 3), -minor(0, 2, 3), minor(0, 1, 3), -minor(0, 1, 2)]
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::linear::Vector;
    use crate::faces::normals::images;
    use dashu_int::IBig;

    /// Points a little inside and a little outside of the facets of random bodies, some of them with parallel and
    /// coplanar generators.
    #[test]
    fn facets_with_points_beyond_them_are_open() {
        let mut state = 3_u64;
        let mut next = move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 40) as f64 / (1_u64 << 24) as f64 - 0.5
        };
        let (mut clear, mut beyond) = (0, 0);
        for (rank, rounds) in [(2, 40), (3, 40), (4, 12)] {
            for round in 0..rounds {
                let coarse = if round % 2 == 0 { 4.0 } else { 1e6 };
                let mut vector = |room: f64| -> Image {
                    std::array::from_fn(
                        |axis| if axis < rank { (next() * coarse).round() / coarse * room } else { 0.0 },
                    )
                };
                let generators: Vec<Image> = (0..3 + round % 7).map(|_| vector(1.0)).collect();
                let points = [vector(2.0), vector(4.0)];
                let pencils = Pencils::new(rank, &generators, &points);
                for fixed in crate::exact::subsets::subsets(generators.len(), rank - 2) {
                    let open = pencils.open(&fixed);
                    for k in fixed.last().map_or(0, |last| last + 1)..generators.len() {
                        let rows = fixed.iter().chain([&k]).map(|&index| &generators[index]);
                        let u = orthogonal(rank, rows);
                        let reach: f64 = generators.iter().map(|g| image_dot(&u, g).abs()).sum();
                        let excess = points.iter().map(|p| image_dot(&u, p).abs() - reach).fold(f64::MIN, f64::max);
                        if excess > 1e-12 {
                            beyond += 1;
                            assert!(open.contains(&k), "{rank} {generators:?} {fixed:?} {k}");
                        } else if excess < -1e-9 * reach && image_dot(&u, &u) > 1e-9 {
                            clear += 1;
                            assert!(!open.contains(&k), "{rank} {generators:?} {fixed:?} {k}");
                        }
                    }
                }
            }
        }
        assert!(clear > 300 && beyond > 300, "{clear} {beyond}");
    }

    /// Whether the facet of the plane that is parallel to the first vector is open, with the last vector as the point.
    fn is_open_along_the_first(vectors: &[Vector]) -> bool {
        let images = images(vectors);
        let (generators, points) = images.split_at(images.len() - 1);
        Pencils::new(2, generators, points).open(&[]).contains(&0)
    }

    fn upright(heights: impl IntoIterator<Item = IBig>) -> Vec<Vector> {
        let first = vec![IBig::ONE, IBig::ZERO];
        std::iter::once(first).chain(heights.into_iter().map(|height| vec![IBig::ZERO, height])).collect()
    }

    /// The last two thousand sums are rounded up, each by half of its last place.
    #[test]
    fn a_facet_is_open_for_a_point_a_unit_beyond_thousands_of_generators() {
        let height = (IBig::ONE << 52) + (IBig::ONE << 10) + IBig::ONE;
        let beyond = &height * IBig::from(4000) + IBig::ONE;
        assert!(is_open_along_the_first(&upright(std::iter::repeat_n(height, 4000).chain([beyond]))));
    }

    #[test]
    fn a_facet_is_clear_of_a_point_that_is_inside_by_more_than_rounding() {
        let height = IBig::ONE << 40;
        let heights = |short: i32| {
            let point = &height * IBig::from(1000) - IBig::from(short);
            std::iter::repeat_n(height.clone(), 1000).chain([point])
        };
        assert!(!is_open_along_the_first(&upright(heights(5000))), "5 parts of 10^12");
        assert!(is_open_along_the_first(&upright(heights(0))));
    }

    /// The generator along the facet is so short that products with it are lost.
    #[test]
    fn a_facet_along_a_vanishing_generator_is_open_for_a_point_beyond_it() {
        let height = IBig::ONE << 970;
        let beyond = &height + (IBig::ONE << 900);
        assert!(is_open_along_the_first(&upright([height, beyond])));
    }

    /// The first facet that a point is beyond names the point, so the order is part of an answer's text.
    #[test]
    fn open_facets_come_in_the_order_of_the_angles_of_their_generators() {
        let rows = [[-1, 1], [0, -1], [1, 0], [1, 1], [90, -40]].map(|row: [i32; 2]| row.map(IBig::from).to_vec());
        let images = images(&rows);
        assert_eq!(Pencils::new(2, &images[..4], &images[4..]).open(&[]), [2, 3, 1, 0]);
    }
}
