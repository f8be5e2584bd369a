//! Small zonotopes by their definition, in rationals: every face is tried.

use dashu_ratio::RBig;

use crate::rationals::{absolute, dot, minus, solved};

/// The squared distance of a vector from { Σ δ_i g_i : |δ_i| ≤ 1 }: of all choices that leave each generator at an end
/// or free, with the free ones independent, the least one that the coefficients allow.
pub fn squared_distance(p: &[RBig], generators: &[Vec<RBig>]) -> RBig {
    let mut least: Option<RBig> = None;
    for choice in 0..3_usize.pow(generators.len() as u32) {
        let (mut rest, mut free): (Vec<RBig>, Vec<&Vec<RBig>>) = (p.to_vec(), Vec::new());
        for (index, generator) in generators.iter().enumerate() {
            let end = match choice / 3_usize.pow(index as u32) % 3 {
                0 => RBig::ONE,
                1 => -RBig::ONE,
                _ => {
                    free.push(generator);
                    continue;
                }
            };
            rest = rest.iter().zip(generator).map(|(r, c)| r - &end * c).collect();
        }
        if free.len() > p.len() {
            continue;
        }
        let products = |v: &[RBig]| -> Vec<RBig> { free.iter().map(|g| dot(g, v)).collect() };
        let gram: Vec<Vec<RBig>> = free.iter().map(|g| products(g)).collect();
        let Some(x) = solved(&gram.iter().collect::<Vec<_>>(), &products(&rest)) else { continue };
        if x.iter().any(|x| absolute(x.clone()) > RBig::ONE) {
            continue;
        }
        for (x, g) in x.iter().zip(&free) {
            rest = rest.iter().zip(*g).map(|(r, c)| r - x * c).collect();
        }
        let square = dot(&rest, &rest);
        if least.as_ref().is_none_or(|least| square < *least) {
            least = Some(square);
        }
        if least.as_ref() == Some(&RBig::ZERO) {
            break;
        }
    }
    least.expect("all generators may be at an end")
}

/// Whether { center + Σ δ_i g_i : |δ_i| ≤ 1 } contains a point.
pub fn contains(center: &[RBig], generators: &[Vec<RBig>], point: &[RBig]) -> bool {
    squared_distance(&minus(point, center), generators) == RBig::ZERO
}

/// Σ ± g_i for all choices of signs.
pub fn corners(dimension: usize, generators: &[Vec<RBig>]) -> impl Iterator<Item = Vec<RBig>> {
    (0..1_usize << generators.len()).map(move |signs| {
        let mut corner = vec![RBig::ZERO; dimension];
        for (index, generator) in generators.iter().enumerate() {
            let is_minus = signs >> index & 1 == 1;
            corner = corner.iter().zip(generator).map(|(sum, c)| if is_minus { sum - c } else { sum + c }).collect();
        }
        corner
    })
}

/// The squared largest distance of a point of the first zonotope, whose centre is at the offset, from the second one
/// around the origin.
pub fn squared_excess(offset: &[RBig], first: &[Vec<RBig>], second: &[Vec<RBig>]) -> RBig {
    corners(offset.len(), first)
        .map(|corner| corner.iter().zip(offset).map(|(c, moved)| c + moved).collect::<Vec<_>>())
        .fold(RBig::ZERO, |farthest, point| farthest.max(squared_distance(&point, second)))
}

/// Σ |u · g_i|.
pub fn reach(u: &[RBig], generators: &[Vec<RBig>]) -> RBig {
    generators.iter().fold(RBig::ZERO, |sum, g| sum + absolute(dot(u, g)))
}

/// The squared least distance of a vector inside a zonotope of one to three dimensions from the plane of a facet.
pub fn squared_depth(p: &[RBig], generators: &[Vec<RBig>]) -> Option<RBig> {
    let pairs = || generators.iter().enumerate().flat_map(|(i, a)| generators[..i].iter().map(move |b| (a, b)));
    let normals: Vec<Vec<RBig>> = match p.len() {
        1 => vec![vec![RBig::ONE]],
        2 => generators.iter().map(|g| vec![-g[1].clone(), g[0].clone()]).collect(),
        _ => pairs().map(|(a, b)| cross(a, b)).collect(),
    };
    let depth = |u: &Vec<RBig>| {
        let (along, square) = (reach(u, generators) - absolute(dot(u, p)), dot(u, u));
        (square != RBig::ZERO).then(|| &along * &along / square)
    };
    normals.iter().filter_map(depth).reduce(RBig::min)
}

fn cross(a: &[RBig], b: &[RBig]) -> Vec<RBig> {
    [(1, 2), (2, 0), (0, 1)].map(|(j, k)| &a[j] * &b[k] - &a[k] * &b[j]).to_vec()
}
