//! Answers to "which facets have an edge in common with this one", of generators in general position.
//!
//! A facet [i, j, s] has the outward normal u = s · (v_i × v_j), and every other generator v_k counts in it with the
//! sign of u · v_k. Its edges along v_i are those where j has a sign, too, and so for j. A facet [i, l, s'] has such an
//! edge if its signs are those of the first facet for all generators but i, j and l: then the sign that it has for j
//! tells which of the two edges it is.

use std::fmt::{self, Display};

use dashu_int::IBig;

use crate::exact::grid::{Grid, check_finite};
use crate::exact::linear::{Vector, dot, is_zero};
use crate::verdict::Verdict;

/// A facet: two generators, the first before the second, and the sign of its outward normal.
pub type FacetTriple = (usize, usize, i64);

/// That the facets are the neighbours.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct WalkProof;

impl Display for WalkProof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("each facet has another edge in common with the given one")
    }
}

/// Checks that four facets are the neighbours of a facet, one across each edge.
pub fn check_walk(generators: &[Vec<f64>], facet: FacetTriple, neighbours: &[FacetTriple]) -> Verdict<WalkProof> {
    proved(generators, facet, neighbours).map(|()| WalkProof).into()
}

/// A facet with its normal.
struct Facet {
    pair: [usize; 2],
    normal: Vector,
}

impl Facet {
    fn new(generators: &[Vector], (first, second, sign): FacetTriple) -> Result<Self, String> {
        if first >= second || second >= generators.len() || sign.abs() != 1 {
            return Err(format!("[{first}, {second}, {sign}] names no facet"));
        }
        let (a, b) = (&generators[first], &generators[second]);
        let minor = |k: usize, l: usize| (&a[k] * &b[l] - &a[l] * &b[k]) * IBig::from(sign);
        let normal = vec![minor(1, 2), minor(2, 0), minor(0, 1)];
        if is_zero(&normal) {
            return Err(format!("generators {first} and {second} span no facet"));
        }
        Ok(Self { pair: [first, second], normal })
    }

    fn sign(&self, generator: &Vector) -> std::cmp::Ordering {
        dot(&self.normal, generator).cmp(&IBig::ZERO)
    }
}

fn proved(generators: &[Vec<f64>], facet: FacetTriple, neighbours: &[FacetTriple]) -> Result<(), String> {
    if generators.iter().any(|generator| generator.len() != 3) {
        return Err("answered a question whose generators are not in space".to_owned());
    }
    check_finite("the question", generators.iter().flatten())?;
    let grid = Grid::of(generators.iter().flatten().copied());
    let generators: Vec<Vector> =
        generators.iter().map(|generator| generator.iter().map(|&x| grid.units(x)).collect()).collect();
    let own = Facet::new(&generators, facet)?;
    if neighbours.len() != 4 {
        return Err(format!("there are {} neighbours, not 4", neighbours.len()));
    }
    let mut edges = Vec::new();
    for &triple in neighbours {
        let other = Facet::new(&generators, triple)?;
        let kept: Vec<usize> = own.pair.into_iter().filter(|index| other.pair.contains(index)).collect();
        let [along] = kept[..] else {
            return Err(format!("{triple:?} has no edge in common with the facet"));
        };
        let left = own.pair.into_iter().find(|&index| index != along).unwrap_or(along);
        let is_other = |index: &usize| !own.pair.contains(index) && !other.pair.contains(index);
        for index in (0..generators.len()).filter(is_other) {
            let signs = [&own, &other].map(|facet| facet.sign(&generators[index]));
            if signs[0].is_eq() || signs[0] != signs[1] {
                return Err(format!("generator {index} is between the facet and {triple:?}"));
            }
        }
        let side = other.sign(&generators[left]);
        if side.is_eq() || edges.contains(&(along, side)) {
            return Err(format!("{triple:?} is not across an edge of its own"));
        }
        edges.push((along, side));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sides_of_a_cube() {
        let cube = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|v| v.to_vec());
        let sides = [(0, 2, 1), (1, 2, 1), (0, 2, -1), (1, 2, -1)];
        let accepts = |neighbours: &[FacetTriple]| check_walk(&cube, (0, 1, 1), neighbours).is_right();
        assert!(accepts(&sides));
        assert!(!accepts(&sides[..3]) && !accepts(&[sides[0], sides[1], sides[2], sides[0]]));
        assert!(!accepts(&[sides[0], sides[1], sides[2], (0, 1, -1)]));
        assert!(!accepts(&[sides[0], sides[1], sides[2], (1, 2, 0)]));
        assert!(!accepts(&[sides[0], sides[1], sides[2], (1, 3, 1)]));
        // a fourth generator cuts two of the edges off
        let more = [&cube[..], &[vec![1.0, 1.0, 1.0]]].concat();
        assert!(!check_walk(&more, (0, 1, 1), &sides).is_right());
    }

    /// The sums of generators that are the corners of a facet.
    fn corners(generators: &[[f64; 3]], (first, second, sign): FacetTriple) -> Vec<[i64; 3]> {
        let whole = |index: usize| generators[index].map(|x| x as i64);
        let ([ax, ay, az], [bx, by, bz]) = (whole(first), whole(second));
        let normal = [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx].map(|x| x * sign);
        let mut corners = Vec::new();
        for (of_first, of_second) in [(1, 1), (1, -1), (-1, 1), (-1, -1)] {
            let mut sum = [0; 3];
            for index in 0..generators.len() {
                let g = whole(index);
                let along: i64 = normal.iter().zip(g).map(|(u, x)| u * x).sum();
                let factor = if index == first {
                    of_first
                } else if index == second {
                    of_second
                } else {
                    along.signum()
                };
                sum = std::array::from_fn(|axis| sum[axis] + factor * g[axis]);
            }
            corners.push(sum);
        }
        corners
    }

    /// The facets that have two corners in common with one are its neighbours, and no others.
    #[test]
    fn neighbours_have_two_corners_in_common() {
        let body = [[7.0, 1.0, 2.0], [-1.0, 5.0, 3.0], [2.0, -3.0, 6.0], [4.0, 4.0, -5.0], [-6.0, 2.0, 1.0]];
        let plain = body.map(|g| g.to_vec());
        let pairs = (0..5).flat_map(|second| (0..second).map(move |first| (first, second)));
        let facets: Vec<FacetTriple> = pairs.flat_map(|(i, j)| [(i, j, 1), (i, j, -1)]).collect();
        for &facet in &facets {
            let own = corners(&body, facet);
            let is_beside = |other: &FacetTriple| {
                *other != facet && corners(&body, *other).iter().filter(|corner| own.contains(corner)).count() == 2
            };
            let (neighbours, others): (Vec<FacetTriple>, Vec<FacetTriple>) = facets.iter().partition(|&f| is_beside(f));
            assert_eq!(neighbours.len(), 4);
            assert!(check_walk(&plain, facet, &neighbours).is_right(), "{facet:?} {neighbours:?}");
            for (place, &other) in (0..4).flat_map(|place| others.iter().map(move |other| (place, other))) {
                let mut wrong = neighbours.clone();
                wrong[place] = other;
                assert!(!check_walk(&plain, facet, &wrong).is_right(), "{facet:?} {wrong:?}");
            }
        }
        // generators in one plane with the facet's
        let flat = [&plain[..4], &[vec![6.0, 6.0, 5.0]]].concat();
        assert!(!check_walk(&flat, (0, 1, 1), &[(0, 2, 1), (1, 2, 1), (0, 2, -1), (1, 2, -1)]).is_right());
    }

    #[test]
    fn a_facet_is_named_by_two_generators_the_first_before_the_second() {
        let cube = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|v| v.to_vec());
        let sides = [(0, 2, 1), (1, 2, 1), (0, 2, -1), (1, 2, -1)];
        for facet in [(1, 1, 1), (1, 0, 1), (0, 3, 1), (0, 1, 2)] {
            let complaint = check_walk(&cube, facet, &sides).proof().expect_err("there is no such facet");
            assert!(complaint.contains("names no facet"), "{complaint}");
        }
        let parallel = [&cube[..], &cube[..1]].concat();
        let complaint = check_walk(&parallel, (0, 3, 1), &sides).proof().expect_err("the generators are parallel");
        assert!(complaint.contains("span no facet"), "{complaint}");
    }
}
