//! Cones of directions in the plane, cut by half-planes, exactly.

use std::cmp::Ordering;

use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::dot;

type Direction = [Dyadic; 2];

/// The cone of the directions that satisfy all inequalities so far.
#[derive(Debug, Clone)]
pub(crate) enum Cone {
    /// The cone of all directions.
    Plane,
    /// The directions from `right` counter-clockwise to `left`, at most half a turn.
    Wedge { right: Direction, left: Direction },
    /// A direction and its opposite.
    Line(Direction),
    /// One direction.
    Ray(Direction),
    /// No direction.
    Point,
}

impl Cone {
    /// The directions u of the cone with normal · u ≥ 0.
    pub(crate) fn clip(self, normal: &Direction) -> Self {
        let side = |u: &Direction| dot(normal, u).sign();
        let end = [-normal[1].clone(), normal[0].clone()];
        match self {
            Self::Plane => Self::Wedge { right: opposite(&end), left: end },
            Self::Wedge { right, left } => match (side(&right), side(&left)) {
                (Ordering::Equal, Ordering::Equal) => {
                    let inside = [left[1].clone(), -left[0].clone()];
                    if side(&inside) == Ordering::Greater { Self::Wedge { right, left } } else { Self::Line(left) }
                }
                (Ordering::Less, Ordering::Less) => Self::Point,
                (Ordering::Equal, Ordering::Less) => Self::Ray(right),
                (Ordering::Less, Ordering::Equal) => Self::Ray(left),
                (_, Ordering::Less) => Self::Wedge { right, left: end },
                (Ordering::Less, _) => Self::Wedge { right: opposite(&end), left },
                _ => Self::Wedge { right, left },
            },
            Self::Line(u) => match side(&u) {
                Ordering::Equal => Self::Line(u),
                Ordering::Greater => Self::Ray(u),
                Ordering::Less => Self::Ray(opposite(&u)),
            },
            Self::Ray(u) if side(&u) != Ordering::Less => Self::Ray(u),
            Self::Ray(_) | Self::Point => Self::Point,
        }
    }

    /// The dimension of the cone.
    pub(crate) fn dimension(&self) -> u8 {
        match self {
            Self::Plane | Self::Wedge { .. } => 2,
            Self::Line(_) | Self::Ray(_) => 1,
            Self::Point => 0,
        }
    }
}

fn opposite([x, y]: &Direction) -> Direction {
    [-x.clone(), -y.clone()]
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn exact([x, y]: [i8; 2]) -> Direction {
        [Dyadic::from_f64(f64::from(x)), Dyadic::from_f64(f64::from(y))]
    }

    /// The dimension by trial: the rays along the ends of all half-planes that satisfy every inequality.
    fn dimension_by_trial(normals: &[[i8; 2]]) -> u8 {
        let dot = |a: [i8; 2], b: [i8; 2]| i32::from(a[0]) * i32::from(b[0]) + i32::from(a[1]) * i32::from(b[1]);
        let ends = normals.iter().flat_map(|&[x, y]| [[-y, x], [y, -x]]);
        let kept: Vec<_> = ends.filter(|&u| normals.iter().all(|&n| dot(n, u) >= 0)).collect();
        let crossing = |a: [i8; 2]| kept.iter().any(|&b| dot([-a[1], a[0]], b) != 0);
        let inside =
            normals.iter().any(|&m| normals.iter().all(|&n| dot(n, m) >= 0) && !normals.contains(&[-m[0], -m[1]]));
        match kept[..] {
            [] => 0,
            [first, ..] if crossing(first) => 2,
            _ if inside && normals.iter().all(|&n| dot([-n[1], n[0]], normals[0]) == 0 && dot(n, normals[0]) > 0) => 2,
            _ => 1,
        }
    }

    properties! {
        #[test]
        fn agrees_with_trial(
            normals in proptest::collection::vec([-3i8..4, -3i8..4].prop_filter("not zero", |n| *n != [0, 0]), 1..7),
        ) {
            let cone = normals.iter().fold(Cone::Plane, |cone, &n| cone.clip(&exact(n)));
            prop_assert_eq!(cone.dimension(), dimension_by_trial(&normals));
        }
    }
}
