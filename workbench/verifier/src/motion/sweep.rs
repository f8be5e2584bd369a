//! Answers to "a zonotope around all placements of a turning and translating one".
//!
//! A zonotope contains a convex body if it reaches as far along each of its facet normals u, and along all directions
//! orthogonal to it. A placement reaches as far along u as the body does along the u that is turned back. That is a
//! convex function of the vector, which goes along an arc: on a stretch it is at most the largest of three values, at
//! both ends and at the corner of the tangents. Stretches are halved until that suffices, or until the value at a
//! placement shows the answer wrong.
//!
//! If the generators of the body are among those of the answer, they are left out on both sides first: the sum of the
//! other generators has few facets, and it is enough that it holds all displacements of points of the body.

mod turned_arc;

use dashu_int::IBig;
use dashu_int::ops::Abs;

use self::turned_arc::{Rotation, Turning};
use crate::exact::grid::{Grid, check_finite};
use crate::exact::linear::{Echelon, Vector, dot, is_zero, reduced};
use crate::exact::subsets::{count_subsets, subsets};
use crate::reduction::difference::without_common_summands;
use crate::verdict::{Proved, Stop, Verdict};

/// Stretches are halved so often that their ends are 2^-40 of the angle apart.
const DEPTH: u32 = 40;

/// The stretches with which the search begins: an eighth of the angle each.
const FIRST_DEPTH: u32 = 3;

/// The products of a vector and a generator that a check takes.
const MOST_PRODUCTS: u64 = 6_000_000;

/// The question: a body, an axis line, the largest angle in radians, and a translation.
#[derive(Debug, Clone, PartialEq)]
pub struct Sweep {
    /// The centre of the body.
    pub center: Vec<f64>,
    /// Its generators.
    pub generators: Vec<Vec<f64>>,
    /// A point of the axis.
    pub axis_point: Vec<f64>,
    /// The direction of the axis, of any length.
    pub axis: Vec<f64>,
    /// The largest angle.
    pub angle: f64,
    /// The whole translation.
    pub translation: Vec<f64>,
}

/// Proves that a zonotope contains every placement of the body.
pub fn check_sweep(question: &Sweep, center: &[f64], generators: &[Vec<f64>]) -> Verdict<Proved> {
    checked(question, center, generators).into()
}

/// The numbers of a question and its answer on one grid.
struct Check {
    turning: Turning,
    /// The body seen from the axis, and its translation.
    arm: Vector,
    body: Vec<Vector>,
    translation: Vector,
    /// The products that were not taken yet.
    products: u64,
}

fn checked(question: &Sweep, center: &[f64], generators: &[Vec<f64>]) -> Result<Proved, Stop> {
    let Sweep { center: from, generators: own, axis_point, axis, angle, translation } = question;
    let vectors = [from, axis_point, axis, translation];
    let all = vectors.iter().map(|v| &v[..]).chain([center]).chain(own.iter().chain(generators).map(|g| &g[..]));
    for vector in all.clone() {
        if vector.len() != 3 {
            return Err(format!("a vector has {} coordinates, not 3", vector.len()).into());
        }
        check_finite("a vector", vector)?;
    }
    if !angle.is_finite() || *angle < 0.0 {
        return Err("the angle is negative or not finite".into());
    }
    let axis_grid = Grid::of(axis.iter().copied());
    let on_axis_grid: Vector = axis.iter().map(|&c| axis_grid.units(c)).collect();
    if is_zero(&on_axis_grid) {
        return Err("the axis is zero".into());
    }
    let grid = Grid::of(all.flatten().copied());
    let units = |v: &[f64]| -> Vector { v.iter().map(|&c| grid.units(c)).collect() };
    let [answer_center, from, point] = [center, from, axis_point].map(units);
    let [answer, own] = [generators, own].map(|list| list.iter().map(|g| units(g)).collect::<Vec<Vector>>());
    let mut check = Check {
        turning: Turning::new(reduced(on_axis_grid), *angle),
        arm: difference(&from, &point),
        body: own,
        translation: units(translation),
        products: MOST_PRODUCTS,
    };
    let [rest, missing] = without_common_summands([&answer, &check.body]);
    let around_axis = Outer { center: difference(&answer_center, &point), generators: answer, keeps_body: false };
    let by_displacements = if missing.is_empty() {
        let around_body = Outer { center: difference(&answer_center, &from), generators: rest, keeps_body: true };
        check.contained(&around_body)
    } else {
        Err(Stop::Unchecked(String::new()))
    };
    match by_displacements {
        Err(Stop::Unchecked(_)) => {
            check.products = MOST_PRODUCTS;
            check.contained(&around_axis)
        }
        decided => decided,
    }
}

fn difference(a: &Vector, b: &Vector) -> Vector {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

/// The zonotope that has to contain placements, or their displacements.
struct Outer {
    center: Vector,
    generators: Vec<Vector>,
    keeps_body: bool,
}

impl Outer {
    /// The facet normals, one of each pair of opposite ones, and vectors that span what is orthogonal to it.
    fn directions(&self) -> Result<Vec<Vector>, Stop> {
        let span = Echelon::spanned(3, &self.generators);
        let across = span.complement(3);
        let rank = span.rank();
        let count = count_subsets(self.generators.len(), rank.saturating_sub(1));
        if count.saturating_mul(self.generators.len() as u64) > MOST_PRODUCTS {
            return Err(Stop::Unchecked("the answer has too many facets to try".to_owned()));
        }
        let mut directions = across.clone();
        if rank > 0 {
            for facet in subsets(self.generators.len(), rank - 1) {
                let rows = facet.iter().map(|&index| &self.generators[index]).chain(&across);
                if let [normal] = &Echelon::spanned(3, rows).complement(3)[..] {
                    directions.push(normal.clone());
                }
            }
        }
        directions.sort();
        directions.dedup();
        Ok(directions)
    }
}

impl Check {
    /// Proves that the outer body reaches far enough in every direction.
    fn contained(&mut self, outer: &Outer) -> Result<Proved, Stop> {
        for u in outer.directions()? {
            self.along(outer, &u)?;
            self.along(outer, &u.iter().map(|c| -c).collect())?;
        }
        Ok(Proved("every placement is contained, along each facet normal and at every angle"))
    }

    /// Proves that the outer body reaches as far along u as every placement.
    fn along(&mut self, outer: &Outer, u: &Vector) -> Result<(), Stop> {
        let reach: IBig = outer.generators.iter().map(|g| dot(g, u).abs()).sum();
        let limit = reach + dot(&outer.center, u) - dot(&self.translation, u).max(IBig::ZERO);
        // the stretches that are left, as parts of the angle, and the ends of the first of them
        let mut left: Vec<(u64, u32)> = (0..1 << FIRST_DEPTH).rev().map(|part| (part, FIRST_DEPTH)).collect();
        let placed = |check: &mut Self, part: u64, depth: u32| -> Result<(Rotation, bool), Stop> {
            let rotation = check.turning.rotation(part, depth);
            // the last rotation is a little beyond the angle, and shows nothing wrong
            if part != 1 << depth && check.is_beyond(outer, u, &rotation, &limit)? {
                return Err(format!("the placement at {part} / 2^{depth} of the angle is not contained").into());
            }
            let is_below = check.is_at_most(outer, u, [&rotation, &rotation], &limit)?;
            Ok((rotation, is_below))
        };
        while let Some((part, depth)) = left.pop() {
            let (from, is_from_below) = placed(self, part, depth)?;
            let (to, is_to_below) = placed(self, part + 1, depth)?;
            if is_from_below && is_to_below && self.is_at_most(outer, u, [&from, &to], &limit)? {
                continue;
            }
            if depth == DEPTH {
                return Err(Stop::Unchecked("a placement may stick out by less than the check tells apart".to_owned()));
            }
            left.extend([(2 * part + 1, depth + 1), (2 * part, depth + 1)]);
        }
        Ok(())
    }

    /// Whether the bound at a point of the arc, or at a corner between two, is at most a limit.
    fn is_at_most(&mut self, outer: &Outer, u: &Vector, ends: [&Rotation; 2], limit: &IBig) -> Result<bool, Stop> {
        let Some((mut w, scale)) = self.turning.turned_back(u, ends[0], ends[1]) else { return Ok(false) };
        if outer.keeps_body {
            w = w.iter().zip(u).map(|(w, u)| w - &scale * u).collect();
        }
        Ok(self.reach(&w)? <= limit * scale)
    }

    /// Whether the placement itself reaches farther than the answer.
    fn is_beyond(&mut self, outer: &Outer, u: &Vector, at: &Rotation, limit: &IBig) -> Result<bool, Stop> {
        let Some((w, scale)) = self.turning.turned_back(u, at, at) else { return Ok(false) };
        let own = if outer.keeps_body { self.reach(u)? } else { IBig::ZERO };
        Ok(self.reach(&w)? > (limit + own) * scale)
    }

    /// The largest w · y over the body seen from the axis.
    fn reach(&mut self, w: &Vector) -> Result<IBig, Stop> {
        let products = self.body.len() as u64 + 1;
        self.products = self
            .products
            .checked_sub(products)
            .ok_or_else(|| Stop::Unchecked("the body has too many generators for the check".to_owned()))?;
        Ok(self.body.iter().map(|g| dot(g, w).abs()).sum::<IBig>() + dot(&self.arm, w))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A point at distance 1 that makes a quarter turn from (1, 0, 0) to (0, 1, 0), and is moved up by 2.
    fn quarter() -> Sweep {
        Sweep {
            center: vec![1.0, 0.0, 0.0],
            generators: Vec::new(),
            axis_point: vec![0.0; 3],
            axis: vec![0.0, 0.0, 3.0],
            angle: 1.5,
            translation: vec![0.0, 0.0, 2.0],
        }
    }

    fn verdict(question: &Sweep, center: [f64; 3], generators: &[[f64; 3]]) -> Verdict<Proved> {
        check_sweep(question, &center, &generators.map_to_vectors())
    }

    trait MapToVectors {
        fn map_to_vectors(&self) -> Vec<Vec<f64>>;
    }

    impl MapToVectors for [[f64; 3]] {
        fn map_to_vectors(&self) -> Vec<Vec<f64>> {
            self.iter().map(|g| g.to_vec()).collect()
        }
    }

    #[test]
    fn boxes_around_an_arc() {
        let whole = [[0.5, 0.0, 0.0], [0.0, 0.5, 0.0], [0.0, 0.0, 1.0]];
        assert!(verdict(&quarter(), [0.5, 0.5, 1.0], &whole).is_right(), "the arc ends before (0, 1)");
        let short = [[0.5, 0.0, 0.0], [0.0, 0.49, 0.0], [0.0, 0.0, 1.0]];
        assert!(verdict(&quarter(), [0.5, 0.5, 1.0], &short).is_wrong());
        let flat = [[0.5, 0.0, 0.0], [0.0, 0.5, 0.0]];
        assert!(verdict(&quarter(), [0.5, 0.5, 1.0], &flat).is_wrong(), "the translation is left out");
        assert!(verdict(&quarter(), [0.5, 0.5, 1.0], &[[0.0, 0.0, 1.0]]).is_wrong());
        assert!(verdict(&quarter(), [0.5, 0.5, 1.1], &whole).is_wrong(), "the centre is moved");
    }

    #[test]
    fn a_side_along_the_tangent_is_proved_to_the_last_place() {
        // a rectangle with a side on the tangent at 45°: from the chord of the quarter to the arc
        let mut question = quarter();
        question.angle = 1.57;
        question.translation = vec![0.0; 3];
        let root = 0.5f64.sqrt().next_up();
        let (middle, half) = ((1.0 + root) / 2.0, (1.0 - root) / 2.0 + 1e-15);
        let center = [middle * root, middle * root, 0.0];
        let generators = |half: f64| [[half * root, half * root, 0.0], [-0.5, 0.5, 0.0]];
        assert!(verdict(&question, center, &generators(half)).is_right());
        assert!(verdict(&question, center, &generators(half - 1e-13)).is_wrong());
    }

    #[test]
    fn bodies_whose_generators_are_kept_and_turned() {
        let cube = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let question = Sweep {
            center: vec![0.0; 3],
            generators: cube.map_to_vectors(),
            angle: 100.0,
            translation: vec![0.0; 3],
            ..quarter()
        };
        let root = 2f64.sqrt().next_up();
        let around = [[root, 0.0, 0.0], [0.0, root, 0.0], [0.0, 0.0, 1.0]];
        assert!(verdict(&question, [0.0; 3], &around).is_right(), "the square around the circle of the corners");
        let doubled = [&cube[..], &[[2.0 * root, 0.0, 0.0], [0.0, 2.0 * root, 0.0]]].concat();
        assert!(verdict(&question, [0.0; 3], &doubled).is_right());
        assert!(verdict(&question, [0.0; 3], &cube).is_wrong());
        let narrow = [[1.4, 0.0, 0.0], [0.0, 1.5, 0.0], [0.0, 0.0, 1.0]];
        assert!(verdict(&question, [0.0; 3], &narrow).is_wrong());
    }

    #[test]
    fn what_is_no_question_or_no_answer_is_wrong() {
        let mut question = quarter();
        question.axis = vec![0.0; 3];
        assert!(verdict(&question, [0.0; 3], &[]).is_wrong());
        question = quarter();
        question.angle = -1.0;
        assert!(verdict(&question, [0.0; 3], &[]).is_wrong());
        assert!(verdict(&quarter(), [f64::NAN, 0.0, 0.0], &[]).is_wrong());
        assert!(check_sweep(&quarter(), &[0.0], &[]).is_wrong());
    }

    #[test]
    fn an_angle_is_finite_and_not_negative() {
        let told = |angle: f64| {
            let box_around = [[10.0, 0.0, 0.0], [0.0, 10.0, 0.0], [0.0, 0.0, 10.0]];
            verdict(&Sweep { angle, ..quarter() }, [0.0; 3], &box_around)
        };
        assert!(told(0.0).is_right() && told(1.0).is_right() && told(1e300).is_right());
        for angle in [-1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(told(angle).is_wrong(), "{angle}");
        }
    }

    #[test]
    fn a_translation_leaves_a_flat_answer_that_holds_the_arc() {
        let flat = [[0.5, 0.0, 0.0], [0.0, 0.5, 0.0]];
        assert!(verdict(&quarter(), [0.5, 0.5, 0.0], &flat).is_wrong());
        assert!(verdict(&Sweep { translation: vec![0.0; 3], ..quarter() }, [0.5, 0.5, 0.0], &flat).is_right());
    }

    #[test]
    fn a_body_that_begins_outside_is_refused_where_it_begins() {
        let question = Sweep { translation: vec![0.0; 3], ..quarter() };
        let told = verdict(&question, [0.0, 0.5, 0.0], &[[0.875, 0.0, 0.0], [0.0, 0.5, 0.0]]);
        assert_eq!(told, Verdict::Wrong("the placement at 0 / 2^3 of the angle is not contained".to_owned()));
    }

    #[test]
    fn a_short_part_of_an_arc_is_found_wherever_it_sticks_out() {
        for k in 1..=28 {
            // The point begins below the first axis, at the angle -2 atan(k / 32), and crosses it within 1.5.
            let t = f64::from(k) / 32.0;
            let start = vec![(1.0 - t * t) / (1.0 + t * t), -2.0 * t / (1.0 + t * t), 0.0];
            let question = Sweep { center: start, translation: vec![0.0; 3], ..quarter() };
            let within = |x: f64| verdict(&question, [0.0; 3], &[[x, 0.0, 0.0], [0.0, 2.0, 0.0]]);
            assert!(within(1.0 + 1e-15).is_right(), "{k}");
            assert!(within(1.0 - 1e-6).is_wrong(), "{k}");
        }
    }

    #[test]
    fn a_body_of_many_generators_is_held_by_what_its_points_are_displaced() {
        // The answer has 302 generators, too many facets to try; without those of the body it is a square.
        let body = vec![vec![0.0, 0.0, 1.0 / 1024.0]; 300];
        let question = Sweep { generators: body.clone(), translation: vec![0.0; 3], ..quarter() };
        let told = |half: f64| {
            let square = [vec![0.5, 0.0, 0.0], vec![0.0, half, 0.0]];
            check_sweep(&question, &[0.5, 0.5, 0.0], &[&body[..], &square].concat())
        };
        assert!(told(0.5).is_right(), "{:?}", told(0.5));
        assert!(told(0.49).is_wrong());
    }

    #[test]
    fn a_reach_takes_a_product_for_each_generator_and_one_for_the_centre() {
        let vector = |v: [i32; 3]| v.map(IBig::from).to_vec();
        let mut check = Check {
            turning: Turning::new(vector([0, 0, 1]), 1.0),
            arm: vector([1, 2, 3]),
            body: vec![vector([1, 0, -1]), vector([0, -2, 0])],
            translation: vector([0; 3]),
            products: 5,
        };
        // Along (3, 1, 5) the centre is at 20, and the generators reach 2 farther each.
        assert_eq!(check.reach(&vector([3, 1, 5])), Ok(IBig::from(24)));
        assert_eq!(check.products, 2);
        assert!(matches!(check.reach(&vector([3, 1, 5])), Err(Stop::Unchecked(_))));
    }

    #[test]
    fn an_answer_that_ends_a_little_before_the_arc_does_is_never_right() {
        // The point turns by 1 and rises until then, to the sine of 1.
        let question = Sweep { angle: 1.0, translation: vec![0.0; 3], ..quarter() };
        let up_to = |y: f64| verdict(&question, [0.75, y / 2.0, 0.0], &[[0.25, 0.0, 0.0], [0.0, y / 2.0, 0.0]]);
        let sine = 0.841_470_984_807_896_5;
        assert!(up_to(sine + 1e-13).is_right() && up_to(sine - 1e-11).is_wrong());
        assert!(matches!(up_to(sine - 1e-13), Verdict::Unchecked(_)), "no placement that is tried is so near the end");
    }
}
