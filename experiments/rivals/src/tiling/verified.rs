//! A tiling as the plain numbers that the crate `verifier` checks.

use verifier::{Fraction, Tile, TilingAnswer, TilingEdge, TilingProof, Verdict};
use zonotope::numeric::Rational;
use zonotope::numeric::dyadic::Dyadic;

use super::{CornerIndex, Tiling};

/// Checks a tiling, but for the generators along its left side and how many edges a separator has above a tile.
pub fn check_tiling(generators: &[[f64; 3]], tiling: &Tiling) -> Verdict<TilingProof> {
    let generators: Vec<Vec<f64>> = generators.iter().map(|generator| generator.to_vec()).collect();
    verifier::check_tiling(&generators, &tiling_answer(tiling))
}

/// The tiling as the verifier takes it.
pub fn tiling_answer(tiling: &Tiling) -> TilingAnswer {
    let vertex = |corner: CornerIndex| corner.0 as usize;
    let place = |point: &[Dyadic; 3]| -> [Fraction; 3] { point.each_ref().map(|c| fraction(&c.to_rational())) };
    TilingAnswer {
        vertices: tiling.vertices().iter().map(|corner| place(&corner.exact_point)).collect(),
        edges: tiling
            .edges()
            .iter()
            .map(|edge| TilingEdge {
                generator: edge.generator,
                upper: vertex(edge.upper),
                lower: vertex(edge.lower),
                left: edge.left.map(|tile| tile.0 as usize),
                right: edge.right.map(|tile| tile.0 as usize),
            })
            .collect(),
        tiles: tiling
            .tiles()
            .iter()
            .map(|tile| Tile {
                generators: tile.generators,
                corners: tile.corners.map(vertex),
                edges: tile.edges.map(|edge| edge.0 as usize),
                dual: tile.exact_dual.each_ref().map(fraction),
            })
            .collect(),
        left_side: tiling.left_side().iter().map(|&corner| vertex(corner)).collect(),
    }
}

/// A rational number as the verifier takes it.
fn fraction(number: &Rational) -> Fraction {
    Fraction::new(number.numerator().clone(), number.denominator().clone()).expect("a denominator is positive")
}
