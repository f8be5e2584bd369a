//! Answers to "how many faces has the zonotope of these generators, and what does it measure".
//!
//! The faces are counted in the coordinates of the zonotope's span: in space line by line, in other dimensions subset
//! by subset. The measure is 2^d Σ |det| over all d generators. Where either would take too long, only what holds for
//! every zonotope is looked at.

mod by_subsets;
mod in_space;

use std::collections::{BTreeMap, BTreeSet};

use dashu_int::IBig;
use dashu_int::ops::{Abs, BitTest};

use crate::RELATIVE_ERROR;
use crate::collision::placed::{Body, Frame};
use crate::exact::fraction::Fraction;
use crate::exact::grid::{Grid, check_finite};
use crate::exact::linear::{Echelon, Vector, absolute_determinant, is_zero, reduced};
use crate::exact::proportion::{Proportion, check_figure};
use crate::exact::subsets::{count_subsets, subsets};
use crate::exact::turns::turns;
use crate::verdict::{Proved, Stop, Verdict};

/// The number of steps that are made for the counts, and for the measure: a step takes some tenths of a microsecond.
const MOST_STEPS: u64 = 30_000_000;

/// An answer as it was written.
#[derive(Debug, Clone, PartialEq)]
pub struct CombinatoricsAnswer {
    /// The dimension of the affine hull.
    pub affine_dim: usize,
    /// The number of vertices.
    pub vertices: u64,
    /// The number of edges.
    pub edges: u64,
    /// The number of facets, within the affine hull.
    pub facets: u64,
    /// The number of facets that have so many vertices.
    pub facet_sizes: BTreeMap<usize, u64>,
    /// The volume in the space of the generators.
    pub measure: Fraction,
}

/// Checks counts and measure. Where going through the faces would take too long, counts are only held against the
/// relations that all such counts satisfy, and left unchecked.
pub fn check_combinatorics<G: AsRef<[f64]>>(body: &Body<'_, G>, answer: &CombinatoricsAnswer) -> Verdict<Proved> {
    counted_and_measured(body, answer).into()
}

/// Checks a rounded measure, which may differ from the exact one by the relative [`RELATIVE_ERROR`].
pub fn check_measure(generators: &[Vec<f64>], claimed: f64) -> Verdict<Proved> {
    let checked = || {
        check_finite("the question", generators.iter().flatten())?;
        let dimension = generators.first().map_or(0, Vec::len);
        let grid = Grid::of(generators.iter().flatten().copied());
        let placed: Vec<Vector> =
            generators.iter().map(|g| g.iter().map(|&component| grid.units(component)).collect()).collect();
        let rank = Echelon::spanned(dimension, &placed).rank();
        let exponent = i32::try_from(dimension).ok().and_then(|dimension| dimension.checked_mul(grid.exponent()));
        let exponent = exponent.ok_or("the dimension is beyond all bounds")?;
        let Some(units) = measure(dimension, &placed, rank) else {
            return Err(Stop::Unchecked("the measure was not computed".to_owned()));
        };
        let exact = Proportion::whole(units, exponent);
        check_figure("volume", claimed, &exact, &exact.times(&Proportion::of_double(RELATIVE_ERROR)))?;
        Ok(Proved("the measure is exact but for rounding"))
    };
    checked().into()
}

fn counted_and_measured<G: AsRef<[f64]>>(body: &Body<'_, G>, answer: &CombinatoricsAnswer) -> Result<Proved, Stop> {
    let dimension = body.center.len();
    body.check_dimension(dimension)?;
    let frame = Frame::of(&[body], &[])?;
    let placed = frame.generators(body);
    let span = Echelon::spanned(dimension, &placed);
    expect("affine_dim", answer.affine_dim as u64, span.rank() as u64)?;
    let pivots = span.pivots();
    let inside: Vec<Vector> = placed.iter().map(|v| pivots.iter().map(|&axis| v[axis].clone()).collect()).collect();

    let lines = directions(&inside);
    let counted = match counts(span.rank(), &lines, longest(&inside)) {
        Some(counts) => {
            expect("vertices", answer.vertices, counts.vertices)?;
            expect("edges", answer.edges, counts.edges)?;
            expect("facets", answer.facets, counts.facet_sizes.values().sum())?;
            if answer.facet_sizes != counts.facet_sizes {
                return Err(
                    format!("facet_sizes are {:?}, exactly {:?}", answer.facet_sizes, counts.facet_sizes).into()
                );
            }
            true
        }
        None => {
            relations(span.rank(), answer)?;
            false
        }
    };

    let claimed = Proportion::of_fraction(&answer.measure);
    let exponent = i32::try_from(dimension).ok().and_then(|dimension| dimension.checked_mul(frame.exponent()));
    let exponent = exponent.ok_or("the dimension is beyond all bounds")?;
    let measured = match measure(dimension, &placed, span.rank()) {
        Some(units) => {
            let exact = Proportion::whole(units, exponent);
            if claimed.compare(&exact).is_ne() {
                return Err(format!("measure is {:?}, exactly {:?}", claimed.nearest(), exact.nearest()).into());
            }
            true
        }
        None => false,
    };
    let counts =
        if counted { "every face counted" } else { "the counts satisfy Euler's relation, but were not counted" };
    let measure = if measured { "the measure is exact" } else { "the measure was not computed" };
    if counted && measured {
        return Ok(Proved("every face counted; the measure is exact"));
    }
    Err(Stop::Unchecked(format!("{counts}; {measure}")))
}

fn expect(name: &str, claimed: u64, exact: u64) -> Result<(), String> {
    if claimed == exact { Ok(()) } else { Err(format!("{name} is {claimed}, exactly it is {exact}")) }
}

/// The number of bits that the components take.
fn longest(vectors: &[Vector]) -> u64 {
    vectors.iter().flatten().map(|component| component.bit_len() as u64).max().unwrap_or(0)
}

/// Whether so many products of numbers of so many bits are few enough.
fn is_quick(products: u64, bits: u64) -> bool {
    let words = bits / 64 + 1;
    products.saturating_mul(1 + words.saturating_mul(words) / 16) <= MOST_STEPS
}

/// n^power times the logarithm of n.
fn sorted_steps(count: usize, power: u32) -> u64 {
    (count as u64).saturating_pow(power).saturating_mul(u64::from(count.max(2).ilog2()))
}

/// The numbers of faces, if counting them is quick.
fn counts(rank: usize, lines: &[Vector], bits: u64) -> Option<Counts> {
    let products = match rank {
        0..=2 => 0,
        3 => sorted_steps(lines.len(), 2),
        _ => count_subsets(lines.len(), rank - 1).saturating_mul((lines.len() * rank) as u64),
    };
    match rank {
        _ if !is_quick(products, bits.saturating_mul(rank as u64)) => None,
        3 => Some(in_space::counts(lines)),
        _ => by_subsets::counts(rank, lines),
    }
}

struct Counts {
    vertices: u64,
    edges: u64,
    facet_sizes: BTreeMap<usize, u64>,
}

/// One vector for each line through the origin that holds one of the vectors.
fn directions(vectors: &[Vector]) -> Vec<Vector> {
    let canonical = |v: &Vector| {
        let v = reduced(v.clone());
        let first = v.iter().find(|component| **component != IBig::ZERO)?;
        Some(if *first < IBig::ZERO { v.iter().map(|component| -component).collect() } else { v })
    };
    let distinct: BTreeSet<Vector> = vectors.iter().filter_map(canonical).collect();
    distinct.into_iter().collect()
}

/// The vectors with g counted as nothing: in one dimension less, zero for multiples of g.
fn modulo(vectors: &[Vector], g: &Vector) -> Vec<Vector> {
    let axis = g.iter().position(|component| *component != IBig::ZERO).expect("a direction is not zero");
    let along = |v: &Vector| {
        let rest = (0..v.len()).filter(|&other| other != axis);
        rest.map(|other| &g[axis] * &v[other] - &v[axis] * &g[other]).collect()
    };
    vectors.iter().map(along).collect()
}

/// The relations of every zonotope: faces come in opposite pairs; in space V − E + F = 2, and each edge belongs to two
/// facets.
fn relations(rank: usize, answer: &CombinatoricsAnswer) -> Result<(), String> {
    // Claimed counts may be as large as they like.
    let sum = |counts: &mut dyn Iterator<Item = u64>| counts.fold(0, u64::saturating_add);
    expect("the sum of facet_sizes", sum(&mut answer.facet_sizes.values().copied()), answer.facets)?;
    let all = [answer.vertices, answer.edges, answer.facets];
    if all.iter().chain(answer.facet_sizes.values()).any(|count| count % 2 == 1) {
        return Err("a count of faces is odd, though faces come in opposite pairs".to_owned());
    }
    if rank == 3 {
        let [vertices, edges, facets] = all;
        expect("vertices − edges + facets", vertices.saturating_add(facets).saturating_sub(edges), 2)?;
        let sides = |(&size, &count): (&usize, &u64)| (size as u64).saturating_mul(count);
        let sides = sum(&mut answer.facet_sizes.iter().map(sides));
        expect("the number of sides of all facets", sides, edges.saturating_mul(2))?;
    }
    Ok(())
}

/// 2^d Σ |det| in units of the grid, if adding them up is quick.
fn measure(dimension: usize, generators: &[Vector], rank: usize) -> Option<IBig> {
    if rank < dimension || dimension == 0 {
        return Some(IBig::ZERO);
    }
    // Parallel generators add up, which leaves the sum as it is.
    let mut merged: BTreeMap<Vector, Vector> = BTreeMap::new();
    for generator in generators.iter().filter(|generator| !is_zero(generator)) {
        let [direction] = <[Vector; 1]>::try_from(directions(std::slice::from_ref(generator))).ok()?;
        let sum = merged.entry(direction).or_insert_with_key(|direction| vec![IBig::ZERO; direction.len()]);
        let opposite =
            generator.iter().find(|component| **component != IBig::ZERO).is_some_and(|first| *first < IBig::ZERO);
        for (sum, component) in sum.iter_mut().zip(generator) {
            if opposite { *sum -= component } else { *sum += component }
        }
    }
    let merged: Vec<Vector> = merged.into_values().collect();
    let products = match dimension {
        1 => 0,
        2 | 3 => sorted_steps(merged.len(), dimension as u32 - 1),
        _ => count_subsets(merged.len(), dimension).saturating_mul((dimension * dimension * dimension) as u64),
    };
    if !is_quick(products, longest(&merged).saturating_mul(dimension as u64)) {
        return None;
    }
    let sum: IBig = match dimension {
        2 => turns(merged),
        3 => in_space::volumes(&merged),
        _ => subsets(merged.len(), dimension)
            .map(|subset| absolute_determinant(subset.into_iter().map(|index| merged[index].clone()).collect()).abs())
            .sum(),
    };
    Some(sum << dimension)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn answer(affine_dim: usize, counts: [u64; 3], facet_sizes: &[(usize, u64)], measure: i64) -> CombinatoricsAnswer {
        let [vertices, edges, facets] = counts;
        let facet_sizes = facet_sizes.iter().copied().collect();
        CombinatoricsAnswer { affine_dim, vertices, edges, facets, facet_sizes, measure: whole(measure) }
    }

    fn whole(number: i64) -> Fraction {
        Fraction::new(number, 1).expect("one is not zero")
    }

    fn check_combinatorics(generators: &[Vec<f64>], answer: &CombinatoricsAnswer) -> Verdict<Proved> {
        let center = vec![0.0; generators.first().map_or(0, Vec::len)];
        super::check_combinatorics(&Body { center: &center, generators, pose: None }, answer)
    }

    fn right(generators: &[&[f64]], answer: &CombinatoricsAnswer) {
        let generators: Vec<Vec<f64>> = generators.iter().map(|generator| generator.to_vec()).collect();
        let proof = check_combinatorics(&generators, answer);
        assert!(proof.is_right(), "{generators:?} {proof:?}");
        let worse = CombinatoricsAnswer { edges: answer.edges + 2, ..answer.clone() };
        assert!(check_combinatorics(&generators, &worse).is_wrong());
        let worse = CombinatoricsAnswer { measure: Fraction::new(1, 7).expect("not over zero"), ..answer.clone() };
        assert!(check_combinatorics(&generators, &worse).is_wrong());
    }

    const E: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

    #[test]
    fn named_bodies() {
        let [x, y, z] = [&E[0][..], &E[1], &E[2]];
        right(&[x, y, z], &answer(3, [8, 12, 6], &[(4, 6)], 8));
        right(&[x, x, y, &[0.0, -2.0, 0.0], z, &[0.0; 3]], &answer(3, [8, 12, 6], &[(4, 6)], 8 * 6));
        let diagonals: [&[f64]; 4] = [&[1.0, 1.0, 1.0], &[1.0, 1.0, -1.0], &[1.0, -1.0, 1.0], &[-1.0, 1.0, 1.0]];
        right(&diagonals, &answer(3, [14, 24, 12], &[(4, 12)], 8 * 16));
        let truncated: [&[f64]; 6] = [
            &[1.0, 1.0, 0.0],
            &[1.0, -1.0, 0.0],
            &[1.0, 0.0, 1.0],
            &[1.0, 0.0, -1.0],
            &[0.0, 1.0, 1.0],
            &[0.0, 1.0, -1.0],
        ];
        right(&truncated, &answer(3, [24, 36, 14], &[(4, 6), (6, 8)], 8 * 32));
        right(&[x, y, z, &[1.0, 1.0, 0.0]], &answer(3, [12, 18, 8], &[(4, 6), (6, 2)], 8 * 3));
    }

    #[test]
    fn other_dimensions() {
        right(&[&[3.0], &[-1.0]], &answer(1, [2, 1, 2], &[(1, 2)], 8));
        right(&[&[1.0, 0.0], &[0.0, 2.0], &[1.0, 1.0]], &answer(2, [6, 6, 6], &[(2, 6)], 4 * 5));
        let axes = |at: usize| (0..4).map(|axis| if axis == at { 1.0 } else { 0.0 }).collect::<Vec<f64>>();
        let tesseract: Vec<Vec<f64>> = (0..4).map(axes).collect();
        let tesseract: Vec<&[f64]> = tesseract.iter().map(Vec::as_slice).collect();
        right(&tesseract, &answer(4, [16, 32, 8], &[(8, 8)], 16));
        let flat = answer(2, [4, 4, 4], &[(2, 4)], 0);
        right(&[&E[0], &E[1]], &flat);
    }

    #[test]
    fn a_point_has_one_vertex() {
        let proof = check_combinatorics(&[vec![0.0, 0.0]], &answer(0, [1, 0, 0], &[], 0));
        assert!(proof.is_right(), "{proof:?}");
    }

    /// Of n generators in general position in R^d a zonotope has 2 C(n, d − 1) facets, each a parallelepiped, twice as
    /// many vertices as subsets of fewer than d of n − 1, and for each generator as many edges as the projection along
    /// it has vertices.
    #[test]
    fn general_position_in_four_and_five_dimensions() {
        let moments = |count: i64, dimension: u32| -> Vec<Vec<f64>> {
            (1..=count).map(|t| (0..dimension).map(|power| t.pow(power) as f64).collect()).collect()
        };
        let counted = |generators: &[Vec<f64>]| {
            let rows: Vec<Vector> =
                generators.iter().map(|g| g.iter().map(|&x| IBig::from(x as i64)).collect()).collect();
            counts(generators[0].len(), &directions(&rows), longest(&rows)).expect("there are few faces")
        };
        let four = counted(&moments(6, 4));
        assert_eq!((four.vertices, four.edges), (2 * (1 + 5 + 10 + 10), 6 * 2 * (1 + 4 + 6)));
        assert_eq!(four.facet_sizes, BTreeMap::from([(8, 2 * 20)]));
        let five = counted(&moments(7, 5));
        assert_eq!((five.vertices, five.edges), (2 * (1 + 6 + 15 + 20 + 15), 7 * 2 * (1 + 5 + 10 + 10)));
        assert_eq!(five.facet_sizes, BTreeMap::from([(16, 2 * 35)]));
    }

    /// The vectors (1, t, t², …) of t = 0, 1, …: no two are parallel, and as many as there are axes are independent.
    fn many(count: i64, dimension: u32) -> Vec<Vector> {
        (0..count).map(|t| (0..dimension).map(|power| IBig::from(t.pow(power))).collect()).collect()
    }

    #[test]
    fn work_is_counted_before_it_is_begun() {
        assert_eq!(longest(&[vec![IBig::from(255), IBig::ZERO], vec![IBig::from(-256), IBig::ONE]]), 9);
        assert_eq!(longest(&[]), 0);
        assert_eq!((sorted_steps(8, 2), sorted_steps(1, 3), sorted_steps(0, 1)), (64 * 3, 1, 0));
        assert_eq!(sorted_steps(usize::MAX, 3), u64::MAX);
        assert!(is_quick(MOST_STEPS, 0) && is_quick(MOST_STEPS, 191) && !is_quick(MOST_STEPS + 1, 191));
        // four words: each product counts as two
        assert!(!is_quick(MOST_STEPS, 192) && is_quick(MOST_STEPS / 2, 192) && !is_quick(MOST_STEPS / 2 + 1, 192));
        assert!(counts(4, &many(300, 4), 30).is_none() && counts(3, &many(2_000, 3), 30).is_none());
        assert!(measure(4, &many(300, 4), 4).is_none() && measure(3, &many(2_000, 3), 3).is_none());
        assert!(measure(4, &many(12, 4), 4).is_some_and(|measure| measure > IBig::ZERO));
        assert_eq!(measure(4, &many(12, 4), 3), Some(IBig::ZERO));
    }

    /// Eight lines of space take 8² · 3 products, six in four dimensions 20 · 6 · 4 and their measure 15 · 4³.
    #[test]
    fn numbers_are_as_long_as_the_number_of_products_lets_them_be() {
        for (rank, count, bits) in [(3, 8, 33_727), (4, 6, 15_983)] {
            let is_counted = |bits: u64| counts(rank, &many(count, rank as u32), bits).is_some();
            assert!(is_counted(bits) && !is_counted(bits + 1), "{rank}");
        }
        let is_measured = |dimension: usize, count: i64, bits: usize| {
            let mut long = many(count, dimension as u32);
            long[0][0] = IBig::ONE << (bits - 1);
            measure(dimension, &long, dimension).is_some()
        };
        for (dimension, count, bits) in [(3, 8, 33_727), (4, 6, 11_311)] {
            assert!(is_measured(dimension, count, bits) && !is_measured(dimension, count, bits + 1), "{dimension}");
        }
        assert!(is_measured(1, 1, 1_500_000), "one length takes no products");
    }

    /// Twelve generators with numbers as long as those of doubles: 220 · 12 · 4 products count, 495 · 4³ would measure.
    #[test]
    fn counts_without_a_measure_are_left_unchecked() {
        let tiny = |t: u64| (0..4).map(|power| f64::from_bits(t.pow(power))).collect::<Vec<f64>>();
        let generators: Vec<Vec<f64>> = (1..12).map(tiny).chain([vec![2.0_f64.powi(1000), 0.0, 0.0, 0.0]]).collect();
        let right = answer(4, [2 * (1 + 11 + 55 + 165), 12 * 2 * (1 + 10 + 45), 440], &[(8, 440)], 0);
        let verdict = check_combinatorics(&generators, &right);
        assert!(matches!(&verdict, Verdict::Unchecked(why) if why.contains("every face counted")), "{verdict:?}");
        assert!(check_combinatorics(&generators, &CombinatoricsAnswer { edges: 2, ..right }).is_wrong());
    }

    #[test]
    fn counts_that_are_not_counted_satisfy_the_relations_of_every_zonotope() {
        let cube = answer(3, [8, 12, 6], &[(4, 6)], 8);
        assert_eq!(relations(3, &cube), Ok(()));
        let wrong = [
            CombinatoricsAnswer { facets: 8, ..cube.clone() },
            CombinatoricsAnswer { edges: 14, ..cube.clone() },
            CombinatoricsAnswer { vertices: 10, edges: 14, ..cube.clone() },
            CombinatoricsAnswer { facets: 7, facet_sizes: BTreeMap::from([(4, 7)]), ..cube.clone() },
            CombinatoricsAnswer { facet_sizes: BTreeMap::from([(4, 3), (6, 3)]), ..cube.clone() },
            CombinatoricsAnswer { facet_sizes: BTreeMap::from([(4, 4), (6, 2)]), ..cube.clone() },
        ];
        for wrong in &wrong {
            assert!(relations(3, wrong).is_err(), "{wrong:?}");
        }
        // Above three dimensions faces come in pairs, and no more is said.
        assert_eq!(relations(4, &answer(4, [16, 32, 8], &[(8, 8)], 16)), Ok(()));
        assert!(relations(4, &answer(4, [16, 31, 8], &[(8, 8)], 16)).is_err());
    }
}
