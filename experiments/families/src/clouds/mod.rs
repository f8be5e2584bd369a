//! Families of point clouds in two, three and four dimensions, for the enclosing zonotopes of 4.2 and 4.3.
//!
//! | family | points on the hull | what it is for |
//! | --- | --- | --- |
//! | `ball_2`, `ball_3`, `ball_4` | few | most points never matter |
//! | `sphere_2`, `sphere_3`, `sphere_4` | all | every point may matter |
//! | `tetrahedron` … `icosahedron` | all | the Platonic solids, each of its own size |

mod solids;
pub mod spiral;

use crate::source::RandomSource;

pub use solids::SOLIDS;

/// Points of some dimension.
#[derive(Clone, Debug, PartialEq)]
pub enum Cloud {
    /// In the plane.
    Plane(Vec<[f64; 2]>),
    /// In space.
    Space(Vec<[f64; 3]>),
    /// In R^4.
    Four(Vec<[f64; 4]>),
}

impl Cloud {
    /// The number of points.
    pub fn len(&self) -> usize {
        match self {
            Self::Plane(points) => points.len(),
            Self::Space(points) => points.len(),
            Self::Four(points) => points.len(),
        }
    }

    /// Whether there is no point.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// A family of point clouds.
#[derive(Clone, Copy, Debug)]
pub struct CloudFamily {
    /// Stable name: part of every case id.
    pub id: &'static str,
    /// Name for people.
    pub title: &'static str,
    /// The instance with `n` points for a seed: a pure function.
    pub generate: fn(n: usize, seed: u64) -> Cloud,
}

/// Every family with instances of all sizes.
pub static CLOUD_FAMILIES: &[CloudFamily] = &[
    CloudFamily { id: "ball_2", title: "Points in a disc", generate: |n, seed| Cloud::Plane(in_ball(n, seed)) },
    CloudFamily { id: "ball_3", title: "Points in a ball", generate: |n, seed| Cloud::Space(in_ball(n, seed)) },
    CloudFamily { id: "ball_4", title: "Points in a ball of R^4", generate: |n, seed| Cloud::Four(in_ball(n, seed)) },
    CloudFamily { id: "sphere_2", title: "Points on a circle", generate: |n, seed| Cloud::Plane(on_sphere(n, seed)) },
    CloudFamily { id: "sphere_3", title: "Points on a sphere", generate: |n, seed| Cloud::Space(on_sphere(n, seed)) },
    CloudFamily {
        id: "sphere_4",
        title: "Points on a sphere of R^4",
        generate: |n, seed| Cloud::Four(on_sphere(n, seed)),
    },
];

/// The family called `id`, if there is one.
pub fn find(id: &str) -> Option<&'static CloudFamily> {
    CLOUD_FAMILIES.iter().find(|family| family.id == id)
}

/// The vertices of the Platonic solid called `name`, if there is one.
pub fn solid(name: &str) -> Option<Vec<[f64; 3]>> {
    SOLIDS.iter().find(|solid| solid.name == name).map(|solid| (solid.vertices)())
}

/// Uniform in the unit ball: points of the cube, those outside the ball thrown away.
fn in_ball<const D: usize>(n: usize, seed: u64) -> Vec<[f64; D]> {
    let mut random = RandomSource::new(seed);
    (0..n).map(|_| ball_point(&mut random)).collect()
}

/// Uniform on the unit sphere, up to rounding.
pub fn on_sphere<const D: usize>(n: usize, seed: u64) -> Vec<[f64; D]> {
    let mut random = RandomSource::new(seed);
    let mut unit = || loop {
        let point = ball_point::<D>(&mut random);
        let length = norm(&point);
        // A point very near the centre would lose digits.
        if length > 0.01 {
            return point.map(|c| c / length);
        }
    };
    (0..n).map(|_| unit()).collect()
}

fn ball_point<const D: usize>(random: &mut RandomSource) -> [f64; D] {
    loop {
        let point = std::array::from_fn(|_| random.signed_unit());
        if norm(&point) <= 1.0 {
            return point;
        }
    }
}

fn norm<const D: usize>(v: &[f64; D]) -> f64 {
    v.iter().map(|c| c * c).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_where_their_family_says() {
        let check = |id: &str, inner: f64| {
            let family = find(id).expect("listed");
            let lengths: Vec<f64> = match (family.generate)(50, 7) {
                Cloud::Plane(points) => points.iter().map(norm).collect(),
                Cloud::Space(points) => points.iter().map(norm).collect(),
                Cloud::Four(points) => points.iter().map(norm).collect(),
            };
            assert_eq!(lengths.len(), 50);
            assert!(lengths.iter().all(|length| (inner..=1.0 + 1e-15).contains(length)), "{id}");
        };
        for dimension in 2..=4 {
            check(&format!("ball_{dimension}"), 0.0);
            check(&format!("sphere_{dimension}"), 1.0 - 1e-15);
        }
    }

    #[test]
    fn an_instance_is_a_function_of_its_seed() {
        let family = find("ball_3").expect("listed");
        assert_eq!((family.generate)(9, 1), (family.generate)(9, 1));
        assert_ne!((family.generate)(9, 1), (family.generate)(9, 2));
    }
}
